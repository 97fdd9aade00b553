//! The wing that `calibrate` fits: with small deflections, or the one that really bends, as its file asks for.

use aero::{BoxLoads, Corrections};
use calibrate::{Calibration, LiftFactor};
use coupling::{
    CorrectableBoxes, CouplingError, ElasticWing, LargeModel, LargeState, LargeWing, RootLoads,
    RootSensitivity, SteadyCase, SteadyModel, SteadyState,
};

/// What is fitted.
#[derive(Debug)]
pub(crate) enum Fitted<'a> {
    /// Small deflections.
    Small(&'a ElasticWing),
    /// Large ones.
    Large(&'a ElasticWing, LargeModel<'a>),
}

/// One solved case.
pub(crate) enum Seen {
    /// Of the linear wing.
    Small(SteadyState),
    /// Of the bent wing.
    Large(Box<LargeState>),
}

impl<'a> Fitted<'a> {
    /// The bent wing.
    pub(crate) fn large(wing: &'a LargeWing) -> Self {
        Self::Large(&wing.elastic, wing.model())
    }

    /// The wing with small deflections.
    pub(crate) fn elastic(&self) -> &'a ElasticWing {
        match self {
            Self::Small(elastic) | Self::Large(elastic, _) => elastic,
        }
    }

    fn model(&self) -> &dyn SteadyModel {
        match self {
            Self::Small(elastic) => *elastic,
            Self::Large(_, model) => model,
        }
    }

    /// Cases that share a flow.
    ///
    /// # Errors
    /// If there is no equilibrium.
    pub(crate) fn solve(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
    ) -> Result<Vec<Seen>, CouplingError> {
        match (self, cases) {
            (_, []) => Ok(Vec::new()),
            (Self::Small(elastic), [first, ..]) => {
                let states = elastic.at(first.flow, corrections)?.solve(cases);
                Ok(states.into_iter().map(Seen::Small).collect())
            }
            (Self::Large(_, model), _) => {
                let one = |case| Ok(Seen::Large(Box::new(model.equilibrium(case, corrections)?)));
                cases.iter().map(one).collect()
            }
        }
    }
}

impl Seen {
    /// Fz, Mx, My (N, N m, N m) and the tip's height (m).
    pub(crate) fn readings(&self) -> [f64; 4] {
        let (root, tip_z_m) = match self {
            Self::Small(state) => (&state.root, state.tip_z_m),
            Self::Large(state) => (&state.root, state.tip_m.z),
        };
        let [fz, mx, my] = root.to_array();
        [fz, mx, my, tip_z_m]
    }

    /// Corrected box loads.
    pub(crate) fn box_loads(&self) -> &BoxLoads {
        match self {
            Self::Small(state) => &state.box_loads,
            Self::Large(state) => &state.box_loads,
        }
    }
}

impl SteadyModel for Fitted<'_> {
    fn correctable(&self) -> &CorrectableBoxes {
        self.model().correctable()
    }

    fn root_loads(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
    ) -> Result<Vec<RootLoads>, CouplingError> {
        self.model().root_loads(cases, corrections)
    }

    fn tip_deflections(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
    ) -> Result<Vec<f64>, CouplingError> {
        self.model().tip_deflections(cases, corrections)
    }

    fn has_tip(&self) -> bool {
        self.model().has_tip()
    }

    fn bends_far(&self) -> bool {
        self.model().bends_far()
    }

    fn nearby(&self) -> Option<&dyn SteadyModel> {
        self.model().nearby()
    }

    fn sensitivities(
        &self,
        cases: &[SteadyCase],
        corrections: &Corrections,
    ) -> Result<Vec<RootSensitivity>, CouplingError> {
        self.model().sensitivities(cases, corrections)
    }

    fn pressure_coefficients(&self, case: &SteadyCase) -> Result<Vec<f64>, CouplingError> {
        self.model().pressure_coefficients(case)
    }
}

/// The uniform factors on lift of a calibration: of the common set, or of each airspeed.
pub(crate) fn lift_factors(calibration: &Calibration) -> Vec<&LiftFactor> {
    let common = calibration.common.iter().filter_map(|set| set.lift.as_ref());
    common.chain(calibration.airspeeds.iter().filter_map(|at| at.lift.as_ref())).collect()
}

/// The factors of both geometries in words: where they are with small deflections, and how they change up to the largest one.
pub(crate) fn told(large: &Calibration, small: &Calibration) -> String {
    let words = |lift: &LiftFactor| {
        let trend = lift.trend.map_or_else(String::new, |(change, sigma)| {
            format!(", changing by {change:.3} +- {sigma:.3} up to the largest deflection")
        });
        format!("{:.3} +- {:.3}{trend}", lift.factor, lift.sigma)
    };
    let line = |(large, small)| {
        format!("lift factor with large deflections {}; with small ones {}\n", words(large), words(small))
    };
    let lines: Vec<String> = lift_factors(large).into_iter().zip(lift_factors(small)).map(line).collect();
    lines.concat()
}
