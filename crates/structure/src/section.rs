//! A beam's section at any place along the element, from the stations of its property card.
//!
//! Between two stations every quantity is linear in x/L; shear factors are constant; the offsets of the neutral
//! axis and of the non-structural mass run linearly from end A to end B.

use nalgebra::{Matrix6, Vector2};
use nastran::{BeamProperty, BeamStation, InputError, Mat1};

/// Points and weights of the six-point Gauss rule on 0 to 1: exact for the mass (degree seven), and within 1e-6 for the
/// rational flexibility of a beam that tapers to a quarter of its stiffness.
const GAUSS: [(f64, f64); 6] = [
    (0.033_765_242_898_423_98, 0.085_662_246_189_585_18),
    (0.169_395_306_766_867_73, 0.180_380_786_524_069_3),
    (0.380_690_406_958_401_56, 0.233_956_967_286_345_52),
    (0.619_309_593_041_598_4, 0.233_956_967_286_345_52),
    (0.830_604_693_233_132_3, 0.180_380_786_524_069_3),
    (0.966_234_757_101_576, 0.085_662_246_189_585_18),
];

type Column = fn(&BeamStation) -> f64;

/// Six Gauss points and their weights from one place to another.
pub(crate) fn gauss([from, to]: [f64; 2]) -> [(f64, f64); 6] {
    GAUSS.map(|(x, weight)| (from + x * (to - from), weight * (to - from)))
}

/// A section with its material.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Section<'a> {
    pub(crate) property: &'a BeamProperty,
    pub(crate) material: &'a Mat1,
}

impl Section<'_> {
    /// The cross section at `x` = x/L, all fields linear between stations, constant outside them.
    pub(crate) fn at(&self, x: f64) -> BeamStation {
        let stations = &self.property.stations;
        let after = stations.iter().position(|station| station.x_over_l >= x).unwrap_or(stations.len());
        if after == 0 || after == stations.len() {
            return stations[after.min(stations.len() - 1)];
        }
        let (a, b) = (&stations[after - 1], &stations[after]);
        let t = (x - a.x_over_l) / (b.x_over_l - a.x_over_l);
        let mix = |a: f64, b: f64| a + t * (b - a);
        BeamStation {
            x_over_l: x,
            area: mix(a.area, b.area),
            i1: mix(a.i1, b.i1),
            i2: mix(a.i2, b.i2),
            i12: mix(a.i12, b.i12),
            j: mix(a.j, b.j),
            nsm: mix(a.nsm, b.nsm),
        }
    }

    /// Integration points x/L and weights over the element: six Gauss points between each two stations.
    pub(crate) fn quadrature(&self) -> Vec<(f64, f64)> {
        self.quadrature_between(&[])
    }

    /// The same, for what has kinks at further places x/L.
    pub(crate) fn quadrature_between(&self, kinks: &[f64]) -> Vec<(f64, f64)> {
        let mut ends: Vec<f64> =
            self.property.stations.iter().map(|s| s.x_over_l).chain([0.0, 1.0]).collect();
        ends.extend(kinks);
        ends.retain(|x| (0.0..=1.0).contains(x));
        ends.sort_by(f64::total_cmp);
        ends.dedup();
        ends.windows(2).flat_map(|w| gauss([w[0], w[1]])).collect()
    }

    /// Where the neutral axis stands from the shear centre (y, z) at `x`.
    pub(crate) fn neutral_axis(&self, x: f64) -> Vector2<f64> {
        between(&self.property.neutral_axis, x)
    }

    /// Where the non-structural mass stands from the shear centre (y, z) at `x`.
    pub(crate) fn nsm_offset(&self, x: f64) -> Vector2<f64> {
        between(&self.property.nsm_offset, x)
    }

    /// Non-structural mass moment of inertia per length at `x`.
    pub(crate) fn nsi(&self, x: f64) -> f64 {
        let [a, b] = self.property.nsi;
        a + x * (b - a)
    }

    /// Flexibility of a unit length: strains from the section forces (N, Vy, Vz, T, My, Mz), bending about the
    /// neutral axis. Components without stiffness get no flexibility: [`Section::carried`] leaves them out.
    pub(crate) fn flexibility(&self, x: f64) -> Matrix6<f64> {
        let s = self.at(x);
        let (e, g) = (self.material.e, self.material.g);
        let [k1, k2] = self.property.shear_factors;
        let over = |stiffness: f64| if stiffness > 0.0 { 1.0 / stiffness } else { 0.0 };
        let mut f = Matrix6::zeros();
        f[(0, 0)] = over(e * s.area);
        f[(1, 1)] = over(k1 * s.area * g);
        f[(2, 2)] = over(k2 * s.area * g);
        f[(3, 3)] = over(g * s.j);
        if s.i12 == 0.0 {
            f[(4, 4)] = over(e * s.i2);
            f[(5, 5)] = over(e * s.i1);
        } else {
            let determinant = e * (s.i1 * s.i2 - s.i12 * s.i12);
            f[(4, 4)] = s.i1 / determinant;
            f[(5, 5)] = s.i2 / determinant;
            f[(4, 5)] = s.i12 / determinant;
            f[(5, 4)] = s.i12 / determinant;
        }
        f
    }

    /// Which of the six end forces (N, Vy, Vz, T, My, Mz) the section carries: a zero area, I or J carries none, nor does J without G.
    pub(crate) fn carried(&self) -> [bool; 6] {
        let s = &self.property.stations[0];
        let (axial, plane_1, plane_2) = (s.area > 0.0, s.i1 > 0.0, s.i2 > 0.0);
        [axial, plane_1, plane_2, s.j > 0.0 && self.material.g > 0.0, plane_2, plane_1]
    }

    /// Refuses what no section can be.
    pub(crate) fn check(&self) -> Result<(), InputError> {
        let (p, m) = (self.property, self.material);
        let bad = |what: &str| {
            let message = format!("beam property {}: {what}", p.id);
            Err(InputError::at(&p.span, message)
                .with_help("areas and moments of inertia are zero or positive"))
        };
        if p.stations.is_empty() {
            return bad("it has no station");
        }
        if !p.stations.windows(2).all(|w| w[0].x_over_l < w[1].x_over_l) {
            return bad("its stations are not in ascending x/L");
        }
        let columns: [(&str, Column); 4] =
            [("A", |s| s.area), ("I1", |s| s.i1), ("I2", |s| s.i2), ("J", |s| s.j)];
        for (name, value) in columns {
            if !p.stations.iter().all(|s| value(s) >= 0.0 && value(s).is_finite()) {
                return bad(&format!("{name} is negative"));
            }
            let zeros = p.stations.iter().filter(|s| value(s) == 0.0).count();
            if zeros != 0 && zeros != p.stations.len() {
                return bad(&format!("{name} is zero at one station and positive at another"));
            }
        }
        if p.stations.iter().any(|s| s.i12 != 0.0 && s.i1 * s.i2 <= s.i12 * s.i12) {
            return bad("I1 I2 is not greater than I12 squared");
        }
        if p.shear_factors.iter().any(|k| *k < 0.0) {
            return bad("a shear factor is negative");
        }
        let needs_e = p.stations.iter().any(|s| s.area > 0.0 || s.i1 > 0.0 || s.i2 > 0.0);
        if (needs_e && m.e <= 0.0) || m.g < 0.0 || m.rho < 0.0 {
            let message = format!("material {} has E = {}, G = {}, rho = {}", m.id, m.e, m.g, m.rho);
            let help = "the beams that use it need a positive E, and G and a density of zero or more";
            return Err(InputError::at(&m.span, message).with_help(help));
        }
        Ok(())
    }

    /// Refuses a material without G (MAT1 with E alone), with which Nastran's beams neither twist stiffly nor shear.
    pub(crate) fn check_shear(&self) -> Result<(), InputError> {
        let (p, m) = (self.property, self.material);
        let needs_g = p.stations.iter().any(|s| s.j > 0.0) || p.shear_factors.iter().any(|k| *k > 0.0);
        if needs_g && m.g <= 0.0 {
            let message = format!(
                "material {} has G = {}, and beam property {} has J or a shear factor",
                m.id, m.g, p.id
            );
            return Err(InputError::at(&m.span, message).with_help("give G or NU beside E"));
        }
        Ok(())
    }
}

fn between(ends: &[[f64; 2]; 2], x: f64) -> Vector2<f64> {
    Vector2::from(ends[0]) * (1.0 - x) + Vector2::from(ends[1]) * x
}

#[cfg(test)]
mod tests;
