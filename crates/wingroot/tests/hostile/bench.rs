//! Runs rows in parallel, each in a copy of the example of its own, with 20 s, 8 GB of addresses, and no result.

use super::row::{Change, End, Row};
use std::collections::BTreeSet;
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

const PROGRAM: &str = env!("CARGO_BIN_EXE_wingroot");
/// Longest answer.
const LONGEST: Duration = Duration::from_secs(20);
/// Most that may be said, bytes.
const MOST_SAID: usize = 2000;
/// Addresses of a process, kB.
const ADDRESSES: u32 = 8_000_000;

/// Runs rows and gives what is wrong with the answers.
pub(crate) fn run(rows: &[Row]) -> Vec<String> {
    let scratch = std::env::temp_dir().join(format!("wingroot-hostile-{}", std::process::id()));
    let example = scratch.join("example");
    make_example(&example);
    let next = AtomicUsize::new(0);
    let bad = Mutex::new(Vec::new());
    let threads = std::thread::available_parallelism().map_or(2, usize::from);
    std::thread::scope(|scope| {
        for _ in 0..threads {
            scope.spawn(|| {
                while let Some(row) = rows.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let folder = scratch.join(format!("{:?}", std::thread::current().id()));
                    if let Err(wrong) = answer(row, &example, &folder) {
                        bad.lock().expect("no row panics").push(format!("{row}\n    {wrong}"));
                    }
                    std::fs::remove_dir_all(&folder).expect("the row's folder");
                }
            });
        }
    });
    std::fs::remove_dir_all(&scratch).expect("the temporary folder");
    bad.into_inner().expect("no row panics")
}

/// The example of `new`, and beside it what it does not have.
fn make_example(folder: &Path) {
    let parent = folder.parent().expect("it is below the scratch folder");
    std::fs::create_dir_all(parent).expect("a temporary folder");
    let made = Command::new(PROGRAM).arg("new").arg(folder).output().expect("the program starts");
    assert!(made.status.success(), "{}", String::from_utf8_lossy(&made.stderr));
    for (name, content) in super::lists::added() {
        std::fs::write(folder.join(name), content).expect("a file of the example");
    }
    // corrections of the example, so that commands that need some do not calibrate first
    let calibrated =
        Command::new(PROGRAM).args(["calibrate", "--out", "results"]).current_dir(folder).output();
    assert!(calibrated.expect("the program starts").status.success());
    std::fs::copy(folder.join("results/corrections.ron"), folder.join("corrections.ron"))
        .expect("corrections");
    std::fs::remove_dir_all(folder.join("results")).expect("results");
}

fn copy(from: &Path, to: &Path) {
    std::fs::create_dir_all(to).expect("the row's folder");
    for entry in std::fs::read_dir(from).expect("the example").flatten() {
        let target = to.join(entry.file_name());
        if entry.path().is_dir() {
            copy(&entry.path(), &target);
        } else {
            std::fs::copy(entry.path(), target).expect("a file of the example");
        }
    }
}

fn change(row: &Row, folder: &Path) {
    if row.file.is_empty() {
        return;
    }
    let path = folder.join(&row.file);
    let read = || std::fs::read_to_string(&path).unwrap_or_else(|error| panic!("{row}: {error}"));
    let written = match &row.change {
        Change::Text(from, to) => {
            let before = read();
            let after = before.replacen(from, to, 1);
            assert_ne!(before, after, "{row}: the change does nothing");
            after.into_bytes()
        }
        Change::At(at, from, to) => {
            let before = read();
            assert!(before[*at..].starts_with(from.as_str()), "{row}: the text is not there");
            format!("{}{to}{}", &before[..*at], &before[at + from.len()..]).into_bytes()
        }
        Change::Whole(content) => content.clone(),
        Change::Gone | Change::Folder => {
            std::fs::remove_file(&path).unwrap_or_else(|error| panic!("{row}: {error}"));
            if matches!(row.change, Change::Folder) {
                std::fs::create_dir(&path).expect("a folder");
            }
            return;
        }
    };
    std::fs::write(path, written).expect("a file of the row");
}

/// Names below a folder.
fn names(folder: &Path) -> BTreeSet<PathBuf> {
    let mut found = BTreeSet::new();
    for entry in std::fs::read_dir(folder).expect("a folder").flatten() {
        if entry.path().is_dir() {
            found.extend(names(&entry.path()));
        }
        found.insert(entry.path());
    }
    found
}

fn start(row: &Row, folder: &Path) -> Child {
    let words: Vec<&str> = row.command.split_whitespace().collect();
    let mut command = if cfg!(target_os = "linux") {
        let mut shell = Command::new("sh");
        shell.arg("-c").arg(format!("ulimit -v {ADDRESSES}; exec \"$0\" \"$@\"")).arg(PROGRAM);
        shell
    } else {
        Command::new(PROGRAM)
    };
    command.args(words).args(["--threads", "1"]).current_dir(folder);
    command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
    command.env_remove("RUST_LOG").spawn().expect("the program starts")
}

/// What is wrong with the answer to a row.
fn answer(row: &Row, example: &Path, folder: &Path) -> Result<(), String> {
    copy(example, folder);
    change(row, folder);
    let before = names(folder);
    let begun = Instant::now();
    let mut child = start(row, folder);
    let mut streams = (child.stdout.take().expect("piped"), child.stderr.take().expect("piped"));
    let output = std::thread::spawn(move || {
        let (mut out, mut said) = (Vec::new(), Vec::new());
        // what is said is short, so that neither pipe is full before the other is read
        let _ = (streams.1.read_to_end(&mut said), streams.0.read_to_end(&mut out));
        said
    });
    let status = loop {
        if let Some(status) = child.try_wait().expect("a child") {
            break status;
        }
        if begun.elapsed() > LONGEST {
            let _ = child.kill();
            let _ = child.wait();
            return Err(format!("no answer within {} s", LONGEST.as_secs()));
        }
        std::thread::sleep(Duration::from_millis(5));
    };
    let said = String::from_utf8_lossy(&output.join().expect("a reader")).into_owned();
    let wrong = |what: &str| Err(format!("{what}, status {:?}: {}", status.code(), said.trim_end()));
    if said.contains("panicked") {
        return wrong("a panic");
    }
    match (row.end, status.code()) {
        (End::Open, Some(0)) => return Ok(()),
        (End::Refused | End::Open, Some(2)) | (End::Stopped | End::Open, Some(3)) => {}
        _ => return wrong("another end"),
    }
    if said.lines().filter(|line| line.starts_with("error: ")).count() != 1 {
        return wrong("not one error");
    }
    if said.len() > MOST_SAID {
        return wrong(&format!("{} bytes are said", said.len()));
    }
    // what cannot be computed is not always one file's
    if row.end == End::Open && status.code() == Some(3) {
        return Ok(());
    }
    if let Some(word) = row.words.iter().find(|word| !said.contains(word.as_str())) {
        return wrong(&format!("`{word}` is not said"));
    }
    if status.code() == Some(2) && names(folder) != before {
        let new: Vec<_> = names(folder).difference(&before).cloned().collect();
        return wrong(&format!("something is written: {new:?}"));
    }
    Ok(())
}
