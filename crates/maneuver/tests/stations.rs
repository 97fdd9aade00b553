//! Loads along the span: stations and strips are parts of the balance's loads.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::{uneven, wing_with};
use aero::Flow;
use maneuver::motion::{About, OneMinusCosine};
use maneuver::{Motion, Rig, RigSettings, Signal, Smooth, Station, TimeHistory};
use nalgebra::Point3;

/// A fast pitch of the coarse wing with loads at given stations and of every strip.
fn flown(stations: Vec<Station>) -> TimeHistory {
    let (file, wing) = wing_with(|_| ());
    let settings = RigSettings {
        stations,
        strip_loads: true,
        ..RigSettings::new(file.damping_ratio, file.pitch_axis_x())
    };
    let rig = Rig::new(&wing, settings).unwrap();
    let model = rig.at(Flow { v_m_s: 30.0, rho_kg_m3: 1.225 }, &uneven(&wing)).unwrap();
    let signal = About(0.02, OneMinusCosine::new(0.06, 4.0, 0.1));
    let of = |value: &dyn Fn(f64) -> f64| (0..120).map(|i| value(f64::from(i) * 0.005)).collect();
    let alpha = Smooth {
        value: of(&|t| signal.at(t)),
        rate: of(&|t| signal.rate(t)),
        second: of(&|t| signal.second(t)),
    };
    model.fly(&Motion { time_step_s: 0.005, alpha, controls_rad: Vec::new() })
}

fn station(name: &str, x: f64, y: f64) -> Station {
    Station { name: name.into(), point: Point3::new(x, y, 0.0) }
}

#[test]
fn a_station_inboard_of_everything_at_the_balance_has_the_balances_loads() {
    let (_, wing) = wing_with(|_| ());
    let balance = wing.balance.point;
    let all = Station { name: "all".into(), point: Point3::new(balance.x, -1.0, balance.z) };
    let history = flown(vec![all]);
    let get = |name: &str| history.get(name).unwrap();
    for i in 0..history.t_s.len() {
        assert!((get("Fz_N")[i] - get("Fz_all_N")[i]).abs() < 1e-9);
        assert!((get("My_Nm")[i] - get("My_all_Nm")[i]).abs() < 1e-9);
        // bending about the axis through the station's own point
        let arm = -1.0 - balance.y;
        let moved = get("Mx_Nm")[i] - arm * get("Fz_N")[i];
        assert!((moved - get("Mx_all_Nm")[i]).abs() < 1e-8, "{moved} {}", get("Mx_all_Nm")[i]);
    }
}

#[test]
fn along_the_span_shear_is_the_slope_of_bending_and_vanishes_at_the_tip() {
    let (near, far) = (0.795, 0.805);
    let history =
        flown(vec![station("near", 0.3, near), station("far", 0.3, far), station("tip", 0.3, 1.799)]);
    let get = |name: &str| history.get(name).unwrap();
    for i in 0..history.t_s.len() {
        // nothing lies between the two: d Mx/dy = -Fz to the digit
        let slope = (get("Mx_far_Nm")[i] - get("Mx_near_Nm")[i]) / (far - near);
        let shear = get("Fz_near_N")[i];
        assert!((slope + shear).abs() < 0.05 * shear.abs().max(1.0), "{slope} {shear}");
        assert!(get("Fz_tip_N")[i].abs() < 0.05 * get("Fz_N")[i].abs().max(1.0));
    }
}

#[test]
fn strips_add_up_to_the_lift() {
    let (_, wing) = wing_with(|_| ());
    let history = flown(Vec::new());
    let boxes = &wing.correctable;
    let strips = boxes.strip.iter().max().unwrap() + 1;
    let width = |strip: usize| {
        let first = boxes.strip.iter().position(|s| *s == strip).unwrap();
        wing.lattice.boxes[boxes.places[first]].width_m()
    };
    let lift: f64 = (0..strips)
        .map(|strip| history.get(&format!("lift_strip_{}_N_m", strip + 1)).unwrap()[0] * width(strip))
        .sum();
    // at rest the balance feels the lift, and of the weight what the tare at zero angle leaves
    let weight = wing.structure.as_ref().unwrap().0.mass_properties().mass_kg * coupling::GRAVITY_M_S2;
    let expected = history.get("Fz_N").unwrap()[0] - weight * (1.0 - 0.02_f64.cos());
    assert!((lift - expected).abs() < 1e-8 * lift, "{lift} {expected}");
}
