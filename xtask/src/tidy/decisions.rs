//! The numbers that decide what `discover` names stand in its rules, each with its meaning and origin.

use syn::visit::Visit;

use super::complaint::Complaint;
use super::parsed::{Source, about};

/// Where they stand.
const RULES: &str = "crates/discover/src/rules";
/// Numbers that decide nothing: a mathematical constant or a matter of format.
const NO_DECISION: &[(&str, &str, &str)] = &[
    ("crates/discover/src/locate/gram.rs", "NEW", "below it elimination divides by rounding errors"),
    ("crates/discover/src/null_key.rs", "FINE", "how finely a key compares inputs"),
];

/// Complaints about constants with numbers in `crates/discover/src` outside its rules.
pub fn check(sources: &[Source]) -> Vec<Complaint> {
    let mut complaints = Vec::new();
    let judged = sources.iter().filter(|source| source.name.starts_with("crates/discover/src/"));
    for source in judged.filter(|source| !source.name.starts_with(RULES)) {
        let mut constants = Constants::default();
        constants.visit_file(&source.file);
        for (constant, line) in constants.0 {
            let excepted =
                NO_DECISION.iter().any(|(file, name, _)| *file == source.name && *name == constant);
            if !excepted {
                let message = format!("the constant `{constant}` belongs to the rules of discover ({RULES})");
                complaints.push(about(&source.name, line, message));
            }
        }
    }
    complaints
}

#[derive(Default)]
struct Constants(Vec<(String, usize)>);

impl Constants {
    fn note(&mut self, name: &syn::Ident, value: &syn::Expr) {
        let mut numbers = Numbers(false);
        numbers.visit_expr(value);
        if numbers.0 {
            self.0.push((name.to_string(), name.span().start().line));
        }
    }
}

impl Visit<'_> for Constants {
    fn visit_item_const(&mut self, item: &syn::ItemConst) {
        self.note(&item.ident, &item.expr);
    }

    fn visit_item_static(&mut self, item: &syn::ItemStatic) {
        self.note(&item.ident, &item.expr);
    }

    fn visit_impl_item_const(&mut self, item: &syn::ImplItemConst) {
        self.note(&item.ident, &item.expr);
    }
}

struct Numbers(bool);

impl Visit<'_> for Numbers {
    fn visit_lit(&mut self, literal: &syn::Lit) {
        self.0 |= matches!(literal, syn::Lit::Int(_) | syn::Lit::Float(_));
    }
}
