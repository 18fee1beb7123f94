//! What is wrong with a file, and where.

use std::fmt;

/// An error in a line of the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fault {
    /// The line, of the text with all included files in their places; from 1.
    pub line: usize,
    /// A sentence.
    pub message: String,
}

impl Fault {
    /// An error in a line.
    pub fn new(line: usize, message: impl Into<String>) -> Self {
        Self { line, message: message.into() }
    }
}

impl fmt::Display for Fault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "line {}: {}", self.line, self.message)
    }
}

impl std::error::Error for Fault {}

/// Errors of the mesh reader begin with their line.
impl From<anyhow::Error> for Fault {
    fn from(error: anyhow::Error) -> Self {
        let text = format!("{error:#}");
        let rest = text.strip_prefix("line ").and_then(|rest| rest.split_once(": "));
        match rest.and_then(|(line, message)| Some((line.parse().ok()?, message))) {
            Some((line, message)) => Self::new(line, message),
            None => Self::new(1, text),
        }
    }
}
