//! The wing as its files say it: planform, control surfaces, the beam's table, masses.

mod planform;
pub(crate) mod polars;
pub(crate) mod table;

pub use planform::Planform;
pub use polars::{Polars, Section};

use crate::fault::{Fault, text_of};
use serde::Deserialize;
use std::path::Path;
use table::Table;

/// A control surface.
#[derive(Debug, Clone, PartialEq)]
pub struct Control {
    /// Name.
    pub name: String,
    /// Inner and outer end, m.
    pub y_m: (f64, f64),
    /// Chord of the surface over that of the wing.
    pub chord_share: f64,
}

/// A mass that is not in the beam's table.
#[derive(Debug, Clone, PartialEq)]
pub struct Lump {
    /// Place along the span, m.
    pub y_m: f64,
    /// Place along the chord, 0 at the leading edge.
    pub x_over_c: f64,
    /// Mass, kg.
    pub mass_kg: f64,
}

/// The beam's table, by station.
#[derive(Debug, Clone, PartialEq)]
pub struct Stations {
    /// Place along the span, m.
    pub y_m: Vec<f64>,
    /// Bending stiffness about the axis, N m².
    pub bending_n_m2: Vec<f64>,
    /// Torsional stiffness, N m².
    pub torsion_n_m2: Vec<f64>,
    /// Mass per unit of span, kg/m.
    pub mass_kg_m: Vec<f64>,
    /// Pitch inertia per unit of span about the section's centre of gravity, kg m.
    pub inertia_kg_m: Vec<f64>,
    /// Centre of gravity, 0 at the leading edge, 1 at the trailing edge.
    pub mass_x_over_c: Vec<f64>,
    /// Elastic axis likewise.
    pub axis_x_over_c: Vec<f64>,
}

/// See the module.
#[derive(Debug, Clone, PartialEq)]
pub struct Wing {
    /// Outline.
    pub planform: Planform,
    /// Inner edge of the fairing at the wall, m; at or below zero.
    pub wall_y_m: f64,
    /// Control surfaces.
    pub controls: Vec<Control>,
    /// The beam.
    pub stations: Stations,
    /// Masses beside it.
    pub lumps: Vec<Lump>,
    /// Balance point, m.
    pub balance_x_m: f64,
    /// Axis of pitch, m.
    pub pitch_x_m: f64,
    /// Modal damping over critical.
    pub damping_ratio: f64,
}

#[derive(Deserialize)]
#[serde(rename = "Wing")]
struct File {
    source: Source,
    balance: Point,
    root_plane: Option<Plane>,
    pitch_axis_x_m: Option<f64>,
    damping_ratio: Option<f64>,
}

#[derive(Deserialize)]
enum Plane {
    Symmetric(f64),
    None,
}

#[derive(Deserialize)]
enum Source {
    Parametric(Parametric),
}

#[derive(Deserialize)]
struct Parametric {
    semispan_m: f64,
    root_chord_m: f64,
    tip_chord_m: f64,
    quarter_chord_sweep_deg: f64,
    #[serde(default)]
    dihedral_deg: f64,
    #[serde(default)]
    twist_deg: (f64, f64),
    #[serde(default)]
    root_leading_edge_x_m: f64,
    boxes: Boxes,
    fairing: Option<Fairing>,
    #[serde(default)]
    controls: Vec<ControlOf>,
    structure: Structure,
}

#[derive(Deserialize)]
struct Boxes {
    chordwise: u32,
    spanwise: u32,
}

#[derive(Deserialize)]
struct Fairing {
    width_m: f64,
}

#[derive(Deserialize)]
struct ControlOf {
    name: String,
    strips: (u32, u32),
    chord_boxes: u32,
}

#[derive(Deserialize)]
enum Structure {
    Beam(BeamOf),
}

#[derive(Deserialize)]
struct BeamOf {
    distribution: String,
    #[serde(default)]
    point_masses: Vec<MassOf>,
    #[serde(default)]
    sensors: Vec<MassOf>,
}

#[derive(Deserialize)]
struct MassOf {
    y_m: f64,
    x_over_c: f64,
    mass_kg: f64,
}

#[derive(Deserialize)]
struct Point {
    x_m: f64,
}

impl Wing {
    /// Reads a wing's file and the table of its beam.
    ///
    /// # Errors
    /// A file that cannot be read, or whose wing is no parametric one with a beam.
    pub fn read(path: &Path) -> Result<Self, Fault> {
        let options =
            ron::Options::default().with_default_extension(ron::extensions::Extensions::IMPLICIT_SOME);
        let file: File = options.from_str(&text_of(path)?).map_err(|error| Fault::new(path, error))?;
        let (Source::Parametric(of), balance_x_m) = (file.source, file.balance.x_m);
        if of.dihedral_deg != 0.0 || of.twist_deg != (0.0, 0.0) {
            return Err(Fault::new(
                path,
                "the vortices of this program lie in a plane: no dihedral, no twist",
            ));
        }
        let wall_y_m = of.fairing.map_or(0.0, |fairing| -fairing.width_m);
        if let Some(Plane::Symmetric(y_m)) = file.root_plane
            && (y_m - wall_y_m).abs() > 1e-9
        {
            return Err(Fault::new(path, "the plane of symmetry is not where the fairing ends"));
        }
        if matches!(file.root_plane, Some(Plane::None)) {
            return Err(Fault::new(path, "this program flies a wing beside a wall, and this one has none"));
        }
        let Structure::Beam(beam) = of.structure;
        let stations = Stations::read(&path.with_file_name(beam.distribution))?;
        let strips = f64::from(of.boxes.spanwise);
        let control = |control: ControlOf| Control {
            name: control.name,
            y_m: (
                of.semispan_m * f64::from(control.strips.0 - 1) / strips,
                of.semispan_m * f64::from(control.strips.1) / strips,
            ),
            chord_share: f64::from(control.chord_boxes) / f64::from(of.boxes.chordwise),
        };
        let lump = |mass: MassOf| Lump { y_m: mass.y_m, x_over_c: mass.x_over_c, mass_kg: mass.mass_kg };
        Ok(Self {
            planform: Planform {
                semispan_m: of.semispan_m,
                root_chord_m: of.root_chord_m,
                tip_chord_m: of.tip_chord_m,
                sweep_rad: of.quarter_chord_sweep_deg.to_radians(),
                root_leading_x_m: of.root_leading_edge_x_m,
            },
            wall_y_m,
            controls: of.controls.into_iter().map(control).collect(),
            stations,
            lumps: beam.point_masses.into_iter().chain(beam.sensors).map(lump).collect(),
            balance_x_m,
            pitch_x_m: file.pitch_axis_x_m.unwrap_or(balance_x_m),
            damping_ratio: file.damping_ratio.unwrap_or(0.02),
        })
    }
}

impl Stations {
    fn read(path: &Path) -> Result<Self, Fault> {
        let table = Table::read(path)?;
        let column = |name: &str| table.column(name, path);
        Ok(Self {
            y_m: column("y_m")?,
            bending_n_m2: column("EI_flap_Nm2")?,
            torsion_n_m2: column("GJ_Nm2")?,
            mass_kg_m: column("mass_per_span_kg_m")?,
            inertia_kg_m: column("Itheta_kgm")?,
            mass_x_over_c: column("xcg_over_c")?,
            axis_x_over_c: column("xea_over_c")?,
        })
    }

    /// A column's value at a place of the span.
    pub(crate) fn at(&self, column: &[f64], y_m: f64) -> f64 {
        table::between(&self.y_m, column, y_m)
    }
}
