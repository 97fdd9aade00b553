//! Modes, damping and unsteady air of a study as cards.

use super::cards::{Asked, FIRST, blanks, card, real};
use super::fault::Fault;
use super::file::Study;
use super::unsteady::{Motion, Unsteady};
use nastran::BulkData;

/// Its EIGRL, TABDMP1 and system of the air: behind the numbers that splines may take.
const METHOD: u32 = FIRST + 500_000;
const DAMPING: u32 = FIRST + 500_001;
const STREAM: u32 = FIRST + 500_002;
/// Modes where neither it nor the decks say how many.
const MODES: u32 = 10;
/// Mach numbers and reduced frequencies of a card.
const A_CARD: usize = 8;

/// References of unsteady air as a deck has them.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Air {
    /// The AERO card with its system, or nothing where the decks have one.
    pub(super) cards: String,
    /// Its density.
    pub(super) density: f64,
    /// The system whose x lies along the stream, before it is turned to the gusts.
    pub(super) acsid: u32,
}

impl Unsteady {
    /// Modes and damping, as far as it says anything of them.
    pub(super) fn said(&self) -> Asked {
        let mut asked = Asked::default();
        if self.modes.is_some() || self.up_to_hz.is_some() {
            asked.select("METHOD", METHOD);
            let highest = self.up_to_hz.map_or_else(String::new, real);
            let count = self.modes.map_or_else(String::new, |count| count.to_string());
            asked.add("EIGRL", &[METHOD.to_string(), String::new(), highest, count]);
        }
        if let Some((hz, g)) = self.damping.last() {
            asked.select("SDAMPING", DAMPING);
            // One point is drawn on as a straight line by a second one.
            let second = (self.damping.len() == 1).then_some((hz + 1.0, *g));
            let points = self.damping.iter().copied().chain(second).flat_map(|(hz, g)| [real(hz), real(g)]);
            let head = [DAMPING.to_string(), "G".to_owned()].into_iter().chain(blanks(6));
            asked.add("TABDMP1", &head.chain(points).chain(["ENDT".to_owned()]).collect::<Vec<_>>());
        }
        asked
    }

    /// The same, with the modes of the decks or ten where it does not say which.
    pub(super) fn asked(&self, decks: &BulkData) -> Result<Asked, Fault> {
        let mut asked = self.said();
        if self.modes.is_some() || self.up_to_hz.is_some() {
            return Ok(asked);
        }
        match decks.eigen_methods.keys().collect::<Vec<_>>()[..] {
            [] => asked.join(&Self { modes: Some(MODES), damping: Vec::new(), ..self.clone() }.said()),
            [id] => asked.select("METHOD", *id),
            ref several => {
                let message =
                    format!("the decks have {} EIGRL or EIGR, and nothing says which", several.len());
                return Err(Fault::new("unsteady", message)
                    .with_help("give the number of modes: unsteady: (modes: 20)"));
            }
        }
        Ok(asked)
    }

    /// Reduced frequencies at some Mach numbers.
    pub(super) fn pairs(&self, decks: &BulkData, machs: &[f64]) -> Result<String, Fault> {
        let is_of_decks = !decks.reduced_frequencies.is_empty();
        if self.reduced_frequencies.is_empty() && !is_of_decks {
            let message = "neither the study nor its decks have reduced frequencies";
            return Err(Fault::new("unsteady", message)
                .with_help("list them: unsteady: (reduced_frequencies: [0.001, 0.1, 0.3, 0.6, 1.0])"));
        }
        let mut once = machs.to_vec();
        once.sort_by(f64::total_cmp);
        once.dedup();
        let mut cards = String::new();
        for machs in once.chunks(A_CARD) {
            for ks in self.reduced_frequencies.chunks(A_CARD) {
                let machs = machs.iter().copied().map(real).chain(blanks(A_CARD - machs.len()));
                cards += &card("MKAERO1", &machs.chain(ks.iter().copied().map(real)).collect::<Vec<_>>());
            }
        }
        Ok(cards)
    }
}

impl Study {
    /// References of unsteady air, with a density that ratios refer to, the airspeed of gusts and where their air goes, degrees from up.
    pub(super) fn air(
        &self,
        decks: &BulkData,
        density: f64,
        velocity: Option<f64>,
        direction_deg: f64,
    ) -> Result<Air, Fault> {
        let motion = self.unsteady.motion;
        if let Some(aero) = &decks.unsteady_reference {
            let why =
                "the decks have an AERO of their own, which says how the air lies and the aircraft moves";
            let refuse = |field| Err(Fault::new(field, why).with_help("take it out of the decks"));
            return match (direction_deg == 0.0, motion == Motion::Antisymmetric && aero.symmetry != -1) {
                (false, _) => refuse("direction_deg"),
                (_, true) => refuse("motion"),
                _ => Ok(Air { cards: String::new(), density: aero.density, acsid: aero.acsid }),
            };
        }
        let aeros = decks.aero_reference.as_ref();
        let chord =
            self.reference.map(|of| of.chord).or(aeros.map(|aeros| aeros.chord)).ok_or_else(|| {
                Fault::new(
                    "decks",
                    "unsteady air needs a reference chord, and neither the study nor its decks have one",
                )
                .with_help("give it: reference: (chord: 3.5)")
            })?;
        let is_half = self.is_half() || aeros.is_some_and(|aeros| aeros.symmetry != 0);
        let symmetry = match (is_half, motion) {
            (true, Motion::Antisymmetric) => "-1",
            (true, Motion::Symmetric) => "1",
            (false, Motion::Symmetric) => "0",
            (false, Motion::Antisymmetric) => {
                let message = "only half an aircraft moves antisymmetrically, and this is a whole one";
                return Err(Fault::new("motion", message)
                    .with_help("say so, reference: (is_half: true), or leave it out"));
            }
        };
        if is_half && direction_deg != 0.0 {
            return Err(Fault::new("direction_deg", "half an aircraft meets gusts along z alone"));
        }
        let acsid = self.stream(decks);
        let (system, cards) = if direction_deg == 0.0 {
            (acsid, String::new())
        } else {
            (STREAM, turned(acsid, direction_deg))
        };
        let velocity = velocity.map_or_else(String::new, real);
        let fields = [system.to_string(), velocity, real(chord), real(density), symmetry.to_owned()];
        Ok(Air { cards: cards + &card("AERO", &fields), density, acsid })
    }
}

/// A system turned about the x of another, whose z points where the air of gusts goes.
fn turned(from: u32, direction_deg: f64) -> String {
    let (sin, cos) = direction_deg.to_radians().sin_cos();
    let places = [[0.0; 3], [0.0, sin, cos], [1.0, 0.0, 0.0]].concat();
    let head = [STREAM.to_string(), from.to_string()];
    card("CORD2R", &head.into_iter().chain(places.into_iter().map(real)).collect::<Vec<_>>())
}
