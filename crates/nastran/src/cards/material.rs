//! Materials: MAT1, MAT2, MAT8 and MAT9. Thermal expansion, strengths and damping are skipped.

use super::prelude::*;

/// An isotropic material (MAT1).
#[derive(Debug, Clone, PartialEq)]
pub struct Mat1 {
    /// Identification number.
    pub id: u32,
    /// Young's modulus.
    pub e: f64,
    /// Shear modulus (E/2(1+nu) if the field is blank).
    pub g: f64,
    /// Poisson's ratio.
    pub nu: f64,
    /// Density.
    pub rho: f64,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Mat1 {
    numbered!();
    /// MAT1: MID E G NU RHO; of E, G and NU the empty one follows from E = 2 (1 + NU) G.
    ///
    /// If NU is empty together with E or G, both are zero, as in Nastran.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let fields = (card.optional_real(1, "E")?, card.optional_real(2, "G")?, card.optional_real(3, "NU")?);
        let (e, g, nu) = match fields {
            (Some(e), Some(g), Some(nu)) => (e, g, nu),
            (Some(e), None, Some(nu)) if nu > -1.0 => (e, e / (2.0 * (1.0 + nu)), nu),
            (None, Some(g), Some(nu)) => (2.0 * (1.0 + nu) * g, g, nu),
            (Some(e), Some(g), None) if g > 0.0 => (e, g, e / (2.0 * g) - 1.0),
            (Some(e), Some(g), None) => (e, g, 0.0),
            (Some(e), None, None) => (e, 0.0, 0.0),
            (None, Some(g), None) => (0.0, g, 0.0),
            (Some(_), None, Some(_)) => return Err(card.wrong(3, "NU", "above -1")),
            (None, None, _) => {
                return Err(card.empty(1, "E", "Young's modulus, or the shear modulus in field G"));
            }
        };
        Ok(vec![Mat1 {
            id: card.id(0, "MID")?,
            e,
            g,
            nu,
            rho: card.real_or(4, "RHO", 0.0)?,
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.int(self.id).reals(&[self.e, self.g, self.nu, self.rho])
    }

    raises!(cards: id);

    own_image!();
}

/// An anisotropic plane material (MAT2).
#[derive(Debug, Clone, PartialEq)]
pub struct Mat2 {
    /// Identification number.
    pub id: u32,
    /// G11, G12, G13, G22, G23, G33.
    pub g: [f64; 6],
    /// Density.
    pub rho: f64,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Mat2 {
    numbered!();
    /// MAT2: MID G11 G12 G13 G22 G23 G33 RHO.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let mut g = [0.0; 6];
        for (index, name) in ["G11", "G12", "G13", "G22", "G23", "G33"].into_iter().enumerate() {
            g[index] = card.real_or(1 + index, name, 0.0)?;
        }
        let rho = card.not_negative(7, "RHO", 0.0)?;
        Ok(vec![Mat2 { id: card.id(0, "MID")?, g, rho, span: card.span.clone() }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.int(self.id).reals(&self.g).real(self.rho)
    }

    raises!(cards: id);

    /// G13 and G23 join shear with stretching.
    fn mirrored(mut self, _: &Mirror) -> Mirrored<Self> {
        for at in [2, 4] {
            self.g[at] = minus(self.g[at]);
        }
        Ok(Some(self))
    }
}

/// An orthotropic plane material (MAT8).
#[derive(Debug, Clone, PartialEq)]
pub struct Mat8 {
    /// Identification number.
    pub id: u32,
    /// E1, along the fibres.
    pub e1: f64,
    /// E2, across.
    pub e2: f64,
    /// NU12.
    pub nu12: f64,
    /// G12.
    pub g12: f64,
    /// G1Z; none or zero means no shear flexibility in that plane.
    pub g1z: f64,
    /// G2Z.
    pub g2z: f64,
    /// Density.
    pub rho: f64,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Mat8 {
    numbered!();
    /// MAT8: MID E1 E2 NU12 G12 G1Z G2Z RHO.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
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
        Ok(vec![material])
    }

    fn write(&self, card: Fields) -> Fields {
        let card = card.int(self.id).reals(&[self.e1, self.e2, self.nu12, self.g12]);
        card.reals(&[self.g1z, self.g2z, self.rho])
    }

    raises!(cards: id);

    own_image!();
}

/// An anisotropic solid material (MAT9), stresses x, y, z, xy, yz, zx.
#[derive(Debug, Clone, PartialEq)]
pub struct Mat9 {
    /// Identification number.
    pub id: u32,
    /// The upper triangle of the 6 x 6 matrix, row by row: G11, G12, ... G16, G22, ... G66.
    pub g: [f64; 21],
    /// Density.
    pub rho: f64,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Mat9 {
    numbered!();
    /// MAT9: MID G11 G12 ... G16 G22 / ... G66 RHO, the upper triangle row by row.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let mut g = [0.0; 21];
        let mut index = 0;
        for row in 1..=6 {
            for column in row..=6 {
                g[index] = card.real_or(1 + index, &format!("G{row}{column}"), 0.0)?;
                index += 1;
            }
        }
        let rho = card.not_negative(22, "RHO", 0.0)?;
        Ok(vec![Mat9 { id: card.id(0, "MID")?, g, rho, span: card.span.clone() }])
    }

    fn write(&self, card: Fields) -> Fields {
        card.int(self.id).reals(&self.g).real(self.rho)
    }

    raises!(cards: id);

    /// The upper triangle row by row; xy and yz (3 and 4) change their sign.
    fn mirrored(mut self, _: &Mirror) -> Mirrored<Self> {
        let odd = |at: usize| at == 3 || at == 4;
        let places = (0..6).flat_map(|row| (row..6).map(move |column| (row, column)));
        for (value, (row, column)) in self.g.iter_mut().zip(places) {
            if odd(row) != odd(column) {
                *value = minus(*value);
            }
        }
        Ok(Some(self))
    }
}
