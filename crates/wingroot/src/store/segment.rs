//! Segments: text files to which one process appends finished cases, a line each. `TAB` stands between the parts of a line, and JSON
//! holds neither tabs nor ends of lines, so that a line that was cut or damaged costs no other.
//!
//! ```text
//! wingroot-segment 1 TAB sum TAB inputs                   sum: of the inputs
//! sum TAB hash TAB sum of result TAB bytes TAB told TAB result      sum: of all that follows; bytes: of told TAB result
//! ```
//! Sums are [`Fingerprint`]s: multiplication by an odd number is a bijection, so no single changed byte keeps one.

use std::fs::{File, OpenOptions};
use std::hash::{BuildHasher, Hasher};
use std::io::{BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};

use super::inputs::Inputs;
use crate::fingerprint::Fingerprint;

/// Ending of segments.
const ENDING: &str = "segment";
/// What a segment begins with.
const HEAD: &str = "wingroot-segment 1";
/// How often what was written is sent to the disk: what a machine that fails may cost.
const SYNC_EVERY: Duration = Duration::from_secs(1);

/// What is told of a finished case beside its result.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Told {
    /// The case.
    pub part: String,
    /// What it took, s.
    pub seconds: Option<f64>,
    /// Why it could not be computed.
    pub failed: Option<String>,
}

/// Where a record stands.
#[derive(Debug, Clone, Copy)]
pub(super) struct Place {
    /// First byte in its segment.
    pub(super) first_byte: u64,
    /// Bytes with the end of the line.
    pub(super) bytes: u32,
    /// Fingerprint of the result.
    pub(super) result: Fingerprint,
}

/// A record that was read whole.
pub(super) struct Record {
    pub(super) hash: Fingerprint,
    pub(super) place: Place,
    pub(super) told: Told,
    pub(super) text: String,
}

/// All segments of a folder, sorted by name.
pub(super) fn paths(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path());
    let mut all: Vec<PathBuf> =
        entries.filter(|path| path.extension().is_some_and(|e| e == ENDING)).collect();
    all.sort();
    all
}

fn sum(bytes: &[u8]) -> String {
    Fingerprint::default().with(bytes).to_string()
}

/// A segment open for reading, after its head.
pub(super) struct Segment {
    lines: BufReader<File>,
    first_byte: u64,
}

impl Segment {
    /// Opens a segment; `None` if its head is not whole, after which nothing is believed.
    pub(super) fn open(path: &Path) -> Option<(Inputs, Self)> {
        let mut lines = BufReader::new(File::open(path).ok()?);
        let mut head = String::new();
        let bytes = lines.read_line(&mut head).ok()?;
        let mut parts = head.strip_suffix('\n')?.splitn(3, '\t');
        let (kind, told, inputs) = (parts.next()?, parts.next()?, parts.next()?);
        if kind != HEAD || told != sum(inputs.as_bytes()) {
            return None;
        }
        Some((serde_json::from_str(inputs).ok()?, Self { lines, first_byte: bytes as u64 }))
    }

    /// Hands over all records that are whole; how many are not, but for a last line that is still being written.
    pub(super) fn records(mut self, mut each: impl FnMut(Record)) -> usize {
        let (mut damaged, mut line) = (0, Vec::new());
        loop {
            line.clear();
            let Ok(bytes @ 1..) = self.lines.read_until(b'\n', &mut line) else { return damaged };
            if line.last() != Some(&b'\n') {
                return damaged;
            }
            match record(&line, self.first_byte) {
                Some(record) => each(record),
                None => damaged += 1,
            }
            self.first_byte += bytes as u64;
        }
    }
}

/// The record of a line, if it is whole.
fn record(line: &[u8], first_byte: u64) -> Option<Record> {
    let line = std::str::from_utf8(line).ok()?;
    let (told_sum, rest) = line.strip_suffix('\n')?.split_once('\t')?;
    if told_sum != sum(rest.as_bytes()) {
        return None;
    }
    let mut parts = rest.splitn(4, '\t');
    let (hash, result, bytes, rest) = (parts.next()?, parts.next()?, parts.next()?, parts.next()?);
    if bytes.parse() != Ok(rest.len()) {
        return None;
    }
    let (told, text) = rest.split_once('\t')?;
    let place =
        Place { first_byte, bytes: u32::try_from(line.len()).ok()?, result: Fingerprint::of_text(result)? };
    let hash = Fingerprint::of_text(hash)?;
    Some(Record { hash, place, told: serde_json::from_str(told).ok()?, text: text.to_owned() })
}

/// The record at a place of a file, if it is still whole.
pub(super) fn record_at(mut file: &File, place: Place) -> Option<Record> {
    let mut line = vec![0; place.bytes as usize];
    file.seek(SeekFrom::Start(place.first_byte)).ok()?;
    file.read_exact(&mut line).ok()?;
    record(&line, place.first_byte)
}

/// A segment that this process writes.
#[derive(Debug)]
pub(super) struct Writer {
    path: PathBuf,
    file: File,
    bytes: u64,
    synced: Instant,
}

impl Writer {
    /// Begins a segment under a name that no other process has.
    pub(super) fn begin(folder: &Path, label: &str, inputs: &Inputs) -> std::io::Result<Self> {
        std::fs::create_dir_all(folder)?;
        let path = folder.join(format!("{label}-{}.{ENDING}", unique()));
        let file = OpenOptions::new().append(true).create_new(true).open(&path)?;
        let inputs = serde_json::to_string(inputs)?;
        let head = format!("{HEAD}\t{}\t{inputs}\n", sum(inputs.as_bytes()));
        (&file).write_all(head.as_bytes())?;
        Ok(Self { path, file, bytes: head.len() as u64, synced: Instant::now() })
    }

    /// The file.
    pub(super) fn path(&self) -> &Path {
        &self.path
    }

    /// Whether somebody removed the file; looked at once a second.
    pub(super) fn is_gone(&mut self) -> bool {
        self.synced.elapsed() > SYNC_EVERY && !self.path.exists()
    }

    /// Appends a case with one write.
    pub(super) fn append(&mut self, hash: Fingerprint, told: &Told, text: &str) -> std::io::Result<Place> {
        let told = serde_json::to_string(told)?;
        let result = Fingerprint::default().with(text.as_bytes());
        let rest = format!("{hash}\t{result}\t{}\t{told}\t{text}", told.len() + 1 + text.len());
        let line = format!("{}\t{rest}\n", sum(rest.as_bytes()));
        let bytes = u32::try_from(line.len()).map_err(std::io::Error::other)?;
        self.file.write_all(line.as_bytes())?;
        if self.synced.elapsed() > SYNC_EVERY {
            self.file.sync_data()?;
            self.synced = Instant::now();
        }
        let place = Place { first_byte: self.bytes, bytes, result };
        self.bytes += u64::from(bytes);
        Ok(place)
    }
}

/// A name that no other process has, on this machine or another.
pub fn unique() -> String {
    let random = std::hash::RandomState::new().build_hasher().finish();
    format!("{}-{}-{random:016x}", host(), std::process::id())
}

/// The machine's name as far as it may stand in a file's.
fn host() -> String {
    let name = std::fs::read_to_string("/proc/sys/kernel/hostname").unwrap_or_default();
    let name = name.chars().filter(char::is_ascii_alphanumeric).take(32).collect::<String>();
    if name.is_empty() { "host".to_owned() } else { name }
}
