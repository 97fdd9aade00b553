//! Gusts and turbulence of a plan on a deck: a rigid wing beside another doublet lattice, HA144A beside SOL 146 of the same deck, laws of
//! its loads, and what is refused.

use aero::Lattice;
use fullaircraft::cases::file::DeckUnits;
use fullaircraft::design_loads::deck::DeckPlan;
use fullaircraft::design_loads::deck_gusts::DeckFlight;
use fullaircraft::design_loads::fly::Nodal;
use fullaircraft::design_loads::instants::{FlownCase, TurbulentLoad};
use fullaircraft::{
    AircraftError, CasesFile, Component, GustDeck, NodalLoads, Station, TrimDeck, gust_cases,
};
use loads::Air;
use loads::design::{Attitude, Direction, Rules, Spectrum};
use loads::matrix::{Action, Case, Status};
use maneuver::gust::{gust_incidence, gust_incidence_along};
use nastran::{BulkData, parse_deck};
use serde_json::Value;
use std::f64::consts::PI;
use std::path::Path;

/// Steady slope of the rectangle's lattice, per rad (`data/rectangular_wing_turbulence.json`).
const SLOPE: f64 = 4.298_809_448;
const G: f64 = 9.806_65;
/// The rectangle's airspeed, m/s: its chord is one metre.
const V_M_S: f64 = 10.0;
const FOOT_M: f64 = 0.3048;
const POUND_N: f64 = 4.448_221_615_260_5;

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

/// The rigid rectangle of `rectangular_wing.rs` as a half model in metres, kg and N, free in plunge in air of `rho_kg_m3`: half of its
/// mass on the centreline and half amid the wing, whose net loads NET adds up.
fn rectangle(mu: f64, rho_kg_m3: f64) -> BulkData {
    let mass = 1.5 * mu * rho_kg_m3;
    let deck = format!(
        "SOL 144\nCEND\nSPC = 1\nMETHOD = 5\nTRIM = 1\nBEGIN BULK\nGRID,1,,.5,0.,0.\nGRID,2,,.5,1.5,0.\nGRID,3,,0.,0.,0.\n\
         GRID,4,,1.,0.,0.\nGRID,5,,0.,3.,0.\nGRID,6,,1.,3.,0.\nCONM2,11,1,,{mass:?}\nCONM2,12,2,,{mass:?}\n\
         RBE2,13,1,123456,2,3,4,5,6\nCELAS2,14,1.-9,1,3\nSPC1,1,12456,1\nSUPORT,1,3\nEIGRL,5,,,1\nPAERO1,1\n\
         CAERO1,1001,1,,16,8,,,1\n,0.,0.,0.,1.,0.,3.,0.,1.\nSET1,30,3,THRU,6\nSPLINE1,20,1001,1001,1128,30\n\
         AEROS,0,0,1.,6.,3.,1\nAESTAT,501,ANGLEA\nAESTAT,503,URDD3\nTRIM,1,0.,61.25,URDD3,{G}\n\
         SET1,31,2,THRU,6\nMONPNT3,NET,net\n,34,31,,0,0.,0.,0.\nENDDATA\n"
    );
    parse_deck("wing", &deck).unwrap_or_else(|error| panic!("{error}"))
}

/// HA144A with its wing outboard of the fuselage as a station, in basic axes and turned by a quarter about x.
pub(crate) fn ha144a(change: &[(&str, &str)], more: &str) -> BulkData {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/published/decks/ha144a_fsw.bdf");
    let mut text = std::fs::read_to_string(path).expect("the shipped deck");
    let stations = "SET1,82,110,111,112,120,121,122\nCORD2R,88,0,0.,0.,0.,0.,-1.,0.,+T\n+T,1.,0.,0.\n\
                    MONPNT3,OUTER   ,wing\n,123456,82,,0,27.11325,5.,0.\n\
                    MONPNT3,TURNED  ,wing\n,123456,82,,0,27.11325,5.,0.,,+M\n+M,88\n";
    text.insert_str(text.find("ENDDATA").expect("an end"), &format!("{stations}{more}"));
    for (from, to) in change {
        assert!(text.contains(from), "{from}");
        text = text.replacen(from, to, 1);
    }
    parse_deck("ha144a", &text).unwrap_or_else(|error| panic!("{error}"))
}

pub(crate) fn feet() -> DeckUnits {
    DeckUnits { length_m: FOOT_M, force_n: POUND_N, trim: Some(1), modes_up_to_hz: Some(1000.0) }
}

fn case(v_m_s: f64, action: Action) -> Case {
    Case {
        number: 7,
        kind: "gust".to_owned(),
        mass: 0,
        h_m: 0.0,
        v_m_s,
        v_eas_m_s: v_m_s,
        mach: v_m_s / Air::at(0.0).sound_m_s,
        n_z: 1.0,
        condition: "a gust".to_owned(),
        rule: Rules::Own,
        status: Status::Planned,
        why: String::new(),
        action,
    }
}

pub(crate) fn discrete(v_m_s: f64, gradient_m: f64) -> Case {
    case(v_m_s, Action::Discrete { gradient_m, direction: Direction::Up, u_ds_m_s: 1.0, refine: false })
}

pub(crate) fn turbulence(v_m_s: f64, scale_m: f64, cut_off_hz: f64) -> Case {
    let action = Action::Turbulence {
        direction: Direction::Up,
        u_sigma_m_s: 2.0,
        scale_m,
        cut_off_hz,
        spectrum: Spectrum::Karman,
        attitude: Attitude::default(),
        longest_gradient_m: 107.0,
    };
    case(v_m_s, action)
}

/// A plan, its deck and stations.
pub(crate) struct Ready {
    pub(crate) plan: DeckPlan,
    pub(crate) deck: TrimDeck,
    pub(crate) stations: Vec<Station>,
}

impl Ready {
    pub(crate) fn new(bulk: &BulkData, units: DeckUnits, v_m_s: f64) -> Self {
        let plan = DeckPlan::new(bulk, units).unwrap_or_else(|error| panic!("{error}"));
        let deck = plan.at(1, v_m_s / Air::at(0.0).sound_m_s).unwrap_or_else(|error| panic!("{error}"));
        let stations = plan.stations(&deck, &CasesFile::default()).expect("they are there");
        Self { plan, deck, stations }
    }

    /// A case as it is flown, and loads at grids of its instants.
    pub(crate) fn fly(&self, case: &Case) -> (FlownCase, Vec<NodalLoads>) {
        let stations = &self.stations;
        let flight = DeckFlight { deck: &self.deck, stations, search: false, nodal: true, all: &[case] };
        let mut found = None;
        let done = &mut |flown: FlownCase, nodal: &Nodal<'_>| {
            let all = flown.instants.iter().filter_map(nodal).collect();
            found = Some((flown, all));
            Ok::<(), AircraftError>(())
        };
        self.plan.fly_in_gusts(flight, 1, &[case], done).expect("nothing stops it");
        found.expect("it was flown or refused")
    }

    pub(crate) fn flown(&self, case: &Case) -> (FlownCase, Vec<NodalLoads>) {
        let (flown, nodal) = self.fly(case);
        assert_eq!(flown.refused, None);
        assert!(!flown.instants.is_empty() && nodal.len() == flown.instants.len());
        (flown, nodal)
    }

    pub(crate) fn place(&self, name: &str) -> usize {
        self.stations.iter().position(|station| station.name == name).expect("a station")
    }
}

#[test]
fn a_wing_free_in_plunge_peaks_in_a_plan_s_gusts_as_by_another_doublet_lattice() {
    let text = include_str!("data/rectangular_wing_gust.json");
    let reference: Value = serde_json::from_str(text).expect("JSON");
    let rho = Air::at(0.0).rho_kg_m3;
    for row in reference["cases"].as_array().expect("a list") {
        let (mu_g, h) = (number(&row["mu_g"]), number(&row["H_over_c"]));
        let ready = Ready::new(&rectangle(0.5 * mu_g * SLOPE, rho), DeckUnits::default(), V_M_S);
        let (flown, _) = ready.flown(&discrete(V_M_S, h));
        let (net, whole) = (ready.place("NET"), ready.place("whole"));
        let half_weight = 1.5 * 0.5 * mu_g * SLOPE * rho * G;
        let largest = flown.instants.iter().map(|one| one.net()[net][2]).fold(0.0, f64::max);
        // Newton: what the centreline's mass needs is half of the lift, about its weight in level flight
        let edge = 0.5 * rho * V_M_S * SLOPE * 3.0;
        let peak = 2.0 * (largest - half_weight) / edge;
        let expected = number(&row["peak_over_sharp_edge"]);
        println!("mu_g {mu_g}, H {h} c: {peak:.6} beside {expected:.6}");
        assert!((peak / expected - 1.0).abs() < 0.01, "mu_g {mu_g}, H {h} c: {peak} beside {expected}");
        let highest = flown.instants.iter().map(|one| one.loads[whole][0][2]).fold(0.0, f64::max);
        assert!((highest - 2.0 * largest).abs() < 1e-6 * half_weight, "the air lifts twice of it: {highest}");
    }
}

#[test]
fn a_wing_free_in_plunge_has_in_a_plan_s_turbulence_the_loads_of_another_doublet_lattice() {
    let text = include_str!("data/rectangular_wing_turbulence.json");
    let reference: Value = serde_json::from_str(text).expect("JSON");
    let rho = Air::at(0.0).rho_kg_m3;
    for row in reference["turbulence"].as_array().expect("a list") {
        let (mu, scale) = (number(&row["mass_over_rho_S_c"]), number(&row["L_over_c"]));
        let ready = Ready::new(&rectangle(mu, rho), DeckUnits::default(), V_M_S);
        let (flown, nodal) = ready.flown(&turbulence(V_M_S, scale, number(&row["k_max"]) * V_M_S / PI));
        let facts = flown.turbulence.as_ref().expect("statistics");
        let net = ready.place("NET");
        let at = |load: usize| {
            let own = |one: &TurbulentLoad| (one.station, one.load) == (net, load);
            facts.loads.iter().position(own).expect("it moves")
        };
        let near = |what: &str, ours: f64, expected: &Value, share: f64| {
            println!("mu {mu}, {what}: {ours:.6} beside {expected}");
            assert!(
                (ours / number(expected) - 1.0).abs() < share,
                "mu {mu}, {what}: {ours} beside {expected}"
            );
        };
        let expected = &row["A_bar_per_w_over_V"];
        let (force, bending) = (&facts.loads[at(2)], &facts.loads[at(3)]);
        let q = 0.5 * rho * V_M_S * V_M_S;
        near("CL", 2.0 * force.a_bar * V_M_S / (3.0 * q), &expected["CL"], 0.01);
        near("net bending", bending.a_bar * V_M_S / (6.0 * q), &expected["net_bending"], 0.01);
        near("N0", force.n0_hz / V_M_S, &row["N0_acc_c_over_V"], 0.03);
        let [load_factor, _] = facts.load_factor.expect("the whole is a station");
        near("acceleration", load_factor * G / V_M_S, &expected["acc_c_over_V2"], 0.01);
        let pair = |i: usize, j: usize| facts.correlations.iter().find(|one| (one.0, one.1) == (i, j));
        let rho_ij = pair(at(2), at(3)).expect("a pair").2;
        assert!((rho_ij - number(&row["corr_acc_net_bending"])).abs() < 0.002, "mu {mu}: {rho_ij}");
        // cards of a limit sum up to the limit load and to its companions (check 17)
        let points = ready.deck.grids.free.points();
        for (instant, nodal) in flown.instants.iter().zip(&nodal) {
            let limit = instant.limit.expect("turbulence");
            let sums = ready.stations[net].sums(points, &nodal.of(Component::Net));
            let sign = if limit.is_largest { 1.0 } else { -1.0 };
            if (limit.station, limit.direction) == (net, 1) {
                let limits = [(bending, 1.0), (force, rho_ij)];
                for (load, share) in limits {
                    let expected = load.one_g + sign * share * 2.0 * load.a_bar;
                    let off = (sums[load.load] - expected).abs();
                    assert!(off < 1e-9 * bending.one_g.abs(), "{} of {expected}", sums[load.load]);
                }
            }
        }
    }
}

#[test]
fn ha144a_in_a_plan_s_gust_has_the_loads_of_sol_146_in_time() {
    // SOL 146 is met beside MSC's and NASA's numbers elsewhere; here the same deck with the cards of the same gust
    let (v_m_s, gradient_m) = (180.0, 30.0);
    let ready = Ready::new(&ha144a(&[], ""), feet(), v_m_s);
    let (flown, _) = ready.flown(&discrete(v_m_s, gradient_m));
    let air = Air::at(0.0);
    let (v, lasts) = (v_m_s / FOOT_M, 2.0 * gradient_m / v_m_s);
    let q = 0.5 * air.rho_kg_m3 * v_m_s * v_m_s * FOOT_M * FOOT_M / POUND_N;
    let mach = v_m_s / air.sound_m_s;
    let cards = format!(
        "AERO,1,{v:?},10.,{rho:.9},1\nPARAM,Q,{q:?}\nPARAM,MACH,{mach:.9}\nEIGRL,5,,1000.\n\
         MKAERO1,{mach:.9}\n,.001,.02,.05,.1,.15,.2,.3,.4\nMKAERO1,{mach:.9}\n,.5,.6,.7,.8,.9,1.,1.1,1.2\n\
         MKAERO1,{mach:.9}\n,1.3,1.4,1.5,1.6,1.7,1.8,1.9,2.\nMKAERO1,{mach:.9}\n,2.2,2.4,2.6,2.8,3.\n\
         GUST,7,8,{wg:?},-.625,{v:?}\nDLOAD,8,.5,1.,81,-1.,82\nTLOAD2,81,9,,,0.,{lasts:?},0.\n\
         TLOAD2,82,9,,,0.,{lasts:?},{hz:?}\nFREQ1,10,.025,.05,1200\nTSTEP,11,3000,.0005\n",
        rho = 2.0 * q / (v * v),
        wg = 1.0 / FOOT_M / v,
        hz = 1.0 / lasts
    );
    let change =
        [("SOL 144", "SOL 146"), ("SUBCASE 1", "METHOD = 5\nGUST = 7\nFREQ = 10\nTSTEP = 11\nSUBCASE 1")];
    let bulk = ha144a(&change, &cards);
    let gust = gust_cases(&bulk).unwrap_or_else(|error| panic!("{error}")).remove(0);
    let deck = GustDeck::new(&bulk, &gust.subcase, &[&gust]).unwrap_or_else(|error| panic!("{error}"));
    let answer = deck.answer(&gust).unwrap_or_else(|error| panic!("{error}"));
    let time = deck.in_time(&gust, &answer).expect("in time");
    for name in ["OUTER", "TURNED"] {
        let theirs = &time.stations[deck.stations().position(|one| one.0 == name).expect("a station")];
        let ours = ready.place(name);
        let level = ready.plan.fly(&ready.deck, &discrete(v_m_s, gradient_m), 1, &ready.stations);
        let level = level.case.instants[0].net()[ours];
        for (load, before) in level.iter().enumerate() {
            let of_kind = if load < 3 { 0..3 } else { 3..6 };
            let peak = theirs.loads.iter().flat_map(|one| of_kind.clone().map(|at| one.total(at).abs()));
            let peak = peak.fold(0.0, f64::max);
            for instant in flown.instants.iter().filter(|instant| instant.t_s < 1.4) {
                let unit = if load < 3 { POUND_N } else { POUND_N * FOOT_M };
                let change = (instant.net()[ours][load] - before) / unit;
                let at = instant.t_s / 0.0005;
                let (low, share) = (at.floor(), at - at.floor());
                #[expect(
                    clippy::cast_possible_truncation,
                    clippy::cast_sign_loss,
                    reason = "a place in time"
                )]
                let pair = [low as usize, low as usize + 1].map(|place| theirs.loads[place].total(load));
                let other = pair[0] * (1.0 - share) + pair[1] * share;
                let off = (change - other).abs() / peak;
                assert!(
                    off < 0.01,
                    "{name} load {load} at {} s: {change} beside {other} of {peak}",
                    instant.t_s
                );
            }
        }
    }
}

#[test]
fn loads_at_grids_in_gusts_add_up_to_the_stations_and_are_in_balance() {
    let ready = Ready::new(&ha144a(&[], "PARAM,G,.02\n"), feet(), 180.0);
    let points = ready.deck.grids.free.points();
    for case in [discrete(180.0, 30.0), turbulence(180.0, 762.0, 20.0)] {
        let (flown, nodal) = ready.flown(&case);
        let mut damped = 0.0_f64;
        for (instant, nodal) in flown.instants.iter().zip(&nodal) {
            let sums = ready.plan.at_stations(nodal, &ready.stations, points);
            let largest = |of: &[[f64; 6]; 5]| of[4].iter().fold(0.0_f64, |most, load| most.max(load.abs()));
            let size = instant.loads.iter().map(largest).fold(0.0, f64::max);
            for (ours, known) in sums.iter().flatten().flatten().zip(instant.loads.iter().flatten().flatten())
            {
                assert!((ours - known).abs() < 1e-9 * size, "{ours} {known}");
            }
            let whole = instant.loads[ready.place("whole")];
            let weight = 8000.0 * POUND_N;
            // free are plunge and pitch
            assert!(
                whole[4][2].abs() < 1e-9 * weight && whole[4][4].abs() < 1e-9 * weight * 10.0,
                "{whole:?}"
            );
            damped = damped.max(instant.loads[ready.place("OUTER")][3][2].abs());
        }
        assert!(damped > 1.0, "the structure's damping is a load: {damped} N");
    }
}

#[test]
fn twice_a_gust_changes_loads_twice_and_one_downwards_takes_away_what_one_upwards_adds() {
    let ready = Ready::new(&ha144a(&[], ""), feet(), 180.0);
    let of = |direction: Direction, u_ds_m_s: f64| {
        let action = Action::Discrete { gradient_m: 20.0, direction, u_ds_m_s, refine: false };
        ready.flown(&case(180.0, action)).0
    };
    let [up, down, twice] =
        [(Direction::Up, 1.0), (Direction::Down, 1.0), (Direction::Up, 2.0)].map(|(d, u)| of(d, u));
    let outer = ready.place("OUTER");
    let level =
        ready.plan.fly(&ready.deck, &discrete(180.0, 20.0), 1, &ready.stations).case.instants[0].net()[outer];
    let ends = |flown: &FlownCase, sign: f64| {
        let all = flown.instants.iter().map(|one| sign * (one.net()[outer][3] - level[3]));
        all.fold(f64::NEG_INFINITY, f64::max)
    };
    let most = ends(&up, 1.0);
    assert!(most > 0.0 && (ends(&down, -1.0) - most).abs() < 1e-9 * most);
    assert!((ends(&twice, 1.0) - 2.0 * most).abs() < 1e-9 * most);
}

#[test]
fn a_side_gust_meets_a_fin_as_one_upwards_meets_a_wing() {
    // a wing turned by a quarter about x, its tip up: its normal is towards -y, where a gust from the right goes
    let wing = Lattice::trapezoid(1, [0.0; 3], 1.0, [0.3, 2.0, 0.0], 0.5, [3, 2]).expect("a wing");
    let fin = Lattice::trapezoid(1, [0.0; 3], 1.0, [0.3, 0.0, 2.0], 0.5, [3, 2]).expect("a fin");
    let up = gust_incidence(&wing, 0.2, 1.3);
    let side = gust_incidence_along(&fin, [0.0, -1.0, 0.0], 0.2, 1.3);
    let from_below = gust_incidence(&fin, 0.2, 1.3);
    for at in 0..wing.len() {
        assert!((up[(at, 0)] - side[(at, 0)]).norm() < 1e-12, "box {at}");
        assert!(from_below[(at, 0)].norm() < 1e-12 && up[(at, 0)].norm() > 0.9);
    }
}

#[test]
fn a_gust_from_the_right_pushes_a_whole_deck_s_fin_to_the_left() {
    // a whole rigid aircraft of a wing and a fin, free in plunge and to the side
    let grids = "GRID,1,,.5,0.,0.\nGRID,3,,0.,-3.,0.\nGRID,4,,1.,-3.,0.\nGRID,5,,0.,3.,0.\nGRID,6,,1.,3.,0.\nGRID,7,,3.,0.,0.\n\
                 GRID,8,,4.,0.,0.\nGRID,9,,3.,0.,2.\nGRID,10,,4.,0.,2.\nCONM2,11,1,,200.\nRBE2,13,1,123456,3,4,5,6,7,+R\n+R,8,9,10\n";
    let deck = format!(
        "SOL 144\nCEND\nSPC = 1\nMETHOD = 5\nTRIM = 1\nBEGIN BULK\n{grids}CELAS2,14,1.-9,1,3\nCELAS2,15,1.-9,1,2\nSPC1,1,1456,1\n\
         SUPORT,1,23\nEIGRL,5,,,2\nPAERO1,1\nCAERO1,1001,1,,16,4,,,1\n,0.,-3.,0.,1.,0.,3.,0.,1.\nSET1,30,3,THRU,6\n\
         SPLINE1,20,1001,1001,1064,30\nCAERO1,2001,1,,6,4,,,1\n,3.,0.,0.,1.,3.,0.,2.,1.\nSET1,32,7,THRU,10\n\
         SPLINE1,21,2001,2001,2024,32\nMONPNT3,FIN     ,fin\n,246,32,,0,3.5,0.,0.\nAEROS,0,0,1.,6.,6.,0\nAESTAT,501,ANGLEA\nAESTAT,502,SIDES\nAESTAT,503,URDD3\n\
         AESTAT,504,URDD2\nTRIM,1,0.,61.25,URDD3,{G},URDD2,0.\nENDDATA\n"
    );
    let bulk = parse_deck("whole", &deck).unwrap_or_else(|error| panic!("{error}"));
    let ready = Ready::new(&bulk, DeckUnits::default(), V_M_S);
    let side = |u_ds_m_s: f64| {
        let action =
            Action::Discrete { gradient_m: 12.0, direction: Direction::Lateral, u_ds_m_s, refine: false };
        let side = case(V_M_S, action);
        assert_eq!(ready.plan.left_out(&side, &[]), None);
        let (flown, _) = ready.flown(&side);
        let [whole, fin] = ["whole", "FIN"].map(|name| ready.place(name));
        let loads: Vec<[f64; 6]> = flown.instants.iter().map(|one| one.loads[whole][0]).collect();
        let of = |load: usize, sign: f64| {
            loads.iter().map(|six| sign * six[load]).fold(f64::NEG_INFINITY, f64::max)
        };
        let lift = of(2, 1.0) - 200.0 * G;
        assert!(lift.abs() < 1e-6 * 200.0 * G, "it changes no lift: {lift}");
        assert!(
            flown.instants.iter().all(|one| (one.loads[fin][0][1] - one.loads[whole][0][1]).abs() < 1e-9)
        );
        [of(1, 1.0), of(1, -1.0)]
    };
    let [right, left] = side(1.0);
    // in slow air of 1 m/s at 10 m/s: below the fin's flat plate, 2 pi q S w/V, above a fifth of it
    let plate = 2.0 * PI * 0.5 * Air::at(0.0).rho_kg_m3 * V_M_S * 2.0;
    assert!((0.2 * plate..plate).contains(&left) && right < 0.3 * left, "{right} {left} beside {plate}");
}

#[test]
fn an_unstable_deck_a_side_gust_on_half_of_one_and_a_deck_without_modes_are_refused() {
    // the weight goes from the nose to the tail
    let aft =
        [("CONM2,97,97,0,1500.", "CONM2,97,97,0,300."), ("CONM2,100,100,0,1500.", "CONM2,100,100,0,2700.")];
    let ready = Ready::new(&ha144a(&aft, ""), feet(), 180.0);
    for case in [discrete(180.0, 30.0), turbulence(180.0, 762.0, 20.0)] {
        let why = ready.fly(&case).0.refused.expect("it is unstable");
        assert!(why.contains("unstable") && why.contains("doubles in"), "{why}");
    }
    let side =
        Action::Discrete { gradient_m: 30.0, direction: Direction::Lateral, u_ds_m_s: 1.0, refine: false };
    assert!(ready.plan.left_out(&case(180.0, side), &[]).is_some_and(|why| why.contains("half")));
    assert_eq!(ready.plan.left_out(&discrete(180.0, 30.0), &[]), None);
    assert!(ready.plan.check_modes().is_ok());
    let silent =
        DeckPlan::new(&ha144a(&[], ""), DeckUnits { modes_up_to_hz: None, ..feet() }).expect("a plan");
    let why = silent.check_modes().unwrap_err().to_string();
    assert!(why.contains("nothing says which"), "{why}");
}
