//! Numbers of a tunnel's file beyond what its structure says: sizes, names of files and what the truth can be.

use crate::file::{Corners, TunnelFile};
use std::collections::BTreeSet;
use std::path::Path;

/// Most rows of the static cases.
const MOST_ROWS: usize = 100_000;
/// Factors and offsets of the truth are smaller.
const LARGEST: f64 = 100.0;

impl TunnelFile {
    /// The first thing about sizes, names and the truth that cannot be, with what to do about it.
    pub(crate) fn size_fault(&self) -> Option<(String, &'static str)> {
        rows(self).or_else(|| names(self)).or_else(|| runs(self)).or_else(|| truth(self))
    }
}

fn rows(file: &TunnelFile) -> Option<(String, &'static str)> {
    let statics = &file.statics;
    let points = statics.airspeeds_m_s.len().saturating_mul(statics.angles_deg.len());
    let points = points.saturating_add(statics.tilt_deg.len());
    let replicates = statics.blocks.replicates.iter().map(|(_, count)| *count);
    let rows = points.saturating_mul(replicates.fold(0, usize::saturating_add));
    let what = format!("replicates: the static cases have {rows} rows, and {MOST_ROWS} are the most");
    (rows > MOST_ROWS).then_some((what, "measure fewer points, or fewer times"))
}

/// Runs are files of the campaign's folder, each of its own name.
fn names(file: &TunnelFile) -> Option<(String, &'static str)> {
    let mut seen = BTreeSet::from(["static.csv", "campaign.ron", "README.md"]);
    file.runs.iter().map(|run| run.file.as_str()).find_map(|name| {
        let path = Path::new(name);
        let plain = path.file_name().is_some_and(|last| last == name)
            && path.extension().is_some_and(|end| end == "csv");
        if !plain {
            let what = format!("`{name}` is no name of a run's file");
            return Some((what, "a name such as pitch.csv, without a folder"));
        }
        (!seen.insert(name))
            .then(|| (format!("the file {name} would be written twice"), "name each run by itself"))
    })
}

fn runs(file: &TunnelFile) -> Option<(String, &'static str)> {
    let slow = file.runs.iter().find(|run| !maneuver::run::AIRSPEEDS_M_S.contains(&run.v_m_s));
    let slow =
        slow.map(|run| format!("{}: the airspeed {:?} m/s is not within 0 to 340 m/s", run.file, run.v_m_s));
    if let Some(what) = slow {
        return Some((what, "zero is a wind-off run"));
    }
    let actuator = file.dynamics.as_ref()?.actuator?;
    let possible = |value: f64, most: f64| value > 0.0 && value <= most;
    let good = possible(actuator.frequency_hz, 1e4) && possible(actuator.damping_ratio, 10.0);
    (!good).then(|| {
        let what = format!(
            "an actuator of {:?} Hz and a damping ratio of {:?}",
            actuator.frequency_hz, actuator.damping_ratio
        );
        (what, "both are above zero")
    })
}

fn truth(file: &TunnelFile) -> Option<(String, &'static str)> {
    let mut factors = Vec::new();
    let mut shares = Vec::new();
    if let Some(beam) = &file.truth.beam {
        factors.extend([beam.bending, beam.torsion, beam.mass].map(|ends| ("beam", ends)));
        shares.extend([("axis_aft_over_c", beam.axis_aft_over_c), ("mass_aft_over_c", beam.mass_aft_over_c)]);
    }
    let corners = |name, corners: &Corners| [(name, corners.root), (name, corners.tip)];
    if let Some(sections) = &file.truth.sections {
        shares.push(("polar_share", sections.polar_share));
        factors.extend(corners("force_factor", &sections.force_factor));
        for at in &sections.by_airspeed {
            factors.push(("moment_factor", at.moment_factor));
            factors.extend(corners("pressure_offset", &at.pressure_offset));
        }
    }
    let large = factors
        .iter()
        .find(|(_, ends)| [ends.0, ends.1].iter().any(|end| !(-LARGEST..=LARGEST).contains(end)));
    if let Some((name, ends)) = large {
        return Some((
            format!("{name} is {ends:?}, beyond {LARGEST}"),
            "factors are near one, offsets near zero",
        ));
    }
    let far = shares.into_iter().find(|(_, share)| !(-1.0..=1.0).contains(share));
    if let Some((name, share)) = far {
        return Some((format!("{name} is {share:?}, beyond 1"), "it is a share"));
    }
    let damping = file.truth.beam.as_ref().map(|beam| beam.damping_ratio);
    let wrong = damping.filter(|ratio| !(0.0..=0.5).contains(ratio))?;
    Some((format!("damping_ratio is {wrong:?}, expected 0 to 0.5"), "a share of critical"))
}
