//! What to measure next: by how much each sensor would narrow the interval of one prediction.

use super::known::{Known, over};
use super::predictions::{Predicted, Quantity, predict};
use super::read::read_case;
use crate::calibration::Calibration;
use crate::campaign::TIP;
use crate::sensors::{Reading, Row, Together};
use coupling::wing_file::CorrectionPrior;
use coupling::{CouplingError, ElasticWing, SteadyCase};
use nastran::InputError;

/// Places of strain bridges along the span, as shares of it.
const BRIDGES: [f64; 4] = [0.2, 0.4, 0.6, 0.8];
/// A strain bridge reads bending to this share of its largest reading.
const BRIDGE_SHARE: f64 = 0.01;
/// A marker at the tip reads its height to this, m, where the campaign declares nothing.
const TIP_M: f64 = 1e-3;
/// Deflections of static points, deg.
const DEFLECTED_DEG: [f64; 2] = [-10.0, 10.0];

/// A measurement that was not made, and what it would do.
#[derive(Debug, Clone, PartialEq)]
pub struct Suggestion {
    /// What to measure.
    pub measure: String,
    /// Standard deviation of the prediction with the data there are.
    pub sigma: f64,
    /// The same with this measurement beside them.
    pub sigma_then: f64,
}

/// Ranks sensors and points by how much they would narrow a prediction at the highest airspeed, the best first.
///
/// # Errors
/// If the wing cannot be solved.
pub fn rank(
    wing: &ElasticWing,
    calibration: &Calibration,
    prior: &CorrectionPrior,
    wanted: &Quantity,
) -> Result<Vec<Suggestion>, CouplingError> {
    let (all, joint) = Known::all(wing, calibration, prior)?;
    let Some((last, known)) = all.iter().enumerate().next_back() else { return Ok(Vec::new()) };
    let in_case = |case: &SteadyCase, quantity: &Quantity| {
        let quantity = std::slice::from_ref(quantity);
        Ok::<_, InputError>(predict(wing, &known.corrected, &known.off, case, quantity)?.swap_remove(0))
    };
    let at_angles = |quantity: &Quantity| {
        known
            .alphas_rad
            .iter()
            .map(|&alpha| in_case(&known.case(alpha), quantity))
            .collect::<Result<Vec<_>, _>>()
    };
    let data = &calibration.data;
    let gradient = |reading: usize, read: &Predicted| {
        known.with_reading(read.gradient(&known.unknowns), reading, read.value())
    };
    let reading_of_wanted = known.reading_of(wanted, &data.sensors);
    // a reading that the data have not is off by something of its own
    let reading_of = |quantity: &Quantity| match known.reading_of(quantity, &data.sensors) {
        reading if reading == reading_of_wanted && quantity != wanted => reading + 1,
        reading => reading,
    };
    let asked = gradient(reading_of_wanted, &in_case(&known.largest(), wanted)?);
    let sigma = joint.sigma(last, &asked);
    let mut found = Vec::new();
    let mut suggest = |measure: String, rows: Vec<Vec<f64>>| {
        found.push(Suggestion { measure, sigma, sigma_then: joint.sigma_with(last, &rows, &asked) });
    };
    let rows = |quantity: &Quantity, readings: &[Predicted], sigma: f64| {
        readings.iter().map(|read| over(gradient(reading_of(quantity), read), sigma)).collect()
    };
    if !data.channels[TIP] {
        let tip_m = if known.sigma[TIP] > 0.0 { known.sigma[TIP] } else { TIP_M };
        let measure = format!(
            "the tip's height (to {:.1} mm, its wind-off zero known) at the angles measured",
            1e3 * tip_m
        );
        suggest(measure, rows(&Quantity::TipHeight, &at_angles(&Quantity::TipHeight)?, tip_m));
    }
    for y_over_span in BRIDGES {
        let bending = Quantity::Reading(Reading::Bending { y_over_span });
        let readings = at_angles(&bending)?;
        let most = readings.iter().map(|read| read.value().abs()).fold(f64::MIN_POSITIVE, f64::max);
        let measure =
            format!("bending by strain (to 1 %) at {y_over_span:.1} of the span, at the angles measured");
        suggest(measure, rows(&bending, &readings, BRIDGE_SHARE * most));
    }
    for (c, control) in wing.control_names().into_iter().enumerate() {
        let measure = format!("root loads with {control} at -10 and 10 degrees");
        suggest(measure, deflected_rows(wing, known, c, data.channels));
    }
    found.sort_by(|a, b| a.sigma_then.total_cmp(&b.sigma_then));
    Ok(found)
}

/// Rows of root loads with a control deflected, at the middle of the angles measured.
fn deflected_rows(
    wing: &ElasticWing,
    known: &Known<'_>,
    control: usize,
    channels: [bool; 4],
) -> Vec<Vec<f64>> {
    let middle = known.case(known.alphas_rad[known.alphas_rad.len() / 2]);
    let balance = Together::new(wing, (0..3).map(Row::Balance).collect());
    let mut rows = Vec::new();
    for deflection_deg in DEFLECTED_DEG {
        let mut deflected = middle.clone();
        deflected.controls_rad = vec![0.0; wing.controls.len()];
        deflected.controls_rad[control] = f64::to_radians(deflection_deg);
        let loads = read_case(&known.corrected, &known.off, &deflected, &balance);
        rows.extend((0..3).filter(|&channel| channels[channel]).map(|channel| {
            let by_wing = known.unknowns.gradient(&loads, channel);
            let reading = known.reading_of_channel(channel);
            over(known.with_reading(by_wing, reading, loads.values[channel]), known.sigma[channel])
        }));
    }
    rows
}
