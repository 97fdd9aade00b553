//! Derivatives against what they must be: sums made another way, trims, scaled corrections and a shifted centre of gravity.

use crate::common::{assert_near, beam_wing, whole};
use aero::{BoxLoads, Corrections, Integration, MirrorPlane, SteadyAero, incidence};
use coupling::wing_file::Departure;
use coupling::{GRAVITY_M_S2, WingFile};
use fullaircraft::{Aircraft, Coefficients, Steady, TrimTools};
use nalgebra::{Point3, Vector3};

#[test]
fn rigid_derivatives_are_those_of_a_lattice_solved_directly() {
    let aircraft = whole();
    let all = aircraft.uncorrected().derivatives(30.0).unwrap();
    assert_near("area", all.area_m2, 0.81, 1e-12);
    assert_near("span", all.span_m, 3.6, 1e-12);
    // taper 1/2: two thirds of the root chord times (1 + t + t2)/(1 + t); strips are 56 steps of the linear chord
    assert_near("chord", all.chord_m, 2.0 / 3.0 * 0.3 * 1.75 / 1.5, 1e-4);
    let lattice = &aircraft.flow.lattice;
    let aero = SteadyAero::new(lattice, MirrorPlane::None, 0.0).unwrap();
    let about = Point3::new(0.40, 0.0, 0.0);
    let (integration, neutral) = (Integration::new(lattice), Corrections::neutral(lattice.len()));
    let sums = |w: &[f64]| -> Coefficients {
        let loads: BoxLoads = integration.corrected(&neutral).box_loads(1.0, &aero.pressures_of(w));
        let (force, moment) = loads.resultant(lattice, 0..lattice.len(), &about);
        let (s, b, c) = (all.area_m2, all.span_m, all.chord_m);
        Coefficients {
            lift: force[2] / s,
            side: force[1] / s,
            roll: -moment[0] / (s * b),
            pitch: moment[1] / (s * c),
            yaw: -moment[2] / (s * b),
        }
    };
    let rate =
        |axis: Vector3<f64>, length_m: f64| incidence::rotation_rate(lattice, &axis, &about, length_m / 2.0);
    let columns = [
        ("alpha", incidence::angle_of_attack(lattice)),
        ("beta", incidence::sideslip(lattice)),
        ("roll_rate", rate(-Vector3::x(), all.span_m)),
        ("pitch_rate", rate(Vector3::y(), all.chord_m)),
        ("yaw_rate", rate(-Vector3::z(), all.span_m)),
        ("rudder", aircraft.flow.controls[aircraft.control("rudder").unwrap()].column(lattice.len())),
    ];
    for (name, column) in columns {
        let (ours, direct) = (all.by(name).unwrap().rigid, sums(&column));
        let pairs = [
            (ours.lift, direct.lift),
            (ours.side, direct.side),
            (ours.roll, direct.roll),
            (ours.pitch, direct.pitch),
            (ours.yaw, direct.yaw),
        ];
        for (ours, direct) in pairs {
            assert!((ours - direct).abs() < 1e-9, "{name}: {ours} {direct}");
        }
    }
}

#[test]
fn signs_and_sizes_are_those_of_an_aircraft() {
    let all = whole().uncorrected().derivatives(30.0).unwrap();
    let by = |name: &str| all.by(name).unwrap().restrained;
    // lift slope of a wing of aspect ratio 16 with a tail: above 4, below thin-airfoil theory on wing and tail together
    assert!((4.0..7.5).contains(&by("alpha").lift), "{:?}", by("alpha"));
    assert!(by("alpha").pitch < 0.0 && by("beta").yaw > 0.0, "stable in pitch and yaw");
    assert!(by("roll_rate").roll < 0.0 && by("pitch_rate").pitch < 0.0 && by("yaw_rate").yaw < 0.0, "damped");
    assert!(by("elevator").pitch < 0.0 && by("outer").roll < 0.0);
    // rudder with its trailing edge to the right pushes the tail to the left: nose right
    assert!(by("rudder").yaw > 0.0 && by("rudder").side < 0.0, "{:?}", by("rudder"));
    // a symmetric aircraft's symmetric motions have no antisymmetric part
    for name in ["zero", "alpha", "pitch_rate", "elevator"] {
        let c = by(name);
        assert!([c.side, c.roll, c.yaw].iter().all(|x| x.abs() < 1e-10), "{name}: {c:?}");
    }
    for name in ["beta", "roll_rate", "yaw_rate", "outer", "rudder"] {
        let c = by(name);
        assert!([c.lift, c.pitch].iter().all(|x| x.abs() < 1e-10), "{name}: {c:?}");
    }
}

#[test]
fn elastic_derivatives_become_rigid_ones_in_slow_air() {
    let all = whole().uncorrected().derivatives(0.1).unwrap();
    for row in &all.derivatives {
        for elastic in [row.restrained, row.unrestrained] {
            assert!((elastic.lift - row.rigid.lift).abs() < 1e-4 * row.rigid.lift.abs().max(1.0), "{row:?}");
            assert!((elastic.roll - row.rigid.roll).abs() < 1e-4 * row.rigid.roll.abs().max(1.0), "{row:?}");
        }
    }
}

#[test]
fn unrestrained_derivatives_give_the_elevator_of_the_trim() {
    // Two ways to one flight: held at the root with weight and inertia as loads, or in mean axes with inertia relief.
    let aircraft = whole();
    let model = aircraft.uncorrected();
    let v_m_s = 30.0;
    let all = model.derivatives(v_m_s).unwrap();
    let by = |name: &str| all.by(name).unwrap().unrestrained;
    let (zero, alpha, elevator) = (by("zero"), by("alpha"), by("elevator"));
    let q_pa = 0.5 * 1.225 * v_m_s * v_m_s;
    let missing = 20.0 * GRAVITY_M_S2 / (q_pa * all.area_m2) - zero.lift;
    let determinant = alpha.lift * elevator.pitch - elevator.lift * alpha.pitch;
    let deflection = (-alpha.lift * zero.pitch - alpha.pitch * missing) / determinant;
    let tools = TrimTools::new(aircraft, &[]).unwrap();
    let at = tools.at(&model, v_m_s).unwrap();
    let found = at.solve(&Steady::Level.case(&aircraft.file, v_m_s)).unwrap();
    assert_near("elevator", at.value(&found, "elevator_deg").unwrap(), deflection.to_degrees(), 1e-8);
    // the wing's root is not where mean axes are, so the angles differ: tips up is nose down of the root against them
    let angle_deg = (missing * elevator.pitch + elevator.lift * zero.pitch) / determinant;
    assert!((at.value(&found, "alpha_deg").unwrap() - angle_deg.to_degrees()).abs() > 1e-3);
}

#[test]
fn corrections_of_c_everywhere_are_a_dynamic_pressure_times_c() {
    let aircraft = whole();
    let c = 1.3;
    let mut scaled = aircraft.uncorrected();
    scaled.corrections.force.fill(c);
    scaled.corrections.moment.fill(c);
    let plain = aircraft.uncorrected();
    let tools = TrimTools::new(aircraft, &[]).unwrap();
    let (v_m_s, faster_m_s) = (30.0, 30.0 * f64::sqrt(c));
    let (at, other) = (tools.at(&scaled, v_m_s).unwrap(), tools.at(&plain, faster_m_s).unwrap());
    let level = Steady::Level;
    let one = at.solve(&level.case(&aircraft.file, v_m_s)).unwrap();
    let two = other.solve(&level.case(&aircraft.file, faster_m_s)).unwrap();
    for name in ["alpha_deg", "elevator_deg"] {
        assert_near(name, at.value(&one, name).unwrap(), other.value(&two, name).unwrap(), 1e-9);
    }
    for (a, b) in at.station_loads(&one).iter().zip(other.station_loads(&two)) {
        for (a, b) in a.iter().zip(b) {
            assert_near("root load", *a, b, 1e-9);
        }
    }
    let (derivatives, faster) = (scaled.derivatives(v_m_s).unwrap(), plain.derivatives(faster_m_s).unwrap());
    for elastic in [
        (derivatives.by("alpha").unwrap().restrained, faster.by("alpha").unwrap().restrained),
        (derivatives.by("alpha").unwrap().unrestrained, faster.by("alpha").unwrap().unrestrained),
    ] {
        assert_near("lift slope", elastic.0.lift, c * elastic.1.lift, 1e-9);
    }
}

#[test]
fn with_its_centre_of_gravity_at_the_neutral_point_the_moment_does_not_follow_alpha() {
    let aircraft = whole();
    let all = aircraft.uncorrected().derivatives(30.0).unwrap();
    let [rigid, restrained, _] = all.neutral_point_x_m;
    for (place, x_cg_m) in [(0, rigid), (1, restrained)] {
        let mut file = aircraft.file.clone();
        file.total.x_cg_m = x_cg_m;
        // inertia about another point: enough for the body that closes the masses
        file.total.iyy_kg_m2 += 5.0;
        file.total.izz_kg_m2 += 5.0;
        let shifted = Aircraft::new(file, WingFile::read(&beam_wing()).unwrap()).unwrap();
        let there = shifted.uncorrected().derivatives(30.0).unwrap();
        let alpha = there.by("alpha").unwrap();
        let slope = if place == 0 { alpha.rigid } else { alpha.restrained };
        assert!(slope.pitch.abs() < 1e-8 * slope.lift, "{slope:?}");
    }
}

/// A flap that the flow sees nine tenths of does nine tenths of all it does, and nothing else changes.
#[test]
fn a_departing_aileron_departs_on_both_wings_of_the_aircraft() {
    let mut wing = WingFile::read(&beam_wing()).unwrap();
    wing.departure = Departure { controls: vec![("outer".into(), 0.9)], ..Departure::default() };
    let departing = Aircraft::new(whole().file.clone(), wing).unwrap();
    let [drawn, there] =
        [whole(), &departing].map(|aircraft| aircraft.uncorrected().derivatives(30.0).unwrap());
    for (name, factor) in [("outer", 0.9), ("inner", 1.0), ("alpha", 1.0)] {
        let [drawn, there] = [&drawn, &there].map(|all| all.by(name).unwrap());
        for (drawn, there) in [(drawn.rigid, there.rigid), (drawn.restrained, there.restrained)] {
            let size = drawn.roll.abs().max(drawn.lift.abs());
            for (there, drawn) in [(there.roll, drawn.roll), (there.lift, drawn.lift)] {
                assert!((there - factor * drawn).abs() < 1e-9 * size, "{name}: {there} {drawn}");
            }
        }
    }
    assert!(drawn.by("outer").unwrap().rigid.roll.abs() > 0.01, "an aileron rolls");
}
