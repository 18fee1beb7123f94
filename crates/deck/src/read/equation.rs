//! `*EQUATION`: linear constraints of displacements.

use super::scope::Scope;
use super::words::{only, required};
use crate::Fault;
use fmc_mesh_io::inp::{Keyword, Lines, fields};

/// Σ a u = 0, of single nodes, or of the nodes of sets one by one.
#[derive(Clone, Debug)]
pub(crate) struct EquationRow {
    pub(crate) line: usize,
    pub(crate) scope: Scope,
    pub(crate) terms: Vec<Term>,
}

/// A displacement along an axis with its factor.
#[derive(Clone, Debug)]
pub(crate) struct Term {
    pub(crate) line: usize,
    /// A label or a set.
    pub(crate) set: String,
    /// From 0.
    pub(crate) axis: usize,
    pub(crate) factor: f64,
}

impl EquationRow {
    /// Reads `*EQUATION`: a number of terms, and as many times a node or set, a degree of freedom and a factor; again and again.
    pub(super) fn read(keyword: &Keyword, scope: &Scope, lines: &mut Lines) -> Result<Vec<Self>, Fault> {
        only(keyword, &[])?;
        let mut rows = Vec::new();
        while let Some((line, text)) = lines.data() {
            let entries: Vec<&str> = fields(text).filter(|field| !field.is_empty()).collect();
            let count = match entries[..] {
                [count] => count.parse::<usize>().ok().filter(|count| *count > 0),
                _ => None,
            };
            let Some(count) = count else {
                return Err(Fault::new(line, format!("expected the number of terms of an equation, found '{text}'")));
            };
            let mut terms = Vec::new();
            while terms.len() < count {
                let Some((line, text)) = lines.data() else {
                    let message = format!("this equation has {count} terms, and {} are there", terms.len());
                    return Err(Fault::new(line, message));
                };
                terms.extend(terms_of(line, text)?);
            }
            if terms.len() > count {
                let message = format!("the equation of line {line} has {count} terms, and more are there");
                return Err(Fault::new(terms[count].line, message));
            }
            rows.push(Self { line, scope: scope.clone(), terms });
        }
        match rows.is_empty() {
            true => Err(Fault::new(keyword.line, "*EQUATION has no equation")),
            false => Ok(rows),
        }
    }
}

fn terms_of(line: usize, text: &str) -> Result<Vec<Term>, Fault> {
    let mut entries: Vec<&str> = fields(text).collect();
    if entries.last().is_some_and(|last| last.is_empty()) {
        entries.pop();
    }
    let (triples, rest) = entries.as_chunks::<3>();
    if !rest.is_empty() {
        return Err(Fault::new(line, "expected a node or set, a degree of freedom and a factor for each term"));
    }
    let term = |[set, axis, _]: &[&str; 3], place: usize| {
        let Ok(axis @ 1..=3) = axis.parse::<usize>() else {
            return Err(Fault::new(line, format!("degree of freedom {axis} of *EQUATION is not known, only 1 to 3")));
        };
        let factor = required(line, &entries, place, "the factor")?;
        Ok(Term { line, set: set.trim_matches('"').to_owned(), axis: axis - 1, factor })
    };
    triples.iter().enumerate().map(|(k, triple)| term(triple, 3 * k + 3)).collect()
}
