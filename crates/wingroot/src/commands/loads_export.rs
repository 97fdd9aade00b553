//! Where the loads of a package go: to the grids of the structure, or condensed to the stations' points.

use fullaircraft::package::cards::{CardCase, Hold, index_of};
use fullaircraft::package::condensed::Condensed;
use fullaircraft::package::round_trip::{Expected, RoundTrip, Row};
use fullaircraft::{NodalLoads, Station};
use loads::select::file::ExportAt;

use crate::failure::Failure;

/// The places of a package's loads, and how its cards are read back.
pub(crate) struct Export<'a> {
    /// The structure as it was read.
    pub(crate) back: RoundTrip<'a>,
    /// Points of the stations with their cards, if loads go there.
    condensed: Option<(Condensed<'a>, String)>,
    grids: &'a [u32],
    hold: Hold,
    /// The file of the structure.
    deck: String,
}

/// What the places belong to.
pub(crate) struct Places<'a> {
    /// Stations.
    pub(crate) stations: &'a [Station],
    /// Numbers of the structure's grids.
    pub(crate) grids: &'a [u32],
    /// How the index holds the structure.
    pub(crate) hold: Hold,
    /// Its file.
    pub(crate) deck: String,
    /// Program, plan and fingerprints.
    pub(crate) common: &'a [String],
}

impl<'a> Export<'a> {
    /// Places of a structure that was read.
    ///
    /// # Errors
    /// If loads cannot be condensed to the stations.
    pub(crate) fn new(back: RoundTrip<'a>, at: ExportAt, places: Places<'a>) -> Result<Self, Failure> {
        let Places { stations, grids, hold, deck, common } = places;
        let condensed = match at {
            ExportAt::Grids => None,
            ExportAt::Stations => {
                let last = grids.iter().max().copied().unwrap_or(0);
                let condensed = Condensed::new(stations, back.points(), last)?;
                let cards = condensed.cards(common);
                Some((condensed, cards))
            }
        };
        Ok(Self { back, condensed, grids, hold, deck })
    }

    /// Numbers of the grids that carry loads.
    pub(crate) fn grids(&self) -> &[u32] {
        self.condensed.as_ref().map_or(self.grids, |(condensed, _)| condensed.grids())
    }

    /// Where these are.
    pub(crate) fn points(&self) -> Vec<[f64; 3]> {
        let all = match &self.condensed {
            Some((condensed, _)) => condensed.places(),
            None => self.back.points().to_vec(),
        };
        all.iter().map(|point| [point.x, point.y, point.z]).collect()
    }

    /// Loads at these places.
    pub(crate) fn nodal(&self, loads: NodalLoads) -> NodalLoads {
        match &self.condensed {
            Some((condensed, _)) => condensed.nodal(&loads),
            None => loads,
        }
    }

    /// A case's cards read back beside what was flown.
    ///
    /// # Errors
    /// If they cannot be read.
    pub(crate) fn compare(
        &self,
        case: &CardCase,
        text: &str,
        expected: &Expected,
    ) -> Result<Vec<Row>, Failure> {
        match &self.condensed {
            Some((condensed, cards)) => {
                Ok(condensed.compare(case, text, cards, expected, self.back.balanced())?)
            }
            None => Ok(self.back.compare(case, text, expected)?),
        }
    }

    /// `index.bdf`.
    pub(crate) fn index(&self, title: &str, cases: &[CardCase], common: &[String]) -> String {
        match &self.condensed {
            Some(_) => index_of("stations.bdf", None, title, cases, common),
            None => index_of("aircraft.bdf", Some(&self.hold), title, cases, common),
        }
    }

    /// What the package says of its places; `held` is where the index holds the structure.
    pub(crate) fn words(&self, held: &str) -> String {
        match &self.condensed {
            Some(_) => "`index.bdf` has a subcase each and includes `stations.bdf` (a grid each station) and the cards, `case_NNNNN.bdf`. \
                        Each grid carries the difference of its station's cut to the next outboard ones: the grids inside a cut, moved to it, \
                        add up to its loads. The structure is yours: put these grids on it where its stations are."
                .to_owned(),
            None => format!(
                "`index.bdf` is a deck of linear statics with a subcase each; it includes `aircraft.bdf` (the structure the cards belong to) \
                 and the cards, `case_NNNNN.bdf`. It holds the aircraft {held}, where no reaction is left."
            ),
        }
    }

    /// Name and text of the file of grids or structure.
    pub(crate) fn file(self) -> (&'static str, String) {
        match self.condensed {
            Some((_, cards)) => ("stations.bdf", cards),
            None => ("aircraft.bdf", self.deck),
        }
    }
}
