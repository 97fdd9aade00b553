//! K2GG and M2GG add to a structure what elements would.

use nastran::parse_deck;
use structure::{Model, System};

fn system(case: &str, cards: &str) -> Result<System, String> {
    let deck = parse_deck("t.bdf", &format!("CEND\n{case}BEGIN BULK\n{cards}"))
        .map_err(|error| error.to_string())?;
    let model = Model::from_deck(&deck, None).map_err(|error| error.to_string())?;
    System::assemble(&model).map_err(|error| error.to_string())
}

/// Two turned grids, an oblique one held, with a spring and a lump so that all is attached.
const GRIDS: &str = "CORD2R,4,0,0.,0.,0.,.3,.2,1.,+\n+,1.,.5,0.\nGRID,1,,0.,0.,0.,4\nGRID,2,,1.,.5,-.2,4\nGRID,3,,2.,1.,.4\n\
                     CELAS2,50,2.,1,1,3,2\nCONM2,60,2,0,1.5\n";

#[track_caller]
fn assert_alike(a: &System, b: &System) {
    let n = 6 * a.node_count();
    let unit = |j: usize| faer::Mat::from_fn(n, 1, |i, _| f64::from(u8::from(i == j)));
    for j in 0..n {
        for (of, other) in [
            (a.inertia_loads(unit(j).as_ref()), b.inertia_loads(unit(j).as_ref())),
            (a.elastic_loads(unit(j).as_ref()), b.elastic_loads(unit(j).as_ref())),
        ] {
            assert!((&of - &other).norm_max() < 1e-12, "column {j}: {of:?} {other:?}");
        }
    }
}

#[test]
fn a_stiffness_between_two_motions_is_a_spring_between_them() {
    let springs = format!("{GRIDS}CELAS2,7,5.,1,3,2,5\n");
    let matrix = format!("{GRIDS}DMIG,K,0,6,1,0\nDMIG,K,1,3,,1,3,5.,,+\n+,2,5,-5.\nDMIG,K,2,5,,2,5,5.\n");
    let by_elements = system("", &springs).expect("springs");
    assert_alike(&by_elements, &system("K2GG = K\n", &matrix).expect("one triangle"));
    let both = format!("{matrix}DMIG,K,2,5,,1,3,-5.\n");
    assert_alike(&by_elements, &system("K2GG = K\n", &both).expect("both triangles"));
    // not selected, it is not there
    assert_alike(&system("", GRIDS).expect("a deck"), &system("", &matrix).expect("a deck"));
}

#[test]
fn a_mass_matrix_is_in_units_of_mass_whatever_weights_are_in() {
    let lump = format!("{GRIDS}CONM2,7,3,0,4.\n");
    let diagonal = |value: f64| {
        (1..=3).fold(format!("{GRIDS}DMIG,M,0,6,1,0\n"), |all, c| {
            all + &format!("DMIG,M,3,{c},,3,{c},{value:?}\n")
        })
    };
    assert_alike(
        &system("", &lump).expect("a lump"),
        &system("M2GG = M\n", &diagonal(4.0)).expect("a matrix"),
    );
    let weighed = system("", &format!("{lump}PARAM,WTMASS,.25\n")).expect("weights");
    let matrix = system("M2GG = M\n", &format!("{}PARAM,WTMASS,.25\n", diagonal(1.0))).expect("a mass");
    assert_alike(&weighed, &matrix);
}

#[test]
fn what_is_no_symmetric_matrix_of_the_grids_is_refused() {
    for (cards, said) in [
        ("", "t.bdf:2:1: DMIG K is not there"),
        ("DMIG,K,0,2,1,0\nDMIG,K,1,3,,1,3,5.\n", "DMIG K is not real and symmetric"),
        ("DMIG,K,0,6,3,0\nDMIG,K,1,3,,1,3,5.\n", "DMIG K is not real and symmetric"),
        ("DMIG,K,0,6,1,0\nDMIG,K,1,3,,2,3,5.\nDMIG,K,2,3,,1,3,5.1\n", "not symmetric: "),
        ("DMIG,K,0,6,1,0\nDMIG,K,1,3,,2,3,5.,,+\n+,2,3,5.\n", "given twice"),
        ("DMIG,K,0,6,1,0\nDMIG,K,8,3,,2,3,5.\n", "GRID 8"),
        ("DMIG,K,0,6,1,0\nDMIG,K,1,0,,2,3,5.\n", "no component for GRID 1"),
    ] {
        let error = system("K2GG = K\n", &format!("{GRIDS}{cards}")).expect_err(said);
        assert!(error.contains(said), "{error}");
    }
}
