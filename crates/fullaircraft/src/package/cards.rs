//! Cards of cases: FORCE and MOMENT of each, an index with a subcase each, and the structure they act on.
//!
//! What is on the cards is all that is applied (air, inertia, thrust, damping, gravity) at the grids, in the basic system;
//! no reactions. The aircraft is free; the index holds it at the wing's root, where loads in balance leave no reaction.

use crate::aircraft::assembly::Aircraft;
use nastran::{BulkData, InputError, load_cards, write_deck};
use std::collections::BTreeMap;
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
        self.text_in("N, N m; basic axes x aft, y right, z up", grids, origin)
    }

    /// The same with units and axes of a deck's own, in words.
    pub fn text_in(&self, units: &str, grids: &[u32], origin: &[String]) -> String {
        let mut text = comments(origin);
        let sentence = format!(
            "net applied loads (air, inertia, thrust, damping, gravity), limit; {units}; no reactions"
        );
        text += &comments(&[self.words.clone(), sentence]);
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

impl CardCase {
    /// Loads of this case in its file as read, six a place, by the place of each grid.
    ///
    /// # Errors
    /// If a load is of another case, at no place, or in another system.
    pub(crate) fn read_back(
        &self,
        deck: &BulkData,
        places: usize,
        place: impl Fn(u32) -> Option<usize>,
    ) -> Result<Vec<f64>, InputError> {
        let sid = self.sid;
        let mut loads = vec![0.0; 6 * places];
        let factor = |set: u32| match deck.load_sums.get(&sid) {
            Some(sum) => {
                sum.parts.iter().filter(|(_, of)| *of == set).map(|(part, _)| sum.scale * part).sum()
            }
            None => f64::from(u8::from(set == sid)),
        };
        for card in &deck.point_loads {
            let factor: f64 = factor(card.set);
            let node = place(card.grid).filter(|_| factor != 0.0 && card.cid == 0);
            let node = node.ok_or_else(|| {
                let message =
                    format!("this load of set {} at grid {} is not of case {sid}", card.set, card.grid);
                InputError::at(&card.span, message)
            })?;
            let first = 6 * node + if card.is_moment { 3 } else { 0 };
            (0..3).for_each(|axis| loads[first + axis] += factor * card.vector[axis]);
        }
        Ok(loads)
    }
}

/// Lines as comments of a deck, without what would end one.
pub(crate) fn comments(lines: &[String]) -> String {
    lines.iter().fold(String::new(), |text, line| text + "$ " + &line.replace(['\n', '\r'], " ") + "\n")
}

/// The structure that the cards belong to, to be included in a bulk data section; `origin` says where it comes from.
pub fn structure(aircraft: &Aircraft, origin: &[String]) -> String {
    structure_of(&aircraft.bulk, origin)
}

/// The structure of any deck: without its air, loads, supports and case control.
pub fn structure_of(deck: &BulkData, origin: &[String]) -> String {
    let all = deck.clone();
    let bulk = BulkData {
        panels: BTreeMap::new(),
        panel_properties: BTreeMap::new(),
        factors: BTreeMap::new(),
        surfaces: BTreeMap::new(),
        box_lists: BTreeMap::new(),
        splines: BTreeMap::new(),
        monitors: Vec::new(),
        sets: BTreeMap::new(),
        point_loads: Vec::new(),
        line_loads: Vec::new(),
        cross_loads: Vec::new(),
        pressures: Vec::new(),
        gravities: Vec::new(),
        spins: Vec::new(),
        accelerations: Vec::new(),
        load_sums: BTreeMap::new(),
        aero_reference: None,
        trim_variables: BTreeMap::new(),
        trims: BTreeMap::new(),
        aero_links: Vec::new(),
        aero_components: BTreeMap::new(),
        supports: Vec::new(),
        unsteady_reference: None,
        flutters: BTreeMap::new(),
        flutter_factors: BTreeMap::new(),
        reduced_frequencies: Vec::new(),
        matrices: BTreeMap::new(),
        subcases: Vec::new(),
        ..all
    };
    let cards = write_deck(&bulk);
    let lines = cards.lines().filter(|line| !["BEGIN BULK", "ENDDATA"].contains(line));
    lines.fold(comments(origin), |text, line| text + line + "\n")
}

/// What holds a structure in the index: the sets of its own constraints and equations, and the motions of a grid that are held where
/// no reaction may be left.
#[derive(Debug, Clone, PartialEq)]
pub struct Hold {
    /// SPC sets of the structure that stay.
    pub constraints: Vec<u32>,
    /// MPC set of the structure.
    pub equations: Option<u32>,
    /// A set that no card has.
    pub set: u32,
    /// Grid and components (1 to 6); none: its own constraints hold it.
    pub support: Option<(u32, Vec<u8>)>,
}

impl Hold {
    /// Of a deck with the constraints and equations that apply.
    pub fn of(bulk: &BulkData, equations: Option<u32>, support: Option<(u32, Vec<u8>)>) -> Self {
        let mut constraints: Vec<u32> = bulk.constraints.iter().map(|card| card.set).collect();
        constraints.sort_unstable();
        constraints.dedup();
        let used = constraints.iter().chain(bulk.constraint_unions.keys()).max();
        let equations = equations.or_else(|| bulk.equations.first().map(|card| card.set));
        Self { set: used.map_or(1, |used| used + 1), constraints, equations, support }
    }

    /// Of an aircraft of ours: at the wing's root.
    pub fn at_the_root(aircraft: &Aircraft) -> Self {
        let centre = aircraft.free.node_ids()[aircraft.centre];
        Self::of(&aircraft.bulk, None, Some((centre, (1..=6).collect())))
    }

    fn case_control(&self) -> String {
        let applied = if self.constraints.is_empty() { self.set } else { self.set + 1 };
        let equations = self.equations.map_or_else(String::new, |set| format!("MPC = {set}\n"));
        format!("SPC = {applied}\n{equations}")
    }

    fn cards(&self) -> String {
        let mut text = String::new();
        let mut united = self.constraints.clone();
        if let Some((grid, components)) = &self.support {
            let digits = components.iter().fold(String::new(), |text, digit| text + &digit.to_string());
            // Writing to a String cannot fail.
            let _ = writeln!(text, "SPC1    {:>8}{digits:>8}{grid:>8}", self.set);
            united.push(self.set);
        }
        if !self.constraints.is_empty() {
            let _ = write!(text, "SPCADD,{}", self.set + 1);
            for (at, set) in united.iter().enumerate() {
                // seven in the first line, eight in each that follows
                let begins = if at > 0 && (at + 1) % 8 == 0 { "\n" } else { "" };
                let _ = write!(text, "{begins},{set}");
            }
            text.push('\n');
        }
        text
    }
}

/// The deck of all cases: linear statics, a subcase each, the files included, the aircraft held at the wing's root.
pub fn index(aircraft: &Aircraft, title: &str, cases: &[CardCase], origin: &[String]) -> String {
    index_of("aircraft.bdf", Some(&Hold::at_the_root(aircraft)), title, cases, origin)
}

/// The deck of all cases of the structure in a file, held in a way of its own; without a hold there are only grids, for another's structure.
pub fn index_of(
    structure: &str,
    hold: Option<&Hold>,
    title: &str,
    cases: &[CardCase],
    origin: &[String],
) -> String {
    let mut text = comments(origin);
    // Writing to a String cannot fail.
    let _ = write!(
        text,
        "SOL 101\nCEND\nTITLE = {}\n{}DISPLACEMENT = ALL\nSPCFORCES = ALL\n",
        clipped(title),
        hold.map(Hold::case_control).unwrap_or_default()
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
    let _ = writeln!(text, "BEGIN BULK\nINCLUDE '{structure}'");
    for case in cases {
        let _ = writeln!(text, "INCLUDE '{}'", case.file());
    }
    text + &hold.map(Hold::cards).unwrap_or_default() + "ENDDATA\n"
}

/// As much as a title can have.
fn clipped(words: &str) -> String {
    words.chars().filter(|c| !c.is_control()).take(SUBTITLE).collect()
}

#[cfg(test)]
mod tests;
