//! Play between servo and surface: the mean of two widths (the obvious form: one).

use super::{Effect, Kind, Parameter, Sign};
use crate::flown::At;

pub(super) const KIND: Kind = Kind {
    name: "backlash",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("gap_deg", 0.1, 3.0, Sign::Plus)],
    make: |values| Box::new(Backlash { gap_deg: values[0] }),
};

#[derive(Debug)]
struct Backlash {
    gap_deg: f64,
}

impl Effect for Backlash {
    fn deflection(&self, _at: &At<'_>, _control: usize, delta: &mut [f64]) {
        if self.gap_deg <= 0.0 {
            return;
        }
        let half = 0.5 * self.gap_deg.to_radians();
        let mut places = [delta.first().copied().unwrap_or_default(); 2];
        for value in delta {
            for (place, width) in places.iter_mut().zip([0.7 * half, 1.3 * half]) {
                *place = place.clamp(*value - width, *value + width);
            }
            *value = 0.5 * (places[0] + places[1]);
        }
    }
}
