//! Lines that a user can type again: the command of this process without what only this process was asked for.

/// Commands that stand before the command of a sweep, with their own words.
const BEFORE: [&[&str]; 5] =
    [&["prepare"], &["merge"], &["status"], &["cluster", "slurm"], &["cluster", "kubernetes"]];
/// Commands that go over many cases.
const SWEPT: [&str; 4] = ["fullaircraft", "loads", "discover", "hidden"];
/// Options of every command whose value is a word of the user's, which may be a command's.
const WITH_VALUE: [&str; 3] = ["--out", "--threads", "--seed"];
/// Options of one process, and those of `cluster` itself.
const OWN: [&str; 6] = ["--part", "--case", "--parts", "--cpus", "--image", "--claim"];

/// The command line of the sweep that this process works on, without its program and without what only this process is to do.
pub fn sweep_line() -> String {
    let words: Vec<String> = std::env::args().skip(1).collect();
    of_all_cases(words).iter().map(|word| quoted(word)).collect::<Vec<_>>().join(" ")
}

/// The words of a command line without the task of one process: the line of all cases.
pub fn of_all_cases(mut words: Vec<String>) -> Vec<String> {
    let is_value = |at: usize| at > 0 && WITH_VALUE.iter().chain(&OWN).any(|option| *option == words[at - 1]);
    let swept = (0..words.len()).find(|&at| SWEPT.contains(&words[at].as_str()) && !is_value(at));
    for before in BEFORE {
        let at = words.windows(before.len()).position(|found| found == before);
        if let Some(at) = at.filter(|at| swept.is_some_and(|swept| *at < swept)) {
            words.drain(at..at + before.len());
            break;
        }
    }
    let mut is_value = false;
    words.retain(|word| {
        let is_kept = swept.is_none()
            || !(is_value
                || OWN.iter().any(|own| {
                    word.strip_prefix(own).is_some_and(|rest| rest.is_empty() || rest.starts_with('='))
                }));
        is_value = swept.is_some() && OWN.contains(&word.as_str());
        is_kept
    });
    words
}

/// A word as a shell takes it.
pub fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_./=:,+@%".contains(c);
    if !word.is_empty() && word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_is_that_of_all_cases() {
        let of = |text: &str| of_all_cases(text.split(' ').map(str::to_owned).collect()).join(" ");
        assert_eq!(of("merge fullaircraft --cases a.ron --out x"), "fullaircraft --cases a.ron --out x");
        assert_eq!(of("--out merged status hidden --cases 20"), "--out merged hidden --cases 20");
        assert_eq!(of("hidden --part 3/8 --cases 20 --case=0123"), "hidden --cases 20");
        assert_eq!(of("cluster slurm --parts 8 --cpus=1 hidden --cases 20"), "hidden --cases 20");
        assert_eq!(of("cluster kubernetes --claim loads loads --out loads"), "loads --out loads");
        assert_eq!(
            of("--out loads merge fullaircraft --cases a.ron"),
            "--out loads fullaircraft --cases a.ron"
        );
        assert_eq!(of("modes --count 3"), "modes --count 3");
        assert_eq!(quoted("it's"), r"'it'\''s'");
    }
}
