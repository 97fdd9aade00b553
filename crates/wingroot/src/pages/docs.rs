//! The page of `docs`: the list of documents.

use report::Page;
use report::page::{Block, Link, Plate, Section};
use serde_json::Value;

use super::values::{list, text};

pub(super) fn page(result: &Value, _: &mut Vec<Plate>) -> Page {
    let link = |document: &Value| Link {
        text: text(document, "title").into(),
        to: text(document, "page").into(),
        note: format!("wingroot docs {}", text(document, "name")),
    };
    let links = list(result, "documents").iter().map(link).collect();
    Page {
        title: "Documents of wingroot".into(),
        lead: vec!["What came with this program; nothing here needs a network.".into()],
        sections: vec![Section::new("Documents", vec![Block::Links(links)])],
        ..Page::default()
    }
}
