//! Progress bars on standard error; nothing is drawn with `--quiet` or when nobody looks (no terminal).

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::args::Common;

/// A bar of so many steps with a word on what is done; `inc(1)` per step, `finish_and_clear()` at the end.
pub fn bar(common: &Common, steps: usize, doing: &str) -> ProgressBar {
    let target = if common.quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
    let style = ProgressStyle::with_template("{msg:>24} [{bar:32}] {pos}/{len} {elapsed}")
        .unwrap_or_else(|_| ProgressStyle::default_bar());
    let bar =
        ProgressBar::with_draw_target(Some(steps as u64), target).with_style(style.progress_chars("=> "));
    bar.set_message(doing.to_string());
    bar
}
