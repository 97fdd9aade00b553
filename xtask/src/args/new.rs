//! Options of `new`.

use std::path::PathBuf;

use clap::Args;

/// Options of `new`.
#[derive(Debug, Clone, Default, Args)]
#[command(after_help = "Examples:
  cargo xtask new my_wing
  cargo xtask calibrate --wing my_wing/wing.ron --campaign my_wing/campaign --out out/my_wing

The folder holds wing.ron with every field explained, its section and beam, a campaign of static points and runs, and a
README.md. The example measurements are generated, so that everything runs before yours are in place; docs/guide.md goes on
from there.")]
pub struct NewArgs {
    /// The folder to make; it must not exist, or be empty
    #[arg(value_name = "DIR")]
    pub folder: PathBuf,
}
