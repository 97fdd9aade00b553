//! Masses of a beam: slices of the span, and lumps that ride on them.

use super::axis::{Axis, Stiffness};
use super::flexibility::Flexibility;
use crate::wing::Wing;
use nalgebra::DMatrix;

/// A slice of the span: a body that stands off the axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Slice {
    /// Its middle, m.
    pub y_m: f64,
    /// Mass, kg.
    pub mass_kg: f64,
    /// How far its centre of gravity is aft of the axis, m.
    pub aft_m: f64,
    /// Pitch inertia about its centre of gravity, kg m².
    pub pitch_kg_m2: f64,
    /// Roll inertia about its centre of gravity, kg m².
    pub roll_kg_m2: f64,
}

/// A lump without inertia of its own, tied to the nearest slice.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extra {
    /// Place along the span, m.
    pub y_m: f64,
    /// Place along x, m.
    pub x_m: f64,
    /// Mass, kg.
    pub mass_kg: f64,
}

/// A beam, held at y = 0.
#[derive(Debug, Clone)]
pub struct Beam {
    /// Its axis.
    pub axis: Axis,
    /// Its end, m.
    pub end_y_m: f64,
    /// Slices from root to tip.
    pub slices: Vec<Slice>,
    /// Lumps.
    pub extras: Vec<Extra>,
    pub(crate) flexibility: Flexibility,
}

impl Beam {
    /// A beam of slices.
    pub fn new(axis: Axis, end_y_m: f64, slices: Vec<Slice>, stiffness: &dyn Stiffness) -> Self {
        let flexibility = Flexibility::new(&axis, end_y_m, stiffness);
        Self { axis, end_y_m, slices, extras: Vec::new(), flexibility }
    }

    /// The beam of a wing as drawn, in `count` slices.
    pub fn of_wing(wing: &Wing, count: usize) -> Self {
        let stations = &wing.stations;
        let stiffness =
            |y_m: f64| [stations.at(&stations.bending_n_m2, y_m), stations.at(&stations.torsion_n_m2, y_m)];
        let axis = Axis::of(&wing.planform, stations);
        let mut beam = Self::new(axis, wing.planform.semispan_m, slices_of(wing, &axis, count), &stiffness);
        beam.extras = wing
            .lumps
            .iter()
            .map(|lump| Extra {
                y_m: lump.y_m,
                x_m: wing.planform.x_m(lump.y_m, lump.x_over_c),
                mass_kg: lump.mass_kg,
            })
            .collect();
        beam
    }

    /// Places of the slices, m.
    pub(crate) fn places(&self) -> Vec<f64> {
        self.slices.iter().map(|slice| slice.y_m).collect()
    }

    /// The slice that a place belongs to.
    fn nearest(&self, y_m: f64) -> usize {
        let width = self.end_y_m / self.slices.len().max(1) as f64;
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "not negative, and bounded"
        )]
        let place = (y_m.max(0.0) / width) as usize;
        place.min(self.slices.len().saturating_sub(1))
    }

    /// Bodies as point masses with inertia: slice, mass, how the height of the centre of gravity follows the slice's motion.
    fn bodies(&self) -> impl Iterator<Item = (usize, f64, [f64; 3], f64)> + '_ {
        let own = self.slices.iter().enumerate().map(|(place, slice)| {
            (place, slice.mass_kg, self.axis.height(slice.aft_m, 0.0), self.x_of(slice))
        });
        let extra = self.extras.iter().map(|extra| {
            let place = self.nearest(extra.y_m);
            let slice = &self.slices[place];
            let (dx, dy) = (extra.x_m - self.axis.x_m(slice.y_m), extra.y_m - slice.y_m);
            (place, extra.mass_kg, self.axis.height(dx, dy), extra.x_m)
        });
        own.chain(extra)
    }

    fn x_of(&self, slice: &Slice) -> f64 {
        self.axis.x_m(slice.y_m) + slice.aft_m
    }

    /// Mass matrix, three rows a slice.
    pub(crate) fn mass(&self) -> DMatrix<f64> {
        let count = 3 * self.slices.len();
        let mut mass = DMatrix::zeros(count, count);
        let mut add = |slice: usize, weight: f64, along: [f64; 3]| {
            for i in 0..3 {
                for j in 0..3 {
                    mass[(3 * slice + i, 3 * slice + j)] += weight * along[i] * along[j];
                }
            }
        };
        for (place, mass_kg, height, _) in self.bodies() {
            add(place, mass_kg, height);
        }
        for (place, slice) in self.slices.iter().enumerate() {
            add(place, slice.pitch_kg_m2, self.axis.pitch());
            add(place, slice.roll_kg_m2, self.axis.roll());
        }
        mass
    }

    /// What bodies weigh on the slices' motions when all are accelerated: by a unit downward pull (column 0), and by a unit
    /// nose-up pitch acceleration about `axis_x_m` (column 1, what resists it), three rows a slice.
    pub(crate) fn fields(&self, axis_x_m: f64) -> DMatrix<f64> {
        let mut fields = DMatrix::zeros(3 * self.slices.len(), 2);
        for (place, mass_kg, height, x_m) in self.bodies() {
            for (i, share) in height.iter().enumerate() {
                fields[(3 * place + i, 0)] -= mass_kg * share;
                // nose up moves what is aft down: its inertia pushes up
                fields[(3 * place + i, 1)] += mass_kg * (x_m - axis_x_m) * share;
            }
        }
        for (place, slice) in self.slices.iter().enumerate() {
            for (i, share) in self.axis.pitch().iter().enumerate() {
                fields[(3 * place + i, 1)] -= slice.pitch_kg_m2 * share;
            }
        }
        fields
    }

    /// Rows of the loads Fz, Mx, My about (`x_m`, 0) by the slices' accelerations: mass times how each moves, so that inertia
    /// puts their negative on the balance.
    pub(crate) fn balance_rows(&self, x_m: f64) -> DMatrix<f64> {
        let mut rows = DMatrix::zeros(3, 3 * self.slices.len());
        for (place, mass_kg, height, body_x_m) in self.bodies() {
            let slice_y_m = self.slices[place].y_m;
            for (i, share) in height.iter().enumerate() {
                rows[(0, 3 * place + i)] += mass_kg * share;
                rows[(1, 3 * place + i)] += mass_kg * share * slice_y_m;
                rows[(2, 3 * place + i)] -= mass_kg * share * (body_x_m - x_m);
            }
        }
        for extra in &self.extras {
            let place = self.nearest(extra.y_m);
            let dx = extra.x_m - self.axis.x_m(self.slices[place].y_m);
            let dy = extra.y_m - self.slices[place].y_m;
            for (i, share) in self.axis.height(dx, dy).iter().enumerate() {
                rows[(1, 3 * place + i)] += extra.mass_kg * share * dy;
            }
        }
        for (place, slice) in self.slices.iter().enumerate() {
            for i in 0..3 {
                rows[(1, 3 * place + i)] += slice.roll_kg_m2 * self.axis.roll()[i];
                rows[(2, 3 * place + i)] += slice.pitch_kg_m2 * self.axis.pitch()[i];
            }
        }
        rows
    }

    /// Mass times place: kg, kg m aft of `x_m`, kg m outward.
    pub(crate) fn moments(&self, x_m: f64) -> [f64; 3] {
        let mut sums = [0.0; 3];
        for (place, mass_kg, _, body_x_m) in self.bodies() {
            sums[0] += mass_kg;
            sums[1] += mass_kg * (body_x_m - x_m);
            sums[2] += mass_kg * self.slices[place].y_m;
        }
        for extra in &self.extras {
            sums[2] += extra.mass_kg * (extra.y_m - self.slices[self.nearest(extra.y_m)].y_m);
        }
        sums
    }

    /// Inertia about the axis of pitch at `x_m`, kg m².
    pub(crate) fn pitch_inertia_kg_m2(&self, x_m: f64) -> f64 {
        self.bodies().map(|(_, mass_kg, _, body_x_m)| mass_kg * (body_x_m - x_m).powi(2)).sum::<f64>()
            + self.slices.iter().map(|slice| slice.pitch_kg_m2).sum::<f64>()
    }

    /// Product of inertia of pitch and roll, kg m²: mass times aft times outward.
    pub(crate) fn product_kg_m2(&self, x_m: f64) -> f64 {
        let slices = self.slices.iter().map(|s| s.mass_kg * (self.x_of(s) - x_m) * s.y_m).sum::<f64>();
        slices + self.extras.iter().map(|e| e.mass_kg * (e.x_m - x_m) * e.y_m).sum::<f64>()
    }
}

/// Slices of a wing as drawn.
fn slices_of(wing: &Wing, axis: &Axis, count: usize) -> Vec<Slice> {
    let width_m = wing.planform.semispan_m / count as f64;
    let stations = &wing.stations;
    let slice = |place: usize| {
        let y_m = width_m * (place as f64 + 0.5);
        let mass_kg = width_m * stations.at(&stations.mass_kg_m, y_m);
        let x_m = wing.planform.x_m(y_m, stations.at(&stations.mass_x_over_c, y_m));
        Slice {
            y_m,
            mass_kg,
            aft_m: x_m - axis.x_m(y_m),
            pitch_kg_m2: width_m * stations.at(&stations.inertia_kg_m, y_m),
            roll_kg_m2: mass_kg * width_m * width_m / 12.0,
        }
    };
    (0..count).map(slice).collect()
}
