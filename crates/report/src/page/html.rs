//! A [`Page`] as an HTML document.

use super::markup::Markup;
use super::{
    Block, Content, Input, Judgement, KeyNumber, Link, Page, PageTable, Plate, curves, script, shapes,
};
use crate::drawing::Drawing;
use crate::error::DrawError;

const STYLE: &str = include_str!("style.css");
const SCRIPT: &str = include_str!("page.js");
/// The page loads nothing from anywhere but pictures beside it: browsers are told to refuse it.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src 'self' file: data: blob:";
/// Points of all curves of a page together, about: some 8 MB.
const POINTS: usize = 600_000;
/// Points of one curve at most, and at least.
const CURVE: (usize, usize) = (2000, 300);

impl Page {
    /// The page as a document of its own.
    ///
    /// # Errors
    /// If a figure cannot be drawn: x and y of a series have different lengths.
    pub fn html(&self) -> Result<String, DrawError> {
        let mut page = Markup::default();
        page.raw("<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n");
        page.open("meta", &[("http-equiv", "Content-Security-Policy"), ("content", POLICY)]);
        page.open("meta", &[("name", "viewport"), ("content", "width=device-width, initial-scale=1")]);
        page.open("link", &[("rel", "icon"), ("href", "data:,")]);
        page.element("title", &[], &format!("{} - {}", self.command, self.title));
        page.raw("<style>\n");
        page.raw(STYLE);
        page.raw("</style>\n</head>\n<body>\n<main>\n");
        self.head(&mut page);
        let limit = self.points_a_curve();
        for (number, section) in self.sections.iter().enumerate() {
            page.open("section", &[("id", &format!("part-{number}"))]);
            if !section.title.is_empty() {
                page.element("h2", &[], &section.title);
            }
            for block in &section.blocks {
                write_block(&mut page, block, limit)?;
            }
            page.close("section");
        }
        if !self.is_document() {
            self.origin(&mut page);
        }
        page.raw("</main>\n");
        if self.plates().any(|plate| !matches!(plate.content, Content::Pictures(_))) {
            page.raw(&script::plotly());
            page.raw("\n<script>\n");
            page.raw(SCRIPT);
            page.raw("</script>\n");
        }
        page.raw("</body>\n</html>\n");
        Ok(page.finish())
    }

    fn plates(&self) -> impl Iterator<Item = &Plate> {
        self.sections.iter().flat_map(|section| &section.blocks).filter_map(|block| match block {
            Block::Plate(plate) => Some(&**plate),
            _ => None,
        })
    }

    fn points_a_curve(&self) -> usize {
        let curves = |plate: &Plate| match &plate.content {
            Content::Curves(figure) => figure.panels.iter().map(|panel| panel.series.len()).sum(),
            _ => 0,
        };
        let all: usize = self.plates().map(curves).sum();
        (POINTS / all.max(1)).clamp(CURVE.1, CURVE.0)
    }

    fn head(&self, page: &mut Markup) {
        page.open("header", &[]);
        page.element("p", &[("class", "command")], &format!("wingroot {}", self.command));
        page.element("h1", &[], &self.title);
        for sentence in &self.lead {
            page.element("p", &[("class", "lead")], sentence);
        }
        if !self.numbers.is_empty() {
            page.open("dl", &[("class", "numbers")]);
            self.numbers.iter().for_each(|number| write_number(page, number));
            page.close("dl");
        }
        page.open("nav", &[]);
        for link in &self.around {
            page.element("a", &[("href", &address(&link.to))], &link.text);
        }
        for (number, section) in
            self.sections.iter().enumerate().filter(|(_, section)| !section.title.is_empty())
        {
            page.element("a", &[("href", &format!("#part-{number}"))], &section.title);
        }
        if !self.is_document() {
            page.element("a", &[("href", "#origin")], "Inputs");
        }
        page.close("nav");
        page.close("header");
    }

    /// Whether nothing was run for it.
    fn is_document(&self) -> bool {
        self.run.is_empty() && self.inputs.is_empty()
    }

    /// What was run, and on what.
    fn origin(&self, page: &mut Markup) {
        page.open("section", &[("id", "origin")]);
        page.element("h2", &[], "What was run, on which inputs");
        for (what, value) in &self.run {
            page.open("p", &[]);
            page.text(&format!("{what}: "));
            page.element("code", &[], value);
            page.close("p");
        }
        if !self.inputs.is_empty() {
            write_inputs(page, &self.inputs);
        }
        page.close("section");
    }
}

fn write_number(page: &mut Markup, number: &KeyNumber) {
    let class = match number.judgement {
        Judgement::Plain => "number",
        Judgement::Good => "number good",
        Judgement::Doubtful => "number doubtful",
    };
    page.open("div", &[("class", class)]);
    page.element("dt", &[], &number.label);
    page.element("dd", &[("class", "value")], &number.value);
    if !number.note.is_empty() {
        page.element("dd", &[("class", "note")], &number.note);
    }
    page.close("div");
}

fn write_inputs(page: &mut Markup, inputs: &[Input]) {
    page.element(
        "p",
        &[("class", "caption")],
        "The fingerprint (FNV-1a, 64 bits) changes with the content of a file, or of any file of a folder.",
    );
    page.raw("<div class=\"scroll\"><table>\n<thead><tr><th>input</th><th>file or folder</th><th>fingerprint</th></tr></thead>\n<tbody>\n");
    for input in inputs {
        page.open("tr", &[]);
        page.element("td", &[], &input.what);
        page.element("td", &[], &input.path);
        page.element("td", &[("class", "hash")], &input.fingerprint);
        page.close("tr");
    }
    page.raw("</tbody></table></div>\n");
}

fn write_block(page: &mut Markup, block: &Block, limit: usize) -> Result<(), DrawError> {
    match block {
        Block::Text(text) => page.element("p", &[], text),
        Block::Prose(prose) => page.raw(&prose.0),
        Block::Table(table) => write_table(page, table),
        Block::Links(links) => write_links(page, links),
        Block::Plate(plate) => write_plate(page, plate, limit)?,
    }
    Ok(())
}

fn write_table(page: &mut Markup, table: &PageTable) {
    let numeric = |column: usize| {
        let cells = || table.rows.iter().filter_map(|row| row.get(column)).filter(|cell| !cell.is_empty());
        cells().next().is_some() && cells().all(|cell| looks_like_a_number(cell))
    };
    let classes: Vec<&str> = (0..table.head.len()).map(|c| if numeric(c) { "n" } else { "t" }).collect();
    // beside the box that scrolls, so that it is read whole on a narrow window
    if !table.caption.is_empty() {
        page.element("p", &[("class", "caption")], &table.caption);
    }
    page.raw("<div class=\"scroll\"><table>\n");
    let row = |page: &mut Markup, tag: &'static str, cells: &[String]| {
        page.raw("<tr>");
        for (column, cell) in cells.iter().enumerate() {
            page.element(tag, &[("class", classes.get(column).copied().unwrap_or("t"))], cell);
        }
        page.raw("</tr>\n");
    };
    page.raw("<thead>");
    row(page, "th", &table.head);
    page.raw("</thead>\n<tbody>\n");
    for cells in &table.rows {
        row(page, "td", cells);
    }
    page.raw("</tbody></table></div>\n");
}

/// Whether a cell is a number, with or without a unit, or a dash for none.
fn looks_like_a_number(cell: &str) -> bool {
    let first = cell.split_whitespace().next().unwrap_or_default();
    first == "-" || first.trim_end_matches('%').parse::<f64>().is_ok()
}

fn write_links(page: &mut Markup, links: &[Link]) {
    page.open("ul", &[("class", "links")]);
    for link in links {
        page.open("li", &[]);
        page.element("a", &[("href", &address(&link.to))], &link.text);
        page.element("span", &[], &link.note);
        page.close("li");
    }
    page.close("ul");
}

fn write_plate(page: &mut Markup, plate: &Plate, limit: usize) -> Result<(), DrawError> {
    if plate.folded {
        page.open("details", &[("id", &plate.name)]);
        page.element("summary", &[], &plate.title);
    } else {
        page.element("h3", &[("id", &plate.name)], &plate.title);
    }
    let class = if matches!(plate.content, Content::Shapes(..)) { "shapes" } else { "" };
    page.open("figure", &[("class", class)]);
    match &plate.content {
        Content::Curves(figure) => {
            let size = [figure.panels.len(), curves::columns(figure)].map(|count| count.to_string());
            write_plot(
                page,
                &[("data-panels", &size[0]), ("data-columns", &size[1])],
                &curves::data(figure, limit)?,
            );
        }
        Content::Pictures(drawings) => write_pictures(page, "picture", drawings),
        Content::Shapes(views, drawing) => {
            write_plot(page, &[], &shapes::data(views));
            write_pictures(page, "picture on-paper", std::slice::from_ref(drawing));
        }
    }
    page.open("figcaption", &[]);
    page.text(&plate.caption);
    page.open("span", &[("class", "files")]);
    for file in &plate.files {
        let ending = |file: &str| file.rsplit('.').next().unwrap_or(file).to_uppercase();
        let alone = plate.files.iter().filter(|other| ending(other) == ending(file)).count() == 1;
        let shown = if alone { ending(file) } else { file.clone() };
        page.element("a", &[("href", &address(file)), ("title", file)], &shown);
    }
    page.close("span");
    page.close("figcaption");
    page.close("figure");
    if plate.folded {
        page.close("details");
    }
    Ok(())
}

/// A relative path as an address: what would begin a query or a place in a page, or a scheme, is written as its code.
fn address(path: &str) -> String {
    path.replace('%', "%25").replace('#', "%23").replace('?', "%3F").replace(':', "%3A")
}

/// Where `page.js` draws, and what.
fn write_plot(page: &mut Markup, size: &[(&'static str, &str)], data: &serde_json::Value) {
    page.element("div", &[&[("class", "plot")], size].concat(), "");
    page.data(data);
}

fn write_pictures(page: &mut Markup, class: &str, drawings: &[Drawing]) {
    page.open("div", &[("class", class)]);
    for drawing in drawings {
        page.raw(&drawing.svg());
    }
    page.close("div");
}
