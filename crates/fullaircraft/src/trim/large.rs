//! Balanced flight of the aircraft that really bends ([`coupling::FreeBody`]), in the numbers of [`Trimmed`](crate::Trimmed).
//!
//! Loads act at the places of now, lift stands on the stream and on the bound vortices, weight and inertia are those of the bent
//! aircraft. Angle of attack and elevator are found with the shape. What is left out with small deflections
//! (drag, suction, centrifugal forces) is left out here, and the wake leaves along the fuselage, as there: a wake along the stream
//! passes the tail within millimetres at some angles, where one that is made of single vortices gives it an incidence by chance.

use crate::aircraft::assembly::{Aircraft, WingPlaces};
use crate::aircraft::file::{FlightPoint, Surfaces};
use crate::error::AircraftError;
use crate::stations::places::Station;
use crate::trim::model::FlightModel;
use crate::trim::variables::incidence_of_control;
use coupling::{FreeBody, FreeState, RootLoads, SteadyFlight, Wake};
use nalgebra::{Matrix3, Point3};
use nastran::{Span, Spc1};
use structure::Model;

/// An aircraft whose deflections may be large.
#[derive(Debug)]
pub struct LargeAircraft<'a> {
    aircraft: &'a Aircraft,
    body: FreeBody<'a>,
    wake: Wake,
}

/// The bent aircraft in balanced flight.
#[derive(Debug, Clone)]
pub struct LargeTrimmed {
    /// Where.
    pub point: FlightPoint,
    /// Angle of the centre (the wing's root) against the flow, rad.
    pub alpha_rad: f64,
    /// Elevator, trailing edge down, rad; zero with wings only.
    pub elevator_rad: f64,
    /// Rise of the right and left tip over the plane of the centre, m.
    pub tip_deflection_m: [f64; 2],
    /// From tip to tip along y, m: less than the span as they bend.
    pub spread_m: f64,
    /// What right and left wing put on the fuselage, weight and inertia included, about the wing's balance point, at the places of
    /// now; aircraft axes on both sides.
    pub root_loads: [RootLoads; 2],
    /// Largest force left over the weight at rest, and largest moment over the weight on a mean chord; with wings only nothing balances
    /// the pitching moment.
    pub unbalanced: [f64; 2],
    /// Shape and loads.
    pub flight: FreeState,
}

impl Aircraft {
    /// The aircraft for large deflections.
    ///
    /// # Errors
    /// If something in its structure cannot turn far (the card is named).
    pub fn large(&self) -> Result<LargeAircraft<'_>, AircraftError> {
        let mut bulk = self.bulk.clone();
        bulk.constraints.push(Spc1 {
            set: 1,
            components: vec![1, 2, 3, 4, 5, 6],
            grids: vec![self.free.node_ids()[self.centre]],
            enforced: 0.0,
            span: Span::generated("the hold at the wing's root"),
        });
        let model = Model::from_bulk(&bulk)?;
        Ok(LargeAircraft {
            aircraft: self,
            body: FreeBody::new(&self.flow, &model, self.centre, &self.carried)?,
            wake: Wake::Body,
        })
    }
}

impl LargeAircraft<'_> {
    /// The same with another wake than along the fuselage.
    #[must_use]
    pub fn with_wake(self, wake: Wake) -> Self {
        Self { wake, ..self }
    }

    /// Balanced flight of a model of this aircraft at a point.
    ///
    /// # Errors
    /// If no balanced equilibrium is found; with the last load factor that was reached.
    pub fn trim(&self, model: &FlightModel<'_>, point: &FlightPoint) -> Result<LargeTrimmed, AircraftError> {
        let aircraft = self.aircraft;
        let whole = aircraft.file.surfaces == Surfaces::All;
        let elevator = || incidence_of_control(aircraft, &aircraft.file.htp.control.name);
        let flight = SteadyFlight {
            flow: model.flow(point),
            load_factor: point.load_factor,
            pitch_rate_rad_s: point.pitch_rate_deg_s.to_radians(),
            about: Point3::new(aircraft.file.total.x_cg_m, 0.0, 0.0),
            control: if whole { elevator() } else { None },
            wake: self.wake,
        };
        let found = self.body.fly(&flight, &model.corrections)?;
        let chord_m = aircraft.flow.correctable.mean_chord_m();
        let largest =
            |from: usize| found.held[from..from + 3].iter().fold(0.0_f64, |most, v| most.max(v.abs()));
        let weight_n = self.body.weight_n();
        let place = |wing: &WingPlaces| found.state.places[wing.tip];
        let rise = |wing: &WingPlaces| place(wing).z - aircraft.free.points()[wing.tip].z;
        Ok(LargeTrimmed {
            point: *point,
            alpha_rad: found.alpha_rad,
            elevator_rad: found.control_rad,
            tip_deflection_m: [rise(&aircraft.right), rise(&aircraft.left)],
            spread_m: place(&aircraft.right).y - place(&aircraft.left).y,
            root_loads: [&aircraft.right, &aircraft.left].map(|wing| self.root_loads(wing, &found)),
            unbalanced: [largest(0) / weight_n, largest(3) / (weight_n * chord_m)],
            flight: found,
        })
    }

    /// Sums over the nodes of a wing at the places of now.
    fn root_loads(&self, wing: &WingPlaces, flight: &FreeState) -> RootLoads {
        let station = Station {
            name: String::new(),
            channel: String::new(),
            point: self.aircraft.root_point(),
            nodes: wing.nodes.clone(),
            axes: Matrix3::identity(),
        };
        let points: Vec<Point3<f64>> = flight.state.places.iter().map(|place| Point3::from(*place)).collect();
        let all: Vec<f64> = flight.air.iter().zip(&flight.inertia).map(|(air, own)| air + own).collect();
        let [_, _, fz, mx, my, _] = station.sums(&points, &all);
        RootLoads { fz_n: fz, mx_nm: mx, my_nm: my }
    }
}
