//! The flutter of a study as cards.

use super::cards::{Asked, FIRST, real};
use super::flutter::{Flutter, Method};

/// Its FLUTTER.
const FLUTTER: u32 = FIRST + 500_010;
/// Its lists of densities, Mach numbers and airspeeds (FLFACT).
const LISTS: [u32; 3] = [FIRST + 500_011, FIRST + 500_012, FIRST + 500_013];

impl Flutter {
    /// What it asks for, with the density of the deck's AERO.
    pub(super) fn asked(&self, density: f64) -> Asked {
        let mut asked = Asked::default();
        asked.control += "SUBCASE 1\n  LABEL = flutter\n";
        asked.select("  FMETHOD", FLUTTER);
        let method = match self.method {
            Method::Pk => "PK",
            Method::Pknl => "PKNL",
        };
        let head = [FLUTTER.to_string(), method.to_owned()];
        asked.add("FLUTTER", &head.into_iter().chain(LISTS.map(|id| id.to_string())).collect::<Vec<_>>());
        let (to, ratios) = self.densities.ratios();
        let ratios: Vec<f64> = ratios.iter().map(|ratio| ratio * (to / density)).collect();
        for (id, values) in LISTS.into_iter().zip([&ratios, &self.machs, &self.airspeeds]) {
            let values = values.iter().copied().map(real);
            asked.add("FLFACT", &std::iter::once(id.to_string()).chain(values).collect::<Vec<_>>());
        }
        asked
    }
}
