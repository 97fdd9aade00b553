//! Nastran's real numbers: reading them, and the most precise text for one in a field of given width.
//!
//! A real has a decimal point, or an exponent with a letter (`1E9`, which Nastran takes as well); an exponent may come with `E`,
//! `D` or only a sign (`1.5-3` is 0.0015).

/// The value of a Nastran real, or nothing if the text is not one or is not finite.
pub fn parse(text: &str) -> Option<f64> {
    let text = text.trim();
    let unsigned = text.strip_prefix(['+', '-']).unwrap_or(text);
    let end = unsigned.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(unsigned.len());
    let (mantissa, exponent) = unsigned.split_at(end);
    let digits = mantissa.bytes().filter(u8::is_ascii_digit).count();
    let points = mantissa.bytes().filter(|b| *b == b'.').count();
    if digits == 0 || points > 1 || (points == 0 && !exponent.starts_with(['e', 'E', 'd', 'D'])) {
        return None;
    }
    let letterless = exponent.strip_prefix(['e', 'E', 'd', 'D']).unwrap_or(exponent);
    let exponent_digits = letterless.strip_prefix(['+', '-']).unwrap_or(letterless);
    let well_formed = !exponent_digits.is_empty() && exponent_digits.bytes().all(|b| b.is_ascii_digit());
    if !exponent.is_empty() && !well_formed {
        return None;
    }
    let value: Result<f64, _> = if exponent.is_empty() || exponent.starts_with(['e', 'E']) {
        text.parse()
    } else {
        let sign = if text.starts_with('-') { "-" } else { "" };
        format!("{sign}{mantissa}e{letterless}").parse()
    };
    value.ok().filter(|value| value.is_finite())
}

/// The most precise text of at most `width` characters (8 or more) that Nastran reads as a real.
///
/// Of the fixed and the exponential forms the one nearest to `value` wins, the shorter one of two equals.
/// What is read from the text and written again gives the same text, for widths up to 16. A value that is not
/// finite gives `NaN` or `inf`, which no reader takes for a number.
pub fn format(value: f64, width: usize) -> String {
    if !value.is_finite() {
        return value.to_string();
    }
    let [most_fixed, most_exponential] = most(value, width);
    let fixed = longest(most_fixed, value, width, fixed);
    let exponential = longest(most_exponential, value, width, exponential);
    let error = |found: &Option<(String, f64)>| found.as_ref().map_or(f64::INFINITY, |(_, error)| *error);
    let chosen = match (error(&fixed), error(&exponential)) {
        (f64::INFINITY, f64::INFINITY) => None,
        (fixed_error, exponential_error) if fixed_error < exponential_error => fixed,
        (fixed_error, exponential_error) if exponential_error < fixed_error => exponential,
        _ => [fixed, exponential].into_iter().flatten().min_by_key(|(text, _)| text.len()),
    };
    // Only numbers so near the largest one that rounding overflows have no candidate.
    let largest = || if value < 0.0 { "-1.7+308".into() } else { "1.79+308".into() };
    with_leading_zero(chosen.map_or_else(largest, |(text, _)| text), width)
}

/// Precisions of the fixed and the exponential form that are not worth exceeding: a longer text fits only if its last digits are zeros,
/// and is then the text of this precision. One more than the power of ten says, which may be one off near a power.
fn most(value: f64, width: usize) -> [usize; 2] {
    let power = value.abs().log10().floor();
    if !power.is_finite() {
        return [width - 1; 2];
    }
    let sign = usize::from(value.is_sign_negative());
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "between 0 and 324")]
    let [whole, size] = [(power + 1.0).max(0.0) as usize, power.abs() as usize];
    let digits = size.max(1).ilog10() as usize + 1;
    // the point; a digit, the point and the exponent's sign
    let left = |taken: usize| (width + 1).saturating_sub(sign + taken).min(width - 1);
    [left(whole + 1), left(3 + digits)]
}

/// The longest text that fits, from a precision down, and how far it is from the value.
fn longest(most: usize, value: f64, width: usize, text: fn(f64, usize) -> String) -> Option<(String, f64)> {
    let of = |precision| {
        let text = Some(text(value, precision)).filter(|text| text.len() <= width)?;
        let error = (parse(&text)? - value).abs();
        Some((text, error))
    };
    (0..=most).rev().find_map(of)
}

/// `12.5`, `.125`; trailing zeros dropped only when they are beyond the width anyway or say nothing.
fn fixed(value: f64, precision: usize) -> String {
    let text = format!("{value:.precision$}");
    let text = if text.contains('.') { text.trim_end_matches('0').to_owned() } else { format!("{text}.") };
    match text.strip_prefix("0.") {
        Some(rest) if !rest.is_empty() => format!(".{rest}"),
        _ => match text.strip_prefix("-0.") {
            Some(rest) if !rest.is_empty() => format!("-.{rest}"),
            _ => text,
        },
    }
}

/// `1.25-3`, without a letter.
fn exponential(value: f64, precision: usize) -> String {
    let text = format!("{value:.precision$e}");
    let (mantissa, exponent) = text.split_once('e').expect("Rust's exponential format contains an e");
    let mantissa = if mantissa.contains('.') {
        mantissa.trim_end_matches('0').to_owned()
    } else {
        format!("{mantissa}.")
    };
    if exponent.starts_with('-') { format!("{mantissa}{exponent}") } else { format!("{mantissa}+{exponent}") }
}

/// `.5` and `1.` are easier to read as `0.5` and `1.0`, if there is room.
fn with_leading_zero(text: String, width: usize) -> String {
    if text.len() >= width {
        return text;
    }
    match (text.strip_prefix('.'), text.strip_prefix("-.")) {
        (Some(rest), _) => format!("0.{rest}"),
        (_, Some(rest)) => format!("-0.{rest}"),
        _ if text.ends_with('.') => format!("{text}0"),
        _ => text,
    }
}
