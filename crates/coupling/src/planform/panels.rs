//! CAERO1 panels of wing and fairing, and camber and twist as the W2GJ matrix.
//!
//! W2GJ is the incidence each box has besides the angle of attack, at its 3/4 point, nose up positive:
//! `-dz/dx + twist` with dz/dx the slope of the section's camber line.

use super::{FAIRING_PANEL, Mount, Planform, WING_PANEL};
use aero::Airfoil;
use nastran::{Aefact, BulkData, Caero1, Divisions, Dmi, InputError, Paero1, Span};
use std::path::Path;

/// PAERO1 and AEFACT are numbered by what they serve; there is one of each.
const PANEL_PROPERTY: u32 = 1;
const STRIP_EDGES: u32 = 1;

impl Planform {
    pub(super) fn add_panels(
        &self,
        bulk: &mut BulkData,
        folder: &Path,
        mount: Mount,
        span: &Span,
    ) -> Result<(), InputError> {
        bulk.panel_properties.insert(PANEL_PROPERTY, Paero1 { id: PANEL_PROPERTY, span: span.clone() });
        let strips = if self.boxes.strip_edges.is_some() {
            let values = self.strip_fractions();
            bulk.factors.insert(STRIP_EDGES, Aefact { id: STRIP_EDGES, values, span: span.clone() });
            Divisions::Aefact(STRIP_EDGES)
        } else {
            Divisions::Equal(card_number(self.boxes.spanwise))
        };
        bulk.panels.insert(WING_PANEL, self.panel(WING_PANEL, strips, [0.0, self.semispan_m], span));
        let fairing = self.fairing.as_ref().filter(|_| mount == Mount::Tunnel);
        if let Some(fairing) = fairing {
            let strips = Divisions::Equal(card_number(fairing.strips));
            bulk.panels
                .insert(FAIRING_PANEL, self.panel(FAIRING_PANEL, strips, [-fairing.width_m, 0.0], span));
        }

        let slopes = self.incidence_from_camber(folder)?;
        let mut incidence = Vec::new();
        for edges in self.strip_fractions().windows(2) {
            let middle = 0.5 * (edges[0] + edges[1]);
            let twist_deg = self.twist_deg.0 + middle * (self.twist_deg.1 - self.twist_deg.0);
            incidence.extend(slopes.iter().map(|slope| slope + twist_deg.to_radians()));
        }
        if let Some(fairing) = fairing {
            let root_twist = self.twist_deg.0.to_radians();
            for _ in 0..fairing.strips {
                incidence
                    .extend(slopes.iter().map(|slope| if fairing.camber { slope + root_twist } else { 0.0 }));
            }
        }
        bulk.matrices.insert("W2GJ".to_owned(), Dmi::column_vector("W2GJ", incidence));
        Ok(())
    }

    fn panel(&self, id: u32, span_divisions: Divisions, y_m: [f64; 2], span: &Span) -> Caero1 {
        Caero1 {
            id,
            property: PANEL_PROPERTY,
            cp: 0,
            span_divisions,
            chord_divisions: Divisions::Equal(card_number(self.boxes.chordwise)),
            group: 1,
            point_1: self.point(y_m[0], 0.0),
            chord_1: self.chord_m(y_m[0]),
            point_4: self.point(y_m[1], 0.0),
            chord_4: self.chord_m(y_m[1]),
            span: span.clone(),
        }
    }

    /// -dz/dx of the camber line at the 3/4 point of each box of a chord, leading edge first.
    fn incidence_from_camber(&self, folder: &Path) -> Result<Vec<f64>, InputError> {
        let count = self.boxes.chordwise;
        let Some(file) = &self.airfoil else { return Ok(vec![0.0; count]) };
        let airfoil = Airfoil::read(&folder.join(file))?;
        Ok((0..count).map(|row| -airfoil.camber_slope((row as f64 + 0.75) / count as f64)).collect())
    }
}

/// A count as a card holds it; counts are bounded by [`Planform::check`] long before this could saturate.
pub(super) fn card_number(count: usize) -> u32 {
    u32::try_from(count).unwrap_or(u32::MAX)
}
