//! What cargo says of the workspace.

use std::path::Path;
use std::process::Command;

use wingroot::failure::Failure;

/// What a command of cargo prints about the repository at `root`.
///
/// # Errors
/// If it does not run or fails.
pub(super) fn said(root: &Path, arguments: &[&str]) -> Result<Vec<u8>, Failure> {
    let name = arguments.first().copied().unwrap_or_default();
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    let output = Command::new(cargo)
        .args(arguments)
        .current_dir(root)
        .output()
        .map_err(|error| Failure::Computation(format!("cargo {name} does not run: {error}")))?;
    if !output.status.success() {
        let complaint = String::from_utf8_lossy(&output.stderr).into_owned();
        return Err(Failure::Computation(format!("cargo {name} failed: {complaint}")));
    }
    Ok(output.stdout)
}
