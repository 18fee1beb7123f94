//! A case file with its lines, its variants and the changes made to it.

use super::{Case, CaseError, Change, Key, Origin, Problem, change, check, library};
use std::path::{Path, PathBuf};
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A case file, before and after changes.
#[derive(Clone, Debug)]
pub struct Document {
    /// Name of the case: that of the file without its ending.
    pub name: String,
    /// The file as the user named it, or the built-in one.
    pub file: String,
    /// Folder that mesh files are looked for in.
    pub folder: PathBuf,
    text: String,
    table: toml::Table,
    /// Everything that was changed, in order.
    pub changes: Vec<Change>,
    /// The variant that was chosen.
    pub variant: Option<String>,
}

impl Document {
    /// Opens a case by the name of a built-in one or by the path of its file.
    ///
    /// # Errors
    /// If there is neither, or the file is no TOML.
    pub fn open(case: &str) -> Result<Self, CaseError> {
        if let Some((name, text)) = library::CASES.iter().find(|(name, _)| *name == case) {
            return Self::parse(name, &format!("cases/{name}.toml"), Path::new(""), text);
        }
        let path = Path::new(case);
        let text = std::fs::read_to_string(path).map_err(|error| {
            let is_path = case.contains(['/', '\\']) || case.ends_with(".toml");
            let message = if is_path {
                format!("it cannot be read: {error}")
            } else {
                let near = nearest(case, library::CASES.iter().map(|(name, _)| *name));
                let hint = near.map_or(String::new(), |near| format!("; did you mean '{near}'?"));
                format!("there is no such case and no such file{hint}; `fmc list` shows the cases")
            };
            CaseError { problems: vec![Problem { place: case.to_owned(), key: None, message }] }
        })?;
        let name = path.file_stem().map_or("case".into(), |stem| stem.to_string_lossy().into_owned());
        Self::parse(&name, case, path.parent().unwrap_or(Path::new("")), &text)
    }

    /// Reads a document; `folder` is where it looks for mesh files.
    ///
    /// # Errors
    /// If it is no TOML.
    pub fn parse(name: &str, file: &str, folder: &Path, text: &str) -> Result<Self, CaseError> {
        let table = text.parse().map_err(|error: toml::de::Error| {
            let line = error.span().map_or(1, |span| line_at(text, span.start));
            let message = error.message().trim_end_matches('\n').replace('\n', "; ");
            CaseError { problems: vec![Problem { place: format!("{file}:{line}"), key: None, message }] }
        })?;
        let (name, file, text, folder) = (name.to_owned(), file.to_owned(), text.to_owned(), folder.to_owned());
        Ok(Self { name, file, folder, text, table, changes: Vec::new(), variant: None })
    }

    /// Makes the changes of a variant.
    ///
    /// # Errors
    /// If there is no such variant, or it changes what is not there.
    pub fn choose(&mut self, variant: &str) -> Result<(), CaseError> {
        let variants = self.table.get("variants").and_then(|value| value.as_table());
        let Some(chosen) = variants.and_then(|variants| variants.get(variant)) else {
            let names: Vec<&str> = variants.into_iter().flat_map(|names| names.keys()).map(String::as_str).collect();
            let known = if names.is_empty() { "none".into() } else { names.join(", ") };
            let message = format!("there is no variant '{variant}'; there are: {known}");
            return Err(self.problem(None, message));
        };
        let set = chosen.get("set").and_then(|set| set.as_table()).cloned().unwrap_or_default();
        self.variant = Some(variant.to_owned());
        for (key, value) in Key::leaves(&set) {
            self.put(&key, value, Origin::Variant(variant.to_owned()))?;
        }
        Ok(())
    }

    /// Makes a change as the user wrote it, `key=value`; `option` is what the user wrote it behind.
    ///
    /// # Errors
    /// If it has no `=`, or the key leads to a missing entry. A key that no case has is found by [`Self::case`].
    pub fn override_with(&mut self, option: &str, assignment: &str) -> Result<(), CaseError> {
        let place = || format!("{option} {assignment}");
        let Some((key, text)) = assignment.split_once('=') else {
            let message = "it is not KEY=VALUE, as in contact.exponent=2".into();
            return Err(CaseError { problems: vec![Problem { place: place(), key: None, message }] });
        };
        self.put(&Key::parse(key), change::value(text), Origin::User(place()))
    }

    fn put(&mut self, key: &Key, value: toml::Value, origin: Origin) -> Result<(), CaseError> {
        let numbered = key.with_numbers(&self.table);
        if numbered.find(&self.table) == Some(&value) {
            return Ok(());
        }
        if let Err(message) = key.set(&mut self.table, value) {
            let place = match origin {
                Origin::User(words) => words,
                Origin::Variant(name) => format!("{}, variant {name}", self.file),
            };
            return Err(CaseError { problems: vec![Problem { place, key: None, message }] });
        }
        self.changes.retain(|change| change.key != numbered);
        self.changes.push(Change { key: numbered, origin });
        Ok(())
    }

    /// Value of a key as it stands.
    pub fn value(&self, key: &str) -> Option<&toml::Value> {
        Key::parse(key).find(&self.table)
    }

    /// What the document says, checked.
    ///
    /// # Errors
    /// Everything that is wrong with it.
    pub fn case(&self) -> Result<Case, CaseError> {
        let case: Case = serde_path_to_error::deserialize(toml::Value::Table(self.table.clone())).map_err(|error| {
            use serde_path_to_error::Segment;
            let segments = error.path().iter().filter_map(|segment| match segment {
                Segment::Seq { index } => Some(index.to_string()),
                Segment::Map { key } => Some(key.clone()),
                Segment::Enum { .. } | Segment::Unknown => None,
            });
            let mut key = Key(segments.collect());
            let message = error.inner().message().to_owned();
            if let Some(field) = unknown_field(&message)
                && key.0.last().map(String::as_str) != Some(field)
            {
                key = key.then(field);
            }
            self.problem(Some(&key), reworded(&message))
        })?;
        let flaws = check::flaws(&case);
        let problems: Vec<Problem> =
            flaws.into_iter().flat_map(|(key, message)| self.problem(Some(&key), message).problems).collect();
        if problems.is_empty() { Ok(case) } else { Err(CaseError { problems }) }
    }

    /// A problem with the value of a key, blamed on whoever put it there.
    pub fn problem(&self, key: Option<&Key>, message: String) -> CaseError {
        // A table that only a change has brought in is that change's.
        let brought_in = |key: &Key| self.text.parse().is_ok_and(|file: toml::Table| key.find(&file).is_none());
        let around = |change: &&Change| {
            key.is_some_and(|key| key.is_within(&change.key) || change.key.is_within(key) && brought_in(key))
        };
        let place = match self.changes.iter().rev().find(around).map(|change| &change.origin) {
            Some(Origin::User(words)) => words.clone(),
            Some(Origin::Variant(name)) => {
                let line = self.line(&Key(["variants", name, "set"].map(String::from).to_vec()));
                format!("{}:{line}", self.file)
            }
            None => key.map_or(self.file.clone(), |key| format!("{}:{}", self.file, self.line(key))),
        };
        let key = key.map(|key| key.with_names(&self.table));
        CaseError { problems: vec![Problem { place, key, message }] }
    }

    /// Line of a key in the file, from 1; of what is around it, where it is missing.
    fn line(&self, key: &Key) -> usize {
        let Ok(root) = DeTable::parse(&self.text) else { return 1 };
        let mut value: Option<&Spanned<DeValue>> = None;
        let mut start = 0;
        for segment in &key.0 {
            let table = match value.map(Spanned::get_ref) {
                None => Some(root.get_ref()),
                Some(DeValue::Table(table)) => Some(table),
                Some(DeValue::Array(entries)) => {
                    let Some(entry) = segment.parse().ok().and_then(|index: usize| entries.get(index)) else { break };
                    (start, value) = (entry.span().start, Some(entry));
                    continue;
                }
                Some(_) => None,
            };
            let Some((name, inner)) = table.and_then(|table| table.get_key_value(segment.as_str())) else { break };
            (start, value) = (name.span().start, Some(inner));
        }
        line_at(&self.text, start)
    }
}

/// Line of a byte, from 1.
fn line_at(text: &str, byte: usize) -> usize {
    1 + text.as_bytes()[..byte.min(text.len())].iter().filter(|&&byte| byte == b'\n').count()
}

/// The field in a message "unknown field `x`, expected …".
fn unknown_field(message: &str) -> Option<&str> {
    message.strip_prefix("unknown field `")?.split('`').next()
}

/// A message of the parser in words that speak of the file.
fn reworded(message: &str) -> String {
    if let Some(field) = unknown_field(message) {
        let known: Vec<&str> = message.split('`').skip(3).step_by(2).collect();
        let near = nearest(field, known.iter().copied());
        let hint = near.map_or(String::new(), |near| format!("; did you mean '{near}'?"));
        return format!("there is no such key{hint} Known here: {}", known.join(", "))
            .replace("key Known", "key. Known");
    }
    let types = [
        ("expected f64", "it must be a number"),
        ("expected usize", "it must be a whole number, not negative"),
        ("expected u64", "it must be a whole number, not negative"),
        ("expected a sequence", "it must be a list"),
        ("expected a string", "it must be text in quotes"),
        ("expected a boolean", "it must be true or false"),
    ];
    match types.into_iter().find(|(expected, _)| message.contains(expected)) {
        Some((_, wish)) => format!("{} ({})", wish, message.split(", expected").next().unwrap_or(message)),
        None => message.replace("missing field", "missing key").replace("unknown variant", "unknown value"),
    }
}

/// The most similar of some words, if it is similar.
fn nearest<'a>(word: &str, words: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    words
        .map(|known| (strsim::jaro_winkler(word, known), known))
        .filter(|(similarity, _)| *similarity > 0.75)
        .max_by(|a, b| a.0.total_cmp(&b.0))
        .map(|(_, known)| known)
}
