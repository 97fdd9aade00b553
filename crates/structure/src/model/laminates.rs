//! Laminates: PCOMP and PCOMPG with what LAM makes of their plies (MSC Nastran Quick Reference Guide).

use super::build::Builder;
use crate::laminate::{PlacedPly, ShellSection};
use crate::plane_material::PlaneMaterial;
use nalgebra::{Matrix2, Matrix3};
use nastran::{InputError, LaminateOption, Pcomp, Ply};

/// How far Z0 may be from minus half the thickness, as a share of it, where LAM allows no other.
const MIDDLE: f64 = 1e-6;

impl Builder<'_> {
    pub(super) fn laminate(&self, card: &Pcomp) -> Result<ShellSection, InputError> {
        let placed: Vec<PlacedPly> = self.layers(card)?.into_iter().map(|(ply, _)| ply).collect();
        let placed = if card.option == LaminateOption::SmearedFaces { sandwich(&placed) } else { placed };
        let thickness_m: f64 = placed.iter().map(|ply| ply.z_high_m - ply.z_low_m).sum();
        let all = ShellSection::laminate(&placed, card.nsm, self.shear);
        let (none, rigid) = (Matrix3::zeros(), Matrix2::from_element(f64::INFINITY));
        Ok(match card.option {
            LaminateOption::All | LaminateOption::Symmetric | LaminateOption::SmearedFaces => all,
            // A membrane has no transverse stiffness at all.
            LaminateOption::Membrane => {
                ShellSection { coupling: none, bending: none, shear: Matrix2::zeros(), ..all }
            }
            LaminateOption::Bending => ShellSection { membrane: none, coupling: none, shear: rigid, ..all }
                .with_finite_shear(thickness_m),
            LaminateOption::Smeared => {
                let bending = all.membrane * (thickness_m.powi(2) / 12.0);
                ShellSection { coupling: none, bending, shear: rigid, ..all }.with_finite_shear(thickness_m)
            }
        })
    }

    /// Layers of a laminate from bottom to top, each with the number of its material; the last of a sandwich of smeared faces is its core.
    pub(super) fn layers(&self, card: &Pcomp) -> Result<Vec<(PlacedPly, u32)>, InputError> {
        let user = format!("PCOMP {}", card.id);
        let mirrored: &[Ply] = if card.option == LaminateOption::Symmetric { &card.plies } else { &[] };
        let plies: Vec<&Ply> = card.plies.iter().chain(mirrored.iter().rev()).collect();
        let total: f64 = plies.iter().map(|ply| ply.thickness).sum();
        let wrong = plies.iter().find(|ply| !(ply.thickness > 0.0 && ply.thickness.is_finite()));
        if plies.is_empty() || wrong.is_some() {
            let message = match wrong {
                Some(ply) => format!("{user} has a ply of thickness {}", ply.thickness),
                None => format!("{user} has no plies"),
            };
            return Err(InputError::at(&card.span, message).with_help("every ply has a positive thickness"));
        }
        let low = card.z0.unwrap_or(-0.5 * total);
        let is_middle = (low + 0.5 * total).abs() <= MIDDLE * total;
        if let Some(word) =
            card.option.word().filter(|_| !is_middle && card.option != LaminateOption::Symmetric)
        {
            let message = format!(
                "{user} has Z0 {low} with LAM {word}, which stands on its middle (Z0 {})",
                -0.5 * total
            );
            return Err(InputError::at(&card.span, message)
                .with_help("leave Z0 empty, and offset the elements by ZOFFS, as Nastran demands"));
        }
        if card.option == LaminateOption::SmearedFaces && plies.len() < 2 {
            let message = format!("{user} with LAM SMCORE has no faces");
            return Err(
                InputError::at(&card.span, message).with_help("list the faces' plies and, last, the core")
            );
        }
        let mut at = low;
        let mut placed = Vec::with_capacity(plies.len());
        for ply in plies {
            let material = self.plane(ply.material, &user, &card.span)?;
            let high = at + ply.thickness;
            let angle_rad = ply.angle_deg.to_radians();
            placed.push((PlacedPly { material, angle_rad, z_low_m: at, z_high_m: high }, ply.material));
            at = high;
        }
        Ok(placed)
    }
}

/// The core, which is the last ply, between two faces of half the mean of all others each.
fn sandwich(plies: &[PlacedPly]) -> Vec<PlacedPly> {
    let Some((core, faces)) = plies.split_last() else { return Vec::new() };
    let thickness = |ply: &PlacedPly| ply.z_high_m - ply.z_low_m;
    let (of_faces, of_core): (f64, f64) = (faces.iter().map(thickness).sum(), thickness(core));
    let mut mean = PlaneMaterial { stiffness: Matrix3::zeros(), shear: [0.0; 2], density: 0.0 };
    for ply in faces {
        let (share, shear) = (thickness(ply) / of_faces, ply.material.turned_shear(ply.angle_rad));
        mean.stiffness += ply.material.turned(ply.angle_rad).stiffness * share;
        mean.shear = [0, 1].map(|axis| mean.shear[axis] + share * shear[(axis, axis)]);
        mean.density += share * ply.material.density;
    }
    let half = 0.5 * of_core;
    let face = |z_low_m: f64| PlacedPly {
        material: mean,
        angle_rad: 0.0,
        z_low_m,
        z_high_m: z_low_m + 0.5 * of_faces,
    };
    vec![face(-half - 0.5 * of_faces), PlacedPly { z_low_m: -half, z_high_m: half, ..*core }, face(half)]
}
