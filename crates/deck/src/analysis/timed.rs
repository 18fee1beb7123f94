//! A value over the time of a step.

use crate::read::Amplitude;

/// Grows evenly from where it was, or follows an amplitude.
#[derive(Clone, Debug)]
pub(super) struct Timed {
    start: f64,
    target: f64,
    amplitude: Option<Amplitude>,
}

/// Where a step is: its time, how long it takes, and when it began.
#[derive(Clone, Copy, Debug)]
pub(super) struct When {
    pub(super) time: f64,
    pub(super) period: f64,
    pub(super) begun: f64,
}

impl Timed {
    /// From a value to another, or along an amplitude times that other.
    pub(super) fn new(start: f64, target: f64, amplitude: Option<Amplitude>) -> Self {
        Self { start, target, amplitude }
    }

    pub(super) fn at(&self, when: When) -> f64 {
        match &self.amplitude {
            Some(amplitude) if amplitude.is_total => self.target * amplitude.at(when.begun + when.time),
            Some(amplitude) => self.target * amplitude.at(when.time),
            None if when.time >= when.period => self.target,
            None => self.start + (self.target - self.start) * when.time / when.period,
        }
    }

    /// The value in the step after one that ends: what it was, unless an amplitude over all steps goes on.
    pub(super) fn go_on(&mut self, end: When) {
        if !self.amplitude.as_ref().is_some_and(|amplitude| amplitude.is_total) {
            let value = self.at(end);
            *self = Self::new(value, value, None);
        }
    }

    /// The value with which the step begins after one that ends.
    pub(super) fn first(&self, end: When) -> f64 {
        match &self.amplitude {
            Some(amplitude) if amplitude.is_total => self.at(end),
            _ => self.start,
        }
    }

    /// Whether it goes to the same value in the same way, wherever it starts.
    pub(super) fn goes_with(&self, other: &Self) -> bool {
        self.target == other.target && self.amplitude == other.amplitude
    }

    /// Adds to the value that it goes to, in the same way; `false` where that is another amplitude.
    pub(super) fn increase(&mut self, more: f64, amplitude: Option<&Amplitude>) -> bool {
        let is_same = self.amplitude.as_ref() == amplitude;
        self.target += if is_same { more } else { 0.0 };
        is_same
    }

    /// Whether it is not 0 at the end.
    pub(super) fn goes_on(&self) -> bool {
        self.target != 0.0
    }

    /// Whether it is 0 all the time.
    pub(super) fn is_zero(&self) -> bool {
        self.start == 0.0 && self.target == 0.0
    }

    /// Whether it does not change in its step.
    pub(super) fn is_constant(&self) -> bool {
        self.amplitude.is_none() && self.start == self.target
    }

    /// Fades to nothing.
    pub(super) fn fade(&mut self, end: When) {
        *self = Self::new(self.at(end), 0.0, None);
    }

    /// Times of the step at which it bends.
    pub(super) fn bends(&self, begun: f64) -> impl Iterator<Item = f64> + '_ {
        let times = self.amplitude.iter().flat_map(|a| a.times().map(|t| if a.is_total { t - begun } else { t }));
        times.collect::<Vec<f64>>().into_iter()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_grows_evenly_and_stays() {
        let when = |time| When { time, period: 2.0, begun: 0.0 };
        let mut value = Timed::new(1.0, 3.0, None);
        assert_eq!([0.0, 1.0, 2.0].map(|t| value.at(when(t))), [1.0, 2.0, 3.0]);
        value.go_on(when(2.0));
        assert_eq!(value.at(when(0.5)), 3.0);
        value.fade(when(2.0));
        assert_eq!(value.first(when(2.0)), 3.0);
        assert_eq!([0.0, 1.0, 2.0].map(|t| value.at(when(t))), [3.0, 1.5, 0.0]);
    }
}
