//! What `fmc force` is at, on a terminal, once it has taken long enough for somebody to ask.

use anyhow::Result;
use indicatif::{ProgressBar, ProgressState, ProgressStyle};
use std::fmt::Write;
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

/// Before that nobody asks.
const SHORT: Duration = Duration::from_secs(2);

/// Stages one after another, none of which says how far it is. What shows them is gone when this is.
pub(super) struct Stages {
    bar: ProgressBar,
    now: Arc<Mutex<String>>,
}

impl Stages {
    /// So many, none of them begun.
    pub(super) fn new(count: u64) -> Result<Self> {
        let now = Arc::<Mutex<String>>::default();
        let shown = Arc::clone(&now);
        let show = move |state: &ProgressState, to: &mut dyn Write| {
            let what = shown.lock().unwrap_or_else(PoisonError::into_inner);
            let _ = to.write_str(&line(state.pos(), count, &what, state.elapsed()));
        };
        // Draws on standard error, and only if that is a terminal.
        let bar = ProgressBar::new(count).with_style(ProgressStyle::with_template("{stage}")?.with_key("stage", show));
        bar.enable_steady_tick(Duration::from_millis(200));
        Ok(Self { bar, now })
    }

    /// The next one.
    pub(super) fn begin(&self, what: impl Into<String>) {
        *self.now.lock().unwrap_or_else(PoisonError::into_inner) = what.into();
        self.bar.inc(1);
    }
}

impl Drop for Stages {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

fn line(stage: u64, count: u64, what: &str, elapsed: Duration) -> String {
    if elapsed < SHORT {
        return String::new();
    }
    format!("{stage}/{count} {what}, {} s so far", elapsed.as_secs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn who_waits_for_two_seconds_is_told() {
        assert_eq!(line(2, 6, "finding the bodies", Duration::from_millis(1999)), "");
        assert_eq!(line(3, 6, "evaluating", Duration::from_millis(12_900)), "3/6 evaluating, 12 s so far");
    }

    #[test]
    fn stages_are_counted() {
        let stages = Stages::new(2).expect("a template");
        stages.begin("reading");
        stages.begin("evaluating");
        assert_eq!((stages.bar.position(), stages.now.lock().expect("no panic").as_str()), (2, "evaluating"));
    }
}
