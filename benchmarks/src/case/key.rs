//! Paths to values of a document: `bodies.star.material.young`.

use std::fmt;
use toml::Value;

/// Path to a value, from the outside in. Entries of a list go by their `name` or by their number from 0.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Key(pub Vec<String>);

impl Key {
    /// Splits at dots.
    pub fn parse(text: &str) -> Self {
        Self(text.split('.').map(|segment| segment.trim().to_owned()).collect())
    }

    /// The key with one more segment.
    pub fn then(&self, segment: impl fmt::Display) -> Self {
        Self(self.0.iter().cloned().chain([segment.to_string()]).collect())
    }

    /// Whether the other key is this one, or around it.
    pub fn is_within(&self, other: &Key) -> bool {
        self.0.starts_with(&other.0)
    }

    /// All values of a table that are no tables, with their keys.
    pub fn leaves(table: &toml::Table) -> Vec<(Key, Value)> {
        fn walk(table: &toml::Table, at: &Key, found: &mut Vec<(Key, Value)>) {
            for (name, value) in table {
                match value {
                    Value::Table(inner) => walk(inner, &at.then(name), found),
                    _ => found.push((at.then(name), value.clone())),
                }
            }
        }
        let mut found = Vec::new();
        walk(table, &Key::default(), &mut found);
        found
    }

    /// The value that it leads to.
    pub fn find<'a>(&self, table: &'a toml::Table) -> Option<&'a Value> {
        let (first, rest) = self.0.split_first()?;
        rest.iter().try_fold(table.get(first)?, |value, segment| match value {
            Value::Table(table) => table.get(segment),
            Value::Array(entries) => entries.get(index(entries, segment)?),
            _ => None,
        })
    }

    /// The same path with entries of lists called by their names, where they have one.
    pub fn with_names(&self, table: &toml::Table) -> Self {
        let mut named = Self::default();
        for (depth, segment) in self.0.iter().enumerate() {
            let here = Key(self.0[..=depth].to_vec()).find(table);
            let is_number = segment.parse::<usize>().is_ok();
            let name = here.and_then(|value| value.get("name")).and_then(Value::as_str).filter(|_| is_number);
            named = named.then(name.unwrap_or(segment));
        }
        named
    }

    /// The same path with entries of lists called by their numbers.
    pub fn with_numbers(&self, table: &toml::Table) -> Self {
        let mut numbered = Self::default();
        for segment in &self.0 {
            let number = match numbered.find(table) {
                Some(Value::Array(entries)) => index(entries, segment),
                _ => None,
            };
            numbered = numbered.then(number.map_or(segment.clone(), |number| number.to_string()));
        }
        numbered
    }

    /// Puts a value where the path leads; tables on the way that are missing are made.
    ///
    /// # Errors
    /// A sentence, if the path leads into something that is no table and no list, or to a missing entry of a list.
    pub fn set(&self, table: &mut toml::Table, value: Value) -> Result<(), String> {
        let Some((first, rest)) = self.0.split_first() else { return Err("the key is empty".into()) };
        let mut name = first;
        let mut place = table.entry(first).or_insert_with(|| Value::Table(toml::Table::new()));
        for segment in rest {
            place = match place {
                Value::Table(table) => table.entry(segment).or_insert_with(|| Value::Table(toml::Table::new())),
                Value::Array(entries) => match index(entries, segment) {
                    Some(index) => &mut entries[index],
                    None => {
                        let names = names(entries);
                        return Err(format!("{name} has no '{segment}'; it has {}", names.join(", ")));
                    }
                },
                _ => return Err(format!("{name} is a single value and has no '{segment}'")),
            };
            name = segment;
        }
        *place = value;
        Ok(())
    }
}

/// Entry of a list by its name or number.
fn index(entries: &[Value], segment: &str) -> Option<usize> {
    let by_name = entries.iter().position(|entry| entry.get("name").and_then(Value::as_str) == Some(segment));
    by_name.or(segment.parse().ok().filter(|&number| number < entries.len()))
}

/// What the entries of a list go by.
fn names(entries: &[Value]) -> Vec<String> {
    let name = |(number, entry): (usize, &Value)| {
        entry.get("name").and_then(Value::as_str).map_or(number.to_string(), str::to_owned)
    };
    if entries.is_empty() { vec!["no entries".into()] } else { entries.iter().enumerate().map(name).collect() }
}

impl fmt::Display for Key {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.0.join("."))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_go_by_name_or_number() {
        let mut table: toml::Table =
            "[[bodies]]\nname = 'a'\nx = [1, 2]\n[[bodies]]\nname = 'b'\nx = [3, 4]".parse().unwrap();
        for text in ["bodies.b.x.1", "bodies.1.x.1"] {
            assert_eq!(Key::parse(text).find(&table).and_then(Value::as_integer), Some(4), "{text}");
        }
        assert_eq!(Key::parse("bodies.1.x").with_names(&table), Key::parse("bodies.b.x"));
        assert_eq!(Key::parse("bodies.b.x").with_numbers(&table), Key::parse("bodies.1.x"));
        Key::parse("bodies.b.x.0").set(&mut table, Value::Integer(7)).unwrap();
        assert_eq!(Key::parse("bodies.1.x.0").find(&table).and_then(Value::as_integer), Some(7));
        let refusal = Key::parse("bodies.c.x").set(&mut table, Value::Integer(7)).unwrap_err();
        assert_eq!(refusal, "bodies has no 'c'; it has a, b");
        assert!(Key::parse("bodies.a.name.first").set(&mut table, Value::Integer(7)).is_err());
    }
}
