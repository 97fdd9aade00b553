//! The wing that `new` gives a user to begin with, in a folder of the test's own, and the program run there.

use std::path::PathBuf;
use std::process::{Command, Output};

/// The folder of the wing; what stands above it goes with this value.
pub(crate) struct OwnWing(PathBuf);

impl OwnWing {
    /// The wing as `new` writes it. The name tells tests that run at the same time apart.
    pub(crate) fn new(name: &str) -> Self {
        let above = std::env::temp_dir().join(format!("wingroot-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&above).expect("a folder of our own");
        let begun =
            Command::new(env!("CARGO_BIN_EXE_wingroot")).args(["new", "wing"]).current_dir(&above).output();
        assert!(begun.is_ok_and(|output| output.status.success()));
        Self(above.join("wing"))
    }

    /// The same, calibrated, with a file of one's own.
    pub(crate) fn calibrated_with(name: &str, file: &str, text: &str) -> Self {
        let own = Self::new(name);
        own.finishes(&["calibrate"]);
        std::fs::write(own.path(file), text).expect("a file of our own");
        own
    }

    /// A place in the folder.
    pub(crate) fn path(&self, inside: &str) -> PathBuf {
        self.0.join(inside)
    }

    /// The text of a file there.
    pub(crate) fn read(&self, inside: &str) -> String {
        std::fs::read_to_string(self.path(inside)).expect("a file of results")
    }

    /// The program, to be started there.
    pub(crate) fn command(&self, words: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_wingroot"));
        command.args(words).arg("--quiet").current_dir(&self.0);
        command
    }

    /// How it ended.
    pub(crate) fn run(&self, words: &[&str]) -> Output {
        self.command(words).output().expect("the command starts")
    }

    /// Runs it to a good end.
    pub(crate) fn finishes(&self, words: &[&str]) {
        let output = self.run(words);
        assert!(output.status.success(), "{words:?}: {}", String::from_utf8_lossy(&output.stderr));
    }
}

impl Drop for OwnWing {
    fn drop(&mut self) {
        let _ = self.0.parent().map(std::fs::remove_dir_all);
    }
}
