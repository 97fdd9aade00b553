//! Reading a motion: `Kind(of: .., parameters)`. The kind's own type reads its parameters; what every kind has beside
//! them (`of`, and `duration_s` where the file does not give the length of the record) is taken out on the way.

use serde::de::{
    Deserialize, DeserializeSeed, Deserializer, EnumAccess, Error, IntoDeserializer, MapAccess,
    VariantAccess, Visitor,
};
use serde::forward_to_deserialize_any;
use std::fmt;
use std::marker::PhantomData;

/// An angle that files give in degrees, rad.
pub(super) fn degrees<'de, D: Deserializer<'de>>(from: D) -> Result<f64, D::Error> {
    f64::deserialize(from).map(f64::to_radians)
}

/// The same where it may be left out.
pub(super) fn some_degrees<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
    Option::<f64>::deserialize(from).map(|angle| angle.map(f64::to_radians))
}

/// What every kind has beside its parameters.
#[derive(Debug, Default)]
pub(super) struct Beside {
    /// What moves.
    pub(super) of: Option<String>,
    /// Length of the record, s.
    pub(super) duration_s: Option<f64>,
}

/// The fields of a variant as the type of its kind, and those beside; `timed`: whether the length of the record may be
/// among them.
pub(super) fn fields<'de, T: Deserialize<'de>, A: VariantAccess<'de>>(
    variant: A,
    timed: bool,
) -> Result<(T, Beside), A::Error> {
    variant.struct_variant(&[], FieldsVisitor { timed, kind: PhantomData })
}

/// The same of a struct, which may name its kind; the length of the record is among the fields.
pub(super) fn struct_fields<'de, T: Deserialize<'de>, D: Deserializer<'de>>(
    from: D,
) -> Result<(T, Beside), D::Error> {
    let name = std::any::type_name::<T>().rsplit("::").next().unwrap_or_default();
    from.deserialize_struct(name, &[], FieldsVisitor { timed: true, kind: PhantomData })
}

struct FieldsVisitor<T> {
    timed: bool,
    kind: PhantomData<T>,
}

impl<'de, T: Deserialize<'de>> Visitor<'de> for FieldsVisitor<T> {
    type Value = (T, Beside);

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the fields of a motion")
    }

    fn visit_map<M: MapAccess<'de>>(self, map: M) -> Result<Self::Value, M::Error> {
        let mut beside = Beside::default();
        let kind = T::deserialize(Fields { map, beside: &mut beside, timed: self.timed, known: &[] })?;
        Ok((kind, beside))
    }
}

/// The fields of a motion; those beside the kind's are kept as they pass.
struct Fields<'b, M> {
    map: M,
    beside: &'b mut Beside,
    timed: bool,
    /// Fields of the kind.
    known: &'static [&'static str],
}

impl<'de, M: MapAccess<'de>> Deserializer<'de> for Fields<'_, M> {
    type Error = M::Error;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, M::Error> {
        visitor.visit_map(self)
    }

    fn deserialize_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        known: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, M::Error> {
        visitor.visit_map(Self { known, ..self })
    }

    forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 f64 char str string bytes byte_buf option unit unit_struct
        newtype_struct seq tuple tuple_struct map enum identifier ignored_any
    }
}

impl<'de, M: MapAccess<'de>> MapAccess<'de> for Fields<'_, M> {
    type Error = M::Error;

    fn next_key_seed<K: DeserializeSeed<'de>>(&mut self, seed: K) -> Result<Option<K::Value>, M::Error> {
        while let Some(Name(key)) = self.map.next_key()? {
            // runs and cases of aircraft call the height after what moves
            let key = match key.as_str() {
                "deflection_deg" | "amplitude_deg" if self.known.contains(&"height_deg") => "height_deg",
                key => key,
            };
            match key {
                known if self.known.contains(&known) => {
                    return seed.deserialize(key.into_deserializer()).map(Some);
                }
                "of" | "control" if self.beside.of.is_none() => self.beside.of = Some(self.map.next_value()?),
                "duration_s" if self.timed => self.beside.duration_s = Some(self.map.next_value()?),
                unknown => {
                    let mut expected = [&["of"], self.known].concat();
                    expected.extend(self.timed.then_some("duration_s"));
                    // an error may only hold names that last; this is once for a file that is refused
                    return Err(Error::unknown_field(unknown, expected.leak()));
                }
            }
        }
        Ok(None)
    }

    fn next_value_seed<V: DeserializeSeed<'de>>(&mut self, seed: V) -> Result<V::Value, M::Error> {
        self.map.next_value_seed(seed)
    }
}

/// A variant whose name was read already.
pub(super) struct Named<A> {
    pub(super) name: String,
    pub(super) variant: A,
}

impl<'de, A: VariantAccess<'de>> EnumAccess<'de> for Named<A> {
    type Error = A::Error;
    type Variant = A;

    fn variant_seed<V: DeserializeSeed<'de>>(self, seed: V) -> Result<(V::Value, A), A::Error> {
        Ok((seed.deserialize(self.name.into_deserializer())?, self.variant))
    }
}

/// The name of a field or of a kind.
pub(super) struct Name(pub(super) String);

impl<'de> Deserialize<'de> for Name {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        struct NameVisitor;
        impl Visitor<'_> for NameVisitor {
            type Value = Name;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a name")
            }
            fn visit_str<E: Error>(self, name: &str) -> Result<Name, E> {
                Ok(Name(name.to_owned()))
            }
        }
        from.deserialize_identifier(NameVisitor)
    }
}
