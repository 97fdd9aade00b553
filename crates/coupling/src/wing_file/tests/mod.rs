//! What a wing's file may say: numbers at their bounds and just beyond, names, lists, and what need not be said.

mod of_decks;

use super::*;
use crate::planform::Boxes;

/// A rigid wing of two strips of four boxes.
fn wing() -> WingFile {
    let text = "Wing(name: \"plain\", source: Parametric((semispan_m: 2.0, root_chord_m: 0.6, tip_chord_m: 0.4, \
                quarter_chord_sweep_deg: 0.0, boxes: (chordwise: 4, spanwise: 2))), \
                balance: (x_m: 0.3, y_m: 0.1, z_m: -0.2), correction: (chord_strips: 2, span_order: 1))";
    ron_file::parse("wing.ron", text).expect("a wing's file")
}

/// What is said of a wing after a change; nothing if it may be.
fn said(change: impl Fn(&mut WingFile)) -> String {
    let mut wing = wing();
    change(&mut wing);
    let at = Span::generated("a test");
    wing.check().err().map(|fault| fault.at(&at).to_string()).unwrap_or_default()
}

fn tells(what: &str, said: &str, word: &str) {
    assert!(said.contains(word) && said.is_empty() == word.is_empty(), "{what}: {said}");
}

/// A field, how it is set, values that may be and values that may not.
type Bound = (&'static str, fn(&mut WingFile, f64), &'static [f64], &'static [f64]);

fn station(name: &str, y_m: f64) -> StationAt {
    StationAt { name: name.to_owned(), y_m, x_m: None, z_m: None }
}

#[test]
fn numbers_at_their_bounds_are_taken_and_beyond_them_refused() {
    let far: &[f64] = &[-1e4, 0.0, 1e4];
    let farther: &[f64] = &[-10_001.0, 10_001.0, f64::NAN];
    let bounds: &[Bound] = &[
        ("x_m", |w, v| w.balance.x_m = v, far, farther),
        ("y_m", |w, v| w.balance.y_m = v, far, farther),
        ("z_m", |w, v| w.balance.z_m = v, far, farther),
        ("pitch_axis_x_m", |w, v| w.pitch_axis_x_m = Some(v), far, farther),
        ("root_plane", |w, v| w.root_plane = Some(RootPlane::Symmetric(v)), far, farther),
        ("damping_ratio", |w, v| w.damping_ratio = v, &[0.0, 0.5], &[-0.001, 0.501]),
        ("y_m", |w, v| w.stations = vec![station("a", v)], far, farther),
        ("x_m", |w, v| w.stations = vec![StationAt { x_m: Some(v), ..station("a", 0.0) }], far, farther),
        ("z_m", |w, v| w.stations = vec![StationAt { z_m: Some(v), ..station("a", 0.0) }], far, farther),
        ("neighbour_bound", |w, v| w.correction.neighbour_bound = v, &[1e-6, 1e4], &[0.0, -1.0, 10_001.0]),
        ("bending", |w, v| w.known_to.bending = v, &[0.0, 0.5], &[-0.001, 0.501]),
        ("torsion", |w, v| w.known_to.torsion = v, &[0.0, 0.5], &[-0.001, 0.501]),
        ("mass", |w, v| w.known_to.mass = v, &[0.0, 0.5], &[-0.001, 0.501]),
        ("damping", |w, v| w.known_to.damping = v, &[0.0, 1.0], &[-0.001, 1.001]),
        ("apparent_mass", |w, v| w.known_to.apparent_mass = v, &[0.0, 0.5], &[-0.001, 0.501]),
        ("wake_lag", |w, v| w.known_to.wake_lag = v, &[0.0, 0.5], &[-0.001, 0.501]),
        ("surfaces", |w, v| w.known_to.surfaces = v, &[0.0, 0.5], &[-0.001, 0.501]),
        ("linkage", |w, v| w.known_to.linkage = v, &[0.0, 0.5], &[-0.001, 0.501]),
        ("alpha_deg", |w, v| w.known_to.alpha_deg = v, &[0.0, 5.0], &[-0.001, 5.001]),
        ("clock_s", |w, v| w.known_to.clock_s = v, &[0.0, 0.05], &[-0.001, 0.051]),
        ("force", |w, v| w.correction.prior.force[0] = v, &[0.0, 10.0], &[-0.001, 10.01]),
        ("force", |w, v| w.correction.prior.force[2] = v, &[0.0, 10.0], &[-0.001, 10.01]),
        (
            "force_along_chord",
            |w, v| w.correction.prior.force_along_chord = v,
            &[0.0, 10.0],
            &[-0.001, 10.01],
        ),
        ("zero_lift_deg", |w, v| w.correction.prior.zero_lift_deg[1] = v, &[0.0, 10.0], &[-0.001, 10.01]),
        ("moment_offset_cp", |w, v| w.correction.prior.moment_offset_cp = v, &[0.0, 10.0], &[-0.001, 10.01]),
        ("moment", |w, v| w.correction.prior.moment = v, &[0.0, 10.0], &[-0.001, 10.01]),
        ("control", |w, v| w.correction.prior.control[1] = v, &[0.0, 10.0], &[-0.001, 10.01]),
        ("flexibility", |w, v| w.correction.prior.flexibility[0] = v, &[0.0, 10.0], &[-0.001, 10.01]),
        ("flexibility", |w, v| w.correction.prior.flexibility[1] = v, &[0.0, 10.0], &[-0.001, 10.01]),
        ("reading", |w, v| w.correction.prior.reading = v, &[0.0, 10.0], &[-0.001, 10.01]),
        ("unsteady", |w, v| w.correction.prior.unsteady = v, &[0.0, 10.0], &[-0.001, 10.01]),
        ("stream", |w, v| w.correction.prior.stream = v, &[0.0, 10.0], &[-0.001, 10.01]),
        ("airspeeds_alike", |w, v| w.correction.prior.airspeeds_alike = v, &[0.0, 10.0], &[-0.001, 10.01]),
        ("smooth_over_span", |w, v| w.correction.prior.smooth_over_span = v, &[0.01, 10.0], &[0.009, 10.01]),
        ("local_over_chord", |w, v| w.correction.prior.local_over_chord = v, &[0.01, 10.0], &[0.009, 10.01]),
    ];
    for (field, set, good, bad) in bounds {
        for value in *good {
            assert_eq!(said(|wing| set(wing, *value)), "", "{field} {value}");
        }
        for value in *bad {
            let error = said(|wing| set(wing, *value));
            assert!(error.contains(&format!("{field} is ")), "{field} {value}: {error}");
        }
    }
}

#[test]
fn counts_at_their_bounds_are_taken_and_beyond_them_refused() {
    for (strips, order, word) in [
        (1, 0, ""),
        (100, 8, ""),
        (0, 1, "chord_strips is 0"),
        (101, 1, "chord_strips is 101"),
        (1, 9, "span_order is 9"),
    ] {
        let error = said(|w| (w.correction.chord_strips, w.correction.span_order) = (strips, order));
        tells("counts", &error, word);
    }
}

#[test]
fn servos_are_known_to_half_of_themselves_at_most() {
    let with = |frequency_hz: f64, damping_ratio: f64, frequency_sd_hz: f64, damping_ratio_sd: f64| {
        said(|wing| {
            wing.servos =
                Servos::SecondOrder { frequency_hz, damping_ratio, frequency_sd_hz, damping_ratio_sd };
        })
    };
    assert_eq!(said(|wing| wing.servos = Servos::None), "");
    for (frequency, damping, sd, damping_sd) in
        [(15.0, 0.8, 1.0, 0.05), (0.1, 0.05, 0.05, 0.025), (1e4, 10.0, 5e3, 5.0), (4.0, 0.5, 0.0, 0.0)]
    {
        assert_eq!(with(frequency, damping, sd, damping_sd), "");
    }
    for (frequency, damping, sd, damping_sd) in [
        (0.09, 0.8, 0.01, 0.05),
        (1.1e4, 0.8, 1.0, 0.05),
        (15.0, 0.04, 1.0, 0.01),
        (15.0, 10.1, 1.0, 0.05),
        (15.0, 0.8, 7.6, 0.05),
        (15.0, 0.8, -0.1, 0.05),
        (15.0, 0.8, 1.0, 0.41),
        (15.0, 0.8, 1.0, -0.01),
        (f64::NAN, 0.8, 1.0, 0.05),
    ] {
        let error = with(frequency, damping, sd, damping_sd);
        assert!(error.contains(&format!("servos of {frequency:?}")), "{error}");
    }
}

#[test]
fn stations_have_names_of_columns_each_once() {
    let names =
        |names: &[&str]| said(|wing| wing.stations = names.iter().map(|name| station(name, 0.5)).collect());
    tells("plain", &names(&["a", "B_2", "mid-span", "7"]), "");
    tells("none", &names(&[""]), "the station's name \"\"");
    tells("a space", &names(&["a b"]), "the station's name \"a b\"");
    tells("a comma", &names(&["a,b"]), "the station's name");
    tells("a letter of another alphabet", &names(&["é"]), "the station's name");
    tells("twice", &names(&["a", "b", "a"]), "two stations are called a");
}

#[test]
fn chord_strips_are_whole_rows_of_every_panel_that_is_corrected() {
    let strips = |chord_strips: usize, change: &dyn Fn(&mut WingFile, &mut BulkData)| {
        let mut wing = wing();
        wing.correction.chord_strips = chord_strips;
        let mut bulk = wing.bulk(Mount::Tunnel).expect("cards");
        change(&mut wing, &mut bulk);
        let at = Span::generated("a test");
        wing.check_chord_strips(&bulk).err().map(|fault| fault.at(&at).to_string()).unwrap_or_default()
    };
    for (count, word) in [(1, ""), (2, ""), (4, ""), (3, "divide the 4 boxes"), (8, "divide the 4 boxes")] {
        tells("equal boxes", &strips(count, &|_, _| ()), word);
    }
    let listed = |_: &mut WingFile, bulk: &mut BulkData| {
        let span = Span::generated("a test");
        let values = vec![0.0, 0.2, 0.5, 1.0];
        bulk.factors.insert(9, nastran::Aefact { id: 9, values, span });
        bulk.panels.values_mut().for_each(|panel| panel.chord_divisions = Divisions::Aefact(9));
    };
    for (count, word) in [(1, ""), (3, ""), (2, "divide the 3 boxes")] {
        tells("a list", &strips(count, &listed), word);
    }
    let fairing = |wing: &mut WingFile, _: &mut BulkData| {
        let deck = DeckSource { file: String::new(), fairing_panels: vec![100_001], spline_set: None };
        wing.source = Source::Deck(deck);
    };
    tells("a fairing is not corrected", &strips(3, &fairing), "");
}

fn effect(name: &str, parameters: &[(&str, f64)]) -> WingEffect {
    let parameters = parameters.iter().map(|(name, value)| ((*name).to_owned(), *value)).collect();
    WingEffect { name: name.to_owned(), parameters, ..WingEffect::default() }
}

fn of_effects(all: &[WingEffect]) -> String {
    effects::check(all, "", Path::new("wing.ron")).err().map(|error| error.to_string()).unwrap_or_default()
}

#[test]
fn effects_have_finite_numbers_of_parameters_listed_once() {
    let two = effect("gap", &[("a", 1.0), ("b", -2.0)]);
    let other = effect("slot", &[("a", 1.0)]);
    tells("two", &of_effects(&[two.clone(), other.clone()]), "");
    tells("twice", &of_effects(&[two.clone(), other, two.clone()]), "gap is listed twice");
    let with = |change: &dyn Fn(&mut WingEffect)| {
        let mut effect = two.clone();
        change(&mut effect);
        of_effects(&[effect])
    };
    let sigma =
        |name: &'static str, value: f64| move |e: &mut WingEffect| e.sigma.push((name.to_owned(), value));
    tells("sigma", &with(&sigma("b", 0.5)), "");
    tells("sigma of zero", &with(&sigma("b", 0.0)), "");
    tells("sigma below", &with(&sigma("b", -0.1)), "b of gap is -0.1 under sigma");
    tells("sigma of none", &with(&sigma("c", 0.1)), "sigma of gap has c");
    tells("a number", &with(&|e| e.parameters[1].1 = f64::NAN), "b of gap is NaN under parameters");
    tells("endless", &with(&sigma("a", f64::INFINITY)), "a of gap is inf under sigma");
    tells(
        "the same",
        &with(&|e| e.parameters[1].0 = "a".into()),
        "a of gap is listed twice under parameters",
    );
    let again = |e: &mut WingEffect| e.sigma = vec![("a".into(), 0.1), ("a".into(), 0.1)];
    tells("sigma twice", &with(&again), "a of gap is listed twice under sigma");
    let matrix = |rows: &[&[f64]]| {
        let rows: Vec<Vec<f64>> = rows.iter().map(|row| row.to_vec()).collect();
        with(&|e| e.covariance.clone_from(&rows))
    };
    let wrong = "covariance of gap is no symmetric matrix of 2 by 2 numbers";
    for (rows, word) in [
        (&[&[4.0, 1.0][..], &[1.0, 9.0]][..], ""),
        (&[&[0.0, 0.0], &[0.0, 0.0]], ""),
        (&[&[4.0, -3.0], &[-3.0, 9.0]], ""),
        (&[&[4.0, 1.0], &[1.000_000_005, 9.0]], ""),
        (&[&[4.0, 1.0], &[1.000_000_007, 9.0]], wrong),
        (&[&[4.0, 1.0], &[-1.0, 9.0]], wrong),
        (&[&[-4.0, 1.0], &[1.0, -9.0]], wrong),
        (&[&[4.0, 1.0], &[1.0, -9.0]], wrong),
        (&[&[f64::NAN, 1.0], &[1.0, 9.0]], wrong),
        (&[&[4.0, f64::INFINITY], &[f64::INFINITY, 9.0]], wrong),
        (&[&[4.0, 1.0]], wrong),
        (&[&[4.0], &[9.0]], wrong),
        (&[&[4.0, 1.0], &[1.0, 9.0], &[0.0, 0.0]], wrong),
        (&[&[4.0, 1.0, 0.0], &[1.0, 9.0, 0.0]], wrong),
    ] {
        tells(&format!("{rows:?}"), &matrix(rows), word);
    }
}

#[test]
fn what_data_of_an_effect_covered_ascends() {
    type Set = fn(&mut EffectValidity, (f64, f64));
    let fields: [(&str, Set); 4] = [
        ("alpha_deg", |v, range| v.alpha_deg = Some(range)),
        ("V_m_s", |v, range| v.v_m_s = Some(range)),
        ("frequency_hz", |v, range| v.frequency_hz = Some(range)),
        ("delta_deg", |v, range| v.delta_deg = Some(range)),
    ];
    for (field, set) in fields {
        for (range, good) in [
            ((-3.0, 5.0), true),
            ((2.0, 2.0), true),
            ((2.0, 1.9), false),
            ((f64::NEG_INFINITY, 1.0), false),
            ((0.0, f64::INFINITY), false),
        ] {
            let mut one = effect("gap", &[("a", 1.0)]);
            set(one.validity.insert(EffectValidity::default()), range);
            let word = if good { String::new() } else { format!("{field} of gap does not ascend") };
            tells(field, &of_effects(&[one]), &word);
        }
    }
}

fn table(odd: bool, rows: Vec<DeflectionRow>) -> DeflectionTable {
    DeflectionTable { control: "flap".to_owned(), odd, outside: OutsideAirspeeds::Refuse, rows }
}

fn row(v_m_s: f64, commanded: &[f64], factor: &[f64]) -> DeflectionRow {
    let (commanded_deg, factor) = (commanded.to_vec(), Some(factor.to_vec()));
    DeflectionRow { v_m_s, commanded_deg, equivalent_deg: None, factor }
}

#[test]
fn deflections_and_their_factors_keep_to_their_bounds() {
    let complaint = |odd: bool, rows: Vec<DeflectionRow>| table(odd, rows).complaint().unwrap_or_default();
    let one = |commanded: &[f64], factor: &[f64]| complaint(true, vec![row(20.0, commanded, factor)]);
    tells("bounds", &one(&[1e-3, 90.0], &[0.0, 5.0]), "");
    tells("too far", &one(&[90.1], &[1.0]), "beyond 90");
    tells("zero", &one(&[0.0], &[1.0]), "beyond 90");
    tells("no number", &one(&[f64::NAN], &[1.0]), "beyond 90");
    tells("none", &one(&[], &[]), "no deflection is listed");
    tells("the same", &one(&[5.0, 5.0], &[1.0, 1.0]), "must ascend");
    tells("falling", &one(&[5.0, 4.0], &[1.0, 1.0]), "must ascend");
    tells("negative in an odd table", &one(&[-5.0, 5.0], &[1.0, 1.0]), "a negative deflection");
    tells("a factor below", &one(&[5.0], &[-0.1]), "a factor of -0.1000");
    tells("a factor above", &one(&[5.0], &[5.1]), "a factor of 5.1000");
    tells("a number short", &one(&[5.0, 6.0], &[1.0]), "1 numbers for 2 deflections");
    let both = |commanded: &[f64]| complaint(false, vec![row(20.0, commanded, &vec![1.0; commanded.len()])]);
    tells("both signs", &both(&[-5.0, 5.0]), "");
    tells("one sign", &both(&[5.0, 6.0]), "both signs");
    tells("the other sign", &both(&[-6.0, -5.0]), "both signs");
    let speeds = |speeds: &[f64]| complaint(true, speeds.iter().map(|v| row(*v, &[5.0], &[1.0])).collect());
    tells("speeds", &speeds(&[0.1, 20.0, 340.0]), "");
    tells("none", &speeds(&[]), "has no rows");
    tells("slow", &speeds(&[0.09]), "V_m_s is 0.09");
    tells("fast", &speeds(&[20.0, 341.0]), "V_m_s is 341.0");
    tells("twice", &speeds(&[20.0, 20.0]), "20 is followed by 20");
    tells("falling", &speeds(&[10.0, 20.0, 15.0]), "20 is followed by 15");
    let equivalent = |equivalents: Option<Vec<f64>>, factor: Option<Vec<f64>>| DeflectionRow {
        equivalent_deg: equivalents,
        factor,
        ..row(20.0, &[4.0, 10.0], &[])
    };
    let halves = equivalent(Some(vec![2.0, 20.0]), None);
    assert_eq!(halves.factors(), [0.5, 2.0]);
    tells("equivalents", &complaint(true, vec![halves]), "");
    tells(
        "of the other sign",
        &complaint(true, vec![equivalent(Some(vec![-2.0, 5.0]), None)]),
        "a factor of -0.5000",
    );
    let two = equivalent(Some(vec![2.0, 5.0]), Some(vec![1.0, 1.0]));
    assert_eq!(two.factors(), [1.0, 1.0]);
    tells("both", &complaint(true, vec![two]), "give either");
    let neither = equivalent(None, None);
    assert_eq!(neither.factors(), [1.0, 1.0]);
    tells("neither", &complaint(true, vec![neither]), "give either");
}

#[test]
fn what_a_file_need_not_say_is_not_written_and_what_departs_is() {
    let text = |change: &dyn Fn(&mut WingFile)| {
        let mut wing = wing();
        change(&mut wing);
        wing.written().expect("a file").text
    };
    let plain = text(&|_| ());
    for (field, change) in [
        ("servos:", &(|w: &mut WingFile| w.servos = Servos::None) as &dyn Fn(&mut WingFile)),
        ("known_to:", &|w| w.known_to.clock_s = 0.002),
        ("geometry:", &|w| w.geometry = Geometry::Nonlinear),
        ("prior:", &|w| w.correction.prior.reading = 0.5),
        ("stations:", &|w| w.stations = vec![station("a", 1.0)]),
        ("deflection:", &|w| w.deflection = vec![table(true, vec![row(20.0, &[5.0], &[1.0])])]),
        ("tip_grid:", &|w| w.tip_grid = Some(7)),
    ] {
        assert!(!plain.contains(field), "{field} in {plain}");
        let said = text(change);
        assert!(said.contains(field), "no {field} in {said}");
        let mut expected = wing();
        change(&mut expected);
        let read: WingFile = ron_file::parse("again.ron", &said).expect("it reads back");
        assert_eq!(WingFile { root_plane: None, ..read }, expected, "{field}");
    }
    assert_eq!(wing().written_name(), "wing.ron");
    assert_eq!(WingFile { path: "a/b.json".into(), ..wing() }.written_name(), "wing.json");
    assert_eq!(WingFile { path: "a/b.json".into(), ..wing() }.folder(), Path::new("a"));
    assert!((wing().pitch_axis_x() - 0.3).abs() < 1e-15 && wing().fairing_panel_ids().is_empty());
    assert_eq!(WingFile { pitch_axis_x_m: Some(1.5), ..wing() }.pitch_axis_x(), 1.5);
    let boxes = Boxes { chordwise: 4, spanwise: 2, strip_edges: None };
    assert_eq!(wing().planform().map(|planform| planform.boxes.clone()), Some(boxes));
}
