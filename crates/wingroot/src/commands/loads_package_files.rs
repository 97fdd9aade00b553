//! The files of a package for stress: index, loads at stations, round trip, arrays, and what they say of themselves.

use std::fmt::Write as _;
use std::time::Instant;

use fullaircraft::design_loads::instants::FlownInstant;
use fullaircraft::package::cards::CardCase;
use fullaircraft::package::round_trip::{Expected, LOADS, Row, round_trip_csv};
use fullaircraft::{Component, Station};
use loads::Selection;

use crate::commands::loads_result::RoundTripResult;
use crate::failure::Failure;
use crate::fingerprint::Fingerprint;
use crate::hdf5::{self, Group, Values};

/// A package in memory.
pub(crate) struct Packed {
    /// Name and bytes of each file.
    pub(crate) files: Vec<(String, Vec<u8>)>,
    /// How well the cards give back what was flown.
    pub(crate) round_trip: RoundTripResult,
}

impl Packed {
    /// What it is, in a line; since when it was made.
    pub(crate) fn line(&self, since: Instant) -> String {
        let sets = self.files.iter().filter(|(name, _)| name.starts_with("case_")).count();
        let bytes: usize = self.files.iter().map(|(_, bytes)| bytes.len()).sum();
        let seconds = since.elapsed().as_secs_f64();
        format!("package      {sets} load sets, {:.1} MB, made in {seconds:.1} s\n", bytes as f64 / 1e6)
    }
}

/// The places that cards belong to.
pub(crate) struct Site<'a> {
    /// Stations.
    pub(crate) stations: &'a [Station],
    /// Numbers of the grids that carry loads.
    pub(crate) grids: &'a [u32],
    /// Where they are, in the structure's unit of length.
    pub(crate) points: Vec<[f64; 3]>,
    /// Units of the loads on cards.
    pub(crate) units: &'a str,
    /// What the package says of where its loads are.
    pub(crate) words: &'a str,
}

/// A selected instant on cards, and what the solver says of it.
pub(crate) struct Card {
    pub(crate) case: CardCase,
    pub(crate) text: String,
    pub(crate) expected: Expected,
    /// How far a trim's own tips are from those of its loads on the structure, over what each load does to them.
    pub(crate) trim_tip: f64,
    /// How far these sums are from the first flight's loads at stations.
    pub(crate) repeat: f64,
    /// The instant, with the sums of the nodal loads that are on the cards.
    pub(crate) flown: FlownInstant,
    pub(crate) origin: Vec<String>,
}

/// What is written beside the cards.
pub(crate) struct Heads {
    /// Name and text of the file of grids or structure.
    pub(crate) structure: (&'static str, String),
    /// `index.bdf`.
    pub(crate) index: String,
    /// Program, plan and fingerprints.
    pub(crate) common: Vec<String>,
    /// Of ultimate loads.
    pub(crate) factor: f64,
}

/// All files of a package.
///
/// # Errors
/// If a row of the round trip does not hold.
pub(crate) fn packed(
    site: &Site<'_>,
    selection: &Selection,
    cards: Vec<Card>,
    rows: &[Row],
    heads: Heads,
) -> Result<Packed, Failure> {
    if let Some(row) = rows.iter().find(|row| !row.holds()) {
        return Err(Failure::Computation(format!(
            "the round trip failed: load set {}, {} {}: {} flown, {} by the cards ({:.1e} of the largest); no package is written",
            row.sid, row.place, row.what, row.solver, row.cards, row.of_largest
        )));
    }
    let Heads { structure, index, common, factor } = heads;
    let texts = [
        structure,
        ("index.bdf", index),
        ("index.csv", index_csv(&cards, &common, factor)),
        ("station_loads.csv", stations_csv(selection, site.stations, &cards, &common)),
        ("round_trip.csv", comment(&common) + &round_trip_csv(rows)),
        ("README.md", readme(&common, cards.len(), site.words)),
    ];
    let mut files: Vec<(String, Vec<u8>)> =
        texts.into_iter().map(|(name, text)| (name.to_owned(), text.into_bytes())).collect();
    files.push(("loads.h5".to_owned(), hdf5_file(site, &cards, &common)?));
    let most = |of: fn(&Card) -> f64| cards.iter().map(of).fold(0.0, f64::max);
    let (trim_tip, repeat) = (most(|card| card.trim_tip), most(|card| card.repeat));
    files.extend(cards.into_iter().map(|card| (card.case.file(), card.text.into_bytes())));
    Ok(Packed { files, round_trip: RoundTripResult { trim_tip, repeat, ..worst(rows) } })
}

fn worst(rows: &[Row]) -> RoundTripResult {
    let most = |of: &dyn Fn(&Row) -> bool| {
        rows.iter().filter(|row| of(row)).map(|row| row.of_largest).fold(0.0, f64::max)
    };
    let is_tip = |row: &Row| row.what == "deflection_m";
    RoundTripResult {
        stations: most(&|row| !is_tip(row) && !["balance", "structure"].contains(&row.place.as_str())),
        balance: most(&|row| row.place == "balance"),
        tip: most(&is_tip),
        structure: most(&|row| row.place == "structure"),
        trim_tip: 0.0,
        repeat: 0.0,
    }
}

fn comment(lines: &[String]) -> String {
    lines.iter().fold(String::new(), |text, line| text + "# " + line + "\n")
}

fn index_csv(cards: &[Card], common: &[String], factor: f64) -> String {
    let mut text = comment(common) + "sid,file,fingerprint,factor,case\n";
    for card in cards {
        let print = Fingerprint::default().with(card.text.as_bytes());
        // Writing to a String cannot fail.
        let _ =
            writeln!(text, "{},{},{print},{factor},\"{}\"", card.case.sid, card.case.file(), card.case.words);
    }
    text
}

fn stations_csv(selection: &Selection, stations: &[Station], cards: &[Card], common: &[String]) -> String {
    let mut text = comment(common) + "sid,case,instant,t_s,station,component," + &LOADS.join(",") + "\n";
    for (one, card) in selection.selected.iter().zip(cards) {
        let instant = &card.flown;
        for (station, components) in stations.iter().zip(&instant.loads) {
            for (component, loads) in Component::ALL.iter().zip(components) {
                // Writing to a String cannot fail.
                let _ = write!(
                    text,
                    "{},{},{},{},{},{}",
                    one.sid,
                    one.case,
                    one.instant,
                    instant.t_s,
                    station.name,
                    component.name()
                );
                for load in loads {
                    let _ = write!(text, ",{load:.12e}");
                }
                text.push('\n');
            }
        }
    }
    text
}

fn readme(common: &[String], cases: usize, words: &str) -> String {
    let lines = common.iter().fold(String::new(), |text, line| text + "- " + line + "\n");
    format!(
        "# Loads for stress\n\n{lines}\n{cases} load sets. {words} Cards are limit loads: all that is applied (air, inertia, thrust, \
         damping, gravity), no reactions; each set is in balance. Centrifugal forces of steady rolls and turns are left out. \
         `round_trip.csv`: cards read back, summed at the stations and over the whole aircraft, and put on the structure. `loads.h5` has the \
         same as arrays.\n"
    )
}

fn hdf5_file(site: &Site<'_>, cards: &[Card], common: &[String]) -> Result<Vec<u8>, Failure> {
    let dofs = 6 * site.points.len();
    let nets: Vec<f64> = cards.iter().flat_map(|card| card.case.net.iter().copied()).collect();
    let count = site.stations.len();
    let sums: Vec<f64> = cards.iter().flat_map(|card| card.flown.net()).flatten().collect();
    let of_station = |station: &Station| [station.point.x, station.point.y, station.point.z];
    let about: Vec<f64> = site.stations.iter().flat_map(of_station).collect();
    let loads = Group::new(
        "loads",
        &format!(
            "net loads at grids, a row a load set; three forces and three moments of each grid; {}",
            site.units
        ),
    )
    .with("sid", Values::Whole(cards.iter().map(|card| card.case.sid).collect()))
    .with("words", Values::words(cards.iter().map(|card| &card.case.words)))
    .with("origin", Values::words(cards.iter().map(|card| card.origin.join("\n"))))
    .with("f_g", Values::Real(nets, vec![cards.len(), dofs]))
    .with("grids", Values::Whole(site.grids.to_vec()))
    .with("xyz_m", Values::Real(site.points.concat(), vec![site.points.len(), 3]));
    let stations = Group::new(
        "stations",
        "net loads at stations by load set, station and Fx, Fy, Fz (N), Mx, My, Mz (N m)",
    )
    .with("names", Values::words(site.stations.iter().map(|station| &station.name)))
    .with("points_m", Values::Real(about, vec![count, 3]))
    .with("net", Values::Real(sums, vec![cards.len(), count, 6]));
    hdf5::bytes(&common.join("\n"), &[loads, stations])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_load_that_the_cards_do_not_give_back_ends_with_status_3_and_no_package() {
        let site = Site { stations: &[], grids: &[], points: Vec::new(), units: "N, N m", words: "" };
        let selection = Selection { selected: Vec::new(), drives: Vec::new(), never: Vec::new() };
        let made = |cards: f64, of_largest: f64| {
            let row =
                Row { sid: 1, place: "right root".to_owned(), what: "Mx_Nm", solver: 1.0, cards, of_largest };
            let structure = ("aircraft.bdf", String::new());
            let heads = Heads { structure, index: String::new(), common: Vec::new(), factor: 1.0 };
            packed(&site, &selection, Vec::new(), &[row], heads)
        };
        assert!(made(1.0, 0.0).is_ok());
        // the fourth place of one value is one more
        let failure = made(1.001, 1e-3).err().expect("it does not hold");
        assert_eq!(failure.exit_status(), 3);
        assert!(failure.to_string().contains("load set 1, right root Mx_Nm"), "{failure}");
    }
}
