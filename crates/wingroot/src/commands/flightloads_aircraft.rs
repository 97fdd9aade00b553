//! Loads of an aircraft in flight at measured states: trims at the airspeed and load factor of each reading, by both models.

use std::path::Path;

use fullaircraft::{AircraftError, CasesFile, Component, FlightModel, Station, Steady, TrimTools};
use loads::flight::{Channel, Condition, Reading, Source};
use loads::{Air, FlightFile};
use nastran::{InputError, Table, named_file};

use super::flightloads_measured::MODELS;
use super::flightloads_wing::Calculated;
use crate::args::Common;
use crate::commands::fullaircraft_prepared::{FullaircraftArgs, Prepared, prepared};
use crate::failure::Failure;

/// Deflections that a trim without ailerons leaves out, deg.
const STILL_DEG: f64 = 0.5;

/// An aircraft with its stations.
pub(super) struct FlownAircraft {
    pub(super) prepared: Prepared,
    stations: Vec<Station>,
    rho_kg_m3: f64,
}

impl FlownAircraft {
    /// Of a file, with the stations of the wing's file and of a plan of design loads.
    pub(super) fn read(
        aircraft: &Path,
        plan: Option<&Path>,
        file: &FlightFile,
        common: &Common,
    ) -> Result<Self, Failure> {
        if file.wing.is_some() || file.corrections.is_some() {
            let message = "an aircraft in flight brings its own wing and corrections";
            let field = if file.wing.is_some() { "wing" } else { "corrections" };
            let help = "leave out `wing` and `corrections` where --aircraft is named";
            return Err(InputError::in_field(&file.path, field, message).with_help(help).into());
        }
        let asked =
            FullaircraftArgs { aircraft: Some(aircraft.to_path_buf()), ..FullaircraftArgs::default() };
        let prepared = prepared(&asked, common)?;
        let plan = plan.map(CasesFile::read).transpose()?.unwrap_or_default();
        let stations = prepared.aircraft.loads_stations(&plan)?;
        let rho_kg_m3 = file.rho_kg_m3.unwrap_or(Air::at(0.0).rho_kg_m3);
        Ok(Self { prepared, stations, rho_kg_m3 })
    }

    /// Loads of both models at all readings of a condition.
    pub(super) fn calculated(
        &self,
        file: &FlightFile,
        condition: &Condition,
        channels: &[Channel],
        readings: &[Reading],
    ) -> Result<[Option<Vec<Calculated>>; 2], Failure> {
        self.refuse_rolls(file, condition)?;
        let places: Vec<(usize, usize)> =
            channels.iter().map(|channel| self.place(file, channel)).collect::<Result<_, _>>()?;
        let mut models: [Option<Vec<Calculated>>; 2] = [None, None];
        for (model, calculated) in models.iter_mut().enumerate() {
            let is_initial = MODELS[model] == "initial";
            let aircraft = if is_initial { &self.prepared.aircraft } else { self.prepared.updated() };
            let tools = TrimTools::new(aircraft, &[])?;
            let flown = if is_initial {
                aircraft.uncorrected()
            } else {
                aircraft.with_corrections(&self.prepared.corrections)?
            };
            let flown = flown.in_air(self.rho_kg_m3);
            let one = |reading: &Reading| self.one(&tools, &flown, reading, file.state_sigma.v_m_s, &places);
            *calculated = Some(readings.iter().map(one).collect::<Result<_, Failure>>()?);
        }
        Ok(models)
    }

    /// The station and load of a channel; `root` and other points of the wing are those of the right one.
    fn place(&self, file: &FlightFile, channel: &Channel) -> Result<(usize, usize), InputError> {
        let right = format!("right {}", channel.station);
        let of = |station: &Station| station.name == channel.station || station.name == right;
        let place = self.stations.iter().position(of).ok_or_else(|| {
            let names: Vec<&str> = self.stations.iter().map(|station| station.name.as_str()).collect();
            let message = format!("the aircraft has no station {}", channel.station);
            InputError::in_field(&file.path, "stations", message)
                .with_help(format!("there are {}; more come with --plan", names.join(", ")))
        })?;
        Ok((place, channel.load.place()))
    }

    /// Trims know no ailerons: a condition that moved them brings its calculated loads.
    fn refuse_rolls(&self, file: &FlightFile, condition: &Condition) -> Result<(), InputError> {
        let (Source::Points(name) | Source::History(name, _)) = &condition.source else {
            let message = format!("`{}` is none of points and histories", condition.name);
            return Err(InputError::in_field(&file.path, "conditions", message)
                .with_help("leave out --aircraft for campaigns and sections of a wing in the tunnel"));
        };
        let table = Table::read(&named_file(&file.path, name)?)?;
        let moves = ["p_deg_s", "r_deg_s", "beta_deg"];
        for column in table.columns() {
            let of_wing = column.strip_prefix("delta_").and_then(|rest| rest.strip_suffix("_deg"));
            if !of_wing.is_some_and(|name| self.is_aileron(name)) && !moves.contains(&column) {
                continue;
            }
            if let Some(row) = (0..table.len())
                .find(|row| table.number(*row, column).is_ok_and(|value| value.abs() > STILL_DEG))
            {
                let message = format!("{column} is not zero, and flight is calculated wings level");
                return Err(InputError::at(&table.span(row, column), message).with_help(
                    "bring calculated loads of rolls and turns in columns such as updated_root_Mx_Nm",
                ));
            }
        }
        Ok(())
    }

    /// Whether a control is one of the wing's.
    fn is_aileron(&self, name: &str) -> bool {
        let planform = self.prepared.wing.file.planform();
        planform.is_none_or(|planform| planform.controls.iter().any(|control| control.name == name))
    }

    fn one(
        &self,
        tools: &TrimTools<'_>,
        model: &FlightModel<'_>,
        reading: &Reading,
        noise_m_s: f64,
        places: &[(usize, usize)],
    ) -> Result<Calculated, Failure> {
        let missing = |what: &str| {
            InputError::at(&reading.place, format!("there is no {what} to calculate loads at"))
                .with_help("add the columns V_m_s and n_z (1 in level flight)")
        };
        let v_m_s = reading.v_m_s.ok_or_else(|| missing("airspeed"))?;
        let n_z = reading.n_z.ok_or_else(|| missing("load factor"))?;
        let at = |v_m_s: f64| -> Result<Vec<f64>, Failure> {
            let wrong = |error: AircraftError| match error {
                AircraftError::NotTrimmable { .. } => Failure::Input(
                    InputError::at(&reading.place, format!("the aircraft cannot be trimmed here: {error}"))
                        .with_help("take the row out, or bring its calculated loads"),
                ),
                other => other.into(),
            };
            let at = tools.at(model, v_m_s).map_err(wrong)?;
            let case = Steady::Pull { load_factor: n_z }.case(&tools.aircraft.file, v_m_s);
            let net = at.nodal_loads(&at.solve(&case).map_err(wrong)?).of(Component::Net);
            let points = tools.aircraft.free.points();
            Ok(places.iter().map(|(place, load)| self.stations[*place].sums(points, &net)[*load]).collect())
        };
        let loads = at(v_m_s)?;
        let sigma = if noise_m_s > 0.0 {
            at(v_m_s + noise_m_s)?.iter().zip(&loads).map(|(moved, load)| (moved - load).abs()).collect()
        } else {
            vec![0.0; loads.len()]
        };
        Ok(Calculated { loads, sigma })
    }
}
