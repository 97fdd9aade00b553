//! What is looked at: balance loads, the tip's height, and the zones where they are asked for.

use crate::modal::Masses;
use crate::strips::ZONES;
use crate::system::{Inputs, Layout, Parts, Rows, ZonesOf};

impl Parts {
    /// Rows of the outputs, in the order of [`crate::system::LinearWing`].
    pub(crate) fn outputs(
        &self,
        layout: &Layout,
        strip_loads: &Rows,
        acceleration: &Rows,
        masses: &Masses,
        zones: ZonesOf,
    ) -> Rows {
        let asked = zones != ZonesOf::Nothing;
        let count = if asked { 4 + 4 * ZONES } else { 4 };
        let mut all = Rows::zeros(count, layout);
        let inertia = acceleration.mapped(&masses.loads_by_modes);
        let balance = strip_loads.mapped(&self.balance_rows);
        for row in 0..3 {
            for column in 0..layout.states() {
                all.state[(row, column)] = balance.state[(row, column)] - inertia.state[(row, column)];
            }
            for column in 0..layout.inputs.len() {
                all.input[(row, column)] = balance.input[(row, column)] - inertia.input[(row, column)];
            }
            all.input[(row, Inputs::G_SIN)] += masses.loads_by_fields[(row, 0)];
            all.input[(row, Inputs::G_COS)] -= masses.loads_by_fields[(row, 1)];
            all.input[(row, Inputs::ALPHA + 2)] -= masses.loads_by_fields[(row, 2)];
            // tared wind off at alpha = 0
            all.input[(row, Inputs::ONE)] += masses.loads_by_fields[(row, 1)] * self.gravity_m_s2;
        }
        for mode in 0..layout.modes {
            all.state[(3, mode)] = self.structure.tip[mode];
        }
        if asked {
            self.add_zones(&mut all, layout, strip_loads);
        }
        all
    }

    /// Lift, mean height, mean twist and mean upward velocity of every zone.
    fn add_zones(&self, all: &mut Rows, layout: &Layout, strip_loads: &Rows) {
        for zone in 0..ZONES {
            let members: Vec<usize> =
                (0..self.strips.len()).filter(|strip| self.strips.zone[*strip] == zone).collect();
            let share = 1.0 / members.len().max(1) as f64;
            for &strip in &members {
                for column in 0..layout.states() {
                    all.state[(4 + zone, column)] += strip_loads.state[(strip, column)];
                }
                for column in 0..layout.inputs.len() {
                    all.input[(4 + zone, column)] += strip_loads.input[(strip, column)];
                }
                for mode in 0..layout.modes {
                    let (height, twist) =
                        (self.strips.height[(strip, mode)], self.strips.twist[(strip, mode)]);
                    all.state[(4 + ZONES + zone, mode)] += share * height;
                    all.state[(4 + 2 * ZONES + zone, mode)] += share * twist;
                    all.state[(4 + 3 * ZONES + zone, layout.modes + mode)] += share * height;
                }
            }
        }
    }
}
