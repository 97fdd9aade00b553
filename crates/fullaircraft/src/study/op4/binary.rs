//! OP4 files in binary: Fortran's records, each between two copies of its length in bytes; words of four bytes, or of eight where a
//! head has 48 bytes. Both orders of bytes are read: the length of the head tells them apart.

use super::records::{Head, Records};
use nastran::text_file::LARGEST_FILE;
use nastran::{InputError, memory};
use std::fs::File;
use std::io::Read as _;
use std::path::{Path, PathBuf};

/// Bytes of a head of four numbers and a name of two words.
const SHORT: u32 = 24;
const LONG: u32 = 48;
/// What a file takes in memory for each byte of it: its bytes, and terms of three words, in a list that grows to twice its length.
const MEMORY_A_BYTE: f64 = 13.0;

/// How numbers are stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Layout {
    /// Most significant byte first.
    is_big_endian: bool,
    /// Bytes of a word.
    word: usize,
}

/// The layout that the first four bytes of a file tell; nothing of a file that is none.
pub(super) fn layout(start: [u8; 4]) -> Option<Layout> {
    let of = |length: u32, is_big_endian: bool| match length {
        SHORT => Some(Layout { is_big_endian, word: 4 }),
        LONG => Some(Layout { is_big_endian, word: 8 }),
        _ => None,
    };
    of(u32::from_le_bytes(start), false).or_else(|| of(u32::from_be_bytes(start), true))
}

/// A file being read.
pub(super) struct Binary {
    path: PathBuf,
    bytes: Vec<u8>,
    /// The byte that is read next.
    at: usize,
    /// Where the record that is open ends.
    record_end: usize,
    layout: Layout,
    /// Bytes of a number of the matrix that is being read.
    real: usize,
}

impl Binary {
    /// A file from its beginning.
    ///
    /// # Errors
    /// If it cannot be read, or is larger than what is read or than the memory.
    pub(super) fn open(path: &Path) -> Result<Self, InputError> {
        let wrong = |message: String| InputError::in_file(path, message);
        let unreadable = |error: std::io::Error| wrong(format!("the file cannot be read: {error}"));
        let file = File::open(path).map_err(unreadable)?;
        let size = file.metadata().map_err(unreadable)?.len();
        if size > LARGEST_FILE {
            return Err(wrong(format!("the file has more than {LARGEST_FILE} bytes, the most that is read")));
        }
        memory::demand("this matrix and what is made of it", MEMORY_A_BYTE * size as f64)
            .map_err(|error| error.or_in(path))?;
        let mut bytes = Vec::new();
        file.take(LARGEST_FILE).read_to_end(&mut bytes).map_err(unreadable)?;
        let start = bytes.first_chunk::<4>().copied().and_then(layout);
        let layout =
            start.ok_or_else(|| wrong("this is no OP4 file: it does not begin with a head".to_owned()))?;
        Ok(Self { path: path.to_path_buf(), bytes, at: 0, record_end: 0, layout, real: layout.word })
    }

    fn take<const N: usize>(&mut self) -> Result<[u8; N], InputError> {
        let taken: Option<[u8; N]> =
            self.bytes.get(self.at..).and_then(|rest| rest.first_chunk::<N>()).copied();
        let taken = taken.ok_or_else(|| self.wrong("the file ends early".to_owned()))?;
        self.at += N;
        Ok(taken)
    }

    /// The length of a record, which stands before and behind it.
    fn length(&mut self) -> Result<usize, InputError> {
        let bytes = self.take()?;
        let length =
            if self.layout.is_big_endian { u32::from_be_bytes(bytes) } else { u32::from_le_bytes(bytes) };
        Ok(length as usize)
    }

    fn begin(&mut self) -> Result<(), InputError> {
        let length = self.length()?;
        self.record_end = self.at.saturating_add(length);
        if self.record_end > self.bytes.len() {
            return Err(self.wrong(format!("a record of {length} bytes goes beyond the end of the file")));
        }
        Ok(())
    }

    fn integer(&mut self) -> Result<i64, InputError> {
        let is_big_endian = self.layout.is_big_endian;
        if self.layout.word == 4 {
            let bytes = self.take()?;
            return Ok(i64::from(if is_big_endian {
                i32::from_be_bytes(bytes)
            } else {
                i32::from_le_bytes(bytes)
            }));
        }
        let bytes = self.take()?;
        Ok(if is_big_endian { i64::from_be_bytes(bytes) } else { i64::from_le_bytes(bytes) })
    }

    fn float(&mut self) -> Result<f64, InputError> {
        let is_big_endian = self.layout.is_big_endian;
        if self.real == 4 {
            let bytes = self.take()?;
            return Ok(f64::from(if is_big_endian {
                f32::from_be_bytes(bytes)
            } else {
                f32::from_le_bytes(bytes)
            }));
        }
        let bytes = self.take()?;
        Ok(if is_big_endian { f64::from_be_bytes(bytes) } else { f64::from_le_bytes(bytes) })
    }
}

impl Records for Binary {
    fn head(&mut self) -> Result<Option<Head>, InputError> {
        if self.at >= self.bytes.len() {
            return Ok(None);
        }
        self.begin()?;
        let numbers = [self.integer()?, self.integer()?, self.integer()?, self.integer()?];
        let name = self.bytes.get(self.at..self.record_end).unwrap_or_default();
        let name = String::from_utf8_lossy(name).into_owned();
        let head = Head::new(numbers, &name)
            .filter(|_| self.record_end.checked_sub(self.at) == Some(2 * self.layout.word));
        let head = head.ok_or_else(|| self.wrong(format!("{numbers:?} is no head of a matrix")))?;
        self.real = if head.kind % 2 == 1 { self.layout.word } else { 8 };
        self.skip()?;
        Ok(Some(head))
    }

    fn column(&mut self) -> Result<[i64; 3], InputError> {
        self.begin()?;
        Ok([self.integer()?, self.integer()?, self.integer()?])
    }

    fn whole(&mut self, count: usize) -> Result<[i64; 2], InputError> {
        let first = self.integer()?;
        Ok([first, if count == 2 { self.integer()? } else { 0 }])
    }

    fn reals(&mut self, count: u64) -> Result<Vec<f64>, InputError> {
        let left = (self.record_end.saturating_sub(self.at) / self.real) as u64;
        if count > left {
            return Err(self.wrong(format!("{count} numbers in a record that has {left} left")));
        }
        let mut all = Vec::new();
        for _ in 0..count {
            let value = self.float()?;
            if !value.is_finite() {
                return Err(self.wrong(format!("{value} is not a finite number")));
            }
            all.push(value);
        }
        Ok(all)
    }

    fn end(&mut self) -> Result<(), InputError> {
        if self.at == self.record_end {
            return self.skip();
        }
        let left = self.record_end as i128 - self.at as i128;
        Err(self.wrong(format!("a record ends {left} bytes from where its length says")))
    }

    fn skip(&mut self) -> Result<(), InputError> {
        self.at = self.record_end;
        self.length().map(|_| ())
    }

    fn words_of_double(&self) -> [u64; 2] {
        if self.layout.word == 4 { [2, 2] } else { [1, 1] }
    }

    fn wrong(&self, message: String) -> InputError {
        InputError::in_file(&self.path, format!("{message} (byte {})", self.at))
            .with_help("expected the binary format of Nastran's OUTPUT4")
    }
}
