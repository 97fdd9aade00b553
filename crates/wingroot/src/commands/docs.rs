//! `docs`: the documents that came with the program, as pages to read without a network.

use clap::Args;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use nastran::InputError;
use report::Page;
use report::page::Link;
use serde_json::json;

use crate::args::Common;
use crate::failure::Failure;
use crate::output::{ResultFolder, needs_pages};
use crate::show;

/// Options of `docs`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  wingroot docs
  wingroot docs guide --open

Written: a page for each document, its pictures, and report.html, which lists them. The path of the page is printed.")]
pub struct DocsArgs {
    /// The document to go to [default: the list of all]
    #[arg(value_name = "NAME")]
    name: Option<String>,
    /// Open the page in the browser
    #[arg(long)]
    open: bool,
}

/// The list of all documents.
const LIST: &str = "report.html";

/// Runs the command.
pub(crate) fn run(args: &DocsArgs, common: &Common) -> Result<(), Failure> {
    needs_pages(common, "docs")?;
    let files = shipped::documents().map_err(Failure::computation)?;
    let page = args.name.as_ref().map_or(Ok(PathBuf::from(LIST)), |name| page_named(name, &files))?;
    let folder = ResultFolder::begin(&common.out("docs"))?;
    let mut documents = Vec::new();
    for (path, bytes) in &files {
        let Some(to) = page_of(path) else {
            folder.write_bytes(&address(path), bytes)?;
            continue;
        };
        let mut page = Page::of_markdown(&String::from_utf8_lossy(bytes), &|to| beside(path, to, &files));
        page.command = "docs".into();
        let up = "../".repeat(path.components().count() - 1);
        page.around = vec![Link { text: "All documents".into(), to: up + LIST, note: String::new() }];
        folder.write_text(&address(&to), &page.html().map_err(Failure::computation)?)?;
        documents.push(
            json!({ "name": address(&path.with_extension("")), "title": page.title, "page": address(&to) }),
        );
    }
    let result = json!({ "command": "docs", "documents": documents });
    folder.write_json("result.json", &result)?;
    let path = folder.commit()?.join(page);
    show::summary(common, &path.display().to_string());
    if args.open
        && let Err(error) = open::that_detached(&path)
    {
        show::note(&format!("no browser could be started ({error}): open the page by its path"));
    }
    show::json(common, &result)
}

/// The page of a document; none for a picture.
fn page_of(path: &Path) -> Option<PathBuf> {
    path.extension().is_some_and(|ending| ending == "md").then(|| path.with_extension("html"))
}

/// The page of the document of this name, with or without its ending.
fn page_named(name: &str, files: &BTreeMap<PathBuf, Vec<u8>>) -> Result<PathBuf, InputError> {
    let path = PathBuf::from(format!("{}.md", name.strip_suffix(".md").unwrap_or(name)));
    if files.contains_key(&path) {
        return Ok(path.with_extension("html"));
    }
    let names: Vec<String> =
        files.keys().filter(|path| page_of(path).is_some()).map(|p| address(&p.with_extension(""))).collect();
    Err(InputError::general(format!("there is no document {name}"))
        .with_help(format!("the documents are {}", names.join(", "))))
}

/// Where a link of a document leads: to the page of another, or to a picture; none for what did not come with the program.
fn beside(document: &Path, to: &str, files: &BTreeMap<PathBuf, Vec<u8>>) -> Option<String> {
    let found = files.contains_key(&document.with_file_name(to));
    found.then(|| page_of(Path::new(to)).map_or_else(|| to.to_owned(), |page| address(&page)))
}

/// A relative path as written in addresses.
fn address(path: &Path) -> String {
    path.components().map(|part| part.as_os_str().to_string_lossy()).collect::<Vec<_>>().join("/")
}
