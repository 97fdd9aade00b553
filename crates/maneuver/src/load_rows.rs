//! Loads that are looked at: rows by which box loads and accelerations give the loads at the balance, at monitoring
//! stations and of strips.
//!
//! A load is a sum of forces: `rows P + inertia (M r c - M Phi xi'')`, both over what the station counts as its own: all
//! that is metric for the balance, all boxes and grids outboard of a monitoring station, a strip's boxes.

use coupling::wing_file::StationAt;
use coupling::{ElasticWing, WingFile, station_rows, strip_rows};
use faer::{Mat, MatRef};
use nalgebra::Point3;
use structure::System;

/// A station along the span where the loads of everything outboard of it are given.
#[derive(Debug, Clone, PartialEq)]
pub struct Station {
    /// Name, part of the channels' names.
    pub name: String,
    /// Reference point of the moments; what has a larger y counts.
    pub point: Point3<f64>,
}

impl Station {
    /// The stations of a wing's file.
    pub fn of_wing(file: &WingFile) -> Vec<Self> {
        let balance = file.balance;
        let one = |at: &StationAt| Self {
            name: at.name.clone(),
            point: Point3::new(at.x_m.unwrap_or(balance.x_m), at.y_m, at.z_m.unwrap_or(balance.z_m)),
        };
        file.stations.iter().map(one).collect()
    }
}

/// Rows of loads with the names of their channels.
#[derive(Debug, Clone)]
pub(crate) struct LoadRows {
    /// Channels.
    pub(crate) names: Vec<String>,
    /// Rows by 2 a box: loads of box loads.
    pub(crate) air: Mat<f64>,
    /// Rows by fields: loads of the weight in unit fields of acceleration.
    pub(crate) by_fields: Mat<f64>,
    /// Rows by modes: momentum of the modes, `Phiᵀ M` seen from the rows.
    pub(crate) by_modes: Mat<f64>,
}

/// Structure in motion: inertia loads on the g-set of the fields and of the modes.
pub(crate) struct Momentum<'a> {
    pub(crate) system: &'a System,
    pub(crate) fields: MatRef<'a, f64>,
    pub(crate) modes: MatRef<'a, f64>,
}

impl LoadRows {
    /// Loads on the balance: Fz, Mx, My.
    pub(crate) fn balance(wing: &ElasticWing, momentum: Option<&Momentum<'_>>, fields: usize) -> Self {
        let names = ["Fz_N", "Mx_Nm", "My_Nm"].map(String::from).to_vec();
        let rigid = momentum.map(|m| {
            let all = m.system.rigid_body(&wing.balance.point);
            Mat::from_fn(3, all.nrows(), |row, dof| all[(dof, row + 2)])
        });
        Self::new(names, wing.root_rows.clone(), rigid, momentum, fields)
    }

    /// Shear, bending and torsion at a station: Fz up, Mx tip up, My nose up, about its point.
    pub(crate) fn station(
        wing: &ElasticWing,
        station: &Station,
        momentum: Option<&Momentum<'_>>,
        fields: usize,
    ) -> Self {
        let names = ["Fz", "Mx", "My"]
            .map(|load| format!("{load}_{}_{}", station.name, if load == "Fz" { "N" } else { "Nm" }));
        let at = &station.point;
        let air = station_rows(&wing.lattice, &wing.balance, at);
        let rigid = momentum.map(|m| {
            let all = m.system.rigid_body(at);
            let outboard = |dof: usize| m.system.points()[dof / 6].y > at.y;
            Mat::from_fn(3, all.nrows(), |row, dof| if outboard(dof) { all[(dof, row + 2)] } else { 0.0 })
        });
        Self::new(names.to_vec(), air, rigid, momentum, fields)
    }

    /// Lift per metre of span of every strip of the correctable boxes (air alone), N/m.
    pub(crate) fn strips(wing: &ElasticWing, fields: usize, modes: usize) -> Self {
        let air = strip_rows(&wing.lattice, &wing.correctable);
        let count = air.nrows();
        Self {
            names: (0..count).map(|strip| format!("lift_strip_{}_N_m", strip + 1)).collect(),
            by_fields: Mat::zeros(count, fields),
            by_modes: Mat::zeros(count, modes),
            air,
        }
    }

    fn new(
        names: Vec<String>,
        air: Mat<f64>,
        rigid: Option<Mat<f64>>,
        momentum: Option<&Momentum<'_>>,
        fields: usize,
    ) -> Self {
        let rows = names.len();
        let (by_fields, by_modes) = match (rigid, momentum) {
            (Some(rigid), Some(m)) => (&rigid * m.fields, &rigid * m.modes),
            _ => (Mat::zeros(rows, fields), Mat::zeros(rows, 0)),
        };
        Self { names, air, by_fields, by_modes }
    }

    /// One below the other.
    pub(crate) fn stacked(parts: &[Self]) -> Self {
        let stack = |of: fn(&Self) -> &Mat<f64>| {
            let rows: Vec<(&Mat<f64>, usize)> =
                parts.iter().flat_map(|part| (0..part.names.len()).map(move |row| (of(part), row))).collect();
            Mat::from_fn(rows.len(), of(&parts[0]).ncols(), |i, j| rows[i].0[(rows[i].1, j)])
        };
        Self {
            names: parts.iter().flat_map(|part| part.names.clone()).collect(),
            air: stack(|part| &part.air),
            by_fields: stack(|part| &part.by_fields),
            by_modes: stack(|part| &part.by_modes),
        }
    }
}

#[cfg(test)]
mod tests;
