//! The vocabulary of motions: maneuver files, runs of the virtual tunnel, the menu of experiments, the aircraft's cases
//! and the recogniser of runs all say the same kinds. A kind is one file of this folder and one line of the list below.

mod kind;
mod read;
mod schema;
mod signal;

pub use kind::{Column, Kind, Mover, Recognised, Record};
pub use schema::OfKind;
pub use signal::{About, Signal, sampled};

use read::{Beside, Name, Named};
use schemars::{Schema, SchemaGenerator};
use serde::Deserialize;
use serde::de::value::EnumAccessDeserializer;
use serde::de::{Deserializer, EnumAccess, Error, VariantAccess, Visitor};
use std::fmt;
use std::marker::PhantomData;

/// Declares the kinds.
macro_rules! kinds {
    ($($module:ident :: $kind:ident),* $(,)?) => {
        $(mod $module; pub use $module::$kind;)*

        /// A motion of one of the kinds.
        #[derive(Debug, Clone, PartialEq)]
        pub enum Shape {
            $(#[doc = concat!("See [`", stringify!($kind), "`].")] $kind($kind)),*
        }

        /// Names of all kinds in files.
        pub const KINDS: &[&str] = &[$(stringify!($kind)),*];

        impl Shape {
            /// Its name in files.
            pub fn name(&self) -> &'static str {
                match self { $(Self::$kind(_) => stringify!($kind)),* }
            }

            /// What its kind says of it.
            pub fn kind(&self) -> &dyn Kind {
                match self { $(Self::$kind(kind) => kind),* }
            }

            /// Schemas of its kinds as files have them, each with its name.
            fn schemas(generator: &mut SchemaGenerator, timed: bool) -> Vec<(&'static str, Schema)> {
                vec![$((stringify!($kind), schema::of_kind::<$kind>(generator, timed))),*]
            }

            fn kind_mut(&mut self) -> &mut dyn Kind {
                match self { $(Self::$kind(kind) => kind),* }
            }

            fn read<'de, A: VariantAccess<'de>>(
                name: &str,
                variant: A,
                timed: bool,
            ) -> Result<(Self, Beside), A::Error> {
                match name {
                    $(stringify!($kind) => {
                        read::fields(variant, timed).map(|(kind, beside)| (Self::$kind(kind), beside))
                    })*
                    _ => Err(A::Error::unknown_variant(name, KINDS)),
                }
            }
        }

        $(impl From<$kind> for Shape {
            fn from(kind: $kind) -> Self {
                Self::$kind(kind)
            }
        })*

        /// The kind of motion in a record; none if it is no kind that leaves certain signs.
        pub fn recognised(record: &Record<'_>) -> Option<Recognised> {
            [$($kind::recognised),*].into_iter().find_map(|signs| signs(record))
        }
    };
}

kinds! {
    one_minus_cosine::OneMinusCosine,
    doublet::Doublet,
    chirp::Chirp,
    step::Step,
    three_two_one_one::ThreeTwoOneOne,
    triangle::Triangle,
    from_file::FromFile,
}

/// What `of` calls the angle of attack.
pub const ANGLE: &str = "alpha";
/// Largest height, degrees.
const LARGEST_DEG: f64 = 90.0;

/// A motion as a file declares it: what moves, and how.
#[derive(Debug, Clone, PartialEq)]
pub struct MotionSpec {
    /// [`ANGLE`] or the name of a control surface; none where the kind's columns say it.
    pub of: Option<String>,
    /// How it moves.
    pub shape: Shape,
    /// Length of the record in s, where the file says it here.
    pub duration_s: Option<f64>,
}

/// A number of a motion that cannot be.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Fault {
    /// Its field.
    pub field: &'static str,
    /// What is wrong.
    pub message: String,
    /// What to do.
    pub help: &'static str,
}

impl MotionSpec {
    /// A motion of what `of` names.
    pub fn new(of: &str, shape: impl Into<Shape>) -> Self {
        Self { of: Some(of.to_owned()), shape: shape.into(), duration_s: None }
    }

    /// What the kind called `name` reads from a file; `timed`: whether the file gives the length of the record here.
    fn read<'de, A: VariantAccess<'de>>(name: &str, variant: A, timed: bool) -> Result<Self, A::Error> {
        Shape::read(name, variant, timed).and_then(|(shape, beside)| Self::of_parts(shape, beside))
    }

    fn of_parts<E: Error>(shape: Shape, beside: Beside) -> Result<Self, E> {
        let Beside { of, duration_s } = beside;
        let kind = shape.kind();
        if kind.mover() == Mover::Named && kind.height().is_nan() {
            return Err(E::missing_field("height_deg"));
        }
        let of = match (kind.mover(), of) {
            (Mover::Columns, Some(_)) => return Err(E::unknown_field("of", &["file", "start_s"])),
            (Mover::Named, None) => return Err(E::missing_field("of")),
            (Mover::Angle, None) => Some(ANGLE.to_owned()),
            (_, of) => of,
        };
        Ok(Self { of, shape, duration_s })
    }

    /// The same motion with another height, rad.
    #[must_use]
    pub fn with_height(mut self, height: f64) -> Self {
        self.shape.kind_mut().set_height(height);
        self
    }

    /// Length of the record: what the file says, or to the motion's end, s.
    pub fn record_s(&self) -> f64 {
        self.duration_s.unwrap_or_else(|| self.end_s())
    }

    /// The control surface it moves; none for the angle of attack and for columns.
    pub fn control(&self) -> Option<&str> {
        self.of.as_deref().filter(|of| *of != ANGLE)
    }

    /// Its kind.
    pub fn kind(&self) -> &dyn Kind {
        self.shape.kind()
    }

    /// Puts in what counts from the angle at the beginning (rad), and reads what is kept in a file of its own, named in
    /// the file `path`.
    ///
    /// # Errors
    /// If that file cannot be read or is not what it must be.
    pub fn complete(&mut self, base: f64, path: &std::path::Path) -> Result<(), nastran::InputError> {
        let kind = self.shape.kind_mut();
        kind.count_from(base);
        kind.read_beside(path)
    }

    /// What it adds to the thing called `of`, rad.
    pub fn at(&self, of: &str, t_s: f64) -> f64 {
        let kind = self.kind();
        let own = if self.of.as_deref() == Some(of) { kind.at(t_s) } else { 0.0 };
        let columns = kind.columns().iter().filter(|column| column.of == of);
        columns.fold(own, |sum, column| sum + column.at(t_s - kind.start_s()))
    }

    /// Whether it moves the thing called `of`.
    pub fn moves(&self, of: &str) -> bool {
        self.of.as_deref() == Some(of) || self.kind().columns().iter().any(|column| column.of == of)
    }

    /// Its end, s.
    pub fn end_s(&self) -> f64 {
        self.kind().start_s() + self.kind().length_s()
    }

    /// The first of its numbers that cannot be, at a sampling rate.
    pub fn fault(&self, sample_rate_hz: f64) -> Option<Fault> {
        let (name, kind) = (self.shape.name(), self.kind());
        let fault = |field, message, help| Some(Fault { field, message, help });
        let start_s = kind.start_s();
        if !(start_s >= 0.0 && start_s.is_finite()) {
            let message = format!("{name} starts at {start_s:?} s, before the maneuver");
            return fault("start_s", message, "time counts from the first sample");
        }
        let height_deg = tidy_degrees(kind.height());
        if height_deg.is_nan() || height_deg.abs() > LARGEST_DEG {
            let message = format!("height_deg is {height_deg:?}, beyond 90 degrees");
            return fault("height_deg", message, "angles are in degrees");
        }
        if let Some((field, value)) = kind.above_zero().filter(|(_, v)| !(*v > 0.0 && v.is_finite())) {
            let message = format!("{field} of {name} is {value:?}, expected a number above zero");
            return fault(field, message, "the unit is in the field's name");
        }
        let half = 0.5 * sample_rate_hz;
        let (field, hz) = kind.frequencies().into_iter().find(|(_, hz)| !(0.0..=half).contains(hz))?;
        let message = format!(
            "{name} has {hz} Hz, expected 0 to {half} Hz, half the sampling rate of {sample_rate_hz} Hz"
        );
        fault(field, message, "raise sample_rate_hz, or lower the frequency")
    }
}

/// An angle in degrees as a file gave it, without the rounding of the way to rad and back.
pub fn tidy_degrees(rad: f64) -> f64 {
    (rad.to_degrees() * 1e9).round() / 1e9
}

/// A motion whose kind the place in a file says: its fields alone, with the length of the record.
///
/// # Errors
/// If the fields are not those of the kind.
pub fn of_kind<'de, K: Into<Shape> + Deserialize<'de>, D: Deserializer<'de>>(
    from: D,
) -> Result<MotionSpec, D::Error> {
    let (kind, beside) = read::struct_fields::<K, D>(from)?;
    MotionSpec::of_parts(kind.into(), beside)
}

/// A motion, or something else that a file may name in its place.
#[derive(Debug, Clone, PartialEq)]
pub enum MotionOr<T> {
    /// A motion with the length of its record.
    Motion(MotionSpec),
    /// Something else.
    Other(T),
}

/// An enumeration that shares a place in a file with the kinds of motion.
pub trait Others {
    /// Its names there.
    const NAMES: &'static [&'static str];
}

impl<'de, T: Others + Deserialize<'de>> Deserialize<'de> for MotionOr<T> {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        from.deserialize_enum("Maneuver", T::NAMES, MotionVisitor { timed: true, other: PhantomData })
    }
}

/// Nothing else.
#[derive(Deserialize)]
enum Nothing {}

impl Others for Nothing {
    const NAMES: &'static [&'static str] = &[];
}

impl<'de> Deserialize<'de> for MotionSpec {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        let visitor = MotionVisitor::<Nothing> { timed: false, other: PhantomData };
        match from.deserialize_enum("Motion", KINDS, visitor)? {
            MotionOr::Motion(motion) => Ok(motion),
            MotionOr::Other(never) => match never {},
        }
    }
}

struct MotionVisitor<T> {
    timed: bool,
    other: PhantomData<T>,
}

impl<'de, T: Others + Deserialize<'de>> Visitor<'de> for MotionVisitor<T> {
    type Value = MotionOr<T>;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a motion")
    }

    fn visit_enum<A: EnumAccess<'de>>(self, data: A) -> Result<MotionOr<T>, A::Error> {
        let (Name(name), variant) = data.variant()?;
        if KINDS.contains(&name.as_str()) {
            return MotionSpec::read(&name, variant, self.timed).map(MotionOr::Motion);
        }
        if T::NAMES.contains(&name.as_str()) {
            return T::deserialize(EnumAccessDeserializer::new(Named { name, variant })).map(MotionOr::Other);
        }
        // an error may only hold names that last; this is once for a file that is refused
        Err(A::Error::unknown_variant(&name, [T::NAMES, KINDS].concat().leak()))
    }
}

#[cfg(test)]
mod tests;
