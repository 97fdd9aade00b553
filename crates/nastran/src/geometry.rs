//! Coordinate systems: the rectangular systems of a deck (CORD1R, CORD2R) resolved to the basic system.
//!
//! The three points of a system give its axes: z from A to B, x in the half plane of C, y = z x x. They may
//! stand in another system or be grids of other systems, in any order, but not in a circle.

use crate::cards::{BulkData, Coord, CoordDefinition, Grid};
use crate::source::{InputError, Span};
use nalgebra::{Matrix3, Point3, Vector3};
use std::collections::{BTreeMap, BTreeSet};

/// Every coordinate system of a deck, in the basic system.
#[derive(Debug, Clone)]
pub struct Frames {
    frames: BTreeMap<u32, Frame>,
    unread: Vec<String>,
}

#[derive(Debug, Clone, Copy)]
struct Frame {
    origin: Point3<f64>,
    axes: Matrix3<f64>,
}

impl Frames {
    /// Resolves all systems of a deck.
    ///
    /// # Errors
    /// If a system refers to one or to a grid that is not there, refers to itself by detours, or its points do
    /// not span a plane; the system's card is blamed.
    pub fn resolve(deck: &BulkData) -> Result<Self, InputError> {
        let basic = Frame { origin: Point3::origin(), axes: Matrix3::identity() };
        let mut frames = Self { frames: BTreeMap::from([(0, basic)]), unread: unread(deck) };
        for id in deck.coords.keys() {
            frames.resolve_one(deck, *id)?;
        }
        Ok(frames)
    }

    /// The point `xyz` of system `cid`, in the basic system. `span` is the card that refers to `cid`.
    ///
    /// # Errors
    /// If there is no such system.
    pub fn point(&self, cid: u32, xyz: [f64; 3], span: &Span) -> Result<Point3<f64>, InputError> {
        let frame = self.frames.get(&cid).ok_or_else(|| self.missing(cid, Some(span)))?;
        Ok(frame.origin + frame.axes * Vector3::from(xyz))
    }

    /// The axes of system `cid` as columns (x, y, z) in the basic system.
    ///
    /// # Errors
    /// If there is no such system; the error has no place, see [`Frames::axes_at`].
    pub fn axes(&self, cid: u32) -> Result<Matrix3<f64>, InputError> {
        self.frames.get(&cid).map(|frame| frame.axes).ok_or_else(|| self.missing(cid, None))
    }

    /// As [`Frames::axes`]; `span` is the card that refers to `cid`.
    ///
    /// # Errors
    /// If there is no such system, with the card's place.
    pub fn axes_at(&self, cid: u32, span: &Span) -> Result<Matrix3<f64>, InputError> {
        self.frames.get(&cid).map(|frame| frame.axes).ok_or_else(|| self.missing(cid, Some(span)))
    }

    /// A grid's place in the basic system.
    ///
    /// # Errors
    /// If the grid's coordinate system is not there.
    pub fn grid_point(&self, grid: &Grid) -> Result<Point3<f64>, InputError> {
        self.point(grid.cp, grid.xyz, &grid.span)
    }

    /// Resolves a system after those it needs, with a stack of our own: a long chain must not end the program.
    fn resolve_one(&mut self, deck: &BulkData, id: u32) -> Result<(), InputError> {
        let mut stack = vec![id];
        let mut waiting = BTreeSet::from([id]);
        while let Some(&id) = stack.last() {
            if self.frames.contains_key(&id) {
                stack.pop();
                continue;
            }
            let coord = &deck.coords[&id];
            let missing = self.needed(deck, coord)?;
            let Some(next) = missing else {
                let frame = self.build(deck, coord)?;
                self.frames.insert(id, frame);
                waiting.remove(&id);
                continue;
            };
            if !deck.coords.contains_key(&next) {
                return Err(self.missing(next, Some(&coord.span)));
            }
            if !waiting.insert(next) {
                let message = format!("coordinate system {id} refers to itself by way of system {next}");
                return Err(
                    InputError::at(&coord.span, message).with_help("define one of them in the basic system")
                );
            }
            stack.push(next);
        }
        Ok(())
    }

    /// A system that must be resolved before `coord`.
    fn needed(&self, deck: &BulkData, coord: &Coord) -> Result<Option<u32>, InputError> {
        let needed = match coord.definition {
            CoordDefinition::Points { rid, .. } => vec![rid],
            CoordDefinition::Grids(grids) => {
                grids.iter().map(|id| grid(deck, *id, coord).map(|grid| grid.cp)).collect::<Result<_, _>>()?
            }
        };
        Ok(needed.into_iter().find(|id| !self.frames.contains_key(id)))
    }

    fn build(&self, deck: &BulkData, coord: &Coord) -> Result<Frame, InputError> {
        let points = match coord.definition {
            CoordDefinition::Points { rid, a, b, c } => {
                [a, b, c].map(|xyz| self.point(rid, xyz, &coord.span))
            }
            CoordDefinition::Grids(grids) => {
                grids.map(|id| grid(deck, id, coord).and_then(|grid| self.grid_point(grid)))
            }
        };
        let [a, b, c] = points;
        let (a, b, c) = (a?, b?, c?);
        let degenerate = || {
            InputError::at(
                &coord.span,
                format!("the three points of coordinate system {} do not span a plane", coord.id),
            )
            .with_help("B must differ from A, and C must not lie on the line through A and B")
        };
        let z = (b - a).try_normalize(0.0).ok_or_else(degenerate)?;
        let towards_c = (c - a).try_normalize(0.0).ok_or_else(degenerate)?;
        // Below this sine the direction of x would be round-off.
        let y = z.cross(&towards_c).try_normalize(1e-9).ok_or_else(degenerate)?;
        let axes = Matrix3::from_columns(&[y.cross(&z), y, z]);
        if axes.iter().all(|value| value.is_finite()) {
            Ok(Frame { origin: a, axes })
        } else {
            Err(degenerate())
        }
    }

    fn missing(&self, cid: u32, span: Option<&Span>) -> InputError {
        missing(&self.unread, cid, span)
    }
}

/// Demands that every system a grid refers to has been read.
pub(crate) fn check_grids(deck: &BulkData) -> Result<(), InputError> {
    let known = |cid: u32| cid == 0 || deck.coords.contains_key(&cid);
    for grid in deck.grids.values() {
        if let Some(cid) = [grid.cp, grid.cd].into_iter().find(|cid| !known(*cid)) {
            let error = missing(&unread(deck), cid, Some(&grid.span));
            let message = format!("grid {} refers to coordinate system {cid}, which is not defined", grid.id);
            return Err(InputError { message, ..error });
        }
    }
    Ok(())
}

/// The names of coordinate system cards that are in the deck but not read.
fn unread(deck: &BulkData) -> Vec<String> {
    deck.unknown.keys().filter(|name| name.starts_with("CORD")).cloned().collect()
}

fn missing(unread: &[String], cid: u32, span: Option<&Span>) -> InputError {
    let message = format!("coordinate system {cid} is not defined");
    let error = match span {
        Some(span) => InputError::at(span, message),
        None => InputError::general(message),
    };
    if unread.is_empty() {
        error.with_help(format!("add a CORD2R {cid} or correct the number"))
    } else {
        let names = unread.join(", ");
        error.with_help(format!("the deck has {names} cards, which are not read; use CORD1R or CORD2R"))
    }
}

fn grid<'a>(deck: &'a BulkData, id: u32, coord: &Coord) -> Result<&'a Grid, InputError> {
    deck.grids.get(&id).ok_or_else(|| {
        InputError::at(&coord.span, format!("grid {id} of CORD1R {} does not exist", coord.id))
    })
}
