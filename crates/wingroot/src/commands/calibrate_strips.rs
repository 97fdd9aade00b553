//! Spanwise lift beside measured strips, if the campaign's folder has some (`strips.csv`). Never part of a fit.

use std::path::Path;

use aero::{Corrections, Flow};
use calibrate::Calibration;
use coupling::SteadyCase;
use nastran::table::Table;
use nastran::{InputError, Span};
use report::{Figure, Panel, Series, Style};

use crate::commands::calibrate_model::Fitted;
use crate::commands::calibrate_result::{StripResult, StripsRms};
use crate::failure::Failure;

/// Measured strips of one angle at one airspeed, and the models' at the same places; all as cl/CL.
pub(crate) struct Strips {
    v_m_s: f64,
    alpha_deg: f64,
    two_y_over_b: Vec<f64>,
    measured: Vec<f64>,
    initial: Vec<f64>,
    updated: Vec<f64>,
    /// The models at every strip of the lattice, for the figure: place, initial, updated.
    curves: [Vec<f64>; 3],
}

/// Reads `strips.csv` of a campaign, if it is there, and compares.
///
/// # Errors
/// A misspelt column, a cell that is not a number, an airspeed or angle that the static cases do not have.
pub(crate) fn compare(
    folder: &Path,
    fitted: &Fitted<'_>,
    calibration: &Calibration,
) -> Result<Option<Strips>, Failure> {
    let wing = fitted.elastic();
    let path = folder.join("strips.csv");
    if !path.is_file() {
        return Ok(None);
    }
    let table = Table::read(&path)?;
    let columns = ["V_m_s", "alpha_deg", "two_y_over_b", "cl"];
    table.require(&columns)?;
    table.allow_only(|name| columns.contains(&name), "V_m_s, alpha_deg, two_y_over_b or cl")?;
    if table.is_empty() {
        return Err(InputError::in_file(&path, "there are no strips").into());
    }
    let (v_m_s, alpha_deg) = (table.number(0, "V_m_s")?, table.number(0, "alpha_deg")?);
    for row in 1..table.len() {
        if table.number(row, "V_m_s")? != v_m_s || table.number(row, "alpha_deg")? != alpha_deg {
            return Err(InputError::at(&table.span(row, "V_m_s"), "strips of another airspeed or angle")
                .with_help("one file holds the strips of one angle at one airspeed")
                .into());
        }
    }
    let (corrections, measured_fz_n) =
        measured_point(calibration, v_m_s, alpha_deg, &table.span(0, "V_m_s"))?;
    let case = SteadyCase::new(Flow { v_m_s, rho_kg_m3: calibration.rho_kg_m3 }, alpha_deg.to_radians());
    let area_m2: f64 = wing.correctable.places.iter().map(|&place| wing.lattice.boxes[place].area_m2()).sum();
    let q_pa = case.flow.dynamic_pressure_pa();
    let measured_total = measured_fz_n / (q_pa * area_m2);
    let two_y_over_b = table.numbers("two_y_over_b")?;
    let neutral = Corrections::neutral(wing.correctable.len());
    let (places, initial) = distribution(fitted, &case, &neutral)?;
    let (_, updated) = distribution(fitted, &case, corrections)?;
    let at = |curve: &[f64]| two_y_over_b.iter().map(|y| interpolated(&places, curve, *y)).collect();
    Ok(Some(Strips {
        v_m_s,
        alpha_deg,
        measured: table.numbers("cl")?.into_iter().map(|cl| cl / measured_total).collect(),
        initial: at(&initial),
        updated: at(&updated),
        two_y_over_b,
        curves: [places, initial, updated],
    }))
}

/// Corrections of the strips' airspeed and the measured Fz at their angle.
fn measured_point<'a>(
    calibration: &'a Calibration,
    v_m_s: f64,
    alpha_deg: f64,
    span: &Span,
) -> Result<(&'a Corrections, f64), InputError> {
    let airspeed = calibration.airspeeds.iter().find(|a| (a.data.v_m_s - v_m_s).abs() < 2e-3 * v_m_s);
    let angle = airspeed.and_then(|a| {
        a.data.angles.iter().find(|angle| (angle.alpha_rad.to_degrees() - alpha_deg).abs() < 0.05)
    });
    match (airspeed, angle) {
        (Some(airspeed), Some(angle)) if calibration.data.channels[0] => {
            Ok((&airspeed.corrections, angle.loads.fz))
        }
        _ => Err(InputError::at(
            span,
            format!("no static case with Fz at {v_m_s} m/s and {alpha_deg} degrees"),
        )
        .with_help("strips are compared at an airspeed and angle of static.csv")),
    }
}

/// cl/CL of every strip of the wing and where its middle is, 0 at the root, 1 at the tip.
fn distribution(
    fitted: &Fitted<'_>,
    case: &SteadyCase,
    corrections: &Corrections,
) -> Result<(Vec<f64>, Vec<f64>), Failure> {
    let wing = fitted.elastic();
    let seen = &fitted.solve(std::slice::from_ref(case), corrections)?[0];
    let boxes = &wing.correctable;
    let strips = boxes.strip.iter().max().map_or(0, |last| last + 1);
    let (mut lift, mut area, mut place) = (vec![0.0; strips], vec![0.0; strips], vec![0.0; strips]);
    for (b, &at) in boxes.places.iter().enumerate() {
        lift[boxes.strip[b]] += seen.box_loads().values[2 * at] * wing.lattice.boxes[at].normal().z;
        area[boxes.strip[b]] += wing.lattice.boxes[at].area_m2();
        place[boxes.strip[b]] = boxes.y_norm[b];
    }
    let mean = lift.iter().sum::<f64>() / area.iter().sum::<f64>();
    Ok((place, lift.iter().zip(&area).map(|(lift, area)| lift / area / mean).collect()))
}

/// Linear between the middles of strips, constant beyond them.
fn interpolated(places: &[f64], values: &[f64], at: f64) -> f64 {
    let above = places.partition_point(|place| *place < at);
    if above == 0 || above == places.len() {
        return values[above.min(places.len() - 1)];
    }
    let share = (at - places[above - 1]) / (places[above] - places[above - 1]);
    values[above - 1] + share * (values[above] - values[above - 1])
}

impl Strips {
    /// Measured beside computed.
    pub(crate) fn rows(&self) -> Vec<StripResult> {
        let row = |i: usize| StripResult {
            two_y_over_b: self.two_y_over_b[i],
            measured: self.measured[i],
            initial: self.initial[i],
            updated: self.updated[i],
        };
        (0..self.measured.len()).map(row).collect()
    }

    /// How far they are apart.
    pub(crate) fn rms(&self) -> StripsRms {
        let rms = |model: &[f64]| {
            let squares = model.iter().zip(&self.measured).map(|(m, x)| (m - x).powi(2)).sum::<f64>();
            (squares / model.len() as f64).sqrt()
        };
        StripsRms {
            note: "cl/CL; not used in the fit",
            v_m_s: self.v_m_s,
            alpha_deg: self.alpha_deg,
            initial: rms(&self.initial),
            updated: rms(&self.updated),
        }
    }

    /// cl/CL over the span.
    ///
    /// # Errors
    /// If it cannot be drawn.
    pub(crate) fn figure(&self) -> Figure {
        let [places, initial, updated] = &self.curves;
        let series = vec![
            Series::new("initial", places.clone(), initial.clone(), Style::DashedLine),
            Series::new("updated", places.clone(), updated.clone(), Style::Line),
            Series::new(
                "measured, not fitted",
                self.two_y_over_b.clone(),
                self.measured.clone(),
                Style::Points,
            ),
        ];
        let panel = Panel::new("", "2y/b (-)", "cl/CL (-)", series);
        let title = format!("Spanwise lift at {} m/s, {} degrees", self.v_m_s, self.alpha_deg);
        Figure::new(title, vec![panel], 1)
    }
}
