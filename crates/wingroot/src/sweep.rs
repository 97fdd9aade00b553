//! Commands that go over many cases: all of them in one process, or shares of them in many, then put together.
//!
//! `fullaircraft --cases`, `loads` and `hidden` do the same whatever they are asked for: they take their share ([`split`]), leave out what the
//! store has, and keep each case as it is finished ([`crate::store`]). Results are made of the store, so that parts give the
//! bytes that one process gives.

use clap::Args;
use nastran::InputError;

pub mod estimate;
pub mod lines;
pub mod merging;
pub mod share;
pub mod split;
pub mod status;

use crate::failure::Failure;
use crate::fingerprint::Fingerprint;
use estimate::Slot;
use share::{Share, Source};

/// Which of the cases, for commands that go over many.
#[derive(Debug, Clone, Default, Args)]
pub struct SweepArgs {
    /// Only this share of the cases, 1/N to N/N [default: that of a Slurm array's task or an indexed job's pod, else all]
    #[arg(long, value_name = "K/N")]
    pub(crate) part: Option<Share>,
    /// Only the case of this hash, once more
    #[arg(long, value_name = "HASH", conflicts_with = "part", value_parser = hash)]
    pub(crate) case: Option<Fingerprint>,
    /// What `prepare`, `merge` and `status` ask for.
    #[arg(skip)]
    pub(crate) stage: Stage,
    /// Where an estimate is left.
    #[arg(skip)]
    pub(crate) estimate: Slot,
}

/// What a sweep is asked for.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum Stage {
    /// To compute cases.
    #[default]
    Compute,
    /// To compute once what all cases share.
    Prepare,
    /// To put the results together.
    Merge,
    /// To say how far it is.
    Status,
    /// To compute a few cases, and say what the others will take.
    Estimate,
}

/// What one process does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Task {
    /// Everything: all cases and the results.
    All,
    /// A share of the cases.
    Part(Share),
    /// One case.
    Case(Fingerprint),
    /// What all cases share.
    Prepare,
    /// The results.
    Merge,
    /// How far the sweep is.
    Status,
    /// A few cases, and what the others will take.
    Estimate,
}

impl Task {
    /// What the name of this process' segment begins with.
    pub fn label(self) -> String {
        match self {
            Self::Part(share) => format!("part{}of{}", share.number, share.of),
            _ => "whole".to_owned(),
        }
    }
}

impl SweepArgs {
    /// What this process is to do; a share that the environment names is said.
    ///
    /// # Errors
    /// If the environment names a share that cannot be, or options do not go together.
    pub fn task(&self) -> Result<Task, Failure> {
        let one = self.case.is_some() || self.part.is_some();
        match self.stage {
            Stage::Compute => {}
            _ if one => {
                let error = InputError::general("`--part` and `--case` choose cases to compute");
                return Err(error.with_help("leave them out of `prepare`, `merge` and `status`").into());
            }
            Stage::Prepare => return Ok(Task::Prepare),
            Stage::Merge => return Ok(Task::Merge),
            Stage::Status => return Ok(Task::Status),
            Stage::Estimate => return Ok(Task::Estimate),
        }
        if let Some(hash) = self.case {
            return Ok(Task::Case(hash));
        }
        if let Some(share) = self.part {
            return Ok(if share.of == 1 { Task::All } else { Task::Part(share) });
        }
        let Some(Source { share, variable }) = share::of_environment(&|name| std::env::var(name).ok())?
        else {
            return Ok(Task::All);
        };
        crate::show::note(&format!("part {share} of the cases, by {variable}; `--part 1/1` is all of them"));
        Ok(Task::Part(share))
    }
}

impl SweepArgs {
    /// The same for a command that a user may run in an array of their own, a task each with its own input: an array or an indexed job
    /// tells its share only with the number of parts, as the scripts of `cluster` do.
    ///
    /// # Errors
    /// As [`task`](Self::task).
    pub fn task_by_parts(&self) -> Result<Task, Failure> {
        let told = std::env::var_os(share::PARTS).is_some();
        let asked = self.part.is_some() || self.case.is_some() || self.stage != Stage::Compute;
        if told || asked { self.task() } else { Ok(Task::All) }
    }
}

fn hash(text: &str) -> Result<Fingerprint, String> {
    Fingerprint::of_text(text)
        .ok_or_else(|| "expected 16 hexadecimal digits, as `status` shows them".to_owned())
}
