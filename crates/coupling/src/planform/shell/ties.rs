//! What holds the block, what follows it, and the masses on it.
//!
//! The root rib moves as one with the root grid. In the tunnel that grid is at the balance point, held by a bush to
//! a clamped grid at the same place, so that the bush's force is what the balance reads; in an aircraft it is the
//! axis' own grid, for the fuselage to hold. Every other grid of the elastic axis moves as the mean of its station's
//! skin (RBE3), and so takes the boxes' loads to the skin.

use super::mesh::Mesh;
use super::{BALANCE_BUSH, BALANCE_GRID, ROOT_GRID};
use crate::planform::cards::{add_grid, add_mass, add_tie};
use crate::planform::panels::card_number;
use crate::planform::{
    AXIS_SET, FIRST_AXIS_GRID, FIRST_MASS_GRID, FIRST_SENSOR_GRID, Mount, PointMass, ROOT_SET,
};
use nalgebra::Point3;
use nastran::{BulkData, BushAxes, Cbush, Conm2, Pbush, Rbe3, Rbe3Group, Set1, Span, Spc1};

/// Ties are numbered by the grid they hold.
const TIES: u32 = 3_000_000;
/// CONM2 of masses along the span.
const FIRST_LINE_MASS: u32 = 3_100_001;
/// CONM2 of point masses and sensors, numbered by their grid.
const MASSES: u32 = 3_200_000;
const ALL: [u8; 6] = [1, 2, 3, 4, 5, 6];

impl Mesh<'_> {
    pub(super) fn add_ties(&self, bulk: &mut BulkData, mount: Mount, balance: &Point3<f64>, span: &Span) {
        self.add_axis(bulk, span);
        self.add_root(bulk, mount, balance, span);
        self.add_line_masses(bulk, span);
        let items =
            [(FIRST_MASS_GRID, &self.settings.point_masses), (FIRST_SENSOR_GRID, &self.settings.sensors)];
        for (first, items) in items {
            for (id, item) in (first..).zip(items) {
                self.add_point_mass(bulk, id, item, span);
            }
        }
    }

    fn axis_grid(station: usize) -> u32 {
        FIRST_AXIS_GRID + card_number(station)
    }

    /// Skin grids of a station on some chord lines.
    fn skin_grids(&self, station: usize, lines: impl Iterator<Item = usize>) -> Vec<u32> {
        lines.flat_map(|line| [0, self.layers].map(|layer| self.grid(line, station, layer))).collect()
    }

    fn add_axis(&self, bulk: &mut BulkData, span: &Span) {
        for (station, &y_m) in self.y_m.iter().enumerate() {
            let id = Self::axis_grid(station);
            add_grid(bulk, id, &self.axis_point(y_m), span);
            if station > 0 {
                add_mean(bulk, id, self.skin_grids(station, 0..self.lines.len()), span);
            }
        }
        let ids = (0..self.y_m.len()).map(Self::axis_grid).collect();
        bulk.sets.insert(AXIS_SET, Set1 { id: AXIS_SET, ids, span: span.clone() });
    }

    fn add_root(&self, bulk: &mut BulkData, mount: Mount, balance: &Point3<f64>, span: &Span) {
        let axis = Self::axis_grid(0);
        let layers = 0..=self.layers;
        let mut dependent: Vec<u32> = (0..self.lines.len())
            .flat_map(|line| layers.clone().map(move |layer| self.grid(line, 0, layer)))
            .collect();
        let (independent, held) = match mount {
            Mount::Aircraft => (axis, axis),
            Mount::Tunnel => {
                dependent.insert(0, axis);
                self.add_balance(bulk, balance, span);
                (ROOT_GRID, BALANCE_GRID)
            }
        };
        add_tie(bulk, TIES + independent, independent, dependent, span);
        bulk.sets.insert(ROOT_SET, Set1 { id: ROOT_SET, ids: vec![held], span: span.clone() });
    }

    fn add_balance(&self, bulk: &mut BulkData, point: &Point3<f64>, span: &Span) {
        add_grid(bulk, ROOT_GRID, point, span);
        add_grid(bulk, BALANCE_GRID, point, span);
        let (kx, ky, kz, kmx, kmy, kmz) = self.settings.balance_stiffness;
        let stiffness = [kx, ky, kz, kmx, kmy, kmz];
        let id = BALANCE_BUSH;
        let property = Pbush { id, stiffness, damping: [0.0; 6], mass: 0.0, span: span.clone() };
        bulk.bush_properties.insert(id, property);
        let bush = Cbush {
            id,
            property: id,
            grids: (BALANCE_GRID, Some(ROOT_GRID)),
            axes: BushAxes::System(0),
            location: 0.5,
            offset: None,
            span: span.clone(),
        };
        bulk.bushes.insert(id, bush);
        let (components, grids) = (ALL.to_vec(), vec![BALANCE_GRID]);
        bulk.constraints.push(Spc1 { set: 1, components, grids, enforced: 0.0, span: span.clone() });
    }

    /// Each grid of the axis carries the span half way to its neighbours, at that piece's own middle.
    fn add_line_masses(&self, bulk: &mut BulkData, span: &Span) {
        let last = self.spanwise();
        let pieces = (0..=last).map(|station| {
            let (before, after) = (station.saturating_sub(1), (station + 1).min(last));
            let y_m = self.y_m[station];
            (Self::axis_grid(station), 0.5 * (self.y_m[before] + y_m), 0.5 * (y_m + self.y_m[after]))
        });
        let pieces: Vec<(u32, f64, f64)> = pieces.collect();
        let each =
            self.settings.line_masses.iter().flat_map(|item| pieces.iter().map(move |piece| (item, piece)));
        for (id, (item, &(grid, low_m, high_m))) in (FIRST_LINE_MASS..).zip(each) {
            let middle_m = 0.5 * (low_m + high_m);
            let point = self.inner_point(middle_m, item.x_over_c);
            let axis = self.axis_point(self.y_m[(grid - FIRST_AXIS_GRID) as usize]);
            let offset = point - axis;
            let card = Conm2 {
                id,
                grid,
                cid: 0,
                mass: item.mass_kg_m * (high_m - low_m),
                offset,
                inertia: [0.0; 6],
                span: span.clone(),
            };
            bulk.masses.insert(id, card);
        }
    }

    /// A place half way between both surfaces.
    fn inner_point(&self, y_m: f64, x_over_c: f64) -> Point3<f64> {
        self.planform.section_point(y_m, x_over_c, self.contour.camber(x_over_c))
    }

    /// A mass on its own grid, which moves as the mean of the corners of the cell it is in.
    fn add_point_mass(&self, bulk: &mut BulkData, id: u32, item: &PointMass, span: &Span) {
        add_grid(bulk, id, &self.inner_point(item.y_m, item.x_over_c), span);
        add_mean(bulk, id, self.around(item), span);
        add_mass(bulk, MASSES + id, id, item.mass_kg, span);
    }

    /// Corners on both surfaces of the cell around a mass. The root rib's are left out: they follow the root.
    fn around(&self, item: &PointMass) -> Vec<u32> {
        let cell =
            |edges: &[f64], at: f64| edges.partition_point(|&edge| edge <= at).clamp(1, edges.len() - 1) - 1;
        let (line, station) = (cell(&self.lines, item.x_over_c), cell(&self.y_m, item.y_m));
        let stations = [station, station + 1].into_iter().filter(|&station| station > 0);
        stations.flat_map(|station| self.skin_grids(station, line..=line + 1)).collect()
    }
}

/// RBE3: all six motions of `reference` follow the displacements of `grids`, weighted alike.
fn add_mean(bulk: &mut BulkData, reference: u32, grids: Vec<u32>, span: &Span) {
    let id = TIES + reference;
    let groups = vec![Rbe3Group { weight: 1.0, components: vec![1, 2, 3], grids }];
    let (components, um) = (ALL.to_vec(), Vec::new());
    bulk.averages.insert(id, Rbe3 { id, reference, components, groups, um, span: span.clone() });
}
