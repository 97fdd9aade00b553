//! The JSON schema of motions as files have them: the fields of a kind with what every kind has beside them (see `read`).

use super::{MotionOr, MotionSpec, Shape};
use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde_json::{Map, Value, json};
use std::borrow::Cow;
use std::marker::PhantomData;

/// Other names of the height.
const HEIGHTS: [&str; 3] = ["height_deg", "deflection_deg", "amplitude_deg"];

/// Names of what moves.
const MOVED: [&str; 2] = ["of", "control"];

/// The fields of kind `K`; `timed`: whether the length of the record may be among them.
///
/// What has a height moves what is named; where the height may be left out, so may the name.
pub(super) fn of_kind<K: JsonSchema>(generator: &mut SchemaGenerator, timed: bool) -> Schema {
    let mut schema = K::json_schema(generator);
    let mut choices = Vec::new();
    if let Some(Value::Array(required)) = schema.get_mut("required")
        && let Some(at) = required.iter().position(|name| name == HEIGHTS[0])
    {
        required.remove(at);
        choices = [one_of(&HEIGHTS), one_of(&MOVED)].to_vec();
    }
    if let Some(Value::Object(fields)) = schema.get_mut("properties") {
        if let Some(height) = fields.get(HEIGHTS[0]).cloned() {
            fields.extend(HEIGHTS.map(|name| (name.to_owned(), height.clone())));
            let what = "What moves: \"alpha\" (the angle of attack) or the name of a control surface.";
            let moved = json!({ "type": "string", "description": what });
            fields.extend(MOVED.map(|name| (name.to_owned(), moved.clone())));
        }
        if timed {
            let length = json!({ "type": "number", "description": "Length of the record, s; left out: to the motion's end." });
            fields.entry("duration_s").or_insert(length);
        }
    }
    if !choices.is_empty() {
        schema.insert("allOf".into(), choices.into());
    }
    schema
}

/// Exactly one of these fields.
fn one_of(names: &[&str]) -> Value {
    json!({ "oneOf": names.iter().map(|name| json!({ "required": [name] })).collect::<Vec<_>>() })
}

/// `{ "Doublet": { ... } }` for every kind.
fn motions(generator: &mut SchemaGenerator, timed: bool) -> Vec<Value> {
    let named = |(name, fields): (&str, Schema)| {
        let properties = Map::from_iter([(name.to_owned(), Value::from(fields))]);
        json!({ "type": "object", "properties": properties, "required": [name], "additionalProperties": false })
    };
    Shape::schemas(generator, timed).into_iter().map(named).collect()
}

impl JsonSchema for MotionSpec {
    fn schema_name() -> Cow<'static, str> {
        "Motion".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        json_schema!({ "description": "What moves, and how.", "oneOf": motions(generator, false) })
    }
}

impl<T: JsonSchema> JsonSchema for MotionOr<T> {
    fn schema_name() -> Cow<'static, str> {
        format!("MotionOr{}", T::schema_name()).into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let mut all = motions(generator, true);
        all.push(generator.subschema_for::<T>().into());
        json_schema!({ "description": "A motion with the length of its record, or something else.", "oneOf": all })
    }
}

/// In a schema: a motion whose kind the place in a file says ([`super::of_kind`]).
#[derive(Debug)]
pub struct OfKind<K>(PhantomData<K>);

impl<K: JsonSchema> JsonSchema for OfKind<K> {
    fn schema_name() -> Cow<'static, str> {
        format!("Only{}", K::schema_name()).into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        of_kind::<K>(generator, true)
    }
}
