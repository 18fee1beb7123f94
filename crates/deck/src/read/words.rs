//! Parameters and numbers of a keyword.

use crate::Fault;
use fmc_mesh_io::inp::{Keyword, Lines, fields, number};

/// A keyword has no parameters but these.
pub(super) fn only(keyword: &Keyword, known: &[&str]) -> Result<(), Fault> {
    for (name, value) in &keyword.parameters {
        if name.is_empty() && value.is_empty() {
            continue;
        }
        if !known.contains(&name.as_str()) {
            let message = match known {
                [] => format!("*{}, {name} is not known; it has no parameters here", keyword.name),
                _ => format!("*{}, {name} is not known; known are {}", keyword.name, known.join(", ")),
            };
            return Err(Fault::new(keyword.line, message));
        }
    }
    Ok(())
}

/// A parameter has one of these values, in upper case, if it is there.
pub(super) fn one_of(keyword: &Keyword, name: &str, values: &[&str]) -> Result<(), Fault> {
    match keyword.value(name) {
        Some(value) if !values.contains(&value.to_uppercase().as_str()) => {
            let known = values.join(", ");
            Err(Fault::new(keyword.line, format!("*{}, {name}={value} is not known; known are {known}", keyword.name)))
        }
        _ => Ok(()),
    }
}

/// The numbers of a data line; a field that is empty is none.
pub(super) fn numbers(line: usize, text: &str) -> Result<Vec<Option<f64>>, Fault> {
    let of = |(place, field)| finite(line, place, field);
    (1..).zip(fields(text)).map(of).collect()
}

/// The number in field `place` of a data line, from 1; none if it is empty.
fn finite(line: usize, place: usize, field: &str) -> Result<Option<f64>, Fault> {
    if field.is_empty() {
        return Ok(None);
    }
    number(line, field).map(Some).map_err(|error| {
        let Fault { line, message } = error.into();
        Fault::new(line, format!("{message} in field {place}"))
    })
}

/// The number in field `place` of a data line, from 1; `what` says what is there.
pub(super) fn required(line: usize, entries: &[&str], place: usize, what: &str) -> Result<f64, Fault> {
    let field = entries.get(place - 1).copied().unwrap_or_default();
    finite(line, place, field)?.ok_or_else(|| Fault::new(line, format!("{what} is missing in field {place}")))
}

/// The number in field `place` of numbers that were read, from 1; `what` says what is there.
pub(super) fn present(line: usize, found: &[Option<f64>], place: usize, what: &str) -> Result<f64, Fault> {
    let value = found.get(place - 1).copied().flatten();
    value.ok_or_else(|| Fault::new(line, format!("{what} is missing in field {place}")))
}

/// A parameter of this keyword is a number above or equal to 0, if it is there.
pub(super) fn length(keyword: &Keyword, name: &str) -> Result<Option<f64>, Fault> {
    let Some(text) = keyword.value(name) else { return Ok(None) };
    match number(keyword.line, text) {
        Ok(value) if value >= 0.0 && !text.is_empty() => Ok(Some(value)),
        _ => Err(Fault::new(keyword.line, format!("*{}, {name}={text} is not a length", keyword.name))),
    }
}

/// The only data line of a keyword, with its line.
pub(super) fn only_line(keyword: &Keyword, lines: &mut Lines, what: &str) -> Result<(usize, Vec<Option<f64>>), Fault> {
    let Some((line, text)) = lines.data() else {
        return Err(Fault::new(keyword.line, format!("*{} has no data line with {what}", keyword.name)));
    };
    let found = numbers(line, text)?;
    no_more(keyword, lines)?;
    Ok((line, found))
}

/// The only data line that a keyword may have, with its line; without one no numbers.
pub(super) fn optional_line(keyword: &Keyword, lines: &mut Lines) -> Result<(usize, Vec<Option<f64>>), Fault> {
    let Some((line, text)) = lines.data() else { return Ok((keyword.line, Vec::new())) };
    let found = numbers(line, text)?;
    no_more(keyword, lines)?;
    Ok((line, found))
}

/// There is no further data line.
pub(super) fn no_more(keyword: &Keyword, lines: &mut Lines) -> Result<(), Fault> {
    match lines.data() {
        Some((line, _)) => Err(Fault::new(line, format!("*{} has a data line more than is known", keyword.name))),
        None => Ok(()),
    }
}

/// Nothing but zeros stands behind the first numbers.
pub(super) fn at_most(keyword: &Keyword, found: &[Option<f64>], count: usize, why: &str) -> Result<(), Fault> {
    match found.iter().skip(count).flatten().any(|value| *value != 0.0) {
        true => Err(Fault::new(keyword.line, format!("*{}: {why}", keyword.name))),
        false => Ok(()),
    }
}
