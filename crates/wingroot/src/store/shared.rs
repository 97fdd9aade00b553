//! What all cases of a sweep share, computed once and kept beside the finished cases: one file for each thing and each state of
//! what it depends on, so that a file is never of other inputs or of another program than whoever reads it.
//!
//! ```text
//! wingroot-shared 1 TAB inputs LF    bytes    sum of all before (16 hexadecimal digits)
//! ```
//! Matrices are numbers of rows and columns, then entries column by column, 64 bits each, little end first.

use std::path::{Path, PathBuf};

use coupling::Keep;
use faer::Mat;

use super::inputs::Inputs;
use super::segment::unique;
use crate::fingerprint::Fingerprint;
use crate::show;

/// Ending of the files.
const ENDING: &str = "shared";
/// What they begin with.
const HEAD: &str = "wingroot-shared 1";
/// Bytes of the sum at their end.
const SUM: usize = 16;
/// Bytes of a number.
const NUMBER: usize = 8;

/// Where a sweep keeps what its cases share.
#[derive(Debug, Clone, Default)]
pub struct Shared {
    folder: Option<PathBuf>,
    keeps: bool,
}

impl Shared {
    /// In the folder of a store; `keeps` if what is not there is put there.
    pub fn new(folder: &Path, keeps: bool) -> Self {
        Self { folder: Some(folder.to_path_buf()), keeps }
    }

    /// What is kept under a name of the same inputs, by the same program. A file that is damaged is said and removed.
    pub fn bytes(&self, name: &str, inputs: &str) -> Option<Vec<u8>> {
        let (path, head) = self.place(name, inputs)?;
        let mut bytes = std::fs::read(&path).ok()?;
        let body = bytes.len().saturating_sub(SUM);
        let sum = Fingerprint::default().with(&bytes[..body]).to_string();
        if bytes[body..] != *sum.as_bytes() || !bytes.starts_with(head.as_bytes()) {
            show::note(&format!("{} is damaged: what it holds is computed again", path.display()));
            // said once; who cannot remove it says it again
            let _ = std::fs::remove_file(&path);
            return None;
        }
        bytes.truncate(body);
        bytes.drain(..head.len());
        Some(bytes)
    }

    /// Keeps bytes, if this process is one that does. Readers see the whole file or none.
    pub fn put_bytes(&self, name: &str, inputs: &str, bytes: &[u8]) {
        let Some((path, head)) = self.place(name, inputs).filter(|_| self.keeps) else { return };
        let mut all = [head.as_bytes(), bytes].concat();
        let sum = Fingerprint::default().with(&all).to_string();
        all.extend(sum.as_bytes());
        let begun = path.with_file_name(format!("{name}-{}.begun", unique()));
        let folder = path.parent().unwrap_or(Path::new(""));
        let kept = std::fs::create_dir_all(folder)
            .and_then(|()| std::fs::write(&begun, &all))
            .and_then(|()| std::fs::rename(&begun, &path));
        if let Err(error) = kept {
            // Who cannot keep it has it all the same; others compute it again.
            tracing::warn!("{}: what the cases share is not kept: {error}", path.display());
        }
    }

    /// Files and bytes that are kept here.
    pub fn size(&self) -> (usize, u64) {
        let entries = self.folder.iter().flat_map(std::fs::read_dir).flatten().flatten();
        let own = entries.filter(|entry| entry.path().extension().is_some_and(|e| e == ENDING));
        own.fold((0, 0), |(files, bytes), entry| {
            (files + 1, bytes + entry.metadata().map_or(0, |data| data.len()))
        })
    }

    /// The file of a name and its inputs, and its head.
    fn place(&self, name: &str, inputs: &str) -> Option<(PathBuf, String)> {
        let inputs = serde_json::to_string(&Inputs::default().with(name, inputs)).ok()?;
        let print = Fingerprint::default().with(inputs.as_bytes());
        Some((self.folder.as_ref()?.join(format!("{name}-{print}.{ENDING}")), format!("{HEAD}\t{inputs}\n")))
    }
}

impl Keep for Shared {
    fn get(&self, name: &str, inputs: &str) -> Option<Vec<Mat<f64>>> {
        matrices(&self.bytes(name, inputs)?)
    }

    fn put(&self, name: &str, inputs: &str, matrices: &[Mat<f64>]) {
        if !self.keeps {
            return;
        }
        let mut bytes = Vec::new();
        for matrix in matrices {
            bytes.extend(
                [matrix.nrows(), matrix.ncols()].map(|size| (size as u64).to_le_bytes()).as_flattened(),
            );
            for column in 0..matrix.ncols() {
                matrix.col(column).iter().for_each(|value| bytes.extend(value.to_le_bytes()));
            }
        }
        self.put_bytes(name, inputs, &bytes);
    }
}

/// Matrices of bytes; `None` if sizes and bytes contradict each other.
fn matrices(mut bytes: &[u8]) -> Option<Vec<Mat<f64>>> {
    let mut all = Vec::new();
    while !bytes.is_empty() {
        let sizes;
        (sizes, bytes) = bytes.split_at_checked(2 * NUMBER)?;
        let [rows, columns] =
            [0, NUMBER].map(|at| sizes[at..].first_chunk().map(|size| u64::from_le_bytes(*size)));
        let [rows, columns] = [usize::try_from(rows?).ok()?, usize::try_from(columns?).ok()?];
        let entries;
        (entries, bytes) = bytes.split_at_checked(rows.checked_mul(columns)?.checked_mul(NUMBER)?)?;
        let entry =
            |at: usize| entries[at..].first_chunk().map_or(f64::NAN, |value| f64::from_le_bytes(*value));
        all.push(Mat::from_fn(rows, columns, |row, column| entry(NUMBER * (column * rows + row))));
    }
    Some(all)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("wingroot-shared-{name}-{}", std::process::id()));
        let _ = std::fs::remove_dir_all(&folder);
        folder
    }

    fn some() -> Vec<Mat<f64>> {
        let of = |rows, columns| Mat::from_fn(rows, columns, |i, j| 1.0 / (1.0 + i as f64 + 7.0 * j as f64));
        vec![of(3, 2), of(0, 4), of(1, 1), Mat::from_fn(1, 3, |_, j| [-0.0, f64::NAN, f64::MIN_POSITIVE][j])]
    }

    fn bits(all: &[Mat<f64>]) -> Vec<(usize, Vec<u64>)> {
        let of = |matrix: &Mat<f64>| {
            let entries = (0..matrix.ncols()).flat_map(|j| matrix.col(j).iter().map(|v| v.to_bits()));
            (matrix.nrows(), entries.collect())
        };
        all.iter().map(of).collect()
    }

    #[test]
    fn matrices_come_back_to_the_last_bit_and_of_the_same_name_and_inputs_only() {
        let folder = folder("bits");
        Shared::new(&folder, false).put("air", "a", &some());
        assert!(!folder.exists(), "who only reads leaves nothing behind");
        let shared = Shared::new(&folder, true);
        shared.put("air", "a", &some());
        assert_eq!(shared.get("air", "a").map(|found| bits(&found)), Some(bits(&some())));
        assert!(shared.get("air", "b").is_none() && shared.get("flexibility", "a").is_none());
        assert_eq!(shared.size().0, 1, "no half-written file is left");
        // a file under the name of another's inputs is not believed
        let [own, other] = ["a", "b"].map(|inputs| shared.place("air", inputs).expect("a place").0);
        std::fs::rename(own, other).expect("our own files");
        assert!(shared.get("air", "b").is_none() && Shared::default().get("air", "a").is_none());
        std::fs::remove_dir_all(folder).expect("our own folder");
    }

    #[test]
    fn a_file_that_is_cut_or_has_one_other_byte_is_not_believed_and_is_replaced() {
        let folder = folder("damaged");
        let shared = Shared::new(&folder, true);
        shared.put("air", "a", &some());
        let path = shared.place("air", "a").expect("a place").0;
        let whole = std::fs::read(&path).expect("our own file");
        for at in 0..whole.len() {
            std::fs::write(&path, &whole[..at]).expect("our own file");
            assert!(shared.get("air", "a").is_none(), "cut after {at} bytes");
            let mut other = whole.clone();
            other[at] ^= 1;
            std::fs::write(&path, other).expect("our own file");
            assert!(shared.get("air", "a").is_none(), "byte {at} is another");
        }
        shared.put("air", "a", &some());
        assert_eq!(std::fs::read(&path).expect("our own file"), whole);
        std::fs::remove_dir_all(folder).expect("our own folder");
    }
}
