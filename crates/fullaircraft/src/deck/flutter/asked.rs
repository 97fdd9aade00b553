//! At which points a deck looks for flutter: FLUTTER and its lists (FLFACT).

use aero::Flow;
use nastran::{Aero, BulkData, Flutter, FlutterMethod, InputError, Subcase};

/// Points that belong together.
#[derive(Debug, Clone, PartialEq)]
pub enum FlutterPoints {
    /// PK: rising airspeeds at one density and Mach number. PKNL: matched points of one Mach number.
    Speeds {
        /// Mach number.
        mach: f64,
        /// Airspeeds and densities, the deck's units.
        flows: Vec<Flow>,
    },
    /// PKNL: matched points of rising airspeeds and several Mach numbers.
    Matched {
        /// Mach numbers, one a flow.
        machs: Vec<f64>,
        /// Airspeeds and densities, the deck's units.
        flows: Vec<Flow>,
    },
    /// K and KE: reduced frequencies at one density and Mach number.
    Frequencies {
        /// Mach number.
        mach: f64,
        /// Density, the deck's unit.
        density: f64,
        /// Reduced frequencies.
        ks: Vec<f64>,
        /// Whether viscous damping counts (K).
        is_damped: bool,
    },
}

impl FlutterPoints {
    /// Mach numbers, each once.
    pub fn machs(&self) -> Vec<f64> {
        match self {
            Self::Speeds { mach, .. } | Self::Frequencies { mach, .. } => vec![*mach],
            Self::Matched { machs, .. } => machs.clone(),
        }
    }

    /// Mach number at an airspeed (the deck's unit): that of the points, between two matched ones in proportion.
    pub fn mach_at(&self, v_m_s: f64) -> f64 {
        match self {
            Self::Speeds { mach, .. } | Self::Frequencies { mach, .. } => *mach,
            Self::Matched { machs, flows } => {
                let above = flows.partition_point(|flow| flow.v_m_s < v_m_s);
                if above == 0 || above == flows.len() {
                    return machs[above.min(flows.len() - 1)];
                }
                let [low, high] = [above - 1, above].map(|place| flows[place].v_m_s);
                let share = (v_m_s - low) / (high - low);
                (1.0 - share) * machs[above - 1] + share * machs[above]
            }
        }
    }
}

/// The subcases of a deck that select a FLUTTER, with it; of a deck without case control its only FLUTTER.
///
/// # Errors
/// If there is none, or one that is selected is not there.
pub fn flutter_cases(bulk: &BulkData) -> Result<Vec<(Subcase, Flutter)>, InputError> {
    bulk.refuse_unread_air()?;
    let mut cases = Vec::new();
    for case in &bulk.subcases {
        let Some(id) = case.flutter else { continue };
        let card = bulk.flutters.get(&id).ok_or_else(|| {
            InputError::general(format!("the case control selects FMETHOD {id}, which is not there"))
        })?;
        cases.push((case.clone(), card.clone()));
    }
    if let (true, [] | [_], [card]) =
        (cases.is_empty(), bulk.subcases.as_slice(), bulk.flutters.values().collect::<Vec<_>>().as_slice())
    {
        cases.push((bulk.subcases.first().cloned().unwrap_or_default(), (*card).clone()));
    }
    if cases.is_empty() {
        return Err(InputError::general("the deck asks for no flutter")
            .with_help("add a FLUTTER card and select it by FMETHOD in the case control"));
    }
    Ok(cases)
}

/// The points of a FLUTTER card, those that belong together in one group.
///
/// # Errors
/// If a list is not there, airspeeds or densities are not positive, or lists of matched points differ in length.
pub(crate) fn points(bulk: &BulkData, card: &Flutter, aero: &Aero) -> Result<Vec<FlutterPoints>, InputError> {
    let list = |id: u32, what: &str| {
        let found = bulk.flutter_factors.get(&id).map(|list| list.values.clone());
        found.ok_or_else(|| {
            InputError::at(
                &card.span,
                format!("FLFACT {id}, the {what} of FLUTTER {}, is not there", card.id),
            )
        })
    };
    let (ratios, machs) = (list(card.densities, "density ratios")?, list(card.machs, "Mach numbers")?);
    let is_k = matches!(card.method, FlutterMethod::K { .. });
    // Minus asks for eigenvectors.
    let speeds: Vec<f64> = list(card.speeds, if is_k { "reduced frequencies" } else { "airspeeds" })?
        .into_iter()
        .map(f64::abs)
        .collect();
    for (what, values) in [("density ratios", &ratios), ("airspeeds or reduced frequencies", &speeds)] {
        if values.iter().any(|value| !(*value > 0.0 && value.is_finite())) {
            let message = format!("the {what} of FLUTTER {} are not all above zero", card.id);
            return Err(InputError::at(&card.span, message));
        }
    }
    let flow = |ratio: f64, v_m_s: f64| Flow { v_m_s, rho_kg_m3: ratio * aero.density };
    if card.method == FlutterMethod::Pknl {
        return matched(card, &ratios, &machs, &speeds, &flow);
    }
    let mut rising = speeds.clone();
    rising.sort_by(f64::total_cmp);
    rising.dedup();
    let pairs = machs.iter().flat_map(|mach| ratios.iter().map(|ratio| (*mach, *ratio)));
    Ok(pairs
        .map(|(mach, ratio)| match card.method {
            FlutterMethod::K { is_efficient } => FlutterPoints::Frequencies {
                mach,
                density: ratio * aero.density,
                ks: speeds.clone(),
                is_damped: !is_efficient,
            },
            _ => FlutterPoints::Speeds { mach, flows: rising.iter().map(|v| flow(ratio, *v)).collect() },
        })
        .collect())
}

/// Matched points in the order given: in one group if their airspeeds rise or the Mach number stays.
fn matched(
    card: &Flutter,
    ratios: &[f64],
    machs: &[f64],
    speeds: &[f64],
    flow: &dyn Fn(f64, f64) -> Flow,
) -> Result<Vec<FlutterPoints>, InputError> {
    if ratios.len() != machs.len() || machs.len() != speeds.len() {
        let message = format!(
            "FLUTTER {} matches {} density ratios, {} Mach numbers and {} airspeeds one by one",
            card.id,
            ratios.len(),
            machs.len(),
            speeds.len()
        );
        return Err(
            InputError::at(&card.span, message).with_help("give three lists of one length, or the method PK")
        );
    }
    let mut all: Vec<(f64, Flow)> =
        (0..speeds.len()).map(|i| (machs[i], flow(ratios[i], speeds[i]))).collect();
    // The last is often given again with the sign that asks for eigenvectors.
    all.dedup();
    let is_rising = all.windows(2).all(|pair| pair[0].1.v_m_s < pair[1].1.v_m_s);
    if is_rising && all.iter().any(|point| point.0 != all[0].0) {
        let (machs, flows) = all.into_iter().unzip();
        return Ok(vec![FlutterPoints::Matched { machs, flows }]);
    }
    // Those of one Mach number that follow each other.
    let groups = all.chunk_by(|a, b| a.0 == b.0);
    Ok(groups
        .map(|group| FlutterPoints::Speeds {
            mach: group[0].0,
            flows: group.iter().map(|point| point.1).collect(),
        })
        .collect())
}

#[cfg(test)]
mod tests;
