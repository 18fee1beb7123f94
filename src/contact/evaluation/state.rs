//! What a contact keeps from one evaluation to the next: nothing that any result depends on.

use crate::configuration::Configuration;
use crate::contact::laws::FoundPatches;
use crate::contact::partners::Placed;
use std::sync::{Mutex, PoisonError};

/// The bodies and the obstacles where they were evaluated last.
pub(crate) struct State<const D: usize> {
    pub(crate) configuration: Configuration<D>,
    /// Obstacles that are bounded by facets.
    pub(crate) placed: Vec<Option<Placed<D>>>,
    pub(crate) found: FoundPatches<D>,
}

/// That of the last evaluation, while no other has taken it.
pub(crate) struct LastState<const D: usize>(Mutex<Option<Box<State<D>>>>);

impl<const D: usize> LastState<D> {
    pub(crate) fn new() -> Self {
        Self(Mutex::new(None))
    }

    /// Takes it; concurrent evaluations find nothing and start afresh, with the same result.
    pub(crate) fn take(&self) -> Box<State<D>> {
        let last = self.0.lock().unwrap_or_else(PoisonError::into_inner).take();
        last.unwrap_or_else(|| {
            let (configuration, placed) = (Configuration::new(), Vec::new());
            Box::new(State { configuration, placed, found: FoundPatches::default() })
        })
    }

    pub(crate) fn put(&self, state: Box<State<D>>) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Some(state);
    }

    /// Forgets what was found at the last coordinates, after a change of the options or of an obstacle.
    pub(crate) fn forget_found(&mut self) {
        if let Some(state) = self.0.get_mut().unwrap_or_else(PoisonError::into_inner) {
            state.found = FoundPatches::default();
        }
    }

    /// Forgets all, since other cells are taken.
    pub(crate) fn forget(&mut self) {
        *self.0.get_mut().unwrap_or_else(PoisonError::into_inner) = None;
    }
}
