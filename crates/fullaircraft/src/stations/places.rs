//! Stations: a point, and the grids whose loads count there. Wings at their roots and at any points along the span, the tail's
//! surfaces, the fuselage on both sides of the wing, and the whole.
//!
//! ```text
//! F = sum f_g,   M = sum (r_g - r_0) x f_g + m_g      over the grids of the station: Rᵀ f, R the station's rigid motions
//! ```
//! All is summed on the structure: loads of boxes count where the spline takes them, so a cut through a member has the forces of
//! that member. Aircraft axes (x aft, y right, z up) on both sides: what everything outboard puts on the rest has Fz up,
//! Mx = +y Fz (negative on the left under lift), My nose up.

use crate::aircraft::assembly::{Aircraft, WingPlaces};
use coupling::wing_file::StationAt;
use faer::Mat;
use nalgebra::{Matrix3, Point3, Vector3};
use nastran::InputError;
use structure::System;

/// A station.
#[derive(Debug, Clone, PartialEq)]
pub struct Station {
    /// `right root`, `left NAME`, `whole`...
    pub name: String,
    /// What columns of histories call it: `right`, `NAME_left`, `whole`...
    pub channel: String,
    /// Point the moments are about.
    pub point: Point3<f64>,
    /// Nodes that count, as places in the structure's list.
    pub nodes: Vec<usize>,
    /// Directions that loads are along and about, as columns: those of the aircraft but for monitoring points of decks.
    pub axes: Matrix3<f64>,
}

impl Station {
    /// Fx, Fy, Fz (N), Mx, My, Mz (N m) about the station's point, in its axes, of loads on the g-set; `points` are the structure's nodes.
    pub fn sums(&self, points: &[Point3<f64>], f_g: &[f64]) -> [f64; 6] {
        let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
        for &node in &self.nodes {
            let part = |from: usize| Vector3::from_fn(|axis, _| f_g[6 * node + from + axis]);
            force += part(0);
            moment += part(3) + (points[node] - self.point).cross(&part(0));
        }
        let [force, moment] = [force, moment].map(|three| self.axes.transpose() * three);
        [force.x, force.y, force.z, moment.x, moment.y, moment.z]
    }

    /// Rigid motions of its nodes about a point in aircraft axes, the rest still, g-set by 6: their transpose sums loads.
    pub(crate) fn motions(&self, system: &System, about: &Point3<f64>) -> Mat<f64> {
        let rigid = system.rigid_body(about);
        let mut own = Mat::zeros(rigid.nrows(), 6);
        for dof in self.nodes.iter().flat_map(|node| 6 * node..6 * node + 6) {
            (0..6).for_each(|motion| own[(dof, motion)] = rigid[(dof, motion)]);
        }
        own
    }
}

impl Aircraft {
    /// Right and left root, then right and left of the stations of the wing's file and of `points` of the right wing.
    ///
    /// # Errors
    /// If two have the same name, or one has no grids outboard of it.
    pub fn wing_stations(&self, points: &[StationAt]) -> Result<Vec<Station>, InputError> {
        let whole = |side: &str, wing: &WingPlaces| Station {
            name: format!("{side} root"),
            channel: side.to_owned(),
            point: self.root_point(),
            nodes: wing.nodes.clone(),
            axes: Matrix3::identity(),
        };
        let mut all = vec![whole("right", &self.right), whole("left", &self.left)];
        let points: Vec<&StationAt> = self.wing.stations.iter().chain(points).collect();
        for (at, point) in points.iter().enumerate() {
            if point.name == "root" || points[..at].iter().any(|other| other.name == point.name) {
                return Err(InputError::general(format!("two stations are called {}", point.name))
                    .with_help("give every station its own name; the wing's file may have some, too"));
            }
            all.push(self.outboard(point, "right", &self.right, 1.0)?);
            all.push(self.outboard(point, "left", &self.left, -1.0)?);
        }
        Ok(all)
    }

    /// Roots of the tail's surfaces, the fuselage ahead of and behind the wing's root (behind with the tail), and the whole about its
    /// centre of gravity.
    pub fn body_stations(&self) -> Vec<Station> {
        let points = self.free.points();
        let station = |name: &str, point, nodes: Vec<usize>| Station {
            name: name.to_owned(),
            channel: name.replace(' ', "_"),
            point,
            nodes,
            axes: Matrix3::identity(),
        };
        let names = ["right horizontal tail", "left horizontal tail", "vertical tail"];
        let mut all: Vec<Station> = names
            .iter()
            .zip(&self.tail)
            .filter_map(|(name, nodes)| Some(station(name, points[*nodes.first()?], nodes.clone())))
            .collect();
        let centre = points[self.centre];
        let (ahead, behind): (Vec<usize>, Vec<usize>) = (self.fuselage.iter())
            .filter(|node| **node != self.centre)
            .partition(|node| points[**node].x < centre.x);
        let mut behind: Vec<usize> = behind.into_iter().chain(self.tail.iter().flatten().copied()).collect();
        behind.sort_unstable();
        all.push(station("fuselage ahead", centre, ahead));
        all.push(station("fuselage behind", centre, behind));
        all.push(station("whole", self.mass.centre, (0..self.free.node_count()).collect()));
        all
    }

    fn outboard(
        &self,
        point: &StationAt,
        side: &str,
        wing: &WingPlaces,
        sign: f64,
    ) -> Result<Station, InputError> {
        let beyond = |node: &usize| sign * self.free.points()[*node].y > point.y_m;
        let nodes: Vec<usize> = wing.nodes.iter().copied().filter(beyond).collect();
        if nodes.is_empty() {
            let message =
                format!("station {} has nothing of the wing outboard of y = {} m", point.name, point.y_m);
            return Err(
                InputError::general(message).with_help("expected a y between the wing's root and its tip")
            );
        }
        let root = self.root_point();
        let place = Point3::new(point.x_m.unwrap_or(root.x), sign * point.y_m, point.z_m.unwrap_or(root.z));
        let (name, channel) = (format!("{side} {}", point.name), format!("{}_{side}", point.name));
        Ok(Station { name, channel, point: place, nodes, axes: Matrix3::identity() })
    }
}
