//! Colours that survive colour blindness and grey printing.
//!
//! Lines: the qualitative set of M. Okabe and K. Ito, "Color Universal Design" (2008), without its yellow, which
//! vanishes on white paper. Values: a diverging blue-white-orange ramp between two colours of that set, whose
//! lightness falls off to both sides, so that zero (or one) is the lightest colour.

/// Line colours in order of use: blue, vermilion, green, purple, orange, sky blue, black.
pub const LINES: [&str; 7] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"];

const BELOW: [f64; 3] = [0.0, 80.0, 150.0];
const MIDDLE: [f64; 3] = [247.0, 247.0, 247.0];
const ABOVE: [f64; 3] = [190.0, 75.0, 0.0];

/// The line colour of the series with this number; the colours repeat after seven.
pub fn line(index: usize) -> &'static str {
    LINES[index % LINES.len()]
}

/// Colour `#rrggbb` of a place on the diverging ramp: 0 blue, 0.5 white, 1 orange. Places outside are clamped, and
/// a place that is not a number is grey.
pub fn diverging(place: f64) -> String {
    if !place.is_finite() {
        return "#b0b0b0".into();
    }
    let signed = (place.clamp(0.0, 1.0) - 0.5) * 2.0;
    let end = if signed < 0.0 { BELOW } else { ABOVE };
    let weight = signed.abs();
    let channel = |i: usize| (MIDDLE[i] + weight * (end[i] - MIDDLE[i])).round();
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 255")]
    let byte = |i: usize| channel(i) as u8;
    format!("#{:02x}{:02x}{:02x}", byte(0), byte(1), byte(2))
}

/// The colour `#rrggbb` mixed with white (`factor` > 0) or black (`factor` < 0); 0 changes nothing, 1 is white.
pub(crate) fn shaded(colour: &str, factor: f64) -> String {
    let channel = |at: usize| {
        let byte = colour.get(at..at + 2).and_then(|hex| u8::from_str_radix(hex, 16).ok()).unwrap_or(128);
        let towards = if factor > 0.0 { 255.0 } else { 0.0 };
        let mixed = f64::from(byte) + factor.abs().min(1.0) * (towards - f64::from(byte));
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 255")]
        let mixed = mixed.round() as u8;
        mixed
    };
    format!("#{:02x}{:02x}{:02x}", channel(1), channel(3), channel(5))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_middle_of_the_ramp_is_the_lightest_and_the_ends_are_the_named_colours() {
        assert_eq!(diverging(0.0), "#005096");
        assert_eq!(diverging(0.5), "#f7f7f7");
        assert_eq!(diverging(1.0), "#be4b00");
        assert_eq!(diverging(7.0), diverging(1.0));
        assert_eq!(diverging(f64::NAN), "#b0b0b0");
    }

    #[test]
    fn shading_reaches_white_and_black() {
        assert_eq!(shaded("#0072b2", 1.0), "#ffffff");
        assert_eq!(shaded("#0072b2", -1.0), "#000000");
        assert_eq!(shaded("#0072b2", 0.0), "#0072b2");
    }
}
