//! Frequency responses of a [`ReducedOrderModel`] with changes, and its steady answer to what is constant.

use super::blocks::Blocks;
use super::drive::{Constants, Drive, Outputs};
use super::structural::Structural;
use super::{BALANCE, Change, ReducedOrderModel};
use faer::linalg::solvers::Solve;
use faer::{Mat, c64};

/// What motions do at one frequency, column by column.
struct ByMotion {
    /// Forces of the air on modes and balance.
    forces: Mat<c64>,
    /// Height of the tip.
    tip: Mat<c64>,
    /// Lift of the zones, if it is asked for.
    lift: Option<Mat<c64>>,
}

impl ReducedOrderModel {
    /// Outputs by drives at several frequencies (rad/s, zero included), one matrix each; `everything` adds lifts and heights
    /// of the zones, and what drives them.
    pub fn responses(&self, change: &Change, omegas_rad_s: &[f64], everything: bool) -> Vec<Mat<c64>> {
        let air = self.changed(change);
        let lift = everything.then(|| self.changed_lift(change));
        let weights = self.weights(omegas_rad_s);
        let of = |blocks: &Blocks| &blocks.by * &weights;
        let (air_values, lift_values) = (of(&air), lift.as_ref().map(of));
        // the tip's height is the shape of the modes and the unchanged wing's static residual: no force of the air
        let tip = self.blocks(&self.tip, &Change::none(self.zones.len()));
        let tip_values = of(&tip);
        let structure = Structural::new(self, change);
        let at = |(k, omega): (usize, &f64)| {
            let s = c64::new(0.0, *omega);
            let mut forces = self.at(&air, &air_values, k);
            self.add_memory(&mut forces, change, *omega);
            let lift = lift.as_ref().zip(lift_values.as_ref()).map(|(l, values)| self.at(l, values, k));
            let motion = ByMotion { forces, tip: self.at(&tip, &tip_values, k), lift };
            self.solve(s, &motion, &structure, change)
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
            let twists = self.outputs().twists();
            for zone in 0..self.zones.len() {
                let own = factor * (1.0 + change.zone_force[zone]) * self.lift[(zone, one)];
                rest[lifts + zone] = own + (0..m).map(|k| (l[(zone, k)] * xi[(k, 0)]).re).sum::<f64>();
                rest[heights + zone] = (0..m).map(|k| self.heights[(zone, k)] * xi[(k, 0)].re).sum();
                rest[twists + zone] = (0..m).map(|k| self.twists[(zone, k)] * xi[(k, 0)].re).sum();
            }
        }
        self.turn_at_rest(&mut rest, change, everything);
        rest
    }

    /// What loads at rest turn the wing in the stream: the response by incidence has the loop closed already.
    fn turn_at_rest(&self, rest: &mut [f64], change: &Change, everything: bool) {
        let gains = incidence_gains(change);
        if gains == [0.0; 3] {
            return;
        }
        let incidence: f64 = gains.iter().zip(rest.iter()).map(|(gain, load)| gain * load).sum();
        for response in self.responses(change, &[0.0], everything) {
            for (row, value) in rest.iter_mut().enumerate() {
                *value += response[(row, Drive::INCIDENCE)].re * incidence;
            }
        }
    }

    /// Apparent mass and a wake with another memory of the same incidence: the difference of the few poles' functions is added, as the
    /// many poles of the approximation are no lags of their own.
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
            for ([still, moving], &g) in self.wake.iter().zip(&self.wake_poles_per_m) {
                let later = (1.0 + change.unsteady) * (lag(g / (1.0 + change.lag)) - lag(g));
                add(later, still);
                add(later * s / c64::from(self.flow.v_m_s), moving);
            }
        }
    }

    /// Closes the loop of the modes at one frequency.
    fn solve(
        &self,
        s: c64,
        ByMotion { forces: z, tip, lift }: &ByMotion,
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
                let (mut height, mut twist) = (c64::new(0.0, 0.0), c64::new(0.0, 0.0));
                for k in 0..m {
                    sum += lift[(zone, k)] * xi[(k, column)];
                    height += xi[(k, column)] * self.heights[(zone, k)];
                    twist += xi[(k, column)] * self.twists[(zone, k)];
                }
                response[(outputs.lifts() + zone, column)] = sum;
                response[(outputs.heights() + zone, column)] = height;
                response[(outputs.twists() + zone, column)] = twist;
            }
        }
        feed_back(&mut response, change);
        response
    }

    /// Modes and balance by drives, the modes held.
    fn direct(&self, s: c64, z: &Mat<c64>, structure: &Structural, everything: bool) -> Mat<c64> {
        let m = self.modes();
        Mat::from_fn(m + BALANCE, self.drive().len(everything), |row, column| {
            let field = |f: usize| c64::from(structure.field(self, row, f));
            let drive = self.drive();
            match column {
                Drive::PITCH => z[(row, m)] - s * s * field(2),
                Drive::INCIDENCE => z[(row, m)],
                Drive::G_SIN => field(0),
                Drive::G_COS => -field(1),
                c if c < drive.lifts() => z[(row, m + 1 + c - Drive::CONTROLS)],
                c if c < drive.modal() => c64::from(self.zone_drive[(row, c - drive.lifts())]),
                c => c64::from(f64::from(u8::from(row == c - drive.modal()))),
            }
        })
    }

    fn tip_direct(&self, s: c64, tip: &Mat<c64>, column: usize) -> c64 {
        let (m, field) = (self.modes(), |f: usize| c64::from(self.tip[(0, self.layout.field(f))]));
        match column {
            Drive::PITCH => tip[(0, m)] - s * s * field(2),
            Drive::INCIDENCE => tip[(0, m)],
            Drive::G_SIN => field(0),
            Drive::G_COS => -field(1),
            c if c < self.drive().lifts() => tip[(0, m + 1 + c - Drive::CONTROLS)],
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
            c if (Drive::CONTROLS..drive.lifts()).contains(&c) => lift[(zone, m + 1 + c - Drive::CONTROLS)],
            c if (drive.lifts()..drive.modal()).contains(&c) => {
                c64::from(f64::from(u8::from(zone == c - drive.lifts())))
            }
            _ => c64::new(0.0, 0.0),
        }
    }
}

/// Angle of attack by Fz, Mx and My.
fn incidence_gains(change: &Change) -> [f64; 3] {
    [change.incidence_by_fz, 0.0, change.incidence_by_my]
}

/// Loads that turn the wing in the stream: `y = H u + H_incidence (g y)`.
fn feed_back(response: &mut Mat<c64>, change: &Change) {
    let gains = incidence_gains(change);
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
