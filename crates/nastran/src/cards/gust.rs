//! Gusts and loads that vary in time or over frequency: GUST, TLOAD1, TLOAD2, RLOAD1, RLOAD2, DAREA. They are read, not written, and
//! have no mirror image: they say what is asked of the whole aircraft.

use super::prelude::*;

/// A gust in the stream (GUST): w(t) = WG V f(t - (x - X0)/V).
#[derive(Debug, Clone, PartialEq)]
pub struct Gust {
    /// Identification number, which GUST of the case control selects.
    pub id: u32,
    /// The TLOAD, RLOAD or DLOAD whose function f the gust has.
    pub load: u32,
    /// Gust velocity over airspeed per unit of f, WG.
    pub scale: f64,
    /// Place along the stream that the function refers to, X0.
    pub x_0: f64,
    /// Airspeed V.
    pub velocity: f64,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Gust {
    numbered!();
    /// GUST: SID DLOAD WG X0 V.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        card.ends_after(5)?;
        Ok(vec![Self {
            id: card.id(0, "SID")?,
            load: card.id(1, "DLOAD")?,
            scale: card.real(2, "WG")?,
            x_0: card.real_or(3, "X0", 0.0)?,
            velocity: card.positive(4, "V")?,
            span: card.span.clone(),
        }])
    }

    not_written!();

    // Sets keep their numbers.
    keeps_numbers!();

    no_image!();
}

/// A number, or the table that has it over frequency.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum TableOr {
    /// TABLED1 to TABLED4 of this number.
    Table(u32),
    /// The same at all frequencies.
    Constant(f64),
}

/// The function that a dynamic load has.
#[derive(Debug, Clone, PartialEq)]
pub enum LoadFunction {
    /// TLOAD1: a table over time.
    Table(TableOr),
    /// TLOAD2: t^B e^(C t) cos(2 pi F t + P) from T1 to T2, t counted from T1.
    Wave {
        /// T1 and T2.
        times: [f64; 2],
        /// F, Hz.
        hz: f64,
        /// P, degrees.
        phase_deg: f64,
        /// C, 1/s.
        growth: f64,
        /// B.
        power: f64,
    },
    /// RLOAD1: real and imaginary part over frequency.
    Parts {
        /// TC.
        real: TableOr,
        /// TD.
        imaginary: TableOr,
    },
    /// RLOAD2: amplitude and phase (degrees) over frequency.
    Polar {
        /// TB.
        amplitude: TableOr,
        /// TP.
        phase_deg: TableOr,
    },
}

/// A load that varies in time (TLOAD1, TLOAD2) or over frequency (RLOAD1, RLOAD2).
#[derive(Debug, Clone, PartialEq)]
pub struct DynamicLoad {
    /// Identification number.
    pub id: u32,
    /// DAREA (or static load set) that it multiplies.
    pub area: u32,
    /// Delay, s.
    pub delay: f64,
    /// DELAY card that gives delays in its place; zero for none.
    pub delay_set: u32,
    /// Phase lead of RLOAD, degrees.
    pub phase_deg: f64,
    /// DPHASE card that gives phases in its place; zero for none.
    pub phase_set: u32,
    /// TYPE, `LOAD` if it is a force.
    pub kind: String,
    /// Its function.
    pub function: LoadFunction,
    /// Where the card stands.
    pub span: Span,
}

impl DynamicLoad {
    /// Whether it is given in time.
    pub fn is_in_time(&self) -> bool {
        matches!(self.function, LoadFunction::Table(_) | LoadFunction::Wave { .. })
    }
}

/// A number, or the set that a whole number names.
fn number_or_set(card: &Card, index: usize, what: &str) -> Result<(f64, u32), InputError> {
    match card.text(index).parse::<u32>() {
        Ok(set) => Ok((0.0, set)),
        Err(_) => Ok((card.real_or(index, what, 0.0)?, 0)),
    }
}

/// A number, or the table that a whole number names.
fn table_or(card: &Card, index: usize, what: &str) -> Result<TableOr, InputError> {
    Ok(match number_or_set(card, index, what)? {
        (value, 0) => TableOr::Constant(value),
        (_, table) => TableOr::Table(table),
    })
}

impl DeckCard for DynamicLoad {
    numbered!();
    variant!(|card| match card.function {
        LoadFunction::Table(_) => 0,
        LoadFunction::Wave { .. } => 1,
        LoadFunction::Parts { .. } => 2,
        LoadFunction::Polar { .. } => 3,
    });
    /// TLOAD1: SID EXCITEID DELAY TYPE TID, TLOAD2: SID EXCITEID DELAY TYPE T1 T2 F P / C B,
    /// RLOAD1: SID EXCITEID DELAY DPHASE TC TD TYPE, RLOAD2: SID EXCITEID DELAY DPHASE TB TP TYPE.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let in_time = card.name.starts_with('T');
        let function = match card.name.as_str() {
            "TLOAD1" => LoadFunction::Table(table_or(card, 4, "TID")?),
            "TLOAD2" => {
                let times = [card.real_or(4, "T1", 0.0)?, card.real(5, "T2")?];
                if times[1] <= times[0] {
                    return Err(card.wrong(5, "T2", "after T1"));
                }
                LoadFunction::Wave {
                    times,
                    hz: card.real_or(6, "F", 0.0)?,
                    phase_deg: card.real_or(7, "P", 0.0)?,
                    growth: card.real_or(8, "C", 0.0)?,
                    power: card.not_negative(9, "B", 0.0)?,
                }
            }
            "RLOAD1" => {
                LoadFunction::Parts { real: table_or(card, 4, "TC")?, imaginary: table_or(card, 5, "TD")? }
            }
            _ => LoadFunction::Polar {
                amplitude: table_or(card, 4, "TB")?,
                phase_deg: table_or(card, 5, "TP")?,
            },
        };
        let (delay, delay_set) = number_or_set(card, 2, "DELAY")?;
        let (phase_deg, phase_set) = if in_time { (0.0, 0) } else { number_or_set(card, 3, "DPHASE")? };
        let kind = match card.text(if in_time { 3 } else { 6 }).to_ascii_uppercase().as_str() {
            "" | "0" | "L" | "LO" | "LOA" | "LOAD" => "LOAD".to_owned(),
            other => other.to_owned(),
        };
        let id = card.id(0, "SID")?;
        let area = card.count_or(1, "EXCITEID", 0)?;
        let span = card.span.clone();
        Ok(vec![Self { id, area, delay, delay_set, phase_deg, phase_set, kind, function, span }])
    }

    not_written!();

    keeps_numbers!();

    no_image!();
}

/// A force or moment that dynamic loads multiply (DAREA).
#[derive(Debug, Clone, PartialEq)]
pub struct Darea {
    /// Set, which TLOAD and RLOAD name.
    pub set: u32,
    /// Grid, scalar or extra point.
    pub point: u32,
    /// Component; zero for a point without.
    pub component: u8,
    /// Force or moment.
    pub value: f64,
    /// Where the card stands.
    pub span: Span,
}

impl DeckCard for Darea {
    keyed!(u32, set);
    /// DAREA: SID P1 C1 A1 P2 C2 A2.
    fn read(card: &Card) -> Result<Vec<Self>, InputError> {
        let set = card.id(0, "SID")?;
        let there = [1, 4].into_iter().filter(|at| *at == 1 || !card.text(*at).is_empty());
        there
            .map(|at| {
                let (point, component) = card.motion(at, "P", "C")?;
                let value = card.real(at + 2, "A")?;
                Ok(Self { set, point, component, value, span: card.span.clone() })
            })
            .collect()
    }

    not_written!();

    raises!(cards: point);

    no_image!();
}
