//! Cards of cases: FORCE and MOMENT of each, an index with a subcase each, and the structure they act on.
//!
//! What is on the cards is all that is applied (air, inertia, thrust, damping, gravity) at the grids, in the basic system;
//! no reactions. The aircraft is free; the index holds it at the wing's root, where loads in balance leave no reaction.

use crate::aircraft::assembly::Aircraft;
use nastran::{BulkData, load_cards, write_deck};
use std::fmt::Write as _;

/// The longest subtitle: programs cut longer ones.
const SUBTITLE: usize = 64;

/// A case and an instant of it.
#[derive(Debug, Clone, PartialEq)]
pub struct CardCase {
    /// Load set and subcase.
    pub sid: u32,
    /// What is flown, in a line: number of the case, speed, load factor, mass.
    pub words: String,
    /// Net loads of the g-set, 6 a node, N and N m.
    pub net: Vec<f64>,
    /// Load sets that the case's LOAD adds up to the net loads; none: the net loads are one set of their own.
    pub parts: Vec<CardPart>,
}

/// A load set that is a part of a case.
#[derive(Debug, Clone, PartialEq)]
pub struct CardPart {
    /// Load set.
    pub sid: u32,
    /// What it is, in words.
    pub words: &'static str,
    /// Loads of the g-set, 6 a node, N and N m.
    pub loads: Vec<f64>,
}

impl CardCase {
    /// Name of its file.
    pub fn file(&self) -> String {
        format!("case_{:05}.bdf", self.sid)
    }

    /// Its file: what it is, in comments, then the cards; `grids` are the numbers of the nodes, `origin` says where it comes from.
    pub fn text(&self, grids: &[u32], origin: &[String]) -> String {
        let mut text = comments(origin);
        text += &comments(&[
            self.words.clone(),
            "net applied loads (air, inertia, thrust, damping, gravity), limit; N, N m; basic axes x aft, y right, z up; no reactions".to_owned(),
        ]);
        if self.parts.is_empty() {
            return text + &load_cards(self.sid, grids, &self.net);
        }
        // Writing to a String cannot fail.
        let _ = write!(text, "LOAD,{},1.", self.sid);
        for part in &self.parts {
            let _ = write!(text, ",1.,{}", part.sid);
        }
        text.push('\n');
        for part in &self.parts {
            text += &comments(&[format!("load set {}: {}", part.sid, part.words)]);
            text += &load_cards(part.sid, grids, &part.loads);
        }
        text
    }
}

/// Lines as comments of a deck, without what would end one.
fn comments(lines: &[String]) -> String {
    lines.iter().fold(String::new(), |text, line| text + "$ " + &line.replace(['\n', '\r'], " ") + "\n")
}

/// The structure that the cards belong to, to be included in a bulk data section; `origin` says where it comes from.
pub fn structure(aircraft: &Aircraft, origin: &[String]) -> String {
    let mut bulk = aircraft.bulk.clone();
    let BulkData { panels, panel_properties, factors, surfaces, box_lists, splines, monitors, sets, .. } =
        &mut bulk;
    panels.clear();
    panel_properties.clear();
    factors.clear();
    surfaces.clear();
    box_lists.clear();
    splines.clear();
    monitors.clear();
    sets.clear();
    bulk.matrices.clear();
    let cards = write_deck(&bulk);
    let lines = cards.lines().filter(|line| !["BEGIN BULK", "ENDDATA"].contains(line));
    lines.fold(comments(origin), |text, line| text + line + "\n")
}

/// The deck of all cases: linear statics, a subcase each, the files included, the aircraft held at the wing's root.
pub fn index(aircraft: &Aircraft, title: &str, cases: &[CardCase], origin: &[String]) -> String {
    let bulk = &aircraft.bulk;
    let sets = bulk.constraints.iter().map(|card| card.set).chain(bulk.constraint_unions.keys().copied());
    let hold = sets.max().unwrap_or(0) + 1;
    let mut text = comments(origin);
    // Writing to a String cannot fail.
    let _ = write!(
        text,
        "SOL 101\nCEND\nTITLE = {}\nSPC = {hold}\nDISPLACEMENT = ALL\nSPCFORCES = ALL\n",
        clipped(title)
    );
    for case in cases {
        let _ = writeln!(
            text,
            "SUBCASE {}\n  SUBTITLE = {}\n  LOAD = {}",
            case.sid,
            clipped(&case.words),
            case.sid
        );
    }
    let _ = writeln!(text, "BEGIN BULK\nINCLUDE 'aircraft.bdf'");
    for case in cases {
        let _ = writeln!(text, "INCLUDE '{}'", case.file());
    }
    let centre = aircraft.free.node_ids()[aircraft.centre];
    let _ = writeln!(text, "SPC1    {hold:>8}{:>8}{centre:>8}\nENDDATA", 123_456);
    text
}

/// As much as a title can have.
fn clipped(words: &str) -> String {
    words.chars().filter(|c| !c.is_control()).take(SUBTITLE).collect()
}
