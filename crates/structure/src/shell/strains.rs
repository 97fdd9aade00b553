//! What the strains of a shell are.

/// Strains of a shell at a point, in the element's axes ([`crate::Shell::axes`]).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ShellStrains {
    /// Membrane strains at the reference surface (x, y, xy).
    pub membrane: [f64; 3],
    /// Curvatures (x, y, xy), 1/m: strains at height z are membrane + z curvature.
    pub curvature: [f64; 3],
    /// Transverse shears (xz, yz).
    pub shear: [f64; 2],
}
