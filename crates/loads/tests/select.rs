//! Hulls, ends and policies beside `selection.json`, and laws of any selection.

use crate::common::{number, reference};
use loads::select::file::{Load, Model, Policy};
use loads::{Instant, SelectFile, Selection, select};
use proptest::prelude::*;
use serde_json::Value;
use std::collections::BTreeSet;

fn instants(loads: &[[f64; 3]]) -> Vec<Instant> {
    let one = |(case, [fz, mx, my]): (usize, &[f64; 3])| Instant {
        model: Model::Updated,
        case,
        instant: 1,
        loads: vec![[0.0, 0.0, *fz, *mx, *my, 0.0]],
    };
    loads.iter().enumerate().map(one).collect()
}

fn read(rows: &Value) -> Vec<[f64; 3]> {
    let row = |row: &Value| [0, 1, 2].map(|at| number(&row[at]));
    rows.as_array().expect("rows").iter().map(row).collect()
}

fn by(policies: Vec<Policy>) -> SelectFile {
    SelectFile { policies, ..SelectFile::default() }
}

fn at_root(file: &SelectFile, all: &[Instant]) -> Selection {
    select(file, &["root".into()], all).expect("a selection")
}

fn cases(selection: &Selection) -> BTreeSet<usize> {
    selection.selected.iter().map(|selected| selected.case).collect()
}

fn places(list: &Value) -> BTreeSet<usize> {
    serde_json::from_value(list.clone()).expect("a list of places")
}

const NAMED: [(&str, Load); 3] = [("Fz", Load::Fz), ("Mx", Load::Mx), ("My", Load::My)];

#[test]
fn hulls_and_ends_of_every_reference_set_are_the_same_cases() {
    for (name, set) in reference("selection.json")["cases"].as_object().unwrap() {
        let all = instants(&read(&set["loads_Fz_Mx_My"]));
        for (pair, expected) in set["hull"].as_object().unwrap() {
            let loads: Vec<Load> =
                pair.split(',').map(|load| NAMED.iter().find(|(own, _)| *own == load).unwrap().1).collect();
            let hull = by(vec![Policy::Hull { pairs: vec![(loads[0], loads[1])], stations: vec![] }]);
            let selection = at_root(&hull, &all);
            assert_eq!(cases(&selection), places(expected), "hull {pair} of {name}");
            let order: Vec<usize> = selection.drives.iter().map(|drive| drive.case).collect();
            let expected: Vec<usize> = serde_json::from_value(expected.clone()).unwrap();
            assert_eq!(order, expected, "corners of {pair} of {name}, counter-clockwise");
        }
        for (load, ends) in set["envelope"].as_object().unwrap() {
            let own = NAMED.iter().find(|(own, _)| own == load).unwrap().1;
            let envelope = by(vec![Policy::Envelope { loads: vec![own], stations: vec![] }]);
            let drives = at_root(&envelope, &all).drives;
            for (drive, end) in drives.iter().zip(["smallest", "largest"]) {
                assert_eq!(drive.case as u64, ends[end].as_u64().unwrap(), "{end} {load} of {name}");
            }
        }
        let selection = at_root(&SelectFile::default(), &all);
        assert_eq!(cases(&selection), places(&set["union_sorted"]), "union of {name}");
    }
}

#[test]
fn cases_within_some_percent_of_an_end_are_those_of_the_reference() {
    let margin = &reference("selection.json")["margin"];
    let loads: Vec<[f64; 3]> =
        margin["loads"].as_array().unwrap().iter().map(|load| [number(load), 0.0, 0.0]).collect();
    let within = by(vec![Policy::Within { percent: 5.0, loads: vec![Load::Fz], stations: vec![] }]);
    let expected =
        &places(&margin["within_5_percent_of_largest"]) | &places(&margin["within_5_percent_of_smallest"]);
    assert_eq!(cases(&at_root(&within, &instants(&loads))), expected);
}

#[test]
fn a_cap_keeps_all_ends_before_corners_of_hulls_and_says_what_is_uncovered() {
    let set = &reference("selection.json")["cases"]["random_40"];
    let all = instants(&read(&set["loads_Fz_Mx_My"]));
    let ends: BTreeSet<usize> = NAMED
        .iter()
        .flat_map(|(load, _)| ["smallest", "largest"].map(|end| set["envelope"][load][end].as_u64().unwrap()))
        .map(|case| usize::try_from(case).unwrap())
        .collect();
    for cap in ends.len()..13 {
        let file = SelectFile { at_most: Some(cap), ..SelectFile::default() };
        let selection = at_root(&file, &all);
        assert!(ends.is_subset(&cases(&selection)), "all ends with at most {cap}");
        assert_eq!(cases(&selection).len(), cap, "the hull has 13 cases");
        assert!(selection.uncovered().all(|drive| drive.policy == "hull"));
        assert!(selection.uncovered().count() > 0 && selection.csv().contains(",no\n"), "{cap}");
    }
    let two = SelectFile { at_most: Some(2), ..SelectFile::default() };
    let selection = at_root(&two, &all);
    assert!(selection.uncovered().any(|drive| drive.policy == "envelope"), "two cases cannot hold five ends");
}

#[test]
fn cases_asked_for_by_number_are_in_and_those_refused_are_out_with_the_reason() {
    let set = &reference("selection.json")["cases"]["random_40"];
    let all = instants(&read(&set["loads_Fz_Mx_My"]));
    let mut file = SelectFile::default();
    file.policies.push(Policy::Always { cases: vec![5], because: "certified before".into() });
    file.policies.push(Policy::Never { cases: vec![36], because: "flaps out".into() });
    let selection = at_root(&file, &all);
    let five = selection.selected.iter().find(|selected| selected.case == 5).unwrap();
    assert!(five.why[0].contains("certified before") && five.driven == 0, "{five:?}");
    assert!(!cases(&selection).contains(&36));
    assert_eq!(selection.never, [(36, "flaps out".to_owned())]);
    assert!(selection.drives.iter().all(|drive| drive.case != 36), "another case takes the end");
    file.at_most = Some(1);
    assert_eq!(cases(&at_root(&file, &all)), BTreeSet::from([5]), "what is asked for by number comes first");
}

#[test]
fn left_and_right_are_one_family_only_if_the_file_says_so() {
    let stations = ["right root".to_owned(), "left root".to_owned()];
    // The second case bends the left wing up further: Mx of the left is negative for that.
    let case = |case, right: f64, left: f64| Instant {
        model: Model::Updated,
        case,
        instant: 1,
        loads: vec![[0.0, 0.0, right, right, 0.0, 0.0], [0.0, 0.0, left, -left, 0.0, 0.0]],
    };
    let all = [case(1, 3.0, 2.0), case(2, 2.0, 5.0), case(3, 1.0, 1.0)];
    let ends = by(vec![Policy::Envelope { loads: vec![Load::Mx], stations: vec!["root".into()] }]);
    let apart = select(&ends, &stations, &all).unwrap();
    assert_eq!(apart.drives.len(), 4, "two ends on each side");
    assert_eq!(cases(&apart), BTreeSet::from([1, 2, 3]));
    let one = select(&SelectFile { mirror: true, ..ends }, &stations, &all).unwrap();
    assert_eq!(cases(&one), BTreeSet::from([2, 3]));
    let largest = one.drives.iter().find(|drive| drive.what.contains("largest")).unwrap();
    assert_eq!((largest.case, largest.values[0]), (2, 5.0));
    assert!(largest.what.contains("image of the left"), "{}", largest.what);
}

#[test]
fn a_thousand_cases_at_forty_stations_are_selected_in_two_seconds() {
    let stations: Vec<String> = (0..40).map(|at| format!("y {at}")).collect();
    let at = |case: usize, station: usize, load: usize| {
        let phase = (case * (7 + station) + 13 * load) as f64;
        (phase.sin() * 43_758.545_3).fract()
    };
    let loads = |case| (0..40).map(|station| std::array::from_fn(|load| at(case, station, load))).collect();
    let all: Vec<Instant> = (1..=1000)
        .map(|case| Instant { model: Model::Updated, case, instant: 1, loads: loads(case) })
        .collect();
    let start = std::time::Instant::now();
    let selection = select(&SelectFile::default(), &stations, &all).unwrap();
    assert!(selection.drives.len() > 40 * 12);
    assert!(start.elapsed().as_secs_f64() < 2.0, "{:?}", start.elapsed());
}

#[test]
fn a_station_or_a_case_that_is_not_there_is_refused() {
    let all = instants(&[[1.0, 2.0, 3.0]]);
    let select = |policy| select(&by(vec![policy]), &["root".into()], &all).unwrap_err();
    let error = select(Policy::Envelope { loads: vec![Load::Mx], stations: vec!["rot".into()] });
    assert!(error.message.contains("`rot`"), "{error}");
    let error = select(Policy::Always { cases: vec![9], because: String::new() });
    assert!(error.message.contains("case 9"), "{error}");
}

#[test]
fn a_file_of_the_documents_is_read_and_mistakes_are_refused_at_their_place() {
    let folder = std::env::temp_dir().join(format!("loads_select_{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let read = |text: &str| {
        let path = folder.join("select.ron");
        std::fs::write(&path, text).unwrap();
        SelectFile::read(&path)
    };
    let good = "Select(\n policies: [Envelope(loads: [Fz, Mx, My]), Hull(pairs: [(Fz, Mx), (Mx, My)], stations: [\"root\"]),\n \
                Always(cases: [17], because: \"certified before\")],\n mirror: false, at_most: Some(30), models: [Updated],\n \
                export: (at: Grids, components: [Net], factor: 1.0),\n)";
    let file = read(good).unwrap();
    assert_eq!((file.policies.len(), file.at_most), (3, Some(30)));
    for (from, to, words) in [
        ("Envelope", "Envelop", "Envelop"),
        ("Fz, Mx, My", "Fz, Mx, Mw", "Mw"),
        ("Some(30)", "Some(0)", "at most no case"),
        ("(Fz, Mx)", "(Fz, Fz)", "same load twice"),
        ("factor: 1.0", "factor: NaN", "NaN"),
    ] {
        let error = read(&good.replacen(from, to, 1)).unwrap_err();
        assert!(
            error.message.contains(words) && error.span.as_ref().is_some_and(|span| span.line > 0),
            "{error}"
        );
    }
    std::fs::remove_dir_all(&folder).unwrap();
}

fn grid() -> impl Strategy<Value = Vec<[f64; 3]>> {
    let value = (-6i32..=6).prop_map(f64::from);
    prop::collection::vec([value.clone(), value.clone(), value], 1..25)
}

proptest! {
    #[test]
    fn no_case_of_the_envelope_is_missing_from_a_selection(loads in grid()) {
        let selection = at_root(&SelectFile::default(), &instants(&loads));
        let kept = cases(&selection);
        for load in 0..3 {
            let of = |case: &usize| loads[*case][load];
            let all = loads.iter().map(|row| row[load]);
            prop_assert!(kept.iter().map(of).fold(f64::MIN, f64::max) == all.clone().fold(f64::MIN, f64::max));
            prop_assert!(kept.iter().map(of).fold(f64::MAX, f64::min) == all.fold(f64::MAX, f64::min));
        }
    }

    #[test]
    fn every_point_is_inside_the_hull_of_those_selected(loads in grid()) {
        // By the support function, which knows no hull: in every direction a corner reaches as far as any point.
        let pair = by(vec![Policy::Hull { pairs: vec![(Load::Fz, Load::Mx)], stations: vec![] }]);
        let kept = cases(&at_root(&pair, &instants(&loads)));
        for step in 0..360 {
            let (sin, cos) = f64::from(step).to_radians().sin_cos();
            let reach = |row: &[f64; 3]| cos * row[0] + sin * row[1];
            let all = loads.iter().map(reach).fold(f64::MIN, f64::max);
            let ours = kept.iter().map(|case| reach(&loads[*case])).fold(f64::MIN, f64::max);
            prop_assert!(ours >= all - 1e-12, "{step} degrees: {ours} beside {all}");
        }
    }

    #[test]
    fn an_inner_point_changes_nothing(loads in grid()) {
        let before = cases(&at_root(&SelectFile::default(), &instants(&loads)));
        let mean = [0, 1, 2].map(|at| {
            let first = loads[0][at];
            // The middle of two points of the set is inside or on an edge, or one of them again.
            f64::midpoint(first, loads[loads.len() / 2][at])
        });
        let mut more = loads.clone();
        more.push(mean);
        prop_assert_eq!(before, cases(&at_root(&SelectFile::default(), &instants(&more))));
    }

    #[test]
    fn the_order_of_cases_changes_no_set(loads in grid(), cap in 1usize..20) {
        let file = SelectFile { at_most: Some(cap), ..SelectFile::default() };
        let mut all = instants(&loads);
        let before = at_root(&file, &all);
        all.reverse();
        prop_assert_eq!(before, at_root(&file, &all));
    }
}

#[test]
fn a_load_that_is_rounding_in_all_cases_sends_none_of_them_to_stress() {
    // a root that is loaded, and the whole in balance but for the last digits
    let stations = ["root".to_owned(), "whole".to_owned()];
    let one = |case: usize, root: f64, whole: f64| Instant {
        model: Model::Updated,
        case,
        instant: 1,
        loads: [root, whole].map(|load| [0.0, 0.0, load, 2.0 * load, -load, 0.0]).to_vec(),
    };
    let all = [one(1, 100.0, 1e-9), one(2, -50.0, 0.0), one(3, 10.0, 5e-8), one(4, 20.0, -9e-8)];
    let ends = Policy::Envelope { loads: vec![Load::Fz, Load::Mx], stations: vec![] };
    let hulls = Policy::Hull { pairs: vec![(Load::Fz, Load::My)], stations: vec![] };
    let selection = select(&by(vec![ends, hulls]), &stations, &all).expect("a selection");
    assert_eq!(cases(&selection), BTreeSet::from([1, 2]), "{:?}", selection.drives);
    assert!(selection.drives.iter().all(|drive| !drive.what.starts_with("whole")));
    // a thousandth of the largest is a load
    let alone = Policy::Envelope { loads: vec![Load::Fz], stations: vec![] };
    let all = [one(1, 100.0, 0.1), one(2, -50.0, 0.0)];
    let selection = select(&by(vec![alone]), &stations, &all).expect("a selection");
    assert_eq!(selection.drives.len(), 4);
}
