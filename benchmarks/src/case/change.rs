//! Changes of a document before it is read.

use super::Key;
use toml::Value;

/// A value that was put into a document.
#[derive(Clone, Debug, PartialEq)]
pub struct Change {
    /// Where, with entries of lists by number.
    pub key: Key,
    /// By whom.
    pub origin: Origin,
}

/// Who asked for a change.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// A variant of the case, by its name.
    Variant(String),
    /// The user, in these words.
    User(String),
}

impl Change {
    /// Whether the case file itself knows nothing of it.
    pub fn by_user(&self) -> bool {
        matches!(self.origin, Origin::User(_))
    }
}

/// A value as a user writes it: TOML, or else plain text, so that names need no quotes.
pub(super) fn value(text: &str) -> Value {
    let document = format!("value = {text}");
    let parsed = document.parse::<toml::Table>().ok().filter(|table| table.len() == 1);
    parsed.and_then(|mut table| table.remove("value")).unwrap_or_else(|| Value::String(text.trim().to_owned()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_need_no_quotes() {
        assert_eq!(value("2"), Value::Integer(2));
        assert_eq!(value("1.9445e-6"), Value::Float(1.9445e-6));
        assert_eq!(value("[1, 2]").as_array().map(Vec::len), Some(2));
        assert_eq!(value("true"), Value::Boolean(true));
        assert_eq!(value("exact"), Value::String("exact".into()));
        assert_eq!(value("1\nother = 2"), Value::String("1\nother = 2".into()));
    }
}
