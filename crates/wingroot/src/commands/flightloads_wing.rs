//! Loads of a wing in the tunnel at measured states, by the initial and the updated model.

use aero::{Corrections, Flow};
use calibrate::Schedule;
use coupling::{ElasticWing, SteadyCase, WingFile};
use loads::FlightFile;
use loads::flight::{Channel, Reading, State};
use nastran::{InputError, named_file};

use super::flightloads_campaign::{CampaignPoints, root_load};
use super::flightloads_span::SpanLift;
use crate::corrections::{calibrated, schedule};
use crate::failure::Failure;

/// Loads at a reading in the order of the channels, N or N m.
pub(super) struct Calculated {
    /// Loads.
    pub(super) loads: Vec<f64>,
    /// Their standard deviation for noise in the measured state.
    pub(super) sigma: Vec<f64>,
}

/// The wing with its corrections.
pub(super) struct TunnelWing {
    /// Its file.
    pub(super) file: WingFile,
    wing: ElasticWing,
    schedule: Option<(Schedule, String)>,
}

impl TunnelWing {
    /// The wing that a file names, with corrections from a file or from the points that are marked as fitted.
    pub(super) fn read(file: &FlightFile, campaigns: &[CampaignPoints]) -> Result<Option<Self>, Failure> {
        let Some(name) = &file.wing else { return Ok(None) };
        let (wing_file, wing) = ElasticWing::read(&named_file(&file.path, name)?)?;
        let fitted: Vec<_> =
            campaigns.iter().filter_map(|c| Some((&c.condition, c.fitted.as_ref()?))).collect();
        let schedule = match (&file.corrections, fitted.as_slice()) {
            (Some(name), _) => {
                let path = named_file(&file.path, name)?;
                let given = Schedule::read(&path)?;
                if given.wing_hash != wing_file.hash {
                    let message =
                        format!("these corrections belong to another wing than {}", wing_file.path.display());
                    return Err(InputError::in_file(&path, message).with_help("calibrate this wing").into());
                }
                Some((given, path.display().to_string()))
            }
            (None, []) => None,
            (None, [(condition, campaign)]) => {
                let calibration = calibrated(&wing_file, &wing, campaign)?;
                let found = schedule(&wing_file, &calibration);
                if !found.unconverged.is_empty() {
                    let message = format!("the fit did not converge: {}", found.unconverged.join(", "));
                    return Err(Failure::Computation(message));
                }
                Some((found, format!("fitted now to the marked points of `{condition}`")))
            }
            _ => {
                let message = "two conditions have points that fit corrections";
                let help = "leave `fit_every` at one of them, or name `corrections`";
                return Err(InputError::in_field(&file.path, "conditions", message).with_help(help).into());
            }
        };
        Ok(Some(Self { file: wing_file, wing, schedule }))
    }

    /// Where the corrections come from.
    pub(super) fn origin(&self) -> String {
        self.schedule.as_ref().map_or_else(|| "none".into(), |(_, origin)| origin.clone())
    }

    /// Loads of both models at all readings; none of the updated one without corrections.
    pub(super) fn calculated(
        &self,
        file: &FlightFile,
        channels: &[Channel],
        readings: &[Reading],
        rho_kg_m3: Option<f64>,
    ) -> Result<[Option<Vec<Calculated>>; 2], Failure> {
        let rho_kg_m3 = rho_kg_m3.ok_or_else(|| {
            InputError::in_field(&file.path, "wing", "the density of the air is missing")
                .with_help("give rho_kg_m3: 1.225, for instance")
        })?;
        let places =
            channels.iter().map(|channel| root_load(channel).ok_or_else(|| elsewhere(file, channel)));
        let places: Vec<usize> = places.collect::<Result<_, _>>()?;
        let mut models: [Option<Vec<Calculated>>; 2] = [None, None];
        for (model, calculated) in models.iter_mut().enumerate() {
            if model == 1 && self.schedule.is_none() {
                continue;
            }
            let of = |reading: &Reading| self.one(file, reading, (model == 1, rho_kg_m3), &places);
            *calculated = Some(readings.iter().map(of).collect::<Result<_, _>>()?);
        }
        Ok(models)
    }

    /// Loads at a reading and how they go with the state.
    fn one(
        &self,
        file: &FlightFile,
        reading: &Reading,
        (is_updated, rho_kg_m3): (bool, f64),
        places: &[usize],
    ) -> Result<Calculated, Failure> {
        let state = reading.state.as_ref().ok_or_else(|| {
            InputError::at(&reading.place, "there is no state to calculate loads at")
                .with_help("add the columns V_m_s and alpha_deg")
        })?;
        let noise = &file.state_sigma;
        let mut states = vec![state.clone()];
        if noise.alpha_deg > 0.0 {
            states.push(State { alpha_deg: state.alpha_deg + noise.alpha_deg, ..state.clone() });
        }
        if noise.v_m_s > 0.0 {
            states.push(State { v_m_s: state.v_m_s + noise.v_m_s, ..state.clone() });
        }
        let corrections = self.corrections(is_updated, state.v_m_s, reading)?;
        let all = states
            .iter()
            .map(|state| self.root(state, rho_kg_m3, &corrections, reading))
            .collect::<Result<Vec<_>, _>>()?;
        let loads: Vec<f64> = places.iter().map(|place| all[0][*place]).collect();
        let sigma = places.iter().map(|place| {
            all[1..].iter().map(|moved| (moved[*place] - all[0][*place]).powi(2)).sum::<f64>().sqrt()
        });
        Ok(Calculated { sigma: sigma.collect(), loads })
    }

    /// Lift along the span at a state.
    pub(super) fn along_the_span(
        &self,
        reading: &Reading,
        state: &State,
        is_updated: bool,
        rho_kg_m3: f64,
    ) -> Result<SpanLift, Failure> {
        let corrections = self.corrections(is_updated, state.v_m_s, reading)?;
        let flow = Flow { v_m_s: state.v_m_s, rho_kg_m3 };
        let case = SteadyCase::new(flow, state.alpha_deg.to_radians());
        let solved = self.wing.at(flow, &corrections)?.solve(&[case]);
        Ok(SpanLift::of(&self.wing, &solved[0].box_loads.values))
    }

    /// Whether there is an updated model.
    pub(super) fn is_corrected(&self) -> bool {
        self.schedule.is_some()
    }

    /// Corrections of a model at an airspeed.
    fn corrections(
        &self,
        is_updated: bool,
        v_m_s: f64,
        reading: &Reading,
    ) -> Result<Corrections, InputError> {
        match &self.schedule {
            Some((schedule, _)) if is_updated => {
                schedule.at(v_m_s).map_err(|error| InputError { span: Some(reading.place.clone()), ..error })
            }
            _ => Ok(Corrections::neutral(self.wing.correctable.len())),
        }
    }

    /// Fz, Mx and My at the balance.
    fn root(
        &self,
        state: &State,
        rho_kg_m3: f64,
        corrections: &Corrections,
        reading: &Reading,
    ) -> Result<[f64; 3], Failure> {
        let names = self.wing.control_names();
        if let Some(unknown) = state.controls_deg.keys().find(|name| !names.contains(name)) {
            let message = format!("the wing has no control {unknown}");
            return Err(InputError::at(&reading.place, message)
                .with_help(format!("its controls are {}", names.join(", ")))
                .into());
        }
        let deflection = |name: &String| state.controls_deg.get(name).copied().unwrap_or(0.0).to_radians();
        let flow = Flow { v_m_s: state.v_m_s, rho_kg_m3 };
        let case = SteadyCase {
            controls_rad: names.iter().map(deflection).collect(),
            ..SteadyCase::new(flow, state.alpha_deg.to_radians())
        };
        let solved = self.wing.at(flow, corrections)?.solve(&[case]);
        Ok(solved[0].root.to_array())
    }
}

fn elsewhere(file: &FlightFile, channel: &Channel) -> InputError {
    let message =
        format!("{} of station {} is not calculated in the tunnel", channel.load.name(), channel.station);
    InputError::in_field(&file.path, "stations", message)
        .with_help("give Fz, Mx and My of station root, or bring calculated loads in the tables")
}
