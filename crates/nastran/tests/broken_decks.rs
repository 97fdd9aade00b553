//! Broken decks: each gives one sentence that names the fault and its line, and none ends the program.

use crate::common::content;
use nastran::{Frames, parse_deck, read_deck, write_deck};
use std::path::PathBuf;

/// A good deck: a shell and solid box with springs and masses, one line a card where it fits.
const GOOD: &str = include_str!("good_deck.bdf");

/// What breaks, how (old text, new text), the words the message must have, and the line it must blame.
const BREAKS: &[(&str, &str, &str, usize)] = &[
    // Numbers.
    ("GRID,2,,1.,", "GRID,1,,1.,", "GRID 1 is given twice; the number or name is taken since good.bdf:7", 8),
    ("GRID,2,,1.,", "GRID,2,,1.O,", "`1.O` in field X1 of GRID is not a real number", 8),
    ("GRID,2,,1.,", "GRID,2,,1,", "`1` in field X1 of GRID is not a real number", 8),
    ("GRID,2,,1.,", "GRID,2,,1.+,", "`1.+` in field X1 of GRID is not a real number", 8),
    ("GRID,2,,1.,", "GRID,2,,1.+9999,", "`1.+9999` in field X1 of GRID is not a real number", 8),
    ("GRID,2,,1.,", "GRID,-2,,1.,", "`-2` in field ID of GRID is not a positive whole number", 8),
    ("GRID,2,,1.,", "GRID,0,,1.,", "`0` in field ID of GRID is not a positive whole number", 8),
    ("GRID,2,,1.,", "GRID,2.,,1.,", "`2.` in field ID of GRID is not a positive whole number", 8),
    ("GRID,2,,1.,", "GRID,99999999999,,1.,", "is not a positive whole number", 8),
    ("GRID,2,,1.,", "GRID,,,1.,", "field ID of GRID is empty", 8),
    ("GRID,2,,1.,", "GRID,2,6,1.,", "grid 2 refers to coordinate system 6, which is not defined", 8),
    ("GRID,2,,1.,0.,0.\n", "GRID,2,,1.,0.,0.,,789\n", "`789` in field PS of GRID is not a combination", 8),
    ("GRID,2,,1.,0.,0.\n", "GRID,2,,1.,0.,0.,,11\n", "`11` in field PS of GRID is not a combination", 8),
    ("GRID,2,,1.,0.,0.\n", "GRID,2,,1.,0.,0.,,,,,7\n", "at most 8 fields", 8),
    ("GRID,2,,1.,", "2,GRID,,1.,", "`2` is not the name of a card", 8),
    ("GRID,2,,1.,0.,0.\n", "GRID    2          1.0    0.0    0.0\n", "in field", 8),
    ("BEGIN BULK\n", "BEGIN BULK\n+,1.,2.\n", "a continuation without a card before it", 5),
    ("BEGIN BULK\n", "", "the deck has an executive or case control, but no BEGIN BULK", 2),
    ("BEGIN BULK\n", "BEGING BULK\n", "`BEGING BULK` is not BEGIN BULK, which the deck has nowhere", 4),
    ("BEGIN BULK\n", "BEGINBULK $ cards\n", "`BEGINBULK` is not BEGIN BULK", 4),
    // Shells and their properties.
    ("CQUAD4,1,1,1,2,3,4", "CQUAD4,1,1,1,2,3", "field G4 of CQUAD4 is empty", 15),
    ("CQUAD4,1,1,1,2,3,4", "CQUAD4,1,1,1,2,3,3", "grid 3 stands twice in CQUAD4 1", 15),
    ("CQUAD4,1,1,1,2,3,4", "CQUAD4,1,1,1,2,3,4,-5", "an angle with a decimal point or the whole number", 15),
    ("CQUAD4,1,1,1,2,3,4", "CQUAD4,1,1,1,2,3,4,,,+\n+,7", "always empty", 16),
    ("CQUAD4,1,1,1,2,3,4", "CQUAD4,1,1,1,2,3,4\n,,2", "`2` in field TFLAG of CQUAD4 is not 0 or 1", 16),
    (
        "CQUAD4,1,1,1,2,3,4",
        "CQUAD4,1,1,1,2,3,4\n,,,-.1",
        "in field T1 of CQUAD4 is not a thickness of zero or more",
        16,
    ),
    ("CTRIA3,2,", "CTRIA3,1,", "CTRIA3 1 has the number of another element, CQUAD4 1 at good.bdf:15", 16),
    ("PSHELL,1,1,.01,", "PSHELL,1,1,,", "field T of PSHELL is empty", 17),
    ("PSHELL,1,1,.01,", "PSHELL,1,1,-.01,", "`-.01` in field T of PSHELL is not above zero", 17),
    ("PSHELL,1,1,.01,1,,1", "PSHELL,1,1,.01,,,1", "a shear material (MID3) but no bending material", 17),
    ("PSHELL,1,1,.01,1,", "PSHELL,1,1,.01,-1,", "plane strain", 17),
    ("PCOMP,2,", "PCOMP,1,", "PCOMP 1 has the number of another shell property, PSHELL 1", 18),
    (",,,SYM\n,2,", ",,,SIM\n,2,", "`SIM` in field LAM of PCOMP is not empty or SYM, MEM", 18),
    ("\n,2,.001,45.,,,,-45.\n", "\n", "PCOMP 2 has no plies", 18),
    (
        ",2,.001,45.,,",
        ",,.001,45.,,",
        "field MID of PCOMP is empty; expected the material of the first ply",
        19,
    ),
    (",2,.001,45.,,", ",2,,45.,,", "field T of PCOMP is empty", 19),
    (",2,.001,45.,,", ",2,.0,45.,,", "above zero", 19),
    ("\n,102,,,90.", "\n,101,,,90.", "global ply 101 stands twice in PCOMPG 3", 22),
    // Materials.
    ("MAT1,1,7.+10", "MAT1,1,", "field E of MAT1 is empty", 23),
    ("MAT8,2,1.4+11", "MAT8,2,0.", "`0.` in field E1 of MAT8 is not above zero", 24),
    ("MAT8,2,1.4+11", "MAT8,1,1.4+11", "MAT8 1 has the number of another material, MAT1 1", 24),
    (",1.+10,.3,", ",1.+10,9.,", "small enough", 24),
    ("MAT9,3,1.", "MAT9,3,1", "`1` in field G11 of MAT9 is not a real number", 25),
    // Solids.
    ("\n,17,18\n", "\n,17\n", "field G8 of CHEXA is empty", 29),
    ("\n,17,18\n", "\n,17,17\n", "grid 17 stands twice in CHEXA 10", 29),
    ("\n,17,18\n", "\n,17,18,1.5\n", "`1.5` in field G9 of CHEXA", 29),
    (
        "CTETRA,12,4,1,2,3,11\n",
        "CTETRA,12,4,1,2,3,11,21,22\n,,,,,7\n",
        "`7` stands behind the last field",
        32,
    ),
    ("PSOLID,4,3", "PSOLID,4,3,-2", "`-2` in field CORDM of PSOLID is not -1, 0 or", 32),
    ("PSOLID,4,3", "PSOLID,4,3,-1", "a MAT9 in element axes", 32),
    (
        "PSOLID,4,3",
        "PSOLID,4,3,,GARBAGE",
        "`GARBAGE` in field IN of PSOLID is not empty or one of 0 (BUBBLE), 1 (ONE), 2 (TWO), 3 (THREE)",
        32,
    ),
    (
        "PSOLID,4,3",
        "PSOLID,4,3,,,,2",
        "`2` in field ISOP of PSOLID is not empty or one of 0 (REDUCED), 1 (FULL)",
        32,
    ),
    ("PSOLID,4,3", "PSOLID,4,3,,,,,PFLUID", "`PFLUID` in field FCTN of PSOLID", 32),
    // Springs and masses.
    ("CBUSH,20,5,1,2", "CBUSH,20,5,1,1", "grid 1 stands twice in CBUSH 20", 33),
    ("CBUSH,20,5,1,2,,,,0", "CBUSH,20,5,1", "ends at the ground but names no coordinate system", 33),
    ("\n,.5\nPBUSH", "\n,1.5\nPBUSH", "`1.5` in field S of CBUSH is not from 0 to 1", 34),
    ("PBUSH,5,K,", "PBUSH,5,T,", "field ALPHA of PBUSH is not read", 35),
    ("PBUSH,5,K,", "PBUSH,5,M,-", "in field M of PBUSH", 35),
    ("PBUSH,5,K,", "PBUSH,5,Q,", "`Q` in field FLAG of PBUSH is not K", 35),
    (
        "CELAS2,21,100.,1,3",
        "CELAS2,21,100.,1,0",
        "there is no component for GRID 1, which is no scalar point",
        36,
    ),
    ("CELAS2,21,100.,1,3", "CELAS2,21,100.,1,12", "`12` in field C1 of CELAS2 is not one digit", 36),
    ("CELAS2,21,100.,1,3", "CELAS2,21,100.", "no grid at either end", 36),
    ("CELAS2,21,100.,1,3", "CELAS2,21,100.,1,3,1,3", "both ends of CELAS2 21 are the same motion", 36),
    ("CMASS2,50,", "CMASS2,40,", "CONM2 40 has the number of another mass element, CMASS2 40", 38),
    ("CONM2,40,2,,1.5", "CONM2,40,2,,ton", "`ton` in field M of CONM2 is not a real number", 38),
    ("\n,Z,1.,.1,1.\n", "\n,Z,1.,.1\n", "list Z of GENEL 22 has 2 numbers; expected 3", 42),
    ("\n,Z,1.,.1,1.\n", "\n", "has neither K nor Z", 39),
    ("\n,UD,,1,1,", "\n,UD,,3,3,", "stands in both lists, UI and UD", 39),
    ("1,5,1,6\n", "1,5\n", "has 5 motions in UD and no S", 39),
    // Rigid elements and constraints.
    ("RBE3,60,,1,123,1.,123,2,3", "RBE3,60,,1,123", "RBE3 60 has no grids to follow", 43),
    ("RBE3,60,,1,123,1.,123,2,3", "RBE3,60,,1,123,1.,123", "at least one number", 43),
    (
        "RBE3,60,,1,123,1.,123,2,3",
        "RBE3,60,,1,123,1,123,2,3",
        "`1` in field WT of RBE3 is not a real number",
        43,
    ),
    ("RBE3,60,,1,123,1.,123,2,3", "RBE3,60,,1,0,1.,123,2,3", "`0` in field REFC of RBE3", 43),
    ("RBE3,60,", "RBE2,60,", "RBE2", 43),
    ("RBAR,61,1,4,123456", "RBAR,61,1,4,12345", "has 5 independent components", 44),
    (
        "RBAR,61,1,4,123456",
        "RBAR,60,1,4,123456",
        "RBAR 60 has the number of another rigid element, RBE3 60",
        44,
    ),
    ("RBAR,61,1,4,123456", "RBAR,61,1,1,123456", "grid 1 stands twice in RBAR 61", 44),
    ("MPC,9,4,3,1.,3,3,-1.", "MPC,9,4,3,1.,3,3", "field A of MPC is empty", 45),
    (
        "MPC,9,4,3,1.,3,3,-1.",
        "MPC,9,4,3,0.,3,3,-1.",
        "the coefficient of the dependent motion (A1) of MPC is zero",
        45,
    ),
    ("MPC,9,4,3,1.,3,3,-1.", "MPC,9,4,3,1.,4,3,-1.", "motion 3 of grid 4 stands twice in MPC", 45),
    ("MPC,9,4,3,1.,3,3,-1.", "MPC,9,4,7,1.,3,3,-1.", "`7` in field C of MPC", 45),
    ("SPC,1,1,123456,0.", "SPC,1,1,123459,0.", "`123459` in field C of SPC is not a combination", 46),
    (
        "SPC1,1,3,2,THRU,4",
        "SPC1,1,3,2,THRU,400000000",
        "2 THRU 400000000 is not a range that can be meant",
        47,
    ),
    ("SPC1,1,3,2,THRU,4", "SPC1,1,3,4,THRU,2", "4 THRU 2 is not a range", 47),
    ("SPC1,1,3,2,THRU,4", "SPC1,1,3,THRU,4", "`THRU` in field G of SPC1", 47),
    // Panels, parameters and what stands around the cards.
    (
        "SPLINE1,70,1001,1001,1002,5",
        "SPLINE1,70,1001,1002,1001,5",
        "box 1002 of SPLINE1 comes after box 1001",
        48,
    ),
    ("SPLINE1,70,1001,1001,1002,5", "SPLINE1,70,1001,1001,1002,5,,TPS", "in field METH of SPLINE1", 48),
    ("SPLINE1,70,1001,1001,1002,5", "SPLINE2,70,1001,1001,1002,5\n,-2.", "field DTHX of SPLINE2", 49),
    ("PARAM,WTMASS,1.", "PARAM,WTMASS,0.", "above zero, as WTMASS must be", 49),
    ("PARAM,WTMASS,1.", "PARAM,WTMASS,", "field V1 of PARAM is empty", 49),
    (
        "PARAM,WTMASS,1.\n",
        "PARAM,WTMASS,1.\nPARAM,WTMASS,2.\n",
        "parameter WTMASS is 2 here and 1 before",
        50,
    ),
    ("CORD2C,5,,0.,0.,0.,0.,0.,1.\n", "CORD2C,5,5,0.,0.,0.,0.,0.,1.\n", "refers to itself", 5),
    ("CORD2C,5,,0.,0.,0.,0.,0.,1.\n", "CORD2C,5,,0.,0.,0.,0.,0.,0.\n", "do not span a plane", 5),
    ("PBARL,30,1,,BOX", "PBARL,30,1,,HAT", "section HAT of PBARL is not read", 50),
    (",.1,.2,.01,.01\n", ",.1,.2,.1,.01\n", "the dimensions of section BOX in PBARL do not fit together", 51),
    ("INCLUDE_HERE", "INCLUDE 'not_there.bdf'", "not_there.bdf does not exist", 53),
];

#[test]
fn the_good_deck_is_good() {
    let deck = parse_deck("good.bdf", &good()).unwrap_or_else(|error| panic!("{error}"));
    assert!(deck.unknown.is_empty(), "{:?}", deck.unknown);
    Frames::resolve(&deck).unwrap_or_else(|error| panic!("{error}"));
    let back = parse_deck("good.bdf", &write_deck(&deck)).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(write_deck(&back), write_deck(&deck));
    assert!(!content(&deck).is_empty());
}

fn good() -> String {
    GOOD.replace("$ INCLUDE_HERE\n", "")
}

#[test]
fn every_break_is_named_with_its_line() {
    assert!(BREAKS.len() >= 50);
    let mut faults = Vec::new();
    for (old, new, words, line) in BREAKS {
        let template = if *old == "INCLUDE_HERE" { GOOD.replace("$ INCLUDE", "INCLUDE") } else { good() };
        assert_eq!(template.matches(old).count(), 1, "`{old}` must stand once in the good deck");
        let text = template.replace(old, new);
        let result = parse_deck("good.bdf", &text)
            .and_then(|deck| deck.refuse_unread_air().and_then(|()| Frames::resolve(&deck).map(|_| ())));
        match result {
            Ok(()) => faults.push(format!("`{new}` was taken")),
            Err(error) => {
                let place = error.span.as_ref().map_or(0, |span| span.line);
                if !error.message.contains(words) || place != *line || error.message.contains(". ") {
                    faults.push(format!("`{new}` (line {line}, \"{words}\"): {error}"));
                }
            }
        }
    }
    assert!(faults.is_empty(), "{} faults:\n{}", faults.len(), faults.join("\n"));
}

/// A deck, an error with a place: anything but a panic.
fn survives(text: &str) {
    match parse_deck("t.bdf", text) {
        Ok(deck) => {
            let _ = Frames::resolve(&deck);
            let written = write_deck(&deck);
            parse_deck("t.bdf", &written).unwrap_or_else(|error| panic!("our own deck: {error}\nof\n{text}"));
        }
        Err(error) => assert!(error.span.is_some(), "{error}"),
    }
}

#[test]
fn no_field_is_missed_with_a_panic() {
    let good = good();
    let lines: Vec<&str> = good.lines().collect();
    for (index, line) in lines.iter().enumerate() {
        let fields: Vec<&str> = line.split(',').collect();
        for field in 0..fields.len() {
            for replacement in
                [None, Some(""), Some("0"), Some("-1"), Some("7."), Some("THRU"), Some("S"), Some("1e400")]
            {
                let mut fields = fields.clone();
                match replacement {
                    None => drop(fields.remove(field)),
                    Some(text) => fields[field] = text,
                }
                let changed = fields.join(",");
                let mut lines = lines.clone();
                lines[index] = &changed;
                survives(&lines.join("\n"));
            }
        }
    }
}

#[test]
fn no_line_is_missed_or_doubled_with_a_panic() {
    let good = good();
    let lines: Vec<&str> = good.lines().collect();
    for index in 0..lines.len() {
        let mut without = lines.clone();
        without.remove(index);
        survives(&without.join("\n"));
        let mut doubled = lines.clone();
        doubled.insert(index, lines[index]);
        survives(&doubled.join("\n"));
    }
}

#[test]
fn a_file_cut_off_anywhere_gives_a_deck_or_an_error() {
    let good = good();
    let written = write_deck(&parse_deck("t.bdf", &good).expect("a good deck"));
    for text in [good, written] {
        for end in 0..text.len() {
            if let Some(start) = text.get(..end) {
                survives(start);
            }
        }
    }
}

#[test]
fn a_deck_without_its_end_is_the_same_deck() {
    let good = good();
    let open = good.replace("ENDDATA\n", "");
    assert_ne!(open, good);
    let read = |text: &str| content(&parse_deck("t.bdf", text).expect("a good deck"));
    assert_eq!(read(&open), read(&good));
}

/// Writes bytes into a file of its own and reads it as a deck.
fn read_bytes(name: &str, bytes: &[u8]) -> Result<nastran::BulkData, nastran::InputError> {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("broken_{name}"));
    std::fs::create_dir_all(&folder).expect("a folder for the test");
    let path = folder.join("deck.bdf");
    std::fs::write(&path, bytes).expect("a file for the test");
    read_deck(&path)
}

#[test]
fn encodings_other_than_utf_8_are_named_where_they_matter() {
    let umlaut = read_bytes("comment", b"CEND\nTITLE = Fl\xFCgel\nBEGIN BULK\nGRID,1\n$ Fl\xFCgel\nGRID,2\n")
        .expect("comments and titles say nothing");
    assert_eq!(umlaut.grids.len(), 2);
    let unmarked: Vec<u8> = "GRID,1\nGRID,2\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    let cases: [(&str, &[u8], &str, usize); 5] = [
        ("unmarked", &unmarked, "the file has zero bytes", 1),
        ("latin_1", b"GRID,1\n$ Fl\xFCgel\nGRID,\xFC\n", "byte 0xFC is not UTF-8", 2),
        ("nul", b"GRID,1\nGRID,\0\n", "the file has zero bytes", 2),
        ("empty", b"", "the deck is empty", 0),
        ("blank", b"\n  \n", "the deck is empty", 0),
    ];
    for (name, bytes, words, line) in cases {
        let error = read_bytes(name, bytes).expect_err(name);
        assert!(error.message.contains(words), "{error}");
        assert_eq!(error.span.as_ref().map(|span| span.line), Some(line), "{error}");
    }
    let marked = read_bytes("marked", "\u{FEFF}GRID,1\n".as_bytes()).expect("a byte order mark is no harm");
    assert!(marked.grids.contains_key(&1));
    let utf_16: Vec<u8> = "\u{FEFF}GRID,1\n".encode_utf16().flat_map(u16::to_le_bytes).collect();
    assert!(read_bytes("utf_16", &utf_16).expect("UTF-16 with its mark").grids.contains_key(&1));
    let windows = read_bytes("windows", b"GRID,1\r\nGRID,2\r\n").expect("nor are Windows line ends");
    assert_eq!(windows.grids.len(), 2);
}

#[test]
fn decks_that_include_each_other_are_refused() {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("broken_circle");
    std::fs::create_dir_all(&folder).expect("a folder for the test");
    std::fs::write(folder.join("a.bdf"), "GRID,1\nINCLUDE 'b.bdf'\n").expect("a file for the test");
    std::fs::write(folder.join("b.bdf"), "INCLUDE 'a.bdf'\n").expect("a file for the test");
    let error = read_deck(&folder.join("a.bdf")).expect_err("a circle");
    assert!(error.message.contains("is read twice"), "{error}");
}
