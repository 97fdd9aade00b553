//! Frequency responses of a [`Compact`] rig with changes, and its steady answer to what is constant.

use super::{BALANCE, Change, Compact};
use faer::linalg::solvers::Solve;
use faer::{Mat, c64};

/// Where drives stand among the columns of a response.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Drive {
    controls: usize,
    zones: usize,
}

impl Drive {
    /// Pitch of the root with everything it brings but gravity, per rad.
    pub const PITCH: usize = 0;
    /// Angle of attack of the air alone, per rad.
    pub const INCIDENCE: usize = 1;
    /// Gravity aft, per m/s².
    pub const G_SIN: usize = 2;
    /// Gravity down, per m/s².
    pub const G_COS: usize = 3;
    /// First commanded deflection, per rad.
    pub const CONTROLS: usize = 4;
    /// How many modes may be driven by forces of their own.
    pub const DRIVEN_MODES: usize = 2;

    /// First zone's additional lift, per N.
    pub fn lifts(self) -> usize {
        Self::CONTROLS + self.controls
    }

    /// Force on the first mode, per N (modal).
    pub fn modal(self) -> usize {
        self.lifts() + self.zones
    }

    /// Number of drives, those of lift and modes included or not.
    pub fn len(self, everything: bool) -> usize {
        if everything { self.modal() + Self::DRIVEN_MODES } else { self.lifts() }
    }

    /// Never true.
    pub fn is_empty(self) -> bool {
        false
    }
}

/// Where outputs stand among the rows of a response.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Outputs {
    zones: usize,
}

impl Outputs {
    /// Height of the tip, m; Fz, Mx, My come before it.
    pub const TIP: usize = BALANCE;

    /// Lift of the first zone, N.
    pub fn lifts(self) -> usize {
        BALANCE + 1
    }

    /// Height of the first zone, m.
    pub fn heights(self) -> usize {
        self.lifts() + self.zones
    }

    /// Number of outputs, those of zones included or not.
    pub fn len(self, everything: bool) -> usize {
        if everything { self.heights() + self.zones } else { BALANCE + 1 }
    }

    /// Never true.
    pub fn is_empty(self) -> bool {
        false
    }
}

/// What acts on the wing at rest beside angle of attack, gravity and controls.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Constants {
    /// Pitching moment coefficient added everywhere.
    pub moment_coefficient: f64,
    /// Incidence growing along the span, rad/m.
    pub upwash_rad_m: f64,
}

/// The air's forces with changes, in blocks that multiply functions of s.
struct Blocks {
    /// (rows times motions) by functions: 1, s, s², then p/(p + g) of both families.
    by: Mat<f64>,
    rows: usize,
}

impl Compact {
    /// Where drives stand.
    pub fn drive(&self) -> Drive {
        Drive { controls: self.controls.len(), zones: self.zones.len() }
    }

    /// Where outputs stand.
    pub fn outputs(&self) -> Outputs {
        Outputs { zones: self.zones.len() }
    }

    /// Outputs by drives at several frequencies (rad/s, zero included), one matrix each; `everything` adds lifts and heights
    /// of the zones, and what drives them.
    pub fn responses(&self, change: &Change, omegas_rad_s: &[f64], everything: bool) -> Vec<Mat<c64>> {
        let air = self.changed(change);
        let lift = everything.then(|| self.changed_lift(change));
        let weights = self.weights(omegas_rad_s);
        let of = |blocks: &Blocks| &blocks.by * &weights;
        let (air_values, lift_values) = (of(&air), lift.as_ref().map(of));
        let tip = self.blocks(&self.tip, change);
        let tip_values = of(&tip);
        let structure = Structural::new(self, change);
        let at = |(k, omega): (usize, &f64)| {
            let s = c64::new(0.0, *omega);
            let mut z = self.at(&air, &air_values, k);
            self.add_memory(&mut z, change, *omega);
            let lift = lift.as_ref().zip(lift_values.as_ref()).map(|(l, values)| self.at(l, values, k));
            let tip = self.at(&tip, &tip_values, k);
            self.solve(s, &z, (&tip, lift.as_ref()), &structure, change)
        };
        omegas_rad_s.iter().enumerate().map(at).collect()
    }

    /// Outputs by what is constant: camber and tare as they are, then with the given constants. They belong to zero
    /// frequency and are added to the outputs of the other drives at rest.
    pub fn at_rest(&self, change: &Change, constants: &Constants, everything: bool) -> Vec<f64> {
        let air = self.changed(change);
        let lift = self.changed_lift(change);
        let weights = self.weights(&[0.0]);
        let z = self.at(&air, &(&air.by * &weights), 0);
        let l = self.at(&lift, &(&lift.by * &weights), 0);
        let structure = Structural::new(self, change);
        let (m, one) = (self.modes(), self.layout.one());
        let factor = 1.0 + change.pressure;
        let total = self.zone_sum(change);
        let constant = |row: usize| {
            let zones = self.unit_moment.ncols();
            let moments: f64 = (0..zones).map(|zone| self.unit_moment[(row, zone)]).sum();
            factor
                * (total[(row, one)]
                    + constants.moment_coefficient * moments
                    + constants.upwash_rad_m * self.unit_upwash[row])
        };
        let mut forcing = Mat::<c64>::zeros(m, 1);
        for mode in 0..m {
            forcing[(mode, 0)] = c64::from(constant(mode));
        }
        let xi = if m > 0 {
            structure.dynamic(c64::new(0.0, 0.0), &z, m).partial_piv_lu().solve(&forcing)
        } else {
            forcing
        };
        let mut rest = vec![0.0; self.outputs().len(everything)];
        for row in 0..BALANCE {
            let elastic: f64 = (0..m).map(|k| (z[(m + row, k)] * xi[(k, 0)]).re).sum();
            rest[row] = elastic
                + constant(m + row)
                + self.inertia[(row, one)] * (1.0 + change.mass)
                + structure.points_tare(row, self.gravity_m_s2);
        }
        rest[Outputs::TIP] =
            self.tip[(0, one)] + (0..m).map(|k| self.tip[(0, k)] * xi[(k, 0)].re).sum::<f64>();
        if everything {
            let (lifts, heights) = (self.outputs().lifts(), self.outputs().heights());
            for zone in 0..self.zones.len() {
                let own = factor * (1.0 + change.zone_force[zone]) * self.lift[(zone, one)];
                rest[lifts + zone] = own + (0..m).map(|k| (l[(zone, k)] * xi[(k, 0)]).re).sum::<f64>();
                rest[heights + zone] = (0..m).map(|k| self.heights[(zone, k)] * xi[(k, 0)].re).sum();
            }
        }
        rest
    }

    /// Modes and balance by the layout's columns with the factors of the zones.
    fn zone_sum(&self, change: &Change) -> Mat<f64> {
        let mut total = self.air.clone();
        if change.by_zone() {
            for zone in 0..self.zones.len() {
                let (force, aft) = (change.zone_force[zone], change.zone_aft_over_c[zone]);
                if force != 0.0 {
                    total += faer::Scale(force) * &self.zone_air[zone];
                }
                if aft != 0.0 {
                    total -= faer::Scale(aft) * &self.zone_moment[zone];
                }
            }
        }
        total
    }

    fn changed(&self, change: &Change) -> Blocks {
        self.blocks(&self.zone_sum(change), change)
    }

    fn changed_lift(&self, change: &Change) -> Blocks {
        let factor = |zone: usize| 1.0 + change.zone_force[zone];
        let lift = Mat::from_fn(self.lift.nrows(), self.lift.ncols(), |zone, column| {
            factor(zone) * self.lift[(zone, column)]
        });
        self.blocks(&lift, change)
    }

    /// Columns of the layout sorted by motion and function of s.
    fn blocks(&self, total: &Mat<f64>, change: &Change) -> Blocks {
        let (layout, rows) = (self.layout, total.nrows());
        let functions = 3 + layout.poles[0] + layout.poles[1];
        let mut by = Mat::zeros(rows * layout.motions(), functions);
        let first_control = layout.modes + 1;
        let factor = |motion: usize| {
            let slope = if motion < first_control { 1.0 + change.lift_slope } else { 1.0 };
            slope * (1.0 + change.pressure)
        };
        let mut put = |motion: usize, function: usize, column: usize| {
            for row in 0..rows {
                by[(motion * rows + row, function)] = factor(motion) * total[(row, column)];
            }
        };
        for motion in 0..layout.motions() {
            for derivative in 0..3 {
                put(motion, derivative, layout.motion(derivative).start + motion);
            }
        }
        for (lag, (family, pole, motion)) in layout.every_lag().enumerate() {
            put(motion, 3 + family * layout.poles[0] + pole, layout.first_lag() + lag);
        }
        Blocks { by, rows }
    }

    /// The functions of s at all frequencies: real parts, then imaginary parts.
    fn weights(&self, omegas_rad_s: &[f64]) -> Mat<f64> {
        let n = omegas_rad_s.len();
        let poles: Vec<f64> = self.poles_per_m.iter().flatten().map(|pole| pole * self.flow.v_m_s).collect();
        Mat::from_fn(3 + poles.len(), 2 * n, |function, column| {
            let (omega, imaginary) = (omegas_rad_s[column % n], column >= n);
            match (function, imaginary) {
                (0, false) => 1.0,
                (0, true) | (1, false) | (2, true) => 0.0,
                (1, true) => omega,
                (2, false) => -omega * omega,
                (lag, _) => {
                    let g = poles[lag - 3];
                    let scale = omega * omega + g * g;
                    if scale == 0.0 {
                        0.0
                    } else if imaginary {
                        omega * g / scale
                    } else {
                        omega * omega / scale
                    }
                }
            }
        })
    }

    /// Rows by motions at one of the frequencies.
    fn at(&self, blocks: &Blocks, values: &Mat<f64>, k: usize) -> Mat<c64> {
        let n = values.ncols() / 2;
        Mat::from_fn(blocks.rows, self.layout.motions(), |row, motion| {
            let place = motion * blocks.rows + row;
            c64::new(values[(place, k)], values[(place, n + k)])
        })
    }

    /// Apparent mass and a wake with another memory: the difference of the few poles' functions is added, as the many poles
    /// of the approximation are no lags of their own.
    fn add_memory(&self, z: &mut Mat<c64>, change: &Change, omega: f64) {
        let mut add = |factor: c64, by: &Mat<f64>| {
            for motion in 0..z.ncols() {
                for row in 0..z.nrows() {
                    z[(row, motion)] += factor * by[(row, motion)];
                }
            }
        };
        if change.apparent_mass != 0.0 {
            add(c64::from(-change.apparent_mass * omega * omega), &self.apparent);
        }
        if change.lag != 0.0 && self.flow.v_m_s > 0.0 {
            let s = c64::new(0.0, omega);
            let lag = |g: f64| s / (s + c64::from(g * self.flow.v_m_s));
            for (by, &g) in self.wake.iter().zip(&self.wake_poles_per_m) {
                add(lag(g / (1.0 + change.lag)) - lag(g), by);
            }
        }
    }

    /// Closes the loop of the modes at one frequency.
    fn solve(
        &self,
        s: c64,
        z: &Mat<c64>,
        (tip, lift): (&Mat<c64>, Option<&Mat<c64>>),
        structure: &Structural,
        change: &Change,
    ) -> Mat<c64> {
        let (m, everything) = (self.modes(), lift.is_some());
        let drives = self.drive().len(everything);
        let direct = self.direct(s, z, structure, everything);
        let forcing = direct.subrows(0, m).to_owned();
        let xi = if m > 0 { structure.dynamic(s, z, m).partial_piv_lu().solve(&forcing) } else { forcing };
        let outputs = self.outputs();
        let mut response = Mat::<c64>::zeros(outputs.len(everything), drives);
        let balance = structure.balance(s, self, z);
        for column in 0..drives {
            for row in 0..BALANCE {
                let mut sum = direct[(m + row, column)];
                for k in 0..m {
                    sum += balance[(row, k)] * xi[(k, column)];
                }
                response[(row, column)] = sum;
            }
            let mut height = self.tip_direct(s, tip, column);
            for k in 0..m {
                height += tip[(0, k)] * xi[(k, column)];
            }
            response[(Outputs::TIP, column)] = height;
            for zone in 0..if everything { self.zones.len() } else { 0 } {
                let Some(lift) = lift else { break };
                let mut sum = self.lift_direct(s, lift, zone, column);
                let mut height = c64::new(0.0, 0.0);
                for k in 0..m {
                    sum += lift[(zone, k)] * xi[(k, column)];
                    height += xi[(k, column)] * self.heights[(zone, k)];
                }
                response[(outputs.lifts() + zone, column)] = sum;
                response[(outputs.heights() + zone, column)] = height;
            }
        }
        feed_back(&mut response, change);
        response
    }

    /// Modes and balance by drives, the modes held.
    fn direct(&self, s: c64, z: &Mat<c64>, structure: &Structural, everything: bool) -> Mat<c64> {
        let m = self.modes();
        let actuator = self.deflection(s);
        Mat::from_fn(m + BALANCE, self.drive().len(everything), |row, column| {
            let field = |f: usize| c64::from(structure.field(self, row, f));
            let drive = self.drive();
            match column {
                Drive::PITCH => z[(row, m)] - s * s * field(2),
                Drive::INCIDENCE => z[(row, m)],
                Drive::G_SIN => field(0),
                Drive::G_COS => -field(1),
                c if c < drive.lifts() => z[(row, m + 1 + c - Drive::CONTROLS)] * actuator,
                c if c < drive.modal() => c64::from(self.zone_drive[(row, c - drive.lifts())]),
                c => c64::from(f64::from(u8::from(row == c - drive.modal()))),
            }
        })
    }

    /// Deflection per command.
    fn deflection(&self, s: c64) -> c64 {
        let w = std::f64::consts::TAU * self.actuator.frequency_hz;
        c64::from(w * w) / (s * s + s * (2.0 * self.actuator.damping_ratio * w) + w * w)
    }

    fn tip_direct(&self, s: c64, tip: &Mat<c64>, column: usize) -> c64 {
        let (m, field) = (self.modes(), |f: usize| c64::from(self.tip[(0, self.layout.field(f))]));
        match column {
            Drive::PITCH => tip[(0, m)] - s * s * field(2),
            Drive::INCIDENCE => tip[(0, m)],
            Drive::G_SIN => field(0),
            Drive::G_COS => -field(1),
            c if c < self.drive().lifts() => tip[(0, m + 1 + c - Drive::CONTROLS)] * self.deflection(s),
            _ => c64::new(0.0, 0.0),
        }
    }

    fn lift_direct(&self, s: c64, lift: &Mat<c64>, zone: usize, column: usize) -> c64 {
        let (m, drive) = (self.modes(), self.drive());
        let field = |f: usize| c64::from(self.lift[(zone, self.layout.field(f))]);
        match column {
            Drive::PITCH => lift[(zone, m)] - s * s * field(2),
            Drive::INCIDENCE => lift[(zone, m)],
            Drive::G_SIN => field(0),
            Drive::G_COS => -field(1),
            c if (Drive::CONTROLS..drive.lifts()).contains(&c) => {
                lift[(zone, m + 1 + c - Drive::CONTROLS)] * self.deflection(s)
            }
            c if (drive.lifts()..drive.modal()).contains(&c) => {
                c64::from(f64::from(u8::from(zone == c - drive.lifts())))
            }
            _ => c64::new(0.0, 0.0),
        }
    }
}

/// Loads that turn the wing in the stream: `y = H u + H_incidence (g y)`.
fn feed_back(response: &mut Mat<c64>, change: &Change) {
    let gains = [change.incidence_by_fz, 0.0, change.incidence_by_my];
    if gains == [0.0; 3] {
        return;
    }
    let by_incidence: Vec<c64> = (0..response.nrows()).map(|row| response[(row, Drive::INCIDENCE)]).collect();
    let loop_gain: c64 = (0..BALANCE).map(|row| by_incidence[row] * gains[row]).sum();
    for column in 0..response.ncols() {
        let open: c64 = (0..BALANCE).map(|row| response[(row, column)] * gains[row]).sum();
        let incidence = open / (c64::from(1.0) - loop_gain);
        for row in 0..response.nrows() {
            response[(row, column)] += by_incidence[row] * incidence;
        }
    }
}

/// Structure and masses with changes.
struct Structural {
    mass: Mat<f64>,
    damping: Mat<f64>,
    stiffness: Mat<f64>,
    /// Added to the unchanged wing's rows of the balance by modal accelerations, and by fields; of modes by fields.
    balance_by_modes: Mat<f64>,
    balance_by_fields: Mat<f64>,
    modal_by_fields: Mat<f64>,
    mass_factor: f64,
}

impl Structural {
    fn new(rig: &Compact, change: &Change) -> Self {
        let m = rig.modes();
        let unit = |i: usize, j: usize| f64::from(u8::from(i == j));
        let zeta = rig.damping_ratio * (1.0 + change.damping);
        let mut stiffness = Mat::from_fn(m, m, |i, j| unit(i, j) * rig.omega_rad_s[i].powi(2));
        if let Some(parts) = &rig.stiffness {
            stiffness += faer::Scale(change.bending) * &parts.bending;
            stiffness += faer::Scale(change.torsion) * &parts.torsion;
        } else {
            // nobody split it: all of it
            stiffness = faer::Scale(1.0 + change.bending) * stiffness;
        }
        let mut all = Self {
            mass: Mat::from_fn(m, m, |i, j| unit(i, j) * (1.0 + change.mass)),
            damping: Mat::from_fn(m, m, |i, j| unit(i, j) * 2.0 * zeta * rig.omega_rad_s[i]),
            stiffness,
            balance_by_modes: Mat::zeros(BALANCE, m),
            balance_by_fields: Mat::zeros(BALANCE, 3),
            modal_by_fields: Mat::zeros(m, 3),
            mass_factor: 1.0 + change.mass,
        };
        for point in &change.points {
            all.add(rig, point);
        }
        all
    }

    fn add(&mut self, rig: &Compact, point: &super::PointMass) {
        let zones = &rig.zones;
        let Some(zone) = zones.nearest(point.y_norm) else { return };
        let (x, y) = (zones.x_m[zone] + point.aft_over_c * zones.chord_m[zone], zones.y_m[zone]);
        let shape: Vec<f64> = (0..rig.modes()).map(|mode| rig.heights[(zone, mode)]).collect();
        let field = [0.0, 1.0, -(x - rig.pitch_axis_x_m)];
        let row = [1.0, y - rig.balance_m[1], -(x - rig.balance_m[0])];
        for i in 0..shape.len() {
            for j in 0..shape.len() {
                self.mass[(i, j)] += point.mass_kg * shape[i] * shape[j];
            }
            for f in 0..3 {
                self.modal_by_fields[(i, f)] += point.mass_kg * shape[i] * field[f];
            }
        }
        for r in 0..BALANCE {
            for (mode, height) in shape.iter().enumerate() {
                self.balance_by_modes[(r, mode)] -= point.mass_kg * row[r] * height;
            }
            for f in 0..3 {
                self.balance_by_fields[(r, f)] += point.mass_kg * row[r] * field[f];
            }
        }
    }

    /// `s² M + s C + K - Z`.
    fn dynamic(&self, s: c64, z: &Mat<c64>, m: usize) -> Mat<c64> {
        Mat::from_fn(m, m, |i, j| {
            s * s * self.mass[(i, j)] + s * self.damping[(i, j)] + self.stiffness[(i, j)] - z[(i, j)]
        })
    }

    /// Share of a field of acceleration in a row of modes and balance.
    fn field(&self, rig: &Compact, row: usize, field: usize) -> f64 {
        let m = rig.modes();
        // what the truncated modes do under the field, in the air
        let air = rig.air[(row, rig.layout.field(field))];
        air + if row < m {
            rig.modal_fields[(row, field)] * self.mass_factor + self.modal_by_fields[(row, field)]
        } else {
            rig.inertia[(row - m, rig.layout.field(field))] * self.mass_factor
                + self.balance_by_fields[(row - m, field)]
        }
    }

    /// Balance by modes: air and momentum.
    fn balance(&self, s: c64, rig: &Compact, z: &Mat<c64>) -> Mat<c64> {
        let (m, first) = (rig.modes(), rig.layout.modal_accelerations().start);
        Mat::from_fn(BALANCE, m, |row, mode| {
            let momentum =
                rig.inertia[(row, first + mode)] * self.mass_factor + self.balance_by_modes[(row, mode)];
            z[(m + row, mode)] + s * s * momentum
        })
    }

    /// What the tare takes off for the points.
    fn points_tare(&self, row: usize, gravity_m_s2: f64) -> f64 {
        self.balance_by_fields[(row, 1)] * gravity_m_s2
    }
}
