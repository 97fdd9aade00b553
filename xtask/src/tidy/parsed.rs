//! Source files as the compiler reads them, for the rules that a search of text would get wrong.

use std::path::Path;

use syn::visit::Visit;

use super::complaint::{Complaint, files_below, named};
use wingroot::failure::Failure;

/// A source file without its `#[cfg(test)]` items.
pub struct Source {
    /// Path from the repository root.
    pub name: String,
    /// Its items.
    pub file: syn::File,
}

impl Source {
    /// Reads a text.
    ///
    /// # Errors
    /// If it is not Rust.
    pub fn parse(name: &str, text: &str) -> Result<Self, Failure> {
        let mut file =
            syn::parse_file(text).map_err(|error| Failure::computation(format!("{name}: {error}")))?;
        file.items.retain(|item| !is_test(item));
        Ok(Self { name: name.into(), file })
    }

    /// Whether it is compiled for tests only, or an example.
    pub fn is_test(&self) -> bool {
        self.name.contains("/tests/") || self.name.contains("/examples/") || self.name.starts_with("tests/")
    }
}

/// Every source file in `crates`, `xtask` and `tests`.
///
/// # Errors
/// If a file cannot be read or is not Rust.
pub fn sources(root: &Path) -> Result<Vec<Source>, Failure> {
    let files = ["crates", "xtask", "tests"].into_iter().flat_map(|folder| files_below(&root.join(folder)));
    let files = files.filter(|path| path.extension().is_some_and(|ending| ending == "rs"));
    files.map(|path| Source::parse(&named(root, &path), &nastran::read_text(&path)?)).collect()
}

fn is_test(item: &syn::Item) -> bool {
    let syn::Item::Mod(module) = item else { return false };
    module.attrs.iter().any(|attribute| {
        attribute.path().is_ident("cfg")
            && attribute.parse_args::<syn::Path>().is_ok_and(|condition| condition.is_ident("test"))
    })
}

/// Text literals and their lines, those in macros included.
pub fn strings(source: &Source) -> Vec<(String, usize)> {
    let mut strings = Strings::default();
    strings.visit_file(&source.file);
    strings.0
}

#[derive(Default)]
struct Strings(Vec<(String, usize)>);

impl Visit<'_> for Strings {
    fn visit_lit_str(&mut self, literal: &syn::LitStr) {
        self.0.push((literal.value(), literal.span().start().line));
    }

    fn visit_attribute(&mut self, _documentation: &syn::Attribute) {}

    fn visit_macro(&mut self, called: &syn::Macro) {
        self.in_tokens(called.tokens.clone());
    }
}

impl Strings {
    fn in_tokens(&mut self, tokens: proc_macro2::TokenStream) {
        for token in tokens {
            match token {
                proc_macro2::TokenTree::Group(group) => self.in_tokens(group.stream()),
                proc_macro2::TokenTree::Literal(literal) => {
                    if let syn::Lit::Str(text) = syn::Lit::new(literal) {
                        self.visit_lit_str(&text);
                    }
                }
                _ => {}
            }
        }
    }
}

/// A complaint about a line of a source file.
pub(super) fn about(name: &str, line: usize, message: impl Into<String>) -> Complaint {
    Complaint::new(format!("{name}:{line}"), message)
}
