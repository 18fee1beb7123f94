//! What is taken in another sense than a file may mean.

/// Something that is taken in another sense than the file may mean.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Note {
    /// Its line.
    pub line: usize,
    /// A sentence.
    pub message: String,
}

impl Note {
    pub(super) fn new(line: usize, message: impl Into<String>) -> Self {
        Self { line, message: message.into() }
    }
}
