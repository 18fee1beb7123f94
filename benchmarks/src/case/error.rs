//! What is wrong with a case.

use super::Key;
use std::fmt;

/// Why a case cannot be used: everything that was found wrong, with its place.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CaseError {
    /// All problems, at least one.
    pub problems: Vec<Problem>,
}

/// One thing that is wrong.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// Where: `file:line`, `file`, or the option that put the value there.
    pub place: String,
    /// The key, unless there is none to blame.
    pub key: Option<Key>,
    /// What is wrong, and what would be right.
    pub message: String,
}

impl fmt::Display for Problem {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.key {
            Some(key) if !key.0.is_empty() => write!(f, "{}: {key}: {}", self.place, self.message),
            _ => write!(f, "{}: {}", self.place, self.message),
        }
    }
}

impl fmt::Display for CaseError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let problems: Vec<String> = self.problems.iter().map(Problem::to_string).collect();
        write!(f, "{}", problems.join("\n       "))
    }
}

impl std::error::Error for CaseError {}
