//! Stations of a selection: by their names, and left and right as one where the file says so.

use super::file::SelectFile;
use nastran::{InputError, place_of, read_text};

/// The sides in names of stations, and how the image of a load in the plane of symmetry goes.
const SIDES: [&str; 2] = ["right ", "left "];
/// Signs of the image: Fy, Mx and Mz turn round.
const IMAGE: [f64; 6] = [1.0, -1.0, 1.0, -1.0, 1.0, -1.0];

/// A station or a family of two.
pub(super) struct Place {
    /// What it is called.
    pub(super) name: String,
    /// Columns of loads, each with whether its image counts.
    columns: Vec<(usize, bool)>,
}

impl Place {
    /// The loads that count at an instant, with a remark on which they are.
    pub(super) fn loads<'a>(&'a self, loads: &'a [[f64; 6]]) -> impl Iterator<Item = ([f64; 6], bool)> + 'a {
        self.columns.iter().map(|&(column, image)| {
            let own = loads[column];
            (if image { std::array::from_fn(|at| own[at] * IMAGE[at]) } else { own }, image)
        })
    }
}

/// All stations of a selection.
pub(super) struct Places<'a> {
    file: &'a SelectFile,
    all: Vec<Place>,
}

impl<'a> Places<'a> {
    /// Stations, or families of them.
    pub(super) fn new(file: &'a SelectFile, stations: &[String]) -> Self {
        let mut all: Vec<Place> = Vec::new();
        for (column, name) in stations.iter().enumerate() {
            let family = plain(name);
            let known = all.iter_mut().find(|place| file.mirror && place.name == family);
            let image = file.mirror && name.starts_with(SIDES[1]);
            match known {
                Some(place) => place.columns.push((column, image)),
                None => all.push(Place {
                    name: if file.mirror { family.to_owned() } else { name.clone() },
                    columns: vec![(column, image)],
                }),
            }
        }
        Self { file, all }
    }

    /// The stations that a policy names, or all if it names none; `root` is both `right root` and `left root`.
    ///
    /// # Errors
    /// If one is not there.
    pub(super) fn named(&self, names: &[String]) -> Result<Vec<&Place>, InputError> {
        for name in names {
            if !self.all.iter().any(|place| is_meant(place, name)) {
                let text = read_text(&self.file.path).unwrap_or_default();
                let place = place_of(&[&format!("\"{name}\"")], &text, &self.file.path);
                let known: Vec<&str> = self.all.iter().map(|place| place.name.as_str()).collect();
                let error = InputError::at(&place, format!("there is no station `{name}`"));
                return Err(error.with_help(format!("the stations are {}", known.join(", "))));
            }
        }
        let is_wanted = |place: &&Place| names.is_empty() || names.iter().any(|name| is_meant(place, name));
        Ok(self.all.iter().filter(is_wanted).collect())
    }
}

/// A station's name without its side.
fn plain(name: &str) -> &str {
    SIDES.iter().find_map(|side| name.strip_prefix(side)).unwrap_or(name)
}

fn is_meant(place: &Place, name: &str) -> bool {
    place.name == name || plain(&place.name) == name || plain(name) == place.name
}
