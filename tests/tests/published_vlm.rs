//! The vortex lattice beside published and independently computed wings (data/published/vlm__*.json), each at the
//! tolerance its case states; the rows are in `validation::cases::vlm`.

use validation::half_wing::{Planform, lift_slope};
use validation::{check, list, number, published};

#[test]
fn bertin_and_smith_swept_wing() {
    check("vlm__bertin_swept_wing");
}

#[test]
fn bertin_and_smith_swept_wing_to_ten_digits() {
    check("vlm__bertin_swept_wing_own");
}

#[test]
fn warren_12() {
    check("vlm__warren12");
}

#[test]
fn ten_planforms_by_three_meshes_at_two_mach_numbers() {
    check("vlm__vlm_own_tables");
}

/// Each row within the tolerance or at its known deviation; and everywhere lift falls with sweep and rises with
/// aspect ratio, as in the formula.
#[test]
fn helmbold_lowry_polhamus() {
    check("vlm__helmbold_lowry_polhamus");
    let case = published("vlm__helmbold_lowry_polhamus");
    let slope = |row: &serde_json::Value| {
        let (aspect_ratio, sweep) = (number(&row["AR"]), number(&row["sweep_c2_deg"]));
        (aspect_ratio, sweep, lift_slope(Planform::constant_chord(aspect_ratio, sweep), 8, 32))
    };
    let rows: Vec<(f64, f64, f64)> = list(&case["expected"]).iter().map(slope).collect();
    for (a, b) in rows.iter().zip(rows.iter().skip(1)).filter(|(a, b)| a.0 == b.0 && a.0 > 1.0) {
        assert!(b.2 < a.2, "sweep {} carries more than {} at aspect ratio {}", b.1, a.1, a.0);
    }
    for (a, b) in rows.iter().zip(rows.iter().skip(4)) {
        assert!(a.1 == b.1 && b.2 > a.2, "aspect ratio {} carries less than {}", b.0, a.0);
    }
}

/// The case asks for the trend only: a lifting surface carries less than the lifting line, the less so the longer
/// the wing.
#[test]
fn the_lattice_comes_to_the_lifting_line_from_below_as_the_wing_grows() {
    check("vlm__lifting_line_rect");
    let case = published("vlm__lifting_line_rect");
    let gaps: Vec<(f64, f64)> = list(&case["expected"])
        .iter()
        .map(|row| {
            let aspect_ratio = number(&row["AR"]);
            let got = lift_slope(Planform::constant_chord(aspect_ratio, 0.0), 8, 64);
            (aspect_ratio, 1.0 - got / number(&row["CLa"]))
        })
        .collect();
    println!("(aspect ratio, missing part of the lifting line's slope): {gaps:?}");
    assert!(gaps.iter().all(|gap| gap.1 > 0.0), "{gaps:?}");
    assert!(gaps.windows(2).all(|pair| pair[1].1 < pair[0].1), "{gaps:?}");
    assert!(gaps[gaps.len() - 1].1 < 1e-3, "{gaps:?}");
}

#[test]
fn slender_and_long_wings() {
    check("vlm__slender_wing_limit");
}

#[test]
fn avl_simple_wing() {
    check("vlm__avl_simple_wing");
}

#[test]
fn hershey_bar_strips_by_avl() {
    check("vlm__hershey_ar10");
}
