//! Progress on standard error; nothing is drawn with `--quiet` or when nobody looks (no terminal).
//!
//! Every command shows that it is at work, and for how long; crates that work longer say how far they are by events of target
//! `progress` with the fields `what`, `done` and `total`, which [`Bars`] turns into a bar, unless the command shows one of its
//! own ([`bar`]). What is printed meanwhile goes through [`aside`], so that it does not run into the line.

use std::fmt::Debug;
use std::io::{IsTerminal, Write};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use tracing::field::{Field, Visit};
use tracing_subscriber::Layer;
use tracing_subscriber::layer::Context;

use crate::common::Common;
use crate::said;

/// The events by which crates say how far they are.
pub const TARGET: &str = "progress";
/// A command at work, of which it is not known for how long.
const WORKING: &str = "{spinner} {msg} {elapsed}";
/// So much is done, and so much time is left.
const SHARE: &str = "{msg:>24} [{bar:32}] {percent:>3} %  {pos}/{len}  {elapsed}, {eta} left";

/// The line that says that a command is at work.
static AT_WORK: Mutex<Option<ProgressBar>> = Mutex::new(None);
/// What a command is called while a bar of its own stands in the place of that line.
static COMMAND: Mutex<Option<String>> = Mutex::new(None);

fn at_work_line() -> MutexGuard<'static, Option<ProgressBar>> {
    AT_WORK.lock().unwrap_or_else(PoisonError::into_inner)
}

/// The bar of a command that is watched by [`now`].
static WATCHED: Mutex<Option<ProgressBar>> = Mutex::new(None);

fn watched_line() -> MutexGuard<'static, Option<ProgressBar>> {
    WATCHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Shows that a command is at work, until [`done`] or a [`bar`].
pub fn at_work(common: &Common, command: &str) {
    if common.quiet || !std::io::stderr().is_terminal() {
        return;
    }
    *COMMAND.lock().unwrap_or_else(PoisonError::into_inner) = Some(command.to_owned());
    show_at_work(command);
}

fn show_at_work(command: &str) {
    let line = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr()).with_style(style(WORKING));
    line.set_message(command.to_owned());
    line.enable_steady_tick(Duration::from_millis(200));
    *at_work_line() = Some(line);
}

/// As [`at_work`] where nothing is drawn: [`now`] says how far the command is.
pub(crate) fn watched(command: &str) {
    let line = ProgressBar::with_draw_target(None, ProgressDrawTarget::hidden());
    line.set_message(command.to_owned());
    *watched_line() = Some(line.clone());
    *at_work_line() = Some(line);
}

/// How far a command run by [`crate::embedded`] is: what it does, steps done and all steps, if they are known.
pub fn now() -> Option<(String, u64, u64)> {
    let line = watched_line();
    let line = line.as_ref().filter(|line| !line.is_finished())?;
    Some((line.message(), line.position(), line.length()?))
}

/// Takes away what [`at_work`] shows.
pub fn done() {
    if let Some(line) = at_work_line().take() {
        line.finish_and_clear();
    }
}

/// Prints something while a command is at work.
pub fn aside<T>(print: impl FnOnce() -> T) -> T {
    match &*at_work_line() {
        Some(line) => line.suspend(print),
        None => print(),
    }
}

/// Standard error for the crates' events.
#[derive(Debug, Clone, Copy, Default)]
pub struct Aside;

impl Write for Aside {
    fn write(&mut self, bytes: &[u8]) -> std::io::Result<usize> {
        let text = String::from_utf8_lossy(bytes);
        let text = anstream::adapter::strip_str(text.trim_end()).to_string();
        if said::kept(|said| said.notes.push(text)) {
            return Ok(bytes.len());
        }
        aside(|| anstream::stderr().write(bytes))
    }

    fn flush(&mut self) -> std::io::Result<()> {
        anstream::stderr().flush()
    }
}

/// Takes a bar away; the command is at work as before.
pub fn end(bar: &ProgressBar) {
    bar.finish_and_clear();
    if let Some(command) = &*COMMAND.lock().unwrap_or_else(PoisonError::into_inner) {
        show_at_work(command);
    }
}

/// A bar of so many steps with a word on what is done; `inc(1)` per step, [`end`] at the end.
pub fn bar(common: &Common, steps: usize, doing: &str) -> ProgressBar {
    done();
    let mut watched = watched_line();
    let is_hidden = common.quiet || watched.is_some();
    let target = if is_hidden { ProgressDrawTarget::hidden() } else { ProgressDrawTarget::stderr() };
    let bar = ProgressBar::with_draw_target(Some(steps as u64), target).with_style(style(SHARE));
    bar.set_message(doing.to_string());
    if let Some(watched) = &mut *watched {
        *watched = bar.clone();
    }
    bar
}

fn style(template: &str) -> ProgressStyle {
    let style = ProgressStyle::with_template(template).unwrap_or_else(|_| ProgressStyle::default_bar());
    style.progress_chars("=> ")
}

/// Turns the crates' events into a bar in the place of the line that says that a command is at work.
#[derive(Debug, Clone, Copy, Default)]
pub struct Bars;

impl<S: tracing::Subscriber> Layer<S> for Bars {
    fn on_event(&self, event: &tracing::Event<'_>, _: Context<'_, S>) {
        let mut step = Step::default();
        event.record(&mut step);
        if let Some(line) = &*at_work_line() {
            if line.length() != Some(step.total) || line.message() != step.what {
                line.reset();
                line.set_style(style(SHARE));
                line.set_length(step.total);
                line.set_message(step.what);
            }
            // Threads report out of order.
            line.set_position(step.done.max(line.position()));
        }
    }
}

/// What an event says.
#[derive(Debug, Default)]
struct Step {
    what: String,
    done: u64,
    total: u64,
}

impl Visit for Step {
    fn record_str(&mut self, field: &Field, value: &str) {
        if field.name() == "what" {
            value.clone_into(&mut self.what);
        }
    }

    fn record_u64(&mut self, field: &Field, value: u64) {
        match field.name() {
            "done" => self.done = value,
            "total" => self.total = value,
            _ => {}
        }
    }

    fn record_debug(&mut self, _: &Field, _: &dyn Debug) {}
}
