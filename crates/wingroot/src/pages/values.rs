//! Numbers out of `result.json`, written for people.

use report::Figure;
use report::page::PageTable;
use serde_json::Value;

/// Loads at the root: key in results, name and unit.
pub const LOADS: [(&str, &str, &str); 3] =
    [("Fz_N", "lift Fz", "N"), ("Mx_Nm", "bending Mx", "N m"), ("My_Nm", "torsion My", "N m")];

/// Endings of keys, and the units they say.
const UNITS: [(&str, &str); 15] = [
    ("_m_s2", "m/s2"),
    ("_m_s", "m/s"),
    ("_rad_s", "rad/s"),
    ("_deg_s", "deg/s"),
    ("_Nm", "N m"),
    ("_kg_m2", "kg m2"),
    ("_kg", "kg"),
    ("_N", "N"),
    ("_deg", "deg"),
    ("_rad", "rad"),
    ("_Hz", "Hz"),
    ("_Pa", "Pa"),
    ("_V", "V"),
    ("_krpm", "krpm"),
    ("_m", "m"),
];

/// A key as it is read: `tip_acceleration_m_s2` is `tip acceleration (m/s2)`.
pub fn with_unit(key: &str) -> String {
    let known = UNITS.iter().find_map(|(ending, unit)| Some((key.strip_suffix(ending)?, unit)));
    match known.filter(|(name, _)| !name.is_empty()) {
        Some((name, unit)) => format!("{} ({unit})", name.replace('_', " ")),
        None => key.replace('_', " "),
    }
}

/// The number at a path such as `gap/holdout/before`; at the empty path the value itself.
pub fn at(value: &Value, path: &str) -> Option<f64> {
    if path.is_empty() { value.as_f64() } else { value.pointer(&format!("/{path}")).and_then(Value::as_f64) }
}

/// The entries of a list, none if it is no list.
pub fn list<'a>(value: &'a Value, path: &str) -> &'a [Value] {
    value.pointer(&format!("/{path}")).and_then(Value::as_array).map_or(&[], Vec::as_slice)
}

/// The text at a path, or nothing.
pub fn text<'a>(value: &'a Value, path: &str) -> &'a str {
    value.pointer(&format!("/{path}")).and_then(Value::as_str).unwrap_or_default()
}

/// The same as a cell of a table.
pub fn word(value: &Value, path: &str) -> String {
    text(value, path).to_owned()
}

/// A column of a table of entries: its head, where its value is in an entry, and how it is written.
pub type Column = (&'static str, &'static str, fn(&Value, &str) -> String);

/// A table with a row an entry.
pub fn table_of<'a>(
    caption: impl Into<String>,
    entries: impl IntoIterator<Item = &'a Value>,
    columns: &[Column],
) -> PageTable {
    let mut table = PageTable::new(caption, &columns.iter().map(|column| column.0).collect::<Vec<_>>());
    for entry in entries {
        table.row(columns.iter().map(|(_, path, written)| written(entry, path)));
    }
    table
}

/// Three significant digits; a dash where there is no number.
pub fn short(value: Option<f64>) -> String {
    value.map_or_else(|| "-".into(), |value| digits(value, 3))
}

/// The number at a path with three significant digits.
pub fn short_at(value: &Value, path: &str) -> String {
    short(at(value, path))
}

/// The number at a path with four.
pub fn four_at(value: &Value, path: &str) -> String {
    at(value, path).map_or_else(|| "-".into(), |number| digits(number, 4))
}

/// The number at a path with five.
pub fn five_at(value: &Value, path: &str) -> String {
    at(value, path).map_or_else(|| "-".into(), |number| digits(number, 5))
}

/// The number at a path with four decimals, rounded, without a sign of zero.
pub fn decimals_at(value: &Value, path: &str) -> String {
    at(value, path).map_or_else(|| "-".into(), |number| format!("{:.4}", rounded(number, 4)))
}

/// The whole number at a path.
pub fn whole_at(value: &Value, path: &str) -> String {
    at(value, path).map_or_else(|| "-".into(), |number| format!("{number:.0}"))
}

/// So many significant digits, without an exponent where it is short enough; whole numbers as they are.
pub fn digits(value: f64, count: usize) -> String {
    if value == 0.0 || !value.is_finite() {
        return if value == 0.0 { "0".into() } else { "-".into() };
    }
    // 15 degrees went through radians and came back with the last bit changed
    if (value - value.round()).abs() < 1e-12 * value.abs() && value.abs() < 1e7 {
        return format!("{value:.0}");
    }
    #[expect(clippy::cast_possible_truncation, reason = "an exponent is below 400")]
    let power = value.abs().log10().floor() as i32;
    let places = i32::try_from(count).unwrap_or(3) - 1 - power;
    match usize::try_from(places) {
        _ if !(-4..7).contains(&power) => format!("{value:.*e}", count - 1),
        Ok(places) => format!("{value:.places$}"),
        Err(_) => format!("{value:.0}"),
    }
}

/// Rounded to so many places, without a sign of zero: -0.001 is 0.
pub fn rounded(value: f64, places: i32) -> f64 {
    let scale = 10.0_f64.powi(places);
    (value * scale).round() / scale + 0.0
}

/// `a -> b` with a unit.
pub fn from_to(before: Option<f64>, after: Option<f64>, unit: &str) -> String {
    format!("{} \u{2192} {} {unit}", short(before), short(after)).trim_end().to_owned()
}

/// A number of things with the word for it.
pub fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

/// Root mean square of what a series of each panel differs from `measured`, over points they share; panels without both
/// are left out.
pub fn rms_beside_measured(figure: &Figure, name: &str) -> Vec<f64> {
    let rms = |panel: &report::Panel| {
        let of = |name: &str| panel.series.iter().find(|series| series.name == name);
        let (measured, model) = (of("measured")?, of(name)?);
        let squares: Vec<f64> = measured
            .y
            .iter()
            .zip(&model.y)
            .map(|(a, b)| (a - b).powi(2))
            .filter(|square| square.is_finite())
            .collect();
        (!squares.is_empty()).then(|| (squares.iter().sum::<f64>() / squares.len() as f64).sqrt())
    };
    figure.panels.iter().filter_map(rms).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_read_with_their_units() {
        let read = ["tip_acceleration_m_s2", "Mx_Nm", "Fz_N", "mass_kg", "load_factor", "tip_deflection_m"]
            .map(with_unit);
        let words = [
            "tip acceleration (m/s2)",
            "Mx (N m)",
            "Fz (N)",
            "mass (kg)",
            "load factor",
            "tip deflection (m)",
        ];
        assert_eq!(read, words);
    }

    #[test]
    fn zero_has_no_sign() {
        assert_eq!(format!("{:.4}", rounded(-0.000_01, 4)), "0.0000");
        assert_eq!(format!("{:+.2}", rounded(-1.914, 2)), "-1.91");
    }

    #[test]
    fn numbers_have_as_many_digits_as_asked_for() {
        let shown =
            [0.0, 22.916, -0.017_854, 123_456.7, 15.000_000_000_000_002, 4.2e-9, 8.1e12, 9.999, f64::NAN]
                .map(|v| digits(v, 3));
        assert_eq!(shown, ["0", "22.9", "-0.0179", "123457", "15", "4.20e-9", "8.10e12", "10.00", "-"]);
    }
}
