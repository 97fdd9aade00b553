//! A document in Markdown as a page: its title, a section for each heading of the second level, links and pictures by the
//! addresses they have beside the page.

use pulldown_cmark::{CowStr, Event, HeadingLevel, Options, Parser, Tag, TagEnd, html};

use super::{Block, Page, Prose, Section};

impl Page {
    /// The page of a document; `beside` gives the address of what a link or picture names, and none for what is not there:
    /// such a link is text. HTML in the document is text, too.
    pub fn of_markdown(document: &str, beside: &dyn Fn(&str) -> Option<String>) -> Self {
        let mut page = Self { sections: vec![Section::default()], ..Self::default() };
        let mut written = Vec::new();
        let mut events = Parser::new_ext(document, Options::ENABLE_TABLES);
        // whether each link that is open stays one
        let mut linked = Vec::new();
        while let Some(event) = events.next() {
            match event {
                Event::Start(Tag::Heading { level: HeadingLevel::H1, .. }) => {
                    page.title = text_of(&mut events);
                }
                Event::Start(Tag::Heading { level: HeadingLevel::H2, .. }) => {
                    end_section(&mut page, &mut written);
                    let title = text_of(&mut events);
                    written.push(Event::Html(format!("<a id=\"{}\"></a>", anchor(&title)).into()));
                    page.sections.push(Section::new(title, Vec::new()));
                }
                Event::Html(markup) | Event::InlineHtml(markup) => written.push(Event::Text(markup)),
                Event::Start(Tag::Table(columns)) => {
                    written.push(Event::Html("<div class=\"scroll\">".into()));
                    written.push(Event::Start(Tag::Table(columns)));
                }
                Event::End(TagEnd::Table) => {
                    written.push(Event::End(TagEnd::Table));
                    written.push(Event::Html("</div>\n".into()));
                }
                Event::Start(Tag::Link { link_type, dest_url, title, id }) => {
                    let address = address(&dest_url, beside);
                    linked.push(address.is_some());
                    written.extend(
                        address.map(|dest_url| Event::Start(Tag::Link { link_type, dest_url, title, id })),
                    );
                }
                Event::End(TagEnd::Link) => written.extend(linked.pop().filter(|is| *is).map(|_| event)),
                Event::Start(Tag::Image { link_type, dest_url, title, id }) => match beside(&dest_url) {
                    Some(to) => {
                        written.push(Event::Start(Tag::Image { link_type, dest_url: to.into(), title, id }));
                    }
                    None => written.push(Event::Text(text_of(&mut events).into())),
                },
                other => written.push(other),
            }
        }
        end_section(&mut page, &mut written);
        page.sections.retain(|section| !section.blocks.is_empty());
        page
    }
}

/// Puts what was written into the last section.
fn end_section(page: &mut Page, written: &mut Vec<Event<'_>>) {
    let mut text = String::new();
    html::push_html(&mut text, written.drain(..));
    if let Some(section) = page.sections.last_mut().filter(|_| !text.trim().is_empty()) {
        section.blocks.push(Block::Prose(Prose(text)));
    }
}

/// The plain text up to the end of what has begun.
fn text_of<'a>(events: &mut impl Iterator<Item = Event<'a>>) -> String {
    let (mut text, mut depth) = (String::new(), 1);
    for event in events {
        match event {
            Event::Start(_) => depth += 1,
            Event::End(_) => depth -= 1,
            Event::Text(part) | Event::Code(part) => text.push_str(&part),
            Event::SoftBreak => text.push(' '),
            _ => {}
        }
        if depth == 0 {
            break;
        }
    }
    text
}

/// Where a link goes: to the web, to a place on the page, or to what is beside it.
fn address<'a>(to: &CowStr<'a>, beside: &dyn Fn(&str) -> Option<String>) -> Option<CowStr<'a>> {
    if to.starts_with("https://") || to.starts_with('#') {
        return Some(to.clone());
    }
    let (file, place) =
        to.split_once('#').map_or((&**to, String::new()), |(file, place)| (file, format!("#{place}")));
    beside(file).map(|file| (file + &place).into())
}

/// The name of a heading in addresses, as everywhere else where Markdown is shown.
fn anchor(title: &str) -> String {
    let kept = |c: char| match c {
        ' ' => Some('-'),
        c if c.is_alphanumeric() || c == '-' || c == '_' => Some(c),
        _ => None,
    };
    title.to_lowercase().chars().filter_map(kept).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const DOCUMENT: &str = "# A `wing` & its *data*\n\nIntro with [a link](other.md#the-end), [a file](../gone.rs), \
        [the web](https://example.org) and <b onclick=\"x()\">markup</b>.\n\n## First: `part`\n\n![a picture](p.png) \
        ![none](gone.png)\n\n| a | b |\n|---|--:|\n| 1 | <script>2</script> |\n\n### Deeper\n\n```sh\na < b\n```\n";

    #[test]
    fn headings_become_sections_and_links_go_to_what_is_there() {
        let beside = |to: &str| match to {
            "other.md" => Some("other.html".to_owned()),
            "p.png" => Some(to.to_owned()),
            _ => None,
        };
        let page = Page::of_markdown(DOCUMENT, &beside);
        assert_eq!(page.title, "A wing & its data");
        let titles: Vec<&str> = page.sections.iter().map(|section| section.title.as_str()).collect();
        assert_eq!(titles, ["", "First: part"]);
        let html = page.html().unwrap();
        for there in [
            "<a href=\"other.html#the-end\">a link</a>, a file, <a href=\"https://example.org\">",
            "<img src=\"p.png\" alt=\"a picture\" /> none",
            "<a id=\"first-part\"></a>",
            "<div class=\"scroll\"><table>",
            "a &lt; b",
        ] {
            assert!(html.contains(there), "{there}");
        }
        assert!(!html.contains("<b onclick") && !html.contains("<script"), "markup is text");
        assert!(!html.contains("What was run"), "nothing was run");
    }
}
