//! How a fit goes on and ends, and what a model says beside measurements, with numbers worked out by hand.

use nastran::parse_deck;
use std::f64::consts::TAU;
use structure::Model;
use structure::update::{
    MeasuredDeflection, MeasuredMode, Measurements, Parameter, Prediction, Quantity, Settings, evaluate, fit,
    modal_assurance,
};

/// Masses of 2, 3 and 5 kg, each on a spring of its own of 50, 300 and 2000 N/m along z.
fn three() -> Model {
    let deck = "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,2.,0.,0.\nSPC1,1,12456,1,2,3\nCELAS2,1,50.,1,3\n\
        CELAS2,2,300.,2,3\n\
        CELAS2,3,2000.,3,3\nCONM2,11,1,,2.\nCONM2,12,2,,3.\nCONM2,13,3,,5.\n";
    Model::from_bulk(&parse_deck("test.bdf", deck).expect("a deck")).expect("a model")
}

/// Frequencies of the three, Hz.
fn hertz() -> [f64; 3] {
    [5.0, 10.0, 20.0].map(|omega| omega / TAU)
}

fn of(model: &Model, quantity: Quantity, ids: &[u32]) -> Parameter {
    let elements =
        model.elements().enumerate().filter(|(_, e)| ids.contains(&e.id())).map(|(at, _)| at).collect();
    Parameter { region: format!("{ids:?}"), quantity, elements }
}

fn mode(frequency_hz: f64, sigma_hz: f64, mode: usize) -> MeasuredMode {
    MeasuredMode { name: format!("mode {mode}"), frequency_hz, sigma_hz, shape: Vec::new(), mode: Some(mode) }
}

fn pull(grid: usize, newton: f64, motion: usize, value: f64, sigma: f64) -> MeasuredDeflection {
    let (name, loads) = ("pull".to_owned(), vec![(6 * (grid - 1) + 2, newton)]);
    MeasuredDeflection { name, loads, motion, value, sigma }
}

#[test]
fn predictions_and_their_slopes_are_those_of_springs_and_masses() {
    let model = three();
    let parameters = [
        of(&model, Quantity::Stiffness, &[1]),
        of(&model, Quantity::Mass, &[12]),
        of(&model, Quantity::Stiffness, &[2, 3]),
    ];
    let measurements = Measurements {
        modes: vec![mode(0.9, 0.01, 0), mode(2.0, 0.02, 2), mode(1.5, 0.05, 1)],
        deflections: vec![
            pull(2, 6.0, 8, 0.03, 1e-3),
            pull(2, 6.0, 2, 0.03, 1e-3),
            pull(3, 1.0, 14, 0.001, 2e-3),
        ],
        mass_kg: Some((10.5, 0.1)),
    };
    let state = evaluate(&model, &parameters, &[1.21, 2.0, 0.81], &measurements, &Settings::default())
        .expect("sound");
    let [one, two, three] = hertz();
    // Stiffness by 1.21; mass by two and stiffness by 0.81; stiffness by 0.81.
    let frequencies = [1.1 * one, 0.9 * two / 2.0_f64.sqrt(), 0.9 * three];
    for (own, expected) in state.frequencies_hz.iter().zip(frequencies) {
        assert!((own / expected - 1.0).abs() < 1e-9, "{own} {expected}");
    }
    assert_eq!(state.frequencies_hz.len(), 3, "as many as there are");
    assert_eq!(state.pairs, [Some(0), Some(2), Some(1)]);
    assert!(state.assurance.iter().all(Vec::is_empty));
    let [a, b, c] = frequencies;
    let flexible = 6.0 / (0.81 * 300.0);
    let expected: [(f64, [f64; 3], &str); 7] = [
        (a, [0.5 * a / 1.21 / 0.01, 0.0, 0.0], "Hz"),
        (c, [0.0, 0.0, 0.5 * c / 0.81 / 0.02], "Hz"),
        (b, [0.0, -0.5 * b / 2.0 / 0.05, 0.5 * b / 0.81 / 0.05], "Hz"),
        (flexible, [0.0, 0.0, -flexible / 0.81 / 1e-3], "m"),
        (0.0, [0.0; 3], "m"),
        (1.0 / 1620.0, [0.0, 0.0, -1.0 / 1620.0 / 0.81 / 2e-3], "m"),
        (2.0 + 6.0 + 5.0, [0.0, 3.0 / 0.1, 0.0], "kg"),
    ];
    for ((own, slopes), (value, expected, unit)) in
        state.predictions.iter().zip(&state.sensitivities).zip(&expected)
    {
        assert_eq!(own.unit, *unit);
        let model = own.model.expect("predicted");
        assert!((model - value).abs() < 1e-8 * (1.0 + value), "{}: {model} for {value}", own.name);
        for (own, expected) in slopes.iter().zip(expected) {
            assert!((own - expected).abs() < 1e-6 * (1.0 + expected.abs()), "{own} for {expected}");
        }
        let residual = (own.measured - model) / own.sigma;
        assert!((own.residual().expect("predicted") - residual).abs() < 1e-12);
    }
    assert_eq!((state.compared(), state.predictions.len()), (7, 7));
    let squares: f64 = state.predictions.iter().filter_map(Prediction::residual).map(|r| r * r).sum();
    assert!((state.chi_square() - squares).abs() < 1e-12 * squares && squares > 1.0);
}

#[test]
fn rotations_are_measured_in_radians_and_displacements_in_metres() {
    let deck = "GRID,1\nCELAS2,1,4.,1,3\nCELAS2,2,8.,1,4\nCELAS2,3,16.,1,6\nSPC1,1,125,1\n";
    let model = Model::from_bulk(&parse_deck("test.bdf", deck).expect("a deck")).expect("a model");
    let turn = |motion: usize| MeasuredDeflection {
        loads: vec![(motion, 2.0), (motion, 1.0)],
        ..pull(1, 0.0, motion, 0.5, 0.1)
    };
    let measurements = Measurements { deflections: [2, 3, 5].map(turn).into(), ..Measurements::default() };
    let state = evaluate(&model, &[], &[], &measurements, &Settings::default()).expect("sound");
    for (own, (unit, value)) in state.predictions.iter().zip([("m", 0.75), ("rad", 0.375), ("rad", 0.1875)]) {
        assert_eq!(own.unit, unit);
        assert!((own.model.expect("predicted") - value).abs() < 1e-12);
    }
}

/// Modes with shapes are looked for among twice as many and four more, others among those that they name.
#[test]
fn as_many_modes_are_computed_as_may_be_asked_for() {
    let mut deck = String::new();
    for at in 1..=20_u32 {
        let (spring, mass) = (f64::from(at * at) + 0.5, 100 + at);
        deck = format!("{deck}GRID,{at},,{at}.,0.,0.\nCELAS2,{at},{spring},{at},3\nCONM2,{mass},{at},,1.\n");
    }
    deck += "SPC1,1,12456,1,THRU,20\n";
    let model = Model::from_bulk(&parse_deck("test.bdf", &deck).expect("a deck")).expect("a model");
    let count = |modes: Vec<MeasuredMode>| {
        let measurements = Measurements { modes, ..Measurements::default() };
        evaluate(&model, &[], &[], &measurements, &Settings::default()).expect("sound")
    };
    assert_eq!(count(vec![mode(1.0, 0.1, 0)]).frequencies_hz.len(), 6);
    assert_eq!(count(vec![mode(1.0, 0.1, 0), mode(1.0, 0.1, 1), mode(1.0, 0.1, 2)]).frequencies_hz.len(), 10);
    assert_eq!(count(vec![mode(1.0, 0.1, 0), mode(1.0, 0.1, 14)]).frequencies_hz.len(), 15);
    let all = count(vec![mode(1.0, 0.1, 40)]);
    assert_eq!((all.frequencies_hz.len(), all.pairs[0], all.compared()), (20, None, 0));
    assert!(all.predictions[0].model.is_none() && all.predictions[0].residual().is_none());
    assert_eq!(all.chi_square(), 0.0);
    // A shape that moves the third and the fifth grid alone is the mode of the one that moves more.
    let shaped = |third: f64, fifth: f64| {
        let at = |node: usize| {
            if node == 2 {
                third
            } else if node == 4 {
                fifth
            } else {
                0.0
            }
        };
        let shape = (0..20).map(|node| (6 * node + 2, at(node))).collect();
        MeasuredMode { shape, mode: None, ..mode(1.0, 0.1, 0) }
    };
    let found = count(vec![shaped(1.0, 3.0), shaped(2.0, 0.1)]);
    assert_eq!(found.pairs, [Some(4), Some(2)]);
    assert!((found.assurance[0][4] - 0.9).abs() < 1e-9 && (found.assurance[0][2] - 0.1).abs() < 1e-9);
    assert!((modal_assurance(&[1.0, 3.0], &[0.0, 2.0]) - 0.9).abs() < 1e-15);
    // Neither agrees by more than a half: with a limit of 0.6 it is no mode's.
    assert_eq!(count(vec![shaped(1.0, 1.0)]).pairs, [None]);
}

/// 2 kg on springs of 50 N/m along x (5 rad/s) and 200 N/m along z (10 rad/s), and 1 kg m^2 on 125 Nm/rad about y (11.2 rad/s), 4 m from a
/// clamped grid. A spring of stiffness e between x and z lets the mode along x move z by e / (200 - 50), one between x and the
/// rotation by e / (125 - 25); in one place every motion has the shape that was measured.
#[test]
fn a_mode_that_leaves_the_measured_places_still_is_not_paired_by_its_rounding() {
    let found = |component: u32, coupling: &str, motion: usize| {
        let deck = format!(
            "GRID,1\nGRID,2,,4.,0.,0.\nSPC1,1,123456,2\nSPC1,1,246,1\nCELAS2,1,50.,1,1\nCELAS2,2,200.,1,3\nCELAS2,3,125.,1,5\n\
             CELAS2,4,{coupling},1,1,1,{component}\nCONM2,9,1,,2.\n,0.,0.,1.\n"
        );
        let model = Model::from_bulk(&parse_deck("test.bdf", &deck).expect("a deck")).expect("a model");
        let shaped = MeasuredMode { shape: vec![(motion, 0.3)], mode: None, ..mode(1.0, 0.1, 0) };
        let measurements = Measurements { modes: vec![shaped], ..Measurements::default() };
        evaluate(&model, &[], &[], &measurements, &Settings::default()).expect("sound")
    };
    // Shares of 6.7e-8 and 6.7e-6.
    let still = found(3, "1.-5", 2);
    assert_eq!((still.pairs[0], still.assurance[0][0]), (Some(1), 0.0));
    assert!((still.frequencies_hz[1] * TAU - 10.0).abs() < 1e-6, "{}", still.frequencies_hz[1]);
    assert!((still.assurance[0][1] - 1.0).abs() < 1e-12);
    let moved = found(3, "1.-3", 2);
    assert!((moved.assurance[0][0] - 1.0).abs() < 1e-12, "{:?}", moved.assurance);
    // Rotations with an arm of 4 m: 4e-7 and 2e-6.
    let still = found(5, "1.-5", 4);
    assert_eq!((still.pairs[0], still.assurance[0][0]), (Some(2), 0.0));
    let moved = found(5, "5.-5", 4);
    assert!((moved.assurance[0][0] - 1.0).abs() < 1e-12, "{:?}", moved.assurance);
}

/// One spring, one deflection u = F / (f k): Gauss and Newton's step is f (1 - f / f') to the factor f' that was
/// measured.
#[test]
fn a_fit_stops_after_the_steps_it_may_take_and_says_whether_it_is_done() {
    let model = three();
    let parameters = [of(&model, Quantity::Stiffness, &[1])];
    let wanted = |factor: f64| Measurements {
        deflections: vec![pull(1, 10.0, 2, 0.2 / factor, 1e-4)],
        ..Measurements::default()
    };
    let fitted = |measurements: &Measurements, iterations: usize| {
        fit(&model, &parameters, measurements, &Settings { iterations, ..Settings::default() })
            .expect("sound")
    };
    let none = fitted(&wanted(1.3), 0);
    assert_eq!((none.steps, none.is_converged, none.factors[0].value), (0, false, 1.0));
    // The first step is 1 - 1/1.3 by the slope of -0.2 there.
    let one = fitted(&wanted(1.3), 1);
    assert_eq!((one.steps, one.is_converged), (1, false));
    assert!((one.factors[0].value - (2.0 - 1.0 / 1.3)).abs() < 1e-9, "{}", one.factors[0].value);
    let all = fitted(&wanted(1.3), 40);
    assert!(all.is_converged && all.steps < 12 && (all.factors[0].value - 1.3).abs() < 1e-7);
    assert_eq!(all.degrees_of_freedom(), 0);
    // Sigma of f: that of u over its slope, f^2 1e-4 / 0.2.
    assert!((all.factors[0].sigma / (1.69e-4 / 0.2) - 1.0).abs() < 1e-6 && all.factors[0].is_determined);
    // Already there.
    let there = fitted(&wanted(1.0), 40);
    assert_eq!((there.steps, there.is_converged), (0, true));
    // Five times as soft: a whole step would lead to -3, its half to -1, its quarter to 0 and its eighth to 0.5.
    let halved = fitted(&wanted(0.2), 1);
    assert_eq!(halved.steps, 1);
    assert!((halved.factors[0].value - 0.5).abs() < 1e-9, "{}", halved.factors[0].value);
    // A hundred times as soft is less than a factor may be: it stays above 0.02.
    let least = fitted(&wanted(0.01), 40);
    assert!(least.factors[0].value > 0.02 && least.factors[0].value < 0.1, "{}", least.factors[0].value);
    let without = fit(&model, &[], &wanted(1.3), &Settings::default()).expect("sound");
    assert_eq!((without.steps, without.is_converged, without.degrees_of_freedom()), (0, true, 1));
}
