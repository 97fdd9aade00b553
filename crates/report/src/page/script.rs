//! plotly's script (MIT), from the crate `plotly`, which carries it for use without a network. No other file knows where
//! it comes from.

/// The script element. The crate adds a second one that typesets mathematics (2 MB), which is left out: no label has any.
pub(super) fn plotly() -> String {
    const END: &str = "</script>";
    let mut both = plotly::Plot::offline_js_sources();
    let end = both.find(END).map_or(both.len(), |place| place + END.len());
    both.truncate(end);
    both
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_script_is_one_element_and_is_plotly() {
        let script = super::plotly();
        assert!(script.starts_with("<script"), "{}", &script[..80]);
        assert!(script[..200].contains("plotly.js v3"), "{}", &script[..200]);
        assert_eq!(script.matches("</script").count(), 1);
        // the second script alone has two megabytes
        assert!((3_000_000..5_500_000).contains(&script.len()), "{}", script.len());
    }
}
