//! Where the finished cases of a store stand: 48 bytes a case in memory, whatever its result takes.

use std::collections::{BTreeSet, HashMap, HashSet};
use std::fs::File;
use std::path::{Path, PathBuf};

use super::inputs::Inputs;
use super::segment::{Place, Record, Segment, Told, paths, record_at};
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
    /// Cases whose results were read and are whole.
    whole: HashSet<Fingerprint>,
    foreign: Vec<Foreign>,
    damaged: usize,
    contradicted: BTreeSet<String>,
}

impl Index {
    /// Reads what all segments of a folder tell, once, without results; of a case that is there twice the first counts, in the order of the
    /// segments' names.
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
            index.damaged += segment.entries(|entry| {
                let known = index.places.get(&entry.hash);
                if known.is_some_and(|(_, known)| known.result != entry.place.result) {
                    index.contradicted.insert(entry.told.part);
                }
                index.add(entry.hash, entry.place);
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

    /// Whether a case is there and whole.
    pub(super) fn has(&mut self, hash: Fingerprint) -> bool {
        self.whole.contains(&hash) || self.read(hash).is_some()
    }

    /// All hashes, sorted.
    pub(super) fn hashes(&self) -> Vec<Fingerprint> {
        let mut all: Vec<Fingerprint> = self.places.keys().copied().collect();
        all.sort_unstable();
        all
    }

    /// What was told of a case, and its result. One that is damaged is not there, unless another process finished it, too.
    pub(super) fn read(&mut self, hash: Fingerprint) -> Option<(Told, String)> {
        while let Some(&(segment, place)) = self.places.get(&hash) {
            if let Some(record) = self.record(segment, place).filter(|record| record.hash == hash) {
                self.whole.insert(hash);
                return Some((record.told, record.text));
            }
            self.damaged += 1;
            self.places.remove(&hash);
            self.add_next(hash, (segment, place.first_byte));
        }
        None
    }

    fn record(&mut self, segment: u32, place: Place) -> Option<Record> {
        if !self.open.contains_key(&segment) {
            if self.open.len() >= MOST_OPEN {
                self.open.clear();
            }
            self.open.insert(segment, File::open(self.segments.get(segment as usize)?).ok()?);
        }
        record_at(self.open.get(&segment)?, place)
    }

    /// Adds the next record of a case behind one that is damaged.
    fn add_next(&mut self, hash: Fingerprint, damaged: (u32, u64)) {
        for (number, path) in (0..).zip(&self.segments).skip(damaged.0 as usize) {
            let Some((_, segment)) = Segment::open(path) else { continue };
            let mut found = None;
            segment.entries(|entry| {
                if entry.hash == hash && (number, entry.place.first_byte) > damaged {
                    found.get_or_insert(entry.place);
                }
            });
            if let Some(place) = found {
                self.places.insert(hash, (number, place));
                return;
            }
        }
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
