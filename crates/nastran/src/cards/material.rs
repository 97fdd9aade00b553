//! Materials: MAT1, MAT2, MAT8 and MAT9. Strengths and damping are skipped.

use super::prelude::*;

/// How a material expands when it is warmer; none by default.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Expansion {
    /// Strain per degree, in the material's axes: xx, yy, zz, xy, yz, zx (engineering shear). A plane material has xx, yy and xy.
    pub strain: [f64; 6],
    /// Temperature at which there is no strain (TREF).
    pub reference: f64,
}

impl Expansion {
    /// Of fields A... and TREF; `places` are the components that the fields are.
    fn read(card: &Card, from: usize, places: &[usize]) -> Result<Self, InputError> {
        let mut strain = [0.0; 6];
        for (at, place) in places.iter().enumerate() {
            strain[*place] = card.real_or(from + at, &format!("A{}", at + 1), 0.0)?;
        }
        Ok(Self { strain, reference: card.real_or(from + places.len(), "TREF", 0.0)? })
    }

    /// The fields, if they say something.
    fn write(&self, card: Fields, places: &[usize]) -> Fields {
        if *self == Self::default() {
            return card;
        }
        places.iter().fold(card, |card, place| card.real(self.strain[*place])).real(self.reference)
    }
}

/// Components of a plane material: xx, yy, xy.
const PLANE: [usize; 3] = [0, 1, 3];
/// Components along the two axes of a ply.
const PLY: [usize; 2] = [0, 1];
/// All components.
const SOLID: [usize; 6] = [0, 1, 2, 3, 4, 5];

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
    /// Thermal expansion.
    pub expansion: Expansion,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Mat1 {
    numbered!();
    /// MAT1: MID E G NU RHO A TREF; of E, G and NU the empty one follows from E = 2 (1 + NU) G.
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
        let along = card.real_or(5, "A", 0.0)?;
        Ok(vec![Mat1 {
            id: card.id(0, "MID")?,
            e,
            g,
            nu,
            rho: card.real_or(4, "RHO", 0.0)?,
            expansion: Expansion {
                strain: [along, along, along, 0.0, 0.0, 0.0],
                reference: card.real_or(6, "TREF", 0.0)?,
            },
            span: card.span.clone(),
        }])
    }

    fn write(&self, card: Fields) -> Fields {
        let card = card.int(self.id).reals(&[self.e, self.g, self.nu, self.rho]);
        self.expansion.write(card, &PLANE[..1])
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
    /// Thermal expansion.
    pub expansion: Expansion,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Mat2 {
    numbered!();
    /// MAT2: MID G11 G12 G13 G22 G23 G33 RHO A1 A2 A3 TREF.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let mut g = [0.0; 6];
        for (index, name) in ["G11", "G12", "G13", "G22", "G23", "G33"].into_iter().enumerate() {
            g[index] = card.real_or(1 + index, name, 0.0)?;
        }
        let rho = card.not_negative(7, "RHO", 0.0)?;
        let expansion = Expansion::read(card, 8, &PLANE)?;
        Ok(vec![Mat2 { id: card.id(0, "MID")?, g, rho, expansion, span: card.span.clone() }])
    }

    fn write(&self, card: Fields) -> Fields {
        self.expansion.write(card.int(self.id).reals(&self.g).real(self.rho), &PLANE)
    }

    raises!(cards: id);

    /// G13 and G23 join shear with stretching.
    fn mirrored(mut self, _: &Mirror) -> Mirrored<Self> {
        for at in [2, 4] {
            self.g[at] = minus(self.g[at]);
        }
        self.expansion.strain[3] = minus(self.expansion.strain[3]);
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
    /// Thermal expansion.
    pub expansion: Expansion,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Mat8 {
    numbered!();
    /// MAT8: MID E1 E2 NU12 G12 G1Z G2Z RHO A1 A2 TREF.
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
            expansion: Expansion::read(card, 8, &PLY)?,
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
        self.expansion.write(card.reals(&[self.g1z, self.g2z, self.rho]), &PLY)
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
    /// Thermal expansion.
    pub expansion: Expansion,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Mat9 {
    numbered!();
    /// MAT9: MID G11 G12 ... G16 G22 / ... G66 RHO A1 ... A6 TREF, the upper triangle row by row.
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
        let expansion = Expansion::read(card, 23, &SOLID)?;
        Ok(vec![Mat9 { id: card.id(0, "MID")?, g, rho, expansion, span: card.span.clone() }])
    }

    fn write(&self, card: Fields) -> Fields {
        self.expansion.write(card.int(self.id).reals(&self.g).real(self.rho), &SOLID)
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
        for at in [3, 4] {
            self.expansion.strain[at] = minus(self.expansion.strain[at]);
        }
        Ok(Some(self))
    }
}
