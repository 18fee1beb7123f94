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
    let of = |field: &str| if field.is_empty() { Ok(None) } else { number(line, field).map(Some) };
    Ok(fields(text).map(of).collect::<anyhow::Result<_>>()?)
}

/// The only data line of a keyword, as numbers.
pub(super) fn only_line(keyword: &Keyword, lines: &mut Lines, what: &str) -> Result<Vec<Option<f64>>, Fault> {
    let Some((line, text)) = lines.data() else {
        return Err(Fault::new(keyword.line, format!("*{} has no data line with {what}", keyword.name)));
    };
    let found = numbers(line, text)?;
    no_more(keyword, lines)?;
    Ok(found)
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
