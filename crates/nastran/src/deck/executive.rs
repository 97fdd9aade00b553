//! Executive control, as far as it says what a deck asks for: SOL with a number or a name.

use crate::source::InputError;
use crate::text_file::read_deck_text;
use std::path::Path;

/// What a solution sequence computes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Analysis {
    /// Linear statics (SOL 101; rigid formats 1 and 24).
    Statics,
    /// Natural modes (SOL 103; rigid formats 3 and 63).
    Modes,
    /// Linear buckling (SOL 105; rigid formats 5 and 65).
    Buckling,
    /// Nonlinear statics (SOL 106, 400 and 401; rigid formats 6 and 66).
    NonlinearStatics,
    /// Complex eigenvalues, frequency and transient response (SOL 107 to 112 and 129; rigid formats 7 to 12).
    Response,
    /// Static aeroelasticity (SOL 144).
    Trim,
    /// Flutter (SOL 145).
    Flutter,
    /// Gusts and other dynamic aeroelastic response (SOL 146).
    Gust,
    /// Optimisation (SOL 200).
    Optimisation,
    /// What wingroot has nothing to do with, such as heat transfer (SOL 153 and 159) or sequences of the user's own (SOL 100).
    Other,
}

/// The names of solution sequences, numbers and words of MSC Nastran's and NASTRAN-95's manuals.
const SOLUTIONS: [(Analysis, &str); 9] = [
    (Analysis::Statics, "1 2 24 47 61 101 114 STATIC STATICS SESTATIC SESTATICS"),
    (Analysis::Modes, "3 25 48 63 103 115 MODES SEMODES NORMAL"),
    (Analysis::Buckling, "4 5 65 105 116 BUCKLING SEBUCKL"),
    (Analysis::NonlinearStatics, "6 64 66 106 400 401 NLSTATIC NONLINEAR"),
    (
        Analysis::Response,
        "7 8 9 10 11 12 26 27 28 29 30 31 67 68 69 70 71 72 99 107 108 109 110 111 112 118 129 SEDCEIG SEDFREQ SEDTRAN \
         SEMCEIG SEMFREQ SEMTRAN NLTRAN",
    ),
    (Analysis::Trim, "21 144 AESTAT SAERO"),
    (Analysis::Flutter, "45 75 145 SEFLUTTR FLUTTER"),
    (Analysis::Gust, "46 76 146 SEAERO"),
    (Analysis::Optimisation, "200 DESOPT"),
];

/// A deck's solution sequence.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Solution {
    /// Number or name as the deck has it.
    pub name: String,
    /// What it computes.
    pub analysis: Analysis,
}

impl Solution {
    /// The solution that a deck's text asks for; nothing if it is bulk data only.
    pub fn of(text: &str) -> Option<Self> {
        for line in text.lines() {
            let line = line.split('$').next().unwrap_or("");
            let mut words = line
                .split(|c: char| c.is_whitespace() || c == '=' || c == ',')
                .filter(|word| !word.is_empty());
            match words.next().map(str::to_ascii_uppercase).as_deref() {
                Some("SOL") => {
                    let name = words.next().unwrap_or_default().to_ascii_uppercase();
                    let known =
                        SOLUTIONS.iter().find(|(_, names)| names.split_whitespace().any(|one| one == name));
                    let analysis = known.map_or(Analysis::Other, |(analysis, _)| *analysis);
                    return Some(Self { name, analysis });
                }
                Some("CEND" | "BEGIN") => return None,
                _ => {}
            }
        }
        None
    }

    /// As [`Solution::of`], of a file.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn of_file(path: &Path) -> Result<Option<Self>, InputError> {
        Ok(Self::of(&read_deck_text(path)?))
    }
}
