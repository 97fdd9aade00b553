//! A plan of design loads on HA144A: published trims and weights, laws of its loads, and the round trip of its cards.

use fullaircraft::cases::file::DeckUnits;
use fullaircraft::design_loads::deck::{DeckFlown, DeckPlan};
use fullaircraft::package::cards::{CardCase, structure_of};
use fullaircraft::package::round_trip::{Balanced, Expected, Own, RoundTrip, Row};
use fullaircraft::{CasesFile, Component, Station, TrimDeck};
use loads::Air;
use loads::design::Rules;
use loads::matrix::{Action, Case, Status};
use nastran::{BulkData, parse_deck};
use std::path::Path;
use structure::{Model, System};

const FOOT_M: f64 = 0.3048;
const POUND_N: f64 = 4.448_221_615_260_5;
/// The whole aircraft, 16 000 lb.
const MASS_KG: f64 = 7_257.477_92;

/// HA144A with its wing outboard of the fuselage as a station, in basic axes and turned by a quarter about x.
fn ha144a() -> BulkData {
    let more = "SET1,82,110,111,112,120,121,122\nCORD2R,88,0,0.,0.,0.,0.,-1.,0.,+T\n+T,1.,0.,0.\n\
                MONPNT3,OUTER   ,wing\n,123456,82,,0,27.11325,5.,0.\n\
                MONPNT3,TURNED  ,wing\n,123456,82,,0,27.11325,5.,0.,,+M\n+M,88\n\
                AECOMP,ALL,CAERO,1000,1100\nMONPNT1,AIR     ,all boxes\n,123456,ALL,0,15.,0.,0.\n";
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/published/decks/ha144a_fsw.bdf");
    let mut text = std::fs::read_to_string(path).expect("the shipped deck");
    text.insert_str(text.find("ENDDATA").expect("an end"), more);
    parse_deck("ha144a", &text).expect("cards that are right")
}

fn units(trim: u32) -> DeckUnits {
    DeckUnits { length_m: FOOT_M, force_n: POUND_N, trim: Some(trim), modes_up_to_hz: None }
}

/// A pull-up at a dynamic pressure in psf at Mach 0.9 in the air at sea level.
fn pull(q_psf: f64, n_z: f64) -> Case {
    let q_pa = q_psf * POUND_N / (FOOT_M * FOOT_M);
    let v_m_s = (2.0 * q_pa / Air::at(0.0).rho_kg_m3).sqrt();
    Case {
        number: 1,
        kind: "corner".to_owned(),
        mass: 0,
        h_m: 0.0,
        v_m_s,
        v_eas_m_s: v_m_s,
        mach: 0.9,
        n_z,
        condition: "corner A".to_owned(),
        rule: Rules::Own,
        status: Status::Planned,
        why: String::new(),
        action: Action::Trim,
    }
}

struct Ready {
    plan: DeckPlan,
    deck: TrimDeck,
    stations: Vec<Station>,
}

fn ready() -> Ready {
    let plan = DeckPlan::new(&ha144a(), units(1)).expect("its first trim is level flight");
    let deck = plan.at(1, 0.9).expect("it is trimmed");
    let stations = plan.stations(&deck, &CasesFile::default()).expect("they are there");
    Ready { plan, deck, stations }
}

impl Ready {
    fn fly(&self, q_psf: f64, n_z: f64) -> DeckFlown {
        let flown = self.plan.fly(&self.deck, &pull(q_psf, n_z), 1, &self.stations);
        assert_eq!(flown.case.refused, None);
        flown
    }
}

fn near(what: &str, value: f64, expected: f64, share: f64) {
    assert!((value / expected - 1.0).abs() < share, "{what}: {value} for {expected}");
}

#[test]
fn level_flight_of_a_plan_is_the_published_trim_and_the_aircraft_weighs_and_lifts_as_published() {
    let ready = ready();
    // MSC.Nastran Aeroelastic Analysis User's Guide, HA144A: 16 000 lb, angles of trim at 40 and 1200 psf, rigid CZ by alpha of -5.071
    near("mass", ready.plan.mass_kg(&ready.deck), MASS_KG, 1e-5);
    let airframe = ready.plan.airframe(&ready.deck).unwrap();
    near("area", airframe.area_m2, 400.0 * FOOT_M * FOOT_M, 1e-12);
    near("chord", airframe.mean_chord_m, 10.0 * FOOT_M, 1e-12);
    near("slope", airframe.lift_slope_per_rad, 5.071, 2e-4);
    for (q_psf, alpha, elevator) in [(40.0, 0.169_191_0, 0.492_456_7), (1200.0, 1.373_015e-3, 1.932_495e-2)] {
        let flown = ready.fly(q_psf, 1.0);
        near("ANGLEA", flown.values["ANGLEA"], alpha, 2e-6);
        near("ELEV", flown.values["ELEV"], elevator, 2e-6);
        // half of the aircraft's weight
        near("lift", flown.air["AIR"][2], 0.5 * 16_000.0 * POUND_N, 1e-5);
    }
}

#[test]
fn loads_of_load_factors_superpose_balance_and_stations_are_those_of_the_monitoring_points() {
    let ready = ready();
    let of = |n_z: f64| ready.fly(1200.0, n_z);
    let (one, two, half) = (of(1.0), of(2.0), of(1.5));
    let names: Vec<&str> = ready.stations.iter().map(|station| station.name.as_str()).collect();
    assert_eq!(names, ["OUTER", "TURNED", "whole"]);
    let net = |flown: &DeckFlown, station: usize| flown.case.instants[0].net()[station];
    for load in 0..6 {
        let (a, b, middle) = (net(&one, 0)[load], net(&two, 0)[load], net(&half, 0)[load]);
        let size = net(&two, 0).iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        assert!((0.5 * (a + b) - middle).abs() < 1e-9 * size, "{load}: {a} {middle} {b}");
    }
    // a pull-up of two lifts twice the weight: URDD3 goes with n; and its pitch rate is there
    near("lift", two.air["AIR"][2], 16_000.0 * POUND_N, 1e-5);
    let v_m_s = pull(1200.0, 2.0).v_m_s;
    near("PITCH", two.values["PITCH"], 9.806_65 * 10.0 * FOOT_M / (2.0 * v_m_s * v_m_s), 1e-12);
    let [force, _, lift, _, pitch, _] = net(&two, 2);
    let size = 16_000.0 * POUND_N;
    assert!(force.abs() < 1e-9 * size && lift.abs() < 1e-9 * size && pitch.abs() < 1e-9 * size * 4.0);
    // a quarter turn about x: its z is -y, its y is z
    let (basic, turned) = (net(&two, 0), net(&two, 1));
    for from in [0, 3] {
        assert_eq!([turned[from], turned[from + 2]], [basic[from], -basic[from + 1]], "{turned:?} {basic:?}");
        assert_eq!(turned[from + 1], basic[from + 2]);
    }
    // the deck's own sums of the same trim, made of motions on the s-set
    let card = nastran::Trim { q: 1200.0, ..ha144a().trims[&2].clone() };
    let known = ready.deck.trim_card(&card).unwrap().monitors;
    for (station, name) in [(0, "OUTER"), (1, "TURNED")] {
        let size = known[name].iter().fold(0.0_f64, |most, value| most.max(value.abs()));
        for (load, value) in known[name].iter().enumerate() {
            let unit = if load < 3 { POUND_N } else { POUND_N * FOOT_M };
            assert!((net(&one, station)[load] / unit - value).abs() < 1e-9 * size, "{name} {load}");
        }
    }
}

#[test]
fn cards_for_a_deck_s_structure_read_back_give_stations_balance_and_tip_and_a_spoilt_one_does_not() {
    let ready = ready();
    let grids = &ready.deck.grids;
    let text = structure_of(&ready.plan.bulk, &["a test".to_owned()]);
    assert!(text.contains("CBAR") && !text.contains("CAERO1") && !text.contains("TRIM"), "{text}");
    let (support, components) = grids.support.clone().expect("a SUPORT");
    assert_eq!((support, components.as_slice()), (90, &[3, 5][..]));
    let back = |balanced: Vec<Balanced>| {
        let own = Own {
            free: &grids.free,
            held: &grids.held,
            tips: vec![("right tip", grids.free.node_index(122).unwrap())],
            balanced,
            assemble: |bulk| System::assemble(&Model::from_deck(bulk, None)?),
        };
        RoundTrip::of(own, &ready.stations, &text).unwrap()
    };
    let below = back(grids.balanced.iter().map(beside_a_clamp).collect());
    let back = back(grids.balanced.clone());
    let net = ready.fly(1200.0, 2.5).nodal.expect("loads").of(Component::Net);
    let tip: f64 = net.iter().enumerate().map(|(dof, load)| back.tips()[(dof, 0)] * load).sum();
    assert!(tip > 0.01, "the tip goes up by {tip} ft");
    let points = grids.free.points();
    let expected = Expected {
        stations: ready.stations.iter().map(|station| station.sums(points, &net)).collect(),
        tips_m: vec![tip],
    };
    let case = CardCase { sid: 1, words: "pull-up".to_owned(), net, parts: Vec::new() };
    let cards = case.text_in("lbf, ft", grids.free.node_ids(), &[]);
    let rows = back.compare(&case, &cards, &expected).unwrap();
    assert_eq!(rows.len(), 6 * 3 + 2 + 1 + 1);
    assert!(rows.iter().all(Row::holds), "{rows:?}");
    let spoilt = cards.replacen("              1.\n", "           1.001\n", 1);
    assert_ne!(spoilt, cards);
    assert!(
        !back.compare(&case, &spoilt, &expected).unwrap().iter().all(Row::holds),
        "a card 0.1 % too large"
    );
    // A force along x at the supported grid, which a clamp ten feet below would take, is in balance with a moment of -10 times it.
    let mut net = case.net.clone();
    let first = 6 * grids.free.node_index(support).unwrap();
    (net[first], net[first + 4]) = (net[first] + 1e4, net[first + 4] - 1e5);
    let pulled = CardCase { net, ..case };
    let cards = pulled.text_in("lbf, ft", grids.free.node_ids(), &[]);
    let of_balance = |back: &RoundTrip<'_>| {
        let rows = back.compare(&pulled, &cards, &expected).unwrap();
        rows.iter().filter(|row| row.place == "balance").all(Row::holds)
    };
    assert!(of_balance(&below) && !of_balance(&back));
}

/// Pitch that leaves a point ten feet below the supported grid where it is along x.
fn beside_a_clamp(plain: &Balanced) -> Balanced {
    let lever = if plain.load == 4 { 10.0 } else { 0.0 };
    let [_, rest @ ..] = plain.shares;
    let mut shares = [lever; 6];
    shares[1..].copy_from_slice(&rest);
    Balanced { shares, ..plain.clone() }
}

#[test]
fn a_card_that_is_not_level_flight_or_units_of_another_deck_are_refused() {
    let metres = DeckUnits { trim: Some(1), ..DeckUnits::default() };
    let error = DeckPlan::new(&ha144a(), metres).unwrap_err().to_string();
    assert!(error.contains("not level flight") && error.contains("32.17"), "{error}");
    let error = DeckPlan::new(&ha144a(), units(7)).unwrap_err();
    assert!(error.to_string().contains("no TRIM"), "{error}");
}
