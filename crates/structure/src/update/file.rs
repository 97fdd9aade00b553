//! The file of measurements and regions: RON, or a CSV of frequencies alone.
//!
//! Components are digits 1 to 6 in basic axes; modes are numbered from 1. A region is all elements that pass every
//! condition it gives; places are the means of an element's nodes, from the first number (included) to the second
//! (not).

use super::measurements::{MeasuredDeflection, MeasuredMode, Measurements, Parameter, Quantity};
use crate::model::Model;
use crate::model::registry::{self, ElementCard, Visitor};
use crate::system::System;
use nalgebra::Point3;
use nastran::{BulkData, InputError, Table, ron_file};
use schemars::JsonSchema;
use serde::Deserialize;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Highest mode of a model that a measured one may be: as many are computed.
const MOST_MODES: usize = 200;

/// A file of measurements as it stands.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, rename = "Measured")]
pub struct MeasuredFile {
    /// Natural modes.
    #[serde(default)]
    pub modes: Vec<ModeEntry>,
    /// Deflections under loads.
    #[serde(default)]
    pub deflections: Vec<DeflectionEntry>,
    /// Total mass.
    #[serde(default)]
    pub mass: Option<MassEntry>,
    /// Regions whose stiffness or mass is fitted.
    #[serde(default)]
    pub regions: Vec<RegionEntry>,
    /// The file as it was named.
    #[serde(skip)]
    pub path: PathBuf,
}

/// A measured mode.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ModeEntry {
    /// Name; left out: its number in the list.
    #[serde(default)]
    pub name: Option<String>,
    /// Frequency.
    pub frequency_hz: f64,
    /// One standard deviation.
    pub sigma_hz: f64,
    /// The shape at the grids where it was measured, in any scale.
    #[serde(default)]
    pub shape: Vec<MotionEntry>,
    /// The model's mode, from 1, for a mode without a shape; left out: its place in the list.
    #[serde(default)]
    pub mode: Option<usize>,
}

/// A value at one component of a grid.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MotionEntry {
    /// Grid.
    pub grid: u32,
    /// 1 to 6, basic axes.
    pub component: u8,
    /// The value.
    pub value: f64,
}

/// A measured deflection.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DeflectionEntry {
    /// Its name.
    pub name: String,
    /// Loads, N and Nm.
    pub loads: Vec<MotionEntry>,
    /// Grid that was looked at.
    pub grid: u32,
    /// 1 to 6, basic axes.
    pub component: u8,
    /// The deflection by the loads alone, m or rad.
    pub value: f64,
    /// One standard deviation.
    pub sigma: f64,
}

/// A measured mass.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MassEntry {
    /// The mass.
    pub kg: f64,
    /// One standard deviation.
    pub sigma_kg: f64,
}

/// A region and what is fitted of it.
#[derive(Debug, Clone, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RegionEntry {
    /// Its name.
    pub name: String,
    /// Element numbers.
    #[serde(default)]
    pub elements: Option<BTreeSet<u32>>,
    /// Property numbers (PBAR, PSHELL, ...).
    #[serde(default)]
    pub properties: Option<BTreeSet<u32>>,
    /// Range of x.
    #[serde(default)]
    pub x_m: Option<(f64, f64)>,
    /// Range of y.
    #[serde(default)]
    pub y_m: Option<(f64, f64)>,
    /// Range of z.
    #[serde(default)]
    pub z_m: Option<(f64, f64)>,
    /// What is fitted.
    pub fit: Vec<Quantity>,
}

impl MeasuredFile {
    /// Reads a file; one whose name ends in `.csv` has the columns `frequency_hz,sigma_hz`, a row a mode.
    ///
    /// # Errors
    /// If it cannot be read or does not say what is expected.
    pub fn read(path: &Path) -> Result<Self, InputError> {
        let is_csv = path.extension().is_some_and(|kind| kind.eq_ignore_ascii_case("csv"));
        let mut file = if is_csv { Self::of_table(path)? } else { ron_file::read::<Self>(path)? };
        file.path = path.to_path_buf();
        if file.modes.is_empty() && file.deflections.is_empty() && file.mass.is_none() {
            return Err(InputError::in_file(path, "nothing is measured here")
                .with_help("give modes, deflections or the mass"));
        }
        Ok(file)
    }

    fn of_table(path: &Path) -> Result<Self, InputError> {
        let table = Table::read(path)?;
        let columns = [table.numbers("frequency_hz")?, table.numbers("sigma_hz")?];
        let mode = |(&frequency_hz, &sigma_hz): (&f64, &f64)| ModeEntry {
            name: None,
            frequency_hz,
            sigma_hz,
            shape: Vec::new(),
            mode: None,
        };
        Ok(Self { modes: columns[0].iter().zip(&columns[1]).map(mode).collect(), ..Self::default() })
    }

    /// Two measurements of one name could not be told apart in results.
    fn refuse_twins(&self) -> Result<(), InputError> {
        let mut names = BTreeSet::new();
        let modes = self.modes.iter().filter_map(|mode| mode.name.as_deref()).map(|name| ("modes", name));
        let deflections = self.deflections.iter().map(|entry| ("deflections", entry.name.as_str()));
        let regions = self.regions.iter().map(|region| ("regions", region.name.as_str()));
        for (kind, name) in modes.chain(deflections).chain(regions) {
            if !names.insert((kind, name)) {
                let message = format!("two of the {kind} are called \"{name}\"");
                return Err(InputError::in_field(&self.path, kind, message)
                    .with_help("give each a name of its own: results are told apart by it"));
            }
        }
        Ok(())
    }

    /// The number of a mode is one that the model may have.
    fn check_mode(&self, name: &str, mode: Option<usize>, free: usize) -> Result<(), InputError> {
        let most = free.min(MOST_MODES);
        let message = match mode {
            Some(0) => format!("{name}: modes are numbered from 1"),
            Some(mode) if mode > most => {
                format!("{name} is the model's mode {mode}, and the model has {free} free motions")
            }
            _ => return Ok(()),
        };
        Err(InputError::in_field(&self.path, "mode", message).with_help(format!("expected 1 to {most}")))
    }

    /// The measurements, with grids and components as degrees of freedom of a system.
    ///
    /// # Errors
    /// If a grid is not there, a component is none, or a number cannot be.
    pub fn measurements(&self, system: &System) -> Result<Measurements, InputError> {
        let wrong = |field: &str, message: String| InputError::in_field(&self.path, field, message);
        let positive = |field: &str, what: &str, value: f64| {
            let fine = value > 0.0 && value.is_finite();
            if fine {
                Ok(value)
            } else {
                Err(wrong(field, format!("{what} is {value}, not a positive number")))
            }
        };
        let motion = |what: &str, grid: u32, component: u8| {
            let node = system.node_index(grid);
            let node = node.ok_or_else(|| wrong(what, format!("{what}: GRID {grid} is not in the model")))?;
            if !(1..=6).contains(&component) {
                return Err(wrong(what, format!("{what}: component {component} is none of 1 to 6")));
            }
            Ok(6 * node + usize::from(component) - 1)
        };
        let motions = |what: &str, list: &[MotionEntry]| -> Result<Vec<(usize, f64)>, InputError> {
            list.iter().map(|at| Ok((motion(what, at.grid, at.component)?, at.value))).collect()
        };
        self.refuse_twins()?;
        let free = system.free_count();
        let mut modes = Vec::new();
        for (at, entry) in self.modes.iter().enumerate() {
            let name = entry.name.clone().unwrap_or_else(|| format!("mode {}", at + 1));
            self.check_mode(&name, entry.mode, free)?;
            modes.push(MeasuredMode {
                frequency_hz: positive(
                    "frequency_hz",
                    &format!("the frequency of {name}"),
                    entry.frequency_hz,
                )?,
                sigma_hz: positive("sigma_hz", &format!("the standard deviation of {name}"), entry.sigma_hz)?,
                shape: motions("shape", &entry.shape)?,
                mode: entry.shape.is_empty().then(|| entry.mode.map_or(at, |mode| mode - 1)),
                name,
            });
        }
        let mut deflections = Vec::new();
        for entry in &self.deflections {
            deflections.push(MeasuredDeflection {
                name: entry.name.clone(),
                loads: motions("loads", &entry.loads)?,
                motion: motion("deflections", entry.grid, entry.component)?,
                value: entry.value,
                sigma: positive("sigma", &format!("the standard deviation of {}", entry.name), entry.sigma)?,
            });
        }
        let mut mass_kg = None;
        if let Some(mass) = self.mass {
            positive("kg", "the mass", mass.kg)?;
            mass_kg =
                Some((mass.kg, positive("sigma_kg", "the standard deviation of the mass", mass.sigma_kg)?));
        }
        Ok(Measurements { modes, deflections, mass_kg })
    }

    /// The unknowns: for each region and what is fitted of it the elements of a model.
    ///
    /// # Errors
    /// If a region has no element, or two regions share one for the same quantity.
    pub fn parameters(&self, bulk: &BulkData, model: &Model) -> Result<Vec<Parameter>, InputError> {
        let mut properties = Properties::default();
        registry::visit(bulk, &mut properties)?;
        let mut parameters = Vec::new();
        let mut taken: BTreeMap<(Quantity, usize), &str> = BTreeMap::new();
        for region in &self.regions {
            let name = format!("\"{}\"", region.name);
            let wrong = |message: String| InputError::in_field(&self.path, &name, message);
            let chosen = |(_, element): &(usize, &dyn crate::Element)| {
                let passes = |set: &Option<BTreeSet<u32>>, id: Option<u32>| {
                    set.as_ref().is_none_or(|set| id.is_some_and(|id| set.contains(&id)))
                };
                let centre = centre(model, element.nodes());
                let inside =
                    |range: Option<(f64, f64)>, at: f64| range.is_none_or(|(a, b)| a <= at && at < b);
                passes(&region.elements, Some(element.id()))
                    && passes(&region.properties, properties.0.get(&element.id()).copied())
                    && [region.x_m, region.y_m, region.z_m]
                        .iter()
                        .zip(centre.iter())
                        .all(|(r, at)| inside(*r, *at))
            };
            let elements: Vec<usize> =
                model.elements().enumerate().filter(chosen).map(|(place, _)| place).collect();
            if elements.is_empty() {
                let error = wrong(format!("no element of the model is in the region {name}"));
                return Err(error.with_help(
                    "a region is what passes all of its conditions: elements, properties, x_m, y_m, z_m",
                ));
            }
            if region.fit.is_empty() {
                return Err(wrong(format!("nothing of the region {name} is fitted"))
                    .with_help("`fit: [Stiffness]`, `[Mass]` or both; or take the region out"));
            }
            for quantity in &region.fit {
                for place in &elements {
                    if let Some(other) = taken.insert((*quantity, *place), &region.name) {
                        let id = model.elements[*place].id();
                        return Err(wrong(format!("element {id} is in the regions \"{other}\" and {name}")));
                    }
                }
                let (region, quantity) = (region.name.clone(), *quantity);
                parameters.push(Parameter { region, quantity, elements: elements.clone() });
            }
        }
        Ok(parameters)
    }
}

fn centre(model: &Model, nodes: &[usize]) -> Point3<f64> {
    let sum = nodes.iter().fold(Point3::origin(), |sum, node| sum + model.nodes[*node].point.coords);
    sum / (nodes.len().max(1) as f64)
}

/// The property of each element that has one.
#[derive(Default)]
struct Properties(BTreeMap<u32, u32>);

impl Visitor for Properties {
    fn elements<C: ElementCard>(&mut self, cards: &BTreeMap<u32, C>) -> Result<(), InputError> {
        self.0.extend(cards.iter().filter_map(|(id, card)| Some((*id, card.property()?))));
        Ok(())
    }
}
