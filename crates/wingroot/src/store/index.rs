//! Where the finished cases of a store stand: 48 bytes a case in memory, whatever its result takes.

use std::collections::{BTreeSet, HashMap};
use std::fs::File;
use std::path::{Path, PathBuf};

use super::inputs::Inputs;
use super::segment::{Place, Segment, Told, paths, record_at};
use crate::fingerprint::Fingerprint;

/// Segments that are kept open for reading.
const MOST_OPEN: usize = 64;

/// A segment of other inputs than those of the store.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Foreign {
    /// The file.
    pub path: PathBuf,
    /// Names of the inputs that differ.
    pub differs: Vec<String>,
}

/// How a store stands: what it holds beside the results themselves.
#[derive(Debug, Default)]
pub struct Standing {
    /// Segments of other inputs.
    pub foreign: Vec<Foreign>,
    /// Records that were not whole, and are not believed.
    pub damaged: usize,
    /// Cases that were finished twice, with results that are not the same to the last digit.
    pub contradicted: Vec<String>,
}

/// Places of all finished cases by hash.
#[derive(Debug, Default)]
pub(super) struct Index {
    places: HashMap<Fingerprint, (u32, Place)>,
    segments: Vec<PathBuf>,
    open: HashMap<u32, File>,
    foreign: Vec<Foreign>,
    damaged: usize,
    contradicted: BTreeSet<String>,
}

impl Index {
    /// Reads all segments of a folder once; of a case that is there twice the first counts, in the order of the segments' names.
    pub(super) fn read_all(folder: &Path, inputs: &Inputs) -> Self {
        let mut index = Self::default();
        for path in paths(folder) {
            let Some((own, segment)) = Segment::open(&path) else {
                // a process that was killed before its first case leaves a head that is cut
                continue;
            };
            let differs = inputs.differs(&own);
            if !differs.is_empty() {
                index.foreign.push(Foreign { path, differs });
                continue;
            }
            index.add_segment(&path);
            index.damaged += segment.records(|record| {
                if index
                    .places
                    .get(&record.hash)
                    .is_some_and(|(_, known)| known.result != record.place.result)
                {
                    index.contradicted.insert(record.told.part);
                }
                index.add(record.hash, record.place);
            });
        }
        index
    }

    /// Adds a segment; records that follow are in it.
    pub(super) fn add_segment(&mut self, path: &Path) {
        self.segments.push(path.to_path_buf());
    }

    /// Adds a record of the last segment.
    pub(super) fn add(&mut self, hash: Fingerprint, place: Place) {
        let Ok(segment) = u32::try_from(self.segments.len().saturating_sub(1)) else { return };
        self.places.entry(hash).or_insert((segment, place));
    }

    /// Whether a case is there.
    pub(super) fn has(&self, hash: Fingerprint) -> bool {
        self.places.contains_key(&hash)
    }

    /// All hashes, sorted.
    pub(super) fn hashes(&self) -> Vec<Fingerprint> {
        let mut all: Vec<Fingerprint> = self.places.keys().copied().collect();
        all.sort_unstable();
        all
    }

    /// What was told of a case, and its result.
    pub(super) fn read(&mut self, hash: Fingerprint) -> Option<(Told, String)> {
        let &(segment, place) = self.places.get(&hash)?;
        if !self.open.contains_key(&segment) {
            if self.open.len() >= MOST_OPEN {
                self.open.clear();
            }
            self.open.insert(segment, File::open(self.segments.get(segment as usize)?).ok()?);
        }
        let record = record_at(self.open.get(&segment)?, place)?;
        (record.hash == hash).then_some((record.told, record.text))
    }

    /// What was found beside results.
    pub(super) fn standing(&self) -> Standing {
        Standing {
            foreign: self.foreign.clone(),
            damaged: self.damaged,
            contradicted: self.contradicted.iter().cloned().collect(),
        }
    }
}
