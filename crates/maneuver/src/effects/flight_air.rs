//! The air of a flying wing, into whose corrections effects along the span are put.

use super::place::REFERENCE_V_M_S;
use aero::Corrections;
use coupling::ElasticWing;

/// How an effect that travels with the wing acts in flight.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Flight {
    /// Corrections of the boxes carry it.
    Corrections,
    /// Control surfaces deflect otherwise, whatever else moves.
    Deflection,
    /// A flying wing of linear structure and corrected air cannot carry it.
    Left,
}

/// Corrections of a wing's boxes at an airspeed.
#[derive(Debug)]
pub struct FlightAir<'a> {
    /// The wing.
    pub wing: &'a ElasticWing,
    /// Airspeed, m/s.
    pub v_m_s: f64,
    /// The corrections, one entry for each correctable box.
    pub corrections: &'a mut Corrections,
}

impl FlightAir<'_> {
    /// `V_ref/V - 1`: by what share effects of the Reynolds number act at this airspeed; zero in still air.
    pub fn slower(&self) -> f64 {
        if self.v_m_s > 0.0 { REFERENCE_V_M_S / self.v_m_s - 1.0 } else { 0.0 }
    }

    /// Lift by angle changes by a share, that of camber does not. As a factor of boxes it changes the lift of control
    /// surfaces, too.
    pub fn scale_slope(&mut self, share: f64) {
        let corrections = &mut *self.corrections;
        for (k, &j) in self.wing.correctable.places.iter().enumerate() {
            corrections.pressure_offset[k] -=
                share * corrections.force[k] * self.wing.pressures_of_camber()[j];
            corrections.force[k] *= 1.0 + share;
            corrections.moment[k] *= 1.0 + share;
        }
    }

    /// All lift times `1 - d y²`, y over the span.
    pub fn lose_to_tip(&mut self, d: f64) {
        let corrections = &mut *self.corrections;
        for (k, y) in self.wing.correctable.y_norm.iter().enumerate() {
            let factor = 1.0 - d * y * y;
            corrections.force[k] *= factor;
            corrections.moment[k] *= factor;
            corrections.pressure_offset[k] *= factor;
        }
    }

    /// Lift acts a share of the chord further aft: a moment nose down on every box. Pressure offsets stay where they are.
    pub fn shift_aft(&mut self, dx_over_c: f64) {
        let corrections = &mut *self.corrections;
        let boxes = &self.wing.correctable;
        for (k, &j) in boxes.places.iter().enumerate() {
            let chord_m = boxes.chord_rows[k] as f64 * self.wing.lattice.boxes[j].chord_m();
            corrections.moment[k] -=
                dx_over_c * chord_m * corrections.force[k] / self.wing.integration.moment_arm(j);
        }
    }

    /// An angle of attack of all strips that gravity does not see, rad.
    pub fn incline(&mut self, angle_rad: f64) {
        let corrections = &mut *self.corrections;
        for (k, &j) in self.wing.correctable.places.iter().enumerate() {
            corrections.pressure_offset[k] +=
                angle_rad * corrections.force[k] * self.wing.pressures_by_alpha()[j];
        }
    }

    /// A moment coefficient of all strips: pressures that fall in a straight line along the chord and carry no lift. A strip
    /// of one box has none.
    pub fn add_moment(&mut self, coefficient: f64) {
        let boxes = &self.wing.correctable;
        for k in 0..boxes.len() {
            let (row, rows) = (boxes.chord_row[k] as f64, boxes.chord_rows[k] as f64);
            let square = (rows * rows - 1.0) / 12.0;
            if square > 0.0 {
                self.corrections.pressure_offset[k] +=
                    coefficient * rows * (0.5 * (rows - 1.0) - row) / square;
            }
        }
    }
}

#[cfg(test)]
mod tests;
