//! Freeplay between servo and surface: the mean of two widths (the obvious form: one).

use super::{Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "backlash",
    parameters: &[Parameter::size("gap_deg", 0.1, 3.0, Sign::Plus)],
    deflection: |p, _, _, delta| {
        if p[0] <= 0.0 {
            return;
        }
        let half = 0.5 * p[0].to_radians();
        let mut places = [delta.first().copied().unwrap_or_default(); 2];
        for value in delta {
            for (place, width) in places.iter_mut().zip([0.7 * half, 1.3 * half]) {
                *place = place.clamp(*value - width, *value + width);
            }
            *value = 0.5 * (places[0] + places[1]);
        }
    },
    ..Kind::NONE
};
