//! What users' decks have beside plain cards: case control, replication, blanks, old spellings.

use nastran::{Analysis, Offt, Solution, parse_deck};

const CLAMPS: &str = "GRID,1\nGRID,2,,1.\nSPC1,1,123,1\nSPC1,2,456,1\nSPC1,3,2,2\nSPCADD,9,1,3\nSPCADD,10,2,4,5\nSPCADD,11,6\n";

fn held(control: &str, subcase: Option<u32>) -> Result<Vec<u32>, String> {
    let deck = parse_deck("t.bdf", &format!("{control}{CLAMPS}")).map_err(|error| error.to_string())?;
    let bulk = deck.bounded(subcase).map_err(|error| error.to_string())?;
    Ok(bulk.constraints.iter().map(|card| card.set).collect())
}

#[test]
fn the_case_control_selects_and_what_it_does_not_select_does_not_apply() {
    assert_eq!(held("SOL 103\nCEND\nSPC = 2\nBEGIN BULK\n", None).unwrap(), [2]);
    assert_eq!(held("CEND\nSPC=9\nBEGIN BULK\n", None).unwrap(), [1, 3], "a union");
    assert_eq!(held("CEND\nSPC=10\nBEGIN BULK\n", None).unwrap(), [2], "a union of which two are not there");
    let remarks = parse_deck("t.bdf", &format!("CEND\nSPC=10\nBEGIN BULK\n{CLAMPS}")).unwrap().remarks();
    assert_eq!(remarks, ["SPCADD 10 unites set(s) 4, 5, which are not there"]);
    let none = held("CEND\nSPC=11\nBEGIN BULK\n", None).unwrap_err();
    assert!(none.starts_with("SPCADD 11 unites sets of which none is there"), "{none}");
    assert_eq!(held("SOL 103\nCEND\nMETHOD = 1\nBEGIN BULK\n", None).unwrap(), [0; 0], "none is selected");
    let two = "CEND\nSUBCASE 1\nSPC=1\nSUBCASE 2\nSPC=2\nBEGIN BULK\n";
    assert_eq!(held(two, Some(2)).unwrap(), [2]);
    let with_method = "CEND\nSUBCASE 1\nSPC=1\nSUBCASE 2\nSPC=2\nMETHOD=4\nBEGIN BULK\n";
    assert_eq!(held(with_method, None).unwrap(), [2], "modes are asked for in the second");
    let combined = "CEND\nSPC=1\nSUBCASE 1\nSUBCASE 2\nSUBCOM 3\nSUBSEQ=1.,1.\nSPC=2\nBEGIN BULK\n";
    assert_eq!(held(combined, None).unwrap(), [1], "a combination has no boundary conditions of its own");
}

#[test]
fn what_is_left_open_is_refused_with_what_there_is() {
    let two = "CEND\nSUBCASE 1\nSPC=1\nSUBCASE 2\nSPC=2\nBEGIN BULK\n";
    assert_eq!(
        held(two, None).unwrap_err(),
        "the subcases differ in boundary conditions: 1 has SPC 1; 2 has SPC 2 (hint: name one of them (--subcase NUMBER))"
    );
    assert_eq!(held(two, Some(3)).unwrap_err(), "the deck has no subcase 3 (hint: there are: 1, 2)");
    let open = held("", None).unwrap_err();
    assert!(open.starts_with("the deck has SPC sets 1, 2, 3 and no case control that selects one"), "{open}");
    let changed = held("CEND\nSPC=1\nNSM = 5\nBEGIN BULK\n", None).unwrap_err();
    assert!(
        changed.starts_with("t.bdf:3:1: `NSM = 5` changes the structure, its loads or its modes"),
        "{changed}"
    );
    let again = held("CEND\nBEGIN BULK\nGRID,7\nBEGIN SUPER=1\n", None).unwrap_err();
    assert!(again.contains("superelements and parts are not read"), "{again}");
    assert!(held("CEND\nSPC=1\nBEGIN BULK\nBEGIN BULK\n", None).is_ok(), "nothing stands between the two");
}

#[test]
fn the_solution_asked_for_is_known_by_number_and_by_name() {
    let asked = |text: &str| Solution::of(text).map(|solution| solution.analysis);
    for (text, analysis) in [
        ("ID A,B\nSOL 103\nCEND\n", Analysis::Modes),
        ("SOL SEMODES $ modes\n", Analysis::Modes),
        ("sol=144\n", Analysis::Trim),
        ("SOL 1,0\n", Analysis::Statics),
        ("SOL 106\n", Analysis::NonlinearStatics),
        ("SOL 153\n", Analysis::Other),
    ] {
        assert_eq!(asked(text), Some(analysis), "{text}");
    }
    assert_eq!(asked("CEND\nBEGIN BULK\nSOL 103\n"), None);
}

#[test]
fn replication_gives_the_cards_it_stands_for() {
    let short = "GRID,1,,0.,1.\n=,*(10),,*(.5),==\n=(2)\nCBAR,7,1,1,11,0.,0.,1.\n=,*1,=,*10,*10,==\n";
    let long = "GRID,1,,0.,1.\nGRID,11,,.5,1.\nGRID,21,,1.,1.\nGRID,31,,1.5,1.\n\
                CBAR,7,1,1,11,0.,0.,1.\nCBAR,8,1,11,21,0.,0.,1.\n";
    let text = |deck: &str| nastran::write_deck(&parse_deck("t.bdf", deck).unwrap());
    assert_eq!(text(short), text(long));
    let error = parse_deck("t.bdf", "GRID,1\n=,*(.5)\n").unwrap_err().to_string();
    assert!(error.starts_with("t.bdf:2:1: `.5` cannot be added to `1`"), "{error}");
    let error = parse_deck("t.bdf", "=(3)\n").unwrap_err().to_string();
    assert!(error.starts_with("t.bdf:1:1: a replication (`=`) has no card"), "{error}");
}

#[test]
fn a_card_with_its_name_takes_over_fields_of_the_one_before() {
    let text = |deck: &str| nastran::write_deck(&parse_deck("t.bdf", deck).unwrap());
    let written_out = text("PBAR,101,300,12.5,12.,13.,25.\nPBAR,102,300,12.5,12.,13.,25.\n");
    for short in [
        "PBAR,101,300,12.5,12.,13.,25.\nPBAR,102,300,== $ the same\n",
        "PBAR,101,300,12.5,12.,13.,25.\nPBAR,*1,=,==\n",
        "PBAR,101,300,12.5,12.,13.,25.\nPBAR    *(1)    ==\n",
        "PBAR    101     300     12.5    12.     13.     25.\nPBAR    102     =       =       12.     ==\n",
    ] {
        assert_eq!(text(short), written_out, "{short}");
    }
    let rest = "GRID,1,,0.,1.\nGRID,*10,,*.5,==\n=2\nGRID,50,=,=,*2.\n";
    let grids: String =
        [(1, 0.0), (11, 0.5), (21, 1.0), (31, 1.5)].map(|(id, x)| format!("GRID,{id},,{x:?},1.\n")).concat();
    assert_eq!(text(rest), text(&format!("{grids}GRID,50,,1.5,3.\n")));
}

#[test]
fn replications_that_are_not_read_are_named() {
    let error = |deck: &str| parse_deck("t.bdf", deck).unwrap_err().to_string();
    let other = error("CROD,1,1,1,2\nCONROD,2,==\n");
    assert!(
        other.starts_with("t.bdf:2:1: CONROD takes over fields of the card before it, which is a CROD"),
        "{other}"
    );
    let first = error("PBAR,102,300,==\n");
    assert!(first.starts_with("t.bdf:1:1: a replication (`=`) has no card of one line before it"), "{first}");
    let long = error("PBAR,1,3,1.,1.,1.\n,0.,0.\nPBAR,2,3,1.,1.,1.\n,==\n");
    assert!(long.starts_with("t.bdf:4:2: `==` in a continuation of PBAR"), "{long}");
    let end = error("GRID,9,,.02\n=(8),*(2),,%(.10)\n");
    assert!(end.starts_with("t.bdf:2:1: `%(.10)` in a replication is a form of NASTRAN-95"), "{end}");
    // NASTRAN-95 has the steps beside the number of cards.
    let grids = parse_deck("t.bdf", "GRID,1,,.0\n=(3),*(2),,*(.005)\n").unwrap().grids;
    assert_eq!(grids.keys().copied().collect::<Vec<_>>(), [1, 3, 5, 7]);
    assert!((grids[&7].xyz.x - 0.015).abs() < 1e-15);
    // In text the signs are letters.
    let text = "GRID,1\nDEQATN  1       F(A,B)  =       A*B\nMONPNT1,TIP,=\n,3,WING\n";
    assert_eq!(parse_deck("t.bdf", text).unwrap().monitors[0].label, "=");
}

#[test]
fn decks_of_superelements_are_refused_as_such_whatever_else_is_wrong_with_them() {
    let error = |deck: &str| parse_deck("t.bdf", deck).unwrap_err().to_string();
    for card in
        ["SESET,101,1", "CSUPER,101,,1,2", "SEBULK  101     EXTERNAL", "seconct*,101,0", "RELEASE,1,C,1"]
    {
        let name = card.split(|c: char| ", *".contains(c)).next().unwrap_or_default().to_uppercase();
        let expected = format!(
            "t.bdf:2:1: {name} makes this a deck of superelements; superelements and parts are not read (hint: give the whole \
             model as one bulk data section)"
        );
        assert_eq!(error(&format!("GRID,1\n{card}\n")), expected);
    }
    // Parts share numbers, and refer to points that only Nastran makes.
    let twice = error("GRID,1\nGRID,1,,.5\nSEBULK,101\n");
    assert!(twice.starts_with("t.bdf:3:1: SEBULK makes this a deck of superelements"), "{twice}");
    let first = error("GRID,1\nBEGIN SUPER=1\nEXTRN,1,123\n");
    assert!(first.starts_with("t.bdf:2:1: `BEGIN SUPER=1` begins another part of the deck"), "{first}");
    let part = error("GRID,1\nGRID,1,,.5\nBEGIN SUPER=1\n");
    assert!(part.starts_with("t.bdf:2:6: GRID 1 is given twice"), "{part}");
}

#[test]
fn parameters_that_are_whole_numbers_are_those_of_the_deck() {
    let deck =
        parse_deck("t.bdf", "CEND\nPARAM,INREL,-2\nBEGIN BULK\nPARAM,LGDISP,1\nPARAM,AUTOSPC,NO\n").unwrap();
    let value = |name: &str| deck.parameters.get(name).copied();
    assert_eq!((value("INREL"), value("LGDISP"), value("AUTOSPC")), (Some(-2.0), Some(1.0), Some(0.0)));
    assert_eq!(deck.bounded(None).unwrap().parameters, deck.parameters);
}

#[test]
fn blanks_inside_component_fields_and_continuation_names_say_nothing() {
    let deck = "GRDSET                                                  12 4 6\n\
                GRID    1               0.      0.      0.\n\
                PCOMP   1               .03                                             +      A\n\
                +      A74      .0074   0.\n";
    let deck = parse_deck("t.bdf", deck).unwrap();
    assert_eq!(deck.grids[&1].ps, [1, 2, 4, 6]);
    assert_eq!(deck.laminates[&1].plies.len(), 1);
}

#[test]
fn offset_vectors_have_every_spelling_of_the_manual_and_the_flags_of_old_decks() {
    let offt = |text: &str| {
        let deck = format!("GRID,1\nGRID,2,,1.\nCBAR,1,1,1,2,0.,0.,1.,{text}\n");
        parse_deck("t.bdf", &deck).map(|deck| deck.beams[&1].offt)
    };
    assert_eq!(offt("BGG").unwrap(), Offt { is_basic: true, is_element: [false; 2] });
    assert_eq!(offt("GOG").unwrap(), Offt { is_basic: false, is_element: [true, false] });
    assert_eq!(offt("boo").unwrap(), Offt { is_basic: true, is_element: [true; 2] });
    assert_eq!((offt("1").unwrap(), offt("2").unwrap()), (Offt::default(), Offt::default()));
    assert!(offt("GXG").is_err());
}

#[test]
fn supports_of_a_subcase_are_those_it_names() {
    let deck = "CEND\nSUBCASE 1\nSUPORT1=5\nBEGIN BULK\nGRID,1\nSUPORT,1,3\nSUPORT1,5,1,1\nSUPORT1,6,1,2\n";
    let deck = parse_deck("t.bdf", deck).unwrap();
    let bulk = deck.bounded(None).unwrap();
    let kept: Vec<&[u8]> = bulk.supports.iter().map(|card| card.components.as_slice()).collect();
    assert_eq!(kept, [&[3][..], &[1][..]]);
}

#[test]
fn a_wrong_card_of_the_air_stops_who_needs_the_air_and_nobody_else() {
    let deck = parse_deck("t.bdf", "GRID,1\nSPLINE2,1,1001,1001,1004,5,-1.\nSPOINT,7\nSPOINT,7,8\n").unwrap();
    assert_eq!(deck.scalar_points.len(), 2, "naming a scalar point twice changes nothing");
    let error = deck.refuse_unread_air().unwrap_err().to_string();
    assert!(error.starts_with("t.bdf:2:28: `-1.` in field DZ of SPLINE2"), "{error}");
    assert_eq!(deck.refuse_unread_elements(), Ok(()));
}

#[test]
fn sections_made_of_rectangles_have_the_areas_and_moments_of_those() {
    let section = |kind: &str, dimensions: &str| {
        let deck = parse_deck("t.bdf", &format!("PBARL,1,1,,{kind}\n,{dimensions}\n")).unwrap();
        let at = deck.beam_properties[&1].stations[0];
        (at.area, at.i1, at.i2)
    };
    let near = |ours: (f64, f64, f64), closed: (f64, f64, f64), what: &str| {
        for (ours, closed) in [(ours.0, closed.0), (ours.1, closed.1), (ours.2, closed.2)] {
            assert!((ours - closed).abs() < 1e-12 * closed, "{what}: {ours} beside {closed}");
        }
    };
    // An I of height 6 and width 4 with walls of 1: the rectangle less two of 1.5 by 4.
    let i_beam = (24.0 - 12.0, (4.0 * 216.0 - 3.0 * 64.0) / 12.0, (2.0 * 64.0 + 4.0) / 12.0);
    near(section("I1", "3.,1.,4.,6."), i_beam, "I1");
    near(section("I", "6.,4.,4.,1.,1.,1."), i_beam, "I");
    near(section("H", "4.,2.,4.,1."), (i_beam.0, i_beam.2, i_beam.1), "H is an I on its side");
    near(
        section("CROSS", "3.,1.,4.,1."),
        (7.0, 64.0 / 12.0 + 3.0 / 12.0, 4.0 / 12.0 + 60.0 / 12.0 + 0.25),
        "CROSS",
    );
    near(section("T2", "4.,5.,1.,.5"), section("T", "4.,5.,1.,.5"), "a T upside down");
    let tee = section("T", "4.,5.,1.,.5");
    near(section("T1", "4.,4.,1.,.5"), (tee.0, tee.2, tee.1), "a T on its side");
    near(section("CHAN1", "2.,1.,4.,6."), section("CHAN", "3.,6.,1.,1."), "CHAN1");
    near(section("BOX1", "4.,6.,1.,1.,.5,.5"), section("BOX", "4.,6.,1.,.5"), "BOX1 of even walls");
    let beam = parse_deck("t.bdf", "PBEAML,1,1,,T1\n,4.,4.,1.,.5\n").unwrap_err().to_string();
    assert!(beam.contains("its shear centre is not known"), "{beam}");
}

#[test]
fn loads_may_name_the_basic_system_by_its_number() {
    let deck = parse_deck("t.bdf", "GRID,1\nFORCE,1,1,0,10.,0.,0.,1.\nGRAV,2,0,9.81,0.,0.,-1.\n");
    assert_eq!(deck.map(|deck| deck.grids.len()), Ok(1));
}

#[test]
fn numbers_of_a_free_line_are_separated_by_blanks_too() {
    let written = |deck: &str| nastran::write_deck(&parse_deck("t.bdf", deck).unwrap());
    let plain = "PSHEAR,401,1,1.,.5,1.,30.\n";
    assert_eq!(written("PSHEAR, 401     1       1.0     0.5, 1.,30.$ a remark\n"), written(plain));
    // Commas that begin after the second field, as in MSC's own decks.
    let grids = "GRID,1\nGRID,2,,1.\n";
    let bush = written(&format!("{grids}CBUSH   10211,  10010,  1,    2\n"));
    assert_eq!(bush, written(&format!("{grids}CBUSH,10211,10010,1,2\n")));
    let words =
        parse_deck("t.bdf", "MONPNT3,TIP,Wing tip 2 3\n,35,70,,0,.1,.2,.3\nSET1,70,1\nGRID,1\n").unwrap();
    assert_eq!(words.monitors[0].name, "TIP", "words stay together");
}

#[test]
fn a_coordinate_system_may_stand_in_one_free_line() {
    let long = parse_deck("t.bdf", "CORD2C,1,0,0.,0.,0.,0.,0.,1.,0.,1.,0.\n").unwrap();
    let short = parse_deck("t.bdf", "CORD2C,1,0,0.,0.,0.,0.,0.,1.\n,0.,1.,0.\n").unwrap();
    let text = nastran::write_deck(&long);
    assert!(text.contains("CORD2C"), "{text}");
    assert_eq!(text, nastran::write_deck(&short));
}

#[test]
fn a_step_of_a_replication_begins_at_zero_where_the_field_is_empty() {
    let deck = parse_deck(
        "t.bdf",
        "CORD2R,1,,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\nGRID,1,,0.,1.,0.\n=,*(1),=,=,=,=,*(1)\n",
    )
    .unwrap();
    assert_eq!((deck.grids[&1].cd, deck.grids[&2].cd), (0, 1));
}

#[test]
fn commands_may_be_cut_down_and_temperatures_are_told_apart() {
    let text = "CEND\nSUPORT = 4\nTEMP(INIT) = 5\nTEMPERATURE(MATERIAL) = 6\nSUBCASE 1\nMETH = 7\nTEMP(LOAD) = 8\nSUBCASE 2\nTEMP = 9\nBEGIN BULK\nGRID,1\n";
    let deck = parse_deck("t.bdf", text).unwrap();
    let [one, two] = deck.subcases.as_slice() else { panic!("two subcases") };
    assert_eq!((one.support, one.method), (Some(4), Some(7)));
    assert_eq!((one.temperature, one.initial_temperature), (Some(8), Some(5)));
    assert_eq!((two.temperature, two.initial_temperature), (Some(9), Some(5)));
}

#[test]
fn what_wingroot_is_not_for_is_refused_by_what_it_is() {
    for (command, what) in [
        ("ADAPT = 101", "adaptive p-elements"),
        ("BCONTACT = 11", "contact or glue"),
        ("AXISYM = FLUID", "fluids"),
        ("FLUX = ALL", "heat"),
    ] {
        let deck = parse_deck("t.bdf", &format!("CEND\n{command}\nBEGIN BULK\nGRID,1\n")).unwrap();
        let error = deck.bounded(None).unwrap_err().to_string();
        let expected = format!("t.bdf:2:1: `{command}` asks for {what}");
        assert!(error.starts_with(&expected) && error.contains("which wingroot is not for"), "{error}");
    }
}

const BAR: &str = "CBAR,1,1,1,2,0.,1.,0.\nGRID,1\nGRID,2,,1.\n";

/// As Nastran sorts cards: a continuation goes to the card that announces its name, wherever it stands after it.
#[test]
fn a_named_continuation_goes_to_the_card_that_announces_it() {
    let cards = |text: &str| parse_deck("t.bdf", &format!("{BAR}{text}"));
    let near = cards("PBAR,1,1,.01,1.-4,1.-4,1.-4,,,+PB\n+PB,,,,,,,,,+P2\n+P2,.5,.25\nMAT1,1,7.+10,,.3\n")
        .expect("a deck");
    let far = cards("PBAR,1,1,.01,1.-4,1.-4,1.-4,,,+PB\nMAT1,1,7.+10,,.3\n+PB,,,,,,,,,+P2\n+P2,.5,.25\n")
        .expect("a deck");
    assert_eq!(far.beam_properties[&1].shear_factors, [0.5, 0.25]);
    assert_eq!(far.beam_properties[&1].shear_factors, near.beam_properties[&1].shear_factors);
    assert_eq!((far.materials[&1].e, far.materials[&1].rho), (7e10, 0.0));
    let before = cards("MAT1,1,7.+10,,.3\n+PB,,,,,,,,,+P2\n+P2,.5,.25\nPBAR,1,1,.01,1.-4,1.-4,1.-4,,,+PB\n")
        .unwrap_err();
    assert!(
        before
            .to_string()
            .starts_with("t.bdf:5:1: continuation `PB` stands before the card that announces it (t.bdf:7:1)"),
        "{before}"
    );
    // A name that nothing continues is a remark.
    assert!(cards("MAT1,1,7.+10,,.3,,,,+ALU\nPBAR,1,1,.01,1.-4,1.-4,1.-4\n").is_ok());
}

#[test]
fn the_name_of_a_continuation_may_stand_before_the_ninth_field_of_a_free_line() {
    let far = parse_deck("t.bdf", "MKAERO1,0., , , , , , ,+MK\n+MK,.1,.2\n").expect("a deck");
    let near = parse_deck("t.bdf", "MKAERO1,0.\n,.1,.2\n").expect("a deck");
    assert_eq!(far.reduced_frequencies[0].pairs, near.reduced_frequencies[0].pairs);
    assert!(far.air_errors.is_empty(), "{:?}", far.air_errors);
    let short = parse_deck("t.bdf", "GRID,5\nCONM2,5,5,,2.,+\n,1.\n").expect("a deck");
    assert_eq!(short.masses[&5].mass, 2.0);
    let signed = parse_deck("t.bdf", "GRID,5,,+1.,+.5\n").expect("a deck");
    assert_eq!(signed.grids[&5].xyz, [1.0, 0.5, 0.0].into(), "numbers may have a sign");
}

/// MSC Nastran Quick Reference Guide, PBAR: K1 and K2 are ignored if I12 is not zero.
#[test]
fn a_bar_with_i12_has_no_shear_flexibility() {
    let factors = |i12: &str| {
        let deck = format!("{BAR}PBAR,1,1,.01,1.-4,1.-4,1.-4\n,\n,.5,.25,{i12}\n");
        parse_deck("t.bdf", &deck).expect("a deck").beam_properties[&1].shear_factors
    };
    assert_eq!((factors(""), factors("1.-5")), ([0.5, 0.25], [0.0; 2]));
}

/// MSC Nastran's print of pyNastran's `pt145` (EIGR 10 GIV 0. .1, ND 6) has six modes above .1 Hz.
#[test]
fn a_number_of_modes_counts_more_than_the_range_of_a_transformation() {
    let method = |card: &str| {
        let deck = parse_deck("t.bdf", card).expect("a deck");
        deck.eigen_methods.values().next().map(|method| (method.highest_hz, method.count)).expect("a method")
    };
    assert_eq!(method("EIGR,10,GIV,0.,.1,,6\n"), (None, Some(6)));
    assert_eq!(method("EIGR,10,mgiv,0.,.1\n"), (Some(0.1), None));
    assert_eq!(method("EIGR,10,SINV,0.,.1,,6\n"), (Some(0.1), Some(6)));
    assert_eq!(method("EIGRL,10,,.1,6\n"), (Some(0.1), Some(6)));
}

#[test]
fn commands_that_would_change_the_answer_are_refused_or_said() {
    for command in ["P2G = LOADS", "A2GG = AIR", "MFLUID = 3", "MODESELECT = 4"] {
        let said = held(&format!("CEND\nSPC=1\n{command}\nBEGIN BULK\n"), None).unwrap_err();
        assert!(said.starts_with(&format!("t.bdf:3:1: `{command}` changes the structure")), "{said}");
    }
    let deck = |control: &str, cards: &str| {
        parse_deck("t.bdf", &format!("{control}{CLAMPS}{cards}")).expect("a deck")
    };
    let combined = deck("CEND\nSPC=1\nSUBCASE 1\nSUBCASE 2\nSUBCOM 3\nSUBSEQ=1.,1.\nBEGIN BULK\n", "");
    let remarks = combined.remarks();
    assert!(remarks.iter().any(|remark| remark.starts_with("`SUBCOM 3` is not computed")), "{remarks:?}");
    let damped = deck("CEND\nSPC=1\nB2GG = DAMP\nBEGIN BULK\n", "");
    assert_eq!(damped.subcases[0].direct, ["B2GG DAMP"]);
    assert_eq!(damped.subcases[0].id, 1, "Nastran's number of a case control without SUBCASE");
    for command in ["TEMP(MATERIAL) = 5", "TEMP(INIT) = 5"] {
        let warm = deck(&format!("CEND\nSPC=1\n{command}\nBEGIN BULK\n"), "MAT1,1,7.+10,,.3\nMATT1,1,8\n");
        let said = warm.bounded(None).unwrap_err().to_string();
        assert!(said.contains("MATT1 makes a material change with the temperature"), "{said}");
    }
}

/// Subcases that ask for different flutter of the same structure share its modes; one that selects anything else of it does not.
#[test]
fn subcases_share_modes_where_they_select_the_same_structure() {
    let shares = |second: &str| {
        let control = format!(
            "CEND\nSPC=1\nMETHOD=3\nSUBCASE 1\nFMETHOD=1\nSUBCASE 2\nFMETHOD=2\nLABEL=fast\n{second}BEGIN BULK\n"
        );
        let cases = parse_deck("t.bdf", &format!("{control}{CLAMPS}")).expect("a deck").subcases;
        cases[0].has_modes_of(&cases[1])
    };
    assert!(shares("LOAD=4\nDISP=ALL\n"));
    for other in [
        "SPC=2\n",
        "METHOD=4\n",
        "SDAMP=5\n",
        "K2PP=KX\n",
        "B2GG=DAMP\n",
        "MODESELECT=4\n",
        "TEMP(MATE)=5\n",
        "AUTOSPC=NO\n",
    ] {
        assert!(!shares(other), "{other}");
    }
}
