//! Flutter: AERO, FLUTTER, FLFACT, MKAERO1, MKAERO2 and TABDMP1. They are read, not written, and have no mirror image: they say
//! what is asked of the whole aircraft.

use super::prelude::*;

/// References of unsteady aerodynamics (AERO).
#[derive(Debug, Clone, PartialEq)]
pub struct Aero {
    /// Aerodynamic system, x along the stream; 0 is basic.
    pub acsid: u32,
    /// Airspeed of gusts.
    pub velocity: Option<f64>,
    /// Reference chord c of the reduced frequency omega c/(2 V).
    pub chord: f64,
    /// Reference density.
    pub density: f64,
    /// Symmetry about the xz plane: 1 symmetric, 0 none, -1 antisymmetric.
    pub symmetry: i32,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Aero {
    keyed!(u32, acsid);
    /// AERO: ACSID VELOCITY REFC RHOREF SYMXZ SYMXY.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.unset(5, "SYMXY")?;
        let symmetry = card.integer_or(4, "SYMXZ", 0)?;
        if !(-1..=1).contains(&symmetry) {
            return Err(card.wrong(4, "SYMXZ", "1, 0 or -1"));
        }
        Ok(vec![Self {
            acsid: card.count_or(0, "ACSID", 0)?,
            velocity: card.optional_real(1, "VELOCITY")?,
            chord: card.positive(2, "REFC")?,
            density: card.positive(3, "RHOREF")?,
            symmetry,
            span: card.span.clone(),
        }])
    }

    not_written!();

    raises!(systems: acsid);

    no_image!();
}

/// How flutter is looked for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FlutterMethod {
    /// PK: every density with every Mach number and every airspeed.
    Pk,
    /// PKNL: densities, Mach numbers and airspeeds one by one, as matched points.
    Pknl,
    /// K, and KE without viscous damping: every density with every Mach number and every reduced frequency.
    K {
        /// KE.
        is_efficient: bool,
    },
}

/// What flutter is looked for (FLUTTER).
#[derive(Debug, Clone, PartialEq)]
pub struct Flutter {
    /// Identification number, which FMETHOD of the case control selects.
    pub id: u32,
    /// The method.
    pub method: FlutterMethod,
    /// FLFACT of density ratios.
    pub densities: u32,
    /// FLFACT of Mach numbers.
    pub machs: u32,
    /// FLFACT of airspeeds (PK, PKNL) or reduced frequencies (K, KE).
    pub speeds: u32,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Flutter {
    numbered!();
    /// FLUTTER: SID METHOD DENS MACH RFREQ IMETH NVALUE/OMAX EPS; how forces are interpolated, how many roots are printed and how
    /// exactly is skipped.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(8)?;
        let method = match card.text(1).to_ascii_uppercase().as_str() {
            "PK" | "PKS" => FlutterMethod::Pk,
            "PKNL" | "PKNLS" => FlutterMethod::Pknl,
            "K" => FlutterMethod::K { is_efficient: false },
            "KE" => FlutterMethod::K { is_efficient: true },
            _ => return Err(card.wrong(1, "METHOD", "PK, PKS, PKNL, PKNLS, K or KE")),
        };
        Ok(vec![Self {
            id: card.id(0, "SID")?,
            method,
            densities: card.id(2, "DENS")?,
            machs: card.id(3, "MACH")?,
            speeds: card.id(4, "RFREQ")?,
            span: card.span.clone(),
        }])
    }

    not_written!();

    // Sets keep their numbers.
    keeps_numbers!();

    no_image!();
}

/// A list of densities, Mach numbers, airspeeds or reduced frequencies (FLFACT).
#[derive(Debug, Clone, PartialEq)]
pub struct Flfact {
    /// Identification number.
    pub id: u32,
    /// The list.
    pub values: Vec<f64>,
    /// Where the card stands.
    pub span: Span,
}

/// Longest list that THRU makes.
const MOST_FACTORS: u32 = 10_000;

impl DeckCard for Flfact {
    numbered!();
    /// FLFACT: SID F1 F2 ..., or SID F1 THRU FNF NF FMID.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let values = if card.text(2).eq_ignore_ascii_case("THRU") {
            through(card)?
        } else {
            let given = (1..card.len()).filter(|at| {
                let text = card.text(*at);
                !text.is_empty() && !text.eq_ignore_ascii_case("ENDT")
            });
            given.map(|at| card.real(at, "F")).collect::<Result<_, _>>()?
        };
        if values.is_empty() {
            return Err(card.empty(1, "F1", "a list of numbers"));
        }
        Ok(vec![Self { id: card.id(0, "SID")?, values, span: card.span.clone() }])
    }

    not_written!();

    keeps_numbers!();

    no_image!();
}

/// NF values from F1 to FNF, nearer together where they are near FMID (Quick Reference Guide, FLFACT, remark 5).
fn through(card: &Card) -> Result<Vec<f64>, InputError> {
    card.ends_after(6)?;
    let (first, last) = (card.real(1, "F1")?, card.real(3, "FNF")?);
    let count = card.id(4, "NF")?;
    if !(2..=MOST_FACTORS).contains(&count) {
        return Err(card.wrong(4, "NF", "2 to 10000 values"));
    }
    let middle = card.real_or(5, "FMID", 0.5 * (first + last))?;
    let is_between = middle > first.min(last) && middle < first.max(last);
    if first != last && !is_between {
        return Err(card.wrong(5, "FMID", "a number between F1 and FNF"));
    }
    let end = f64::from(count) - 1.0;
    let value = |i: f64| {
        let (near, far) = ((last - middle) * (end - i), (middle - first) * i);
        if first == last { first } else { (first * near + last * far) / (near + far) }
    };
    Ok((0..count).map(|i| value(f64::from(i))).collect())
}

/// Mach numbers and reduced frequencies of the air forces (MKAERO1, MKAERO2).
#[derive(Debug, Clone, PartialEq)]
pub struct Mkaero {
    /// Mach number and reduced frequency omega c/(2 V), one a pair.
    pub pairs: Vec<(f64, f64)>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Mkaero {
    type Key = &'static str;
    fn key(&self) -> Self::Key {
        ""
    }
    fn span(&self) -> &Span {
        &self.span
    }
    /// MKAERO1: M1 ... M8 / K1 ... K8, every M with every K; MKAERO2: M1 K1 M2 K2 ...
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let given = |places: std::ops::Range<usize>, name: &'static str| {
            let there = places.filter(|at| !card.text(*at).is_empty());
            there.map(|at| card.not_negative(at, name, 0.0)).collect::<Result<Vec<f64>, _>>()
        };
        let pairs: Vec<(f64, f64)> = if card.name == "MKAERO1" {
            card.ends_after(16)?;
            let (machs, ks) = (given(0..8, "M")?, given(8..16, "K")?);
            machs.iter().flat_map(|mach| ks.iter().map(|k| (*mach, *k))).collect()
        } else {
            let places = (0..card.len()).step_by(2).filter(|at| !card.text(*at).is_empty());
            let pair = |at: usize| {
                let k = card.real(at + 1, "K")?;
                Ok((card.not_negative(at, "M", 0.0)?, k))
            };
            places.map(pair).collect::<Result<_, InputError>>()?
        };
        if pairs.is_empty() {
            return Err(card.empty(0, "M1", "a Mach number and a reduced frequency"));
        }
        Ok(vec![Self { pairs, span: card.span.clone() }])
    }

    not_written!();

    keeps_numbers!();

    no_image!();
}

/// What the numbers of a damping table are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DampingKind {
    /// Structural damping g, twice the damping ratio.
    Structural,
    /// Shares of critical damping.
    Critical,
    /// Magnification Q at resonance, 1/g.
    Quality,
}

/// Damping of modes over frequency (TABDMP1).
#[derive(Debug, Clone, PartialEq)]
pub struct Tabdmp1 {
    /// Identification number, which SDAMPING of the case control selects.
    pub id: u32,
    /// What its numbers are.
    pub kind: DampingKind,
    /// Frequency, Hz, and value, in rising frequencies.
    pub points: Vec<(f64, f64)>,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Tabdmp1 {
    numbered!();
    /// TABDMP1: TID TYPE / F1 G1 F2 G2 ... ENDT.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let kind = match card.text(1).to_ascii_uppercase().as_str() {
            "" | "G" => DampingKind::Structural,
            "CRIT" => DampingKind::Critical,
            "Q" => DampingKind::Quality,
            _ => return Err(card.wrong(1, "TYPE", "G, CRIT or Q")),
        };
        let is_end = |at: &usize| card.text(*at).eq_ignore_ascii_case("ENDT");
        let end = (8..card.len()).find(is_end).unwrap_or(card.len());
        let point = |at: usize| Ok((card.real(at, "f")?, card.real(at + 1, "g")?));
        let there = (8..end).step_by(2).filter(|at| !card.text(*at).is_empty());
        let points: Vec<(f64, f64)> = there.map(point).collect::<Result<_, InputError>>()?;
        if points.is_empty() || points.windows(2).any(|pair| pair[0].0 > pair[1].0) {
            return Err(card
                .error(8, "the frequencies of TABDMP1 do not rise")
                .with_help("list f1 g1 f2 g2 ..."));
        }
        Ok(vec![Self { id: card.id(0, "TID")?, kind, points, span: card.span.clone() }])
    }

    not_written!();

    keeps_numbers!();

    no_image!();
}

impl Tabdmp1 {
    /// Structural damping g at a frequency, Hz: straight lines between the points, the first and the last
    /// drawn on beyond the ends, as Nastran does.
    pub fn structural_damping(&self, hz: f64) -> f64 {
        let above = self.points.partition_point(|point| point.0 < hz);
        let two = |at: usize| (self.points[at], self.points[at + 1]);
        let last = self.points.len() - 1;
        let ((f1, g1), (f2, g2)) =
            if last == 0 { (self.points[0], self.points[0]) } else { two(above.clamp(1, last) - 1) };
        let value = if f2 > f1 { g1 + (g2 - g1) * (hz - f1) / (f2 - f1) } else { g1 };
        match self.kind {
            DampingKind::Structural => value,
            DampingKind::Critical => 2.0 * value,
            DampingKind::Quality => 1.0 / value,
        }
    }
}
