//! How bodies follow what contact moves.

use fmc_contact::sparse::{Condensed, Factorisation};

/// How all equations follow those that are kept.
pub(super) struct Follower<'a> {
    factors: &'a Factorisation,
    pub(super) condensed: Condensed,
    /// What is kept where all of the bodies have followed it last, and the step on all equations there.
    at: Vec<f64>,
    pub(super) followed: Vec<f64>,
    /// Whether all have, and not what is near alone.
    is_whole: bool,
    /// How far what is kept may move before all follow.
    hardly: f64,
}

impl<'a> Follower<'a> {
    pub(super) fn new(factors: &'a Factorisation, right: &[f64], count: usize, hardly: f64) -> Option<Self> {
        let (condensed, at, followed) = (factors.condense(right)?, vec![0.0; count], vec![0.0; right.len()]);
        let mut new = Self { factors, condensed, at, followed, is_whole: false, hardly };
        let zeros = new.at.clone();
        let near = new.partly(&zeros)?;
        if near.iter().all(|step| step.abs() <= hardly) {
            new.followed = near;
        } else {
            new.all(&zeros)?;
        }
        Some(new)
    }

    /// The step on all equations.
    pub(super) fn all(&mut self, kept: &[f64]) -> Option<&[f64]> {
        if !self.is_whole || self.at != kept {
            self.followed = self.factors.follow(self.condensed.inner.iter().copied(), kept)?;
            (self.at, self.is_whole) = (kept.to_vec(), true);
        }
        Some(&self.followed)
    }

    /// The same with what is far away where it was, at a part of the cost.
    fn partly(&self, kept: &[f64]) -> Option<Vec<f64>> {
        let mut step = self.followed.clone();
        self.factors.follow_near(self.condensed.inner.iter().copied(), kept, &mut step)?;
        Some(step)
    }

    /// The step as far as contact can tell: all follow where what is kept has moved since they did.
    pub(super) fn near(&mut self, kept: &[f64]) -> Option<Vec<f64>> {
        let most = self.at.iter().zip(kept).map(|(at, kept)| (at - kept).abs()).fold(0.0, f64::max);
        if most <= self.hardly { self.partly(kept) } else { self.all(kept).map(<[f64]>::to_vec) }
    }
}
