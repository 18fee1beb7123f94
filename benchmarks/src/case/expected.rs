//! What a figure should be, and when.

use super::{Change, Key};
use serde::{Deserialize, Serialize};

/// `[[expected]]`
///
/// With `relative` or `absolute` it is a check. With neither, the value is printed next to the figure.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Expected {
    /// Name of the figure.
    pub figure: String,
    /// Its value.
    pub value: f64,
    /// Tolerance, relative to the value.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub relative: Option<f64>,
    /// Tolerance in the unit of the figure.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub absolute: Option<f64>,
    /// Source of the value.
    pub source: String,
    /// Conditions: keys of the case with the value that each must have, or a list of values. `variant` names the variant; without
    /// it the entry is for the case itself.
    #[serde(default, skip_serializing_if = "toml::Table::is_empty")]
    pub when: toml::Table,
}

/// Keys that may be changed without changing what a figure should be.
const HARMLESS: [&str; 4] = ["title", "source", "output", "contact.seed"];

impl Expected {
    /// Largest distance from the value that is still right.
    pub fn tolerance(&self) -> Option<f64> {
        self.absolute.or(self.relative.map(|relative| relative * self.value.abs()))
    }

    /// Whether it is about a case with these contents, as this variant and these changes made it.
    ///
    /// Every condition must hold, and whatever the user changed must be among the conditions: nobody said what the
    /// figures of a softer star are.
    pub fn applies(&self, effective: &toml::Table, variant: Option<&str>, changes: &[Change]) -> bool {
        let conditions = Key::leaves(&self.when);
        let is_variant = |key: &Key| key.to_string() == "variant";
        let of_variant = conditions.iter().find(|(key, _)| is_variant(key)).map(|(_, value)| value);
        let variant_holds = match of_variant {
            None => variant.is_none(),
            Some(value) => variant.is_some_and(|name| agrees(&toml::Value::String(name.into()), value)),
        };
        let holds = |(key, value): &(Key, toml::Value)| {
            is_variant(key) || key.find(effective).is_some_and(|found| agrees(found, value))
        };
        let is_named = |key: &Key| {
            HARMLESS.iter().any(|harmless| key.is_within(&Key::parse(harmless)))
                || conditions.iter().any(|(condition, _)| condition == key)
        };
        variant_holds
            && conditions.iter().all(holds)
            && changes.iter().filter(|change| change.by_user()).all(|change| is_named(&change.key))
    }
}

/// Whether a value is the wanted one, or one of those wanted; numbers may differ by rounding.
fn agrees(found: &toml::Value, wanted: &toml::Value) -> bool {
    let number = |value: &toml::Value| value.as_float().or(value.as_integer().map(|value| value as f64));
    match (number(found), number(wanted), wanted) {
        (Some(found), Some(wanted), _) => (found - wanted).abs() <= 1e-9 * wanted.abs(),
        (_, _, toml::Value::Array(any)) => any.iter().any(|wanted| agrees(found, wanted)),
        _ => found == wanted,
    }
}
