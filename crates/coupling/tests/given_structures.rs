//! Wings on structures that are given as numbers, and models that say little: sections that move as a whole, a spring,
//! matrices for other programs.

use crate::straight_wing::{AXIS_M, CHORD_M, boxes, case, near, parts, uneven, wing};
use aero::{Corrections, Flow, Lattice};
use coupling::{
    CorrectableBoxes, CouplingError, ElasticWing, Exchange, RootLoads, RootSensitivity, Spline, SteadyCase,
    SteadyModel, SupportedStructure,
};
use faer::Mat;
use nalgebra::Point3;

/// Boxes that all move with one node show at every point what a rigid body shows there.
#[test]
fn points_of_a_rigid_section_move_as_a_rigid_body() {
    let lattice = Lattice::trapezoid(1, [0.0, 1.0, 0.0], 0.8, [0.6, 3.0, 0.0], 0.4, [3, 4]).expect("boxes");
    let node = Point3::new(0.2, 0.5, 0.0);
    let spline = Spline::nearest_node(&lattice, &[node], &[0]);
    let (zeros, dofs) = (Mat::zeros(6, 6), (0..6).collect());
    let held = SupportedStructure::from_parts(dofs, zeros, Mat::zeros(6, 3), Mat::zeros(3, 3), &spline, 0);
    let mut parts = parts(lattice);
    parts.supported = Some(held.expect("all motions"));
    let wing = ElasticWing::new(parts).expect("a wing");
    for y_norm in [0.125, 0.2, 0.375, 0.7, 0.875] {
        for x_over_c in [-0.2, 0.0, 0.3, 0.5, 1.0] {
            let [height, turned] = wing.point_rows(y_norm, x_over_c);
            let y = 1.0 + 2.0 * y_norm;
            let x = 0.6 * y_norm + x_over_c * (0.8 - 0.4 * y_norm);
            let expected = [0.0, 0.0, 1.0, y - node.y, -(x - node.x), 0.0];
            for (motion, expected) in expected.into_iter().enumerate() {
                near(height[motion], expected, 1e-12, "a height");
                near(turned[motion], f64::from(u8::from(motion == 4)), 1e-12, "a turn");
            }
        }
    }
}

/// Three rows of boxes, each on a node of its own: a point shows what its nearest row does.
#[test]
fn a_point_of_a_section_that_warps_moves_with_the_nearest_box() {
    let lattice = Lattice::trapezoid(1, [0.0; 3], 0.9, [0.0, 1.0, 0.0], 0.9, [3, 1]).expect("boxes");
    let nodes = [0.15, 0.45, 0.75].map(|x| Point3::new(x, 0.5, 0.0));
    let spline = Spline::nearest_node(&lattice, &nodes, &[0, 1, 2]);
    let size = 18;
    let held = SupportedStructure::from_parts(
        (0..size).collect(),
        Mat::zeros(size, size),
        Mat::zeros(size, 3),
        Mat::zeros(3, 3),
        &spline,
        0,
    );
    let mut parts = parts(lattice);
    (parts.supported, parts.controls) = (Some(held.expect("all motions")), Vec::new());
    let wing = ElasticWing::new(parts).expect("a wing");
    for (x_over_c, node, aft_m) in
        [(0.0, 0, -0.15), (0.3, 0, 0.12), (0.34, 1, -0.144), (0.5, 1, 0.0), (0.7, 2, -0.12), (1.0, 2, 0.15)]
    {
        let [height, turned] = wing.point_rows(0.5, x_over_c);
        for dof in 0..size {
            let own = dof / 6 == node;
            let expected = match dof % 6 {
                2 if own => 1.0,
                4 if own => -aft_m,
                _ => 0.0,
            };
            near(height[dof], expected, 1e-12, "a height");
            near(turned[dof], f64::from(u8::from(own && dof % 6 == 4)), 1e-12, "a turn");
        }
    }
    near(wing.tip_twist_rad(&[0.1; 18]), 0.1, 1e-15, "no sag");
}

/// A rigid section on a torsion spring diverges where air turns it, per angle, with the stiffness of the spring.
#[test]
fn a_section_on_a_spring_diverges_where_air_turns_it_as_much_as_the_spring_holds() {
    let lattice = boxes([0.0, 1.0], CHORD_M);
    let spline = Spline::nearest_node(&lattice, &[Point3::new(AXIS_M, 0.5, 0.0)], &[0]);
    let stiffness = 30.0;
    let flexibility = Mat::from_fn(6, 6, |i, j| if i == 4 && j == 4 { 1.0 / stiffness } else { 0.0 });
    let held = SupportedStructure::from_parts(
        (0..6).collect(),
        flexibility,
        Mat::zeros(6, 3),
        Mat::zeros(3, 3),
        &spline,
        0,
    );
    let mut parts = parts(lattice);
    parts.supported = Some(held.expect("all motions"));
    let wing = ElasticWing::new(parts).expect("a wing");
    let neutral = Corrections::neutral(8);
    let nose_up: f64 = wing
        .pressures_by_alpha()
        .iter()
        .zip(&wing.lattice.boxes)
        .map(|(cp, panel)| cp * panel.area_m2() * (AXIS_M - panel.quarter_point().x))
        .sum();
    let limit_pa = stiffness / nose_up;
    near(
        wing.divergence_pressure(&neutral).expect("eigenvalues").expect("it diverges"),
        limit_pa,
        1e-9 * limit_pa,
        "pressure",
    );
    let v = (2.0 * limit_pa / 1.2).sqrt();
    near(
        wing.divergence_speed(1.2, &neutral).expect("eigenvalues").expect("it diverges"),
        v,
        1e-9 * v,
        "airspeed",
    );
    let at = |share: f64| wing.at(Flow { v_m_s: share * v, rho_kg_m3: 1.2 }, &neutral);
    assert!(at(0.9999).is_ok() && at(0.0).is_ok());
    assert!(matches!(at(1.0001), Err(CouplingError::Diverged { divergence_pa: Some(q), .. })
            if (q / limit_pa - 1.0).abs() < 1e-9));
}

/// Readings of a model that gives its sensitivities alone.
struct Given(CorrectableBoxes);

impl SteadyModel for Given {
    fn correctable(&self) -> &CorrectableBoxes {
        &self.0
    }
    fn root_loads(&self, _: &[SteadyCase], _: &Corrections) -> Result<Vec<RootLoads>, CouplingError> {
        Ok(Vec::new())
    }
    fn sensitivities(
        &self,
        cases: &[SteadyCase],
        _: &Corrections,
    ) -> Result<Vec<RootSensitivity>, CouplingError> {
        let nothing = || Mat::zeros(4, 0);
        let one = |case: &SteadyCase| RootSensitivity {
            loads: RootLoads::from_array([1.0, 2.0, 3.0]),
            tip_z_m: 2.0 * case.alpha_rad,
            by_force: nothing(),
            by_moment: nothing(),
            by_offset: nothing(),
        };
        Ok(cases.iter().map(one).collect())
    }
    fn pressure_coefficients(&self, _: &SteadyCase) -> Result<Vec<f64>, CouplingError> {
        Ok(Vec::new())
    }
}

#[test]
fn tips_are_those_of_the_sensitivities_unless_a_model_says_otherwise() {
    let model = Given(wing().correctable);
    let (cases, neutral) = ([case(10.0, 0.1), case(10.0, -0.3)], Corrections::neutral(8));
    assert_eq!(model.tip_deflections(&cases, &neutral).expect("tips"), [0.2, -0.6]);
    assert!(model.has_tip() && !model.bends_far());
    let readings = model.sensitivities(&cases, &neutral).expect("readings")[1].readings();
    assert_eq!(readings, [1.0, 2.0, 3.0, -0.6]);
    assert!(wing().root_loads(&[], &neutral).expect("none").is_empty());
    assert!(wing().tip_deflections(&[], &neutral).expect("none").is_empty());
    assert!(wing().sensitivities(&[], &neutral).expect("none").is_empty() && !wing().bends_far());
}

#[test]
fn matrix_and_incidence_for_other_programs_are_written_as_they_are() {
    let wing = ElasticWing::new(parts(boxes([0.0, 1.0], CHORD_M))).expect("a rigid wing");
    let corrections = uneven(8);
    let exchange = Exchange::of(&wing, &corrections).expect("no factor is zero");
    let card = exchange.w2gj();
    assert_eq!((card.name.as_str(), card.columns.len(), card.rows), ("W2GJ", 1, 8));
    for (written, own) in card.columns[0].iter().zip(&exchange.w2gj_rad) {
        near(*written, *own, 1e-4 * own.abs(), "an incidence");
    }
    let columns: Vec<Vec<f64>> = (0..8).map(|c| (0..8).map(|r| exchange.qjj[(r, c)]).collect()).collect();
    assert_eq!(exchange.op4(), nastran::op4_text("QJJ", &columns));
    assert_eq!(exchange.camber_rad, wing.camber);
    let identity = Mat::<f64>::identity(8, 8);
    let theory = wing.pressures(identity.as_ref());
    for r in 0..8 {
        for c in 0..8 {
            near(exchange.qjj[(r, c)], corrections.force[r] * theory[(r, c)], 1e-12, "a pressure");
        }
    }
    // A factor that is next to nothing beside the largest carries no offset, and needs none where there is none.
    let with = |factor: f64, offset: f64| {
        let mut one = Corrections { force: vec![-2.0; 8], ..Corrections::neutral(8) };
        (one.force[3], one.pressure_offset[3]) = (factor, offset);
        Exchange::of(&wing, &one)
    };
    assert!(with(2.01e-6, 0.1).is_ok() && with(-2.01e-6, 0.1).is_ok());
    assert!(with(2e-6, 0.1).is_err() && with(1.9e-6, -0.1).is_err() && with(0.0, 0.1).is_err());
    let none = with(0.0, 0.0).expect("nothing to carry");
    none.w2gj_rad.iter().zip(&wing.camber).for_each(|(a, b)| near(*a, *b, 1e-15, "camber"));
}
