//! Deflection corrections in a wing's file: what is refused and where, and that a rewritten file is the same wing.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use coupling::WingFile;
use coupling::wing_file::{DeflectionRow, DeflectionTable, OutsideAirspeeds};
use std::path::{Path, PathBuf};

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex").join(name)
}

/// The shipped beam wing with `field` at its end, in a folder of its own.
struct Copy(PathBuf);

impl Copy {
    fn new(test: &str, change: impl Fn(&str) -> String) -> Self {
        let folder = std::env::temp_dir().join(format!("wingroot-deflection-{}-{test}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        for file in ["e214.dat", "beam_distribution.csv"] {
            std::fs::copy(data(file), folder.join(file)).unwrap();
        }
        let text = nastran::read_text(&data("wing_beam.ron")).unwrap();
        std::fs::write(folder.join("wing.ron"), change(&text)).unwrap();
        Self(folder)
    }

    fn with_field(test: &str, field: &str) -> Self {
        Self::new(test, |text| {
            let end = text.rfind(')').unwrap();
            format!("{}{field}\n)\n", &text[..end])
        })
    }

    fn read(&self) -> Result<WingFile, nastran::InputError> {
        WingFile::read(&self.0.join("wing.ron"))
    }
}

impl Drop for Copy {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

fn table(control: &str) -> DeflectionTable {
    let row = |v_m_s: f64, equivalent_deg: Vec<f64>| DeflectionRow {
        v_m_s,
        commanded_deg: vec![5.0, 15.0, 25.0],
        equivalent_deg: Some(equivalent_deg),
        factor: None,
    };
    DeflectionTable {
        control: control.to_owned(),
        odd: true,
        outside: OutsideAirspeeds::Refuse,
        rows: vec![row(18.0, vec![5.0, 13.25, 19.5]), row(30.0, vec![4.875, 12.5, 17.0])],
    }
}

#[test]
fn tables_that_cannot_be_are_refused_at_their_place() {
    let good = "deflection: [\n(control: \"inner\", rows: [\n(V_m_s: 18.0, commanded_deg: [5.0, 15.0], factor: [1.0, 0.9]),\n\
                (V_m_s: 30.0, commanded_deg: [5.0, 15.0], equivalent_deg: [5.0, 14.0]),\n])],";
    let first = {
        let copy = Copy::with_field("good", good);
        assert_eq!(copy.read().unwrap().deflection[0].rows[1].factors(), [1.0, 14.0 / 15.0]);
        nastran::read_text(&copy.0.join("wing.ron"))
            .unwrap()
            .lines()
            .position(|l| l.starts_with("deflection"))
            .unwrap()
            + 1
    };
    // What is replaced, by what, the line behind the field's first, the column, and what is said.
    for (test, from, to, line, column, said) in [
        ("control", "\"inner\"", "\"iner\"", 1, 11, "no control surface \"iner\""),
        ("factor", "0.9]", "-0.9]", 2, 43, "a factor of -0.9000"),
        ("length", "[5.0, 14.0]", "[5.0]", 3, 43, "1 numbers for 2 deflections"),
        ("ascend", "V_m_s: 30.0", "V_m_s: 18.0", 3, 2, "do not ascend"),
        ("airspeed", "V_m_s: 18.0", "V_m_s: -18.0", 2, 2, "V_m_s is -18.0"),
        ("zero", "[5.0, 15.0], factor", "[0.0, 15.0], factor", 2, 15, "zero"),
        ("descend", "[5.0, 15.0], factor", "[5.0, 5.0], factor", 2, 15, "must ascend"),
        ("odd", "[5.0, 15.0], factor", "[-5.0, 15.0], factor", 2, 15, "negative deflection in an odd table"),
        ("sided", "rows: [", "odd: false, rows: [", 2, 15, "both signs"),
        ("neither", ", factor: [1.0, 0.9]", "", 2, 15, "either equivalent_deg or factor"),
    ] {
        assert!(good.contains(from), "{test}");
        let copy = Copy::with_field(test, &good.replace(from, to));
        let error = copy.read().unwrap_err();
        let span = error.span.clone().unwrap();
        assert_eq!((span.line, span.column), (first + line, column), "{test}: {error}");
        assert!(error.message.contains(said) && error.help.is_some(), "{test}: {error}");
    }
}

#[test]
fn a_misspelt_control_is_suggested_and_a_second_table_of_one_refused() {
    let one = "(control: \"inner\", rows: [(V_m_s: 18.0, commanded_deg: [5.0], factor: [1.0])]),";
    let copy = Copy::with_field("suggest", &format!("deflection: [{}],", one.replace("inner", "innner")));
    assert_eq!(copy.read().unwrap_err().help.as_deref(), Some("did you mean \"inner\"?"));
    let copy = Copy::with_field("twice", &format!("deflection: [{one}{one}],"));
    assert!(copy.read().unwrap_err().message.contains("two deflection tables"));
}

#[test]
fn a_limit_that_cannot_be_is_refused_and_a_good_one_is_known() {
    let with = |limit: &str| {
        Copy::new(&format!("limit{limit}"), |text| {
            text.replace(
                "strips: (15, 28), chord_boxes: 3",
                &format!("strips: (15, 28), chord_boxes: 3, limit_deg: {limit}"),
            )
        })
    };
    assert_eq!(with("25.0").read().unwrap().deflection_limit_deg("inner"), Some(25.0));
    assert_eq!(with("25.0").read().unwrap().deflection_limit_deg("outer"), None);
    assert!(with("-25.0").read().unwrap_err().message.contains("limit_deg -25.0"));
}

#[test]
fn a_rewritten_file_keeps_its_comments_and_is_the_same_wing_with_the_tables() {
    for name in ["wing_beam.ron", "wing.ron"] {
        let wing = WingFile::read(&data(name)).unwrap();
        let tables = vec![table("inner"), table("outer")];
        let rewritten = wing.with_deflection(tables.clone()).unwrap();
        assert!(
            rewritten.text.contains("// Axes: x aft, y to the right tip, z up."),
            "{name}: comments are kept"
        );
        let copy = Copy::new(&format!("rewritten-{name}"), |_| rewritten.text.clone());
        for (file, from) in &rewritten.beside {
            std::fs::copy(from, copy.0.join(file)).unwrap();
        }
        let read = copy.read().unwrap();
        assert_eq!(read.deflection, tables);
        assert_ne!(read.hash, wing.hash);
        let as_before = WingFile {
            deflection: Vec::new(),
            path: wing.path.clone(),
            hash: wing.hash.clone(),
            ..read.clone()
        };
        assert_eq!(as_before, wing);
        // A file that has tables already is written anew, and is the same wing too.
        let again = read.with_deflection(vec![table("middle")]).unwrap();
        let second = Copy::new(&format!("again-{name}"), |_| again.text.clone());
        let second_read = second.read().unwrap();
        assert_eq!(second_read.deflection, [table("middle")]);
        let as_before = WingFile {
            deflection: Vec::new(),
            path: wing.path.clone(),
            hash: wing.hash.clone(),
            ..second_read
        };
        assert_eq!(as_before, wing);
    }
}

#[test]
fn a_rewritten_deck_wing_names_its_deck_by_the_absolute_path() {
    let copy = Copy::new("deck", |_| {
        "Wing(name: \"deck\", source: Deck((file: \"wing.bdf\")), balance: (x_m: 0.0, y_m: 0.0, z_m: 0.0), \
         correction: (chord_strips: 1, span_order: 1))\n"
            .to_owned()
    });
    std::fs::write(copy.0.join("wing.bdf"), "BEGIN BULK\nGRID,1,,0.,0.,0.\nENDDATA\n").unwrap();
    let wing = copy.read().unwrap();
    let rewritten = wing.with_deflection(vec![table("AIL1")]).unwrap();
    assert!(rewritten.beside.is_empty());
    let path = copy.0.join("wing.bdf");
    assert!(rewritten.text.contains(&format!("{:?}", path.to_string_lossy())), "{}", rewritten.text);
    let again: WingFile = nastran::ron_file::parse("again.ron", &rewritten.text).unwrap();
    assert_eq!(again.deflection, [table("AIL1")]);
}
