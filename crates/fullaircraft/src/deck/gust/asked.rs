//! What a deck asks of a gust: GUST, DLOAD, FREQUENCY, TSTEP of its subcases, and the flow (PARAM Q and MACH).

use super::signal::Signal;
use aero::Flow;
use nastran::{BulkData, Gust, InputError, Subcase};

/// A subcase that a gust or loads excite.
#[derive(Debug, Clone, PartialEq)]
pub struct GustCase {
    /// The subcase.
    pub subcase: Subcase,
    /// Its GUST; none where loads alone excite.
    pub gust: Option<Gust>,
    /// Airspeed and density, the deck's units.
    pub flow: Flow,
    /// Mach number.
    pub mach: f64,
    /// Frequencies, Hz, rising.
    pub hz: Vec<f64>,
    /// Times of answers, s; none if the load is given over frequency or no TSTEP is selected.
    pub times_s: Option<Vec<f64>>,
    /// What the user should know.
    pub remarks: Vec<String>,
    /// The gust's function.
    pub(crate) gust_signal: Signal,
    /// Loads of DLOAD.
    pub(crate) load_signal: Signal,
}

/// Cards that give frequencies by the modes and are not read.
const BY_MODES: [&str; 3] = ["FREQ3", "FREQ4", "FREQ5"];

/// The subcases of a deck that select a GUST, or a DLOAD in the air.
///
/// # Errors
/// If there is none, or what one selects is not there or not read.
pub fn gust_cases(bulk: &BulkData) -> Result<Vec<GustCase>, InputError> {
    bulk.refuse_unread_air()?;
    let excited = bulk.subcases.iter().filter(|case| case.gust.is_some() || case.dynamic_load.is_some());
    let cases: Vec<GustCase> = excited.map(|case| asked(bulk, case)).collect::<Result<_, _>>()?;
    if cases.is_empty() {
        return Err(InputError::general("the deck asks for no gust").with_help(
            "add a GUST card and select it by GUST in the case control, with DLOAD and FREQUENCY",
        ));
    }
    Ok(cases)
}

fn asked(bulk: &BulkData, case: &Subcase) -> Result<GustCase, InputError> {
    let mut remarks = Vec::new();
    let gust = match case.gust {
        None => None,
        Some(id) => Some(bulk.gusts.get(&id).cloned().ok_or_else(|| missing("GUST", id))?),
    };
    let none = Signal { parts: Vec::new() };
    let gust_signal = gust.as_ref().map_or(Ok(none.clone()), |gust| Signal::of(bulk, gust.load))?;
    let load_signal = case.dynamic_load.map_or(Ok(none), |set| Signal::of(bulk, set))?;
    let is_in_time = match (gust_signal.is_in_time(), load_signal.is_in_time()) {
        (Some(gust), Some(load)) if gust == load => gust,
        (Some(one), None) if load_signal.parts.is_empty() => one,
        (None, Some(one)) if gust_signal.parts.is_empty() => one,
        _ => {
            let message = format!("subcase {} mixes loads in time with loads over frequency", case.id);
            return Err(InputError::general(message).with_help("give all of them as TLOAD, or all as RLOAD"));
        }
    };
    let (flow, mach) = flow(bulk, gust.as_ref(), &mut remarks)?;
    let times_s = match case.time_steps {
        Some(id) if is_in_time => Some(bulk.time_steps.get(&id).ok_or_else(|| missing("TSTEP", id))?.times()),
        _ => None,
    };
    if is_in_time && times_s.is_none() {
        remarks.push("no TSTEP is selected: answers are over frequency alone".to_owned());
    }
    let hz = frequencies(bulk, case)?;
    Ok(GustCase { subcase: case.clone(), gust, flow, mach, hz, times_s, remarks, gust_signal, load_signal })
}

fn missing(name: &str, id: u32) -> InputError {
    InputError::general(format!("the case control selects {name} {id}, which is not there"))
}

/// Airspeed and density by GUST and PARAM Q, and PARAM MACH.
fn flow(bulk: &BulkData, gust: Option<&Gust>, remarks: &mut Vec<String>) -> Result<(Flow, f64), InputError> {
    let aero = bulk.unsteady_reference.as_ref();
    let aero =
        aero.ok_or_else(|| InputError::general("the deck has no AERO, which the answer to a gust needs"))?;
    let velocity = gust.map(|gust| gust.velocity).or(aero.velocity).filter(|v| *v > 0.0);
    let v_m_s = velocity.ok_or_else(|| {
        InputError::at(&aero.span, "AERO has no VELOCITY above zero, which loads in the air need")
    })?;
    if let Some(other) = aero.velocity.filter(|other| *other > 0.0 && (other / v_m_s - 1.0).abs() > 1e-3) {
        remarks.push(format!("VELOCITY of AERO is {other} and V of GUST {v_m_s}: the gust's is taken, also for reduced frequencies, which MSC Nastran takes by AERO's"));
    }
    let parameter = |name: &str| bulk.parameters.get(name).copied();
    let rho_kg_m3 = match parameter("Q") {
        Some(q) if q > 0.0 => 2.0 * q / (v_m_s * v_m_s),
        Some(q) => return Err(InputError::general(format!("PARAM Q is {q}, and must be above zero"))),
        None => {
            let q = 0.5 * aero.density * v_m_s * v_m_s;
            remarks.push(format!("the deck has no PARAM Q: RHOREF of AERO gives {q}"));
            aero.density
        }
    };
    let mach = parameter("MACH").unwrap_or(0.0);
    if !(0.0..1.0).contains(&mach) {
        let message = format!("PARAM MACH is {mach}: the doublet lattice is subsonic");
        return Err(InputError::general(message).with_help("give a Mach number below 1"));
    }
    Ok((Flow { v_m_s, rho_kg_m3 }, mach))
}

/// The frequencies of all cards of the set, Hz, rising, each once.
fn frequencies(bulk: &BulkData, case: &Subcase) -> Result<Vec<f64>, InputError> {
    let Some(set) = case.frequencies else {
        return Err(InputError::general(format!("subcase {} selects no FREQUENCY", case.id))
            .with_help("select FREQ, FREQ1 or FREQ2 cards in the case control"));
    };
    let of_modes = BY_MODES.iter().find_map(|name| {
        bulk.unknown.get(*name).filter(|unread| unread.numbers.contains(&set)).map(|unread| (name, unread))
    });
    if let Some((name, unread)) = of_modes {
        let message = format!("{name} gives frequencies by the modes, which is not read");
        return Err(
            InputError::at(&unread.first, message).with_help("list frequencies by FREQ, FREQ1 or FREQ2")
        );
    }
    let cards = bulk.frequencies.iter().filter(|card| card.set == set);
    let mut hz: Vec<f64> = cards.flat_map(|card| card.hz.iter().copied()).collect();
    if hz.is_empty() {
        return Err(missing("FREQUENCY", set));
    }
    hz.sort_by(f64::total_cmp);
    hz.dedup_by(|b, a| (*b - *a).abs() <= 1e-9 * a.abs());
    Ok(hz)
}

#[cfg(test)]
mod tests;
