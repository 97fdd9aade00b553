//! Decks: files, INCLUDE, executive and case control, and one struct for each card.
//!
//! If the deck has a `BEGIN BULK`, everything before it is skipped; `ENDDATA` ends the deck. Cards that are not
//! read are counted by name in [`BulkData::unknown`], so that nothing is dropped in silence.

use crate::aero_cards as aero;
use crate::card::Card;
use crate::cards::BulkData;
use crate::dmi_reader::DmiCards;
use crate::field::Line;
use crate::include;
use crate::property_cards as property;
use crate::source::{InputError, Span, read_text};
use crate::structure_cards as structure;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Reads a deck with the files it includes.
///
/// # Errors
/// If a file cannot be read, a field is not what its card demands, an identification number is given twice, or
/// a grid refers to a coordinate system that is not there.
pub fn read_deck(path: &Path) -> Result<BulkData, InputError> {
    parse_at(path, &read_text(path)?)
}

/// Parses a deck; `name` is its file name in errors and the place included files are relative to.
///
/// # Errors
/// As [`read_deck`].
pub fn parse_deck(name: &str, text: &str) -> Result<BulkData, InputError> {
    parse_at(Path::new(name), text)
}

fn parse_at(path: &Path, text: &str) -> Result<BulkData, InputError> {
    let mut reader = Reader::default();
    let lines: Vec<&str> = text.lines().collect();
    let bulk = lines.iter().position(|line| is_begin_bulk(line)).map_or(0, |index| index + 1);
    reader.files.insert(include::identity(path), Span::whole_file(path));
    reader.lines(path, &lines, bulk)?;
    reader.finish()
}

fn is_begin_bulk(line: &str) -> bool {
    let mut words = line.split('$').next().unwrap_or("").split_whitespace();
    words.next().is_some_and(|word| word.eq_ignore_ascii_case("BEGIN"))
        && words.next().is_some_and(|word| word.eq_ignore_ascii_case("BULK"))
}

#[derive(Default)]
struct Reader {
    deck: BulkData,
    matrices: DmiCards,
    card: Option<Card>,
    files: BTreeMap<PathBuf, Span>,
    has_ended: bool,
}

impl Reader {
    /// Reads the lines of a file from index `next` on.
    fn lines(&mut self, path: &Path, lines: &[&str], mut next: usize) -> Result<(), InputError> {
        let file = Arc::new(path.to_path_buf());
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
            if line.is_continuation() {
                let Some(card) = &mut self.card else {
                    let error = InputError::at(&line.head.span, "a continuation without a card before it");
                    return Err(error.with_help("a card's name starts in the first column"));
                };
                card.extend(line)?;
            } else {
                self.flush()?;
                if line.head.text().eq_ignore_ascii_case("ENDDATA") {
                    self.has_ended = true;
                } else {
                    self.card = Some(Card::start(line)?);
                }
            }
        }
        self.flush()
    }

    fn include(&mut self, from: &Path, found: &include::Target) -> Result<(), InputError> {
        let path = from.parent().unwrap_or(Path::new("")).join(&found.path);
        if !path.is_file() {
            let message = format!("the included file {} does not exist", path.display());
            return Err(InputError::at(&found.span, message)
                .with_help("paths are relative to the file that includes"));
        }
        if let Some(first) = self.files.insert(include::identity(&path), found.span.clone()) {
            let message = format!("{} is read twice; first: {first}", path.display());
            return Err(InputError::at(&found.span, message)
                .with_help("include every file once, and not in a circle"));
        }
        let text =
            read_text(&path).map_err(|error| InputError { span: Some(found.span.clone()), ..error })?;
        let lines: Vec<&str> = text.lines().collect();
        self.lines(&path, &lines, 0)
    }

    /// Turns the card that is complete now into its struct.
    fn flush(&mut self) -> Result<(), InputError> {
        let Some(card) = self.card.take() else { return Ok(()) };
        if card.name == "DMI" {
            return self.matrices.add(card);
        }
        if !structure_card(&mut self.deck, &card)? && !aero_card(&mut self.deck, &card)? {
            *self.deck.unknown.entry(card.name).or_default() += 1;
        }
        Ok(())
    }

    fn finish(mut self) -> Result<BulkData, InputError> {
        self.deck.matrices = self.matrices.assemble()?;
        crate::geometry::check_grids(&self.deck)?;
        Ok(self.deck)
    }
}

/// Keeps the item of a card whose name is known here.
fn structure_card(deck: &mut BulkData, card: &Card) -> Result<bool, InputError> {
    match card.name.as_str() {
        "GRID" => {
            let item = structure::grid(card)?;
            keep(&mut deck.grids, card, item.id, item, |item| &item.span)
        }
        "CORD1R" => structure::cord1r(card)?
            .into_iter()
            .try_for_each(|item| keep(&mut deck.coords, card, item.id, item, |item| &item.span)),
        "CORD2R" => {
            let item = structure::cord2r(card)?;
            keep(&mut deck.coords, card, item.id, item, |item| &item.span)
        }
        "CBAR" | "CBEAM" => {
            let item = structure::beam_element(card)?;
            keep(&mut deck.beams, card, item.id, item, |item| &item.span)
        }
        "PBAR" | "PBEAM" => {
            let item = if card.name == "PBAR" { property::pbar(card)? } else { property::pbeam(card)? };
            keep(&mut deck.beam_properties, card, item.id, item, |item| &item.span)
        }
        "MAT1" => {
            let item = property::mat1(card)?;
            keep(&mut deck.materials, card, item.id, item, |item| &item.span)
        }
        "CONM2" => {
            let item = structure::conm2(card)?;
            keep(&mut deck.masses, card, item.id, item, |item| &item.span)
        }
        "RBE2" => {
            let item = structure::rbe2(card)?;
            keep(&mut deck.rigid, card, item.id, item, |item| &item.span)
        }
        "SPC1" => {
            deck.constraints.push(structure::spc1(card)?);
            Ok(())
        }
        "SET1" => {
            let item = structure::set1(card)?;
            keep(&mut deck.sets, card, item.id, item, |item| &item.span)
        }
        _ => return Ok(false),
    }
    .map(|()| true)
}

fn aero_card(deck: &mut BulkData, card: &Card) -> Result<bool, InputError> {
    match card.name.as_str() {
        "CAERO1" => {
            let item = aero::caero1(card)?;
            keep(&mut deck.panels, card, item.id, item, |item| &item.span)
        }
        "PAERO1" => {
            keep(&mut deck.panel_properties, card, card.id(0, "PID")?, card.span.clone(), |span| span)
        }
        "AEFACT" => {
            let item = aero::aefact(card)?;
            keep(&mut deck.factors, card, item.id, item, |item| &item.span)
        }
        "AESURF" => {
            let item = aero::aesurf(card)?;
            keep(&mut deck.surfaces, card, item.id, item, |item| &item.span)
        }
        "AELIST" => {
            let item = aero::aelist(card)?;
            keep(&mut deck.box_lists, card, item.id, item, |item| &item.span)
        }
        "MONPNT1" | "MONPNT3" => {
            let item = aero::monitor(card)?;
            if let Some(first) = deck.monitors.iter().find(|other| other.name == item.name) {
                return Err(twice(card, &format!("monitoring station {}", item.name), &first.span));
            }
            deck.monitors.push(item);
            Ok(())
        }
        _ => return Ok(false),
    }
    .map(|()| true)
}

fn keep<T>(
    map: &mut BTreeMap<u32, T>,
    card: &Card,
    id: u32,
    item: T,
    span: impl Fn(&T) -> &Span,
) -> Result<(), InputError> {
    if let Some(first) = map.get(&id) {
        return Err(twice(card, &format!("{} {id}", card.name), span(first)));
    }
    map.insert(id, item);
    Ok(())
}

fn twice(card: &Card, what: &str, first: &Span) -> InputError {
    let message = format!("{what} is given twice; the number or name is taken since {first}");
    card.error(0, message).with_help("give every card its own number or name")
}
