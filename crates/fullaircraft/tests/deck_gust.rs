//! Gusts of decks (SOL 146): a rigid wing beside another doublet lattice, one spring beside closed forms, and laws.

use faer::c64;
use fullaircraft::{DeckGust, DynamicAnswer, GustCase, GustDeck, gust_cases};
use nalgebra::{Rotation3, Vector3};
use nastran::{BulkData, parse_deck};
use serde_json::Value;
use std::f64::consts::{PI, TAU};
use std::fmt::Write as _;

/// Steady slope of the rectangle's lattice, per rad (`data/rectangular_wing_turbulence.json`).
pub(crate) const SLOPE: f64 = 4.298_809_448;
const MU: f64 = 20.0;

fn number(value: &Value) -> f64 {
    value.as_f64().expect("a number")
}

fn reference(text: &str, of: &str) -> Vec<Value> {
    let value: Value = serde_json::from_str(text).expect("JSON");
    value[of].as_array().expect("a list").clone()
}

/// The rigid rectangle of `rectangular_wing.rs` as a half model: chord, airspeed and density one, free in plunge, half of its mass on
/// the centreline and half amid the wing. It stands in system 9, which is turned by `turn`; the stream flows along its x.
fn rectangle(mu: f64, turn: &Rotation3<f64>, control: &str, cards: &str) -> BulkData {
    let bulk = parse_deck("wing", &rectangle_text(mu, turn, control, cards));
    let bulk = bulk.unwrap_or_else(|error| panic!("{error}"));
    assert!(bulk.air_errors.is_empty(), "{:?}", bulk.air_errors);
    bulk
}

/// The text of [`rectangle`].
pub(crate) fn rectangle_text(mu: f64, turn: &Rotation3<f64>, control: &str, cards: &str) -> String {
    let origin = if turn.angle() == 0.0 { Vector3::zeros() } else { Vector3::new(3.0, -2.0, 0.5) };
    let [up, along] = [Vector3::z(), Vector3::x()].map(|axis| origin + turn * axis);
    let list = |v: &Vector3<f64>| format!("{:.12},{:.12},{:.12}", v.x, v.y, v.z);
    let mut deck = format!("SOL 146\nCEND\nSPC = 1\nMETHOD = 5\nDISP = ALL\n{control}BEGIN BULK\n");
    let _ = writeln!(deck, "CORD2R,9,,{},{}\n,{}", list(&origin), list(&up), list(&along));
    for (id, x, y) in
        [(1, 0.5, 0.0), (2, 0.5, 1.5), (3, 0.0, 0.0), (4, 1.0, 0.0), (5, 0.0, 3.0), (6, 1.0, 3.0)]
    {
        let _ = writeln!(deck, "GRID,{id},9,{x:?},{y:?},0.,9");
    }
    let _ = writeln!(deck, "CONM2,11,1,,{:?}\nCONM2,12,2,,{:?}", 1.5 * mu, 1.5 * mu);
    deck.push_str(
        "RBE2,13,1,123456,2,3,4,5,6\nCELAS2,14,1.-9,1,3\nSPC1,1,12456,1\nEIGRL,5,,,1\nPAERO1,1\n\
         CAERO1,1001,1,9,16,8,,,1\n,0.,0.,0.,1.,0.,3.,0.,1.\nSET1,30,3,THRU,6\nSPLINE1,20,1001,1001,1128,30\n\
         AERO,9,1.,1.,1.,1\nPARAM,Q,.5\nMKAERO1,0.\n,1.-4,.003,.01,.03,.06,.1,.15,.2\nMKAERO1,0.\n\
         ,.27,.35,.45,.55,.7,.85,1.,1.2\nMKAERO1,0.\n,1.4,1.6,1.8,2.\n\
         AECOMP,ALL,CAERO,1001\nMONPNT1,AIR,air\n,34,ALL,9,0.,0.,0.,9\nSET1,31,2,THRU,6\nMONPNT3,NET,net\n,34,31,,9,0.,0.,0.\n",
    );
    deck += cards;
    deck
}

/// The only case of a deck, its structure and air, and its answer.
pub(crate) fn solved(bulk: &BulkData) -> (GustCase, GustDeck, DynamicAnswer) {
    let case = gust_cases(bulk).unwrap_or_else(|error| panic!("{error}")).remove(0);
    let deck = GustDeck::new(bulk, &case.subcase, &[&case]).unwrap_or_else(|error| panic!("{error}"));
    let answer = deck.answer(&case).unwrap_or_else(|error| panic!("{error}"));
    (case, deck, answer)
}

pub(crate) fn station(deck: &GustDeck, name: &str) -> usize {
    deck.stations().position(|station| station.0 == name).expect("a station")
}

/// One wave of one minus cosine, of amplitude one and 2 H chords, at the frequencies of the reference.
pub(crate) fn wave(h: f64) -> String {
    format!(
        "GUST,7,8,1.,0.,1.\nDLOAD,8,.5,1.,81,-1.,82\nTLOAD2,81,9,,,0.,{t:?},0.\nTLOAD2,82,9,,,0.,{t:?},{f:?}\n\
         FREQ1,10,2.5-4,2.5-4,2545\nTSTEP,11,400,.1\n",
        t = 2.0 * h,
        f = 0.5 / h
    )
}
pub(crate) const IN_TIME: &str = "GUST = 7\nFREQ = 10\nTSTEP = 11\n";

#[test]
fn a_deck_free_in_plunge_peaks_in_discrete_gusts_as_by_another_doublet_lattice() {
    for row in reference(include_str!("data/rectangular_wing_gust.json"), "cases") {
        let (mu_g, h) = (number(&row["mu_g"]), number(&row["H_over_c"]));
        if mu_g > 50.0 {
            continue;
        }
        let bulk = rectangle(0.5 * mu_g * SLOPE, &Rotation3::identity(), IN_TIME, &wave(h));
        let (case, deck, answer) = solved(&bulk);
        let time = deck.in_time(&case, &answer).expect("in time");
        let motions = time.of_grid(&deck.shapes_at(1).expect("a grid"));
        let peak = motions.iter().map(|motion| motion[1][2]).fold(0.0, f64::max) * mu_g;
        let expected = number(&row["peak_over_sharp_edge"]);
        println!("mu_g {mu_g}, H {h} c: {peak:.6} beside {expected:.6}");
        assert!((peak / expected - 1.0).abs() < 0.01, "mu_g {mu_g}, H {h} c: {peak} beside {expected}");
        // Newton: the air on all boxes is mass times acceleration, the net loads of the wing what is left for the centreline.
        let [air, net] = [station(&deck, "AIR"), station(&deck, "NET")];
        let half_mass = 1.5 * 0.5 * mu_g * SLOPE;
        for (at, motion) in motions.iter().enumerate() {
            let lift = time.stations[air].loads[at].total(2);
            assert!((lift - 2.0 * half_mass * motion[1][2]).abs() < 1e-6 * half_mass, "lift at {at}");
            let left = time.stations[net].loads[at].total(2);
            assert!((left - half_mass * motion[1][2]).abs() < 1e-6 * half_mass, "net load at {at}");
        }
        assert!(time.remarks.iter().any(|remark| remark.contains("no mean")), "{:?}", time.remarks);
    }
}

#[test]
fn a_deck_in_turbulence_has_the_loads_of_another_doublet_lattice() {
    for row in reference(include_str!("data/rectangular_wing_turbulence.json"), "turbulence") {
        let (mu, scale) = (number(&row["mass_over_rho_S_c"]), number(&row["L_over_c"]));
        let cards = format!(
            "GUST,7,8,1.,0.,1.\nRLOAD1,8,9,,,1.\nFREQ2,10,{:.6e},{:.6e},400\nTABRNDG,12,1,{scale:?},1.\nRANDPS,13,1,1,1.,,12\n",
            1e-4 / PI,
            number(&row["k_max"]) / PI
        );
        let control = "RANDOM = 13\nSUBCASE 1\nGUST = 7\nFREQ = 10\n";
        let bulk = rectangle(mu, &Rotation3::identity(), control, &cards);
        let (case, deck, answer) = solved(&bulk);
        let gusts = [DeckGust { case: &case, deck: &deck, answer: &answer }];
        let random = DeckGust::random(&bulk, 13, &gusts).unwrap_or_else(|error| panic!("{error}"));
        let near = |what: &str, ours: f64, expected: &Value, share: f64| {
            println!("mu {mu}, {what}: {ours:.6} beside {expected}");
            assert!(
                (ours / number(expected) - 1.0).abs() < share,
                "mu {mu}, {what}: {ours} beside {expected}"
            );
        };
        let acceleration = random.of_grid(1, 2, true).expect("a grid");
        let expected = &row["A_bar_per_w_over_V"];
        near("acceleration", acceleration.rms, &expected["acc_c_over_V2"], 0.01);
        near("N0", acceleration.n0_hz.expect("it moves"), &row["N0_acc_c_over_V"], 0.03);
        let [air, net] = [station(&deck, "AIR"), station(&deck, "NET")];
        // half of the lift over q S/2, bending of a half wing over q S c
        near("CL", random.of_station(air, 2).rms / 1.5, &expected["CL"], 0.01);
        near("bending by the air", random.of_station(air, 3).rms / 3.0, &expected["air_bending"], 0.01);
        near("net bending", random.of_station(net, 3).rms / 3.0, &expected["net_bending"], 0.01);
    }
}

#[test]
fn a_deck_turned_with_its_stream_has_the_same_answers_and_a_later_place_is_a_later_time() {
    let cards = |x_0: f64| {
        format!("GUST,7,8,1.,{x_0:?},1.\nTLOAD2,8,9,,,2.,9.,.1\nFREQ1,10,.01,.01,50\nTSTEP,11,40,.5\n")
    };
    let in_time = |turn: &Rotation3<f64>, cards: &str| {
        let (case, deck, answer) = solved(&rectangle(MU, turn, IN_TIME, cards));
        deck.in_time(&case, &answer).expect("in time")
    };
    let straight = in_time(&Rotation3::identity(), &cards(0.0));
    let size = |time: &fullaircraft::TimeAnswer, station: usize| {
        time.stations[station].loads.iter().map(|loads| loads.total(3).abs()).fold(0.0, f64::max)
    };
    let turned = in_time(&Rotation3::new(Vector3::new(0.3, -0.7, 2.0)), &cards(0.0));
    let later = in_time(&Rotation3::identity(), &cards(-1.5));
    for station in 0..2 {
        let scale = size(&straight, station);
        assert!(scale > 0.1, "it bends: {scale}");
        let pairs = straight.stations[station].loads.iter().zip(&turned.stations[station].loads);
        for (one, other) in pairs {
            assert!((one.total(3) - other.total(3)).abs() < 1e-6 * scale, "{one:?} {other:?}");
        }
        // X0 1.5 before the leading edge: three steps of half a second later at an airspeed of one
        let loads = [&straight, &later].map(|time| &time.stations[station].loads);
        for at in 3..loads[0].len() {
            let off = (loads[1][at].total(3) - loads[0][at - 3].total(3)).abs();
            assert!(off < 1e-9 * scale, "at {at}: {off}");
        }
    }
}

#[test]
fn gusts_add_up_and_grow_with_their_scale() {
    let cards = |wg: f64, parts: &str| {
        format!(
            "GUST,7,8,{wg:?},0.,1.\nDLOAD,8,1.,{parts}\nTLOAD2,81,9,,,0.,4.,0.\nTLOAD2,82,9,,,3.,9.,.2\nFREQ1,10,.01,.01,50\n\
             TSTEP,11,40,.5\n"
        )
    };
    let bending = |wg: f64, parts: &str| -> Vec<f64> {
        let (case, deck, answer) = solved(&rectangle(MU, &Rotation3::identity(), IN_TIME, &cards(wg, parts)));
        let time = deck.in_time(&case, &answer).expect("in time");
        time.stations[station(&deck, "NET")].loads.iter().map(|loads| loads.total(3)).collect()
    };
    let [one, other] = ["1.,81", "1.,82"].map(|parts| bending(1.0, parts));
    let both = bending(0.5, "2.,81,-3.,82");
    let size = both.iter().map(|value| value.abs()).fold(0.0, f64::max);
    for ((one, other), both) in one.iter().zip(&other).zip(&both) {
        assert!((one - 1.5 * other - both).abs() < 1e-12 * size.max(1.0), "{one} {other} {both}");
    }
}

/// A mass on a spring with a box in air so thin that it does nothing.
pub(crate) fn spring(control: &str, cards: &str) -> BulkData {
    parse_deck("spring", &spring_text(control, cards)).unwrap_or_else(|error| panic!("{error}"))
}

/// The text of [`spring`].
fn spring_text(control: &str, cards: &str) -> String {
    format!(
        "SOL 146\nCEND\nSPC = 1\nMETHOD = 5\nSDAMP = 6\n{control}BEGIN BULK\nGRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,0.,1.,0.\n\
         RBE2,13,1,123456,2,3\nCONM2,11,1,,2.\nCELAS2,14,800.,1,3\nSPC1,1,12456,1\nEIGRL,5,,,1\nTABDMP1,6,CRIT\n,0.,.05,99.,.05,ENDT\n\
         PAERO1,1\nCAERO1,1001,1,,1,1,,,1\n,0.,0.,0.,1.,0.,1.,0.,1.\nSET1,30,1,2,3\nSPLINE1,20,1001,1001,1001,30\n\
         AERO,0,1.+3,1.,1.\nPARAM,Q,1.-12\nMKAERO1,0.\n,.001,.1\nDAREA,9,1,3,4.\n{cards}"
    )
}

#[test]
fn a_load_on_a_mass_on_a_spring_is_answered_as_in_closed_form() {
    // m x'' + c x' + k x = 4 f(t), k = 800, m = 2, c = 2 zeta sqrt(k m) = 4: the answer to a step that ends after ten seconds
    let (omega, zeta) = (20.0_f64, 0.05_f64);
    let bulk = spring(
        "DLOAD = 8\nFREQ = 10\nTSTEP = 11\n",
        "TLOAD2,8,9,,,0.,10.,0.\nFREQ1,10,0.,.05,2000\nTSTEP,11,120,.05\n",
    );
    let (case, deck, answer) = solved(&bulk);
    let time = deck.in_time(&case, &answer).expect("in time");
    let motions = time.of_grid(&deck.shapes_at(1).expect("a grid"));
    let damped = omega * (1.0 - zeta * zeta).sqrt();
    for (t, motion) in time.times_s.iter().zip(&motions).filter(|(t, _)| **t > 0.01) {
        let decay = (-zeta * omega * t).exp();
        let wave = (damped * t).cos() + zeta * omega / damped * (damped * t).sin();
        let expected = 4.0 / 800.0 * (1.0 - decay * wave);
        assert!((motion[0][2] - expected).abs() < 2e-6, "{t}: {} {expected}", motion[0][2]);
    }
}

#[test]
fn a_spring_with_a_loss_factor_beside_a_damper_is_answered_as_in_closed_form() {
    // k = 800 (1 + i (.06 + .04)), m = 2, c = 4 of the mode and 3 of a damper
    for (spring_cards, damper) in [
        ("CELAS2,14,800.,1,3,,,.06", "CDAMP2,15,3.,1,3"),
        ("CELAS1,14,16,1,3\nPELAS,17,1.,.3,,16,800.,.06", "CDAMP1,15,18,1,3\nPDAMP,18,3."),
        ("CBUSH,14,16,1,,,,,0\nPBUSH,16,K,,,800.\n,,GE,.06\n,,B,,,3.", ""),
        (
            "CBUSH,14,16,1,,,,,0\nPBUSH,16,K,5.,,800.\n,,GE,.3,.3,.06",
            "CBUSH1D,15,19,1,,20\nPBUSH1D,19,,3.\nCORD2R,20,,0.,0.,0.,1.,0.,0.\n,0.,0.,1.",
        ),
    ] {
        let cards = format!("RLOAD1,8,9,,,1.\nFREQ1,10,.5,.5,12\nPARAM,G,.04\n{damper}\n");
        let text = spring_text("DLOAD = 8\nFREQ = 10\n", &cards).replace("CELAS2,14,800.,1,3", spring_cards);
        let (_, deck, answer) =
            solved(&parse_deck("spring", &text).unwrap_or_else(|error| panic!("{error}")));
        let shape = deck.shapes_at(1).expect("a grid")[(2, 0)];
        for (hz, x) in answer.hz.iter().zip(&answer.modal) {
            let omega = TAU * hz;
            let stiffness = c64::new(800.0 - 2.0 * omega * omega, 80.0 + 7.0 * omega);
            let off = (x[0] * shape - c64::from(4.0) / stiffness).norm() * stiffness.norm() / 4.0;
            assert!(
                off < 1e-6,
                "{spring_cards} at {hz} Hz: {} beside {}",
                x[0] * shape,
                c64::from(4.0) / stiffness
            );
        }
    }
}

#[test]
fn a_mass_on_a_spring_in_white_noise_has_the_mean_square_of_the_residues() {
    // int |H|² S df over all frequencies is S F²/(4 k c), and crossings of zero are at the natural frequency
    let bulk = spring(
        "RANDOM = 12\nSUBCASE 3\nDLOAD = 8\nFREQ = 10\n",
        "RLOAD1,8,9,,,1.\nFREQ1,10,0.,.01,20000\nRANDPS,12,3,3,2.5\n",
    );
    let (case, deck, answer) = solved(&bulk);
    let gusts = [DeckGust { case: &case, deck: &deck, answer: &answer }];
    let random = DeckGust::random(&bulk, 12, &gusts).unwrap_or_else(|error| panic!("{error}"));
    let heave = random.of_grid(1, 2, false).expect("a grid");
    let expected = (2.5 * 16.0 / (4.0 * 800.0 * 4.0_f64)).sqrt();
    assert!((heave.rms / expected - 1.0).abs() < 1e-3, "{} {expected}", heave.rms);
    let n0 = heave.n0_hz.expect("it moves");
    assert!((n0 * TAU / 20.0 - 1.0).abs() < 5e-3, "{n0}");
}

#[test]
fn two_loads_whose_spectra_go_together_add_up_or_take_away() {
    let of = |cross: f64| {
        let cards = format!(
            "RLOAD1,8,9,,,1.\nRLOAD1,81,9,,,2.\nFREQ1,10,0.,.05,400\nRANDPS,12,1,1,1.\nRANDPS,12,2,2,1.\nRANDPS,12,1,2,{cross:?}\n"
        );
        let bulk = spring("RANDOM = 12\nFREQ = 10\nSUBCASE 1\nDLOAD = 8\nSUBCASE 2\nDLOAD = 81\n", &cards);
        let cases = gust_cases(&bulk).expect("two cases");
        let deck = GustDeck::new(&bulk, &cases[0].subcase, &[&cases[0], &cases[1]]).expect("a deck");
        let answers: Vec<DynamicAnswer> =
            cases.iter().map(|case| deck.answer(case).expect("an answer")).collect();
        let gusts: Vec<DeckGust<'_>> =
            cases.iter().zip(&answers).map(|(case, answer)| DeckGust { case, deck: &deck, answer }).collect();
        let random = DeckGust::random(&bulk, 12, &gusts).expect("a set");
        random.of_grid(1, 2, false).expect("a grid").rms
    };
    // amplitudes 1 and 2: 1 + 2, sqrt(1 + 4), 2 - 1
    let (together, apart, against) = (of(1.0), of(0.0), of(-1.0));
    assert!((together / against - 3.0).abs() < 1e-9, "{together} {against}");
    assert!((apart / against - 5.0_f64.sqrt()).abs() < 1e-9, "{apart} {against}");
}

#[test]
fn what_a_gust_needs_is_asked_for_by_its_name() {
    let cards = "RLOAD1,8,9,,,1.\nFREQ1,10,0.,.05,4\nGUST,7,8,1.,0.,1.+3\n";
    let why = |control: &str, cards: &str| {
        let bulk = spring(control, cards);
        let cases = match gust_cases(&bulk) {
            Ok(cases) => cases,
            Err(error) => return error.to_string(),
        };
        match GustDeck::new(&bulk, &cases[0].subcase, &[&cases[0]]) {
            Ok(deck) => deck.answer(&cases[0]).expect_err("it is wrong").to_string(),
            Err(error) => error.to_string(),
        }
    };
    assert!(why("FREQ = 10\n", cards).contains("asks for no gust"));
    assert!(why("GUST = 6\nFREQ = 10\n", cards).contains("GUST 6, which is not there"));
    assert!(why("GUST = 7\n", cards).contains("selects no FREQUENCY"));
    assert!(why("GUST = 7\nFREQ = 11\n", &format!("{cards}FREQ4,11,1.,2.,.1,3\n")).contains("FREQ4"));
    let mixed = format!("{cards}TLOAD2,81,9,,,0.,1.\n");
    assert!(why("GUST = 7\nDLOAD = 81\nFREQ = 10\n", &mixed).contains("mixes loads in time"));
    let joined = format!("{cards}DMIG,STIFF,1,3,,1,3,1.\n");
    assert!(why("GUST = 7\nFREQ = 10\nK2PP = STIFF\n", &joined).contains("K2PP = STIFF"));
    assert!(why("GUST = 7\nFREQ = 10\nTFL = 3\n", cards).contains("TFL"));
    let supersonic = format!("{cards}PARAM,MACH,1.2\n");
    assert!(why("GUST = 7\nFREQ = 10\n", &supersonic).contains("subsonic"));
    // the matrices of extra points join nothing of the structure
    let extra = format!("{cards}EPOINT,50\nDMIG,STIFF,50,0,,50,0,1.\n");
    assert_eq!(
        gust_cases(&spring("GUST = 7\nFREQ = 10\nK2PP = STIFF\n", &extra)).map(|cases| cases.len()),
        Ok(1)
    );
}

#[test]
fn a_free_structure_is_refused_at_rest_and_gaps_of_the_air_are_said() {
    let cards = "GUST,7,8,1.,0.,1.\nRLOAD1,8,9,,,1.\nFREQ1,10,0.,.25,4\n";
    let bulk = spring("GUST = 7\nFREQ = 10\n", cards);
    let other = "GRID,4,,2.,0.,0.\nCONM2,12,4,,1.\nCELAS2,15,500.,1,3,4,3\nSPC1,1,12456,4\n";
    let mut free = spring("GUST = 7\nFREQ = 10\n", &format!("{cards}{other}"));
    free.springs.remove(&14);
    let case = gust_cases(&free).expect("a case").remove(0);
    let error = GustDeck::new(&free, &case.subcase, &[&case]).map(|deck| deck.answer(&case));
    let error = error.expect("a deck").expect_err("it flies away").to_string();
    assert!(error.contains("no answer at 0 Hz"), "{error}");
    // the reduced frequencies end at .1, the frequencies at pi 1/1 = 3.1; between them the air turns
    let (_, deck, _) = solved(&bulk);
    assert!(
        deck.remarks.iter().any(|remark| remark.contains("forces are computed there, too")),
        "{:?}",
        deck.remarks
    );
    assert!(deck.remarks.iter().any(|remark| remark.contains("list more")), "{:?}", deck.remarks);
}
