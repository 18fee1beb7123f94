//! How jobs are carried out.

use super::job::Size;
use indicatif::ProgressBar;
use std::sync::atomic::AtomicBool;
use std::time::Duration;

/// How jobs are carried out.
pub struct Setting<'a> {
    /// How much is run.
    pub size: Size,
    /// Threads; nothing but the seconds depends on them.
    pub threads: usize,
    /// Time after which a run is left out.
    pub limit: Option<Duration>,
    /// Where progress is shown.
    pub bar: &'a ProgressBar,
    /// Set when the user wants to stop.
    pub stop: &'a AtomicBool,
}
