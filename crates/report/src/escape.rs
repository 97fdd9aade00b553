//! Text without the characters that mean something in the languages that pages and pictures are written in.

/// For plotly, which reads some HTML in texts; unlike a browser it leaves quotes as they are written.
pub(crate) fn for_plotly(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

/// For XML: text or an attribute in double quotes.
pub(crate) fn for_xml(text: &str) -> String {
    for_plotly(text).replace('"', "&quot;")
}

/// For HTML: text or an attribute in quotes of either kind.
pub(crate) fn for_html(text: &str) -> String {
    for_xml(text).replace('\'', "&#39;")
}

#[cfg(test)]
mod tests {
    #[test]
    fn text_cannot_break_the_document() {
        assert_eq!(super::for_html("a<b> & \"c's\""), "a&lt;b&gt; &amp; &quot;c&#39;s&quot;");
    }
}
