//! A command of the command line, run in a thread of its own without Python's lock.

use std::sync::mpsc::{self, RecvTimeoutError};
use std::time::Duration;

use pyo3::exceptions::PyRuntimeError;
use pyo3::prelude::*;
use wingroot::{embedded, progress};

use crate::raised::checked;

/// How often Python is asked for signals and told of progress.
const EVERY: Duration = Duration::from_millis(100);

/// As much as the command line has on its first thread.
const STACK: usize = 8 << 20;

/// Runs a command given by its words; `tick(what, done, total)` is told how far it is. Returns its summary and remarks.
///
/// Ctrl-C raises KeyboardInterrupt at once; what the command was doing goes on to its end without anyone waiting for it.
#[pyfunction]
#[pyo3(signature = (words, tick=None))]
pub(crate) fn run(
    py: Python<'_>,
    words: Vec<String>,
    tick: Option<Bound<'_, PyAny>>,
) -> PyResult<(String, Vec<String>)> {
    let (send, mut receive) = mpsc::channel();
    let work = move || {
        // Who was interrupted does not listen any more.
        let _ = send.send(embedded::run(&words));
    };
    std::thread::Builder::new().stack_size(STACK).spawn(work)?;
    loop {
        let ended;
        (ended, receive) = py.detach(move || (receive.recv_timeout(EVERY), receive));
        match ended {
            Ok((result, said)) => return checked(py, result).map(|()| (said.summary, said.notes)),
            Err(RecvTimeoutError::Disconnected) => {
                return Err(PyRuntimeError::new_err(
                    "the command broke off: this is a fault of wingroot, please report it",
                ));
            }
            Err(RecvTimeoutError::Timeout) => {
                py.check_signals()?;
                if let (Some(tick), Some(step)) = (&tick, progress::now()) {
                    tick.call1(step)?;
                }
            }
        }
    }
}
