//! The wing's structure: beams along the elastic axis, masses lumped at its grids.
//!
//! The distribution gives, over y: bending and torsional stiffness about the elastic axis itself (so an element
//! is as long as the swept axis), mass and pitch inertia per unit of y (the inertia about the section's centre of
//! gravity and the y axis), and where elastic axis and centre of gravity lie on the chord. Elements have the
//! stiffness of their middle; a grid carries the mass of the span half way to its neighbours.

use super::cards::{self, SlenderSection};
use super::distribution::{Distribution, Section};
use super::panels::card_number;
use super::{
    AXIS_SET, FIRST_AXIS_GRID, FIRST_MASS_GRID, FIRST_SENSOR_GRID, Mount, Planform, PointMass, ROOT_SET,
};
use nalgebra::{Point3, Vector3};
use nastran::{BulkData, Conm2, InputError, Set1, Span, Spc1};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::Path;

/// First beam element; its property has the same number.
const FIRST_BEAM: u32 = 2001;
/// The one material. Its moduli are those of a glass skin; sections are made so that EI and GJ come out exactly,
/// so their choice has no effect on any result.
const MATERIAL: u32 = 1;
const E_PA: f64 = 17e9;
const G_PA: f64 = 6e9;

/// A beam along the elastic axis.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BeamStructure {
    /// Elements from root to tip, equally wide in y.
    pub elements: usize,
    /// CSV file of stiffness and mass over the span, relative to the wing file.
    pub distribution: String,
    /// Masses beside the distributed one, tied rigidly to the nearest grid of the axis.
    #[serde(default)]
    pub point_masses: Vec<PointMass>,
    /// Accelerometers with their masses, tied like point masses; each has its own grid to be read at.
    #[serde(default)]
    pub sensors: Vec<PointMass>,
}

/// The axis while cards are made of it.
struct Axis<'wing> {
    planform: &'wing Planform,
    distribution: Distribution,
    /// Span stations of the grids.
    y_m: Vec<f64>,
    span: Span,
}

impl BeamStructure {
    pub(super) fn add_to(
        &self,
        bulk: &mut BulkData,
        planform: &Planform,
        folder: &Path,
        mount: Mount,
    ) -> Result<(), InputError> {
        let file = folder.join(&self.distribution);
        let distribution = Distribution::read(&file, planform.semispan_m)?;
        let width_m = planform.semispan_m / self.elements as f64;
        let y_m = (0..=self.elements).map(|node| node as f64 * width_m).collect();
        // Cards made from the table point at it, which is where an unusable value can be changed.
        let axis = Axis { planform, distribution, y_m, span: Span::whole_file(&file) };
        axis.add_beams(bulk);
        axis.add_distributed_masses(bulk, width_m);
        for (first, items) in [(FIRST_MASS_GRID, &self.point_masses), (FIRST_SENSOR_GRID, &self.sensors)] {
            for (id, item) in (first..).zip(items) {
                axis.add_point_mass(bulk, id, item);
            }
        }
        axis.add_sets(bulk, mount);
        Ok(())
    }
}

impl Axis<'_> {
    fn grid_id(node: usize) -> u32 {
        FIRST_AXIS_GRID + card_number(node)
    }

    fn point(&self, y_m: f64) -> Point3<f64> {
        self.planform.point(y_m, self.distribution.at(y_m).elastic_axis)
    }

    /// Grids, CBEAM, PBEAM and MAT1. The orientation vector is z, so plane 1 is vertical and I1 bends in flap.
    fn add_beams(&self, bulk: &mut BulkData) {
        let span = &self.span;
        for (node, &y_m) in self.y_m.iter().enumerate() {
            cards::add_grid(bulk, Self::grid_id(node), &self.point(y_m), span);
        }
        for (element, ends) in self.y_m.windows(2).enumerate() {
            let id = FIRST_BEAM + card_number(element);
            let middle_m = 0.5 * (ends[0] + ends[1]);
            let section = self.distribution.at(middle_m).slender(self.planform.chord_m(middle_m));
            let grids = [Self::grid_id(element), Self::grid_id(element + 1)];
            cards::add_beam(bulk, id, id, grids, Vector3::z(), span);
            cards::add_section(bulk, id, MATERIAL, section, span);
        }
        cards::add_material(bulk, MATERIAL, E_PA, G_PA, span);
    }

    fn add_distributed_masses(&self, bulk: &mut BulkData, width_m: f64) {
        for (node, &y_m) in self.y_m.iter().enumerate() {
            let low_m = (y_m - 0.5 * width_m).max(0.0);
            let high_m = (y_m + 0.5 * width_m).min(self.planform.semispan_m);
            let mass_kg = self.integral(low_m, y_m, high_m, |section, _| section.mass_kg_m);
            if mass_kg == 0.0 {
                continue;
            }
            let centre_y_m = self.integral(low_m, y_m, high_m, |section, y| section.mass_kg_m * y) / mass_kg;
            let pitch = self.integral(low_m, y_m, high_m, |section, _| section.inertia_kg_m);
            // A thin section turns about z as heavily as about y; to both comes the slab's own width.
            let slab = mass_kg * (high_m - low_m).powi(2) / 12.0;
            let centre = self.planform.point(centre_y_m, self.distribution.at(centre_y_m).centre_of_gravity);
            let offset = centre - self.point(y_m);
            let id = Self::grid_id(node);
            let mass = Conm2 {
                id,
                grid: id,
                cid: 0,
                mass: mass_kg,
                offset,
                inertia: [slab, 0.0, pitch, 0.0, 0.0, pitch + slab],
                span: self.span.clone(),
            };
            bulk.masses.insert(id, mass);
        }
    }

    /// Simpson's rule on both sides of a grid: exact for a table whose rows fall on grids or half way between.
    fn integral(&self, low_m: f64, y_m: f64, high_m: f64, of: impl Fn(&Section, f64) -> f64) -> f64 {
        let at = |y: f64| of(&self.distribution.at(y), y);
        let simpson = |a: f64, b: f64| (b - a) / 6.0 * (at(a) + 4.0 * at(0.5 * (a + b)) + at(b));
        simpson(low_m, y_m) + simpson(y_m, high_m)
    }

    fn add_point_mass(&self, bulk: &mut BulkData, id: u32, item: &PointMass) {
        let distance = |node: &usize| (self.y_m[*node] - item.y_m).abs();
        let nearest = (0..self.y_m.len()).min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap_or(0);
        let span = &self.span;
        cards::add_grid(bulk, id, &self.planform.point(item.y_m, item.x_over_c), span);
        cards::add_tie(bulk, id, Self::grid_id(nearest), vec![id], span);
        cards::add_mass(bulk, id, id, item.mass_kg, span);
    }

    fn add_sets(&self, bulk: &mut BulkData, mount: Mount) {
        let ids = (0..self.y_m.len()).map(Self::grid_id).collect();
        bulk.sets.insert(AXIS_SET, Set1 { id: AXIS_SET, ids, span: self.span.clone() });
        let root = vec![FIRST_AXIS_GRID];
        bulk.sets.insert(ROOT_SET, Set1 { id: ROOT_SET, ids: root.clone(), span: self.span.clone() });
        if mount == Mount::Tunnel {
            let components = vec![1, 2, 3, 4, 5, 6];
            bulk.constraints.push(Spc1 {
                set: 1,
                components,
                grids: root,
                enforced: 0.0,
                span: self.span.clone(),
            });
        }
    }
}

impl Section {
    /// The axial stiffness is not in the table: taken as if the lag stiffness were spread evenly over the chord,
    /// EA = 12 EI/c^2 with the lag stiffness EI. It puts axial modes far above all others.
    fn slender(&self, chord_m: f64) -> SlenderSection {
        SlenderSection {
            area: 12.0 * self.ei_lag_nm2 / chord_m.powi(2) / E_PA,
            i1: self.ei_flap_nm2 / E_PA,
            i2: self.ei_lag_nm2 / E_PA,
            j: self.gj_nm2 / G_PA,
        }
    }
}
