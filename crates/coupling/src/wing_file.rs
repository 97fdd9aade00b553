//! The RON file that describes a wing to every command: geometry and structure (parametric or a deck), where it
//! is held and measured, and the settings of its calibration.
//!
//! Reading checks everything, the files it names included, so that later steps meet no bad input.

mod deck_source;
mod deflection;
mod departure;
mod effects;
mod geometry;
mod hash;
mod known;
mod prior;
mod servos;
mod stations;
mod write;

pub use crate::planform::Mount;
pub use deck_source::DeckSource;
pub use deflection::{DeflectionRow, DeflectionTable, OutsideAirspeeds};
pub use departure::Departure;
pub use effects::{EffectValidity, WingEffect};
pub use geometry::Geometry;
pub use hash::of_text as fingerprint;
pub use known::KnownTo;
pub use prior::CorrectionPrior;
pub use servos::Servos;
pub use stations::StationAt;
pub use write::Rewritten;

use crate::planform::{AXIS_SET, FAIRING_PANEL, Fault, Planform, ROOT_SET};
use nastran::{BulkData, Divisions, InputError, MonitorPoint, Span, named_file, place_of, ron_file};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};

/// A wing as its file describes it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "Wing")]
pub struct WingFile {
    /// What reports call it.
    pub name: String,
    /// Geometry, structure and boxes.
    pub source: Source,
    /// The plane of symmetry at the root; left out: [`RootPlane::Symmetric`] at the inner edge of the innermost
    /// box.
    #[serde(default, skip_serializing_if = "Option::is_none", with = "root_plane_field")]
    #[schemars(with = "RootPlane")]
    pub root_plane: Option<RootPlane>,
    /// Where root loads are measured; axes pitch with the wing.
    pub balance: BalancePoint,
    /// x of the axis the wing is pitched about; left out: the balance's.
    #[serde(default)]
    pub pitch_axis_x_m: Option<f64>,
    /// Whether the fairing's loads reach the balance.
    #[serde(default)]
    pub fairing_metric: bool,
    /// Modal damping ratio of the structure, a share of critical damping.
    #[serde(default = "default_damping")]
    pub damping_ratio: f64,
    /// What stands between commanded deflections and control surfaces; left out: servos of 15 Hz and 0.8, known to a tenth.
    #[serde(default, skip_serializing_if = "Servos::is_default")]
    pub servos: Servos,
    /// How well the tests before the tunnel leave the rest known, one standard deviation each.
    #[serde(default, skip_serializing_if = "KnownTo::is_default")]
    pub known_to: KnownTo,
    /// How boxes follow the structure.
    #[serde(default)]
    pub spline: SplineKind,
    /// Whether the wing's deflections are small (left out) or as large as they come.
    #[serde(default, skip_serializing_if = "Geometry::is_default")]
    pub geometry: Geometry,
    /// The grid whose height is the tip deflection (a sensor's or point mass's of a parametric wing is 3001 or
    /// 4001 and up); left out: the grid the boxes follow that has the largest y.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub tip_grid: Option<u32>,
    /// The unknowns of the calibration.
    pub correction: CorrectionSettings,
    /// How much of a commanded deflection acts, by control surface, airspeed and deflection; left out: all of it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub deflection: Vec<DeflectionTable>,
    /// Where along the span loads are given beside the balance's.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub stations: Vec<StationAt>,
    /// Effects beyond this model, with their parameters: `maneuver::effects` says which there are.
    #[serde(default)]
    pub effects: Vec<WingEffect>,
    /// The file as it was named when read.
    #[serde(skip)]
    pub path: PathBuf,
    /// Fingerprint of the file and the files it names: 16 hexadecimal digits of the FNV-1a hash of their texts
    /// (line ends unified), the same on every platform. Corrections carry it to show whose they are.
    #[serde(skip)]
    pub hash: String,
    /// What the wing departs from its drawing by. No file says it: wings of an ensemble have it.
    #[serde(skip)]
    pub departure: Departure,
}

/// Where geometry, structure and boxes come from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub enum Source {
    /// A trapezoidal wing given by its dimensions.
    Parametric(Planform),
    /// A Nastran bulk data deck.
    Deck(DeckSource),
}

/// What the flow meets at the root.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub enum RootPlane {
    /// Nothing: the root is a free edge.
    None,
    /// A wall or the other half of the wing: a plane of symmetry at this y, m.
    Symmetric(f64),
}

/// A point in the wing's axes.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct BalancePoint {
    /// Aft.
    pub x_m: f64,
    /// To the right tip.
    pub y_m: f64,
    /// Up.
    pub z_m: f64,
}

/// How box displacements follow grid displacements.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
pub enum SplineKind {
    /// A beam spline along the spline grids, for wings with an elastic axis.
    #[default]
    Beam,
    /// Each box moves rigidly with the nearest spline grid.
    NearestNode,
}

/// The shape of the corrections: polynomials in span, one for each chord strip.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CorrectionSettings {
    /// Strips along the chord; each is one or several rows of boxes, so it divides the number of rows.
    pub chord_strips: usize,
    /// Degree of the polynomial in span.
    pub span_order: usize,
    /// Largest difference between chordwise neighbours.
    #[serde(default = "default_neighbour_bound")]
    pub neighbour_bound: f64,
    /// What corrections are expected to be before any data: intervals of predictions rest on it.
    #[serde(default, skip_serializing_if = "CorrectionPrior::is_default")]
    pub prior: CorrectionPrior,
}

/// `root_plane: None` in the file is a choice ([`RootPlane::None`]), not an absent field.
mod root_plane_field {
    use super::RootPlane;
    use serde::{Deserialize, Deserializer, Serialize, Serializer};

    #[expect(clippy::ref_option, reason = "the signature serde calls")]
    pub(super) fn serialize<S: Serializer>(
        plane: &Option<RootPlane>,
        serializer: S,
    ) -> Result<S::Ok, S::Error> {
        plane.unwrap_or(RootPlane::None).serialize(serializer)
    }

    pub(super) fn deserialize<'de, D: Deserializer<'de>>(source: D) -> Result<Option<RootPlane>, D::Error> {
        RootPlane::deserialize(source).map(Some)
    }
}

fn default_damping() -> f64 {
    0.02
}

fn default_neighbour_bound() -> f64 {
    0.05
}

impl WingFile {
    /// Reads and checks a wing's file and every file it names.
    ///
    /// # Errors
    /// If a file is missing or says something that cannot be: with file, line and column.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let text = nastran::read_text(path)?;
        let mut wing: Self = ron_file::read(path)?;
        wing.path = path.to_path_buf();
        wing.check().map_err(|fault| fault.at(&place_of(&[&fault.anchor], &text, path)))?;
        let files = wing.named_files()?;
        let bulk = wing.bulk(Mount::Tunnel)?;
        wing.check_chord_strips(&bulk).map_err(|fault| fault.at(&place_of(&[&fault.anchor], &text, path)))?;
        deflection::check(&wing.deflection, &bulk, &text, path)?;
        effects::check(&wing.effects, &text, path)?;
        if let Source::Deck(deck) = &wing.source {
            deck.check(&bulk).map_err(|fault| fault.at(&place_of(&[&fault.anchor], &text, path)))?;
        }
        wing.hash = hash::of_files(&text, &files)?;
        Ok(wing)
    }

    /// The wing as bulk data. In the tunnel: with fairing, clamped root and the balance as MONPNT3 `ROOT`; as
    /// half an aircraft: without them. A deck in the tunnel is taken as it is.
    ///
    /// # Errors
    /// If the deck, airfoil or beam table cannot be read.
    pub fn bulk(&self, mount: Mount) -> Result<BulkData, InputError> {
        let mut bulk = self.as_drawn(mount)?;
        self.departure.put_into(&mut bulk);
        Ok(bulk)
    }

    fn as_drawn(&self, mount: Mount) -> Result<BulkData, InputError> {
        match &self.source {
            Source::Deck(deck) => deck.bulk(&self.folder(), mount),
            Source::Parametric(planform) => {
                let BalancePoint { x_m, y_m, z_m } = self.balance;
                let balance = nalgebra::Point3::new(x_m, y_m, z_m);
                let mut bulk = planform.bulk_on_balance(&self.folder(), mount, &balance)?;
                if mount == Mount::Tunnel && planform.structure.is_some() {
                    bulk.monitors.push(self.root_monitor());
                }
                Ok(bulk)
            }
        }
    }

    /// Panels (CAERO1 numbers) that disturb the flow but are neither measured nor corrected.
    pub fn fairing_panel_ids(&self) -> Vec<u32> {
        match &self.source {
            Source::Parametric(planform) => planform.fairing.iter().map(|_| FAIRING_PANEL).collect(),
            Source::Deck(deck) => deck.fairing_panels.clone(),
        }
    }

    /// Grids the boxes follow. The one with the largest y is where tip deflections are read, unless `tip_grid` says
    /// otherwise.
    pub fn spline_grid_ids(&self, bulk: &BulkData) -> Vec<u32> {
        match &self.source {
            Source::Parametric(_) => bulk.sets.get(&AXIS_SET).map_or_else(Vec::new, |set| set.ids.clone()),
            Source::Deck(deck) => deck.spline_grid_ids(bulk),
        }
    }

    /// x of the axis the wing is pitched about.
    pub fn pitch_axis_x(&self) -> f64 {
        self.pitch_axis_x_m.unwrap_or(self.balance.x_m)
    }

    /// The parametric wing, unless the wing is a deck.
    pub fn planform(&self) -> Option<&Planform> {
        match &self.source {
            Source::Parametric(planform) => Some(planform),
            Source::Deck(_) => None,
        }
    }

    /// The largest deflection of a control surface, degrees, if the file gives one (a deck cannot).
    pub fn deflection_limit_deg(&self, control: &str) -> Option<f64> {
        self.planform()?.controls.iter().find(|surface| surface.name == control)?.limit_deg
    }

    /// The folder that relative file names start from.
    pub fn folder(&self) -> PathBuf {
        self.path.parent().unwrap_or_else(|| Path::new("")).to_path_buf()
    }

    fn root_monitor(&self) -> MonitorPoint {
        MonitorPoint {
            name: "ROOT".to_owned(),
            label: "BALANCE".to_owned(),
            axes: vec![1, 2, 3, 4, 5, 6],
            set: ROOT_SET.to_string(),
            cp: 0,
            xyz: nalgebra::Point3::new(self.balance.x_m, self.balance.y_m, self.balance.z_m),
            cd: 0,
            is_structural: true,
            span: Span::whole_file(&self.path),
        }
    }

    fn named_files(&self) -> Result<Vec<PathBuf>, InputError> {
        match &self.source {
            Source::Deck(deck) => Ok(vec![named_file(&self.path, &deck.file)?]),
            Source::Parametric(planform) => {
                let distribution = planform.structure.as_ref().and_then(|structure| structure.distribution());
                let names = planform.airfoil.iter().chain(distribution);
                names.map(|name| named_file(&self.path, name)).collect()
            }
        }
    }

    fn check(&self) -> Result<(), Fault> {
        use crate::planform::check::{count, positive, within};
        for (field, value) in
            [("x_m", self.balance.x_m), ("y_m", self.balance.y_m), ("z_m", self.balance.z_m)]
        {
            within(field, value, -1e4, 1e4)?;
        }
        within("pitch_axis_x_m", self.pitch_axis_x(), -1e4, 1e4)?;
        if let Some(RootPlane::Symmetric(y_m)) = self.root_plane {
            within("root_plane", y_m, -1e4, 1e4)?;
        }
        within("damping_ratio", self.damping_ratio, 0.0, 0.5)?;
        self.servos.check()?;
        for (field, value, most) in self.known_to.values() {
            within(field, value, 0.0, most)?;
        }
        stations::check(&self.stations)?;
        count("chord_strips", self.correction.chord_strips, 1, 100)?;
        count("span_order", self.correction.span_order, 0, 8)?;
        positive("neighbour_bound", self.correction.neighbour_bound)?;
        for (field, value, least) in self.correction.prior.values() {
            within(field, value, least, 10.0)?;
        }
        self.planform().map_or(Ok(()), Planform::check)
    }

    /// Each chord strip must be made of whole rows of boxes on every panel that is corrected.
    fn check_chord_strips(&self, bulk: &BulkData) -> Result<(), Fault> {
        let strips = self.correction.chord_strips;
        let fairing = self.fairing_panel_ids();
        for panel in bulk.panels.values().filter(|panel| !fairing.contains(&panel.id)) {
            let rows = match panel.chord_divisions {
                Divisions::Equal(rows) => rows as usize,
                Divisions::Aefact(id) => {
                    bulk.factors.get(&id).map_or(0, |list| list.values.len().saturating_sub(1))
                }
            };
            if rows % strips != 0 {
                let message =
                    format!("chord_strips is {strips}, which does not divide the {rows} boxes of a chord");
                return Err(Fault::field(
                    "chord_strips",
                    message,
                    "a chord strip is one or several rows of boxes",
                ));
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests;
