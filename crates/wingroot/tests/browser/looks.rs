//! How a page looks: on narrow windows, in the dark and on paper.

use std::path::Path;

use serde_json::{Value, json};

use super::{Browser, draw_all, wait};

/// Windows: width, px, and scheme of colours of a screen, a tablet and a phone.
pub(crate) const SCREENS: [(u64, &str); 3] = [(1400, "light"), (800, "dark"), (390, "light")];
/// The least contrast of curves with the background, and of words (WCAG 2, level AA).
const CONTRAST: [f64; 2] = [3.0, 4.5];
/// Sheets are not wider, px.
const SHEET: f64 = 690.0;

/// Opens a page on screens and comes past all of its figures: it fits, and in the dark it is readable.
pub(crate) fn on_screens(browser: &Browser, page: &Path, screens: &[(u64, &str)]) {
    for (width, scheme) in screens {
        let name = format!("{} at {width} px", page.display());
        browser.resize(*width);
        browser.prefer(scheme);
        browser.open(page);
        draw_all(browser, &name);
        fits(browser, &name, *width);
        if *scheme == "dark" {
            is_readable_in_the_dark(browser, &format!("{name} in the dark"));
        }
    }
    browser.prefer("light");
    browser.resize(1200);
}

/// Nothing on a drawn page is wider than the window, no panel overlaps another, and the buttons of a figure do not lie over its names.
pub(crate) fn fits(browser: &Browser, name: &str, width: u64) {
    let wide = browser.script("return document.documentElement.scrollWidth").as_u64();
    assert!(wide <= Some(width), "{name} is {wide:?} px wide");
    let wrong = browser.script(&format!(
        "const wrong = [], box = e => e.getBoundingClientRect(); \
         const apart = (a, b) => a.right <= b.left + 1 || b.right <= a.left + 1 || a.bottom <= b.top + 1 || b.bottom <= a.top + 1; \
         for (const p of document.querySelectorAll('.plot[data-drawn]')) {{ \
           if (!p.offsetParent) continue; \
           const legend = p.querySelector('.legend'), buttons = p.querySelector('.modebar'); \
           if (legend && buttons && !apart(box(legend), box(buttons))) wrong.push('buttons over names'); \
           const boxes = Array.from(p.querySelectorAll('.cartesianlayer .plot')).map(box); \
           boxes.forEach((a, i) => boxes.slice(i + 1).forEach(b => {{ if (!apart(a, b)) wrong.push('panels overlap'); }})); \
           if (box(p).right > {width} || p.querySelector('.main-svg').clientWidth > {width}) wrong.push('wider than the window'); \
         }} return Array.from(new Set(wrong));"
    ));
    assert_eq!(wrong, json!([]), "{name}");
}

/// The background of a drawn page is dark, and curves and words can be told from it, as the browser paints them.
fn is_readable_in_the_dark(browser: &Browser, name: &str) {
    // colours through the filter of their figure, painted by the browser itself
    let seen = browser.script(
        "const canvas = document.createElement('canvas'), c = canvas.getContext('2d', { willReadFrequently: true }); \
         const painted = (colour, filter) => { c.filter = filter || 'none'; c.fillStyle = colour; c.fillRect(0, 0, 9, 9); \
           return Array.from(c.getImageData(4, 4, 1, 1).data).slice(0, 3); }; \
         const words = Array.from(document.querySelectorAll('h1, h2, p, td, th, dd, dt, summary, figcaption, a')) \
           .filter(e => e.offsetParent).map(e => painted(getComputedStyle(e).color)); \
         const figures = Array.from(document.querySelectorAll('.plot[data-drawn]')).filter(p => p.offsetParent); \
         const of = (p, e, key) => painted(getComputedStyle(e)[key], getComputedStyle(p).filter); \
         const all = (selector, key) => figures.flatMap(p => Array.from(p.querySelectorAll(selector)).map(e => of(p, e, key))); \
         return { ground: painted(getComputedStyle(document.body).backgroundColor), words, \
           letters: all('.legendtext, .xtitle, .ytitle, .xtick text', 'fill'), curves: all('.scatterlayer .js-line', 'stroke') };",
    );
    let ground = luminance(&seen["ground"]);
    assert!(ground < 0.05, "{name}: the background is no dark one ({})", seen["ground"]);
    for (kind, least) in [("words", CONTRAST[1]), ("letters", CONTRAST[1]), ("curves", CONTRAST[0])] {
        for colour in seen[kind].as_array().into_iter().flatten() {
            let contrast = (luminance(colour) + 0.05) / (ground + 0.05);
            assert!(contrast >= least, "{name}: {kind} of colour {colour} have a contrast of {contrast:.1}");
        }
    }
}

/// Relative luminance of a colour (WCAG 2).
fn luminance(rgb: &Value) -> f64 {
    let channel = |i: usize| {
        let share = rgb[i].as_f64().expect("a colour") / 255.0;
        if share <= 0.040_45 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) }
    };
    0.2126 * channel(0) + 0.7152 * channel(1) + 0.0722 * channel(2)
}

/// Prints a page: every figure, folded ones too, is drawn and as wide as the sheet; afterwards the page is as before.
pub(crate) fn prints_whole(browser: &Browser, page: &Path) {
    let name = format!("{} on paper", page.display());
    browser.open(page);
    let folded = "document.querySelectorAll('details:not([open])').length";
    let before = browser.script(&format!("return {folded}"));
    // after the page's own listener, so that what it did is seen
    browser.script(
        "addEventListener('beforeprint', () => { \
           const flat = Array.from(document.querySelectorAll('figure:not(.shapes) > .plot')); \
           window.printed = { figures: flat.length, drawn: flat.filter(p => p.querySelector('.main-svg') && p.checkVisibility()).length, \
             width: Math.max(0, ...flat.map(p => p.querySelector('.main-svg') ? +p.querySelector('.main-svg').getAttribute('width') : 0)) }; })",
    );
    let sheets = browser.print();
    wait(&format!("{name}: it was printed"), || browser.script("return Boolean(window.printed)") == true);
    let printed = browser.script("return window.printed");
    assert_eq!(printed["drawn"], printed["figures"], "{name}: figures are missing");
    assert!(printed["width"].as_f64() <= Some(SHEET), "{name}: a figure is {} px wide", printed["width"]);
    assert!(sheets > 1000, "{name}: nothing was printed");
    assert_eq!(browser.script(&format!("return {folded}")), before, "{name}: figures stay unfolded");
    // shapes in space are printed as pictures
    browser.emulate_paper(true);
    let shapes = browser.script(
        "return Array.from(document.querySelectorAll('.shapes')).every(f => f.querySelector('.on-paper').offsetHeight > 50 && !f.querySelector('.plot').offsetHeight)",
    );
    browser.emulate_paper(false);
    assert_eq!(shapes, true, "{name}: shapes are missing");
}
