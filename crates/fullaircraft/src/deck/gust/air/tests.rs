//! Splined air of a wing of four boxes beside the lattice's own amid the widest gap, and stations of boxes and grids.

use super::GustAir;
use crate::deck::gust::stations::stations;
use crate::deck::modal::ModalDeck;
use faer::{Mat, MatRef, c64};
use maneuver::flutter::GeneralisedForces;
use nastran::parse_deck;

const UP: [f64; 3] = [0.0, 0.0, 1.0];

/// A rigid wing free in plunge, 3 kg at the root and 2 kg outboard, with reduced frequencies.
fn deck(ks: &str, more: &str) -> ModalDeck {
    let text = format!(
        "SOL 146\nCEND\nSPC = 1\nMETHOD = 5\nBEGIN BULK\nGRID,1,,.5,0.,0.\nGRID,2,,.5,1.5,0.\n\
         GRID,3,,0.,0.,0.\nGRID,4,,1.,0.,0.\n\
         GRID,5,,0.,3.,0.\nGRID,6,,1.,3.,0.\nCONM2,11,1,,3.\nCONM2,12,2,,2.\n\
         RBE2,13,1,123456,2,3,4,5,6\nCELAS2,14,1.-9,1,3\n\
         SPC1,1,12456,1\nEIGRL,5,,,1\nPAERO1,1\nCAERO1,1001,1,,2,2,,,1\n,0.,0.,0.,1.,0.,3.,0.,1.\nSET1,30,3,THRU,6\n\
         SPLINE1,20,1001,1001,1004,30\nAERO,,1.,1.,1.,1\nMKAERO1,0.\n,{ks}\n{more}"
    );
    let bulk = parse_deck("wing", &text).unwrap_or_else(|error| panic!("{error}"));
    assert!(bulk.air_errors.is_empty(), "{:?}", bulk.air_errors);
    ModalDeck::new(&bulk, &nastran::Subcase { spc: Some(1), method: Some(5), ..Default::default() }, "a gust")
        .unwrap_or_else(|error| panic!("{error}"))
}

fn air(deck: &ModalDeck, highest: f64) -> GustAir {
    GustAir::new(deck, Mat::zeros(0, 8).as_ref(), 0.0, highest, UP).expect("it can be solved")
}

fn off(a: MatRef<'_, c64>, b: MatRef<'_, c64>) -> f64 {
    (a - b).norm_l2() / b.norm_l2()
}

#[test]
fn what_splines_miss_amid_the_widest_gap_is_said_beside_the_lattice_solved_there() {
    // omega/V = 2 k: rest, 0.2, 1.0, 1.4; the widest gap is amid 0.6
    let (coarse, fine) = (deck(".1,.5,.7", ""), deck(".1,.3,.5,.7", ""));
    let [rough, exact] = [&coarse, &fine].map(|deck| air(deck, 1.0));
    let modal = |of: &GustAir| of.modal.at(0.6, 1.0).expect("within the table");
    // three-quarter points of two boxes: 0.375 and 0.875 m
    let gust = |of: &GustAir| of.gust.at(0.6, 0.625).expect("within the table");
    let law = off(modal(&rough).as_ref(), modal(&exact).as_ref())
        .max(off(gust(&rough).as_ref(), gust(&exact).as_ref()));
    assert!((rough.missed - law).abs() < 1e-9 * law, "{} {law}", rough.missed);
    assert!(law > 1e-6 && exact.missed < rough.missed);
    assert_eq!(rough.remarks.iter().any(|remark| remark.contains("are off by")), law > 0.02);
    // far apart they are off by more than is passed over in silence
    let far = air(&deck(".01,2.", ""), 1.0);
    assert!(far.missed > 0.02, "{}", far.missed);
    let words = format!(
        "between the reduced frequencies 0.0100 and 2.0000 of MKAERO the splined air forces are off by {:.0} %",
        100.0 * far.missed
    );
    assert!(far.remarks.iter().any(|remark| remark.contains(&words)), "{:?}", far.remarks);
}

#[test]
fn frequencies_beyond_those_of_the_deck_are_added_and_a_mach_number_that_is_not_there_is_said() {
    let deck = deck(".1,.5,.7", "");
    assert!(air(&deck, 1.4).remarks.iter().all(|remark| !remark.contains("end at")));
    let beyond = air(&deck, 1.6);
    let words = "end at the reduced frequency 0.7000, the frequencies at 0.8000";
    assert!(beyond.remarks.iter().any(|remark| remark.contains(words)), "{:?}", beyond.remarks);
    assert!(beyond.modal.at(1.6, 1.0).is_ok() && air(&deck, 1.0).modal.at(1.6, 1.0).is_err());
    let faster = GustAir::new(&deck, Mat::zeros(0, 8).as_ref(), 0.3, 1.0, UP).expect("it can be solved");
    assert!(faster.remarks[0].contains("no Mach number 0.3; forces are those of 0") && faster.mach == 0.0);
    assert!(faster.on_stations(0.5, Mat::zeros(1, 1).as_ref()).is_none());
    let twice = deck_gust(&faster, c64::new(0.0, 2.0));
    let one = deck_gust(&faster, c64::new(1.0, 0.0));
    assert!((twice - one * c64::new(0.0, 2.0)).norm() < 1e-14 * one.norm());
}

fn deck_gust(air: &GustAir, amplitude: c64) -> c64 {
    air.of_gust(0.5, 0.0, amplitude).expect("within the table")[(0, 0)]
}

#[test]
fn each_station_adds_up_its_own_boxes_or_grids_about_its_point() {
    let more = "AECOMP,IN,AELIST,40\nAELIST,40,1001,1002\nAECOMP,OUT,AELIST,41\nAELIST,41,1003,1004\n\
                MONPNT1,INNER,in\n,35,IN,0,.2,0.,0.,0\nMONPNT1,OUTER,out\n,3,OUT,0,0.,1.,0.,0\n\
                SET1,31,2,5,6\nMONPNT3,NET,net\n,3,31,,0,0.,1.,0.\n\
                AECOMP,GRIDS,SET1,31\nMONPNT1,POINTS,of grids\n,3,GRIDS,0,0.,1.,0.,0\n\
                AECOMP,LOST,AELIST,41\nMONPNT1,GONE,not there\n,3,NONE,0,0.,0.,0.,0\n";
    let deck = deck(".1,.5", more);
    let (all, left_out) = stations(&deck).expect("stations");
    let names: Vec<&str> = all.iter().map(|station| station.name.as_str()).collect();
    assert_eq!((names, left_out), (vec!["INNER", "OUTER", "NET", "POINTS"], vec!["GONE".to_owned()]));
    assert_eq!(
        all.iter().map(|station| station.is_structural).collect::<Vec<_>>(),
        [false, false, true, true]
    );
    for (station, (boxes, at)) in all.iter().zip([([0, 1], [0.2, 0.0]), ([2, 3], [0.0, 1.0])]) {
        for (j, panel) in deck.lattice.boxes.iter().enumerate() {
            let own = f64::from(u8::from(boxes.contains(&j)));
            let mid = panel.mid_point();
            // a lift at the box: Fz, Mx = y Fz, My = -x Fz; a nose-up moment: My
            let law = [0.0, 0.0, own, own * (mid.y - at[1]), -own * (mid.x - at[0]), 0.0];
            for (row, law) in law.into_iter().enumerate() {
                assert!((station.rows[(row, 2 * j)] - law).abs() < 1e-12, "{} {row} {j}", station.name);
                let moment = if row == 4 { own } else { 0.0 };
                assert!((station.rows[(row, 2 * j + 1)] - moment).abs() < 1e-12);
            }
        }
        assert!(station.inertia.norm_l2() == 0.0, "the air alone");
    }
    // grid 2 has 2 kg at x = 0.5 m, y = 1.5 m; the plunge of 5 kg with a modal mass of one is 1/sqrt(5)
    let up = deck.shapes[(6 * deck.system.node_index(1).expect("a grid") + 2, 0)];
    assert!((up.abs() - 0.2_f64.sqrt()).abs() < 1e-9);
    for station in &all[2..] {
        let law = [0.0, 0.0, 2.0 * up, 2.0 * up * 0.5, -2.0 * up * 0.5, 0.0];
        for (row, law) in law.into_iter().enumerate() {
            assert!((station.inertia[(row, 0)] - law).abs() < 1e-9, "{} {row}", station.name);
        }
    }
}
