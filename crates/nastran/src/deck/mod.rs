//! Decks: files, INCLUDE, executive and case control, and one struct for each card.
//!
//! Before a `BEGIN BULK` only selections of subcases are read; `ENDDATA` ends the deck. Cards that are not
//! read are counted by name in [`BulkData::unknown`], so that nothing is dropped in silence.

pub mod case_control;
mod checks;
pub mod damping;
mod defaults;
mod dmi_cards;
pub mod executive;
mod include;
mod replication;
mod sections;
mod superelements;
mod taken;

use crate::bulk_data::{BulkData, Unread};
use crate::card::line::{Line, continuation_name};
use crate::card::{Card, lists};
use crate::cards::composite_section::LumpedAreas;
use crate::cards::kind::DeckCard;
use crate::cards::{Grid, Spoint};
use crate::source::{InputError, Span};
use crate::text_file::{no_file, read_deck_text};
use defaults::Defaults;
use dmi_cards::DmiCards;
use replication::{Replication, is_replication, refuse_in_continuation};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use taken::Numbers;

/// The most numbers that all `THRU` of a deck may stand for: forty megabytes, and every real deck has less.
const MOST_IN_RANGES: usize = 10_000_000;

/// Cards of the air: one that is wrong or not read as it stands does not stop who asks for the structure alone.
const AIR: [&str; 43] = [
    "CAERO1", "PAERO1", "AEFACT", "AESURF", "AELIST", "SPLINE1", "SPLINE2", "SPLINE4", "SPLINE5", "MONPNT1",
    "MONPNT3", "AEROS", "AESTAT", "TRIM", "DIVERG", "AELINK", "AECOMP", "AECOMPL", "AERO", "FLUTTER",
    "FLFACT", "MKAERO1", "MKAERO2", "TABDMP1", "GUST", "TLOAD1", "TLOAD2", "RLOAD1", "RLOAD2", "DLOAD",
    "DAREA", "EPOINT", "DMIG", "FREQ", "FREQ1", "FREQ2", "TSTEP", "TABLED1", "TABLED2", "TABLED3", "TABRND1",
    "TABRNDG", "RANDPS",
];

/// Reads a deck with the files it includes.
///
/// # Errors
/// If a file cannot be read or has nothing in it, a field is not what its card demands, an identification number is given twice, or
/// a grid refers to a coordinate system that is not there.
pub fn read_deck(path: &Path) -> Result<BulkData, InputError> {
    let text = read_deck_text(path)?;
    if text.trim().is_empty() {
        return Err(InputError::in_file(path, "the deck is empty").with_help("expected bulk data cards"));
    }
    parse_at(path, &text)
}

/// Parses a deck; `name` is its file name in errors and the place included files are relative to.
///
/// # Errors
/// As [`read_deck`]; a text without cards is a deck without cards.
pub fn parse_deck(name: &str, text: &str) -> Result<BulkData, InputError> {
    parse_at(Path::new(name), text)
}

fn parse_at(path: &Path, text: &str) -> Result<BulkData, InputError> {
    let mut reader = Reader::default();
    let lines: Vec<&str> = text.lines().collect();
    let bulk = sections::start_of_bulk(path, &lines)?;
    if bulk > 0 {
        reader.deck.subcases = case_control::read(path, &lines[..bulk - 1])?;
    }
    reader.files.insert(include::identity(path), Span::whole_file(path));
    // PARAM may stand in the case control, too. One that differs between subcases, or from the bulk data, is refused as given twice.
    let parameters: Vec<&str> = lines[..bulk].iter().map(|line| sections::parameter_in(line)).collect();
    reader.lines(path, &parameters, 0)?;
    reader.deck.bars_twist = sections::bars_twist(&lines[..bulk]);
    let read = reader.lines(path, &lines, bulk).and_then(|()| reader.finish());
    read.map_err(|error| superelements::explain(error, path, &lines, bulk))
}

#[derive(Default)]
struct Reader {
    deck: BulkData,
    matrices: DmiCards,
    defaults: Defaults,
    numbers: Numbers,
    /// Scalar points named by elements that join nothing else.
    named_points: Vec<Spoint>,
    /// Areas of sections, whose materials may stand behind them.
    areas: Vec<LumpedAreas>,
    card: Option<Card>,
    /// Cards that announce a continuation which has not come yet, by its name, with their place among them.
    waiting: BTreeMap<String, Vec<(usize, Card)>>,
    /// How many have waited.
    waited: usize,
    /// Names of continuations that went to the card before them, which announces none.
    adopted: BTreeMap<String, Span>,
    files: BTreeMap<PathBuf, Span>,
    /// Numbers that `THRU` has stood for so far.
    ranges: usize,
    has_ended: bool,
}

impl Reader {
    /// Reads the lines of a file from index `next` on.
    fn lines(&mut self, path: &Path, lines: &[&str], mut next: usize) -> Result<(), InputError> {
        let file = Arc::new(path.to_path_buf());
        // The last card of one line, and the replications that follow it.
        let (mut plain, mut running): (Option<usize>, Option<Replication>) = (None, None);
        while next < lines.len() && !self.has_ended {
            let number = next + 1;
            if include::is_include(lines[next]) {
                self.flush()?;
                let found = include::target(&file, lines, next)?;
                next = found.next_line;
                self.include(path, &found)?;
                continue;
            }
            next += 1;
            let Some(line) = Line::cut(&file, number, lines[number - 1])? else { continue };
            if is_replication(&line) {
                let mut replication = match running.take() {
                    Some(replication) => replication,
                    None => Replication::of(
                        plain.map(|at| Line::cut(&file, at + 1, lines[at])).transpose()?.flatten(),
                    ),
                };
                for copy in replication.expanded(&line)? {
                    self.flush()?;
                    self.card = Some(Card::start(copy)?);
                }
                running = Some(replication);
                continue;
            }
            // A card of several lines cannot be replicated line by line.
            plain = (!line.is_continuation()).then_some(number - 1);
            running = None;
            if line.is_continuation() {
                self.turn_to_parent(&line)?;
                let Some(card) = &mut self.card else {
                    let error = InputError::at(&line.head.span, "a continuation without a card before it");
                    return Err(error.with_help("a card's name starts in the first column"));
                };
                refuse_in_continuation(&card.name, &line)?;
                card.extend(line)?;
            } else {
                self.flush()?;
                if self.begins_again(&line, lines[number - 1])? {
                    continue;
                }
                if line.head.text().eq_ignore_ascii_case("ENDDATA") {
                    self.has_ended = true;
                } else {
                    self.card = Some(Card::start(line)?);
                }
            }
        }
        self.flush()
    }

    /// Whether a line is one more BEGIN BULK. Nothing is lost where no card stands between the two.
    fn begins_again(&self, line: &Line, text: &str) -> Result<bool, InputError> {
        let mut words = text.split('$').next().unwrap_or("").split(|c: char| c.is_whitespace() || c == '=');
        if !words.next().is_some_and(|word| word.eq_ignore_ascii_case("BEGIN")) {
            return Ok(false);
        }
        if words.all(|word| word.is_empty() || word.eq_ignore_ascii_case("BULK")) && self.is_empty() {
            return Ok(true);
        }
        let what = format!("`{}` begins another part of the deck", text.trim());
        Err(superelements::refusal(&line.head.span, &what))
    }

    /// Whether no card has been read.
    fn is_empty(&self) -> bool {
        let BulkData { subcases, bars_twist, .. } = &self.deck;
        self.deck == BulkData { subcases: subcases.clone(), bars_twist: *bars_twist, ..BulkData::default() }
    }

    fn include(&mut self, from: &Path, found: &include::Target) -> Result<(), InputError> {
        let path = from.parent().unwrap_or(Path::new("")).join(&found.path);
        let about = std::fs::metadata(&path).map(|about| no_file(&about));
        if !matches!(about, Ok(None)) {
            let is = about
                .ok()
                .flatten()
                .map_or_else(|| "does not exist".to_owned(), |what| format!("is {}", what.0));
            let message = format!("the included file {} {is}", path.display());
            return Err(InputError::at(&found.span, message)
                .with_help("paths are relative to the file that includes"));
        }
        if let Some(first) = self.files.insert(include::identity(&path), found.span.clone()) {
            let message = format!("{} is read twice; first: {first}", path.display());
            return Err(InputError::at(&found.span, message)
                .with_help("include every file once, and not in a circle"));
        }
        let text =
            read_deck_text(&path).map_err(|error| InputError { span: Some(found.span.clone()), ..error })?;
        let lines: Vec<&str> = text.lines().collect();
        self.lines(&path, &lines, 0)
    }

    /// Takes up again the card that announces a continuation, if it is not the last one.
    fn turn_to_parent(&mut self, line: &Line) -> Result<(), InputError> {
        let mark = continuation_name(line.head.text());
        let announced = self.card.as_ref().map_or("", Card::announced);
        if mark.is_empty() || announced == mark {
            return Ok(());
        }
        if let Some((_, parent)) = self.waiting.get_mut(mark).and_then(Vec::pop) {
            self.flush()?;
            self.card = Some(parent);
        } else if announced.is_empty() {
            self.adopted.entry(mark.to_owned()).or_insert_with(|| line.head.span.clone());
        }
        Ok(())
    }

    /// Reads the cards whose continuation never came: a name at the end of a line may be a mere remark.
    fn read_waiting(&mut self) -> Result<(), InputError> {
        let mut waiting: Vec<(usize, Card)> =
            std::mem::take(&mut self.waiting).into_values().flatten().collect();
        waiting.sort_by_key(|(place, _)| *place);
        for (_, card) in waiting {
            if let Some(span) = self.adopted.get(card.announced()) {
                let message = format!(
                    "continuation `{}` stands before the card that announces it ({})",
                    card.announced(),
                    card.span
                );
                return Err(InputError::at(span, message).with_help("put it after that card"));
            }
            self.complete(card)?;
        }
        Ok(())
    }

    /// Turns the card that is complete now into its struct; one that announces a continuation waits for it.
    fn flush(&mut self) -> Result<(), InputError> {
        match self.card.take() {
            Some(card) if card.announced().is_empty() => self.complete(card),
            Some(card) => {
                self.waited += 1;
                self.waiting.entry(card.announced().to_owned()).or_default().push((self.waited, card));
                Ok(())
            }
            None => Ok(()),
        }
    }

    fn complete(&mut self, card: Card) -> Result<(), InputError> {
        superelements::refuse(&card.name, &card.span)?;
        if card.name == "DMI" {
            return self.matrices.add(card);
        }
        self.ranges = self.ranges.saturating_add(lists::numbers_in_ranges(&card));
        if self.ranges > MOST_IN_RANGES {
            let message = format!("THRU stands for more than {MOST_IN_RANGES} numbers in this deck");
            return Err(InputError::at(&card.span, message)
                .with_help("look for a slip in the last number of a range, or for cards given many times"));
        }
        self.numbers.claim(&card)?;
        match self.defaults.take(card)? {
            Some(card) => self.keep(card),
            None => Ok(()),
        }
    }

    fn keep(&mut self, card: Card) -> Result<(), InputError> {
        if matches!(card.name.as_str(), "CELAS3" | "CELAS4" | "CMASS3" | "CMASS4" | "CDAMP3" | "CDAMP4") {
            let ends = [card.count_or(2, "S1", 0)?, card.count_or(3, "S2", 0)?];
            let points = ends.into_iter().filter(|id| *id > 0);
            self.named_points.extend(points.map(|id| Spoint { id, span: card.span.clone() }));
        }
        if card.name == "SPOINT" {
            // Naming a scalar point again changes nothing.
            self.named_points.extend(Spoint::read(&card)?);
            return Ok(());
        }
        if card.name == "GRID" && self.is_known(&card)? {
            return Ok(());
        }
        if card.name == "PBCOMP" {
            self.areas.extend(LumpedAreas::read(&card)?);
        }
        if AIR.contains(&card.name.as_str()) {
            // A structure does without them, and whoever needs them asks for what was wrong.
            let wrong = self.deck.keep(&card).err();
            self.deck.air_errors.extend(wrong);
            return Ok(());
        }
        self.deck.loss_factors.keep(&card);
        if !self.deck.keep(&card)? && !self.parameter(&card)? {
            let number: Option<u32> = card.text(0).parse().ok();
            let parameter = (card.name == "PARAM").then(|| card.text(0).to_uppercase());
            let unread = self.deck.unknown.entry(card.name).or_insert_with(|| Unread::first(card.span));
            unread.count += 1;
            unread.numbers.extend(number);
            unread.parameters.extend(parameter);
        }
        Ok(())
    }

    /// Whether a GRID is there already and says the same, which Nastran takes.
    fn is_known(&self, card: &Card) -> Result<bool, InputError> {
        let Some(known) = self.deck.grids.get(&card.id(0, "ID")?) else { return Ok(false) };
        let again = Grid::read(card)?;
        Ok(again.iter().all(|grid| Grid { span: known.span.clone(), ..grid.clone() } == *known))
    }

    /// Keeps a PARAM with a number.
    fn parameter(&mut self, card: &Card) -> Result<bool, InputError> {
        if card.name != "PARAM" {
            return Ok(false);
        }
        let Some((name, value)) = card.parameter()? else { return Ok(false) };
        let before = self.deck.parameters.insert(name.clone(), value);
        if let Some(before) = before.filter(|before| *before != value) {
            let message = format!("parameter {name} is {value} here and {before} before");
            return Err(card.error(1, message).with_help("give every parameter once"));
        }
        Ok(true)
    }

    /// Scalar points that only CELAS3, CELAS4 and the like name; a point cannot be a grid as well.
    fn scalar_points(&mut self) -> Result<(), InputError> {
        for Spoint { id, span } in std::mem::take(&mut self.named_points) {
            self.deck.scalar_points.entry(id).or_insert(Spoint { id, span });
        }
        match self.deck.scalar_points.values().find(|point| self.deck.grids.contains_key(&point.id)) {
            Some(Spoint { id, span }) => {
                let message =
                    format!("{id} is a scalar point here and a GRID at {}", self.deck.grids[id].span);
                Err(InputError::at(span, message).with_help("give points and grids different numbers"))
            }
            None => checks::components(&self.deck),
        }
    }

    fn finish(mut self) -> Result<BulkData, InputError> {
        self.read_waiting()?;
        for card in self.defaults.elements() {
            self.keep(card)?;
        }
        self.defaults.grids(&mut self.deck)?;
        for areas in &self.areas {
            areas.settle(&mut self.deck.beam_properties, &self.deck.materials)?;
        }
        self.scalar_points()?;
        self.deck.matrices = self.matrices.assemble()?;
        crate::geometry::check_grids(&self.deck)?;
        checks::material_axes(&self.deck)?;
        Ok(self.deck)
    }
}
