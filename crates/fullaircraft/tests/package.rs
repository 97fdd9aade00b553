//! Cards of cases: a cantilever's closed form through them, and the round trip of trims and of a gust's instants.

use crate::common::{air, whole};
use coupling::wing_file::StationAt;
use fullaircraft::flight::loads::LoadedTrim;
use fullaircraft::package::cards::{CardCase, CardPart, index, structure};
use fullaircraft::package::round_trip::{Expected, RoundTrip, Row, round_trip_csv};
use fullaircraft::{
    Aircraft, Component, FlightLoads, FlightPoint, Gust, GustAxis, NodalLoads, Station, Steady, TrimTools,
};

const V_M_S: f64 = 30.0;

fn stations(aircraft: &Aircraft) -> Vec<Station> {
    let point = StationAt { name: "half".to_owned(), x_m: Some(0.42), y_m: 0.9, z_m: None };
    let mut all = aircraft.wing_stations(&[point]).expect("it is on the wing");
    all.extend(aircraft.body_stations());
    all
}

fn case(sid: u32, words: &str, loads: &NodalLoads) -> CardCase {
    CardCase { sid, words: words.to_owned(), net: loads.of(Component::Net), parts: Vec::new() }
}

fn expected(aircraft: &Aircraft, stations: &[Station], net: &[f64], tips_m: [f64; 2]) -> Expected {
    let points = aircraft.free.points();
    Expected {
        stations: stations.iter().map(|station| station.sums(points, net)).collect(),
        tips_m: tips_m.to_vec(),
    }
}

fn worst(rows: &[Row]) -> f64 {
    rows.iter().map(|row| row.of_largest).fold(0.0, f64::max)
}

/// Trims of the aircraft, with their tips as the trim has them.
fn trims(aircraft: &Aircraft) -> Vec<(CardCase, [f64; 2])> {
    let tools = TrimTools::new(aircraft, &[]).expect("it is trimmed");
    let model = aircraft.uncorrected();
    let at = tools.at(&model, V_M_S).expect("it is trimmed");
    let control = || "outer".to_owned();
    let all = [
        Steady::Pull { load_factor: 3.8 },
        Steady::Pull { load_factor: -1.5 },
        Steady::Roll { load_factor: 1.0, rate_deg_s: 60.0, control: control() },
        Steady::Sideslip { load_factor: 1.0, beta_deg: 5.0, control: control() },
    ];
    let mut cases = Vec::new();
    for (sid, steady) in (1..).zip(all) {
        let found = at.solve(&steady.case(&aircraft.file, V_M_S)).expect("it is trimmed");
        cases.push((case(sid, steady.kind(), &at.nodal_loads(&found)), at.tip_deflection_m(&found)));
    }
    cases
}

#[test]
fn cards_of_trims_read_back_give_the_stations_the_balance_and_the_tips() {
    let aircraft = whole();
    let stations = stations(aircraft);
    let back = RoundTrip::new(aircraft, &stations, &structure(aircraft, &["a test".to_owned()])).unwrap();
    for (case, tips_m) in trims(aircraft) {
        let expected = expected(aircraft, &stations, &case.net, tips_m);
        let rows = back.compare(&case, &case.text(aircraft.free.node_ids(), &[]), &expected).unwrap();
        assert_eq!(rows.len(), 6 * stations.len() + 6 + 2 + 1);
        assert!(rows.iter().all(Row::holds), "{}: {}\n{}", case.words, worst(&rows), round_trip_csv(&rows));
        assert!(tips_m[0].abs() > 0.01, "the tips move: {tips_m:?} m");
    }
}

#[test]
fn cards_of_instants_in_a_gust_read_back_give_the_stations_the_balance_and_the_tips() {
    let aircraft = whole();
    let stations = stations(aircraft);
    let tools = TrimTools::new(aircraft, &[]).unwrap();
    let model = aircraft.uncorrected();
    let at = tools.at(&model, V_M_S).unwrap();
    let found = at.solve(&Steady::Level.case(&aircraft.file, V_M_S)).unwrap();
    let point = FlightPoint { v_m_s: V_M_S, load_factor: 1.0, pitch_rate_deg_s: 0.0 };
    let trimmed = at.trimmed(&found, &point);
    let trim = LoadedTrim {
        model: &model,
        air: air(),
        trimmed: &trimmed,
        steady: at.nodal_loads(&found),
        drives: vec![],
        axis: GustAxis::Vertical,
    };
    let flight = FlightLoads::new(trim, stations.clone(), 0.002).unwrap();
    let flown = flight.fly(Some(Gust { velocity_m_s: 5.0, length_m: 6.0, start_s: 0.0 }), &[], 200);
    let back = RoundTrip::new(aircraft, &stations, &structure(aircraft, &[])).unwrap();
    let tips = back.tips();
    let [low, high] = flown.ends(0, 3);
    assert!(low != high);
    for (sid, sample) in [(1, low), (2, high), (3, 133)] {
        let case = case(sid, "gust", &flown.nodal_loads(sample));
        let net_at = |station| flown.at_station(station, Component::Net, sample);
        let tip = |side| case.net.iter().enumerate().map(|(dof, load)| tips[(dof, side)] * load).sum();
        let expected =
            Expected { stations: (0..stations.len()).map(net_at).collect(), tips_m: vec![tip(0), tip(1)] };
        let rows = back.compare(&case, &case.text(aircraft.free.node_ids(), &[]), &expected).unwrap();
        assert!(rows.iter().all(Row::holds), "sample {sample}: {}\n{}", worst(&rows), round_trip_csv(&rows));
        // modes that are kept move the tips as all loads together do: what is left are the modes that are not kept
        let by_modes = flown.tip_deflection_m(sample);
        for side in [0, 1] {
            let off = (by_modes[side] - expected.tips_m[side]).abs();
            assert!(
                off < 0.02 * by_modes[side].abs(),
                "{by_modes:?} m by modes, {:?} by loads",
                expected.tips_m
            );
        }
    }
}

#[test]
fn a_spoilt_card_or_structure_is_found() {
    let aircraft = whole();
    let stations = stations(aircraft);
    let text = structure(aircraft, &[]);
    let back = RoundTrip::new(aircraft, &stations, &text).unwrap();
    let (case, tips_m) = trims(aircraft).swap_remove(0);
    let expected = expected(aircraft, &stations, &case.net, tips_m);
    let cards = case.text(aircraft.free.node_ids(), &[]);
    // the fourth digit of the largest vertical force
    let line = cards
        .lines()
        .filter(|line| line.starts_with("* "))
        .max_by(|a, b| {
            let z = |line: &str| nastran::real::parse(line[40..].trim()).unwrap().abs();
            z(a).total_cmp(&z(b))
        })
        .unwrap();
    let (at, digit) = line.char_indices().skip(40).filter(|(_, c)| c.is_ascii_digit()).nth(3).unwrap();
    let next = char::from_digit((digit.to_digit(10).unwrap() + 1) % 10, 10).unwrap();
    let mut spoilt_line = line.to_owned();
    spoilt_line.replace_range(at..=at, &next.to_string());
    let spoilt = cards.replacen(line, &spoilt_line, 1);
    assert_ne!(spoilt, cards);
    let rows = back.compare(&case, &spoilt, &expected).unwrap();
    assert!(!rows.iter().all(Row::holds), "a spoilt card is not reproduced");
    assert!(rows.iter().any(|row| row.place == "balance" && !row.holds()), "nor in balance");
    // a load left out, one of another case
    let without = cards.replacen(line, "*                     0.              0.              0.", 1);
    assert!(!back.compare(&case, &without, &expected).unwrap().iter().all(Row::holds));
    let other = CardCase { sid: 9, ..case.clone() };
    let refused = back.compare(&case, &other.text(aircraft.free.node_ids(), &[]), &expected).unwrap_err();
    assert!(refused.to_string().contains("not of case 1"), "{refused}");
    // a structure a thousandth softer
    let soften = |line: &str| {
        let field = match line.get(..5) {
            Some("MAT1 ") => 16..24,
            Some("MAT1*") => 24..40,
            _ => return line.to_owned(),
        };
        let modulus = 0.999 * nastran::real::parse(&line[field.clone()]).unwrap();
        let (width, mut line) = (field.len(), line.to_owned());
        line.replace_range(field, &format!("{:>width$}", nastran::real::format(modulus, width)));
        line
    };
    let softer: String = text.lines().map(|line| soften(line) + "\n").collect();
    assert_ne!(softer, text);
    let back = RoundTrip::new(aircraft, &stations, &softer).unwrap();
    let rows = back.compare(&case, &cards, &expected).unwrap();
    assert!(rows.iter().any(|row| row.place == "structure" && !row.holds()), "a softer wing");
}

#[test]
fn the_index_has_a_subcase_for_each_case_and_reads_back() {
    let aircraft = whole();
    let cases: Vec<CardCase> = trims(aircraft).into_iter().map(|(case, _)| case).collect();
    let folder = std::env::temp_dir().join(format!("wingroot-package-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.join(name), text).unwrap();
    let origin = vec!["wingroot, a test\nof two lines".to_owned()];
    write("aircraft.bdf", &structure(aircraft, &origin));
    for case in &cases {
        write(&case.file(), &case.text(aircraft.free.node_ids(), &origin));
    }
    let text = index(aircraft, "loads", &cases, &origin);
    write("index.bdf", &text);
    let deck = nastran::read_deck(&folder.join("index.bdf")).unwrap();
    std::fs::remove_dir_all(&folder).unwrap();
    let numbers: Vec<u32> = deck.subcases.iter().map(|subcase| subcase.id).collect();
    assert_eq!(numbers, [1, 2, 3, 4]);
    assert_eq!(structure::load_sets(&deck), [1, 2, 3, 4]);
    assert!(deck.unknown.is_empty() && deck.panels.is_empty(), "a structure and its loads alone");
    for case in &cases {
        assert!(text.contains(&format!("SUBTITLE = {}\n  LOAD = {}\n", case.words, case.sid)), "{text}");
    }
    let longest = text.lines().map(str::len).max().unwrap();
    assert!(longest <= 80, "a line of {longest} characters");
}

#[test]
fn the_airs_loads_and_all_others_as_sets_of_their_own_add_up_to_the_net_loads() {
    let aircraft = whole();
    let stations = stations(aircraft);
    let back = RoundTrip::new(aircraft, &stations, &structure(aircraft, &[])).unwrap();
    let tools = TrimTools::new(aircraft, &[]).unwrap();
    let model = aircraft.uncorrected();
    let at = tools.at(&model, V_M_S).unwrap();
    let found = at.solve(&Steady::Pull { load_factor: 3.0 }.case(&aircraft.file, V_M_S)).unwrap();
    let loads = at.nodal_loads(&found);
    let mut case = case(1, "pull-up", &loads);
    let part = |sid, words, component| CardPart { sid, words, loads: loads.of(component) };
    case.parts = vec![part(2, "air", Component::Air), part(3, "inertia", Component::Inertia)];
    let text = case.text(aircraft.free.node_ids(), &[]);
    let deck = nastran::parse_deck("case", &text).unwrap();
    let of = |set: u32| -> f64 {
        deck.point_loads
            .iter()
            .filter(|card| card.set == set && !card.is_moment)
            .map(|card| card.vector.z)
            .sum()
    };
    let weight_n = coupling::GRAVITY_M_S2 * aircraft.mass.mass_kg;
    assert!(
        (of(2) / (3.0 * weight_n) - 1.0).abs() < 1e-6,
        "the air lifts three times the weight: {} N",
        of(2)
    );
    assert!(
        (of(3) / (3.0 * weight_n) + 1.0).abs() < 1e-6,
        "inertia and gravity pull as much down: {} N",
        of(3)
    );
    let expected = expected(aircraft, &stations, &case.net, at.tip_deflection_m(&found));
    let rows = back.compare(&case, &text, &expected).unwrap();
    assert!(rows.iter().all(Row::holds), "{}\n{}", worst(&rows), round_trip_csv(&rows));
    // a sum that forgets a part is found
    let forgets = text.replacen(",1.,2,1.,3", ",1.,2,.999,3", 1);
    assert_ne!(forgets, text);
    assert!(!back.compare(&case, &forgets, &expected).unwrap().iter().all(Row::holds));
}
