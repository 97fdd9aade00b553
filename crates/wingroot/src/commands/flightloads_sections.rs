//! Sections of a wing in `flightloads`: measured lift coefficients beside those of both models, each section a station of its own.
//!
//! A section stands for the part of the half wing that is nearer to it than to any other: measured is `q c cl` times the part's width,
//! calculated the lift of a metre of span there times the same width. No fit uses sections.

use loads::FlightFile;
use loads::compare::{Gauge, Zero};
use loads::flight::{Channel, Condition, Reading, State};
use loads::select::file::Load;
use nastran::{InputError, Table, named_file};
use std::collections::BTreeMap;

use super::flightloads_measured::Measured;
use super::flightloads_span::SpanLift;
use super::flightloads_wing::{Calculated, TunnelWing};
use crate::failure::Failure;

/// Columns of the table.
const COLUMNS: [&str; 4] = ["V_m_s", "alpha_deg", "two_y_over_b", "cl"];
/// The station of all sections.
const ALL: &str = "all sections";

/// A condition of sections; `wing` with the density of the air.
///
/// # Errors
/// If there is no wing, or the table is not what it should be.
pub(super) fn sections(
    file: &FlightFile,
    condition: &Condition,
    name: &str,
    wing: Option<(&TunnelWing, f64)>,
) -> Result<Measured, Failure> {
    let (wing, rho_kg_m3) = wing.ok_or_else(|| {
        InputError::in_file(&file.path, "sections are compared with a wing in known air")
            .with_help("name the `wing`, and give rho_kg_m3 or a campaign")
    })?;
    let path = named_file(&file.path, name)?;
    let table = Table::read(&path)?;
    table.require(&COLUMNS)?;
    let places = table.numbers("two_y_over_b")?;
    if places.is_empty() {
        return Err(InputError::in_file(&path, "there are no sections").into());
    }
    if let Some(row) = places.iter().position(|place| !(0.0..=1.0).contains(place)) {
        return Err(InputError::at(&table.span(row, "two_y_over_b"), "a section is on no half wing")
            .with_help("expected numbers from 0 at the root to 1 at the tip")
            .into());
    }
    let mut sorted = places.clone();
    sorted.sort_by(f64::total_cmp);
    sorted.dedup();
    let channels = channels(&sorted);
    let models: &[bool] = if wing.is_corrected() { &[false, true] } else { &[false] };
    let mut readings = Vec::new();
    let mut calculated: [Vec<Calculated>; 2] = [Vec::new(), Vec::new()];
    let mut known: BTreeMap<String, SpanLift> = BTreeMap::new();
    for (row, &place) in places.iter().enumerate() {
        let state = State {
            v_m_s: table.number(row, "V_m_s")?,
            alpha_deg: table.number(row, "alpha_deg")?,
            controls_deg: BTreeMap::new(),
        };
        let own = sorted.partition_point(|known| *known < place);
        let mut reading = empty(&table, row, &state, channels.len());
        for &is_updated in models {
            let key = format!("{:?} {:?} {is_updated}", state.v_m_s, state.alpha_deg);
            if !known.contains_key(&key) {
                known.insert(key.clone(), wing.along_the_span(&reading, &state, is_updated, rho_kg_m3)?);
            }
            let span = &known[&key];
            let width_m = share(&sorted, own) * span.half_span_m;
            let q_pa = 0.5 * rho_kg_m3 * state.v_m_s * state.v_m_s;
            let measured = q_pa * span.at(&span.chord_m, place) * table.number(row, "cl")? * width_m;
            let load = span.at(&span.lift_n_m, place) * width_m;
            let mut loads = vec![0.0; channels.len()];
            for at in [own, channels.len() - 1] {
                (loads[at], reading.measured[at]) = (load, Some(measured));
            }
            calculated[usize::from(is_updated)].push(Calculated { sigma: vec![0.0; loads.len()], loads });
        }
        readings.push(reading);
    }
    let calculated = calculated.map(|all| (!all.is_empty()).then_some(all));
    Ok(Measured { condition: condition.clone(), channels, readings, calculated })
}

/// A station each section, and one of all together.
fn channels(places: &[f64]) -> Vec<Channel> {
    let names = places.iter().map(|place| format!("2y/b {place}")).chain([ALL.to_owned()]);
    let gauge = Gauge { sigma: None, factor_sigma: 0.0, zero: Zero::Known };
    names.map(|station| Channel { station, load: Load::Fz, gauge }).collect()
}

/// The share of the half span that is nearest to one of sorted sections.
fn share(places: &[f64], at: usize) -> f64 {
    let middle = |a: usize, b: usize| 0.5 * (places[a] + places[b]);
    let from = if at == 0 { 0.0 } else { middle(at - 1, at) };
    let to = if at + 1 == places.len() { 1.0 } else { middle(at, at + 1) };
    to - from
}

fn empty(table: &Table, row: usize, state: &State, channels: usize) -> Reading {
    Reading {
        place: table.span(row, "cl"),
        state: Some(state.clone()),
        v_m_s: Some(state.v_m_s),
        n_z: None,
        measured: vec![None; channels],
        calculated: [None, None],
        fitted: false,
    }
}
