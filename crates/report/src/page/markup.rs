//! HTML in the making. Text and attributes are escaped here and nowhere else: what a caller hands over as text comes out
//! as text, whatever it contains.

use crate::escape::for_html;

/// An HTML document or a part of one.
#[derive(Debug, Default)]
pub(super) struct Markup {
    body: String,
}

impl Markup {
    /// `<tag attributes>`.
    pub(super) fn open(&mut self, tag: &'static str, attributes: &[(&'static str, &str)]) {
        self.raw(&format!("<{tag}"));
        for (name, value) in attributes {
            self.raw(&format!(" {name}=\"{}\"", for_html(value)));
        }
        self.raw(">");
    }

    /// `</tag>`.
    pub(super) fn close(&mut self, tag: &'static str) {
        self.raw(&format!("</{tag}>\n"));
    }

    /// Text.
    pub(super) fn text(&mut self, text: &str) {
        self.raw(&for_html(text));
    }

    /// `<tag attributes>text</tag>`.
    pub(super) fn element(&mut self, tag: &'static str, attributes: &[(&'static str, &str)], text: &str) {
        self.open(tag, attributes);
        self.text(text);
        self.close(tag);
    }

    /// Our own pictures, style and scripts, which are no text.
    pub(super) fn raw(&mut self, markup: &str) {
        self.body.push_str(markup);
    }

    /// Data for the page's script: no `<` can end the element early.
    pub(super) fn data(&mut self, json: &serde_json::Value) {
        self.open("script", &[("type", "application/json")]);
        let text = json.to_string();
        self.body.push_str(&text.replace('<', "\\u003c").replace('>', "\\u003e").replace('&', "\\u0026"));
        self.close("script");
    }

    /// The whole.
    pub(super) fn finish(self) -> String {
        self.body
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn text_and_attributes_stay_text() {
        let mut markup = Markup::default();
        markup.element("p", &[("title", "\"><b>")], "<script>alert('1')</script> & more");
        assert_eq!(
            markup.finish(),
            "<p title=\"&quot;&gt;&lt;b&gt;\">&lt;script&gt;alert(&#39;1&#39;)&lt;/script&gt; &amp; more</p>\n"
        );
    }

    #[test]
    fn data_cannot_end_their_element() {
        let mut markup = Markup::default();
        markup.data(&serde_json::json!({ "name": "</script><b>&" }));
        let text = markup.finish();
        assert_eq!(text.matches("</script>").count(), 1);
        let json = text.split_once('>').unwrap().1.rsplit_once("</script>").unwrap().0;
        let value: serde_json::Value = serde_json::from_str(json).unwrap();
        assert_eq!(value["name"], "</script><b>&");
    }
}
