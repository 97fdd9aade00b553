//! The variables of a deck's trim: camber and twist, AESTAT and AESURF, and controls linked to others (AELINK).

use aero::{ControlSurface, Lattice, StreamAxes, camber_and_twist, incidence};
use faer::Mat;
use nalgebra::{Matrix3, Point3, Vector3};
use nastran::{Aeros, BulkData, InputError};

/// SYMXZ of an antisymmetric flow.
pub(crate) const ANTISYMMETRIC: i32 = -1;

/// Names, incidence, and which acceleration each variable is.
pub(crate) type Variables = (Vec<String>, Mat<f64>, Vec<Option<usize>>);

/// Names, incidence, and which acceleration each variable is; boxes, and `origin` and `axes` of the reference system (RCSID, x, y and
/// z as columns), are seen in the axes of the stream. Rolling and yawing are about the reference axes, whichever way they point: with
/// x forward and z down as in flight mechanics, with x aft and z up against it (so Simcenter Nastran prints HA144B).
pub(crate) fn variables(
    bulk: &BulkData,
    lattice: &Lattice,
    aeros: &Aeros,
    origin: &Point3<f64>,
    axes: &Matrix3<f64>,
    stream: &StreamAxes,
) -> Result<Variables, InputError> {
    let n = lattice.len();
    let mut camber = camber_and_twist(bulk, lattice)?;
    // Both halves of an aircraft have the same camber and twist: nothing of it is antisymmetric.
    if aeros.symmetry == ANTISYMMETRIC {
        camber.fill(0.0);
    }
    let mut all = vec![("INTERCEPT".to_owned(), camber, None)];
    let rate =
        |axis: Vector3<f64>, length: f64| incidence::rotation_rate(lattice, &axis, origin, length / 2.0);
    for card in bulk.trim_variables.values() {
        let label = card.label.to_ascii_uppercase();
        let (column, acceleration) = match label.as_str() {
            "ANGLEA" => (incidence::angle_of_attack(lattice), None),
            "SIDES" => (incidence::sideslip(lattice), None),
            "ROLL" => (rate(axes.column(0).into_owned(), aeros.span_length), None),
            "PITCH" => (rate(Vector3::y(), aeros.chord), None),
            "YAW" => (rate(axes.column(2).into_owned(), aeros.span_length), None),
            "URDD1" | "URDD2" | "URDD3" | "URDD4" | "URDD5" | "URDD6" => {
                (vec![0.0; n], label.bytes().last().map(|digit| usize::from(digit - b'1')))
            }
            _ => {
                return Err(InputError::at(&card.span, format!("AESTAT {label} is no trim variable"))
                    .with_help("expected ANGLEA, SIDES, ROLL, PITCH, YAW or URDD1 to URDD6"));
            }
        };
        all.push((label, column, acceleration));
    }
    all.extend(
        ControlSurface::all_in_axes(bulk, lattice, stream)?
            .into_iter()
            .map(|c| (c.name.clone(), c.column(n), None)),
    );
    let incidence = Mat::from_fn(n, all.len(), |j, at| all[at].1[j]);
    let accelerations = all.iter().map(|one| one.2).collect();
    Ok((all.into_iter().map(|one| one.0).collect(), incidence, accelerations))
}

/// Controls that move in proportion to others: `u_d = - sum C_i u_i`.
#[derive(Debug, Clone, Default)]
pub(crate) struct Links {
    all: Vec<Link>,
}

/// One of them, by places of variables.
#[derive(Debug, Clone)]
struct Link {
    trim: Option<u32>,
    dependent: usize,
    terms: Vec<(usize, f64)>,
}

impl Links {
    /// The links of a deck.
    ///
    /// # Errors
    /// If one names a variable that is not there, or depends on another's dependent.
    pub(crate) fn new(bulk: &BulkData, names: &[String]) -> Result<Self, InputError> {
        let mut all: Vec<Link> = Vec::new();
        for card in &bulk.aero_links {
            let place = |label: &String| {
                names.iter().position(|name| name == label).ok_or_else(|| {
                    InputError::at(&card.span, format!("{label} of AELINK is no variable of the trim"))
                        .with_help(format!("there are {}", names[1..].join(", ")))
                })
            };
            let dependent = place(&card.dependent)?;
            let terms = card.terms.iter().map(|(label, c)| Ok((place(label)?, *c)));
            let terms = terms.collect::<Result<Vec<_>, InputError>>()?;
            let chained = |link: &Link| {
                link.dependent == dependent
                    || terms.iter().any(|(at, _)| *at == link.dependent)
                    || link.terms.iter().any(|(at, _)| *at == dependent)
            };
            let together =
                |link: &&Link| link.trim.is_none() || card.trim.is_none() || link.trim == card.trim;
            if terms.iter().any(|(at, _)| *at == dependent) || all.iter().filter(together).any(chained) {
                let message = format!("{} is linked twice, or to one that is linked itself", card.dependent);
                return Err(
                    InputError::at(&card.span, message).with_help("link controls to independent ones only")
                );
            }
            all.push(Link { trim: card.trim, dependent, terms });
        }
        Ok(Self { all })
    }

    fn of(&self, trim: Option<u32>) -> impl Iterator<Item = &Link> {
        self.all.iter().filter(move |link| link.trim.is_none() || link.trim == trim)
    }

    /// The equations with what linked controls do added to those they follow; linked ones are given as zero.
    ///
    /// # Errors
    /// If a linked control has a value of its own.
    pub(crate) fn folded(
        &self,
        balance: &Mat<f64>,
        trim: Option<u32>,
        x: &mut [Option<f64>],
    ) -> Result<Mat<f64>, InputError> {
        let mut folded = balance.clone();
        for link in self.of(trim) {
            if x[link.dependent].is_some() {
                return Err(InputError::general(
                    "a control that follows another (AELINK) has a value in TRIM",
                )
                .with_help("give the value of the one it follows"));
            }
            x[link.dependent] = Some(0.0);
            for (at, c) in &link.terms {
                for row in 0..folded.nrows() {
                    folded[(row, *at)] -= c * balance[(row, link.dependent)];
                }
            }
        }
        Ok(folded)
    }

    /// Sets the linked controls.
    pub(crate) fn follow(&self, trim: Option<u32>, values: &mut [f64]) {
        for link in self.of(trim) {
            values[link.dependent] = -link.terms.iter().map(|(at, c)| c * values[*at]).sum::<f64>();
        }
    }
}
