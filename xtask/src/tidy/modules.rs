//! Which file takes names from which, inside one crate: `use` and paths followed through re-exports to the file that
//! defines the name. Methods are not followed, as no path names them.

use std::collections::{BTreeMap, BTreeSet};

use syn::visit::{self, Visit};

use super::parsed::Source;

/// A module's place in its crate: empty for `lib.rs`.
type Place = Vec<String>;

/// The files of a crate, by module.
pub struct Modules(BTreeMap<Place, Module>);

#[derive(Default)]
struct Module {
    file: String,
    /// Names defined in the file.
    items: BTreeSet<String>,
    imports: Vec<Import>,
    /// Paths in the code, single names included.
    paths: BTreeSet<Vec<String>>,
}

struct Import {
    path: Vec<String>,
    /// The name it has here; none: all names of a module.
    name: Option<String>,
    /// Whether it passes the name on to others, and may not need it here.
    public: bool,
}

/// What a path leads to.
enum Found {
    Module(Place),
    /// A name, defined in this module.
    Item(Place),
}

impl Modules {
    /// The modules of a crate, from its sources below `folder` (with a slash at its end).
    pub fn of(sources: &[Source], folder: &str) -> Self {
        let files = sources.iter().filter_map(|source| Some((source, source.name.strip_prefix(folder)?)));
        Self(files.map(|(source, path)| (place(path), Module::of(source))).collect())
    }

    /// From which other files each file takes names.
    pub fn taken(&self) -> BTreeMap<&str, BTreeSet<&str>> {
        let mut taken = BTreeMap::new();
        for (here, module) in &self.0 {
            let private = module.imports.iter().filter(|import| !import.public && import.name.is_some());
            let named = module.paths.iter().chain(private.map(|import| &import.path));
            let found = named.filter_map(|path| match self.find(here, path, 0)? {
                Found::Item(place) if place != *here => Some(self.0[&place].file.as_str()),
                _ => None,
            });
            taken.insert(module.file.as_str(), found.collect());
        }
        taken
    }

    fn find(&self, here: &Place, path: &[String], depth: usize) -> Option<Found> {
        // Names that pass each other on in a circle lead nowhere.
        if depth > 12 {
            return None;
        }
        match path.first()?.as_str() {
            "crate" => self.walk(&Vec::new(), &path[1..], depth),
            "self" => self.walk(here, &path[1..], depth),
            _ => self.walk(here, path, depth),
        }
    }

    fn walk(&self, here: &Place, path: &[String], depth: usize) -> Option<Found> {
        let module = self.0.get(here)?;
        let Some((first, rest)) = path.split_first() else { return Some(Found::Module(here.clone())) };
        if first == "super" {
            return self.walk(&here[..here.len().checked_sub(1)?].to_vec(), rest, depth);
        }
        let child: Place = here.iter().chain([first]).cloned().collect();
        if self.0.contains_key(&child) && !(rest.is_empty() && module.items.contains(first)) {
            return self.walk(&child, rest, depth);
        }
        if module.items.contains(first) {
            return Some(Found::Item(here.clone()));
        }
        let named = module.imports.iter().find(|import| import.name.as_ref() == Some(first));
        if let Some(import) = named {
            let onward: Vec<String> = import.path.iter().chain(rest).cloned().collect();
            // `use a::b` of another crate finds `a` neither here nor above.
            return if import.path.first() == Some(first) {
                None
            } else {
                self.find(here, &onward, depth + 1)
            };
        }
        module.imports.iter().filter(|import| import.name.is_none()).find_map(|all| {
            match self.find(here, &all.path, depth + 1)? {
                Found::Module(place) if place != *here => self.walk(&place, path, depth + 1),
                _ => None,
            }
        })
    }
}

/// The module of a file below `src`.
fn place(path: &str) -> Place {
    let path = path.trim_end_matches(".rs");
    let path = path.strip_suffix("/mod").unwrap_or(path);
    if path == "lib" { Vec::new() } else { path.split('/').map(str::to_owned).collect() }
}

impl Module {
    fn of(source: &Source) -> Self {
        let mut module = Self { file: source.name.clone(), ..Self::default() };
        module.items.extend(source.file.items.iter().filter_map(defined));
        module.visit_file(&source.file);
        module
    }

    fn import(&mut self, tree: &syn::UseTree, before: &[String], public: bool) {
        let with = |name: &syn::Ident| [before, &[name.to_string()]].concat();
        match tree {
            syn::UseTree::Path(path) => self.import(&path.tree, &with(&path.ident), public),
            syn::UseTree::Group(group) => {
                group.items.iter().for_each(|tree| self.import(tree, before, public));
            }
            syn::UseTree::Name(name) if name.ident == "self" => {
                self.imports.push(Import { path: before.to_vec(), name: before.last().cloned(), public });
            }
            syn::UseTree::Name(name) => {
                self.imports.push(Import {
                    path: with(&name.ident),
                    name: Some(name.ident.to_string()),
                    public,
                });
            }
            syn::UseTree::Rename(as_) => {
                self.imports.push(Import {
                    path: with(&as_.ident),
                    name: Some(as_.rename.to_string()),
                    public,
                });
            }
            syn::UseTree::Glob(_) => self.imports.push(Import { path: before.to_vec(), name: None, public }),
        }
    }

    /// Paths in a macro's tokens: names joined by `::`.
    fn in_tokens(&mut self, tokens: proc_macro2::TokenStream) {
        use proc_macro2::TokenTree;
        let mut path: Vec<String> = Vec::new();
        let mut joined = false;
        for token in tokens {
            match token {
                TokenTree::Ident(name) => {
                    if !joined {
                        self.paths.insert(std::mem::take(&mut path));
                    }
                    path.push(name.to_string());
                    joined = false;
                }
                TokenTree::Punct(mark) if mark.as_char() == ':' => joined = true,
                TokenTree::Group(group) => self.in_tokens(group.stream()),
                _ => joined = false,
            }
        }
        self.paths.insert(path);
    }
}

impl Visit<'_> for Module {
    fn visit_item_use(&mut self, item: &syn::ItemUse) {
        self.import(&item.tree, &[], !matches!(item.vis, syn::Visibility::Inherited));
    }

    fn visit_attribute(&mut self, _: &syn::Attribute) {}

    fn visit_path(&mut self, path: &syn::Path) {
        self.paths.insert(path.segments.iter().map(|segment| segment.ident.to_string()).collect());
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, called: &syn::Macro) {
        self.visit_path(&called.path);
        self.in_tokens(called.tokens.clone());
    }
}

/// The name that an item defines.
fn defined(item: &syn::Item) -> Option<String> {
    let name = match item {
        syn::Item::Const(item) => &item.ident,
        syn::Item::Enum(item) => &item.ident,
        syn::Item::Fn(item) => &item.sig.ident,
        syn::Item::Static(item) => &item.ident,
        syn::Item::Struct(item) => &item.ident,
        syn::Item::Trait(item) => &item.ident,
        syn::Item::Type(item) => &item.ident,
        syn::Item::Union(item) => &item.ident,
        syn::Item::Mod(item) => item.content.as_ref().map(|_| &item.ident)?,
        syn::Item::Macro(item) => item.ident.as_ref()?,
        _ => return None,
    };
    Some(name.to_string())
}
