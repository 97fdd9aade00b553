//! At which frequencies and times answers are asked for, and functions over them: FREQ, FREQ1, FREQ2, TSTEP, TABLED1, TABLED2, TABLED3,
//! TABRND1, TABRNDG, RANDPS. They are read, not written, and have no mirror image.

use super::prelude::*;

/// Longest list of frequencies of one card, and of time steps.
const MOST: u32 = 1_000_000;

/// Frequencies that answers are asked for at (FREQ, FREQ1, FREQ2).
#[derive(Debug, Clone, PartialEq)]
pub struct FrequencyList {
    /// Set, which FREQUENCY of the case control selects; all cards of a set count.
    pub set: u32,
    /// Frequencies, Hz.
    pub hz: Vec<f64>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for FrequencyList {
    keyed!(u32, set);
    /// FREQ: SID F1 F2 ..., FREQ1: SID F1 DF NDF, FREQ2: SID F1 F2 NF (equal ratios).
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let set = card.id(0, "SID")?;
        let steps = |default: u32| {
            let count = card.id_or(3, "NDF", default)?;
            if count > MOST { Err(card.wrong(3, "NDF", "at most 1000000")) } else { Ok(count) }
        };
        let hz = match card.name.as_str() {
            "FREQ1" => {
                card.ends_after(4)?;
                let (first, step) = (card.not_negative(1, "F1", 0.0)?, card.positive(2, "DF")?);
                (0..=steps(1)?).map(|i| first + step * f64::from(i)).collect()
            }
            "FREQ2" => {
                card.ends_after(4)?;
                let (first, last) = (card.positive(1, "F1")?, card.positive(2, "F2")?);
                let count = f64::from(steps(1)?);
                (0..=steps(1)?).map(|i| first * (last / first).powf(f64::from(i) / count)).collect()
            }
            _ => {
                let there = (1..card.len()).filter(|at| !card.text(*at).is_empty());
                there.map(|at| card.not_negative(at, "F", 0.0)).collect::<Result<Vec<f64>, _>>()?
            }
        };
        if hz.is_empty() {
            return Err(card.empty(1, "F1", "a frequency"));
        }
        Ok(vec![Self { set, hz, span: card.span.clone() }])
    }

    not_written!();

    // Sets keep their numbers.
    keeps_numbers!();

    no_image!();
}

/// Times that answers are asked for at (TSTEP).
#[derive(Debug, Clone, PartialEq)]
pub struct TimeSteps {
    /// Identification number, which TSTEP of the case control selects.
    pub id: u32,
    /// Number of steps, their length and every how many answers are written, one after the other.
    pub runs: Vec<(u32, f64, u32)>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for TimeSteps {
    numbered!();
    /// TSTEP: SID N1 DT1 NO1 / N2 DT2 NO2 ..., each on a line of its own.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let places = (1..card.len().max(2)).step_by(8).filter(|at| *at == 1 || !card.text(*at).is_empty());
        let run = |at: usize| {
            let run = (card.id(at, "N")?, card.positive(at + 1, "DT")?, card.id_or(at + 2, "NO", 1)?);
            if run.0 > MOST { Err(card.wrong(at, "N", "at most 1000000 steps")) } else { Ok(run) }
        };
        let runs = places.map(run).collect::<Result<_, InputError>>()?;
        Ok(vec![Self { id: card.id(0, "SID")?, runs, span: card.span.clone() }])
    }

    not_written!();

    keeps_numbers!();

    no_image!();
}

impl TimeSteps {
    /// The times at which answers are written, s.
    pub fn times(&self) -> Vec<f64> {
        let mut times = vec![0.0];
        let mut start = 0.0;
        for (count, step, every) in &self.runs {
            let kept = (1..=*count).filter(|i| i % every == 0 || i == count);
            times.extend(kept.map(|i| start + step * f64::from(i)));
            start += step * f64::from(*count);
        }
        times
    }
}

/// A function given by points (TABLED1, TABLED2, TABLED3): y = f((x - shift)/scale).
#[derive(Debug, Clone, PartialEq)]
pub struct FunctionTable {
    /// Identification number.
    pub id: u32,
    /// X1 of TABLED2 and TABLED3.
    pub shift: f64,
    /// X2 of TABLED3.
    pub scale: f64,
    /// Whether x and y are interpolated by their logarithms.
    pub is_log: [bool; 2],
    /// Points, x never falling.
    pub points: Vec<(f64, f64)>,
    /// Where the card stands.
    pub span: Span,
}

/// The pairs of a table up to ENDT, SKIP left out.
fn pairs(card: &Card, from: usize) -> Result<Vec<(f64, f64)>, InputError> {
    let is_end = |at: &usize| card.text(*at).eq_ignore_ascii_case("ENDT");
    let end = (from..card.len()).find(is_end).unwrap_or(card.len());
    let is_skipped = |at: usize| [at, at + 1].iter().any(|at| card.text(*at).eq_ignore_ascii_case("SKIP"));
    let there = (from..end).step_by(2).filter(|at| !card.text(*at).is_empty()).filter(|at| !is_skipped(*at));
    let points: Vec<(f64, f64)> = there
        .map(|at| Ok((card.real(at, "x")?, card.real(at + 1, "y")?)))
        .collect::<Result<_, InputError>>()?;
    if points.is_empty() || points.windows(2).any(|pair| pair[0].0 > pair[1].0) {
        let message = format!("the first numbers of {} do not rise", card.name);
        return Err(card.error(from, message).with_help("list x1 y1 x2 y2 ... ENDT"));
    }
    Ok(points)
}

/// XAXIS and YAXIS.
fn axes(card: &Card) -> Result<[bool; 2], InputError> {
    card.word(1, "XAXIS", &["LINEAR", "LOG"])?;
    card.word(2, "YAXIS", &["LINEAR", "LOG"])?;
    Ok([1, 2].map(|at| card.text(at).eq_ignore_ascii_case("LOG")))
}

/// Demands numbers above zero where logarithms are taken.
fn logarithmic(card: &Card, is_log: [bool; 2], points: &[(f64, f64)]) -> Result<(), InputError> {
    let is_wrong = |(x, y): &(f64, f64)| is_log[0] && *x <= 0.0 || is_log[1] && *y <= 0.0;
    if points.iter().any(is_wrong) {
        let message = format!("{} has a LOG axis and numbers that are not above zero", card.name);
        return Err(card.error(1, message).with_help("use LINEAR, or numbers above zero"));
    }
    Ok(())
}

impl DeckCard for FunctionTable {
    numbered!();
    /// TABLED1: TID XAXIS YAXIS / x1 y1 ... ENDT; TABLED2: TID X1 / ...; TABLED3: TID X1 X2 / ...
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let is_log = if card.name == "TABLED1" { axes(card)? } else { [false; 2] };
        let (shift, scale) = match card.name.as_str() {
            "TABLED1" => (0.0, 1.0),
            "TABLED2" => (card.real_or(1, "X1", 0.0)?, 1.0),
            _ => (card.real_or(1, "X1", 0.0)?, card.real(2, "X2")?),
        };
        if scale == 0.0 {
            return Err(card.wrong(2, "X2", "not zero"));
        }
        let points = pairs(card, 8)?;
        logarithmic(card, is_log, &points)?;
        Ok(vec![Self { id: card.id(0, "TID")?, shift, scale, is_log, points, span: card.span.clone() }])
    }

    not_written!();

    keeps_numbers!();

    no_image!();
}

/// A value between points, by straight lines on linear or logarithmic axes; the first and the last are drawn on beyond the ends. Of
/// two points at one place the mean.
fn interpolated(points: &[(f64, f64)], is_log: [bool; 2], x: f64) -> f64 {
    let same: Vec<f64> = points.iter().filter(|point| point.0 == x).map(|point| point.1).collect();
    if !same.is_empty() || points.len() == 1 {
        let all = if same.is_empty() { vec![points[0].1] } else { same };
        return all.iter().sum::<f64>() / all.len() as f64;
    }
    let above = points.partition_point(|point| point.0 < x).clamp(1, points.len() - 1);
    let on = |value: f64, is_log: bool| if is_log { value.ln() } else { value };
    let [(x1, y1), (x2, y2)] = [points[above - 1], points[above]];
    let share = (on(x, is_log[0]) - on(x1, is_log[0])) / (on(x2, is_log[0]) - on(x1, is_log[0]));
    if x1 == x2 {
        return y2;
    }
    let y = on(y1, is_log[1]) + share * (on(y2, is_log[1]) - on(y1, is_log[1]));
    if is_log[1] { y.exp() } else { y }
}

impl FunctionTable {
    /// The value at x.
    pub fn at(&self, x: f64) -> f64 {
        interpolated(&self.points, self.is_log, (x - self.shift) / self.scale)
    }
}

/// What the power spectral density of a random function is.
#[derive(Debug, Clone, PartialEq)]
pub enum SpectrumShape {
    /// TABRND1: points over frequency, Hz; nothing beyond them.
    Points {
        /// Whether x and y are interpolated by their logarithms.
        is_log: [bool; 2],
        /// Frequency, Hz, and density.
        points: Vec<(f64, f64)>,
    },
    /// TABRNDG.
    Turbulence {
        /// Von Karman's spectrum; Dryden's otherwise.
        is_karman: bool,
        /// Scale over airspeed, s.
        scale_s: f64,
        /// Root mean square.
        rms: f64,
    },
}

/// A power spectral density (TABRND1, TABRNDG).
#[derive(Debug, Clone, PartialEq)]
pub struct SpectrumTable {
    /// Identification number, which RANDPS names.
    pub id: u32,
    /// The density.
    pub shape: SpectrumShape,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for SpectrumTable {
    numbered!();
    variant!(|card| usize::from(matches!(card.shape, SpectrumShape::Turbulence { .. })));
    /// TABRND1: TID XAXIS YAXIS / f1 g1 ... ENDT; TABRNDG: TID TYPE L/U WG.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let shape = if card.name == "TABRND1" {
            let (is_log, points) = (axes(card)?, pairs(card, 8)?);
            logarithmic(card, is_log, &points)?;
            SpectrumShape::Points { is_log, points }
        } else {
            let kind = card.id(1, "TYPE")?;
            if kind > 2 {
                return Err(card.wrong(1, "TYPE", "1 (von Karman) or 2 (Dryden)"));
            }
            let (scale_s, rms) = (card.positive(2, "L/U")?, card.positive(3, "WG")?);
            SpectrumShape::Turbulence { is_karman: kind == 1, scale_s, rms }
        };
        Ok(vec![Self { id: card.id(0, "TID")?, shape, span: card.span.clone() }])
    }

    not_written!();

    keeps_numbers!();

    no_image!();
}

impl SpectrumShape {
    /// The density of points at a frequency, Hz; zero beyond them.
    pub fn of_points(points: &[(f64, f64)], is_log: [bool; 2], hz: f64) -> f64 {
        let inside = (points[0].0..=points[points.len() - 1].0).contains(&hz);
        if inside { interpolated(points, is_log, hz) } else { 0.0 }
    }
}

/// Which subcases are excited by which density (RANDPS): `S_jk = (X + i Y) G`.
#[derive(Debug, Clone, PartialEq)]
pub struct Randps {
    /// Set, which RANDOM of the case control selects.
    pub set: u32,
    /// Subcases J and K.
    pub subcases: [u32; 2],
    /// X and Y.
    pub factor: [f64; 2],
    /// TABRND1 or TABRNDG; zero for a density of one.
    pub table: u32,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Randps {
    keyed!(u32, set);
    /// RANDPS: SID J K X Y TID.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(6)?;
        let subcases = [card.id(1, "J")?, card.id(2, "K")?];
        let factor = [card.real_or(3, "X", 0.0)?, card.real_or(4, "Y", 0.0)?];
        if subcases[0] > subcases[1] || subcases[0] == subcases[1] && factor[1] != 0.0 {
            return Err(card.wrong(2, "K", "J or more, and Y zero where they are the same"));
        }
        let (set, table) = (card.id(0, "SID")?, card.count_or(5, "TID", 0)?);
        Ok(vec![Self { set, subcases, factor, table, span: card.span.clone() }])
    }

    not_written!();

    keeps_numbers!();

    no_image!();
}
