//! Sections made of areas, each of its own material: PBCOMP, as the PBEAM it amounts to.
//!
//! With C_i the share of the area A that stands at (y_i, z_i), E_i, G_i and rho_i of its material, E and G of the section's own (MSC Nastran
//! Quick Reference Guide, PBCOMP, remark 7):
//!
//! ```text
//! A' = A sum C_i E_i/E,   (y, z)_na = sum C_i E_i (y_i, z_i) / sum C_i E_i,   J' = J sum C_i G_i/G,
//! I1 = A sum C_i (E_i/E) (y_i - y_na)²,   I2 with z,   I12 with (y_i - y_na)(z_i - z_na)
//! ```
//! The guide says nothing of mass: it is A sum C_i rho_i here, at its own centre, and NSM.

use super::prelude::*;
use super::{BeamProperty, BeamStation, Mat1};
use crate::card::FIELDS_PER_LINE;
use nalgebra::Vector2;
use std::collections::BTreeMap;

/// How far the shares of the area may be from one in all.
const ROUNDED: f64 = 1e-3;

/// An area of a section.
#[derive(Debug, Clone, PartialEq)]
struct LumpedArea {
    /// y, z in the element's axes.
    at: Vector2<f64>,
    /// Share of the section's area.
    share: f64,
    /// MAT1; none is the section's own.
    material: Option<u32>,
}

/// The areas of one PBCOMP, those that its symmetry adds included.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct LumpedAreas {
    property: u32,
    areas: Vec<LumpedArea>,
    span: Span,
}

impl LumpedAreas {
    /// The third and further lines of a PBCOMP: Y Z C MID; nothing if it has no areas.
    ///
    /// # Errors
    /// If a field is wrong, or the shares are not one in all.
    pub(crate) fn read(card: &Card) -> Result<Option<Self>, InputError> {
        let symmetry = card.count_or(FIELDS_PER_LINE + 6, "SYMOPT", 0)?;
        // The signs of y and z of the images; about the axis y, z changes its sign.
        let signs: &[[f64; 2]] = match symmetry {
            0 | 5 => &[[1.0, 1.0]],
            1 => &[[1.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]],
            2 => &[[1.0, 1.0], [1.0, -1.0]],
            3 => &[[1.0, 1.0], [-1.0, 1.0]],
            4 => &[[1.0, 1.0], [-1.0, -1.0]],
            _ => return Err(card.wrong(FIELDS_PER_LINE + 6, "SYMOPT", "from 0 to 5")),
        };
        let mut areas = Vec::new();
        for line in (2 * FIELDS_PER_LINE..card.len()).step_by(FIELDS_PER_LINE) {
            let (y, z) = (card.real_or(line, "Y", 0.0)?, card.real_or(line + 1, "Z", 0.0)?);
            let (share, material) =
                (card.not_negative(line + 2, "C", 0.0)?, card.optional_id(line + 3, "MID")?);
            // Places without an area are where stresses are printed.
            if share > 0.0 {
                let at = |[of_y, of_z]: &[f64; 2]| Vector2::new(of_y * y, of_z * z);
                areas.extend(signs.iter().map(|sign| LumpedArea { at: at(sign), share, material }));
            }
        }
        let sum: f64 = areas.iter().map(|area| area.share).sum();
        if areas.is_empty() {
            return Ok(None);
        }
        if (sum - 1.0).abs() > ROUNDED {
            let message = format!(
                "the areas of PBCOMP {}, with those that SYMOPT {symmetry} adds, are {sum} of the section's in all, not one",
                card.text(0)
            );
            return Err(card
                .error(2 * FIELDS_PER_LINE + 2, message)
                .with_help("look at the shares C and at SYMOPT"));
        }
        Ok(Some(Self { property: card.id(0, "PID")?, areas, span: card.span.clone() }))
    }

    /// Puts what the areas amount to into their section.
    ///
    /// # Errors
    /// If a material is not there or has no stiffness.
    pub(crate) fn settle(
        &self,
        sections: &mut BTreeMap<u32, BeamProperty>,
        materials: &BTreeMap<u32, Mat1>,
    ) -> Result<(), InputError> {
        let Some(section) = sections.get_mut(&self.property) else { return Ok(()) };
        let material = |id: u32| {
            let known = materials.get(&id).filter(|material| material.e > 0.0);
            known.ok_or_else(|| {
                let message =
                    format!("PBCOMP {} refers to MAT1 {id}, which is not there or has no E", self.property);
                InputError::at(&self.span, message).with_help("give each area a MAT1 of the deck")
            })
        };
        let own = material(section.material)?;
        let (mut stiff, mut twisting, mut mass) = (0.0, 0.0, 0.0);
        let (mut first, mut mass_moment) = (Vector2::zeros(), Vector2::zeros());
        let mut second = nalgebra::Matrix2::zeros();
        for area in &self.areas {
            let of = material(area.material.unwrap_or(section.material))?;
            let weight = area.share * of.e / own.e;
            stiff += weight;
            twisting += area.share * if own.g > 0.0 { of.g / own.g } else { 1.0 };
            first += area.at * weight;
            second += area.at * area.at.transpose() * weight;
            mass += area.share * of.rho;
            mass_moment += area.at * (area.share * of.rho);
        }
        let neutral = first / stiff;
        let about = second - neutral * neutral.transpose() * stiff;
        let Some(BeamStation { area, j, nsm, .. }) = section.stations.first().copied() else { return Ok(()) };
        // A beam's own mass is rho A' on its neutral axis: the rest goes where the first moment of the whole wants it.
        let rest = area * mass - own.rho * area * stiff;
        let rest_moment = mass_moment * area - neutral * (own.rho * area * stiff);
        let of_nsm = Vector2::from(section.nsm_offset[0]);
        let total = nsm + rest;
        let centre = if rest == 0.0 || total == 0.0 { of_nsm } else { (of_nsm * nsm + rest_moment) / total };
        for station in &mut section.stations {
            (station.area, station.j, station.nsm) = (area * stiff, j * twisting, total);
            (station.i1, station.i2) = (area * about[(0, 0)], area * about[(1, 1)]);
            station.i12 = area * about[(0, 1)];
        }
        section.neutral_axis = [neutral.into(); 2];
        section.nsm_offset = [centre.into(); 2];
        Ok(())
    }
}
