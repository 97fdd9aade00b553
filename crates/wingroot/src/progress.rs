//! Progress on standard error; nothing is drawn with `--quiet` or when nobody looks (no terminal).
//!
//! Every command shows that it is at work, and for how long, until it shows a bar of its own or ends. What is printed
//! meanwhile goes through [`aside`], so that it does not run into the line.

use std::io::{IsTerminal, Write};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};

use crate::args::Common;

/// The line that says that a command is at work.
static AT_WORK: Mutex<Option<ProgressBar>> = Mutex::new(None);

/// Shows that a command is at work, until [`done`] or a [`bar`].
pub fn at_work(common: &Common, command: &str) {
    if common.quiet || !std::io::stderr().is_terminal() {
        return;
    }
    let line = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr());
    let style = ProgressStyle::with_template("{spinner} {msg} {elapsed}");
    line.set_style(style.unwrap_or_else(|_| ProgressStyle::default_spinner()));
    line.set_message(command.to_owned());
    line.enable_steady_tick(Duration::from_millis(200));
    *AT_WORK.lock().unwrap_or_else(PoisonError::into_inner) = Some(line);
}

/// Takes away what [`at_work`] shows.
pub fn done() {
    if let Some(line) = AT_WORK.lock().unwrap_or_else(PoisonError::into_inner).take() {
        line.finish_and_clear();
    }
}

/// Prints something while a command is at work.
pub fn aside<T>(print: impl FnOnce() -> T) -> T {
    match &*AT_WORK.lock().unwrap_or_else(PoisonError::into_inner) {
        Some(line) => line.suspend(print),
        None => print(),
    }
}

/// Standard error for the crates' events.
#[derive(Debug, Clone, Copy, Default)]
pub struct Aside;

impl Write for Aside {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        aside(|| std::io::stderr().write(bytes))
    }

    fn flush(&mut self) -> std::io::Result<()> {
        std::io::stderr().flush()
    }
}

/// A bar of so many steps with a word on what is done; `inc(1)` per step, `finish_and_clear()` at the end.
pub fn bar(common: &Common, steps: usize, doing: &str) -> ProgressBar {
    done();
    let target = if common.quiet { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
    let style = ProgressStyle::with_template("{msg:>24} [{bar:32}] {pos}/{len} {elapsed}")
        .unwrap_or_else(|_| ProgressStyle::default_bar());
    let bar =
        ProgressBar::with_draw_target(Some(steps as u64), target).with_style(style.progress_chars("=> "));
    bar.set_message(doing.to_string());
    bar
}
