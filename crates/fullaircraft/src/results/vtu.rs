//! Deformed shapes as VTK unstructured grids (`.vtu`, XML, ASCII) for ParaView: quadrilaterals with their lift.

use crate::aircraft::assembly::Aircraft;
use crate::trim::trimmed::Trimmed;
use std::fmt::Write as _;

impl Aircraft {
    /// The deformed boxes with lift per area (Pa) as cell data and the deflection (m) as point data.
    pub fn vtu(&self, trimmed: &Trimmed) -> String {
        let quads = self.deformed(trimmed);
        let lattice = &self.flow.lattice;
        let (mut points, mut moved, mut cells, mut ends, mut types, mut lift) =
            (String::new(), String::new(), String::new(), String::new(), String::new(), String::new());
        // Writing to a String cannot fail.
        for (j, (quad, panel)) in quads.iter().zip(&lattice.boxes).enumerate() {
            for (corner, before) in quad.iter().zip(&panel.corners) {
                let _ = writeln!(points, "{:.6} {:.6} {:.6}", corner.x, corner.y, corner.z);
                let _ = writeln!(moved, "{:.6}", (corner - before).dot(&panel.normal()));
            }
            let _ = writeln!(cells, "{} {} {} {}", 4 * j, 4 * j + 1, 4 * j + 2, 4 * j + 3);
            let _ = writeln!(ends, "{}", 4 * (j + 1));
            types.push_str("9\n");
            let _ = writeln!(lift, "{:.5e}", trimmed.box_loads[2 * j] / panel.area_m2());
        }
        let array = |kind: &str, name: &str, components: u32, text: &str| {
            format!(
                "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"ascii\">\n\
                 {text}</DataArray>\n"
            )
        };
        let count = quads.len();
        format!(
            "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"0.1\" byte_order=\"LittleEndian\">\n\
             <UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{count}\">\n<PointData>\n{}</PointData>\n\
             <CellData>\n{}</CellData>\n<Points>\n{}</Points>\n<Cells>\n{}{}{}</Cells>\n</Piece>\n</UnstructuredGrid>\n\
             </VTKFile>\n",
            4 * count,
            array("Float64", "deflection_m", 1, &moved),
            array("Float64", "lift_per_area_Pa", 1, &lift),
            array("Float64", "points", 3, &points),
            array("Int32", "connectivity", 1, &cells),
            array("Int32", "offsets", 1, &ends),
            array("UInt8", "types", 1, &types),
        )
    }
}
