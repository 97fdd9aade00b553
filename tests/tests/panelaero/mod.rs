//! Meshes and tables of data/panelaero.

#![expect(clippy::unwrap_used, reason = "a helper of tests may fail the test where it stands")]

use aero::{AeroBox, Lattice};
use nalgebra::Point3;
use nastran::Table;
use validation::data;

/// A table of the folder.
pub(crate) fn table(name: &str) -> Table {
    Table::read(&data(&format!("panelaero/{name}.csv"))).unwrap()
}

/// The boxes of a mesh.
pub(crate) fn mesh(name: &str) -> Lattice {
    let table = table(&format!("mesh_{name}"));
    let number = |row, axis: &str, corner| table.number(row, &format!("{axis}{corner}")).unwrap();
    let boxes = (0..table.len()).map(|row| {
        let corner = |c| Point3::new(number(row, "x", c), number(row, "y", c), number(row, "z", c));
        AeroBox { id: u32::try_from(row).unwrap(), corners: [corner(1), corner(2), corner(3), corner(4)] }
    });
    let chordwise = table.numbers("ichord").unwrap().iter().fold(0.0, |a: f64, b| a.max(*b)) + 1.0;
    let chordwise = (1..100).find(|n| f64::from(*n) == chordwise).unwrap();
    Lattice::from_corners(name, usize::try_from(chordwise).unwrap(), boxes.collect()).unwrap()
}

/// Pitch axis of each mesh: second line of its file.
pub(crate) fn pitch_axis(name: &str) -> Point3<f64> {
    Point3::new(if name == "A" { 0.5 } else { 0.4 }, 0.0, 0.0)
}
