//! What a page is made of, and its figures sorted under headings.

use report::page::{Block, Content, Input, Plate, Section};
use report::{Drawing, Page};
use serde_json::Value;

/// Makes the head of a page from `result.json` and takes the figures that stand in it.
pub type Head = fn(&Value, &mut Vec<Plate>) -> Page;

/// What a page is made of.
#[derive(Debug, Default)]
pub struct Written {
    /// What `result.json` holds.
    pub result: Value,
    /// Figures in the order of their writing.
    pub plates: Vec<Plate>,
    /// What was read.
    pub inputs: Vec<Input>,
    /// Who makes the page's head, for commands that are not in the list of pages.
    pub head: Option<Head>,
    /// The same as pictures, by name.
    pub drawings: Vec<(String, Drawing)>,
}

/// So many figures with curves stand open on a page; more are folded up.
const OPEN: usize = 6;

/// A section of figures; curves beyond the first few are folded up.
pub fn figures(title: &str, plates: Vec<Plate>) -> Section {
    let mut open = 0;
    let block = |mut plate: Plate| {
        if matches!(plate.content, Content::Curves(_)) {
            open += 1;
            plate.folded |= open > OPEN;
        }
        Block::Plate(Box::new(plate))
    };
    Section::new(title, plates.into_iter().map(block).collect())
}

/// Takes the figures whose names begin with something out of the list.
pub fn taken(plates: &mut Vec<Plate>, prefix: &str) -> Vec<Plate> {
    let (chosen, rest) = plates.drain(..).partition(|plate: &Plate| plate.name.starts_with(prefix));
    *plates = rest;
    chosen
}
