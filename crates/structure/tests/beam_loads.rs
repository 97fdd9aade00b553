//! PLOAD1 against closed forms of one beam, with the displacements of its grids and the reactions.

use nastran::{BulkData, parse_deck};
use structure::nonlinear::{LargeDeflection, Loads};
use structure::{Flexibility, Model, System, loads_of};

/// A bar of length 2 along x, E I1 = 100 (bending along z), E I2 = 50, G J = 30, no shear flexibility; end B free unless more is held.
const BAR: &str = "MAT1,1,1.+3,5.+2,\nPBAR,1,1,1.,.1,.05,.06\nGRID,1,,0.,0.,0.\nGRID,2,,2.,0.,0.\nCBAR,7,1,1,2,0.,0.,1.\nSPC1,1,123456,1\n";
const LENGTH: f64 = 2.0;
const EI: f64 = 100.0;

fn deck(cards: &str) -> BulkData {
    parse_deck("test.bdf", cards).expect("a deck")
}

/// Displacements and rotations of a grid (by position) under load set 5.
fn moved(cards: &str, node: usize) -> [f64; 6] {
    let bulk = deck(cards);
    let system = System::assemble(&Model::from_bulk(&bulk).expect("a model")).expect("a system");
    let forces = system.forces_of(&loads_of(&bulk, 5).expect("loads"));
    let flexibility = Flexibility::new(&system).expect("held");
    let moved = system.expand(flexibility.displacements(system.reduce(forces.as_ref()).as_ref()).as_ref());
    [0, 1, 2, 3, 4, 5].map(|i| moved[(6 * node + i, 0)])
}

fn on_bar(cards: &str) -> [f64; 6] {
    moved(&format!("{BAR}{cards}"), 1)
}

#[track_caller]
fn near(own: f64, expected: f64, what: &str) {
    assert!((own - expected).abs() < 1e-9 * expected.abs().max(1e-3), "{what}: {own} for {expected}");
}

#[test]
fn a_cantilever_bends_under_loads_along_it_as_beam_theory_says() {
    let (l, w) = (LENGTH, 3.0);
    // Uniform: w L^4/8 E I, w L^3/6 E I, nose down about y.
    for scale in ["LE,0.,3.,2.,3.", "FR,0.,3.,1.,3.", "FR,0.,3.,1."] {
        let tip = on_bar(&format!("PLOAD1,5,7,FZ,{scale}\n"));
        near(tip[2], w * l.powi(4) / (8.0 * EI), scale);
        near(tip[4], -w * l.powi(3) / (6.0 * EI), scale);
    }
    // Falling to nothing at the tip: w L^4/30 E I; growing to it: 11 w L^4/120 E I.
    near(on_bar("PLOAD1,5,7,FZ,FR,0.,3.,1.,0.\n")[2], w * l.powi(4) / (30.0 * EI), "falling");
    near(on_bar("PLOAD1,5,7,FZ,FR,0.,0.,1.,3.\n")[2], 11.0 * w * l.powi(4) / (120.0 * EI), "growing");
    // A force at a: P a^2 (3 L - a)/6 E I, and a moment there about y: M a (2 L - a)/2 E I.
    let a = 0.5;
    near(on_bar("PLOAD1,5,7,FZ,LE,.5,3.\n")[2], 3.0 * a * a * (3.0 * l - a) / (6.0 * EI), "a force at .5");
    near(
        on_bar("PLOAD1,5,7,MYE,FR,.25,3.\n")[5],
        3.0 * a / 50.0,
        "element z is basic -y or y: a moment in the other plane",
    );
    // On the outer half only: the whole less the inner half, w a^3 (4 L - a)/24 E I with a = 1.
    let half = w * l.powi(4) / (8.0 * EI) - w * (4.0 * l - 1.0) / (24.0 * EI);
    near(on_bar("PLOAD1,5,7,FZ,FR,.5,3.,1.,3.\n")[2], half, "the outer half");
    // Along and about the bar: p L^2/2 E A, m L^2/2 G J.
    near(on_bar("PLOAD1,5,7,FX,FR,0.,3.,1.,3.\n")[0], w * l * l / (2.0 * 1e3), "along");
    near(on_bar("PLOAD1,5,7,MX,FR,0.,3.,1.,3.\n")[3], w * l * l / (2.0 * 30.0), "about");
}

#[test]
fn what_is_held_at_both_ends_feels_the_moments_of_handbooks() {
    // Two bars of 2 make one of 4: the middle rises by w L^4/384 E I.
    let cards = "MAT1,1,1.+3,5.+2,\nPBAR,1,1,1.,.1,.05,.06\nGRID,1,,0.,0.,0.\nGRID,2,,2.,0.,0.\nGRID,3,,4.,0.,0.\n\
        CBAR,7,1,1,2,0.,0.,1.\nCBAR,8,1,2,3,0.,0.,1.\nSPC1,1,123456,1,3\n";
    let both = "PLOAD1,5,7,FZ,FR,0.,3.,1.\nPLOAD1,5,8,FZ,FR,0.,3.,1.\n";
    near(
        moved(&format!("{cards}{both}"), 1)[2],
        3.0 * 4.0_f64.powi(4) / (384.0 * EI),
        "clamped at both ends",
    );
    // Pinned at both outer ends: 5 w L^4/384 E I.
    let pinned = cards
        .replace("CBAR,7,1,1,2,0.,0.,1.", "CBAR,7,1,1,2,0.,0.,1.\n,56")
        .replace("CBAR,8,1,2,3,0.,0.,1.", "CBAR,8,1,2,3,0.,0.,1.\n,,56");
    near(
        moved(&format!("{pinned}{both}"), 1)[2],
        5.0 * 3.0 * 4.0_f64.powi(4) / (384.0 * EI),
        "pinned at both ends",
    );
}

#[test]
fn taper_shear_and_offsets_are_in_the_loads_as_they_are_in_the_stiffness() {
    let beam = |cards: &str| {
        format!(
            "MAT1,1,1.+3,5.+2,\nPBEAM,1,1,1.,.1,.05,,.06\n,,,,,,,,\n,YES,1.,.5,.03,.02,,.02\n,,,,,,,,\n,.8,.8\nGRID,1,,0.,0.,0.\n{cards}"
        )
    };
    // One element, and the same cut into four: displacements of the end are those of exact beams both.
    let whole =
        beam("GRID,2,,2.,0.,0.\nCBEAM,7,1,1,2,0.,0.,1.\nSPC1,1,123456,1\nPLOAD1,5,7,FZ,FR,.25,1.,.75,4.\n");
    let tip = moved(&whole, 1);
    // By quadrature of M(x) (L - x)/E I(x) + V(x)/k A(x) G, an independent sum.
    let (mut bending, mut shear, cells) = (0.0, 0.0, 40_000);
    for at in 0..cells {
        let x = (f64::from(at) + 0.5) * LENGTH / f64::from(cells);
        let share = x / LENGTH;
        let (i, area) = (0.1 - 0.07 * share, 1.0 - 0.5 * share);
        // Loads beyond x: from .5 to 1.5 m, 1 + 3 (s - .5).
        let from = x.clamp(0.5, 1.5);
        let sum = |f: &dyn Fn(f64) -> f64| f(1.5) - f(from);
        let force = sum(&|s| s + 1.5 * (s - 0.5).powi(2));
        let moment = sum(&|s| 0.5 * s * s + (s - 0.5).powi(3) + 0.75 * (s - 0.5).powi(2)) - x * force;
        bending += moment * (LENGTH - x) / (1e3 * i) * LENGTH / f64::from(cells);
        shear += force / (0.8 * area * 5e2) * LENGTH / f64::from(cells);
    }
    assert!((tip[2] / (bending + shear) - 1.0).abs() < 1e-6, "{} for {}", tip[2], bending + shear);
    // Offset by .3 along y the same load twists by its arm as well.
    let offset =
        format!("{BAR}PLOAD1,5,7,FZ,FR,0.,3.,1.\n").replace("0.,0.,1.\n", "0.,0.,1.\n,,,0.,.3,0.,0.,.3,0.\n");
    let (l, w) = (LENGTH, 3.0);
    let tip = moved(&offset, 1);
    near(tip[3], 0.0, "the bar itself is not twisted by a load on its own axis");
    near(tip[2], w * l.powi(4) / (8.0 * EI), "nor bent otherwise");
}

#[test]
fn a_slanted_beam_takes_loads_by_its_length_or_by_what_is_seen_of_it() {
    // 3-4-5: along x and z.
    let cards = |scale: &str| {
        format!(
            "MAT1,1,1.+3,5.+2,\nPBAR,1,1,1.,.1,.1,.06\nGRID,1,,0.,0.,0.\nGRID,2,,4.,0.,3.\nCBAR,7,1,1,2,0.,1.,0.\nSPC1,1,123456,1\nPLOAD1,5,7,FZ,{scale}\n"
        )
    };
    let force = |scale: &str| -> f64 {
        let bulk = deck(&cards(scale));
        let system = System::assemble(&Model::from_bulk(&bulk).expect("a model")).expect("a system");
        let forces = system.forces_of(&loads_of(&bulk, 5).expect("loads"));
        forces[(2, 0)] + forces[(8, 0)]
    };
    near(force("FR,0.,2.,1."), 10.0, "2 a length of 5");
    near(force("FRPR,0.,2.,1."), 8.0, "2 a seen length of 4");
    near(force("LEPR,0.,2.,5."), 8.0, "the same by length");
}

#[test]
fn at_large_deflections_it_keeps_its_direction() {
    // A cantilever of 16 bars under w L^3/E I = 4.
    use std::fmt::Write as _;
    let mut cards = String::from("MAT1,1,1.+6,,0.\nPBAR,1,1,1.,1.-6,1.-6,2.-6\nSPC1,1,123456,1\n");
    for grid in 1..=17 {
        let _ = writeln!(cards, "GRID,{grid},,{:.6},0.,0.", f64::from(grid - 1) / 16.0);
    }
    for bar in 1..=16 {
        let _ = writeln!(cards, "CBAR,{bar},1,{bar},{},0.,0.,1.\nPLOAD1,5,{bar},FZ,FR,0.,4.,1.", bar + 1);
    }
    let bulk = deck(&cards);
    let wing = LargeDeflection::new(&Model::from_bulk(&bulk).expect("a model")).expect("turns");
    let loads: Loads = loads_of(&bulk, 5).expect("loads");
    assert!(loads.following.is_empty(), "it does not follow");
    let end = wing.under(&loads).expect("carried").end().state.clone();
    let (rise, wanted) = (end.places[16].z, elastica_under_its_weight(4.0));
    assert!((rise / wanted - 1.0).abs() < 2e-3, "rises by {rise} for {wanted}");
    near(moved(&cards, 16)[2], 0.5, "small deflections");
}

/// Rise of the tip of an inextensible cantilever of length and E I one under a uniform dead load: E I theta'' = -w (1 - s) cos theta,
/// theta(0) = 0, theta'(1) = 0, by shooting with Runge and Kutta's rule.
fn elastica_under_its_weight(w: f64) -> f64 {
    let shoot = |slope: f64| -> [f64; 3] {
        let steps = 2000;
        let h = 1.0 / f64::from(steps);
        let rate = |s: f64, [theta, bend, _]: [f64; 3]| [bend, -w * (1.0 - s) * theta.cos(), theta.sin()];
        let mut y = [0.0, slope, 0.0];
        for step in 0..steps {
            let s = f64::from(step) * h;
            let ahead = |k: [f64; 3], by: f64| [0, 1, 2].map(|i| y[i] + by * k[i]);
            let a = rate(s, y);
            let b = rate(s + 0.5 * h, ahead(a, 0.5 * h));
            let c = rate(s + 0.5 * h, ahead(b, 0.5 * h));
            let d = rate(s + h, ahead(c, h));
            y = [0, 1, 2].map(|i| y[i] + h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]));
        }
        y
    };
    let (mut low, mut high) = (0.0, w);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if shoot(middle)[1] > 0.0 { high = middle } else { low = middle }
    }
    shoot(low)[2]
}

#[test]
fn what_is_no_load_of_a_beam_is_refused() {
    let said = |cards: &str| {
        let text = format!("{BAR}{cards}");
        match parse_deck("test.bdf", &text) {
            Err(error) => error.to_string(),
            Ok(bulk) => loads_of(&bulk, 5).expect_err("refused").to_string(),
        }
    };
    for (cards, word) in [
        ("PLOAD1,5,9,FZ,FR,0.,3.,1.\n", "CBAR or CBEAM 9"),
        ("PLOAD1,5,7,FZ,LE,0.,3.,2.5\n", "beyond element 7"),
        ("PLOAD1,5,7,FW,LE,0.,3.,2.\n", "FX to MZ"),
        ("PLOAD1,5,7,FZ,XX,0.,3.,2.\n", "LE, FR, LEPR"),
        ("PLOAD1,5,7,FZ,FR,.5,3.,.2\n", "runs from"),
        ("PLOAD1,5,7,MZ,FRPR,0.,3.,1.\n", "projected"),
    ] {
        assert!(said(cards).contains(word), "{cards}: {}", said(cards));
    }
}

#[test]
fn a_load_along_an_axis_of_its_beam_is_not_projected() {
    // Only loads along basic axes act on the projected length (Strand7 on reading Nastran's PLOAD1).
    let loads = |scale: &str| {
        loads_of(&deck(&format!("{BAR}PLOAD1,5,7,FXE,{scale},0.,3.,1.,5.\n")), 5)
            .expect("a load along the bar")
    };
    assert_eq!(loads("FRPR"), loads("FR"));
    assert_eq!(loads("LEPR"), loads("LE"));
    assert!(loads("FR").dead.iter().any(|load| load.force.norm() > 1.0));
}
