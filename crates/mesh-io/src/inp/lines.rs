//! Lines of an input file: keyword lines with their parameters, data lines with their fields.

use crate::excerpt::shortened;
use anyhow::{Result, bail};

/// A keyword line, with those that continue it.
pub struct Keyword {
    /// Without the asterisk, in upper case, single blanks between words.
    pub name: String,
    /// Where it stands in the file.
    pub line: usize,
    /// Names in upper case, and what follows the equals sign.
    pub parameters: Vec<(String, String)>,
}

impl Keyword {
    /// The value of a parameter; empty where it has none.
    pub fn value(&self, name: &str) -> Option<&str> {
        self.parameters.iter().find(|(known, _)| known == name).map(|(_, value)| value.as_str())
    }

    /// The value of a parameter that must have one.
    ///
    /// # Errors
    /// If it has none.
    pub fn required(&self, name: &str) -> Result<&str> {
        match self.value(name) {
            Some(value) if !value.is_empty() => Ok(value),
            _ => bail!("line {}: *{} has no {name}=", self.line, self.name),
        }
    }
}

/// A file, line by line. Blank lines and comments are left out.
pub struct Lines<'a> {
    rest: std::str::Lines<'a>,
    number: usize,
    next: Option<(usize, &'a str)>,
}

impl<'a> Lines<'a> {
    /// From the start of a text.
    pub fn new(text: &'a str) -> Self {
        let mut lines = Self { rest: text.lines(), number: 0, next: None };
        lines.advance();
        lines
    }

    fn advance(&mut self) {
        self.next = None;
        for line in self.rest.by_ref() {
            self.number += 1;
            let line = line.trim();
            if !line.is_empty() && !line.starts_with("**") {
                self.next = Some((self.number, line));
                break;
            }
        }
    }

    /// The next data line, unless a keyword comes first.
    pub fn data(&mut self) -> Option<(usize, &'a str)> {
        let (number, line) = self.next.filter(|(_, line)| !line.starts_with('*'))?;
        self.advance();
        Some((number, line))
    }

    /// The next keyword, past all data before it.
    pub fn keyword(&mut self) -> Option<Keyword> {
        while self.data().is_some() {}
        let (line, first) = self.next?;
        let mut text = first[1..].to_owned();
        self.advance();
        // A comma at the end goes on in the next line.
        while text.ends_with(',') {
            let Some((_, more)) = self.data() else { break };
            text.push_str(more);
        }
        let mut words = outside_quotes(&text).into_iter();
        let name = spaced(words.next().unwrap_or_default());
        let parameters = words.map(|word| {
            let (name, value) = word.split_once('=').unwrap_or((word, ""));
            (spaced(name), value.trim().trim_matches('"').to_owned())
        });
        Some(Keyword { name, line, parameters: parameters.collect() })
    }
}

/// The fields of a data line; a comma at its end opens no further one.
pub fn fields(line: &str) -> impl Iterator<Item = &str> {
    line.strip_suffix(',').unwrap_or(line).split(',').map(str::trim)
}

/// A number that counts: a label, or a distance between labels.
///
/// # Errors
/// If it is none above 0.
pub fn label(line: usize, field: &str) -> Result<u64> {
    match field.parse() {
        Ok(number) if number > 0 => Ok(number),
        _ => bail!("line {line}: expected a whole number above 0, found '{}'", shortened(field)),
    }
}

/// A floating point number, its exponent marked as in Fortran too; nothing at all is 0.
///
/// # Errors
/// If it is none, or not finite.
pub fn number(line: usize, field: &str) -> Result<f64> {
    if field.is_empty() {
        return Ok(0.0);
    }
    let marked = field.contains(['d', 'D']).then(|| field.replace(['d', 'D'], "e"));
    match marked.as_deref().unwrap_or(field).parse() {
        Ok(number) if f64::is_finite(number) => Ok(number),
        Ok(_) => bail!("line {line}: expected a finite number, found '{}'", shortened(field)),
        Err(_) => bail!("line {line}: expected a number, found '{}'", shortened(field)),
    }
}

fn spaced(words: &str) -> String {
    words.split_whitespace().collect::<Vec<_>>().join(" ").to_uppercase()
}

/// What stands between commas; those in quotes are part of a name.
fn outside_quotes(text: &str) -> Vec<&str> {
    let mut quoted = false;
    let separates = |c: char| {
        quoted ^= c == '"';
        c == ',' && !quoted
    };
    text.split(separates).collect()
}
