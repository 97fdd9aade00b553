//! Envelopes and tables of cases made by hand.

use super::{CaseColumns, Extreme, LOADS, LoadEnvelope, envelope_csv, load_envelope};
use crate::cases::grid::{CaseResult, StationLoads};
use std::collections::BTreeMap;

fn station(name: &str, from: f64) -> StationLoads {
    let pair = |at: f64| [from + at, from + at + 1.0];
    StationLoads { station: name.to_owned(), fz_n: pair(0.0), mx_nm: pair(2.0), my_nm: pair(4.0) }
}

fn result(number: usize, model: &str, loads: Vec<StationLoads>) -> CaseResult {
    CaseResult {
        number,
        model: model.to_owned(),
        maneuver: "pull \"up\"".to_owned(),
        v_m_s: 30.0,
        load_factor: 2.5,
        refused: None,
        values: BTreeMap::new(),
        tip_deflection_m: Vec::new(),
        loads,
        warnings: Vec::new(),
    }
}

#[test]
fn an_envelope_keeps_the_furthest_of_each_end_and_the_first_of_two_alike() {
    let all = [
        result(0, "initial", vec![station("root", 10.0), station("tip", 0.0)]),
        result(1, "initial", vec![station("root", 20.0), station("tip", 0.0)]),
        result(2, "initial", vec![station("root", 5.0)]),
        result(3, "updated", vec![station("root", 7.0)]),
    ];
    let found = load_envelope(&all);
    assert_eq!(found.len(), 18);
    let end = |model: &str, place: &str, load: &str, end: &str| {
        let one = found.iter().find(|e| (&*e.model, &*e.station, e.load, e.end) == (model, place, load, end));
        one.map(|one| (one.value, one.case)).expect("it is there")
    };
    for (at, load) in LOADS.into_iter().enumerate() {
        let at = 2.0 * at as f64;
        assert_eq!(end("initial", "root", load, "smallest"), (5.0 + at, 2));
        assert_eq!(end("initial", "root", load, "largest"), (21.0 + at, 1));
        assert_eq!(end("initial", "tip", load, "smallest"), (at, 0));
        assert_eq!(end("initial", "tip", load, "largest"), (1.0 + at, 0));
        assert_eq!(end("updated", "root", load, "largest"), (8.0 + at, 3));
    }
    assert_eq!(found[0].flown, "pull \"up\", 30 m/s, n = 2.5");
    assert!(LoadEnvelope::default().extremes().is_empty());
}

#[test]
fn the_same_end_of_the_same_load_at_the_same_station_is_the_same_of_either_model() {
    let of = |model: &str, station: &str, load: &'static str, end: &'static str| Extreme {
        model: model.to_owned(),
        station: station.to_owned(),
        load,
        end,
        value: 1.0,
        case: 0,
        flown: String::new(),
        interval_90: None,
    };
    let one = of("initial", "root", "Fz_N", "largest");
    assert!(one.is_end_of(&of("updated", "root", "Fz_N", "largest")));
    assert!(!one.is_end_of(&of("initial", "tip", "Fz_N", "largest")));
    assert!(!one.is_end_of(&of("initial", "root", "Mx_Nm", "largest")));
    assert!(!one.is_end_of(&of("initial", "root", "Fz_N", "smallest")));
    let plain = envelope_csv(std::slice::from_ref(&one));
    assert_eq!(plain, "model,station,load,end,value,case,flown\ninitial,root,Fz_N,largest,1,0,\"\"\n");
    let known = Extreme { interval_90: Some([0.5, 1.5]), ..one.clone() };
    let text = envelope_csv(&[one, known]);
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(lines[0], "model,station,load,end,value,case,flown,low_90,high_90");
    assert_eq!(
        lines[1..],
        ["initial,root,Fz_N,largest,1,0,\"\",,", "initial,root,Fz_N,largest,1,0,\"\",0.5,1.5"]
    );
}

#[test]
fn a_row_of_the_table_has_values_tips_and_both_ends_of_each_load_under_their_names() {
    let mut full = result(4, "initial", vec![station("root", 10.0), station("the tip", 20.0)]);
    full.values = [("alpha_deg".to_owned(), 3.0), ("n_z".to_owned(), 2.5)].into();
    full.tip_deflection_m = vec![[0.1, 0.2], [0.3, 0.4]];
    let mut refused = result(5, "updated", vec![station("the tip", 1.0)]);
    refused.refused = Some("it \"diverges\"".to_owned());
    refused.tip_deflection_m = vec![[0.7, 0.8]];
    let mut columns = CaseColumns::default();
    for one in [&refused, &full, &refused] {
        columns.add(one);
    }
    let names = columns.names();
    assert_eq!(names[..4], ["alpha_deg", "n_z", "right_tip_min_m", "right_tip_max_m"]);
    assert_eq!(names[4..8], ["left_tip_min_m", "left_tip_max_m", "root_Fz_N_min", "root_Fz_N_max"]);
    assert_eq!((names.len(), names[17].as_str()), (18, "the_tip_My_Nm_max"));
    let all = [3.0, 2.5, 0.1, 0.2, 0.3, 0.4, 10., 11., 12., 13., 14., 15., 20., 21., 22., 23., 24., 25.];
    assert_eq!(columns.numbers(&full), all.map(Some).to_vec());
    let law: Vec<Option<f64>> = [None, None, Some(0.7), Some(0.8), None, None]
        .into_iter()
        .chain([None; 6])
        .chain([1.0, 2.0, 3.0, 4.0, 5.0, 6.0].map(Some))
        .collect();
    assert_eq!(columns.numbers(&refused), law);
    let row = columns.csv_row(&refused);
    assert_eq!(row, "5,updated,\"pull \"up\"\",30,2.5,\"it 'diverges'\",,,0.7,0.8,,,,,,,,,1,2,3,4,5,6\n");
    assert_eq!(columns.csv_head().matches(',').count(), row.matches(',').count());
}
