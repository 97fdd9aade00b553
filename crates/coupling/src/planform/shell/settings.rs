//! The shell-and-solid wing as its file describes it.

use crate::planform::PointMass;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Laminates on the contour, foam inside, masses, and how it is held.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ShellSolid {
    /// How fine the mesh is.
    #[serde(default)]
    pub mesh: MeshSettings,
    /// Where on the chord the axis is that boxes follow; plies' angles are measured from it.
    pub elastic_axis_over_c: f64,
    /// The plies' materials.
    pub materials: Vec<PlyMaterial>,
    /// The core.
    pub foam: Foam,
    /// The plies, outermost first.
    pub plies: Vec<PlySettings>,
    /// Shear webs from root to tip, each at the chord line next to this place on the chord.
    #[serde(default)]
    pub webs_over_c: Vec<f64>,
    /// Paint and filler on the outer surface, kg/m², no stiffness.
    #[serde(default)]
    pub finish_kg_m2: f64,
    /// Masses along the whole span, such as cables.
    #[serde(default)]
    pub line_masses: Vec<LineMass>,
    /// Masses tied to the skin around them.
    #[serde(default)]
    pub point_masses: Vec<PointMass>,
    /// Accelerometers with their masses, tied like point masses; each has its own grid to be read at.
    #[serde(default)]
    pub sensors: Vec<PointMass>,
    /// Stiffness of the balance along and about x, y, z: N/m and N m/rad.
    #[serde(default = "stiff")]
    pub balance_stiffness: (f64, f64, f64, f64, f64, f64),
}

/// How fine the mesh is.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct MeshSettings {
    /// Elements along the span in each strip of boxes.
    pub spanwise_per_strip: usize,
    /// Elements along the chord in each box.
    pub chordwise_per_box: usize,
    /// Solids from the lower to the upper surface.
    pub thickness: usize,
    /// Places on the chord of the first and the last chord line, which close the section in front and behind: on
    /// the sharp edges themselves a solid would have no height.
    pub edges_over_c: (f64, f64),
}

impl Default for MeshSettings {
    fn default() -> Self {
        Self { spanwise_per_strip: 1, chordwise_per_box: 1, thickness: 3, edges_over_c: (0.01, 0.97) }
    }
}

/// A ply's material, orthotropic in its plane (MAT8).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlyMaterial {
    /// Its name, unique in the wing.
    pub name: String,
    /// Young's modulus along the fibres.
    pub e1_pa: f64,
    /// Young's modulus across.
    pub e2_pa: f64,
    /// Contraction across under stress along.
    pub nu12: f64,
    /// Shear modulus in the plane; also taken for shear through the thickness.
    pub g12_pa: f64,
    /// Density.
    pub rho_kg_m3: f64,
}

/// The core's material, isotropic (MAT1).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Foam {
    /// Young's modulus.
    pub e_pa: f64,
    /// Poisson's ratio.
    pub nu: f64,
    /// Density.
    pub rho_kg_m3: f64,
}

/// One ply on one or several surfaces.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PlySettings {
    /// Name of its material.
    pub material: String,
    /// The surfaces it lies on.
    pub on: Vec<Surface>,
    /// Thickness over the span; zero where the ply ends.
    pub thickness_m: Profile,
    /// Angle of its fibres from the elastic axis, about the outward normal.
    #[serde(default)]
    pub angle_deg: f64,
    /// A strip of the chord it is limited to; left out: the whole surface. For `Upper` and `Lower` only.
    #[serde(default)]
    pub band: Option<Band>,
}

/// A strip along the span, such as a spar cap.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Band {
    /// Its middle on the chord.
    pub centre_over_c: f64,
    /// Its width along the chord, over the span.
    pub width_m: Profile,
}

/// A surface made of shells.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub enum Surface {
    /// Upper skin.
    Upper,
    /// Lower skin.
    Lower,
    /// The face that closes the section in front, which stands for the nose.
    LeadingEdge,
    /// The face that closes the section behind, which stands for the trailing edge.
    TrailingEdge,
    /// The shear webs.
    Webs,
    /// The rib at the root, which the balance or the fuselage holds.
    RootRib,
    /// The rib at the tip.
    TipRib,
}

/// A mass spread evenly over the span.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LineMass {
    /// Its name.
    pub name: String,
    /// Place on the chord, 0 at the leading edge.
    pub x_over_c: f64,
    /// Mass per unit of y.
    pub mass_kg_m: f64,
}

/// Values over the span station: (`y_m`, value) pairs in ascending y, straight lines between, constant beyond.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(transparent)]
pub struct Profile(pub Vec<(f64, f64)>);

impl Profile {
    /// The value at a span station; zero if there are no pairs.
    pub fn at(&self, y_m: f64) -> f64 {
        let after = self.0.partition_point(|pair| pair.0 <= y_m);
        match (after.checked_sub(1).and_then(|before| self.0.get(before)), self.0.get(after)) {
            (Some(a), Some(b)) => a.1 + (b.1 - a.1) * (y_m - a.0) / (b.0 - a.0),
            (Some(end), None) | (None, Some(end)) => end.1,
            (None, None) => 0.0,
        }
    }
}

/// So stiff that the wing is clamped to within a thousandth of its own flexibility.
fn stiff() -> (f64, f64, f64, f64, f64, f64) {
    (1e8, 1e8, 1e8, 1e7, 1e7, 1e7)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_balance_that_nobody_described_holds_the_wing_in_all_six_motions() {
        let (x, y, z, roll, pitch, yaw) = stiff();
        // A wing of 10 kN m2 and a metre gives way by 3e4 N/m and 1e4 N m/rad: the balance shall be a hundred times as stiff and more.
        assert!([x, y, z].iter().all(|force| *force >= 3e6), "forces: {x}, {y}, {z} N/m");
        assert!(
            [roll, pitch, yaw].iter().all(|moment| *moment >= 1e6),
            "moments: {roll}, {pitch}, {yaw} N m/rad"
        );
    }
}
