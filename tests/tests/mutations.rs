//! Whatever bytes a reader gets, it ends soon, with less than a gigabyte, and without a panic: seeds of the fuzz targets,
//! mutations of them (the same in every run), and inputs of nearly a megabyte that repeat one thing.
//!
//! The work is done by a process of its own, whose memory is measured after each input and limited by the system; its
//! watchdog ends it if one input takes half a minute, which is a hundred times what any needs.

use std::io::Write;
use std::process::Command;
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};
use validation::fuzzing::{ENTRY_POINTS, scratch, seeds};

/// Set for the process that does the work.
const WORKER: &str = "WINGROOT_MUTATIONS";
/// Address space of that process, KiB: what is used must stay below a gigabyte, but the matrix library maps buffers by the
/// size of the processor's cache, half a gigabyte each, and uses little of them.
const ADDRESS_SPACE_KIB: u64 = 6 * 1_048_576;
/// The most memory the process may ever have used, KiB.
const USED_KIB: u64 = 1_048_576;
/// Inputs are below a megabyte.
const LARGEST: usize = 1_000_000;
/// An input that takes longer hangs.
const PATIENCE: Duration = Duration::from_secs(30);
/// Mutations of each seed.
const MUTATIONS: usize = 150;
/// Pieces that numbers, names and brackets are replaced by.
const PIECES: [&str; 22] = [
    "1e400",
    "-1e400",
    "NaN",
    "nan",
    "inf",
    "-inf",
    "999999999999",
    "4294967295",
    "-1",
    "0",
    "1e-320",
    "1.5-3",
    "THRU",
    "((((",
    "))",
    "[",
    ",",
    "\"",
    "//",
    "/*",
    "\n",
    "\u{feff}",
];

#[test]
fn no_input_makes_a_reader_panic_hang_or_fill_the_memory() {
    if std::env::var_os(WORKER).is_some() {
        work();
        return;
    }
    let test = std::env::current_exe().expect("this program");
    let script = format!("ulimit -v {ADDRESS_SPACE_KIB} || exit 99; exec \"$0\" --exact \"$1\" --nocapture");
    let name = "no_input_makes_a_reader_panic_hang_or_fill_the_memory";
    let output = Command::new("sh")
        .args(["-c", &script])
        .arg(&test)
        .arg(name)
        .env(WORKER, "1")
        .env("RAYON_NUM_THREADS", "2")
        .env("MALLOC_ARENA_MAX", "2")
        .output();
    let Ok(output) = output.map_err(|error| println!("skipped: sh does not start ({error})")) else { return };
    if output.status.code() == Some(99) {
        println!("skipped: memory cannot be limited here");
        return;
    }
    let said = String::from_utf8_lossy(&output.stderr);
    let end: String =
        said.lines().rev().take(40).collect::<Vec<_>>().into_iter().rev().collect::<Vec<_>>().join("\n");
    assert!(output.status.success(), "{:?}: {end}", output.status);
}

/// What is being read now, and since when.
type Current = Arc<Mutex<(String, Instant)>>;

fn work() {
    let current: Current = Arc::new(Mutex::new((String::new(), Instant::now())));
    watch(Arc::clone(&current));
    for (name, function) in ENTRY_POINTS {
        let read = |what: &str, bytes: &[u8]| {
            assert!(bytes.len() <= LARGEST, "{name}: {what} is too large");
            *current.lock().expect("no thread panics with it") = (format!("{name}: {what}"), Instant::now());
            // An input that panics or is too much is named last before the end.
            say(&format!("{name}: {what}"));
            function(bytes);
            let used = most_used_kib();
            assert!(used < USED_KIB, "{name}: {what} takes {used} KiB");
        };
        for (seed, bytes) in seeds(name) {
            read(&seed, &bytes);
            let mut random = Random::new(name, &seed);
            for number in 0..MUTATIONS {
                let mutated = mutated(&bytes, &mut random);
                read(&format!("{seed}, mutation {number}"), &mutated);
            }
            for (line, large) in repeated_lines(&bytes) {
                read(&format!("{seed}, line {line} over and over"), &large);
            }
        }
        for (what, text) in large_inputs(name) {
            read(what, text.as_bytes());
        }
    }
    // a folder that stays is only untidy
    let _ = std::fs::remove_dir_all(scratch());
}

/// The most memory this process has used so far, where the system tells (Linux); zero elsewhere.
fn most_used_kib() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
    line.and_then(|line| line.split_whitespace().next()).and_then(|number| number.parse().ok()).unwrap_or(0)
}

/// A line on standard error, at once.
fn say(line: &str) {
    // If standard error is closed there is nobody left to tell.
    let _ = writeln!(std::io::stderr(), "{line}");
}

fn watch(current: Current) {
    std::thread::spawn(move || {
        loop {
            std::thread::sleep(Duration::from_secs(1));
            let (what, since) = current.lock().expect("no thread panics with it").clone();
            if since.elapsed() > PATIENCE {
                say(&format!("hangs: {what}"));
                std::process::abort();
            }
        }
    });
}

/// Numbers that only the seed's name decides (splitmix64, Steele, Lea and Flood 2014).
struct Random(u64);

impl Random {
    fn new(entry_point: &str, seed: &str) -> Self {
        let fold = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        Self(entry_point.bytes().chain(seed.bytes()).fold(0xcbf2_9ce4_8422_2325, fold))
    }

    fn draw(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below `end`; zero if that is zero.
    fn below(&mut self, end: usize) -> usize {
        usize::try_from(self.draw() % (end.max(1) as u64)).expect("it is below a usize")
    }
}

/// One to four changes.
fn mutated(bytes: &[u8], random: &mut Random) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    for _ in 0..=random.below(4) {
        let at = random.below(bytes.len());
        let end = (at + 1 + random.below(40)).min(bytes.len());
        let piece = PIECES[random.below(PIECES.len())].bytes();
        match random.below(7) {
            0 => bytes[at..end].iter_mut().take(1).for_each(|byte| *byte ^= 1 << (at % 8)),
            1 => drop(bytes.drain(at..end)),
            2 => {
                let copy = bytes[at..end].to_vec();
                drop(bytes.splice(at..at, copy));
            }
            3 => drop(bytes.splice(at..at, piece)),
            4 => bytes.truncate(at),
            // a number becomes another
            _ => {
                let digit = |b: &u8| b.is_ascii_digit() || b".-+".contains(b);
                let Some(start) = bytes[at..].iter().position(digit).map(|skip| at + skip) else { continue };
                let length = bytes[start..].iter().position(|b| !digit(b)).unwrap_or(1);
                drop(bytes.splice(start..start + length, piece));
            }
        }
    }
    bytes.truncate(LARGEST);
    bytes
}

/// A seed with one of its lines, of some, repeated up to nearly a megabyte.
fn repeated_lines(bytes: &[u8]) -> Vec<(usize, Vec<u8>)> {
    let lines: Vec<&[u8]> = bytes.split_inclusive(|byte| *byte == b'\n').collect();
    let some = (0..lines.len()).filter(|line| line % (1 + lines.len() / 4) == 2);
    some.map(|line| {
        let copies = (LARGEST.saturating_sub(bytes.len())) / lines[line].len().max(1);
        let before = lines[..line].concat();
        (line, [before, lines[line].repeat(copies), lines[line + 1..].concat()].concat())
    })
    .collect()
}

/// Inputs of nearly a megabyte that one reader or another may not like.
fn large_inputs(entry_point: &str) -> Vec<(&'static str, String)> {
    let many = |count: usize, line: &dyn Fn(usize) -> String| (1..=count).map(line).collect::<String>();
    match entry_point {
        "deck" => vec![
            ("ranges", many(20_000, &|i| format!("SET1,{i},1,THRU,1000001\n"))),
            ("ranges of clamps", "SPC1,1,123456,1,THRU,1000001\n".repeat(20_000)),
            ("grids", many(30_000, &|i| format!("GRID,{i},,{i}.,0.,0.\n"))),
            (
                "systems in a chain",
                many(14_000, &|i| format!("CORD2R,{},{i},0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n", i + 1)),
            ),
            ("rigid elements", many(25_000, &|i| format!("RBE2,{i},{i},123456,{}\n", i + 1))),
            ("panels", many(12_000, &|i| format!("CAERO1,{i}00,1,,9,9\n,0.,0.,0.,1.,0.,1.,0.,1.\n"))),
            (
                "one long card",
                format!(
                    "SET1,1{}",
                    many(70_000, &|i| if i % 8 == 0 { format!(",+\n+,{i}") } else { format!(",{i}") })
                ),
            ),
        ],
        "dmi" => vec![
            ("many matrices", many(20_000, &|i| format!("DMI,A{i},0,2,1,0,,5000,5000\n"))),
            ("many columns", many(20_000, &|i| format!("DMI,A{i},0,2,1,0,,1,100000\n"))),
            (
                "many runs",
                format!(
                    "DMI,A,0,2,1,0,,90000,1\nDMI,A,1{}",
                    many(45_000, &|i| if i % 4 == 0 {
                        format!(",+\n+,{},1.", 2 * i)
                    } else {
                        format!(",{},1.", 2 * i)
                    })
                ),
            ),
        ],
        "table" => vec![
            ("many columns", many(130_000, &|i| format!("c{i:x},"))),
            ("commas", ",".repeat(LARGEST)),
            ("rows", format!("t_s,V_m_s,alpha_deg\n{}", many(60_000, &|i| format!("0.{i:05},20,1\n")))),
            ("a long name", format!("t_s,V_m_s,alpha_deg,{}\n1,2,3,4\n", "x".repeat(900_000))),
        ],
        "campaign" => vec![
            (
                "many blocks",
                format!(
                    "V_m_s,alpha_deg,Fz_N,block\n{}",
                    many(45_000, &|i| format!("20,{},{}.1,b{i}\n", i % 5, i % 5))
                ),
            ),
            (
                "many angles",
                format!(
                    "V_m_s,alpha_deg,Fz_N,block\n{}",
                    many(45_000, &|i| format!("20,{:.3},1.5,b{}\n", i as f64 * 1e-3, i % 150))
                ),
            ),
            ("nested", "(".repeat(LARGEST)),
        ],
        _ => large_files(),
    }
}

/// For readers of RON.
fn large_files() -> Vec<(&'static str, String)> {
    vec![
        ("nested", "(".repeat(LARGEST)),
        ("nested lists", format!("Wing(name: {}", "[".repeat(900_000))),
        ("nested in a field", format!("Wing(name: \"a\", source: {}", "Parametric(".repeat(80_000))),
        ("nested comments", "/*".repeat(LARGEST / 2)),
        ("a long name", format!("Wing(name: \"{}\")", "x".repeat(900_000))),
        ("a long field", format!("Wing({}: 1)", "x".repeat(900_000))),
        ("many fields", format!("Wing({})", "name: \"a\", ".repeat(80_000))),
    ]
}
