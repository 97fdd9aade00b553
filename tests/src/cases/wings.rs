//! The vortex lattice beside strip slopes of a panel program and beside measured wings (data/published).

use crate::half_wing::{Planform, lift_slope, slopes, strip_places, strips, sum, uniform};
use crate::registry::Case;
use crate::row::Row;
use crate::{list, number, numbers};
use serde_json::Value;

/// The cases of this file.
pub const CASES: &[Case] = &[
    Case { file: "vlm__lamar_AR3", run: lamar },
    Case { file: "vlm__pazy_strip_slopes", run: pazy },
    Case { file: "vlm_measured__weber_brebner_45", run: weber_and_brebner },
];

/// Piecewise linear through the strips' middles, constant beyond.
fn interpolate(x: &[f64], y: &[f64], at: f64) -> f64 {
    let i = x.partition_point(|knot| *knot <= at).clamp(1, x.len() - 1);
    let f = ((at - x[i - 1]) / (x[i] - x[i - 1])).clamp(0.0, 1.0);
    y[i - 1] + f * (y[i] - y[i - 1])
}

fn lamar(case: &Value) -> Vec<Row> {
    let got = lift_slope(Planform::constant_chord(3.0, 0.0), 30, 60);
    let points: Vec<Vec<f64>> = list(&case["expected"]["alpha_deg_CL"]).iter().map(numbers).collect();
    let mean = |i: usize| points.iter().map(|p| p[i]).sum::<f64>() / points.len() as f64;
    let (alpha, lift) = (mean(0), mean(1));
    let moment = |f: &dyn Fn(&Vec<f64>) -> f64| points.iter().map(f).sum::<f64>();
    let slope = moment(&|p| (p[0] - alpha) * (p[1] - lift)) / moment(&|p| (p[0] - alpha).powi(2));
    let independent = number(&case["expected"]["CLalpha_own_vlm_30x60"]);
    vec![
        // as printed by an independent lattice of this mesh
        Row::relative("lift slope of an independent lattice, 30 x 60", got, independent, 1e-3),
        Row::relative("measured lift slope", got, slope.to_degrees(), number(&case["tolerance"]["exp"])),
    ]
}

/// Inboard of 90 % span with the mesh the case names; outboard with 60 strips, so that linear interpolation between
/// strips does not miss the curvature. The last station (98.3 %, inside the outermost strip of any mesh like the
/// source's) is a known deviation: 9 % below the source there, 2.05 to 1.78 from 32 strips on to many beside 2.06.
fn pazy(case: &Value) -> Vec<Row> {
    let semispan = number(&case["inputs"]["semispan_aero"]);
    let chord = number(&case["inputs"]["chord_aero"]);
    let planform = Planform { semispan, root: chord, tip: chord, tip_x: 0.0 };
    let solved = |nspan, nchord| {
        let lattice = planform.lattice(&uniform(nspan), &uniform(nchord));
        let (lift, _, cp) = slopes(planform, &lattice, 0.0);
        (strip_places(&lattice), strips(&lattice, &cp), lift)
    };
    let (coarse, fine) = (solved(40, 8), solved(60, 18));
    let total = number(&case["expected"]["CLalpha_total_own"]);
    let mut rows = vec![Row::relative("total lift slope, 8 x 40", coarse.2, total, 1e-3)];
    for row in list(&case["expected"]["rows"]).iter().map(numbers).filter(|row| row[1] > 0.0) {
        let eta = row[0] / semispan;
        let (mesh, name, rel) = if eta < 0.9 { (&coarse, "8 x 40", 0.008) } else { (&fine, "18 x 60", 0.02) };
        let got = interpolate(&mesh.0, &mesh.1, row[0]);
        let strip = Row::relative(format!("strip slope at {eta:.4} of the span, {name}"), got, row[1], rel);
        let reason = "inside the outermost strip of the source's mesh, which is not known";
        rows.push(if eta < 0.98 { strip } else { strip.known(-0.10 * row[1], -0.09 * row[1], reason) });
    }
    rows
}

/// Lift: the case's band (measured to 0.003, a lattice 0 to 4 % higher) holds from 4.2 to 8.4 deg. Two known
/// deviations: at 2.1 deg ours is 0.0032 low (half a printed unit of the measured CL is 0.0005), and at 10.5 deg the
/// measured lift has left the straight line (0.103 in the last step, 0.121 in the first).
///
/// Strips: the case's 0.01 holds at half of the stations. At the others the deviation is known: the measured wing is
/// 12 % thick, and thickness moves lift of a swept wing towards the middle (ours is low inboard, high from 0.5 to 0.7);
/// the measured strips integrate to 2.7 % less than the measured lift; and outside 90 % the tip's vortex, which a flat
/// lattice has not, adds lift.
fn weber_and_brebner(case: &Value) -> Vec<Row> {
    let (span, chord) = (number(&case["inputs"]["b_m"]), number(&case["inputs"]["c_m"]));
    let planform = Planform { semispan: span / 2.0, root: chord, tip: chord, tip_x: span / 2.0 };
    let lattice = planform.lattice(&uniform(60), &uniform(12));
    let cp = slopes(planform, &lattice, number(&case["inputs"]["mach"])).2;
    let slope = sum(&lattice, &cp, |_| 1.0) / planform.area();
    let expected = &case["expected"];
    let mut rows = Vec::new();
    // angle in deg, least and largest deviation of CL
    let known = [
        (2.1, -0.0034, -0.0030, "half a printed unit is 0.0005"),
        (10.5, 0.029, 0.031, "the measured lift bends away, a straight lattice cannot"),
    ];
    for (alpha, want) in numbers(&expected["alpha_deg"]).iter().zip(numbers(&expected["CL"])) {
        let got = slope * alpha.to_radians();
        let row = Row::band(format!("CL at {alpha} deg"), got, want, -0.003, 0.04 * want + 0.003);
        rows.push(match known.iter().find(|(angle, ..)| angle == alpha) {
            None => row,
            Some((_, low, high, reason)) => row.known(*low, *high, *reason),
        });
    }
    let centre = sum(&lattice, &cp, |panel| panel.mid_point().y) / sum(&lattice, &cp, |_| planform.semispan);
    let measured = number(&expected["derived_root_loads"]["eta_cp"]);
    rows.push(Row::absolute("centre of lift over the semispan", centre, measured, 0.008));
    let (places, cl) = (strip_places(&lattice), strips(&lattice, &cp));
    // station, least and largest deviation
    let thick = "12 % thick; the measured strips' own sum";
    let known = [
        (0.041, -0.012, -0.010, thick),
        (0.082, -0.013, -0.010, thick),
        (0.51, 0.010, 0.013, thick),
        (0.653, 0.010, 0.013, thick),
        (0.949, -0.033, -0.028, "the tip's vortex"),
    ];
    for (eta, want) in numbers(&expected["two_y_over_b"]).iter().zip(numbers(&expected["cl_at_4p2deg"])) {
        let got = interpolate(&places, &cl, eta * planform.semispan) * 4.2_f64.to_radians();
        let row = Row::absolute(format!("strip cl at 4.2 deg, {eta} of the semispan"), got, want, 0.01);
        rows.push(match known.iter().find(|(station, ..)| station == eta) {
            None => row,
            Some((_, low, high, reason)) => row.known(*low, *high, *reason),
        });
    }
    rows
}
