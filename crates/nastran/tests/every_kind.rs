//! Every kind of cards goes through reading, counting, numbering, joining, mirroring and writing. The list of kinds and
//! the samples are compared name by name, so that a kind without a sample fails.

use crate::common::content;
use nastran::{BulkData, CARD_KINDS, Family, Step, parse_deck, write_deck};
use std::collections::{BTreeMap, BTreeSet};

/// A card of each name, and what those refer to that must be there.
const SAMPLES: &str = "\
GRID,1,7,.5,.25,0.
GRID,2,,1.,.5,0.,,345
GRID,3,,0.,.5,.25
CORD2R,7,,0.,.1,0.,0.,.1,1.
,1.,.1,0.
CORD2C,8,,0.,0.,0.,0.,0.,1.
,1.,0.,0.
CORD2S,9,,0.,0.,0.,0.,0.,1.
,1.,0.,0.
CORD1R,10,1,2,3
CORD1C,11,1,2,3
CORD1S,12,1,2,3
CBAR,20,30,1,2,0.,.5,1.
CBEAM,21,31,1,2,3
,,,0.,.1,.2,0.,.1,.2
PBAR,30,40,1.,2.,3.,4.,5.
,,,,,,,,
,.8,.9,.1
PBEAM,31,40,1.,2.,3.,.5,4.,5.
PBARL,32,40,,BAR
,.1,.2,.3
PBEAML,33,40,,L
,.1,.2,.01,.02,.3
MAT1,40,7.,,.3,2.7,1.2-5,20.
CONM2,50,1,,2.,.1,.2,.3
,1.,.01,1.1,.02,.03,1.2
RBE2,60,1,123456,2,3
SPC1,1,3,1,2
SPC,1,3,12
ASET1,123,1,2
OMIT1,456,1,2
QSET1,,1
ASET,1,3,2,3
BSET,1,3
BSET1,3,1
CSET,1,3
CSET1,3,1
OMIT,1,4
QSET,1
SET1,70,1,2,3
CQUAD4,80,90,1,2,3,4,30.
CTRIA3,81,91,1,2,3,7
CQUADR,74,90,1,2,3,4,30.
CTRIAR,75,91,1,2,3,7
GRID,4,,0.,1.,.25
GRID,5,,2.,1.,.25
GRID,6,,3.,1.,.25
GRID,13,,3.,2.,.25
GRID,14,,4.,2.,.25
CHEXA,82,92,1,2,3,4,5,6
,13,14
CPENTA,83,92,1,2,3,4,5,6
CTETRA,84,92,1,2,3,4
CROD,85,93,1,2
CQUAD8,76,90,1,2,3,4,5,6
,13,14,,,,,30.
CTRIA6,77,91,1,2,3,4,5,6
,7
CSHEAR,78,98,1,2,3,4
PSHEAR,98,40,.1,.2,.3,.4
CTUBE,79,99,1,2
PTUBE,99,40,2.,.5
CONROD,73,40,1,2,1.,2.
CBUSH,86,94,1,2,0.,1.,.5
,.25,7,.1,.2,.3
CELAS1,87,95,1,3,2,3
CELAS2,88,4.5,1,2
CMASS1,51,96,1,3
CMASS2,52,2.5,2,3
GENEL,89,,1,3,2,3,,
,K,2.,-1.,3.
CONM1,53,1,7,1.,.1,2.,.2,.3
,3.
RBAR,61,1,2,123456
RBE3,62,,1,123,1.,123,2,3
MPC,1,1,2,1.,2,3,-.5
PSHELL,90,40,.01,40,,40
PCOMP,91,,,,,20.
,41,.01,30.,,42,.02,-45.
PCOMPG,97
,1,42,.01,30.
PSOLID,92,43,7
PROD,93,40,1.,2.
PBUSH,94,K,1.,2.,3.,4.,5.,6.
PELAS,95,3.
PMASS,96,4.
MAT2,41,4.,1.,.1,3.,.2,2.,1.5
,.1,.2,.3,20.
MAT8,42,4.,3.,.2,1.,2.,3.,1.5
,.1,.2,20.
MAT9,43,9.,1.,1.,.1,.2,.3,9.
,1.,.1,.2,.3,9.,.1,.2,.3
,3.,.1,.2,3.,.1,3.,2.
CAERO1,1001,1,7,,2,100,,1
,0.,0.,0.,1.,0.,1.,0.,1.
PAERO1,1
AEFACT,100,0.,.25,1.
AESURF,101,FLAP,7,102
AELIST,102,1001,1003
SPLINE1,110,1001,1001,1004,70
SPLINE2,111,1001,1001,1004,70,,,7
SPLINE4,112,1001,102,,70
SPLINE5,113,1001,102,,70,,,7
MONPNT1,ROOT,Wing root
,35,WING,7,.1,.2,.3
MONPNT3,TIP,Wing tip
,35,70,,7,.1,.2,.3
SPCADD,5,1
MPCADD,6,1
FORCE,2,1,7,2.,.1,.2,.3
MOMENT,2,1,7,2.,.1,.2,.3
SLOAD,2,98,4.
FORCE1,2,1,4.,2,3
MOMENT1,2,1,4.,2,3
FORCE2,2,1,4.,2,3,2,1
MOMENT2,2,1,4.,2,3,2,1
PLOAD1,2,20,FZE,FR,.25,3.,.75,5.
PLOAD,2,5.,1,2,3
PLOAD2,2,5.,80,81
PLOAD4,2,80,1.,2.,3.,4.
,7,.1,.2,.3
GRAV,2,7,9.75,0.,0.,-1.
RFORCE,2,1,7,9.75,0.,.5,-1.
LOAD,3,1.,2.,2
SPCD,2,1,3,.5
TEMP,2,1,20.,2,30.
TEMPD,2,15.
TEMPRB,2,20,1.,2.,3.,4.,5.,6.
,,,,,,,,
,21
TEMPP1,2,80,1.,2.
,81
AEROS,,,1.,2.,2.
AESTAT,120,ANGLEA
TRIM,1,.5,100.,URDD3,1.
DIVERG,1,2,.5
AELINK,ALWAYS,FLAP,ANGLEA,.5
AECOMP,WING,AELIST,102
AECOMPL,ALL,WING
SUPORT,1,35
SUPORT1,4,2,35
EIGRL,7,,,5
EIGR,8,MGIV,,,,3
SPOINT,98
CELAS3,71,95,98
CELAS4,72,4.5,98,99
CMASS3,54,96,98
CMASS4,55,2.5,98
AERO,7,,2.,1.2,1
FLUTTER,5,PK,1,2,3
FLFACT,1,.5,1.
MKAERO1,0.,.5,,,,,,
,.1,.2
MKAERO2,0.,.3
TABDMP1,6,CRIT,,,,,,
,0.,.01,10.,.02,ENDT
GUST,1,5,.1,0.,30.
TLOAD1,1,7,.1,,8
TLOAD2,2,7,,,0.,1.,2.,90.
,.5,1.
RLOAD1,3,7,,,8
RLOAD2,4,7,,,8,8
DLOAD,5,1.,2.,1,3.,2
DAREA,7,1,3,2.
EPOINT,1001
DMIG,STIFF,0,6,1,0
DMIG,STIFF,1,3,,2,3,1.
FREQ,9,1.,2.
FREQ1,9,1.,2.,3
FREQ2,9,1.,8.,3
TSTEP,10,100,.1
TABLED1,8,,,,,,,
,0.,1.,2.,3.,ENDT
TABLED2,9,1.,,,,,,
,0.,1.,2.,3.,ENDT
TABLED3,10,1.,2.,,,,,
,0.,1.,2.,3.,ENDT
TABRND1,11,,,,,,,
,0.,1.,2.,3.,ENDT
TABRNDG,12,1,2.,3.
RANDPS,13,1,1,1.,,11
";

/// Boxes 1001 to 1004 in two strips of two; the strips count from the other side.
fn box_images() -> BTreeMap<u32, u32> {
    [(1001, 1003), (1002, 1004), (1003, 1001), (1004, 1002)].into()
}

/// Kinds that an image has no cards of, said beside their types.
const NO_IMAGE: &str = "\
    splines monitors constraint_unions equation_unions point_loads scalar_loads line_loads cross_loads beam_loads pressures \
     gravities spins load_sums enforced temperatures aero_reference trim_variables trims divergences aero_links aero_components \
     component_lists supports eigen_methods unsteady_reference flutters flutter_factors reduced_frequencies \
     damping_tables gusts dynamic_loads dynamic_sums load_areas direct_matrices frequencies time_steps \
     function_tables spectrum_tables spectra";
/// Kinds that are read only.
const NOT_WRITTEN: &str = "\
    constraint_unions equation_unions aero_reference trim_variables trims divergences aero_links aero_components \
     component_lists supports eigen_methods unsteady_reference flutters flutter_factors reduced_frequencies \
     damping_tables gusts dynamic_loads load_areas direct_matrices frequencies time_steps function_tables \
     spectrum_tables spectra";

fn samples() -> BulkData {
    parse_deck("samples.bdf", SAMPLES).unwrap_or_else(|error| panic!("{error}"))
}

/// The samples without a GENEL, which has no image.
fn with_image() -> BulkData {
    BulkData { general: BTreeMap::new(), ..samples() }
}

/// What a deck says by field, as text without places: `grids: {...}`.
fn fields(deck: &BulkData) -> BTreeMap<String, String> {
    let mut fields: BTreeMap<String, String> = BTreeMap::new();
    let mut name = String::new();
    for line in content(deck).lines() {
        let head = line.strip_prefix("    ").filter(|rest| !rest.starts_with([' ', '}', ']', ')']));
        if let Some((field, _)) = head.and_then(|rest| rest.split_once(':')) {
            field.clone_into(&mut name);
        }
        fields.entry(name.clone()).or_default().push_str(line);
    }
    fields
}

/// Numbers to ten digits: sixteen characters do not hold all of a section's.
fn rounded(text: &str) -> String {
    let word = |word: &str| match word.trim_end_matches(',').parse::<f64>() {
        Ok(number) => format!("{number:.9e}"),
        Err(_) => word.to_owned(),
    };
    text.split_whitespace().map(word).collect::<Vec<_>>().join(" ")
}

/// Fields that hold something.
fn filled(deck: &BulkData) -> BTreeSet<String> {
    let is_empty = |text: &str| text.ends_with("{},") || text.ends_with("[],") || text.ends_with("None,");
    fields(deck).into_iter().filter(|(_, text)| !is_empty(text)).map(|(name, _)| name).collect()
}

fn kinds(but: &str) -> Vec<&'static str> {
    CARD_KINDS
        .iter()
        .map(|kind| kind.field)
        .filter(|field| but.split(' ').all(|other| other != *field))
        .collect()
}

#[test]
fn every_name_of_every_kind_has_a_sample_that_is_read() {
    let deck = samples();
    assert_eq!(deck.unread_cards(), None);
    for kind in CARD_KINDS {
        for name in kind.names {
            let card = format!("{name},");
            assert!(SAMPLES.lines().any(|line| line.starts_with(&card)), "no sample of {name}");
        }
        assert!(filled(&deck).contains(kind.field), "the samples of {:?} fill nothing", kind.names);
    }
}

#[test]
fn every_element_is_counted() {
    let counts = samples().element_counts();
    let elements = CARD_KINDS.iter().filter(|kind| kind.family.is_element());
    for name in elements.flat_map(|kind| kind.names) {
        assert_eq!(counts.get(name), Some(&1), "{name}");
    }
}

#[test]
fn every_kind_that_is_written_is_read_again_as_it_was() {
    let deck = samples();
    let text = write_deck(&deck);
    let again = parse_deck("again.bdf", &text).unwrap_or_else(|error| panic!("{error}"));
    let (before, after) = (fields(&deck), fields(&again));
    for field in kinds(NOT_WRITTEN) {
        assert_eq!(rounded(&before[field]), rounded(&after[field]), "{field}");
    }
    assert!(NOT_WRITTEN.split(' ').all(|field| !filled(&again).contains(field)));
}

#[test]
fn every_number_is_raised_and_nothing_else() {
    let step = Step { cards: 100_000, boxes: 1_000_000 };
    let deck = samples();
    let raised = deck.clone().raised(step, "").expect("numbers that do not meet");
    let (before, after) = (fields(&deck), fields(&raised));
    // Sets of constraints and loads, and what only the case control and names refer to.
    let keep = [
        "equation_unions",
        "constraint_unions",
        "load_sums",
        "trims",
        "divergences",
        "aero_links",
        "component_lists",
        "aero_reference",
        "flutters",
        "flutter_factors",
        "reduced_frequencies",
        "damping_tables",
        "gusts",
        "dynamic_loads",
        "dynamic_sums",
        "frequencies",
        "time_steps",
        "function_tables",
        "spectrum_tables",
        "spectra",
    ];
    for field in kinds(&keep.join(" ")) {
        assert_ne!(before[field], after[field], "{field} keeps its numbers");
    }
    // Raising by nothing changes nothing, and both models fit into one deck.
    let same = deck.clone().raised(Step { cards: 0, boxes: 0 }, "").expect("the same numbers");
    assert_eq!(fields(&same), before);
    let mut both =
        BulkData { aero_reference: None, unsteady_reference: None, trims: BTreeMap::new(), ..deck };
    both.divergences.clear();
    (both.flutters, both.flutter_factors, both.damping_tables) = Default::default();
    (both.constraint_unions, both.equation_unions, both.load_sums) = Default::default();
    (both.gusts, both.dynamic_loads, both.dynamic_sums, both.time_steps) = Default::default();
    (both.function_tables, both.spectrum_tables) = Default::default();
    both.aero_components.clear();
    both.component_lists.clear();
    both.join(raised).expect("numbers above all others");
    for (name, count) in samples().element_counts() {
        assert_eq!(both.element_counts()[name], 2 * count, "{name}");
    }
}

#[test]
fn every_kind_has_an_image_or_says_that_it_has_none() {
    let deck = with_image();
    let boxes = box_images();
    let mut placed = deck.clone();
    for mass in placed.masses.values_mut() {
        mass.cid = 0;
    }
    let image = placed.mirrored(&boxes).unwrap_or_else(|error| panic!("{error}"));
    let general = CARD_KINDS.iter().find(|kind| kind.names == ["GENEL"]).expect("a kind").field;
    for field in kinds(NO_IMAGE).into_iter().filter(|field| *field != general) {
        assert!(filled(&image).contains(field), "{field} vanishes from the image");
    }
    assert!(NO_IMAGE.split(' ').all(|field| !filled(&image).contains(field)));
    // The image of the image: all but coordinates, which are in the basic system now.
    let twice = image.mirrored(&boxes).unwrap_or_else(|error| panic!("{error}"));
    let basic = twice.mirrored(&boxes).unwrap_or_else(|error| panic!("{error}"));
    for (field, text) in fields(&image) {
        assert_eq!(text.replace("-0.0", "0.0"), fields(&basic)[&field].replace("-0.0", "0.0"), "{field}");
    }
}

#[test]
fn numbers_that_a_family_shares_are_refused_across_its_kinds() {
    for (family, a, b) in [
        // Those of two kinds are kept: `cards.rs`.
        (Family::Element, "CELAS1,1,1,1,2", "CELAS2,1,4.,1,2"),
        (Family::MassElement, "CONM2,1,1,,2.", "CMASS2,1,4.,1,2"),
        (Family::RigidElement, "RBE2,1,1,3,2", "RBAR,1,1,2,123456"),
        (Family::Material, "MAT1,1,4.,,.3", "MAT8,1,4.,3.,.2,1."),
    ] {
        let error = parse_deck("t.bdf", &format!("{a}\n{b}\n")).expect_err("one number");
        assert!(error.message.contains("has the number of another"), "{family:?}: {error}");
    }
}
