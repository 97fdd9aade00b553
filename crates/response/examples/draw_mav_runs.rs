//! Writes the runs of the micro air vehicle that ship in data/mav again: `cargo run -p wingroot-response --example draw_mav_runs`,
//! from the root of the repository. Another folder may be named.

use std::error::Error;
use std::path::PathBuf;

use response::mav::{Published, shipped_files};

fn main() -> Result<(), Box<dyn Error>> {
    let folder = std::env::args_os().nth(1).map_or_else(|| PathBuf::from("data/mav"), PathBuf::from);
    let published = Published::read(&PathBuf::from("data/mav/published"))?;
    for (name, text) in shipped_files(&published)? {
        std::fs::write(folder.join(name), text)?;
    }
    Ok(())
}
