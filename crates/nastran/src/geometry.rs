//! Coordinate systems: the systems of a deck (CORD1R, CORD2R, and the cylindrical and spherical ones) resolved to
//! the basic system.
//!
//! The three points of a system give its axes: z from A to B, x in the half plane of C, y = z x x. They may
//! stand in another system or be grids of other systems, in any order, but not in a circle.
//!
//! Cylindrical coordinates are r, theta, z with x = r cos(theta), y = r sin(theta). Spherical ones are r, theta, phi
//! with x = r sin(theta) cos(phi), y = r sin(theta) sin(phi), z = r cos(theta). The axes at a point are those in
//! which r, theta and z (or phi) grow; on the z axis, where they are not defined, those of theta (or phi) zero.

use crate::bulk_data::BulkData;
use crate::cards::{Coord, CoordDefinition, CoordKind, Grid};
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
    kind: CoordKind,
}

impl Frame {
    /// The place of three coordinates, in the basic system.
    fn place(&self, coordinates: Point3<f64>) -> Point3<f64> {
        self.origin + self.axes * cartesian(self.kind, coordinates)
    }

    /// The directions in which the coordinates grow at a point of the basic system, as columns.
    fn axes_at(&self, point: &Point3<f64>) -> Matrix3<f64> {
        let local = self.axes.transpose() * (point - self.origin);
        let across = local.x.hypot(local.y);
        // Nearer to the axis than round-off of the place, the direction would be noise.
        let scale = local.norm() + self.origin.coords.norm();
        let (cos, sin) =
            if across > 1e-12 * scale { (local.x / across, local.y / across) } else { (1.0, 0.0) };
        let turned = match self.kind {
            CoordKind::Rectangular => return self.axes,
            CoordKind::Cylindrical => Matrix3::new(cos, -sin, 0.0, sin, cos, 0.0, 0.0, 0.0, 1.0),
            CoordKind::Spherical => {
                let distance = local.norm();
                let (up, out) = if distance > 1e-12 * scale {
                    (local.z / distance, across / distance)
                } else {
                    (1.0, 0.0)
                };
                let radial = Vector3::new(out * cos, out * sin, up);
                let polar = Vector3::new(up * cos, up * sin, -out);
                Matrix3::from_columns(&[radial, polar, Vector3::new(-sin, cos, 0.0)])
            }
        };
        self.axes * turned
    }
}

fn cartesian(kind: CoordKind, coordinates: Point3<f64>) -> Vector3<f64> {
    let [first, second, third] = coordinates.into();
    let (sin, cos) = second.to_radians().sin_cos();
    match kind {
        CoordKind::Rectangular => Vector3::new(first, second, third),
        CoordKind::Cylindrical => Vector3::new(first * cos, first * sin, third),
        CoordKind::Spherical => {
            let (sin_phi, cos_phi) = third.to_radians().sin_cos();
            Vector3::new(first * sin * cos_phi, first * sin * sin_phi, first * cos)
        }
    }
}

impl Frames {
    /// Resolves all systems of a deck.
    ///
    /// # Errors
    /// If a system refers to one or to a grid that is not there, refers to itself by detours, or its points do
    /// not span a plane; the system's card is blamed.
    pub fn resolve(deck: &BulkData) -> Result<Self, InputError> {
        let kind = CoordKind::Rectangular;
        let basic = Frame { origin: Point3::origin(), axes: Matrix3::identity(), kind };
        let mut frames = Self { frames: BTreeMap::from([(0, basic)]), unread: unread(deck) };
        for id in deck.coords.keys() {
            frames.resolve_one(deck, *id)?;
        }
        Ok(frames)
    }

    /// The place of coordinates `xyz` of system `cid`, in the basic system; angles in degrees. `span` is the card
    /// that refers to `cid`.
    ///
    /// # Errors
    /// If there is no such system.
    pub fn point(&self, cid: u32, xyz: Point3<f64>, span: &Span) -> Result<Point3<f64>, InputError> {
        let frame = self.frames.get(&cid).ok_or_else(|| self.missing(cid, Some(span)))?;
        Ok(frame.place(xyz))
    }

    /// The origin of system `cid`, in the basic system; `span` is the card that refers to it.
    ///
    /// # Errors
    /// If there is no such system.
    pub fn origin(&self, cid: u32, span: &Span) -> Result<Point3<f64>, InputError> {
        self.point(cid, Point3::origin(), span)
    }

    /// The axes of rectangular system `cid` as columns (x, y, z) in the basic system.
    ///
    /// # Errors
    /// As [`Frames::axes_at`], without a place.
    pub fn axes(&self, cid: u32) -> Result<Matrix3<f64>, InputError> {
        self.rectangular(cid, None)
    }

    /// As [`Frames::axes`]; `span` is the card that refers to `cid`.
    ///
    /// # Errors
    /// If there is no such system, or its axes differ from point to point ([`Frames::axes_at_point`] has those),
    /// with the card's place.
    pub fn axes_at(&self, cid: u32, span: &Span) -> Result<Matrix3<f64>, InputError> {
        self.rectangular(cid, Some(span))
    }

    /// The axes of system `cid` at a point of the basic system, as columns in the basic system: x, y, z; r, theta, z;
    /// or r, theta, phi. For rectangular systems as [`Frames::axes_at`].
    ///
    /// # Errors
    /// If there is no such system; `span` is the card that refers to it.
    pub fn axes_at_point(
        &self,
        cid: u32,
        point: &Point3<f64>,
        span: &Span,
    ) -> Result<Matrix3<f64>, InputError> {
        let frame = self.frames.get(&cid).ok_or_else(|| self.missing(cid, Some(span)))?;
        Ok(frame.axes_at(point))
    }

    fn rectangular(&self, cid: u32, span: Option<&Span>) -> Result<Matrix3<f64>, InputError> {
        let frame = self.frames.get(&cid).ok_or_else(|| self.missing(cid, span))?;
        if frame.kind == CoordKind::Rectangular {
            return Ok(frame.axes);
        }
        let message = format!("coordinate system {cid} is not rectangular, which is needed here");
        let error = match span {
            Some(span) => InputError::at(span, message),
            None => InputError::general(message),
        };
        Err(error.with_help("name a CORD1R or CORD2R"))
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
            Ok(Frame { origin: a, axes, kind: coord.kind })
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
        error.with_help(format!("the deck has {names} cards, which are not read; use CORD1R, CORD1C, CORD1S, CORD2R, CORD2C or CORD2S"))
    }
}

fn grid<'a>(deck: &'a BulkData, id: u32, coord: &Coord) -> Result<&'a Grid, InputError> {
    deck.grids.get(&id).ok_or_else(|| {
        InputError::at(&coord.span, format!("grid {id} of coordinate system {} does not exist", coord.id))
    })
}
