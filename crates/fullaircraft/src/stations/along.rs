//! Which loads of a station are looked at: those that drive structures in a gust along an axis, and the diagonals of two moments.

use crate::flight::gust::GustAxis;

/// A direction among Fx, Fy, Fz, Mx, My, Mz of a station, each over a scale of its own.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Along {
    /// In words.
    pub words: &'static str,
    /// Shares of Fx, Fy, Fz, Mx, My, Mz.
    pub shares: [f64; 6],
}

const fn one(words: &'static str, load: usize) -> Along {
    let mut shares = [0.0; 6];
    shares[load] = 1.0;
    Along { words, shares }
}

const fn two(words: &'static str, loads: [usize; 2], sign: f64) -> Along {
    let mut shares = [0.0; 6];
    shares[loads[0]] = 1.0;
    shares[loads[1]] = sign;
    Along { words, shares }
}

/// How many there are.
pub const DIRECTIONS: usize = 5;

const VERTICAL: [Along; DIRECTIONS] = [
    one("Fz", 2),
    one("Mx", 3),
    one("My", 4),
    two("Mx with My", [3, 4], 1.0),
    two("Mx against My", [3, 4], -1.0),
];

const LATERAL: [Along; DIRECTIONS] = [
    one("Fy", 1),
    one("Mx", 3),
    one("Mz", 5),
    two("Mx with Mz", [3, 5], 1.0),
    two("Mx against Mz", [3, 5], -1.0),
];

impl GustAxis {
    /// Fz, Mx, My and both diagonals of the moments; Fy, Mx, Mz in gusts from the side.
    pub fn along(self) -> [Along; DIRECTIONS] {
        match self {
            Self::Vertical => VERTICAL,
            Self::Lateral => LATERAL,
        }
    }
}
