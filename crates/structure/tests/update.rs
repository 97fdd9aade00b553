//! Factors of regions fitted to measurements: planted ones come back, derivatives are those of finite differences, and
//! what the data leave open is said to be open.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use crate::common::{beam, section};
use structure::update::{
    Fit, MeasuredDeflection, MeasuredMode, Measurements, Parameter, Quantity, Settings, State, evaluate, fit,
};
use structure::{Model, System, normal_modes};

/// A cantilever of 12 elements with 2 m length and a tip mass off its axis.
fn cantilever() -> Model {
    let deck = beam(1, 12, 2.0, 0.0)
        + &section()
        + "CONM2,101,13,,.05,.03,,,,+\n+,1.-5,,2.-5,,,3.-5\nSPC1,1,123456,1\n";
    Model::from_bulk(&nastran::parse_deck("cantilever.bdf", &deck).unwrap()).unwrap()
}

fn region(model: &Model, name: &str, quantity: Quantity, ids: std::ops::RangeInclusive<u32>) -> Parameter {
    let inside = |(_, element): &(usize, &dyn structure::Element)| ids.contains(&element.id());
    let elements: Vec<usize> = model.elements().enumerate().filter(inside).map(|(place, _)| place).collect();
    assert!(!elements.is_empty());
    Parameter { region: name.into(), quantity, elements }
}

fn three_regions(model: &Model) -> Vec<Parameter> {
    vec![
        region(model, "inner", Quantity::Stiffness, 1..=6),
        region(model, "outer", Quantity::Stiffness, 7..=12),
        region(model, "outer", Quantity::Mass, 7..=12),
    ]
}

/// Five modes with shapes at six grids, the tip's deflection and twist under two loads, and the mass, all without
/// values.
fn plan(model: &Model) -> Measurements {
    let system = System::assemble(model).unwrap();
    let dof = |grid: u32, component: usize| 6 * system.node_index(grid).unwrap() + component - 1;
    let places: Vec<usize> =
        [3, 5, 7, 9, 11, 13].iter().flat_map(|grid| [1, 3].map(|component| dof(*grid, component))).collect();
    let mode = |at: usize| MeasuredMode {
        name: format!("mode {at}"),
        frequency_hz: 1.0,
        sigma_hz: 1.0,
        shape: places.iter().map(|dof| (*dof, 0.0)).collect(),
        mode: None,
    };
    let deflection = |name: &str, loads: Vec<(usize, f64)>, motion| MeasuredDeflection {
        name: name.into(),
        loads,
        motion,
        value: 0.0,
        sigma: 1.0,
    };
    Measurements {
        modes: (0..5).map(mode).collect(),
        deflections: vec![
            deflection("tip", vec![(dof(13, 3), 2.0)], dof(13, 3)),
            deflection("middle", vec![(dof(13, 3), 1.0), (dof(7, 5), 0.5)], dof(7, 5)),
        ],
        mass_kg: Some((1.0, 1.0)),
    }
}

/// Fills a plan with the results of the model with factors, each with a relative standard deviation and an error of
/// so many of it.
fn measured(
    model: &Model,
    parameters: &[Parameter],
    truth: &[f64],
    share: f64,
    mut noise: impl FnMut() -> f64,
) -> Measurements {
    let mut measurements = plan(model);
    let mut factors = vec![[1.0; 2]; model.elements().count()];
    for (parameter, factor) in parameters.iter().zip(truth) {
        for place in &parameter.elements {
            factors[*place][usize::from(parameter.quantity == Quantity::Mass)] = *factor;
        }
    }
    let system = System::assemble_scaled(model, |place| factors[place]).unwrap();
    let modes = normal_modes(&system, 5).unwrap();
    let shapes = system.expand(modes.shapes.as_ref());
    for (at, mode) in measurements.modes.iter_mut().enumerate() {
        let hz = modes.omega_rad_s[at] / std::f64::consts::TAU;
        mode.sigma_hz = share * hz;
        mode.frequency_hz = hz + mode.sigma_hz * noise();
        mode.shape.iter_mut().for_each(|(dof, value)| *value = -2.5 * shapes[(*dof, at)]);
    }
    let flexibility = structure::Flexibility::new(&system).unwrap();
    for deflection in &mut measurements.deflections {
        let mut loads = faer::Mat::zeros(6 * system.node_count(), 1);
        deflection.loads.iter().for_each(|(dof, value)| loads[(*dof, 0)] += value);
        let free = flexibility.displacements(system.reduce(loads.as_ref()).as_ref());
        let value = system.expand(free.as_ref())[(deflection.motion, 0)];
        deflection.sigma = share * value.abs();
        deflection.value = value + deflection.sigma * noise();
    }
    let mass = system.mass_properties().mass_kg;
    measurements.mass_kg = Some((mass + share * mass * noise(), share * mass));
    measurements
}

/// Nearly normal numbers: sums of twelve equally spread ones, from a linear congruential generator (Knuth's MMIX).
fn noise(seed: u64) -> impl FnMut() -> f64 {
    let mut state = seed;
    move || {
        (0..12)
            .map(|_| {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                (state >> 11) as f64 / (1_u64 << 53) as f64
            })
            .sum::<f64>()
            - 6.0
    }
}

const TRUTH: [f64; 3] = [0.85, 1.2, 1.15];

fn fitted(model: &Model, parameters: &[Parameter], measurements: &Measurements) -> Fit {
    fit(model, parameters, measurements, &Settings::default()).unwrap()
}

#[test]
fn planted_factors_come_back_exactly_from_exact_data() {
    let model = cantilever();
    let parameters = three_regions(&model);
    let found = fitted(&model, &parameters, &measured(&model, &parameters, &TRUTH, 0.01, || 0.0));
    assert!(found.is_converged && found.after.chi_square() < 1e-9, "{}", found.after.chi_square());
    for (factor, want) in found.factors.iter().zip(TRUTH) {
        assert!((factor.value - want).abs() < 1e-6 && factor.is_determined, "{factor:?}");
    }
    assert!(found.before.chi_square() > 100.0);
}

/// 40 campaigns with an error of 0.5 %: the factors' errors over their standard deviations spread as normal numbers.
/// Of 120 such numbers the mean square has the standard deviation sqrt(2/120) = 0.13 (they are correlated within a
/// campaign: at most sqrt(3) as much), so it lies from 0.3 to 1.7 but once in a thousand.
#[test]
fn planted_factors_come_back_within_their_uncertainty_from_noisy_data() {
    let model = cantilever();
    let parameters = three_regions(&model);
    let (mut square, mut largest, mut misfit) = (0.0, 0.0_f64, 0.0);
    for seed in 1..=40 {
        let found = fitted(&model, &parameters, &measured(&model, &parameters, &TRUTH, 0.005, noise(seed)));
        assert!(found.is_converged);
        assert_eq!(found.degrees_of_freedom(), 5);
        misfit += found.after.chi_square() / 5.0 / 40.0;
        for (factor, want) in found.factors.iter().zip(TRUTH) {
            let error = (factor.value - want) / factor.sigma;
            assert!(factor.is_determined && factor.sigma < 0.05, "{factor:?}");
            largest = largest.max(error.abs());
            square += error * error / 120.0;
        }
    }
    println!("mean square {square:.3}, largest {largest:.2}, misfit a degree of freedom {misfit:.3}");
    assert!((0.3..1.7).contains(&square), "mean square error over variance: {square}");
    assert!(largest < 4.5, "largest error: {largest} standard deviations");
    assert!((0.5..1.5).contains(&misfit), "misfit a degree of freedom: {misfit}");
}

/// Differences of fourth order: the frequencies' last digits (some 1e-10) forbid the short step that second order needs.
#[test]
fn derivatives_are_those_of_central_differences() {
    let model = cantilever();
    let parameters = three_regions(&model);
    let measurements = measured(&model, &parameters, &TRUTH, 0.01, || 0.0);
    let at = |factors: &[f64]| -> State {
        evaluate(&model, &parameters, factors, &measurements, &Settings::default()).unwrap()
    };
    let state = at(&TRUTH);
    let step = 1e-2;
    for p in 0..3 {
        let moved = |by: f64| {
            let mut factors = TRUTH;
            factors[p] += by;
            at(&factors)
        };
        let [near, far] = [step, 2.0 * step].map(|by| [moved(by), moved(-by)]);
        for (i, row) in state.sensitivities.iter().enumerate() {
            let value = |state: &State| state.predictions[i].model.unwrap() / state.predictions[i].sigma;
            let difference = |pair: &[State; 2]| value(&pair[0]) - value(&pair[1]);
            let slope = (8.0 * difference(&near) - difference(&far)) / (12.0 * step);
            let name = &state.predictions[i].name;
            assert!((row[p] - slope).abs() < 1e-5 * (1.0 + slope.abs()), "{name} by {p}: {} {slope}", row[p]);
        }
    }
}

/// Frequencies of a uniform structure are proportional to the square root of stiffness over mass.
#[test]
fn frequencies_alone_determine_the_ratio_of_stiffness_to_mass_and_no_more() {
    let model = cantilever();
    let all = 1..=200;
    let parameters = vec![
        region(&model, "all", Quantity::Stiffness, all.clone()),
        region(&model, "all", Quantity::Mass, all),
    ];
    let mut measurements = measured(&model, &parameters, &[1.0, 1.0], 0.001, || 0.0);
    measurements.deflections.clear();
    measurements.mass_kg = None;
    measurements.modes.iter_mut().for_each(|mode| mode.frequency_hz *= 1.1);
    let found = fitted(&model, &parameters, &measurements);
    assert!(found.factors.iter().all(|factor| !factor.is_determined), "{:?}", found.factors);
    assert_eq!(found.determination.determined, 1);
    let ratio = found.factors[0].value / found.factors[1].value;
    assert!((ratio - 1.21).abs() < 1e-6, "{ratio}");
    let open = &found.determination.undetermined_directions()[0];
    // Both together, in the proportion of the factors.
    assert!((open[0].1 / open[1].1 - ratio).abs() < 1e-4, "{open:?}");
}

#[test]
fn a_region_the_data_do_not_touch_keeps_its_factor_and_is_not_determined() {
    let model = cantilever();
    let mut parameters = three_regions(&model);
    // A point mass at the tip has no stiffness.
    parameters.push(region(&model, "tip mass", Quantity::Stiffness, 101..=101));
    let truth = [TRUTH[0], TRUTH[1], TRUTH[2], 3.0];
    let found = fitted(&model, &parameters, &measured(&model, &parameters, &truth, 0.01, || 0.0));
    assert!(!found.factors[3].is_determined);
    assert!((found.factors[3].value - 1.0).abs() < 1e-12, "it stays as it is");
    assert_eq!(
        found.determination.undetermined_directions(),
        [vec![(3, found.determination.directions[3][3])]]
    );
    assert!(found.factors[..3].iter().all(|factor| factor.is_determined));
}

#[test]
fn measured_modes_are_paired_by_their_shapes_in_any_order() {
    let model = cantilever();
    let parameters = three_regions(&model);
    let mut measurements = measured(&model, &parameters, &[1.0; 3], 0.01, || 0.0);
    measurements.modes.reverse();
    let state = evaluate(&model, &[], &[], &measurements, &Settings::default()).unwrap();
    assert_eq!(state.pairs, [4, 3, 2, 1, 0].map(Some));
    for (row, pair) in state.assurance.iter().zip(&state.pairs) {
        assert!((row[pair.unwrap()] - 1.0).abs() < 1e-9);
    }
    assert!(state.chi_square() < 1e-9);
}
