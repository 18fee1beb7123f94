//! Files quoted in messages.

/// The start of a text that may be long.
pub(crate) fn shortened(text: &str) -> String {
    if text.chars().count() <= 40 { text.into() } else { text.chars().take(40).chain("…".chars()).collect() }
}
