//! The time of the whole aircraft: building it with its unsteady air, and flying its chirp and its gust.

use std::time::Instant;

use fullaircraft::{Aircraft, FlightAir, FlyingAircraft, FreeFlight, Gust, Integration};
use serde_json::{Value, json};

use super::bench_clock::{cpu_seconds, median, peak_mb, row};
use crate::repository;
use wingroot::failure::Failure;

/// The shipped aircraft with its shell wings, once; then the chirp (linearisation included) and one second of a gust
/// without linearisation.
pub(crate) fn rows() -> Result<Vec<Value>, Failure> {
    let (start, cpu) = (Instant::now(), cpu_seconds());
    let aircraft = Aircraft::read(&repository::path("data/tuflex/aircraft.ron"), None)?;
    let assembled = start.elapsed().as_secs_f64();
    let air = FlightAir::new(&aircraft)?;
    let boxes = aircraft.flow.lattice.len();
    let frequencies = fullaircraft::flight::air::REDUCED_FREQUENCIES.len();
    let mut built = row(
        &format!("aircraft_{boxes}_boxes_{frequencies}_frequencies_modes"),
        start.elapsed().as_secs_f64(),
    );
    built["cpu_seconds"] = json!(cpu_seconds() - cpu);
    built["assembly_seconds"] = json!(assembled);
    built["peak_MB"] = json!(peak_mb());
    let model = aircraft.uncorrected();
    let trim = model.trim("trim", &aircraft.file.trim)?;
    let chirp = &aircraft.file.chirp;
    let flown = median(|| {
        std::hint::black_box(
            FreeFlight::new(&model, &air, &trim, chirp.control().unwrap_or_default())?.fly_motion(chirp),
        );
        Ok(())
    })?;
    let gust = Gust { velocity_m_s: 3.0, length_m: 5.6, start_s: 0.2 };
    let flying = FlyingAircraft::new(&model, &air, &trim, Vec::new(), Some(gust))?;
    let nonlinear = median(|| {
        std::hint::black_box(flying.fly(&[], 1.0, &Integration::default())?);
        Ok(())
    })?;
    Ok(vec![
        built,
        row(&format!("aircraft_chirp_{}_s_linear", chirp.record_s()), flown),
        row("aircraft_gust_1_s_nonlinear", nonlinear),
    ])
}
