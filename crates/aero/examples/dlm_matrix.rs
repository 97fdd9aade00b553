//! Writes the doublet lattice's influence matrix of boxes given as corners, for scripts that compare it with other programs.
//!
//! `dlm_matrix BOXES.csv MACH OMEGA_OVER_V parabolic|quartic`; a line of the file is the twelve coordinates of the
//! corners of one box, with commas; a line that comes out is one row: re, im, re, im... The integral is Laschka's with
//! parabolic, Desmarais' with quartic, as in PanelAero.

use aero::{AeroBox, DlmSettings, KernelIntegral, Lattice, MirrorPlane, SpanFit, oscillatory};
use nalgebra::Point3;
use std::error::Error;
use std::io::Write;

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [file, mach, omega_over_v, fit] = arguments.as_slice() else {
        return Err("expected BOXES.csv MACH OMEGA_OVER_V parabolic|quartic".into());
    };
    let mut boxes = Vec::new();
    for (line, id) in std::fs::read_to_string(file)?.lines().zip(1..) {
        let v = line.split(',').map(str::parse).collect::<Result<Vec<f64>, _>>()?;
        let corners: Vec<_> = v.chunks_exact(3).map(|c| Point3::new(c[0], c[1], c[2])).collect();
        let corners = corners.try_into().map_err(|_| format!("line {id} has not twelve numbers"))?;
        boxes.push(AeroBox { id, corners });
    }
    let lattice = Lattice::from_corners("boxes", 1, boxes)?;
    let settings = match fit.as_str() {
        "parabolic" => DlmSettings { integral: KernelIntegral::Laschka, fit: SpanFit::Parabolic },
        "quartic" => DlmSettings { integral: KernelIntegral::Desmarais, fit: SpanFit::Quartic },
        other => return Err(format!("unknown fit {other}").into()),
    };
    let matrix = oscillatory(&lattice, MirrorPlane::None, mach.parse()?, omega_over_v.parse()?, &settings)?;
    let mut out = std::io::BufWriter::new(std::io::stdout().lock());
    for i in 0..matrix.nrows() {
        let row: Vec<String> =
            (0..matrix.ncols()).map(|j| format!("{:e},{:e}", matrix[(i, j)].re, matrix[(i, j)].im)).collect();
        writeln!(out, "{}", row.join(","))?;
    }
    Ok(())
}
