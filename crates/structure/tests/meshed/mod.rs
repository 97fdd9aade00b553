//! Decks meshed from a map of parameters to places, with grids on the edges.

#![expect(unreachable_pub, reason = "helpers of the tests in this folder")]

use nalgebra::Vector3;
use std::collections::BTreeMap;
use std::fmt::Write;

/// Edges of a quadrilateral, a triangle and a hexahedron in the order of the grids on them.
pub const QUAD: &[[usize; 2]] = &[[0, 1], [1, 2], [2, 3], [3, 0]];
pub const TRIANGLE: &[[usize; 2]] = &[[0, 1], [1, 2], [2, 0]];
pub const HEXA: &[[usize; 2]] =
    &[[0, 1], [1, 2], [2, 3], [3, 0], [0, 4], [1, 5], [2, 6], [3, 7], [4, 5], [5, 6], [6, 7], [7, 4]];
pub const WEDGE: &[[usize; 2]] = &[[0, 1], [1, 2], [2, 0], [0, 3], [1, 4], [2, 5], [3, 4], [4, 5], [5, 3]];
pub const TETRA: &[[usize; 2]] = &[[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]];

/// Grids by their parameters, and cards.
pub struct Mesh<M> {
    map: M,
    numbers: BTreeMap<[String; 3], u32>,
    /// Parameters and places of the grids 1, 2, ...
    pub grids: Vec<[Vector3<f64>; 2]>,
    /// The cards so far, grids left out.
    pub cards: String,
    elements: u32,
}

impl<M: Fn(Vector3<f64>) -> Vector3<f64>> Mesh<M> {
    pub fn new(map: M) -> Self {
        Self { map, numbers: BTreeMap::new(), grids: Vec::new(), cards: String::new(), elements: 0 }
    }

    /// The grid with these parameters.
    pub fn grid(&mut self, parameters: Vector3<f64>) -> u32 {
        // Adding zero takes the sign off a negative one.
        let key = [0, 1, 2].map(|i| format!("{:.6}", (parameters[i] * 1e6).round() * 1e-6 + 0.0));
        *self.numbers.entry(key).or_insert_with(|| {
            self.grids.push([parameters, (self.map)(parameters)]);
            u32::try_from(self.grids.len()).expect("few grids")
        })
    }

    /// Grids of an element: corners, then the middles of `edges`.
    pub fn grids_of(&mut self, corners: &[Vector3<f64>], edges: &[[usize; 2]]) -> Vec<u32> {
        let middles = edges.iter().map(|[a, b]| (corners[*a] + corners[*b]) * 0.5);
        let all: Vec<_> = corners.iter().copied().chain(middles).collect();
        all.into_iter().map(|parameters| self.grid(parameters)).collect()
    }

    /// One element of property 1.
    pub fn element(&mut self, name: &str, corners: &[Vector3<f64>], edges: &[[usize; 2]]) -> u32 {
        self.elements += 1;
        let grids = self.grids_of(corners, edges);
        let fields: Vec<String> = [self.elements, 1].iter().chain(&grids).map(ToString::to_string).collect();
        let lines: Vec<String> = fields.chunks(8).map(|line| line.join(",")).collect();
        writeln!(self.cards, "{name},{}", lines.join("\n,")).expect("a string");
        self.elements
    }

    /// A sheet over the parameters 0 to 1, `cells` along each, of CQUAD8 or of two CTRIA6 a cell.
    pub fn sheet(&mut self, name: &str, cells: [usize; 2]) {
        for cell in 0..cells[0] * cells[1] {
            let at = |dx: usize, dy: usize| {
                let (i, j) = (cell % cells[0] + dx, cell / cells[0] + dy);
                Vector3::new(i as f64 / cells[0] as f64, j as f64 / cells[1] as f64, 0.0)
            };
            let corners = [at(0, 0), at(1, 0), at(1, 1), at(0, 1)];
            let [a, b, c, d] = corners;
            match name {
                "CQUAD8" => _ = self.element(name, &corners, QUAD),
                "CQUAD4" => _ = self.element(name, &corners, &[]),
                "CTRIA6" => {
                    self.element(name, &[a, b, c], TRIANGLE);
                    self.element(name, &[a, c, d], TRIANGLE);
                }
                _ => {
                    self.element(name, &[a, b, c], &[]);
                    self.element(name, &[a, c, d], &[]);
                }
            }
        }
    }

    /// Holds components of the grids whose parameters and place are as asked.
    pub fn hold(&mut self, components: &str, is_meant: impl Fn(&Vector3<f64>, &Vector3<f64>) -> bool) {
        for (at, [parameters, place]) in self.grids.iter().enumerate() {
            if is_meant(parameters, place) {
                writeln!(self.cards, "SPC1,1,{components},{}", at + 1).expect("a string");
            }
        }
    }

    /// The deck, with what else it has.
    pub fn deck(&self, others: &str) -> String {
        let grid = |(at, [_, place]): (usize, &[Vector3<f64>; 2])| {
            format!("GRID*,{},,{:.14E},{:.14E}\n*,{:.14E}\n", at + 1, place.x, place.y, place.z)
        };
        let grids: String = self.grids.iter().enumerate().map(grid).collect();
        format!("{grids}{}{others}", self.cards)
    }
}

/// Forces along `directions` per length on the side of three grids at `places` (a corner, the middle, the other corner),
/// work-equivalent: three Gauss points.
pub fn side_forces(
    places: [Vector3<f64>; 3],
    traction: impl Fn(Vector3<f64>, Vector3<f64>) -> Vector3<f64>,
) -> [Vector3<f64>; 3] {
    let mut forces = [Vector3::zeros(); 3];
    let far = 0.6_f64.sqrt();
    for (s, weight) in [(-far, 5.0 / 9.0), (0.0, 8.0 / 9.0), (far, 5.0 / 9.0)] {
        let shape = [0.5 * s * (s - 1.0), 1.0 - s * s, 0.5 * s * (s + 1.0)];
        let slope = [s - 0.5, -2.0 * s, s + 0.5];
        let place: Vector3<f64> = places.iter().zip(shape).map(|(x, n)| x * n).sum();
        let tangent: Vector3<f64> = places.iter().zip(slope).map(|(x, n)| x * n).sum();
        let force = traction(place, tangent) * weight;
        for (own, n) in forces.iter_mut().zip(shape) {
            *own += force * n;
        }
    }
    forces
}
