//! Files of `statics`: displacements, reactions, steps, shapes.

use std::fmt::Write as _;

use report::{Figure, Panel, Series, Style};
use structure::mesh::{MeshCell, cells};
use structure::nonlinear::Path;

use super::{modes_pictures, modes_shapes};
use crate::failure::Failure;
use crate::output::ResultFolder;
use crate::structures::Structure;

/// A state of the structure: six values a grid.
#[derive(Debug)]
pub(super) struct State {
    /// Displacements and rotation vectors, m, rad; basic axes.
    pub(super) displacements: Vec<f64>,
    /// Loads, N, Nm; basic axes.
    pub(super) forces: Vec<f64>,
    /// What the ground gives, N, Nm; axes of the grids' displacement systems.
    pub(super) reactions: Vec<f64>,
}

/// Both answers.
pub(super) struct Answer<'a> {
    pub(super) structure: &'a Structure,
    pub(super) linear: &'a State,
    /// The way, its end and the displacements of all its points.
    pub(super) large: Option<&'a (Path, State, Vec<Vec<f64>>)>,
}

/// Shapes that are drawn and written at most.
const SHAPES: usize = 12;

const CAPTION: &str = "The structure undeformed, by linear theory and as computed, to scale. Drag to turn, scroll to come nearer; a \
                       click on a name shows or hides a shape.";

impl Answer<'_> {
    /// The end: that of large deflections, if they were asked for.
    pub(super) fn end(&self) -> &State {
        self.large.map_or(self.linear, |(_, end, _)| end)
    }

    /// The node that moves most.
    pub(super) fn largest(&self) -> usize {
        let far = |node: &[f64]| node[..3].iter().map(|u| u * u).sum::<f64>();
        let nodes = self.end().displacements.chunks_exact(6).map(far).enumerate();
        nodes.fold((0, 0.0), |most, own| if own.1 > most.1 { own } else { most }).0
    }

    /// Sum of the loads, and their moment about the origin, at the places of the end if deflections are large.
    pub(super) fn resultant(&self) -> ([f64; 3], [f64; 3]) {
        let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
        let end = self.end();
        for (node, own) in end.forces.chunks_exact(6).enumerate() {
            let mut place = self.structure.system.points()[node];
            if self.large.is_some() {
                (0..3).for_each(|axis| place[axis] += end.displacements[6 * node + axis]);
            }
            for axis in 0..3 {
                let (next, last) = ((axis + 1) % 3, (axis + 2) % 3);
                force[axis] += own[axis];
                moment[axis] += own[3 + axis] + place[next] * own[last] - place[last] * own[next];
            }
        }
        (force, moment)
    }

    /// Writes tables and the shape of a subcase behind the first, under names with its number.
    fn write_further(&self, folder: &ResultFolder, cells: &[MeshCell], subcase: u32) -> Result<(), Failure> {
        let (system, end) = (&self.structure.system, self.end());
        let own = |name: &str| format!("subcase_{subcase}_{name}");
        let held = |six: &[f64]| six.iter().any(|value| *value != 0.0);
        folder.write_text(
            &own("displacements.csv"),
            &self.table(&end.displacements, DISPLACEMENTS, |_| true),
        )?;
        folder.write_text(&own("reactions.csv"), &self.table(&end.reactions, REACTIONS, held))?;
        let nodes: Vec<[f64; 6]> = end.displacements.chunks_exact(6).map(six).collect();
        folder.write_text(&own("shape.vtu"), &modes_pictures::vtu(system, cells, &nodes))
    }

    /// Writes all files and figures; of a further subcase tables and the shape.
    pub(super) fn write(&self, folder: &ResultFolder, further: Option<u32>) -> Result<(), Failure> {
        let (structure, end) = (self.structure, self.end());
        let cells = cells(&structure.bulk, &structure.system);
        if let Some(subcase) = further {
            return self.write_further(folder, &cells, subcase);
        }
        folder.write_text("displacements.csv", &self.table(&end.displacements, DISPLACEMENTS, |_| true))?;
        let held = |six: &[f64]| six.iter().any(|value| *value != 0.0);
        folder.write_text("reactions.csv", &self.table(&end.reactions, REACTIONS, held))?;
        let mut views = vec![(String::from("undeformed"), vec![0.0; end.displacements.len()])];
        let mut files = Vec::new();
        let mut shape = |name: String, file: String, displacements: &[f64]| -> Result<(), Failure> {
            let nodes: Vec<[f64; 6]> = displacements.chunks_exact(6).map(six).collect();
            folder.write_text(&file, &modes_pictures::vtu(&structure.system, &cells, &nodes))?;
            files.push(file);
            views.push((name, displacements.to_vec()));
            Ok(())
        };
        shape("linear".into(), "linear.vtu".into(), &self.linear.displacements)?;
        if let Some((path, _, shapes)) = self.large {
            folder.write_text(
                "displacements_linear.csv",
                &self.table(&self.linear.displacements, DISPLACEMENTS, |_| true),
            )?;
            folder.write_text("steps.csv", &self.steps(path, shapes))?;
            folder.write_figure(
                "displacement_over_load",
                "The grid that moves most, over the share of the load; dashed what linear theory says.",
                self.figure(path, shapes),
            )?;
            let apart_by = path.points.len().div_ceil(SHAPES);
            for (at, (point, own)) in path.points.iter().zip(shapes).enumerate() {
                if (path.points.len() - 1 - at) % apart_by == 0 {
                    shape(
                        format!("{:.3} of the load", point.load_factor),
                        format!("load_{:02}.vtu", at + 1),
                        own,
                    )?;
                }
            }
        }
        let (name, system) = (&structure.name, &structure.system);
        modes_shapes::write_states(folder, name, CAPTION, system, &cells, &views, &files)
    }

    fn table(&self, values: &[f64], head: &str, is_wanted: impl Fn(&[f64]) -> bool) -> String {
        let mut text = format!("{head}\n");
        let ids = self.structure.system.node_ids();
        for (id, six) in ids.iter().zip(values.chunks_exact(6)).filter(|(_, six)| is_wanted(six)) {
            let cells: Vec<String> = six.iter().map(|value| format!("{value:.9e}")).collect();
            let _ = writeln!(text, "{id},{}", cells.join(","));
        }
        text
    }

    fn steps(&self, path: &Path, shapes: &[Vec<f64>]) -> String {
        let node = self.largest();
        let id = self.structure.system.node_ids()[node];
        let mut text =
            format!("# x_m, y_m, z_m: displacement of GRID {id}\nload_factor,iterations,x_m,y_m,z_m\n");
        for (point, shape) in path.points.iter().zip(shapes) {
            let [x, y, z] = [0, 1, 2].map(|axis| shape[6 * node + axis]);
            let _ = writeln!(text, "{:.6},{},{x:.9e},{y:.9e},{z:.9e}", point.load_factor, point.iterations);
        }
        text
    }

    fn figure(&self, path: &Path, shapes: &[Vec<f64>]) -> Figure {
        let node = self.largest();
        let mut shares = vec![0.0];
        shares.extend(path.points.iter().map(|point| point.load_factor));
        let own = |shape: &Vec<f64>| [0, 1, 2].map(|axis| shape[6 * node + axis].abs());
        let largest = shapes.iter().chain([&self.linear.displacements]).flat_map(own).fold(0.0, f64::max);
        // What is rounding beside the others would get an axis of its own.
        let shown = |value: f64| if value.abs() < ROUNDING * largest { 0.0 } else { value };
        let panel = |axis: usize| {
            let mut large = vec![0.0];
            large.extend(shapes.iter().map(|shape| shown(shape[6 * node + axis])));
            let slope = shown(self.linear.displacements[6 * node + axis]);
            let linear = shares.iter().map(|share| share * slope).collect();
            let series = vec![
                Series::new("linear", shares.clone(), linear, Style::DashedLine),
                Series::new("large deflections", shares.clone(), large, Style::Line),
            ];
            let name = ["x", "y", "z"][axis];
            Panel::new(
                format!("along {name}"),
                "share of the load (-)",
                format!("displacement {name} (m)"),
                series,
            )
        };
        let id = self.structure.system.node_ids()[node];
        Figure::new(format!("Displacement of GRID {id}"), [0, 1, 2].map(panel).into(), 3)
    }
}

/// A displacement along one axis that is a smaller share of the largest is drawn as zero.
const ROUNDING: f64 = 1e-9;
const DISPLACEMENTS: &str = "grid,x_m,y_m,z_m,rx_rad,ry_rad,rz_rad";
const REACTIONS: &str = "grid,fx_N,fy_N,fz_N,mx_Nm,my_Nm,mz_Nm";

fn six(values: &[f64]) -> [f64; 6] {
    std::array::from_fn(|component| values[component])
}
