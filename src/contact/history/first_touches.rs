//! Where pairs first touched in a step.

use crate::contact::friction::Step;
use crate::overlap::Partner;
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Places of first touch, as steps that begin there.
#[derive(Clone)]
pub(crate) struct FirstTouches<const D: usize> {
    /// Of pairs that touch there.
    of_pairs: BTreeMap<[Partner; 2], Arc<Step<D>>>,
    /// That of the first pair, at which all others are apart.
    of_all: Option<Arc<Step<D>>>,
}

impl<const D: usize> Default for FirstTouches<D> {
    fn default() -> Self {
        Self { of_pairs: BTreeMap::new(), of_all: None }
    }
}

impl<const D: usize> FirstTouches<D> {
    /// The last place known of a pair at which it was still apart.
    pub(crate) fn of(&self, pair: &[Partner; 2]) -> Option<&Step<D>> {
        self.of_pairs.get(pair).or(self.of_all.as_ref()).map(|step| &**step)
    }

    /// Whether it is known where a pair touches.
    pub(crate) fn is_known(&self, pair: &[Partner; 2]) -> bool {
        self.of_pairs.contains_key(pair)
    }

    pub(crate) fn are_none(&self) -> bool {
        self.of_pairs.is_empty() && self.of_all.is_none()
    }

    /// Pairs count from here that were apart; all others too, where this is the first place of all.
    pub(crate) fn add(&mut self, pairs: &BTreeSet<[Partner; 2]>, step: Step<D>, is_first: bool) {
        let step = Arc::new(step);
        pairs.iter().for_each(|pair| drop(self.of_pairs.insert(*pair, Arc::clone(&step))));
        if is_first {
            self.of_all = Some(step);
        }
    }

    /// Forgets an obstacle that is removed.
    pub(crate) fn forget(&mut self, partner: Partner) {
        self.of_pairs.retain(|partners, _| !partners.contains(&partner));
    }

    /// All of them.
    pub(crate) fn steps_mut(&mut self) -> impl Iterator<Item = &mut Step<D>> {
        self.of_pairs.values_mut().chain(&mut self.of_all).map(Arc::make_mut)
    }
}
