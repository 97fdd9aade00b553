//! No parameter is a tuple of references: what travels together has a name, or fewer parameters are needed.

use syn::visit::{self, Visit};

use super::complaint::Complaint;
use super::parsed::{Source, about};

/// Complaints about functions (closures are not judged: their parameters are those of what calls them).
pub fn check(sources: &[Source]) -> Vec<Complaint> {
    let mut complaints = Vec::new();
    for source in sources {
        let mut signatures = Signatures { name: &source.name, complaints: &mut complaints };
        signatures.visit_file(&source.file);
    }
    complaints
}

struct Signatures<'a> {
    name: &'a str,
    complaints: &'a mut Vec<Complaint>,
}

impl Visit<'_> for Signatures<'_> {
    fn visit_signature(&mut self, signature: &syn::Signature) {
        let typed = signature.inputs.iter().filter_map(|input| match input {
            syn::FnArg::Typed(parameter) => Some(parameter.ty.as_ref()),
            syn::FnArg::Receiver(_) => None,
        });
        for tuple in typed.filter_map(tuple_of_references) {
            let message = format!("`{}` takes a tuple of references: name it, or pass less", signature.ident);
            self.complaints.push(about(self.name, tuple.paren_token.span.open().start().line, message));
        }
        visit::visit_signature(self, signature);
    }
}

/// A tuple with a reference, or with a type that borrows (`View<'_>`), anywhere in it.
fn tuple_of_references(kind: &syn::Type) -> Option<&syn::TypeTuple> {
    let syn::Type::Tuple(tuple) = kind else { return None };
    let mut borrows = Borrows(false);
    tuple.elems.iter().for_each(|element| borrows.visit_type(element));
    borrows.0.then_some(tuple)
}

struct Borrows(bool);

impl Visit<'_> for Borrows {
    fn visit_type_reference(&mut self, _: &syn::TypeReference) {
        self.0 = true;
    }

    fn visit_lifetime(&mut self, _: &syn::Lifetime) {
        self.0 = true;
    }
}
