//! What an effect is to whoever simulates, fits or flies it.

use super::flight_air::{Flight, FlightAir};
use super::place::{Forces, Inputs, Loads, Needs, Place, WingState};
use super::spec::{Parameter, Spec, Stage};
use crate::rig::Actuator;
use crate::rom::{Change, Constants};

/// A term of the simulation with parameters. `p` are values of [`Effect::parameters`], in their order and units.
pub trait Effect: std::fmt::Debug + Send + Sync {
    /// Name, side, rivals.
    fn spec(&self) -> &'static Spec;

    /// The parameters.
    fn parameters(&self) -> Vec<Parameter>;

    /// The form, where an effect has several: empty for the usual one.
    fn form(&self) -> &'static str {
        ""
    }

    /// Values from which a fit may begin, where small ones say nothing (an angle at which something sets in); none: from
    /// zero.
    fn starts(&self) -> Vec<Vec<f64>> {
        Vec::new()
    }

    /// Moves parameters (within their bounds already) to the nearest that physics allows together.
    fn constrain(&self, _p: &mut [f64]) {}

    /// Whether values are what the name says: a table may also take those of another effect.
    fn is_itself(&self, _p: &[f64]) -> bool {
        true
    }

    /// Changes the servos.
    fn servos(&self, _p: &[f64], _servos: &mut Actuator) {}

    /// Changes what the control surfaces make of the angles of their servos (linkage, stops, the flow behind the hinge).
    fn surfaces(&self, _p: &[f64], _place: &Place<'_>, _angles: &mut Inputs) {}

    /// Changes what the angle sensor and the servos are given of angle and commands.
    fn inputs(&self, _p: &[f64], _place: &Place<'_>, _inputs: &mut Inputs) {}

    /// Changes the linear wing: air, structure, masses.
    fn change(&self, _p: &[f64], _place: &Place<'_>, _change: &mut Change) {}

    /// Adds what acts on the wing at rest.
    fn constants(&self, _p: &[f64], _place: &Place<'_>, _constants: &mut Constants) {}

    /// What of the zones [`Effect::forces`] or [`Effect::loads`] look at.
    fn needs(&self) -> Needs {
        Needs::NONE
    }

    /// Adds forces that depend on the wing's state; they are iterated with its answer.
    fn forces(&self, _p: &[f64], _place: &Place<'_>, _state: &WingState<'_>, _forces: &mut Forces) {}

    /// Changes the loads on their way to the record.
    fn loads(&self, _p: &[f64], _place: &Place<'_>, _state: &WingState<'_>, _loads: &mut Loads) {}

    /// Where on the way from the wing to the record [`Self::loads`] acts.
    fn stage(&self) -> Stage {
        Stage::Load
    }

    /// Whether it changes bending and torsion separately, so that the modes' stiffness must be split into both.
    fn splits_stiffness(&self) -> bool {
        false
    }

    /// Whether its form is trusted at static points only: what motion and deflected flaps do to it is in no form of it.
    fn holds_at_rest_only(&self) -> bool {
        false
    }

    /// Whether it is the physics of the deflection correction (Eq. 10), so that a wing may have only one of the two.
    fn excludes_deflection_correction(&self) -> bool {
        false
    }

    /// What becomes of it when the wing flies, if its side travels with the wing ([`Spec::side`]).
    fn flight(&self) -> Flight {
        Flight::Left
    }

    /// Puts it into the air of a flying wing, where [`Self::flight`] is [`Flight::Corrections`].
    fn correct(&self, _p: &[f64], _air: &mut FlightAir<'_>) {}
}
