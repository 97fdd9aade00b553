//! Control surfaces lose effectiveness at large deflections: K_delta(delta, V) of paper 1, Eq. 10.
//!
//! Two forms. `tanh`: `delta_eff = s tanh(delta/s)`, by 1/s for each surface, so that zero is no loss.
//! `table`: for each surface what is added to K at 5, 15 and 25 degrees, straight between, constant outside, where tanh
//! does not fit: an effectiveness above one. In both, what differs from one grows with airspeed by a common power.

use super::prelude::*;

const SPEC: Spec = Spec {
    name: "ctl_saturation",
    title: "control surfaces lose effectiveness at large deflections",
    side: Side::Control,
    rivals: &["act_rate", "ctl_scale", "ctl_asym"],
    experiment: "a static sweep of the flap; doublets of 5, 15 and 25 degrees",
};

/// Deflections of the table, degrees.
const NODES_DEG: [f64; 3] = [5.0, 15.0, 25.0];

/// A table that differs by less than this of its largest entry between its ends is a scale at all deflections, no saturation.
const BENT: f64 = 0.3;

/// The form of tanh.
#[derive(Debug)]
pub(crate) struct CtlSaturation {
    controls: Vec<String>,
}

impl CtlSaturation {
    pub(crate) fn new(controls: &[String]) -> Self {
        Self { controls: controls.to_vec() }
    }
}

impl Effect for CtlSaturation {
    fn spec(&self) -> &'static Spec {
        &SPEC
    }

    fn parameters(&self) -> Vec<Parameter> {
        let each = |name: &String| Parameter::new(format!("inverse_s_{name}_per_rad"), (0.0, 8.0), 2.0);
        let mut all: Vec<Parameter> = self.controls.iter().map(each).collect();
        all.push(Parameter::new("V_power", (-1.0, 2.0), 0.3));
        all
    }

    fn form(&self) -> &'static str {
        "tanh"
    }

    fn inputs(&self, p: &[f64], place: &Place<'_>, inputs: &mut Inputs) {
        let faster = faster(p[self.controls.len()], place);
        for (control, inverse) in inputs.controls_rad.iter_mut().zip(p) {
            let inverse = inverse * faster;
            if inverse > 0.0 {
                for delta in control.iter_mut() {
                    *delta = (inverse * *delta).tanh() / inverse;
                }
            }
        }
    }
}

/// The form of a table.
#[derive(Debug)]
pub(crate) struct CtlSaturationTable {
    controls: Vec<String>,
}

impl CtlSaturationTable {
    pub(crate) fn new(controls: &[String]) -> Self {
        Self { controls: controls.to_vec() }
    }
}

impl Effect for CtlSaturationTable {
    fn spec(&self) -> &'static Spec {
        &SPEC
    }

    fn parameters(&self) -> Vec<Parameter> {
        let each = |name: &String| {
            NODES_DEG.map(|node| Parameter::new(format!("dK_{name}_{node:.0}_deg"), (-0.8, 0.8), 0.15))
        };
        let mut all: Vec<Parameter> = self.controls.iter().flat_map(each).collect();
        all.push(Parameter::new("V_power", (-1.0, 2.0), 0.3));
        all
    }

    fn form(&self) -> &'static str {
        "table"
    }

    fn is_itself(&self, p: &[f64]) -> bool {
        let added = &p[..NODES_DEG.len() * self.controls.len()];
        let largest = added.iter().map(|dk| dk.abs()).fold(0.0, f64::max);
        let bends = |dk: &[f64]| (dk[NODES_DEG.len() - 1] - dk[0]).abs() > BENT * largest;
        added.chunks(NODES_DEG.len()).any(bends)
    }

    fn inputs(&self, p: &[f64], place: &Place<'_>, inputs: &mut Inputs) {
        let faster = faster(p[NODES_DEG.len() * self.controls.len()], place);
        for (control, added) in inputs.controls_rad.iter_mut().zip(p.chunks(NODES_DEG.len())) {
            for delta in control.iter_mut() {
                *delta *= 1.0 + faster * between(added, delta.abs().to_degrees());
            }
        }
    }
}

/// The loss at an airspeed over that at the reference airspeed.
fn faster(power: f64, place: &Place<'_>) -> f64 {
    if place.flow.v_m_s > 0.0 { (place.flow.v_m_s / REFERENCE_V_M_S).powf(power) } else { 1.0 }
}

/// Straight between the nodes, constant outside.
fn between(added: &[f64], delta_deg: f64) -> f64 {
    let [low, middle, high] = NODES_DEG;
    if delta_deg <= middle {
        let t = ((delta_deg - low) / (middle - low)).max(0.0);
        added[0] + t * (added[1] - added[0])
    } else {
        let t = ((delta_deg - middle) / (high - middle)).min(1.0);
        added[1] + t * (added[2] - added[1])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_table_alike_at_all_deflections_is_no_saturation() {
        let table = CtlSaturationTable::new(&["inner".to_owned(), "outer".to_owned()]);
        assert!(!table.is_itself(&[-0.27, -0.25, -0.26, -0.2, -0.2, -0.19, 0.0]));
        // more effective at small deflections, less at large ones
        assert!(table.is_itself(&[0.05, 0.1, -0.32, 0.0, 0.0, 0.0, 0.0]));
    }
}
