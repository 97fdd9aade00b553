//! Results are written whole or not at all.
//!
//! A command writes into a hidden folder beside its target; [`ResultFolder::commit`] puts that in the target's
//! place by renaming. A command that fails or is interrupted leaves the earlier result as it was. Only what wingroot wrote is
//! replaced ([`MARKER`]): a folder with any other file in it stops the command.
//!
//! What is written is remembered: figures become PNG and CSV beside their SVG, and all of it with `result.json` and the
//! inputs becomes `report.html`, without a command having to know how a page is made. With `--numbers-only` nothing is drawn:
//! of figures their CSV stays.

use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, PoisonError};

use nastran::InputError;
use rayon::prelude::*;
use report::deformed::{self, View};
use report::page::{Content, Plate};
use report::{Drawing, Figure, PlanformView, heatmap};
use serde::Serialize;

mod marker;

use marker::refused;
pub use marker::{MARKER, check_replaceable};

use crate::common::Common;
use crate::failure::Failure;
use crate::nulls;
use crate::pages::{self, Written};

/// The file with a command's numbers.
const RESULT: &str = "result.json";

/// Whether nothing is drawn.
static NUMBERS_ONLY: AtomicBool = AtomicBool::new(false);

/// Takes `--numbers-only` for all results of this process.
pub fn start(common: &Common) {
    NUMBERS_ONLY.store(common.numbers_only, Ordering::Relaxed);
}

/// Refuses `--numbers-only` for a command whose results are pages.
///
/// # Errors
/// If it is given.
pub fn needs_pages(common: &Common, command: &str) -> Result<(), Failure> {
    if !common.numbers_only {
        return Ok(());
    }
    let message = format!("the results of `{command}` are pages: there is nothing left with --numbers-only");
    Err(InputError::general(message).with_help("leave --numbers-only out").into())
}

/// Results in the making. Dropped without [`commit`](Self::commit) it leaves nothing behind.
#[derive(Debug)]
pub struct ResultFolder {
    target: PathBuf,
    partial: PathBuf,
    written: Mutex<Written>,
}

impl ResultFolder {
    /// Starts the results that will stand at `target`.
    ///
    /// # Errors
    /// If `target` is something else than an earlier result or an empty folder, which nothing here may delete; or if no folder
    /// can be made beside it.
    pub fn begin(target: &Path) -> Result<Self, Failure> {
        let target = std::path::absolute(target).map_err(|e| refused(target, &e))?;
        check_replaceable(&target)?;
        let parent = target
            .parent()
            .ok_or_else(|| InputError::in_file(&target, "results need a folder of their own"))?;
        std::fs::create_dir_all(parent).map_err(|e| refused(parent, &e))?;
        clear_leftovers(&target);
        let partial = beside(&target, "partial");
        std::fs::create_dir_all(&partial).map_err(|e| refused(&partial, &e))?;
        Ok(Self { target, partial, written: Mutex::default() })
    }

    /// Says who makes the head of the report, for a command that is not one of this crate's.
    #[must_use]
    pub fn with_head(self, head: pages::Head) -> Self {
        self.remember(|written| written.head = Some(head));
        self
    }

    /// The folder to write into until [`commit`](Self::commit).
    pub fn path(&self) -> &Path {
        &self.partial
    }

    /// Writes a text file; `name` may contain folders.
    ///
    /// # Errors
    /// If the file cannot be written, or a file of numbers (CSV, RON, cards, ParaView) has one that is not finite.
    pub fn write_text(&self, name: &str, text: &str) -> Result<(), Failure> {
        check_finite(name, text)?;
        self.write_bytes(name, text.as_bytes())
    }

    /// Writes a text file of any length, line by line.
    ///
    /// # Errors
    /// As [`write_text`](Self::write_text), and what a line says that could not be made.
    pub fn write_lines(
        &self,
        name: &str,
        lines: impl Iterator<Item = Result<String, Failure>>,
    ) -> Result<(), Failure> {
        let path = self.partial.join(name);
        let file = std::fs::File::create(&path).map_err(|e| refused(&path, &e))?;
        let mut file = std::io::BufWriter::new(file);
        for line in lines {
            let line = line?;
            check_finite(name, &line)?;
            file.write_all(line.as_bytes()).map_err(|e| refused(&path, &e))?;
        }
        file.flush().map_err(|e| refused(&path, &e))
    }

    /// Writes a file of any kind; `name` may contain folders.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write_bytes(&self, name: &str, bytes: &[u8]) -> Result<(), Failure> {
        let path = self.partial.join(name);
        if let Some(folder) = path.parent() {
            std::fs::create_dir_all(folder).map_err(|e| refused(folder, &e))?;
        }
        std::fs::write(&path, bytes).map_err(|e| refused(&path, &e))
    }

    /// Writes a value as JSON.
    ///
    /// # Errors
    /// If the file cannot be written, or the value holds a number that is not finite where the format does not say what
    /// the `null` in its place would mean ([`crate::nulls`]).
    pub fn write_json<T: Serialize>(&self, name: &str, value: &T) -> Result<(), Failure> {
        let text = serde_json::to_string_pretty(value).map_err(Failure::computation)?;
        let result = serde_json::to_value(value).map_err(Failure::computation)?;
        if let Some(key) = nulls::missing(&result) {
            return Err(Failure::Computation(format!(
                "{name} would hold no finite number at `{key}`, which is no result: nothing is written"
            )));
        }
        if name == RESULT {
            self.remember(|written| written.result = result);
        }
        self.write_text(name, &(text + "\n"))
    }

    /// Writes a figure as `NAME.svg`, `NAME.png` and `NAME_curves.csv`, and shows it in the report.
    ///
    /// # Errors
    /// If it cannot be drawn or written.
    pub fn write_figure(&self, name: &str, caption: &str, figure: Figure) -> Result<(), Failure> {
        let curves = format!("{name}_curves.csv");
        self.write_text(&curves, &figure.csv())?;
        self.write_figure_of(name, caption, figure, &curves)
    }

    /// The same for a figure whose curves are in a file already.
    ///
    /// # Errors
    /// If it cannot be drawn or written.
    pub fn write_figure_of(
        &self,
        name: &str,
        caption: &str,
        figure: Figure,
        curves: &str,
    ) -> Result<(), Failure> {
        if NUMBERS_ONLY.load(Ordering::Relaxed) {
            return Ok(());
        }
        let drawing = figure.draw().map_err(Failure::computation)?;
        let title = figure.title.clone();
        self.write_plate(name, &title, caption, Content::Curves(figure), drawing, &[curves.to_owned()])
    }

    /// Writes planforms side by side as `NAME.svg` and `NAME.png`, and shows each for itself in the report, which puts them
    /// below one another where there is no room.
    ///
    /// # Errors
    /// If they cannot be drawn or written.
    pub fn write_planforms(
        &self,
        name: &str,
        title: &str,
        caption: &str,
        views: &[PlanformView],
    ) -> Result<(), Failure> {
        if NUMBERS_ONLY.load(Ordering::Relaxed) {
            return Ok(());
        }
        let drawing = heatmap::draw(title, views).map_err(Failure::computation)?;
        let alone = |view| heatmap::draw("", std::slice::from_ref(view));
        let each = views.iter().map(alone).collect::<Result<_, _>>().map_err(Failure::computation)?;
        self.write_plate(name, title, caption, Content::Pictures(each), drawing, &[])
    }

    /// Writes views of shapes in space side by side as a picture, and shows them over one another in the report, where
    /// they can be turned; `files` are the same shapes for other programs.
    ///
    /// # Errors
    /// If they cannot be drawn or written.
    pub fn write_shapes(
        &self,
        name: &str,
        title: &str,
        caption: &str,
        views: Vec<View>,
        files: &[String],
    ) -> Result<(), Failure> {
        if NUMBERS_ONLY.load(Ordering::Relaxed) {
            return Ok(());
        }
        let drawing = deformed::draw(title, &views).map_err(Failure::computation)?;
        self.write_plate(name, title, caption, Content::Shapes(views, drawing.clone()), drawing, files)
    }

    fn write_plate(
        &self,
        name: &str,
        title: &str,
        caption: &str,
        content: Content,
        drawing: Drawing,
        more: &[String],
    ) -> Result<(), Failure> {
        self.write_text(&format!("{name}.svg"), &drawing.svg())?;
        let mut files = ["svg", "png"].map(|ending| format!("{name}.{ending}")).to_vec();
        files.extend_from_slice(more);
        let [name, title, caption] = [name, title, caption].map(str::to_owned);
        self.remember(|written| {
            written.drawings.push((name.clone(), drawing));
            written.plates.push(Plate { name, title, caption, content, files, folded: false });
        });
        Ok(())
    }

    /// Notes a file or folder that was read, with its fingerprint.
    ///
    /// # Errors
    /// If it cannot be read again.
    pub fn input(&self, what: &str, path: &Path) -> Result<(), Failure> {
        let input = pages::input(what, path)?;
        self.remember(|written| written.inputs.push(input));
        Ok(())
    }

    fn remember(&self, what: impl FnOnce(&mut Written)) {
        what(&mut self.written.lock().unwrap_or_else(PoisonError::into_inner));
    }

    /// PNG files of all figures, and the page.
    fn finish(&self) -> Result<(), Failure> {
        if NUMBERS_ONLY.load(Ordering::Relaxed) {
            return Ok(());
        }
        let written = std::mem::take(&mut *self.written.lock().unwrap_or_else(PoisonError::into_inner));
        written.drawings.par_iter().try_for_each(|(name, drawing)| {
            let path = self.partial.join(format!("{name}.png"));
            let pixels = drawing.png().map_err(Failure::computation)?;
            std::fs::write(&path, pixels).map_err(|e| refused(&path, &e))
        })?;
        match pages::page(written) {
            Some(page) => self.write_text("report.html", &page.html().map_err(Failure::computation)?),
            None => Ok(()),
        }
    }

    /// Writes the report, puts the results in the place of an earlier one and returns where they are. What a failed run left
    /// beside them goes.
    ///
    /// # Errors
    /// If the report cannot be written or the folders cannot be renamed; the earlier result is then still there.
    pub fn commit(self) -> Result<PathBuf, Failure> {
        let incomplete = incomplete(&self.target);
        self.put_at(&self.target)?;
        if check_replaceable(&incomplete).is_ok() && incomplete.exists() {
            // It is old now; if it resists, it is still named for what it is.
            let _ = marker::remove(&incomplete);
        }
        Ok(self.target.clone())
    }

    /// The same for results of a computation that could not be completed: they stand beside the place of good ones, as
    /// `NAME.incomplete`, and an earlier good result stays.
    ///
    /// # Errors
    /// If the report cannot be written or the folders cannot be renamed.
    pub fn commit_incomplete(self) -> Result<PathBuf, Failure> {
        let beside = incomplete(&self.target);
        check_replaceable(&beside)?;
        self.put_at(&beside)?;
        Ok(beside)
    }

    /// [`commit`](Self::commit), or [`commit_incomplete`](Self::commit_incomplete).
    ///
    /// # Errors
    /// As theirs.
    pub fn commit_if(self, is_complete: bool) -> Result<PathBuf, Failure> {
        if is_complete { self.commit() } else { self.commit_incomplete() }
    }

    fn put_at(&self, target: &Path) -> Result<(), Failure> {
        self.finish()?;
        marker::write(&self.partial)?;
        let before = beside(target, "before");
        let replaced = target.exists();
        if replaced {
            check_replaceable(target)?;
            std::fs::rename(target, &before).map_err(|e| refused(target, &e))?;
        }
        if let Err(error) = std::fs::rename(&self.partial, target) {
            if replaced {
                std::fs::rename(&before, target).map_err(|e| refused(&before, &e))?;
            }
            return Err(refused(target, &error));
        }
        if replaced {
            marker::remove(&before).map_err(|e| refused(&before, &e))?;
        }
        Ok(())
    }
}

/// Where results go that are not complete.
fn incomplete(target: &Path) -> PathBuf {
    let name = target.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
    target.with_file_name(format!("{name}.incomplete"))
}

impl Drop for ResultFolder {
    fn drop(&mut self) {
        if self.partial.exists() {
            // Nothing can be done about a folder that resists; it is hidden and cleared by the next run.
            let _ = std::fs::remove_dir_all(&self.partial);
        }
    }
}

fn check_finite(name: &str, text: &str) -> Result<(), Failure> {
    let Some(word) = not_finite(name, text) else { return Ok(()) };
    Err(Failure::Computation(format!("{name} would hold `{word}`, which is no result: nothing is written")))
}

/// The first number of a file of numbers that is not finite.
fn not_finite<'a>(name: &str, text: &'a str) -> Option<&'a str> {
    let ending = Path::new(name).extension().and_then(|ending| ending.to_str()).unwrap_or_default();
    if !["csv", "ron", "bdf", "vtu", "op4"].contains(&ending) {
        return None;
    }
    // no word of a file without these letters is one of them: files may be gigabytes
    if ["NaN", "inf"].iter().all(|word| memchr::memmem::find(text.as_bytes(), word.as_bytes()).is_none()) {
        return None;
    }
    let words = text.split(|c: char| c.is_whitespace() || ",:()[]<>".contains(c));
    words.into_iter().find(|word| ["NaN", "inf", "-inf"].contains(word))
}

/// `.NAME.KIND-PROCESS` beside the target.
fn beside(target: &Path, kind: &str) -> PathBuf {
    target.with_file_name(format!("{}{}", prefix(target, kind), std::process::id()))
}

fn prefix(target: &Path, kind: &str) -> String {
    let name = target.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    format!(".{name}.{kind}-")
}

/// Clears what a killed command left beside the target, and brings back a result it had set aside.
fn clear_leftovers(target: &Path) {
    let Some(entries) = target.parent().and_then(|folder| std::fs::read_dir(folder).ok()) else { return };
    for path in entries.flatten().map(|entry| entry.path()) {
        let name = path.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
        let dead =
            |kind| name.strip_prefix(&prefix(target, kind)).is_some_and(|process| !is_running(process));
        let _ = if dead("before") && !target.exists() {
            std::fs::rename(&path, target)
        } else if dead("before") {
            marker::remove(&path)
        } else if dead("partial") {
            std::fs::remove_dir_all(&path)
        } else {
            Ok(())
        };
    }
}

/// Whether a process lives; where that cannot be seen (no /proc) it is taken to live.
fn is_running(process: &str) -> bool {
    process.parse::<u32>().is_ok()
        && (!Path::new("/proc/self").exists() || Path::new("/proc").join(process).exists())
}
