//! Which plies lie where.

use super::settings::{Band, PlyMaterial, PlySettings, ShellSolid, Surface};
use crate::planform::Planform;
use crate::planform::panels::card_number;
use nastran::Ply;

/// MAT8 numbers; 1 is the core's MAT1.
pub(super) const FIRST_PLY_MATERIAL: u32 = 2;

/// The plies of a wing, looked up by place.
#[derive(Debug, Clone, Copy)]
pub(super) struct Layup<'wing> {
    pub(super) settings: &'wing ShellSolid,
    pub(super) planform: &'wing Planform,
}

impl Layup<'_> {
    /// Plies from the inside out; bands only where a cell of the chord is given.
    pub(super) fn plies(self, surface: Surface, y_m: f64, cell: Option<[f64; 2]>) -> Vec<Ply> {
        let chord_m = self.planform.chord_m(y_m);
        let ply = |ply: &PlySettings| {
            let share = match (&ply.band, cell) {
                (None, _) => 1.0,
                (Some(band), Some(cell)) => band.share_of(cell, y_m, chord_m),
                (Some(_), None) => 0.0,
            };
            let thickness = ply.thickness_m.at(y_m) * share;
            let material = self.settings.material_number(&ply.material);
            (thickness > 0.0).then_some(Ply {
                material,
                thickness,
                angle_deg: ply.angle_deg,
                global_id: None,
            })
        };
        self.settings.plies.iter().rev().filter(|ply| ply.on.contains(&surface)).filter_map(ply).collect()
    }

    /// A ply's material.
    pub(super) fn material(&self, ply: &Ply) -> Option<&PlyMaterial> {
        self.settings.materials.get(ply.material.checked_sub(FIRST_PLY_MATERIAL)? as usize)
    }

    pub(super) fn mass_kg_m2(self, plies: &[Ply]) -> f64 {
        plies
            .iter()
            .map(|ply| ply.thickness * self.material(ply).map_or(0.0, |material| material.rho_kg_m3))
            .sum()
    }
}

impl Band {
    /// Share of a chord cell that the band covers.
    fn share_of(&self, cell: [f64; 2], y_m: f64, chord_m: f64) -> f64 {
        let half = 0.5 * self.width_m.at(y_m) / chord_m;
        let overlap = cell[1].min(self.centre_over_c + half) - cell[0].max(self.centre_over_c - half);
        overlap.max(0.0) / (cell[1] - cell[0])
    }
}

impl ShellSolid {
    /// MAT8 number of a material; names are checked before.
    pub(super) fn material_number(&self, name: &str) -> u32 {
        let place = self.materials.iter().position(|material| material.name == name).unwrap_or(0);
        FIRST_PLY_MATERIAL + card_number(place)
    }
}
