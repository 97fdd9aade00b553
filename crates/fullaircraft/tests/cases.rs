//! A grid of cases: how often the aircraft is factorised, what the envelope is made of, and input that makes no sense.

use crate::common::{beam_wing, path, whole};
use fullaircraft::cases::envelope::load_envelope;
use fullaircraft::cases::list::groups;
use fullaircraft::{Aircraft, AircraftError, Case, CaseFlight, CaseResult, CasesFile, TrimTools};

/// The shipped grid without what is flown in time.
fn shipped() -> CasesFile {
    CasesFile::read(&path().with_file_name("cases.ron")).expect("shipped files are right")
}

fn fly(cases: &[Case], tools: &TrimTools<'_>) -> Vec<CaseResult> {
    let (initial, updated) = (tools.aircraft.uncorrected(), tools.aircraft.uncorrected());
    let flight = CaseFlight { tools, models: [&initial, &updated], air: None, limits: None };
    let mut results = Vec::new();
    for group in groups(cases) {
        let mut keep = |_: &Case, result: CaseResult| {
            results.push(result);
            Ok::<(), AircraftError>(())
        };
        flight.fly(&group, &mut keep).expect("a result for each");
    }
    results.sort_by_key(|result| result.number);
    results
}

#[test]
fn one_factorisation_serves_all_cases_of_a_model_at_an_airspeed() {
    let file = shipped();
    let tools = TrimTools::new(whole(), &file.stations).unwrap();
    let cases: Vec<Case> = file.cases().into_iter().filter(|case| !case.is_dynamic()).collect();
    let results = fly(&cases, &tools);
    assert_eq!(results.len(), cases.len());
    assert_eq!(tools.factorisations(), 2 * file.airspeeds_v_m_s.len());
    assert!(results.iter().all(|result| result.refused.is_none()), "the shipped cases can all be trimmed");
}

#[test]
fn the_envelope_is_what_a_search_through_all_cases_finds() {
    let file = shipped();
    let tools = TrimTools::new(whole(), &file.stations).unwrap();
    let cases: Vec<Case> = file.cases().into_iter().filter(|case| !case.is_dynamic()).collect();
    let results = fly(&cases, &tools);
    let envelope = load_envelope(&results);
    // two models, right and left root and three stations a side, three loads, two ends
    assert_eq!(envelope.len(), 2 * 8 * 3 * 2);
    for extreme in &envelope {
        let given = results.iter().find(|result| result.number == extreme.case).unwrap();
        assert_eq!(given.label(), extreme.flown);
        for result in results.iter().filter(|result| result.model == extreme.model) {
            let place = result.loads.iter().find(|place| place.station == extreme.station).unwrap();
            let range = match extreme.load {
                "Fz_N" => place.fz_n,
                "Mx_Nm" => place.mx_nm,
                _ => place.my_nm,
            };
            let inside =
                if extreme.end == "smallest" { range[0] >= extreme.value } else { range[1] <= extreme.value };
            assert!(inside, "{extreme:?} {place:?}");
        }
    }
}

#[test]
fn a_maneuver_in_time_loads_every_station_around_the_load_of_its_trim() {
    let file = shipped();
    let mut aircraft = Aircraft::read(&path(), Some(&beam_wing())).unwrap();
    aircraft.wing.stations.extend(file.stations.iter().cloned());
    let tools = TrimTools::new(&aircraft, &[]).unwrap();
    let cases = file.cases();
    let level = cases.iter().find(|case| case.maneuver() == "level").expect("level flight is in the grid");
    let is_flown = |case: &&Case| case.is_dynamic() && (case.model, case.v_m_s) == (level.model, level.v_m_s);
    let moving = cases.iter().find(is_flown).expect("a maneuver in time is in the grid");
    let mut results = fly(&[level.clone(), moving.clone()], &tools);
    let (flown, steady) = (results.pop().unwrap(), results.pop().unwrap());
    assert_eq!(flown.loads.len(), tools.stations.len());
    for before in &steady.loads {
        let found = flown.loads.iter().find(|loads| loads.station == before.station).unwrap();
        let ranges = [found.fz_n, found.mx_nm, found.my_nm];
        for (range, [steady, _]) in ranges.into_iter().zip([before.fz_n, before.mx_nm, before.my_nm]) {
            let slack = 1e-6 * steady.abs();
            assert!(range[0] <= steady + slack && steady <= range[1] + slack, "{range:?} {steady}");
            assert!(range[1] - range[0] > 0.01 * steady.abs(), "{}: nothing moves", before.station);
        }
    }
}

#[test]
fn a_grid_that_makes_no_sense_is_refused_by_its_place() {
    let folder = std::env::temp_dir().join(format!("wingroot-cases-file-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let text = std::fs::read_to_string(path().with_file_name("cases.ron")).unwrap();
    let refused = |from: &str, to: &str| {
        let file = folder.join("cases.ron");
        std::fs::write(&file, text.replacen(from, to, 1)).unwrap();
        CasesFile::read(&file).unwrap_err().to_string()
    };
    assert!(refused("[22.0,", "[-22.0,").contains("airspeeds_V_m_s"));
    for (from, to, said) in [
        ("[22.0,", "[25.7,", "25.7 stands twice in `airspeeds_V_m_s`"),
        ("[-2.0, -1.0", "[-1e9, -1.0", "-1000000000.0 in `load_factors`"),
        ("[22.0, 25.7, 30.0, 34.0, 37.0, 40.0]", "[]", "there is no airspeed"),
        ("angles_deg: [5.0]", "angles_deg: [500.0]", "angles up to 90 degrees"),
    ] {
        assert!(refused(from, to).contains(said), "{}", refused(from, to));
    }
    let many: Vec<String> = (0..60_000).map(|i| format!("{}", f64::from(i) / 1000.0)).collect();
    let said = refused("[30.0, 60.0]", &format!("[{}]", many.join(", ")));
    assert!(said.contains("cases, and 5000000 are the most of a file"), "{said}");
    assert!(refused("frequency_hz: 5.0", "frequency_hz: 0.0").contains("maneuvers"));
    assert!(refused("Level,", "Levle,").contains("Levle"));
    assert!(refused("y_m: 0.45", "y_m: inf").contains("inf"));
    std::fs::remove_dir_all(&folder).unwrap();
}
