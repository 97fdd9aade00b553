//! Stores that were cut, damaged, written twice and at once.

use std::path::{Path, PathBuf};

use super::*;

/// A folder of a test's own, removed at its end.
struct Folder(PathBuf);

impl Folder {
    fn new(name: &str) -> Self {
        let folder = std::env::temp_dir().join(format!("wingroot-store-{name}-{}", std::process::id()));
        let _ = std::fs::remove_dir_all(&folder);
        Self(folder)
    }

    fn store(&self, inputs: &str) -> Store {
        Store::new(self.0.clone(), inputs)
    }

    fn segments(&self) -> Vec<PathBuf> {
        segment::paths(&self.0)
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

/// A result with everything that could disturb a line of text.
fn result(k: usize) -> (f64, String) {
    (1.0 / (1 + k) as f64, format!("tab\t and end\n of {k}"))
}

fn filled(folder: &Folder, cases: usize) -> Vec<u8> {
    let store = folder.store("a");
    (0..cases)
        .for_each(|k| assert_eq!(store.put(&format!("case {k}"), &result(k)).expect("kept"), result(k)));
    std::fs::read(&folder.segments()[0]).expect("a segment")
}

/// How many of the cases a new process finds; each must be as it was put.
fn found(folder: &Folder, cases: usize) -> usize {
    let store = folder.store("a");
    let all = (0..cases).filter_map(|k| Some((k, store.get::<(f64, String)>(&format!("case {k}"))?)));
    all.map(|(k, found)| assert_eq!(found, result(k), "a damaged result was believed")).count()
}

fn rewrite(path: &Path, bytes: &[u8]) {
    std::fs::write(path, bytes).expect("our own file");
}

#[test]
fn a_case_is_found_again_with_the_same_inputs_only() {
    let folder = Folder::new("found");
    assert_eq!(folder.store("a").put("one", &1.5).unwrap(), 1.5);
    assert_eq!(folder.store("a").get::<f64>("one"), Some(1.5));
    assert_eq!(folder.store("a").get::<f64>("two"), None);
    assert_eq!(folder.store("b").get::<f64>("one"), None);
    let named = |wing: &str| Inputs::default().with("wing", wing).with("aircraft", "x");
    Store::new(folder.0.clone(), named("old")).put("one", &1.0).unwrap();
    let standing = Store::new(folder.0.clone(), named("new")).standing();
    assert!(standing.foreign.iter().any(|foreign| foreign.differs == ["wing"]), "{standing:?}");
    folder.store("a").close().unwrap();
    assert!(!folder.0.exists());
}

#[test]
fn a_segment_cut_anywhere_gives_whole_cases_and_never_a_part_of_one() {
    let folder = Folder::new("torn");
    let whole = filled(&folder, 4);
    let path = folder.segments().remove(0);
    let mut seen = [0; 5];
    for length in 0..=whole.len() {
        rewrite(&path, &whole[..length]);
        let found = found(&folder, 4);
        let ends = whole[..length].split(|byte| *byte == b'\n').count() - 1;
        assert_eq!(found, ends.saturating_sub(1), "cut at byte {length}");
        seen[found] += 1;
    }
    assert!(seen.iter().all(|times| *times > 0), "{seen:?}");
}

#[test]
fn a_flipped_byte_costs_its_own_case_only() {
    let folder = Folder::new("flipped");
    let whole = filled(&folder, 4);
    let path = folder.segments().remove(0);
    let head = whole.iter().position(|byte| *byte == b'\n').expect("a head") + 1;
    for at in 0..whole.len() {
        for mask in [0x01, 0x80] {
            let mut damaged = whole.clone();
            damaged[at] ^= mask;
            rewrite(&path, &damaged);
            let found = found(&folder, 4);
            // an end of line that is gone costs the line behind it, too
            let least = if at < head { 0 } else { 2 };
            assert!((least..4).contains(&found), "byte {at} flipped: {found} of 4 cases found");
        }
    }
}

#[test]
fn two_processes_that_do_the_same_at_once_are_harmless() {
    let folder = Folder::new("twice");
    std::thread::scope(|scope| {
        for _ in 0..2 {
            // each has its own segment, as a process has
            scope.spawn(|| {
                let store = folder.store("a");
                (0..200).for_each(|k| drop(store.put(&format!("case {k}"), &result(k)).expect("kept")));
            });
        }
    });
    assert_eq!(folder.segments().len(), 2);
    assert_eq!(found(&folder, 200), 200);
    let store = folder.store("a");
    let mut told = 0;
    store.told(|_| told += 1);
    assert_eq!(told, 200, "a case that is there twice counts once");
    assert!(store.standing().contradicted.is_empty());
}

#[test]
fn a_case_finished_twice_with_other_digits_is_said() {
    let folder = Folder::new("contradicted");
    folder.store("a").put("one", &1.0).unwrap();
    folder.store("a").put("one", &1.0).unwrap();
    assert!(folder.store("a").standing().contradicted.is_empty());
    folder.store("a").put("one", &(1.0 + f64::EPSILON)).unwrap();
    assert_eq!(folder.store("a").standing().contradicted, ["one"]);
}

#[test]
fn a_store_removed_under_a_running_process_is_begun_anew() {
    let folder = Folder::new("removed");
    let store = folder.store("a");
    store.put("one", &1.0).unwrap();
    folder.store("a").close().unwrap();
    std::thread::sleep(std::time::Duration::from_millis(1100));
    store.put("two", &2.0).unwrap();
    assert_eq!(folder.store("a").get::<f64>("two"), Some(2.0));
}

/// Place of a byte inside the result of the first case.
fn inside_first_result(segment: &[u8]) -> usize {
    let head = segment.iter().position(|byte| *byte == b'\n').expect("a head") + 1;
    let tabs = segment.iter().enumerate().skip(head).filter(|(_, byte)| **byte == b'\t').map(|(at, _)| at);
    tabs.take(5).last().expect("a record") + 2
}

#[test]
fn a_result_is_read_when_it_is_asked_for_and_one_that_is_damaged_is_then_not_there() {
    let folder = Folder::new("lazily");
    let mut bytes = filled(&folder, 3);
    let at = inside_first_result(&bytes);
    bytes[at] ^= 1;
    rewrite(&folder.segments().remove(0), &bytes);
    let store = folder.store("a");
    assert!(store.has("case 1") && store.has("case 2"));
    assert_eq!(store.standing().damaged, 0, "nobody asked for the damaged one");
    assert!(!store.has("case 0"), "a case whose result is damaged is flown again");
    assert_eq!(store.standing().damaged, 1);
    store.put("case 0", &result(0)).expect("kept");
    assert_eq!(found(&folder, 3), 3, "what was flown again stands behind the damaged one");
}

#[test]
fn of_a_case_that_two_finished_the_whole_one_is_read() {
    let folder = Folder::new("second");
    let bytes = filled(&folder, 3);
    filled(&folder, 3);
    let (first, at) = (folder.segments().remove(0), inside_first_result(&bytes));
    let mut damaged = std::fs::read(&first).expect("a segment");
    assert_eq!(damaged.len(), bytes.len());
    damaged[at] ^= 1;
    rewrite(&first, &damaged);
    assert_eq!(found(&folder, 3), 3);
}
