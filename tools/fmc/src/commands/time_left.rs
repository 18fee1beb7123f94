//! How long something that is on its way will take yet, as far as can be told.

use std::time::{Duration, Instant};

/// Below these seconds nobody asks.
const SHORT: f64 = 2.0;

/// Load steps, stage after stage.
pub(crate) struct TimeLeft {
    begun: Instant,
    stages: usize,
    done: usize,
    load: f64,
}

impl TimeLeft {
    /// Of a run with so many stages, in each of which the load grows from 0 to 1.
    pub(crate) fn new(stages: usize) -> Self {
        Self { begun: Instant::now(), stages, done: 0, load: 0.0 }
    }

    /// What to put behind the line that tells of an iteration at this load: nothing while it is not known, or short.
    pub(crate) fn behind(&mut self, load: f64) -> String {
        // Less load than before: the next stage, or a load step that was cut.
        if load < self.load - 0.5 && self.done + 1 < self.stages {
            self.done += 1;
        }
        self.load = load;
        left((self.done as f64 + load) / self.stages as f64, self.begun.elapsed())
    }
}

/// By what the part that is done has taken.
fn left(part: f64, elapsed: Duration) -> String {
    let elapsed = elapsed.as_secs_f64();
    let left = elapsed * (1.0 - part) / part;
    if !(0.02..1.0).contains(&part) || elapsed + left < SHORT {
        return String::new();
    }
    if left < 100.0 { format!("  some {left:.0} s left") } else { format!("  some {:.0} min left", left / 60.0) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_left_grows_with_what_was_taken() {
        assert_eq!(left(0.25, Duration::from_secs(10)), "  some 30 s left");
        assert_eq!(left(0.5, Duration::from_secs(600)), "  some 10 min left");
        for (part, seconds) in [(0.0, 10), (1.0, 10), (0.01, 1000), (0.75, 1)] {
            assert_eq!(left(part, Duration::from_secs(seconds)), "", "{part}");
        }
    }

    #[test]
    fn stages_follow_one_another() {
        let mut time = TimeLeft { begun: Instant::now() - Duration::from_secs(100), stages: 2, done: 0, load: 0.0 };
        assert_eq!(time.behind(0.5), "  some 5 min left");
        assert_eq!(time.behind(1.0), "  some 2 min left");
        assert_eq!(time.behind(0.1), "  some 82 s left");
        assert_eq!(time.done, 1);
    }
}
