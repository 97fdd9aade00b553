//! What stations show of a plan's gusts on a deck: nothing of the whole, limits of turbulence, worst gradients.

use crate::deck_plan_gusts::{Ready, discrete, feet, ha144a, turbulence};
use fullaircraft::AircraftError;
use fullaircraft::cases::file::DeckUnits;
use fullaircraft::design_loads::deck_gusts::DeckFlight;
use fullaircraft::design_loads::fly::Nodal;
use fullaircraft::design_loads::instants::FlownCase;
use loads::matrix::{Action, Case};
use nastran::parse_deck;

const G: f64 = 9.806_65;
const V_M_S: f64 = 10.0;

#[test]
fn a_gust_that_no_station_shows_is_refused_with_that_reason_and_not_for_its_decay() {
    // a flying wing free in plunge and pitch, its mass ahead, and no station but the whole: in balance at every instant
    let whole = "GRID,1,,-.5,0.,0.\nGRID,3,,0.,-3.,0.\nGRID,4,,1.,-3.,0.\nGRID,5,,0.,3.,0.\nGRID,6,,1.,3.,0.\nCONM2,11,1,,200.,,,,,+C\n+C,200.,,100.,,,200.\n\
                 RBE2,13,1,123456,3,4,5,6\nCELAS2,14,1.-9,1,3\nCELAS2,15,1.-9,1,5\nSPC1,1,1246,1\nSUPORT,1,35\nEIGRL,5,,,2\nPAERO1,1\n\
                 CAERO1,1001,1,,16,4,,,1\n,0.,-3.,0.,1.,0.,3.,0.,1.\nSET1,30,3,THRU,6\nSPLINE1,20,1001,1001,1064,30\n\
                 AEROS,0,0,1.,6.,6.,0\nAESTAT,501,ANGLEA\nAESTAT,503,URDD3\nAESTAT,504,URDD5\n";
    let of = |more: &str| {
        let deck = format!(
            "SOL 144\nCEND\nSPC = 1\nMETHOD = 5\nTRIM = 1\nBEGIN BULK\n{whole}TRIM,1,0.,61.25,URDD3,{G}\n{more}ENDDATA\n"
        );
        let bulk = parse_deck("whole", &deck).unwrap_or_else(|error| panic!("{error}"));
        Ready::new(&bulk, DeckUnits::default(), V_M_S).fly(&discrete(V_M_S, 12.0)).0
    };
    let why = of("").refused.expect("nothing to judge by");
    assert!(why.contains("no load") && why.contains("MONPNT3") && !why.contains("is left"), "{why}");
    let right = of("SET1,31,5,6\nMONPNT3,RIGHT   ,tip\n,34,31,,0,0.,0.,0.\n");
    assert!(right.refused.is_none() && !right.instants.is_empty(), "{:?}", right.refused);
}

#[test]
fn in_turbulence_a_load_at_its_limit_is_level_flight_and_u_sigma_times_a_on_a_damped_deck_in_feet() {
    // check 17: cards of an instant are its nodal loads, and A is of the stations' net loads; both have the deck's units and its damping
    let ready = Ready::new(&ha144a(&[], "PARAM,G,.05\n"), feet(), 180.0);
    let rough = turbulence(180.0, 762.0, 20.0);
    let Action::Turbulence { u_sigma_m_s, .. } = rough.action else { panic!("turbulence") };
    let (flown, _) = ready.flown(&rough);
    let facts = flown.turbulence.as_ref().expect("statistics");
    let mut judged = 0;
    for instant in &flown.instants {
        let limit = instant.limit.expect("turbulence");
        let bending = facts.loads.iter().find(|fact| (fact.station, fact.load) == (limit.station, 3));
        let (1, Some(fact)) = (limit.direction, bending) else { continue };
        let sign = if limit.is_largest { 1.0 } else { -1.0 };
        let (expected, found) =
            (fact.one_g + sign * u_sigma_m_s * fact.a_bar, instant.net()[limit.station][3]);
        assert!((found - expected).abs() < 1e-9 * (fact.one_g.abs() + fact.a_bar), "{found} for {expected}");
        judged += 1;
    }
    assert!(judged >= 4, "both ends at two stations or more: {judged}");
}

#[test]
fn a_gradient_that_the_search_finds_is_flown_at_the_sixth_root_of_its_length() {
    let ready = Ready::new(&ha144a(&[], "PARAM,G,.05\n"), feet(), 180.0);
    let family: Vec<Case> = [(1, 9.0), (2, 25.0), (3, 60.0), (4, 107.0)]
        .map(|(number, gradient_m)| {
            let one = discrete(180.0, gradient_m);
            let Action::Discrete { direction, u_ds_m_s, .. } = one.action else { panic!("a gust") };
            let u_ds_m_s = u_ds_m_s * (gradient_m / 9.0_f64).powf(1.0 / 6.0);
            Case { number, action: Action::Discrete { gradient_m, direction, u_ds_m_s, refine: true }, ..one }
        })
        .to_vec();
    let all: Vec<&Case> = family.iter().collect();
    let fly = |cases: &[&Case], search: bool| -> Vec<FlownCase> {
        let flight =
            DeckFlight { deck: &ready.deck, stations: &ready.stations, search, nodal: false, all: &all };
        let mut found = Vec::new();
        let done = &mut |flown: FlownCase, _: &Nodal<'_>| {
            found.push(flown);
            Ok::<(), AircraftError>(())
        };
        ready.plan.fly_in_gusts(flight, 1, cases, done).expect("nothing stops it");
        found
    };
    let searched = fly(&all, true);
    let kept: Vec<_> = searched
        .iter()
        .flat_map(|case| case.instants.iter().filter(|one| one.gradient_m.is_some()))
        .collect();
    let h_m = kept.first().and_then(|one| one.gradient_m).expect("a gradient between those of the plan");
    // CS 25.341(a)(4): U_ds grows with the sixth root of the gradient
    let Action::Discrete { direction, u_ds_m_s, .. } = family[0].action else { panic!("a gust") };
    let u_ds_m_s = u_ds_m_s * (h_m / 9.0).powf(1.0 / 6.0);
    let action = Action::Discrete { gradient_m: h_m, direction, u_ds_m_s, refine: false };
    let alone = fly(&[&Case { number: 1, action, ..family[0].clone() }], false);
    for one in kept.iter().filter(|one| one.gradient_m == Some(h_m)) {
        let twin =
            alone[0].instants.iter().find(|twin| (twin.t_s - one.t_s).abs() < 1e-9).expect("its instant");
        let size = one.net().iter().flatten().fold(0.0_f64, |most, load| most.max(load.abs()));
        for (ours, known) in one.net().iter().flatten().zip(twin.net().iter().flatten()) {
            assert!((ours - known).abs() < 1e-9 * size, "H {h_m} m: {ours} for {known}");
        }
    }
}
