//! Curves of a figure as CSV: for every panel a column of abscissae and one for each curve; curves that share their
//! abscissae share the column, and short columns end in empty cells. No two columns have the same head.

use crate::figure::Figure;
use std::collections::BTreeMap;

/// A column: head and values.
type Column<'a> = (String, &'a [f64]);

impl Figure {
    /// All curves in full as CSV. Heads are `PANEL: LABEL` for abscissae (a panel's title only if it has one), `PANEL: LABEL
    /// of NAME` with the first curve over them where there are several of a label, and `PANEL: NAME LABEL` for curves;
    /// what would still be the same is numbered, `... (2)`. What is not finite is empty.
    pub fn csv(&self) -> String {
        let columns = self.columns_of_curves();
        let heads: Vec<String> = columns.iter().map(|column| quoted(&column.0)).collect();
        let mut text = heads.join(",") + "\n";
        let rows = columns.iter().map(|column| column.1.len()).max().unwrap_or(0);
        for row in 0..rows {
            let cell = |column: &Column<'_>| {
                column.1.get(row).filter(|v| v.is_finite()).map_or(String::new(), |v| nine_digits(*v))
            };
            let cells: Vec<String> = columns.iter().map(cell).collect();
            text.push_str(&cells.join(","));
            text.push('\n');
        }
        text
    }

    fn columns_of_curves(&self) -> Vec<Column<'_>> {
        let mut columns: Vec<(Column<'_>, Option<&str>)> = Vec::new();
        let mut last: Option<(&[f64], String)> = None;
        for panel in &self.panels {
            let of = |text: &str| {
                if panel.title.is_empty() { text.to_owned() } else { format!("{}: {text}", panel.title) }
            };
            for series in &panel.series {
                let head = of(&panel.x_label);
                if last.as_ref().is_none_or(|(x, known)| *x != series.x || *known != head) {
                    columns.push(((head.clone(), &series.x), Some(&series.name)));
                    last = Some((&series.x, head));
                }
                columns.push(((of(&format!("{} {}", series.name, panel.y_label)), &series.y), None));
            }
        }
        told_apart(columns)
    }
}

/// The columns with heads that occur once each; abscissae come with the name of the first curve over them.
fn told_apart<'a>(columns: Vec<(Column<'a>, Option<&str>)>) -> Vec<Column<'a>> {
    let mut uses = BTreeMap::new();
    for ((head, _), _) in &columns {
        *uses.entry(head.clone()).or_insert(0) += 1;
    }
    let mut written: BTreeMap<String, usize> = BTreeMap::new();
    let named = columns.into_iter().map(|((head, values), over)| match over {
        Some(name) if uses[&head] > 1 && !name.is_empty() => (format!("{head} of {name}"), values),
        _ => (head, values),
    });
    named
        .map(|(head, values)| {
            let count = written.entry(head.clone()).or_insert(0);
            *count += 1;
            if *count == 1 { (head, values) } else { (format!("{head} ({count})"), values) }
        })
        .collect()
}

/// Nine significant digits, without trailing zeros.
fn nine_digits(value: f64) -> String {
    /// Powers of ten up to this one are exact: the quotient is what the nine digits would be read as.
    const EXACT: f64 = 22.0;
    let power = 8.0 - value.abs().log10().floor();
    if (0.0..=EXACT).contains(&power) {
        #[expect(clippy::cast_possible_truncation, reason = "a whole number up to 22")]
        let scale = 10.0_f64.powi(power as i32);
        return ((value * scale).round() / scale).to_string();
    }
    format!("{value:.8e}").parse::<f64>().map_or(String::new(), |value| value.to_string())
}

fn quoted(text: &str) -> String {
    if text.contains([',', '"', '\n']) {
        format!("\"{}\"", text.replace('"', "\"\""))
    } else {
        text.to_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::nine_digits;
    use crate::figure::{Figure, Panel, Series, Style};

    #[test]
    fn nine_digits_are_those_of_the_standard_library() {
        let sizes = (-330..300).map(|power| format!("{}e{power}", 1.234_567_890_1 + f64::from(power)));
        let others = ["0", "-0", "1", "1000", "999999999.7", "0.1", "123456789", "5e-324"].map(String::from);
        for text in sizes.chain(others) {
            for value in [1.0, -0.7].map(|sign| sign * text.parse::<f64>().expect("a number")) {
                let expected = format!("{value:.8e}").parse::<f64>().expect("a number");
                assert_eq!(nine_digits(value), expected.to_string(), "{text}");
            }
        }
    }

    #[test]
    fn curves_share_a_column_of_abscissae_and_short_ones_end_in_empty_cells() {
        let series =
            |name: &str, x: &[f64], y: &[f64]| Series::new(name, x.to_vec(), y.to_vec(), Style::Line);
        let panel = |y_label: &str, series| Panel {
            title: "30 m/s".into(),
            x_label: "t (s)".into(),
            y_label: y_label.into(),
            series,
        };
        let (x, short) = ([0.0, 1.0], [0.5]);
        let figure = Figure {
            title: String::new(),
            columns: 1,
            panels: vec![
                panel("Fz (N)", vec![series("a, b", &x, &[1.0, f64::NAN]), series("c", &x, &[2.0, 3.0])]),
                panel(
                    "My (N m)",
                    vec![series("c", &x, &[4.0, 5.123_456_789_1]), series("d", &short, &[6.0])],
                ),
            ],
        };
        let expected = "\"30 m/s: t (s) of a, b\",\"30 m/s: a, b Fz (N)\",30 m/s: c Fz (N),30 m/s: c My (N m),\
                        30 m/s: t (s) of d,30 m/s: d My (N m)\n\
                        0,1,2,4,0.5,6\n1,,3,5.12345679,,\n";
        assert_eq!(figure.csv(), expected);
    }

    #[test]
    fn no_two_columns_have_the_same_head() {
        let of = |name: &str, x: f64| Series::new(name, vec![x], vec![x], Style::Line);
        let panel = || Panel {
            title: String::new(),
            x_label: "t (s)".into(),
            y_label: "y".into(),
            series: vec![of("a", 0.0), of("a", 1.0), of("", 2.0), of("", 3.0)],
        };
        let text = Figure { title: String::new(), columns: 1, panels: vec![panel(), panel()] }.csv();
        let heads: Vec<&str> = text.lines().next().unwrap_or_default().split(',').collect();
        let all: std::collections::BTreeSet<&str> = heads.iter().copied().collect();
        assert_eq!((heads.len(), all.len()), (16, 16), "{heads:?}");
        assert_eq!(heads[..4], ["t (s) of a", "a y", "t (s) of a (2)", "a y (2)"]);
    }
}
