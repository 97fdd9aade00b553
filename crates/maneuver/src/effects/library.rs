//! All effects that the simulator carries.

use super::Effect;
use super::each::{
    AcShift, ActLag, ActRate, AddedMass, AeroLag, AlphaEncoder, AlphaOffset, Backlash, BalanceCompliance,
    BalanceNonlin, BendStiff, CableStiffness, Camber, Crosstalk, CtlAlphaInteraction, CtlAsym, CtlCompliance,
    CtlSaturation, CtlSaturationTable, CtlScale, CubicStiffness, Damping, DaqFilter, Delay, DeltaOffset,
    Drift, DynamicStall, FlowUpwashGradient, Friction, Gain, InplaneForce, JoinerInertia, LargeDeflection,
    LiftSlope, QError, ReDependence, RootSlack, Stall, StallByAngle, StaticHysteresis, TipLoss, TipMass,
    TorsStiff, WallCorrection, WingMassError,
};
use std::sync::Arc;

/// The effects for a wing with these controls; forms of one effect follow each other.
pub fn library(controls: &[String]) -> Vec<Arc<dyn Effect>> {
    let mut all: Vec<Arc<dyn Effect>> = vec![
        Arc::new(JoinerInertia),
        Arc::new(WingMassError),
        Arc::new(TipMass),
        Arc::new(Crosstalk),
        Arc::new(Gain),
        Arc::new(BalanceNonlin),
        Arc::new(BalanceCompliance),
        Arc::new(Drift),
        Arc::new(AlphaOffset),
        Arc::new(FlowUpwashGradient),
        Arc::new(QError),
        Arc::new(WallCorrection),
        Arc::new(Camber),
        Arc::new(LiftSlope { with_camber: false }),
        Arc::new(LiftSlope { with_camber: true }),
        Arc::new(TipLoss),
        Arc::new(AcShift),
        Arc::new(ReDependence),
        Arc::new(Stall),
        Arc::new(StallByAngle),
        Arc::new(ActLag { second_order: false }),
        Arc::new(ActLag { second_order: true }),
        Arc::new(ActRate),
        Arc::new(Backlash),
        Arc::new(CtlScale),
        Arc::new(CtlCompliance),
        Arc::new(CtlAlphaInteraction),
        Arc::new(CtlAsym),
        Arc::new(BendStiff),
        Arc::new(TorsStiff),
        Arc::new(Damping),
        Arc::new(AddedMass),
        Arc::new(AeroLag),
        Arc::new(Delay),
        Arc::new(DaqFilter { pairs: 1 }),
        Arc::new(DaqFilter { pairs: 2 }),
        Arc::new(Friction),
        Arc::new(InplaneForce),
        Arc::new(LargeDeflection),
        Arc::new(DeltaOffset),
        Arc::new(AlphaEncoder),
        Arc::new(CableStiffness),
        Arc::new(CubicStiffness),
        Arc::new(RootSlack),
        Arc::new(StaticHysteresis),
        Arc::new(DynamicStall),
    ];
    if !controls.is_empty() {
        all.push(Arc::new(CtlSaturation::new(controls)));
        all.push(Arc::new(CtlSaturationTable::new(controls)));
    }
    all
}
