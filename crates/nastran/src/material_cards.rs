//! Anisotropic materials: MAT2, MAT8 and MAT9, from fields to the structs of [`crate::fe_cards`].
//!
//! Thermal expansion, strengths and damping are skipped.

use crate::card::Card;
use crate::fe_cards::{Mat2, Mat8, Mat9};
use crate::source::InputError;

/// MAT2: MID G11 G12 G13 G22 G23 G33 RHO.
pub(crate) fn mat2(card: &Card) -> Result<Mat2, InputError> {
    let mut g = [0.0; 6];
    for (index, name) in ["G11", "G12", "G13", "G22", "G23", "G33"].into_iter().enumerate() {
        g[index] = card.real_or(1 + index, name, 0.0)?;
    }
    let rho = card.not_negative(7, "RHO", 0.0)?;
    Ok(Mat2 { id: card.id(0, "MID")?, g, rho, span: card.span.clone() })
}

/// MAT8: MID E1 E2 NU12 G12 G1Z G2Z RHO.
pub(crate) fn mat8(card: &Card) -> Result<Mat8, InputError> {
    let material = Mat8 {
        id: card.id(0, "MID")?,
        e1: card.positive(1, "E1")?,
        e2: card.positive(2, "E2")?,
        nu12: card.real_or(3, "NU12", 0.0)?,
        g12: card.not_negative(4, "G12", 0.0)?,
        g1z: card.not_negative(5, "G1Z", 0.0)?,
        g2z: card.not_negative(6, "G2Z", 0.0)?,
        rho: card.not_negative(7, "RHO", 0.0)?,
        span: card.span.clone(),
    };
    // The stiffness of a ply is positive only if 1 - nu12 nu21 is, with nu21 = nu12 E2/E1.
    if material.nu12 * material.nu12 * material.e2 >= material.e1 {
        return Err(card.wrong(3, "NU12", "small enough: NU12^2 must be below E1/E2"));
    }
    Ok(material)
}

/// MAT9: MID G11 G12 ... G16 G22 / ... G66 RHO, the upper triangle row by row.
pub(crate) fn mat9(card: &Card) -> Result<Mat9, InputError> {
    let mut g = [0.0; 21];
    let mut index = 0;
    for row in 1..=6 {
        for column in row..=6 {
            g[index] = card.real_or(1 + index, &format!("G{row}{column}"), 0.0)?;
            index += 1;
        }
    }
    let rho = card.not_negative(22, "RHO", 0.0)?;
    Ok(Mat9 { id: card.id(0, "MID")?, g, rho, span: card.span.clone() })
}
