//! `loads`: a small plan flown, its package and its round trip, a new selection that flies nothing, and input that makes no sense.

use crate::package_peers::{Cut, read_by_pynastran, solved_by_mystran};
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

const PLAN: &str = r#"Cases(
    name: "a small plan",
    rules: Vla,
    design_speeds_EAS_m_s: (VA: 34.0, VC: 37.0, VD: 46.0),
    limit_load_factors: (n1: 3.8, n2: -1.5),
    lift: (cl_max: 1.3, cl_min: -0.9),
    altitudes_m: [0.0],
    masses: [(name: "full", mass_kg: 20.0), (name: "light", mass_kg: 18.0)],
    maneuvers: [Roll(control: "outer", rates_deg_s: [60.0])],
    gusts: [
        Discrete(at: [VC], gradients_m: Of([4.0, 9.0, 20.0]), directions: [Up, Lateral], refine: true),
        Turbulence(at: [VC], cut_off_hz: 30.0, directions: [Up, Lateral]),
    ],
    gust_speeds: Some((U_ref_m_s: 8.0, F_g: 1.0, U_sigma_ref_m_s: 25.0)),
    stations: [(name: "half", y_m: 0.9, x_m: 0.42)],
)
"#;

fn folder(name: &str) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("wingroot-loads-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder of our own");
    folder
}

fn loads(words: &[&str], out: &Path) -> Output {
    Command::new(env!("CARGO_BIN_EXE_wingroot"))
        .args(["loads", "--out"])
        .arg(out)
        .args(words)
        .current_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("../.."))
        .output()
        .expect("the command starts")
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned() + &String::from_utf8_lossy(&output.stdout)
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// Cells of the rows of a table that begin so.
fn rows(text: &str, beginning: &str) -> Vec<Vec<String>> {
    let own = text.lines().filter(|line| line.starts_with(beginning));
    own.map(|line| line.split(',').map(str::to_owned).collect()).collect()
}

fn number(cell: &str) -> f64 {
    cell.parse().unwrap_or_else(|_| panic!("{cell} is no number"))
}

/// The largest load in turbulence is an instant of its case, and selected.csv names the load at its limit.
fn limits_of_turbulence_are_instants(out: &Path) {
    let table = read(&out.join("turbulence.csv"));
    let stations = read(&out.join("station_loads.csv"));
    let of_right_root = |load: &str| {
        rows(&table, "updated,")
            .into_iter()
            .filter(|row| row[2] == "right root" && row[3] == load)
            .collect::<Vec<_>>()
    };
    assert_eq!(of_right_root("Fz_N").len(), 4, "two masses, two axes: {table}");
    for row in of_right_root("Mx_Nm") {
        let [one_g, a, u, smallest, largest] = [4, 5, 6, 7, 8].map(|at| number(&row[at]));
        assert!(
            a > 0.0
                && (largest - one_g - u * a).abs() < 1e-6 * largest.abs()
                && (one_g - u * a - smallest).abs() < 1e-6 * largest.abs()
        );
        let own = rows(&stations, &format!("updated,{},", row[1]));
        let mx =
            own.iter().filter(|row| row[4] == "right root" && row[5] == "net").map(|row| number(&row[9]));
        let (low, high) =
            mx.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), mx| (low.min(mx), high.max(mx)));
        let size = 1e-8 * (largest - smallest);
        assert!(
            (high - largest).abs() < size && (low - smallest).abs() < size,
            "{low} to {high} for {smallest} to {largest}"
        );
    }
    let selected = read(&out.join("selected.csv"));
    assert!(
        selected.contains(",right root Mx largest,") || selected.contains(",left root Mx smallest,"),
        "{selected}"
    );
    assert!(read(&out.join("correlation.csv")).lines().count() > 100);
}

/// A gradient between those of the plan is flown, loads more than they do, and is in the package's tables.
fn gradients_are_searched_for(out: &Path) {
    let gusts = read(&out.join("gusts.csv"));
    let between = rows(&gusts, "updated,")
        .into_iter()
        .filter(|row| !["4.0000", "9.0000", "20.0000"].contains(&row[5].as_str()));
    let between: Vec<Vec<String>> = between.collect();
    assert!(!between.is_empty() && between.iter().all(|row| row[8] == "yes"), "{gusts}");
    let of_plan =
        rows(&gusts, "updated,").into_iter().filter(|row| row[5] == "4.0000" || row[5] == "20.0000");
    assert!(of_plan.into_iter().all(|row| row[8].starts_with("no")), "{gusts}");
}

#[test]
fn a_plan_is_flown_into_a_package_that_gives_the_loads_back_and_a_new_selection_flies_nothing() {
    let folder = folder("flown");
    let (plan, out) = (folder.join("plan.ron"), folder.join("out"));
    std::fs::write(&plan, PLAN).expect("a file of our own");
    let plan = plan.to_str().expect("a name");
    let wing = ["--wing", "data/tuflex/wing_beam.ron"];
    let output = loads(&[wing[0], wing[1], "--plan", plan], &out);
    assert!(output.status.success(), "{}", said(&output));
    let result: serde_json::Value = serde_json::from_str(&read(&out.join("result.json"))).expect("JSON");
    let number = |path: &str| result.pointer(path).and_then(serde_json::Value::as_f64).expect("a number");
    assert!(number("/round_trip/stations") < 1e-9 && number("/round_trip/stations") > 0.0);
    assert!(number("/round_trip/balance") < 1e-9 && number("/round_trip/tip") < 1e-9);
    assert_eq!(result["failed"].as_array().map(Vec::len), Some(0), "{result}");
    // every case of the matrix has a status
    let cases = read(&out.join("cases.csv"));
    assert_eq!(Some((cases.lines().count() - 1) as u64), result["cases"].as_u64());
    let status = |word: &str| cases.lines().filter(|line| line.contains(&format!(",{word},"))).count() as u64;
    assert_eq!(Some(status("flown")), result["flown"].as_u64());
    assert!(status("planned") == 0 && status("left_out") < 3, "{cases}");
    limits_of_turbulence_are_instants(&out);
    gradients_are_searched_for(&out);
    // one file a load set, numbered from one, each with its origin
    let package = out.join("package");
    let index = read(&package.join("index.bdf"));
    let selected = result["selected"].as_array().expect("a list");
    assert!(selected.len() > 5, "{} load sets", selected.len());
    for sid in 1..=selected.len() {
        let cards = read(&package.join(format!("case_{sid:05}.bdf")));
        assert!(cards.starts_with("$ wingroot ") && cards.contains("$ plan plan.ron "), "{cards}");
        assert!(index.contains(&format!("SUBCASE {sid}\n  SUBTITLE = case ")), "{index}");
    }
    let deck = nastran::read_deck(&package.join("index.bdf")).expect("it is read");
    let sets: Vec<u32> = (1..).take(selected.len()).collect();
    assert_eq!(deck.subcases.iter().map(|subcase| subcase.id).collect::<Vec<_>>(), sets);
    let trips = read(&package.join("round_trip.csv"));
    assert!(!trips.contains("not reproduced") && trips.contains("right tip,deflection_m"));
    let cut = Cut { station: "right half", beyond_y: 0.9, about: 0, unit_loads: [1.0, 1.0] };
    read_by_pynastran(&package, selected.len(), &cut);
    solved_by_mystran(&package, selected.len());
    // a new selection among what was flown
    let select = folder.join("select.ron");
    std::fs::write(&select, "Select(policies: [Envelope(loads: [Mx], stations: [\"right root\"])])")
        .expect("a file");
    let before = read(&out.join("envelope.csv"));
    let again = folder.join("again");
    let words = ["--from", out.to_str().expect("a name"), "--select", select.to_str().expect("a name")];
    let output = loads(&words, &again);
    assert!(output.status.success(), "{}", said(&output));
    assert_eq!(before, read(&out.join("envelope.csv")), "the envelope is a fact");
    let rows = read(&again.join("selection.csv"));
    assert_eq!(rows.lines().count(), 3, "two ends of one load: {rows}");
    for line in rows.lines().skip(1) {
        let mut cells = line.split(',');
        let value: f64 = cells.nth(3).and_then(|cell| cell.parse().ok()).expect("a load");
        let known = before.lines().filter(|row| row.starts_with("updated,right root,Mx_Nm,"));
        let known = known.filter_map(|row| row.split(',').nth(4)?.parse::<f64>().ok());
        assert!(known.into_iter().any(|end| (end - value).abs() < 1e-8 * value.abs()), "{value} is an end");
    }
    cards_of_a_new_selection_are_those_of_the_plan(&folder, &wing, plan, &select);
    std::fs::remove_dir_all(&folder).expect("ours");
}

/// Only the selected cases are flown again; what comes of them are the cards that the whole plan wrote for them.
fn cards_of_a_new_selection_are_those_of_the_plan(folder: &Path, wing: &[&str], plan: &str, select: &Path) {
    let (out, again) = (folder.join("out"), folder.join("cards"));
    let given =
        ["--from", out.to_str().expect("a name"), "--select", select.to_str().expect("a name"), "--cards"];
    let words = [&given[..], wing, &["--plan", plan]].concat();
    let output = loads(&words, &again);
    assert!(output.status.success(), "{}", said(&output));
    assert!(said(&output).contains("cases flown again for their loads at grids: 1"), "{}", said(&output));
    let package = again.join("package");
    assert!(!read(&package.join("round_trip.csv")).contains("not reproduced"));
    // what a set is, in words, and its cards without the number of the set
    let set = |path: &Path| {
        let text = read(path);
        let words = text.lines().find(|line| line.starts_with("$ case ")).expect("its words").to_owned();
        let instant = text.lines().find(|line| line.contains("; model ")).expect("its instant").to_owned();
        let cards: Vec<String> =
            text.lines().filter(|line| !line.starts_with('$')).map(without_set).collect();
        (words + &instant, cards)
    };
    let files = |package: &Path| -> Vec<PathBuf> {
        let all = std::fs::read_dir(package).expect("a package").flatten().map(|entry| entry.path());
        all.filter(|path| path.file_name().is_some_and(|name| name.to_string_lossy().starts_with("case_")))
            .collect()
    };
    let of_plan: std::collections::BTreeMap<_, _> =
        files(&out.join("package")).iter().map(|path| set(path)).collect();
    let selected = files(&package);
    assert_eq!(selected.len(), 2);
    for path in selected {
        let (words, cards) = set(&path);
        assert!(cards.len() > 10 && of_plan.get(&words) == Some(&cards), "{words}");
    }
    // results of another plan
    let other = folder.join("other.ron");
    std::fs::write(&other, PLAN.replacen("VC: 37.0", "VC: 36.0", 1)).expect("a file");
    let words = [&given[..], wing, &["--plan", other.to_str().expect("a name")]].concat();
    let output = loads(&words, &folder.join("none"));
    assert_eq!(output.status.code(), Some(2), "{}", said(&output));
    assert!(said(&output).contains("another plan"), "{}", said(&output));
}

/// A card without the number of its load set.
fn without_set(line: &str) -> String {
    match line.split_at_checked(8) {
        Some(("FORCE*  " | "MOMENT* ", fields)) => line[..8].to_owned() + &fields[16..],
        _ => line.to_owned(),
    }
}

#[test]
fn a_plan_that_makes_no_sense_ends_with_a_sentence_and_status_2() {
    let folder = folder("wrong");
    let plan = folder.join("plan.ron");
    let change = |from: &str, to: &str| {
        assert!(PLAN.contains(from), "{from}");
        PLAN.replacen(from, to, 1)
    };
    for (text, said_of) in [
        (change("mass_kg: 20.0", "mass_kg: 0.0"), "mass"),
        (change("VD: 46.0", "VD: 30.0"), "VD"),
        (change("Of([4.0, 9.0, 20.0])", "Of([4.0, -9.0])"), "gradient"),
        (change("y_m: 0.9", "y_m: 9.0"), "outboard"),
        (change("rules: Vla,", ""), "rules"),
        (change("name: \"half\"", "name: \"root\""), "two stations"),
        (change("mass_kg: 18.0", "mass_kg: 18.0, z_cg_m: 0.1"), "z_cg_m"),
        // nothing to fly
        (change("altitudes_m: [0.0]", "altitudes_m: []"), "there is no altitude"),
        (
            change(
                "masses: [(name: \"full\", mass_kg: 20.0), (name: \"light\", mass_kg: 18.0)]",
                "masses: []",
            ),
            "there is no mass",
        ),
    ] {
        std::fs::write(&plan, text).expect("a file of our own");
        let words = ["--wing", "data/tuflex/wing_beam.ron", "--plan", plan.to_str().expect("a name")];
        let output = loads(&words, &folder.join("out"));
        assert_eq!(output.status.code(), Some(2), "{said_of}: {}", said(&output));
        assert!(said(&output).contains(said_of), "{said_of}: {}", said(&output));
        // without `rules` there is no line to name
        let place = if said_of == "rules" { "plan.ron: " } else { "plan.ron:" };
        let after = said(&output).split_once(place).map(|(_, rest)| rest.chars().next());
        let is_named = after.flatten().is_some_and(|first| said_of == "rules" || first.is_ascii_digit());
        assert!(is_named, "file and line, {said_of}: {}", said(&output));
        assert!(!folder.join("out").exists(), "nothing is written");
    }
    std::fs::remove_dir_all(&folder).expect("ours");
}
