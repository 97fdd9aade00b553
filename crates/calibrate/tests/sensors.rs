//! Sensors beside the balance: what they decide, what is said of one that is wrong, and what a campaign may not say. Readings are made by
//! the model itself with planted corrections.

#![allow(clippy::unwrap_used, reason = "a test whose data cannot be read must fail")]

use crate::common::{RHO, campaign, draw, row, small_settings, wing_with};
use aero::{Corrections, Flow};
use calibrate::campaign::ChannelNoise;
use calibrate::posterior::predictions::Quantity;
use calibrate::posterior::{AirspeedPosterior, Prediction, posterior};
use calibrate::{Calibration, Campaign, Ending, Noise, Reading, Sensor, Zero, calibrate};
use coupling::wing_file::CorrectionPrior;
use coupling::{ElasticWing, Rows, SteadyCase, station_rows};
use faer::Mat;
use std::sync::LazyLock;

static WING: LazyLock<ElasticWing> = LazyLock::new(|| {
    wing_with(|planform| {
        planform.boxes.chordwise = 6;
        planform.boxes.spanwise = 14;
        for control in &mut planform.controls {
            control.strips = (control.strips.0.div_ceil(4), control.strips.1 / 4);
        }
    })
});

const V_M_S: f64 = 30.0;
const ALPHAS_DEG: [f64; 5] = [-2.0, 0.0, 2.0, 4.0, 6.0];
const SIGMA: [f64; 3] = [0.05, 0.03, 0.02];
const BRIDGE_SIGMA_NM: f64 = 0.05;
/// What a degree of a control really does.
const EFFECT: f64 = 0.85;

fn normal(k: usize) -> f64 {
    (0..12).map(|i| draw(12 * k + i)).sum::<f64>() / 2.0
}

/// Lift that is lost outboard and gained inboard: root loads hardly see it.
fn truth() -> Corrections {
    let boxes = &WING.correctable;
    Corrections {
        force: boxes.y_norm.iter().map(|y| 1.0 + 0.15 * (2.5 * y * std::f64::consts::PI).cos()).collect(),
        moment: vec![1.0; boxes.len()],
        pressure_offset: vec![0.0; boxes.len()],
    }
}

/// Root loads, and bending at a place of the span.
fn read(alpha_deg: f64, control: Option<(usize, f64)>, y_over_span: f64) -> Vec<f64> {
    let flow = Flow { v_m_s: V_M_S, rho_kg_m3: RHO };
    let mut case = SteadyCase::new(flow, alpha_deg.to_radians());
    case.controls_rad = vec![0.0; WING.controls.len()];
    if let Some((control, delta_deg)) = control {
        case.controls_rad[control] = EFFECT * delta_deg.to_radians();
    }
    let mut point = WING.balance.point;
    point.y += y_over_span * 1.8;
    let station = station_rows(&WING.lattice, &WING.balance, &point);
    let state = WING.at(flow, &truth()).unwrap().solve(std::slice::from_ref(&case)).swap_remove(0);
    let rows = Rows { on_loads: station, on_structure: Mat::zeros(0, WING.tip_row().len()) };
    let bending_nm = WING.at(flow, &truth()).unwrap().values(&case, &rows)[1];
    state.root.to_array().into_iter().chain([bending_nm]).collect()
}

fn noisy(values: &[f64], k: usize) -> [f64; 3] {
    std::array::from_fn(|c| values[c] + SIGMA[c] * normal(k + c))
}

/// A campaign with a strain bridge at 0.4 of the span that reads `gain` times what it should.
fn with_bridge(gain: f64, zero_nm: f64, zero: Zero) -> Campaign {
    let points = ALPHAS_DEG.iter().enumerate().map(|(i, &alpha_deg)| {
        let values = read(alpha_deg, None, 0.4);
        let mut point = row(V_M_S, alpha_deg.to_radians(), noisy(&values, 100 * i), None);
        // a gain that is wrong is wrong for the large moments alone: a bridge that slips
        let slipped = if alpha_deg > 3.0 { gain } else { 1.0 };
        point.sensors = vec![Some(slipped * values[3] + zero_nm + BRIDGE_SIGMA_NM * normal(100 * i + 9))];
        point.span.line = i + 2;
        point
    });
    let reads = Reading::Bending { y_over_span: 0.4 };
    let bridge =
        Sensor { column: "bridge_Nm".into(), reads, sigma: BRIDGE_SIGMA_NM, zero, scale: 0.002, under: None };
    Campaign { sensors: vec![bridge], ..campaign(points.collect(), Some(noise())) }
}

fn noise() -> Noise {
    let [fz_n, mx_nm, my_nm] = SIGMA.map(Some);
    let static_point = ChannelNoise { fz_n, mx_nm, my_nm, tip_z_m: None };
    Noise { sample: static_point, static_point }
}

/// Of a wing that may be rough along the span: the less is known of it, the more a sensor tells.
fn prior() -> CorrectionPrior {
    CorrectionPrior {
        force: [0.08, 0.06, 0.06],
        zero_lift_deg: [0.8, 0.5, 0.4],
        ..CorrectionPrior::default()
    }
}

fn known(campaign: &Campaign) -> (Calibration, AirspeedPosterior) {
    let calibration = calibrate(&*WING, campaign, &small_settings()).unwrap();
    let mut known = posterior(&WING, &calibration, &prior()).unwrap();
    let calibration = calibration.with_means(&WING, &known).unwrap();
    (calibration, known.swap_remove(0))
}

fn predicted(known: &AirspeedPosterior, quantity: &Quantity) -> Prediction {
    known.predictions.iter().find(|prediction| prediction.quantity == *quantity).unwrap().clone()
}

fn mid_span() -> Quantity {
    Quantity::Reading(Reading::Bending { y_over_span: 0.5 })
}

#[test]
fn a_strain_bridge_decides_the_bending_around_it() {
    let true_nm = read(6.0, None, 0.5)[3];
    let alone = Campaign { sensors: Vec::new(), ..with_bridge(1.0, 0.0, Zero::WindOff) };
    let alone = Campaign {
        points: alone
            .points
            .into_iter()
            .map(|p| calibrate::StaticPoint { sensors: Vec::new(), ..p })
            .collect(),
        ..alone
    };
    let (without, before) = known(&alone);
    assert!(before.mean.is_none() && without.faults().is_empty(), "{:?}", without.faults());
    for (zero_nm, zero) in [(0.0, Zero::WindOff), (3.0, Zero::Free)] {
        let (calibration, after) = known(&with_bridge(1.0, zero_nm, zero));
        let [wide, narrow] = [&before, &after].map(|known| predicted(known, &mid_span()));
        // without its zero a bridge says how the lift grows, not where it is without incidence
        let narrower = if zero == Zero::Free { 0.8 } else { 0.5 };
        assert!(narrow.sigma < narrower * wide.sigma, "{zero:?}: {wide:?} {narrow:?}");
        let [low, high] = narrow.interval();
        assert!((low..=high).contains(&true_nm), "{zero:?}: {narrow:?} {true_nm}");
        assert!(
            (narrow.value - true_nm).abs() < (wide.value - true_nm).abs(),
            "{wide:?} {narrow:?} {true_nm}"
        );
        // the balance is believed as before
        let at = &calibration.airspeeds[0];
        assert_eq!(at.fit.ending, Ending::PosteriorMean);
        assert!(at.fit.objective[1] < 3.0 * at.noise_floor.unwrap(), "{:?} {:?}", at.fit, at.noise_floor);
        assert!(after.beyond.is_empty(), "{:?}", after.beyond);
    }
}

#[test]
fn a_bridge_that_slips_is_said_and_taken_as_noise() {
    let (calibration, known) = known(&with_bridge(1.3, 0.0, Zero::WindOff));
    assert!(known.beyond.iter().any(|(column, _)| column == "bridge_Nm"), "{:?}", known.beyond);
    let said = calibration.said(&[calibrate::Weight::Suspicion]).join(" ");
    assert!(said.contains("bridge_Nm at 30 m/s") && said.contains("times its noise"), "{said}");
    let (_, sound) = self::known(&with_bridge(1.0, 0.0, Zero::WindOff));
    let [slipped, sound] = [&known, &sound].map(|known| predicted(known, &mid_span()));
    assert!(slipped.sigma > 2.0 * sound.sigma, "{slipped:?} {sound:?}");
}

#[test]
fn deflected_points_decide_what_a_control_does() {
    let neutral: Campaign = with_bridge(1.0, 0.0, Zero::WindOff);
    let mut points: Vec<calibrate::StaticPoint> =
        neutral.points.into_iter().map(|p| calibrate::StaticPoint { sensors: Vec::new(), ..p }).collect();
    let names = WING.control_names();
    for (c, name) in names.iter().enumerate() {
        for delta_deg in [-10.0_f64, 10.0] {
            let k = 5000 + 100 * c + usize::from(delta_deg > 0.0);
            let loads = noisy(&read(2.0, Some((c, delta_deg)), 0.4), k);
            let mut point = row(V_M_S, 2.0_f64.to_radians(), loads, None);
            point.controls_rad = vec![(name.clone(), delta_deg.to_radians())];
            points.push(point);
        }
    }
    let (_, known) = known(&campaign(points, Some(noise())));
    for (name, factor) in names.iter().zip(&known.mean.as_ref().unwrap().controls) {
        // lift corrections may take a part of the effect
        assert!((factor - EFFECT).abs() < 0.05, "{name}: {factor}");
        let power = predicted(&known, &Quantity::ControlMx { control: name.clone() });
        let index = names.iter().position(|other| other == name).unwrap();
        let true_nm = read(6.0, Some((index, 1.0)), 0.4)[1] - read(6.0, None, 0.4)[1];
        assert!((power.value / true_nm - 1.0).abs() < 0.01, "{name}: {power:?} {true_nm}");
    }
}

/// A folder with a campaign of three rows and a sensor.
fn written(name: &str, sensor: &str, columns: &str) -> Result<Campaign, nastran::InputError> {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).unwrap();
    let file = format!("(name: \"x\", rho_kg_m3: 1.2, static_cases: \"static.csv\", sensors: [{sensor}])");
    std::fs::write(folder.join("campaign.ron"), file).unwrap();
    std::fs::write(folder.join("static.csv"), columns).unwrap();
    Campaign::read(&folder)
}

#[test]
fn what_a_sensor_says_is_read_and_what_it_cannot_say_is_refused() {
    let table = "V_m_s,alpha_deg,Fz_N,bridge_Nm\n20,0,1,0.5\n20,2,3,\n20,4,5,2.5\n";
    let sensor = |change: (&str, &str)| {
        "(column: \"bridge_Nm\", reads: Bending(y_over_span: 0.4), sigma: 0.1, scale: 0.01)"
            .replace(change.0, change.1)
    };
    let campaign = written("sensors-good", &sensor(("", "")), table).unwrap();
    let read: Vec<Option<f64>> = campaign.points.iter().map(|point| point.sensors[0]).collect();
    assert_eq!(read, [Some(0.5), None, Some(2.5)]);
    let bad = [
        (("0.4", "1.4"), "beside the wing"),
        (("sigma: 0.1", "sigma: 0.0"), "positive standard deviation"),
        (("scale: 0.01", "scale: 1.5"), "less than 1"),
        (("bridge_Nm", "Mx_Nm"), "cannot be called `Mx_Nm`"),
        (("bridge_Nm", "strain"), "strain"),
    ];
    for (i, (change, words)) in bad.into_iter().enumerate() {
        let error = written(&format!("sensors-bad-{i}"), &sensor(change), table).unwrap_err().to_string();
        assert!(error.contains(words), "{change:?}: {error}");
    }
    let error = written("sensors-unlisted", "", table).unwrap_err().to_string();
    assert!(error.contains("unknown column `bridge_Nm`") && error.contains("sensor"), "{error}");
}

#[test]
fn what_is_not_used_is_said_and_a_rigid_wing_has_no_shape() {
    let neutral = with_bridge(1.0, 0.0, Zero::WindOff);
    let common = Campaign { sets: calibrate::Sets::Common, ..neutral.clone() };
    let said =
        calibrate(&*WING, &common, &small_settings()).unwrap().said(&[calibrate::Weight::Open]).join(" ");
    assert!(said.contains("sensors and rows with a control deflected are not used"), "{said}");
    let mut elsewhere = neutral.clone();
    let mut point = elsewhere.points[2].clone();
    (point.v_m_s, point.controls_rad) = (20.0, vec![(WING.control_names().remove(0), 0.1)]);
    elsewhere.points.push(point);
    let said =
        calibrate(&*WING, &elsewhere, &small_settings()).unwrap().said(&[calibrate::Weight::Open]).join(" ");
    assert!(said.contains("1 rows with a control deflected are not used"), "{said}");
    let mut rigid = neutral;
    rigid.sensors[0].reads = Reading::Twist { y_over_span: 0.5 };
    let mut wing = crate::common::wing_with(|planform| planform.boxes.spanwise = 56);
    wing.supported = None;
    let error = calibrate(&wing, &rigid, &small_settings()).unwrap_err().to_string();
    assert!(error.contains("reads the wing's shape, but the wing is rigid"), "{error}");
}

#[test]
fn noise_alone_is_not_called_more_than_noise() {
    let blamed = (0..40).filter(|seed| {
        let mut campaign = with_bridge(1.0, 0.0, Zero::WindOff);
        for (i, point) in campaign.points.iter_mut().enumerate() {
            let k = 20_000 + 1000 * seed + 10 * i;
            point.loads = noisy(&read(ALPHAS_DEG[i], None, 0.4), k).map(Some);
            point.sensors = vec![Some(read(ALPHAS_DEG[i], None, 0.4)[3] + BRIDGE_SIGMA_NM * normal(k + 5))];
        }
        !known(&campaign).1.beyond.is_empty()
    });
    // one in a hundred by design: more than three of forty have a chance of one in a thousand
    assert!(blamed.count() <= 3);
}
