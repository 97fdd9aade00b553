//! An angle sensor with a wrong gain: the wing turns further than it says, with a sine (the obvious form: a factor).

use super::{Effect, Kind, Parameter, Sign};

pub(super) const KIND: Kind = Kind {
    name: "alpha_encoder",
    in_library: true,
    compared: None,
    parameters: &[Parameter::size("g_a", 0.005, 0.1, Sign::Either)],
    make: |values| Box::new(AlphaEncoder { gain: values[0] }),
};

#[derive(Debug)]
struct AlphaEncoder {
    gain: f64,
}

impl Effect for AlphaEncoder {
    fn reading(&self, alpha_deg: &mut [f64]) {
        if self.gain == 0.0 {
            return;
        }
        for angle in alpha_deg {
            *angle = (angle.to_radians().sin() / (1.0 + self.gain)).asin().to_degrees();
        }
    }
}
