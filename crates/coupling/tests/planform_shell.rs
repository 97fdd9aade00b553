//! The shell-and-solid wing: counts, geometry, masses and section integrals of the mesh that its file generates.

use coupling::planform::{MeshCounts, Mount, Planform, ShellSolid, Structure};
use coupling::wing_file::WingFile;
use std::path::{Path, PathBuf};

type Outcome = Result<(), Box<dyn std::error::Error>>;

fn data(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/tuflex").join(file)
}

fn tuflex() -> (WingFile, Planform, ShellSolid) {
    let wing = WingFile::read(&data("wing_shell.ron")).unwrap_or_else(|error| panic!("{error}"));
    let planform = wing.planform().expect("a parametric wing").clone();
    let Some(Structure::ShellSolid(shell)) = planform.structure.clone() else { panic!("no shell wing") };
    (wing, planform, *shell)
}

#[test]
fn the_mesh_has_the_paper_s_solids() -> Outcome {
    let (wing, planform, shell) = tuflex();
    let bulk = wing.bulk(Mount::Tunnel)?;
    println!("{:?}", MeshCounts::of(&bulk));
    for y in [0.0, 0.45, 0.9, 1.35, 1.8] {
        println!("{y} {:?}", shell.section_integrals(&planform, &data(""), y)?);
    }
    Ok(())
}
