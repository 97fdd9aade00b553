//! The README of a campaign: that it holds no measurements, how it was made, and what of the paper's findings it
//! has, in numbers.

use crate::comparison::{AirspeedComparison, FlightState};
use crate::file::TunnelFile;
use crate::run_file::RunPlan;
use calibrate::Use;
use std::fmt::Write as _;

/// What calibration found at one airspeed. Corners are root leading, root trailing, tip leading, tip trailing.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// Airspeed, m/s.
    pub v_m_s: f64,
    /// Paper 1, Eq. 8 before and after.
    pub objective: [f64; 2],
    /// Paper 1, Eq. 8 of straight lines.
    pub line_floor: f64,
    /// Cone programs.
    pub cone_programs: usize,
    /// How it ended.
    pub ending: String,
    /// Paper 1, Eq. 8 at angles left out: before, after, and about their own line.
    pub left_out: Option<[f64; 3]>,
    /// Smallest probability of the three tests for nonlinearity.
    pub least_p: f64,
    /// Force factors at the corners.
    pub force: [f64; 4],
    /// Moment factors at the corners.
    pub moment: [f64; 4],
    /// Pressure offsets at the corners.
    pub offset: [f64; 4],
}

/// What the README tells.
#[derive(Debug)]
pub struct Story<'a> {
    /// The tunnel's file.
    pub tunnel: &'a TunnelFile,
    /// Its name as shown.
    pub file_name: String,
    /// Seed of this campaign.
    pub seed: u64,
    /// Whether the truth bends far; the model beside it does not.
    pub is_bent: bool,
    /// Truth against uncorrected model.
    pub comparison: &'a [AirspeedComparison],
    /// What calibration finds.
    pub found: &'a [Found],
    /// Trim at 1 g, pull-up at 4 g, push-down at -2 g: uncorrected, corrected.
    pub flight: [[FlightState; 2]; 3],
}

/// The README's text.
pub fn readme(story: &Story<'_>) -> String {
    let mut text = format!(
        "# {}\n\n## Source\n\nTHESE ARE NOT MEASUREMENTS. The measurements of the wing in the paper are not public. What is here was\n\
         computed by the virtual wind tunnel of this repository (`wingroot tunnel --runs {}`, seed {}): a model that\n\
         differs from the one being calibrated in its lattice, its structure and its section aerodynamics, with noise,\n\
         block offsets and, at V = 0, weight tares. Nothing that analyses these data may read that file.\n\n",
        story.tunnel.name, story.file_name, story.seed
    );
    text.push_str(if story.tunnel.curvature {
        "The sections follow the curvature of their viscous polars, so no straight line in the angle of attack fits:\n\
         these data are for showing that lack of fit is reported and not fitted away.\n\n"
    } else {
        "The sections follow straight lines through their viscous polars; curvature is left out here.\n\n"
    });
    if story.is_bent {
        text.push_str(
            "The static cases are those of the wing that bends far (`geometry: Nonlinear`). The model beside them below, what\n\
             `calibrate` finds and the half wing in flight have small deflections.\n\n",
        );
    }
    text.push_str(
        "The truth's numbers were chosen by trial until calibration and flight came out near what the paper prints. So the\n\
         agreement below was put in; it confirms neither the paper nor this program. What does not agree is left to be seen.\n\n",
    );
    text.push_str(
        "Columns and conventions are those of any campaign; `campaign.ron` declares the noise, which is the true one.\n\
         All tables below are printed by the command that made the data.\n\n",
    );
    runs(&mut text, story.tunnel);
    static_tables(&mut text, story);
    calibration_tables(&mut text, story);
    flight_table(&mut text, story);
    text
}

/// What was flown, and which runs are held out.
fn runs(text: &mut String, tunnel: &TunnelFile) {
    if tunnel.runs.is_empty() {
        return;
    }
    text.push_str(
        "## Runs\n\nFile names give motion, control, degrees or Hz, and airspeed. The wing in them has things no model \
         here has, as\nthe one in the paper's tunnel had. The measured angle has noise, deflections are as commanded, and \
         runs in the wind have\nthe offset of their day (`block`).\n\n| | train | held out |\n|---|---|---|\n",
    );
    let kind = |run: &RunPlan| match run.motion.kind().words() {
        words if run.motion.control().is_some() => format!("{words}s"),
        words if run.v_m_s > 0.0 => words.to_owned(),
        words => format!("{words} without wind"),
    };
    let mut kinds: Vec<String> = Vec::new();
    kinds.extend(tunnel.runs.iter().map(kind));
    let mut seen = std::collections::BTreeSet::new();
    kinds.retain(|name| seen.insert(name.clone()));
    for name in kinds {
        let count =
            |usage| tunnel.runs.iter().filter(|run| kind(run) == name && run.purpose == usage).count();
        let _ = writeln!(text, "| {name} | {} | {} |", count(Use::Train), count(Use::Holdout));
    }
    text.push('\n');
    if let Some(split) = &tunnel.split {
        let _ = writeln!(text, "{}\n", wrapped(split, 118));
    }
}

/// A paragraph in lines of limited length.
fn wrapped(words: &str, width: usize) -> String {
    let mut lines: Vec<String> = Vec::new();
    for word in words.split_whitespace() {
        match lines.last_mut() {
            Some(line) if line.len() + 1 + word.len() <= width => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines.join("\n")
}

/// The uncorrected model beside the truth (the paper's Figure 8).
fn static_tables(text: &mut String, story: &Story<'_>) {
    text.push_str(
        "## The uncorrected model beside the truth, without noise\n\nOffset at alpha = 0, slope per degree: truth / \
         model. Error: root mean square over the angles, as a share of the load's.\n\n\
         | V m/s | Fz N | slope | error | Mx N m | slope | error | My N m | slope | error |\n\
         |---|---|---|---|---|---|---|---|---|---|\n",
    );
    for row in story.comparison {
        let _ = write!(text, "| {:.0} |", row.v_m_s);
        for c in &row.channels {
            let ([a, b], [s, t]) = (c.offset, c.slope_per_deg);
            let _ = write!(text, " {a:.1} / {b:.1} | {s:.2} / {t:.2} | {:.0} % |", 100.0 * c.relative_error);
        }
        text.push('\n');
    }
    text.push_str(
        "\nThe paper, in words: slopes of Fz and Mx close at all airspeeds, a large offset of both at 18 and 22 m/s, Fz\n\
         and Mx good and My not at 30 to 40 m/s. Here the offset of Fz is large at 18 and 22 m/s and smaller above, and\n\
         the slope of Mx is lower than the model's at every airspeed: without that the wing in flight would not bend\n\
         less, which the paper also reports. So Mx at 30 to 40 m/s is less good here than there, and not only My is off.\n\n",
    );
}

/// What calibration makes of it (the paper's Figure 7).
fn calibration_tables(text: &mut String, story: &Story<'_>) {
    text.push_str(
        "## What `calibrate` finds\n\nObjective of Eq. 8 before and after, the straight-line floor, and at every second \
         angle left out of a fit.\n\n\
         | V m/s | before | after | line | programs | ending | left out: before | after | own line | least p of nonlinearity |\n\
         |---|---|---|---|---|---|---|---|---|---|\n",
    );
    for f in story.found {
        let left = f.left_out.map_or_else(
            || "- | - | -".to_owned(),
            |[before, after, line]| format!("{before:.2} | {after:.3} | {line:.3}"),
        );
        let _ = writeln!(
            text,
            "| {:.0} | {:.2} | {:.3} | {:.3} | {} | {} | {left} | {:.0e} |",
            f.v_m_s, f.objective[0], f.objective[1], f.line_floor, f.cone_programs, f.ending, f.least_p
        );
    }
    text.push_str(
        "\nCorrections at root leading edge, root trailing edge, tip leading edge, tip trailing edge. Six numbers an\n\
         airspeed are measured, so these are the smallest change that explains them, not the truth's own.\n\n\
         | V m/s | force factor | moment factor | pressure offset |\n|---|---|---|---|\n",
    );
    let list = |v: &[f64; 4]| v.map(|x| format!("{x:.2}")).join(", ");
    for f in story.found {
        let _ = writeln!(
            text,
            "| {:.0} | {} | {} | {} |",
            f.v_m_s,
            list(&f.force),
            list(&f.moment),
            list(&f.offset)
        );
    }
    text.push_str(
        "| paper | 1.2-1.3, 1, .35-.5, .35-.5 | 18: .7 to .2, 22: .7 to .45, from 30: 1 | 18: .6, .25, .15, -.2; 40: 0 |\n\n",
    );
}

/// What the corrections do in flight (the paper's sections 5.2 and 5.3).
fn flight_table(text: &mut String, story: &Story<'_>) {
    text.push_str(
        "## The corrections of 40 m/s in flight\n\nThe half wing alone carries 10 kg (no tail, no fuselage, no \
         rotation); `wingroot fullaircraft` flies the whole aircraft.\n\n| | uncorrected | corrected | ratio or change | paper |\n|---|---|---|---|---|\n",
    );
    let [trim, up, down] = story.flight;
    let _ = writeln!(
        text,
        "| trim angle at 25.7 m/s | {:.2} deg | {:.2} deg | {:+.2} deg | 2.28 to 1.87 deg, -0.41 |",
        trim[0].alpha_deg,
        trim[1].alpha_deg,
        trim[1].alpha_deg - trim[0].alpha_deg
    );
    for (what, states, paper) in
        [("tip at 4 g, 37 m/s", up, ".6 to .43 m, 0.72"), ("tip at -2 g, 42 m/s", down, "-.3 to -.2 m, 0.67")]
    {
        let [a, b] = states.map(|state| state.tip_z_m);
        let _ = writeln!(text, "| {what} | {a:.3} m | {b:.3} m | {:.2} | {paper} |", b / a);
    }
    text.push('\n');
}
