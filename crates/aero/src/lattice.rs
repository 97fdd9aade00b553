//! Panels divided into boxes: CAERO1 with NSPAN/NCHORD or AEFACT divisions.
//!
//! Boxes are numbered as Nastran numbers them: from the panel's own number, chordwise first, then spanwise;
//! panels in ascending order. So the boxes' order in the lattice is that of ascending numbers.

use crate::geometry::AeroBox;
use crate::stream_axes::StreamAxes;
use nalgebra::{Point3, Vector3};
use nastran::{Aefact, BulkData, Caero1, Divisions, Frames, InputError};
use std::collections::HashSet;

/// More boxes than this are refused: the influence matrix alone would take 20 GB, its factorisation an hour.
const MOST_BOXES: usize = 50_000;
/// What the matrices of a lattice take in memory, bytes a pair of boxes: 42 were measured for a calibration (five real
/// matrices), and 84 in unsteady air.
const MEMORY_A_PAIR: f64 = 100.0;

/// One panel of a lattice.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Surface {
    /// Number of the panel (EID of the CAERO1).
    pub id: u32,
    /// Name for reports.
    pub name: String,
    /// Index of its first box.
    pub first_box: usize,
    /// Boxes along the chord.
    pub chordwise: usize,
    /// Strips along the span.
    pub spanwise: usize,
}

/// Boxes of all panels.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Lattice {
    /// Boxes, panel by panel, chordwise first, then spanwise.
    pub boxes: Vec<AeroBox>,
    /// Panels.
    pub surfaces: Vec<Surface>,
}

impl Lattice {
    /// The boxes of a deck's CAERO1 panels.
    ///
    /// # Errors
    /// If a panel refers to an AEFACT or a coordinate system that is not there, divisions do not rise between 0 and 1,
    /// a panel has no area, box numbers collide, or there are more than 50000 boxes or than fit into memory; the card
    /// is blamed.
    pub fn from_bulk(bulk: &BulkData) -> Result<Self, InputError> {
        Self::in_axes(bulk, &StreamAxes::basic())
    }

    /// As [`Lattice::from_bulk`], seen in axes whose x lies along the stream: corners are in those axes, and so is everything
    /// that is computed of the lattice.
    ///
    /// # Errors
    /// As [`Lattice::from_bulk`].
    pub fn in_axes(bulk: &BulkData, axes: &StreamAxes) -> Result<Self, InputError> {
        bulk.refuse_unread_air()?;
        let frames = Frames::resolve(bulk)?;
        let mut lattice = Self::default();
        for panel in bulk.panels.values() {
            let corners = panel_corners(panel, &frames, axes)?;
            let span = fractions(bulk, panel, panel.span_divisions, "spanwise")?;
            let chord = fractions(bulk, panel, panel.chord_divisions, "chordwise")?;
            let count = (span.len() - 1).saturating_mul(chord.len() - 1);
            refuse_too_many(lattice.len().saturating_add(count), panel)?;
            let boxes = divide(panel.id, &corners, &span, &chord).ok_or_else(|| {
                InputError::at(&panel.span, format!("boxes of CAERO1 {} exceed the largest number", panel.id))
            })?;
            if let (Some(last), Some(previous)) = (lattice.boxes.last(), lattice.surfaces.last())
                && last.id >= panel.id
            {
                return Err(InputError::at(
                    &panel.span,
                    format!(
                        "boxes of CAERO1 {} run to {} and collide with CAERO1 {}",
                        previous.id, last.id, panel.id
                    ),
                )
                .with_help("number the panels further apart than they have boxes"));
            }
            lattice.push(format!("CAERO1 {}", panel.id), panel.id, boxes, chord.len() - 1);
        }
        Ok(lattice)
    }

    /// One panel from corner points of its boxes, for lattices that come from no deck; `chordwise` boxes a strip.
    ///
    /// # Errors
    /// If the boxes do not fill whole strips, share a number, or one has no area or no chord along x.
    pub fn from_corners(name: &str, chordwise: usize, boxes: Vec<AeroBox>) -> Result<Self, InputError> {
        if chordwise == 0 || !boxes.len().is_multiple_of(chordwise) {
            return Err(InputError::general(format!(
                "{} boxes of {name} do not fill strips of {chordwise} boxes each",
                boxes.len()
            )));
        }
        for panel in &boxes {
            let finite = panel.corners.iter().flat_map(|c| c.iter()).all(|value| value.is_finite());
            if !finite || panel.area_m2() <= 0.0 || panel.chord_m() <= 0.0 {
                return Err(InputError::general(format!(
                    "box {} of {name} has no area or no chord along x",
                    panel.id
                )));
            }
        }
        let mut lattice = Self::default();
        let id = boxes.first().map_or(0, |panel| panel.id);
        lattice.push(name.to_owned(), id, boxes, chordwise);
        lattice.refuse_shared_numbers()
    }

    /// A trapezoid from a leading-edge point and chord to another, `divisions` = (chordwise, spanwise) equal parts.
    ///
    /// # Errors
    /// As [`Lattice::from_bulk`] for such a CAERO1.
    pub fn trapezoid(
        id: u32,
        side_1: [f64; 3],
        chord_1_m: f64,
        side_2: [f64; 3],
        chord_2_m: f64,
        divisions: [u32; 2],
    ) -> Result<Self, InputError> {
        let panel = Caero1 {
            id,
            property: 0,
            cp: 0,
            span_divisions: Divisions::Equal(divisions[1]),
            chord_divisions: Divisions::Equal(divisions[0]),
            group: 1,
            point_1: side_1.into(),
            chord_1: chord_1_m,
            point_4: side_2.into(),
            chord_4: chord_2_m,
            span: nastran::Span::generated("trapezoid"),
        };
        Self::from_bulk(&BulkData { panels: [(id, panel)].into(), ..BulkData::default() })
    }

    /// This lattice and another behind it.
    ///
    /// # Errors
    /// If they share a box number.
    pub fn joined(&self, other: &Self) -> Result<Self, InputError> {
        let mut all = self.clone();
        let shift =
            |surface: &Surface| Surface { first_box: surface.first_box + self.len(), ..surface.clone() };
        all.surfaces.extend(other.surfaces.iter().map(shift));
        all.boxes.extend(other.boxes.iter().cloned());
        all.refuse_shared_numbers()
    }

    /// The same lattice with every length multiplied by `factor`.
    #[must_use]
    pub fn scaled(&self, factor: f64) -> Self {
        let mut lattice = self.clone();
        for corner in lattice.boxes.iter_mut().flat_map(|panel| panel.corners.iter_mut()) {
            *corner *= factor;
        }
        lattice
    }

    /// Number of boxes.
    pub fn len(&self) -> usize {
        self.boxes.len()
    }

    /// True if there are no boxes.
    pub fn is_empty(&self) -> bool {
        self.boxes.is_empty()
    }

    /// Index of the box with this number.
    pub fn index_of(&self, box_id: u32) -> Option<usize> {
        self.boxes.iter().position(|panel| panel.id == box_id)
    }

    fn push(&mut self, name: String, id: u32, boxes: Vec<AeroBox>, chordwise: usize) {
        let spanwise = boxes.len() / chordwise;
        self.surfaces.push(Surface { id, name, first_box: self.len(), chordwise, spanwise });
        self.boxes.extend(boxes);
    }

    fn refuse_shared_numbers(self) -> Result<Self, InputError> {
        let mut seen = HashSet::new();
        match self.boxes.iter().find(|panel| !seen.insert(panel.id)) {
            Some(panel) => Err(InputError::general(format!("box number {} is used twice", panel.id))),
            None => Ok(self),
        }
    }
}

/// Refuses more boxes than can be computed with, before any is made.
fn refuse_too_many(boxes: usize, panel: &Caero1) -> Result<(), InputError> {
    let at = |message: String| {
        InputError::at(&panel.span, message).with_help("use fewer boxes, along the chord or the span")
    };
    if boxes > MOST_BOXES {
        return Err(at(format!("the panels have {boxes} boxes, and {MOST_BOXES} are the most")));
    }
    let n = boxes as f64;
    nastran::memory::demand(&format!("the matrices of {boxes} boxes"), MEMORY_A_PAIR * n * n)
        .map_err(|error| at(error.message))
}

/// Corners 1 to 4 of a panel in the stream's axes; its chords lie along their x.
fn panel_corners(panel: &Caero1, frames: &Frames, axes: &StreamAxes) -> Result<[Point3<f64>; 4], InputError> {
    let leading_1 = axes.seen(&frames.point(panel.cp, panel.point_1, &panel.span)?);
    let leading_4 = axes.seen(&frames.point(panel.cp, panel.point_4, &panel.span)?);
    let along = |from: &Point3<f64>, chord: f64| from + Vector3::x() * chord;
    let width = (leading_4 - leading_1).yz().norm();
    // Negated so that numbers that are not numbers are refused too.
    let chords_fit = panel.chord_1 >= 0.0 && panel.chord_4 >= 0.0 && panel.chord_1 + panel.chord_4 > 0.0;
    if !(chords_fit && width > 0.0 && (panel.chord_1 + panel.chord_4 + width).is_finite()) {
        return Err(InputError::at(
            &panel.span,
            format!(
                "CAERO1 {} has no area: chords {} and {} m, width {width} m",
                panel.id, panel.chord_1, panel.chord_4
            ),
        )
        .with_help("chords must not be negative nor both zero, and the sides must lie apart in y or z"));
    }
    Ok([leading_1, along(&leading_1, panel.chord_1), along(&leading_4, panel.chord_4), leading_4])
}

/// Boundaries of the divisions, from 0 to 1.
fn fractions(bulk: &BulkData, panel: &Caero1, of: Divisions, which: &str) -> Result<Vec<f64>, InputError> {
    match of {
        Divisions::Equal(count) if count == 0 || count as usize > MOST_BOXES => Err(InputError::at(
            &panel.span,
            format!("CAERO1 {} has {count} {which} divisions, expected 1 to {MOST_BOXES}", panel.id),
        )),
        Divisions::Equal(count) => Ok((0..=count).map(|i| f64::from(i) / f64::from(count)).collect()),
        Divisions::Aefact(id) => {
            let list = bulk.factors.get(&id).ok_or_else(|| {
                InputError::at(
                    &panel.span,
                    format!("CAERO1 {} refers to AEFACT {id}, which is not there", panel.id),
                )
            })?;
            rising_fractions(list)
        }
    }
}

/// How far the ends of an AEFACT may be from 0 and 1, as fields of eight characters round them: `.9999999`.
const ROUNDED: f64 = 1e-6;

/// The numbers of an AEFACT, which must rise between 0 and 1; ends that are rounded are 0 and 1, so that panels meet. A list that begins
/// or ends elsewhere makes boxes of that part of the panel alone, as in Nastran ([`BulkData::division_remark`] says it).
fn rising_fractions(list: &Aefact) -> Result<Vec<f64>, InputError> {
    let mut values = list.values.clone();
    for (end, exact) in [(0, 0.0), (values.len().saturating_sub(1), 1.0)] {
        if let Some(value) = values.get_mut(end).filter(|value| (**value - exact).abs() <= ROUNDED) {
            *value = exact;
        }
    }
    let rising = values.windows(2).all(|pair| pair[0] < pair[1]);
    if values.len() >= 2 && rising && values.iter().all(|value| (0.0..=1.0).contains(value)) {
        return Ok(values);
    }
    Err(InputError::at(
        &list.span,
        format!("divisions on AEFACT {} do not rise between 0.0 and 1.0", list.id),
    )
    .with_help("list the boundaries of all strips or boxes, the first 0.0 and the last 1.0"))
}

/// The boxes of a panel; `None` if their numbers do not fit.
fn divide(id: u32, corners: &[Point3<f64>; 4], span: &[f64], chord: &[f64]) -> Option<Vec<AeroBox>> {
    let [c1, c2, c3, c4] = corners;
    // Equal values stay equal and the ends are the panel's own corners, to the last bit: flat panels stay flat.
    let between = |a: f64, b: f64, f: f64| if f == 1.0 { b } else { a + f * (b - a) };
    let mix = |a: &Point3<f64>, b: &Point3<f64>, f: f64| {
        Point3::new(between(a.x, b.x, f), between(a.y, b.y, f), between(a.z, b.z, f))
    };
    let at = |eta: f64, xi: f64| mix(&mix(c1, c4, eta), &mix(c2, c3, eta), xi);
    let mut boxes = Vec::with_capacity((span.len() - 1) * (chord.len() - 1));
    for side in span.windows(2) {
        for edge in chord.windows(2) {
            let corners =
                [at(side[0], edge[0]), at(side[0], edge[1]), at(side[1], edge[1]), at(side[1], edge[0])];
            boxes.push(AeroBox { id: id.checked_add(u32::try_from(boxes.len()).ok()?)?, corners });
        }
    }
    Some(boxes)
}
