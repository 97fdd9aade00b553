//! Colours that survive colour blindness and grey printing.
//!
//! Lines: the qualitative set of M. Okabe and K. Ito, "Color Universal Design" (2008), without its yellow, which
//! vanishes on white paper. Values: a diverging blue-white-orange ramp between two colours of that set, whose
//! lightness falls off to both sides, so that zero (or one) is the lightest colour.

/// Line colours in order of use: blue, vermilion, green, purple, orange, sky blue, black.
pub const LINES: [&str; 7] = ["#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#000000"];

/// What means the same on every page looks the same on every page: a series or view of such a name has this colour
/// wherever it is drawn, and no other has it beside it.
const ROLES: [(&str, &str); 9] = [
    ("measured", "#000000"),
    ("initial", "#d55e00"),
    ("before", "#d55e00"),
    ("updated", "#0072b2"),
    ("after", "#0072b2"),
    ("linear", "#6e7781"),
    ("equal", "#6e7781"),
    ("noise", "#6e7781"),
    ("undeformed", "#8c959f"),
];

const BELOW: [f64; 3] = [0.0, 80.0, 150.0];
const MIDDLE: [f64; 3] = [247.0, 247.0, 247.0];
const ABOVE: [f64; 3] = [190.0, 75.0, 0.0];

/// The line colour of the series with this number; the colours repeat after seven.
pub fn line(index: usize) -> &'static str {
    LINES[index % LINES.len()]
}

/// The colour of a name that has a role; what stands after a colon is its own affair (`initial: tip 0.60 m`).
fn role(name: &str) -> Option<&'static str> {
    let name = name.split(':').next().unwrap_or_default();
    ROLES.iter().find(|(role, _)| *role == name).map(|(_, colour)| *colour)
}

/// Line colours of the names of a figure: those of roles (measured, initial, updated) are fixed, and beside one of these
/// no other name has a colour of theirs; the others take what is left of [`LINES`] in their order.
pub fn of_names(names: &[&str]) -> Vec<&'static str> {
    let some = names.iter().filter_map(|name| role(name)).any(|colour| LINES.contains(&colour));
    let kept = |colour: &&str| some && ROLES.iter().any(|(_, fixed)| fixed == colour);
    let free: Vec<&'static str> = LINES.into_iter().filter(|colour| !kept(colour)).collect();
    let mut used = 0;
    let mut next = || {
        used += 1;
        free[(used - 1) % free.len()]
    };
    names.iter().map(|name| role(name).unwrap_or_else(&mut next)).collect()
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
    hex([0, 1, 2].map(|i| MIDDLE[i] + weight * (end[i] - MIDDLE[i])))
}

/// The colour `#rrggbb` mixed with white (`factor` > 0) or black (`factor` < 0); 0 changes nothing, 1 is white.
pub(crate) fn shaded(colour: &str, factor: f64) -> String {
    let towards = if factor > 0.0 { 255.0 } else { 0.0 };
    hex([1, 3, 5].map(|at| {
        let byte = colour.get(at..at + 2).and_then(|hex| u8::from_str_radix(hex, 16).ok()).unwrap_or(128);
        f64::from(byte) + factor.abs().min(1.0) * (towards - f64::from(byte))
    }))
}

/// `#rrggbb` of channels from 0 to 255.
fn hex(channels: [f64; 3]) -> String {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 255")]
    let [red, green, blue] = channels.map(|channel| channel.round() as u8);
    format!("#{red:02x}{green:02x}{blue:02x}")
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
    fn measured_initial_and_updated_have_their_colours_in_any_order_and_company() {
        let first = of_names(&["measured", "initial", "updated", "angle of attack"]);
        assert_eq!(first, ["#000000", "#d55e00", "#0072b2", "#009e73"]);
        assert_eq!(of_names(&["initial: tip 0.60 m", "updated: tip 0.43 m"]), ["#d55e00", "#0072b2"]);
        assert_eq!(of_names(&["angle", "updated", "measured"]), ["#009e73", "#0072b2", "#000000"]);
        let many: Vec<String> = (0..20).map(|i| format!("{i} m/s")).collect();
        let mut many: Vec<&str> = many.iter().map(String::as_str).collect();
        assert_eq!(of_names(&many)[7], of_names(&many)[0]);
        many.insert(0, "linear");
        assert_eq!(of_names(&many)[1], line(0));
    }

    #[test]
    fn shading_reaches_white_and_black() {
        assert_eq!(shaded("#0072b2", 1.0), "#ffffff");
        assert_eq!(shaded("#0072b2", -1.0), "#000000");
        assert_eq!(shaded("#0072b2", 0.0), "#0072b2");
    }
}
