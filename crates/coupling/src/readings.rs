//! What a corrected wing would show at places without sensors, and how that hangs on corrections and flexibility.

use crate::case::SteadyCase;
use crate::steady::{SteadyOperator, SteadyState};
use crate::wing::ElasticWing;
use faer::Mat;
use faer::linalg::solvers::Solve;

/// What is read: rows on the box loads (two columns a box), and rows on the displacement of the structure from its place
/// with wind off at alpha = 0 (a column for each of its degrees of freedom that carry boxes).
#[derive(Debug, Clone)]
pub struct Rows {
    /// On the box loads.
    pub on_loads: Mat<f64>,
    /// On the displacement.
    pub on_structure: Mat<f64>,
}

/// Readings of one case, those on loads first, and their derivatives.
#[derive(Debug, Clone)]
pub struct Readings {
    /// The readings.
    pub values: Vec<f64>,
    /// Readings by boxes: by the force factor of each correctable box.
    pub by_force: Mat<f64>,
    /// By the moment factor.
    pub by_moment: Mat<f64>,
    /// By the pressure offset f_e/q.
    pub by_offset: Mat<f64>,
    /// By the logarithms of the flexibility in bending and in torsion.
    pub by_flexibility: [Vec<f64>; 2],
}

impl ElasticWing {
    /// Size of the displacement that rows are on; zero for a rigid wing.
    fn displaced(&self) -> usize {
        self.supported.as_ref().map_or(0, crate::supported::SupportedStructure::size)
    }

    /// The row of the tip's height; zeros for a rigid wing.
    pub fn tip_row(&self) -> Vec<f64> {
        let tip = self.supported.as_ref().map(|structure| structure.tip_z);
        (0..self.displaced()).map(|i| f64::from(u8::from(Some(i) == tip))).collect()
    }

    /// Rise of the nose of the tip's section (rad) by a displacement of the structure, against wind off at alpha = 0; zero for
    /// a rigid wing, and one whose boxes hang on grids that do not turn.
    pub fn tip_twist_rad(&self, displacement: &[f64]) -> f64 {
        let Some(structure) = &self.supported else { return 0.0 };
        let pitch = structure.s_dofs[structure.tip_z] + 2;
        let Ok(at) = structure.s_dofs.binary_search(&pitch) else { return 0.0 };
        let field = self.gravity_at(0.0);
        let wind_off: f64 = (0..3).map(|axis| structure.sag[(at, axis)] * field[axis]).sum();
        displacement[at] - wind_off
    }

    /// The row of the height (m) of a point of the wing, at a share of the span and of the chord there; and of the incidence
    /// (rad) there. Between the middles of two strips it is their mean by distance.
    pub fn point_rows(&self, y_norm: f64, x_over_c: f64) -> [Vec<f64>; 2] {
        let boxes = &self.correctable;
        let mut rows = [vec![0.0; self.displaced()], vec![0.0; self.displaced()]];
        let Some(structure) = &self.supported else { return rows };
        for (first, weight) in boxes.strips_at(y_norm) {
            // the nearest box of the strip, and from its middle along its chord
            let chord_m: f64 = (0..boxes.chord_rows[first]).map(|k| self.box_chord_m(first + k)).sum();
            let mut edge_m = 0.0;
            let mut nearest = (f64::INFINITY, first, 0.0);
            for b in first..first + boxes.chord_rows[first] {
                let middle_m = edge_m + 0.5 * self.box_chord_m(b);
                let aft_m = x_over_c * chord_m - middle_m;
                if aft_m.abs() < nearest.0 {
                    nearest = (aft_m.abs(), b, aft_m);
                }
                edge_m += self.box_chord_m(b);
            }
            let (_, b, aft_m) = nearest;
            let place = boxes.places[b];
            for &(dof, value) in &structure.spline_rows[2 * place] {
                rows[0][dof] += weight * value;
            }
            for &(dof, value) in &structure.spline_rows[2 * place + 1] {
                // nose up lowers what is behind
                rows[0][dof] -= weight * aft_m * value;
                rows[1][dof] += weight * value;
            }
        }
        rows
    }

    /// What rows on the displacement read with wind off when a weight (N, downward) is hung on the wing at a share of the span and of the
    /// chord there, against the wing without it; and the derivatives by the logarithms of the flexibility in bending and in torsion.
    pub fn under_weight(&self, weight_n: f64, place: [f64; 2], rows: &Mat<f64>) -> (Vec<f64>, [Vec<f64>; 2]) {
        let nothing = || vec![0.0; rows.nrows()];
        let Some(structure) = &self.supported else { return (nothing(), [nothing(), nothing()]) };
        // a force does on its point's height what it does on the degrees of freedom that the height follows
        let [height, _] = self.point_rows(place[0], place[1]);
        let pulled = Mat::from_fn(height.len(), 1, |i, _| -weight_n * height[i]);
        let moved = &structure.flexibility * pulled;
        let moved = moved.col_as_slice(0);
        let twist = self.twist_of(moved);
        let bent: Vec<f64> = moved.iter().zip(&twist).map(|(all, twist)| all - twist).collect();
        let read = |vector: &[f64]| times(rows, vector).collect::<Vec<f64>>();
        (read(moved), [read(&bent), read(&twist)])
    }

    /// The part of a displacement that turns the axis about itself; zero where boxes hang on grids that do not turn.
    fn twist_of(&self, displacement: &[f64]) -> Vec<f64> {
        let mut twist = vec![0.0; displacement.len()];
        let (Some(supported), Some((system, _))) = (&self.supported, &self.structure) else { return twist };
        let mut nodes: Vec<usize> =
            supported.s_dofs.iter().filter(|dof| *dof % 6 >= 3).map(|dof| dof / 6).collect();
        nodes.dedup();
        nodes.sort_by(|a, b| system.points()[*a].y.total_cmp(&system.points()[*b].y));
        let place = |k: usize| system.points()[nodes[k.min(nodes.len() - 1)]];
        for (k, node) in nodes.iter().enumerate() {
            let axis = (place(k + 1) - place(k.saturating_sub(1))).try_normalize(0.0).unwrap_or_default();
            let turns: Vec<(usize, f64)> = (0..3)
                .filter_map(|c| {
                    supported.s_dofs.binary_search(&(6 * node + 3 + c)).ok().map(|i| (i, axis[c]))
                })
                .collect();
            let about: f64 = turns.iter().map(|&(i, along)| displacement[i] * along).sum();
            for (i, along) in turns {
                twist[i] = about * along;
            }
        }
        twist
    }

    fn box_chord_m(&self, b: usize) -> f64 {
        self.lattice.boxes[self.correctable.places[b]].chord_m()
    }
}

impl SteadyOperator<'_> {
    /// Reads a case without derivatives.
    pub fn values(&self, case: &SteadyCase, rows: &Rows) -> Vec<f64> {
        self.values_of(&self.solve(std::slice::from_ref(case)).swap_remove(0), rows)
    }

    fn values_of(&self, state: &SteadyState, rows: &Rows) -> Vec<f64> {
        let moved: Vec<f64> =
            state.displacement.iter().zip(self.wind_off()).map(|(u, sag)| u - sag).collect();
        times(&rows.on_loads, &state.box_loads.values).chain(times(&rows.on_structure, &moved)).collect()
    }

    /// Reads a case.
    ///
    /// With `A = I - q F H` and `A u = F (...)` (design equations of [`crate::steady`]), the whole right side grows with the
    /// flexibility, so `du/d ln F = A⁻¹ u`; that of torsion is the part of `u` that turns the axis about itself.
    pub fn readings(&self, case: &SteadyCase, rows: &Rows) -> Readings {
        let (wing, q_pa) = (self.wing, self.flow.dynamic_pressure_pa());
        let lambda = self.adjoint_of(rows.on_loads.as_ref(), rows.on_structure.as_ref());
        let state = self.solve(std::slice::from_ref(case)).swap_remove(0);
        let by = self.loads().derivatives(q_pa, lambda.as_ref(), &state.cp, &wing.correctable.places);
        Readings {
            values: self.values_of(&state, rows),
            by_force: by.by_force,
            by_moment: by.by_moment,
            by_offset: by.by_offset,
            by_flexibility: self.by_flexibility(&state.displacement, rows),
        }
    }

    fn by_flexibility(&self, displacement: &[f64], rows: &Rows) -> [Vec<f64>; 2] {
        let Some(factor) = &self.factor else {
            return [0; 2].map(|_| vec![0.0; rows.on_loads.nrows() + rows.on_structure.nrows()]);
        };
        let wind_off = self.wind_off();
        let [twist, sag_twist] = [displacement, &wind_off[..]].map(|u| self.wing.twist_of(u));
        let of = |u: &dyn Fn(usize) -> f64, sag: &dyn Fn(usize) -> f64| {
            let more = factor.solve(&Mat::from_fn(displacement.len(), 1, |i, _| u(i)));
            let cp = &self.wing.cp_displacement * &more;
            let loads = self.loads().of_pressures(self.flow.dynamic_pressure_pa(), cp.as_ref());
            // the wind-off sag, which heights are counted from, grows with the flexibility as well
            let beyond: Vec<f64> = more.col_as_slice(0).iter().enumerate().map(|(i, u)| u - sag(i)).collect();
            times(&rows.on_loads, loads.col_as_slice(0)).chain(times(&rows.on_structure, &beyond)).collect()
        };
        [
            of(&|i| displacement[i] - twist[i], &|i| wind_off[i] - sag_twist[i]),
            of(&|i| twist[i], &|i| sag_twist[i]),
        ]
    }

    /// Displacement with wind off at alpha = 0.
    fn wind_off(&self) -> Vec<f64> {
        let Some(structure) = &self.wing.supported else { return Vec::new() };
        let field = self.gravity_field(0.0);
        times(&structure.sag, field.as_slice()).collect()
    }
}

/// A matrix times a vector.
fn times<'a>(matrix: &'a Mat<f64>, vector: &'a [f64]) -> impl Iterator<Item = f64> + 'a {
    (0..matrix.nrows()).map(|r| vector.iter().enumerate().map(|(k, value)| matrix[(r, k)] * value).sum())
}
