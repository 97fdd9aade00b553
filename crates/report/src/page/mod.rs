//! One page a command: `report.html`, self-contained, with the numbers that matter first, curves one can zoom and hide,
//! pictures, and shapes in space one can turn.
//!
//! A page is data ([`Page`]); how it looks is in `style.css`, what it does in `page.js`, and both are written into it
//! with plotly's script, so that it opens without a network. Every text is escaped where it is written (`markup.rs`).

mod curves;
mod html;
mod markup;
mod prose;
mod script;
mod shapes;

use crate::deformed::View;
use crate::drawing::Drawing;
use crate::figure::Figure;

/// How a number is to be read.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Judgement {
    /// Neither good nor bad.
    #[default]
    Plain,
    /// As it should be.
    Good,
    /// To be looked at.
    Doubtful,
}

/// A number that matters, shown large at the top.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct KeyNumber {
    /// What it is, in a few words.
    pub label: String,
    /// The number with its unit.
    pub value: String,
    /// What to compare it with, or what it means; may be empty.
    pub note: String,
    /// Good, doubtful or neither.
    pub judgement: Judgement,
}

impl KeyNumber {
    /// A number without a judgement.
    pub fn new(label: impl Into<String>, value: impl Into<String>, note: impl Into<String>) -> Self {
        Self { label: label.into(), value: value.into(), note: note.into(), judgement: Judgement::Plain }
    }

    /// The same, judged.
    #[must_use]
    pub fn judged(self, good: bool) -> Self {
        Self { judgement: if good { Judgement::Good } else { Judgement::Doubtful }, ..self }
    }
}

/// A table; cells that are numbers are set to the right.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct PageTable {
    /// What the rows are; may be empty.
    pub caption: String,
    /// Heads of the columns.
    pub head: Vec<String>,
    /// Rows, each as long as the head.
    pub rows: Vec<Vec<String>>,
}

impl PageTable {
    /// A table without rows.
    pub fn new(caption: impl Into<String>, head: &[&str]) -> Self {
        let head = head.iter().map(ToString::to_string).collect();
        Self { caption: caption.into(), head, rows: Vec::new() }
    }

    /// Adds a row.
    pub fn row(&mut self, cells: impl IntoIterator<Item = impl Into<String>>) {
        self.rows.push(cells.into_iter().map(Into::into).collect());
    }
}

/// Where a link goes and what it says.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Link {
    /// What it says.
    pub text: String,
    /// A relative path.
    pub to: String,
    /// A sentence after it; may be empty.
    pub note: String,
}

/// What a figure, picture or shape shows.
#[derive(Debug, Clone)]
pub enum Content {
    /// Curves that can be zoomed and hidden.
    Curves(Figure),
    /// Still pictures side by side, below one another where the window is narrow; without titles of their own.
    Pictures(Vec<Drawing>),
    /// Shapes in space that can be turned, one view over the other; the picture is printed in their place.
    Shapes(Vec<View>, Drawing),
}

/// A figure with its files beside the page.
#[derive(Debug, Clone)]
pub struct Plate {
    /// Name of its files without ending; also its anchor.
    pub name: String,
    /// Title above it.
    pub title: String,
    /// What is seen in it; may be empty.
    pub caption: String,
    /// What it shows.
    pub content: Content,
    /// The same as files: relative paths.
    pub files: Vec<String>,
    /// Whether it is folded up until it is asked for.
    pub folded: bool,
}

/// Text that was written in Markdown, as HTML; only `prose.rs` makes one, so that no markup of a user's gets into a page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Prose(String);

/// A part of a page.
#[derive(Debug, Clone)]
pub enum Block {
    /// A paragraph.
    Text(String),
    /// A document or a part of one.
    Prose(Prose),
    /// A table.
    Table(PageTable),
    /// A figure.
    Plate(Box<Plate>),
    /// Links to other pages.
    Links(Vec<Link>),
}

/// Blocks under a heading.
#[derive(Debug, Clone, Default)]
pub struct Section {
    /// The heading.
    pub title: String,
    /// What stands below it.
    pub blocks: Vec<Block>,
}

impl Section {
    /// A section from its blocks.
    pub fn new(title: impl Into<String>, blocks: Vec<Block>) -> Self {
        Self { title: title.into(), blocks }
    }
}

/// A file or folder the command read.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Input {
    /// What it is: `wing`, `campaign`.
    pub what: String,
    /// Where it is.
    pub path: String,
    /// Fingerprint of its content.
    pub fingerprint: String,
}

/// A whole page.
#[derive(Debug, Clone, Default)]
pub struct Page {
    /// The command, small above the title.
    pub command: String,
    /// The title.
    pub title: String,
    /// Pages that belong to it, before its own sections.
    pub around: Vec<Link>,
    /// What came out, in a sentence or a few.
    pub lead: Vec<String>,
    /// Numbers that matter.
    pub numbers: Vec<KeyNumber>,
    /// Everything else, in order.
    pub sections: Vec<Section>,
    /// What was read.
    pub inputs: Vec<Input>,
    /// The line that was run, and the version that ran it.
    pub run: Vec<(String, String)>,
}
