//! Numbers that are not finite never enter a result: JSON has none of them and writes `null`, so that a `null` is refused
//! wherever the format does not say what it means. What it means is said in the table of docs/results.md, which is read here.

use std::path::Path;
use std::sync::LazyLock;

use serde_json::Value;

/// The page whose table lists the keys that may be `null` and what that says; empty if the program is damaged, which then
/// refuses every `null`.
static PAGE: LazyLock<String> = LazyLock::new(|| {
    let page = shipped::documents().ok().and_then(|mut all| all.remove(Path::new("results.md")));
    page.and_then(|bytes| String::from_utf8(bytes).ok()).unwrap_or_default()
});

/// Keys that may be `null`; `a/b` is `b` of `a`, and `*` any key or place in a list.
fn meant() -> impl Iterator<Item = &'static str> {
    PAGE.lines().filter_map(|line| Some(line.strip_prefix("| `")?.split_once("` |")?.0))
}

/// The path of the first number that should be there and is not.
pub(crate) fn missing(value: &Value) -> Option<String> {
    let mut path = Vec::new();
    search(value, &mut path).then(|| path.join("/"))
}

/// Leaves the path of what was found in `path`.
fn search(value: &Value, path: &mut Vec<String>) -> bool {
    let entries: Vec<(String, &Value)> = match value {
        Value::Null => return !is_meant(path),
        Value::Object(entries) => entries.iter().map(|(key, value)| (key.clone(), value)).collect(),
        Value::Array(entries) => {
            entries.iter().enumerate().map(|(i, value)| (i.to_string(), value)).collect()
        }
        _ => return false,
    };
    for (key, value) in entries {
        path.push(key);
        if search(value, path) {
            return true;
        }
        path.pop();
    }
    false
}

fn is_meant(path: &[String]) -> bool {
    let matches = |pattern: &str| {
        let parts: Vec<&str> = pattern.split('/').collect();
        parts.len() <= path.len()
            && parts
                .iter()
                .zip(&path[path.len() - parts.len()..])
                .all(|(part, key)| *part == "*" || part == key)
    };
    meant().any(matches)
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn a_number_that_is_not_finite_is_found_with_its_path() {
        let value = json!({ "a": [1.0, { "rms_N": f64::NAN }], "error": null });
        assert_eq!(missing(&value).as_deref(), Some("a/1/rms_N"));
        assert_eq!(missing(&json!([0.0, f64::INFINITY])).as_deref(), Some("1"));
    }

    #[test]
    fn what_the_format_leaves_open_is_no_mistake() {
        let floor = json!({ "gap": { "holdout": { "before": 2.0, "floor": f64::NAN } } });
        assert_eq!(missing(&floor), None);
        assert_eq!(missing(&json!({ "floor": f64::NAN })).as_deref(), Some("floor"));
        assert_eq!(missing(&json!({ "neutral_point_x": [1.0, null, 2.0], "refused": null })), None);
    }

    #[test]
    fn the_table_of_the_page_is_read() {
        assert!(meant().any(|key| key == "gap/holdout/after") && meant().all(|key| !key.contains('`')));
    }
}
