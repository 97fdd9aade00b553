//! Segments: text files to which one process appends finished cases, a line each. `TAB` stands between the parts of a line, and JSON
//! holds neither tabs nor ends of lines, so that a line that was cut or damaged costs no other.
//!
//! ```text
//! wingroot-segment 2 TAB sum TAB inputs                   sum: of the inputs
//! sum TAB hash TAB sum of result TAB bytes TAB told TAB result      sum: of all behind it but the result; bytes: of told TAB result
//! ```
//! Sums are [`Fingerprint`]s by words: every step is a bijection, so no single changed byte keeps one. Which cases are there is read
//! without their results, which may be long: a part reads those of its own share, and not the whole sweep's.

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
const HEAD: &str = "wingroot-segment 2";
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

/// What is read of a record without its result.
pub(super) struct Entry {
    pub(super) hash: Fingerprint,
    pub(super) place: Place,
    pub(super) told: Told,
}

fn sum(bytes: &[u8]) -> String {
    Fingerprint::of_words(bytes).to_string()
}

/// A segment open for reading, after its head.
pub(super) struct Segment {
    lines: BufReader<File>,
    first_byte: u64,
}

/// What stands at a place of a segment.
enum Next {
    Entry(Entry),
    /// No record, or one whose end is not where it says.
    Damaged,
    /// Nothing more, or a last line that is still being written.
    End,
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

    /// Hands over what is told of all records; how many are damaged so far as is seen without their results, but for a last line
    /// that is still being written.
    pub(super) fn entries(mut self, mut each: impl FnMut(Entry)) -> usize {
        let mut damaged = 0;
        loop {
            match self.next() {
                Next::Entry(entry) => {
                    self.first_byte += u64::from(entry.place.bytes);
                    each(entry);
                }
                Next::Damaged => {
                    damaged += 1;
                    let Some(bytes) = self.line_at(self.first_byte) else { return damaged };
                    self.first_byte += bytes;
                }
                Next::End => return damaged,
            }
        }
    }

    /// Bytes of the line from a place on; `None` without an end.
    fn line_at(&mut self, first_byte: u64) -> Option<u64> {
        self.lines.seek(SeekFrom::Start(first_byte)).ok()?;
        let bytes = self.lines.skip_until(b'\n').ok()?;
        self.lines.seek_relative(-1).ok()?;
        (bytes > 0 && self.byte() == Some(b'\n')).then_some(bytes as u64)
    }

    fn byte(&mut self) -> Option<u8> {
        let mut byte = [0];
        self.lines.read_exact(&mut byte).ok()?;
        Some(byte[0])
    }

    fn next(&mut self) -> Next {
        let mut head = Vec::new();
        for _ in 0..HEAD_PARTS {
            match self.lines.by_ref().take(LONGEST_TOLD).read_until(b'\t', &mut head) {
                Ok(0) | Err(_) => return Next::End,
                Ok(_) if head.last() == Some(&b'\t') => {}
                Ok(_) => {
                    return if self.line_at(self.first_byte).is_some() { Next::Damaged } else { Next::End };
                }
            }
        }
        let Some((mut entry, rest)) = entry(&head, self.first_byte) else {
            return if self.line_at(self.first_byte).is_some() { Next::Damaged } else { Next::End };
        };
        let skipped = i64::try_from(rest).ok().and_then(|rest| self.lines.seek_relative(rest).ok());
        match skipped.and_then(|()| self.byte()) {
            Some(b'\n') => {
                entry.place.first_byte = self.first_byte;
                Next::Entry(entry)
            }
            Some(_) => Next::Damaged,
            None => Next::End,
        }
    }
}

/// Parts of a line before its result.
const HEAD_PARTS: usize = 5;
/// No more is told of a case, bytes.
const LONGEST_TOLD: u64 = 1 << 20;

/// What a record tells before its result (with the tab behind it), if that is whole; and bytes of the result.
fn entry(head: &[u8], first_byte: u64) -> Option<(Entry, usize)> {
    let told = std::str::from_utf8(head).ok()?.strip_suffix('\t')?;
    let (told_sum, rest) = told.split_once('\t')?;
    if told_sum != sum(rest.as_bytes()) {
        return None;
    }
    let mut parts = rest.splitn(4, '\t');
    let (hash, result, bytes, told) = (parts.next()?, parts.next()?, parts.next()?, parts.next()?);
    let length = bytes.parse::<usize>().ok()?.checked_sub(told.len() + 1)?;
    let bytes = u32::try_from(head.len() + length + 1).ok()?;
    let place = Place { first_byte, bytes, result: Fingerprint::of_text(result)? };
    let entry = Entry { hash: Fingerprint::of_text(hash)?, place, told: serde_json::from_str(told).ok()? };
    Some((entry, length))
}

/// The record of a line, if it is whole.
fn record(line: &[u8], first_byte: u64) -> Option<Record> {
    let tabs = line.iter().enumerate().filter(|(_, byte)| **byte == b'\t').map(|(at, _)| at);
    let (head, rest) = line.split_at_checked(tabs.take(HEAD_PARTS).last()? + 1)?;
    let (Entry { hash, place, told }, bytes) = entry(head, first_byte)?;
    let text = rest.strip_suffix(b"\n").filter(|text| text.len() == bytes)?;
    if place.result != Fingerprint::of_words(text) {
        return None;
    }
    Some(Record { hash, told, text: std::str::from_utf8(text).ok()?.to_owned() })
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
        let result = Fingerprint::of_words(text.as_bytes());
        let rest = format!("{hash}\t{result}\t{}\t{told}", told.len() + 1 + text.len());
        let line = format!("{}\t{rest}\t{text}\n", sum(rest.as_bytes()));
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
