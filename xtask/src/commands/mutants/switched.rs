//! Sources with many mutants in them, each behind a switch, so that one build serves them all.

use std::ops::Range;

use proc_macro2::LineColumn;
use syn::spanned::Spanned;
use syn::visit::{self, Visit};

use super::listed::{Genre, Mutant};

/// What stands at the end of a crate with switched mutants: `on(n)` is true in a process whose environment has `WINGROOT_MUTANT=n`.
/// With `WINGROOT_REACHED=FILE` none is, and the numbers of those that were asked for are written there.
pub(super) const SWITCH: &str = r#"
/// Switches of mutants.
pub(crate) mod mutant_switch {
    use std::io::Write as _;
    use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering::Relaxed};
    const UNKNOWN: usize = usize::MAX;
    const RECORD: usize = usize::MAX - 1;
    static ACTIVE: AtomicUsize = AtomicUsize::new(UNKNOWN);
    static REACHED: [AtomicBool; 4096] = [const { AtomicBool::new(false) }; 4096];
    #[inline]
    pub(crate) fn on(number: usize) -> bool {
        let active = ACTIVE.load(Relaxed);
        if active < RECORD { active == number } else { first(number, active) }
    }
    #[cold]
    fn first(number: usize, active: usize) -> bool {
        if active == UNKNOWN {
            let wanted = std::env::var("WINGROOT_MUTANT").ok().and_then(|text| text.parse().ok());
            let recorded = std::env::var_os("WINGROOT_REACHED").is_some();
            ACTIVE.store(if recorded { RECORD } else { wanted.unwrap_or(RECORD - 1) }, Relaxed);
            return on(number);
        }
        if !REACHED[number].swap(true, Relaxed)
            && let Some(path) = std::env::var_os("WINGROOT_REACHED")
            && let Ok(mut file) = std::fs::OpenOptions::new().append(true).create(true).open(path)
        {
            _ = file.write_all(format!("{number}\n").as_bytes());
        }
        false
    }
}
"#;

/// How a place in the source is rewritten.
#[derive(Debug)]
enum Form {
    /// `(if on(n) { (left) OP (right) } else { .. })`
    Binary([Range<usize>; 2]),
    /// As [`Form::Binary`], the left side as it stands.
    Assigned([Range<usize>; 2]),
    /// `(if on(n) { operand } else { .. })`
    Unary(Range<usize>),
    /// `if on(n) { return VALUE; }` at the beginning of a body.
    Body,
    /// ` if !on(n)` after a pattern.
    Arm,
    /// `!on(n) && (guard)`, or `(if on(n) { VALUE } else { guard })`.
    Guard { arm: bool },
}

/// A place, and the mutants there: number and replacement.
#[derive(Debug)]
struct Place {
    at: Range<usize>,
    form: Form,
    mutants: Vec<(usize, String)>,
}

/// A text with its mutants behind switches, and the numbers of those for which a place was found.
pub(super) fn switched(text: &str, mutants: &[(usize, &Mutant)]) -> syn::Result<(String, Vec<usize>)> {
    let file = syn::parse_file(text)?;
    let starts: Vec<usize> =
        std::iter::once(0).chain(text.match_indices('\n').map(|(place, _)| place + 1)).collect();
    let mut finder = Finder { text, starts, mutants, places: Vec::new() };
    finder.visit_file(&file);
    let mut places = finder.places;
    places.sort_by_key(|place| (place.at.start, std::cmp::Reverse(place.at.end)));
    let found = places.iter().flat_map(|place| place.mutants.iter().map(|(number, _)| *number)).collect();
    Ok((rendered(text, &places, 0..text.len()), found))
}

/// Numbers of the mutants that lines of a switched text ask for; those of the last one above where they ask for none.
pub(super) fn asked_for(text: &str, lines: &Range<usize>) -> Vec<usize> {
    let numbers = |line: &str| -> Vec<usize> {
        let calls = line.split("mutant_switch::on(").skip(1);
        calls.filter_map(|rest| rest.split(')').next()?.parse().ok()).collect()
    };
    let all: Vec<&str> = text.lines().collect();
    let end = lines.end.min(all.len());
    let own: Vec<usize> = all[lines.start.min(end)..end].iter().flat_map(|line| numbers(line)).collect();
    if !own.is_empty() {
        return own;
    }
    all[..end].iter().rev().map(|line| numbers(line)).find(|some| !some.is_empty()).unwrap_or_default()
}

fn asks(number: usize) -> String {
    format!("crate::mutant_switch::on({number})")
}

/// A part of the text; places are sorted, outer ones first.
fn rendered(text: &str, places: &[Place], part: Range<usize>) -> String {
    let mut out = String::new();
    let mut at = part.start;
    for (index, place) in places.iter().enumerate() {
        if place.at.start < at || place.at.end > part.end {
            continue;
        }
        out.push_str(&text[at..place.at.start]);
        out.push_str(&with_switches(text, &places[index + 1..], place));
        at = place.at.end;
    }
    out + &text[at..part.end]
}

fn with_switches(text: &str, inner: &[Place], place: &Place) -> String {
    let part = |range: &Range<usize>| rendered(text, inner, range.clone());
    let chosen = |alternative: &dyn Fn(&str) -> String| {
        let cases = place.mutants.iter();
        let cases: Vec<String> = cases
            .map(|(number, new)| format!("if {} {{ {} }} else ", asks(*number), alternative(new)))
            .collect();
        format!("({}{{ {} }})", cases.concat(), part(&place.at))
    };
    let each = |switch: &dyn Fn(usize, &str) -> String| {
        place.mutants.iter().map(|(number, new)| switch(*number, new)).collect::<Vec<String>>().concat()
    };
    match &place.form {
        Form::Binary([left, right]) => {
            chosen(&|operator| format!("({}) {operator} ({})", part(left), part(right)))
        }
        Form::Assigned([left, right]) => {
            chosen(&|operator| format!("{} {operator} ({})", part(left), part(right)))
        }
        Form::Unary(operand) => chosen(&|_| part(operand)),
        Form::Body => each(&|number, value| format!(" if {} {{ return {value}; }} ", asks(number))),
        Form::Arm => each(&|number, _| format!(" if !{}", asks(number))),
        Form::Guard { arm: true } => {
            let asked = place.mutants.first().map_or(String::new(), |(number, _)| asks(*number));
            format!("!{asked} && ({})", part(&place.at))
        }
        Form::Guard { arm: false } => chosen(&str::to_owned),
    }
}

/// Looks for the places of a file's mutants.
struct Finder<'a> {
    text: &'a str,
    /// Where lines begin, bytes.
    starts: Vec<usize>,
    mutants: &'a [(usize, &'a Mutant)],
    places: Vec<Place>,
}

impl Finder<'_> {
    fn offset(&self, place: LineColumn) -> usize {
        let start = self.starts[place.line - 1];
        let line = &self.text[start..];
        start + line.char_indices().nth(place.column).map_or(line.len(), |(byte, _)| byte)
    }

    fn range(&self, node: &impl Spanned) -> Range<usize> {
        let span = node.span();
        self.offset(span.start())..self.offset(span.end())
    }

    /// Mutants of a genre that begin where something does.
    fn of(&self, genre: Genre, start: LineColumn) -> Vec<(usize, String)> {
        let here = self
            .mutants
            .iter()
            .filter(|(_, mutant)| mutant.genre == genre && mutant.begins_at(start.line, start.column + 1));
        here.map(|(number, mutant)| (*number, mutant.replacement.clone())).collect()
    }

    fn add(&mut self, at: Range<usize>, form: Form, mutants: Vec<(usize, String)>) {
        if !mutants.is_empty() {
            self.places.push(Place { at, form, mutants });
        }
    }

    fn body(&mut self, block: &syn::Block) {
        let Some(first) = block.stmts.first() else { return };
        let at = self.offset(block.brace_token.span.open().end());
        let mutants = self.of(Genre::FnValue, first.span().start());
        self.add(at..at, Form::Body, mutants);
    }
}

impl<'ast> Visit<'ast> for Finder<'_> {
    fn visit_item_fn(&mut self, item: &'ast syn::ItemFn) {
        self.body(&item.block);
        visit::visit_item_fn(self, item);
    }

    fn visit_impl_item_fn(&mut self, item: &'ast syn::ImplItemFn) {
        self.body(&item.block);
        visit::visit_impl_item_fn(self, item);
    }

    fn visit_trait_item_fn(&mut self, item: &'ast syn::TraitItemFn) {
        if let Some(block) = &item.default {
            self.body(block);
        }
        visit::visit_trait_item_fn(self, item);
    }

    fn visit_expr_binary(&mut self, expression: &'ast syn::ExprBinary) {
        let mutants = self.of(Genre::BinaryOperator, expression.op.span().start());
        let sides = [self.range(&expression.left), self.range(&expression.right)];
        // compound assignments are the only operators that end in = and compare nothing
        let assigned = mutants.first().is_some_and(|_| {
            let operator = &self.text[self.range(&expression.op)];
            operator.ends_with('=') && !["==", "!=", "<=", ">="].contains(&operator)
        });
        let form = if assigned { Form::Assigned(sides) } else { Form::Binary(sides) };
        self.add(self.range(expression), form, mutants);
        visit::visit_expr_binary(self, expression);
    }

    fn visit_expr_unary(&mut self, expression: &'ast syn::ExprUnary) {
        let mutants = self.of(Genre::UnaryOperator, expression.op.span().start());
        let operand = self.range(&expression.expr);
        self.add(self.range(expression), Form::Unary(operand), mutants);
        visit::visit_expr_unary(self, expression);
    }

    fn visit_arm(&mut self, arm: &'ast syn::Arm) {
        let deleted = self.of(Genre::MatchArm, arm.span().start());
        if let syn::Pat::Guard(guarded) = &arm.pat {
            let replaced = self.of(Genre::MatchArmGuard, guarded.guard.span().start());
            // two forms at one place would hide each other: the arm's goes first
            let (arm, mutants) = if deleted.is_empty() { (false, replaced) } else { (true, deleted) };
            self.add(self.range(&guarded.guard), Form::Guard { arm }, mutants);
        } else {
            let end = self.range(&arm.pat).end;
            self.add(end..end, Form::Arm, deleted.into_iter().take(1).collect());
        }
        visit::visit_arm(self, arm);
    }
}

#[cfg(test)]
mod tests {
    use super::super::listed;
    use super::*;

    /// Lists mutants as cargo-mutants does: genre, line, column, replacement.
    fn mutants(places: &[(&str, usize, usize, &str)]) -> Vec<Mutant> {
        let all = places.iter().map(|(genre, line, column, replacement)| {
            serde_json::json!({ "name": "", "file": "a.rs", "genre": genre, "replacement": replacement,
                "span": { "start": { "line": line, "column": column }, "end": { "line": 0, "column": 0 } } })
        });
        let json = serde_json::Value::Array(all.collect()).to_string();
        listed::read(json.as_bytes()).expect("a list")
    }

    /// The function with its mutants in, and a line of spaces less.
    fn with(text: &str, places: &[(&str, usize, usize, &str)]) -> (String, Vec<usize>) {
        let mutants = mutants(places);
        let numbered: Vec<(usize, &Mutant)> = mutants.iter().enumerate().collect();
        let (text, found) = switched(text, &numbered).expect("Rust");
        (text.replace("crate::mutant_switch::", ""), found)
    }

    #[test]
    fn an_operator_is_another_with_its_switch_on_and_sides_stay_together() {
        let (text, found) = with(
            "fn f(a: f64) -> f64 { -a + 2.0 - a }",
            &[("BinaryOperator", 1, 32, "*"), ("UnaryOperator", 1, 23, ""), ("BinaryOperator", 1, 32, "/")],
        );
        let a = "(if on(1) { a } else { -a })";
        let all = format!(
            "fn f(a: f64) -> f64 {{ (if on(0) {{ ({a} + 2.0) * (a) }} else if on(2) {{ ({a} + 2.0) / (a) }} \
             else {{ {a} + 2.0 - a }}) }}"
        );
        assert_eq!(text, all);
        assert_eq!(found, [0, 2, 1]);
    }

    #[test]
    fn assignments_bodies_and_arms_have_switches_too() {
        let text = "fn f(a: &mut u8) {\n    match a {\n        1 => *a += 1,\n        2 if *a > 0 => {}\n        _ => {}\n    }\n}";
        let places = [
            ("FnValue", 2, 5, "()"),
            ("MatchArm", 3, 9, ""),
            ("BinaryOperator", 3, 17, "-="),
            ("MatchArmGuard", 4, 14, "true"),
            ("BinaryOperator", 9, 1, "*"),
            ("StructField", 2, 5, ""),
        ];
        let (text, found) = with(text, &places);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines[0], "fn f(a: &mut u8) { if on(0) { return (); } ");
        assert_eq!(lines[2], "        1 if !on(1) => (if on(2) { *a -= (1) } else { *a += 1 }),");
        assert_eq!(lines[3], "        2 if (if on(3) { true } else { *a > 0 }) => {}");
        assert_eq!(found, [0, 1, 2, 3], "what has no place is left out");
    }

    #[test]
    fn an_error_names_the_mutants_of_its_lines_or_the_last_above() {
        let text = "a\nmutant_switch::on(4) mutant_switch::on(7)\nb\nc";
        assert_eq!(asked_for(text, &(1..2)), [4, 7]);
        assert_eq!(asked_for(text, &(3..4)), [4, 7]);
        assert_eq!(asked_for(text, &(0..1)), Vec::<usize>::new());
    }
}
