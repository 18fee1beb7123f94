//! What a search changes of a contact, as it was before: for whatever leads nowhere.

use crate::contact::changes::friction_steps::take_up;
use crate::contact::equilibrium::augmentation::AllMultipliers;
use crate::contact::evaluation::Contact;
use crate::contact::history::{Begun, FirstTouches};
use std::sync::{Arc, Mutex, PoisonError};

/// The step that has begun and the multipliers, with the stiffness that they belong to.
pub(crate) struct Before<const D: usize> {
    begun: Begun<D>,
    multipliers: AllMultipliers<D>,
    stiffened: f64,
}

impl<const D: usize> Before<D> {
    pub(crate) fn of(contact: &Contact<D>) -> Self {
        let (begun, stiffened) = (contact.history.begun(), contact.history.stiffened);
        Self { begun, multipliers: contact.all_multipliers(), stiffened }
    }

    /// The same with the places of first touch that are known now.
    pub(crate) fn with_first_touches(self, contact: &Contact<D>) -> Self {
        Self { begun: self.begun.with_first_touches(contact.history.first_touches.clone()), ..self }
    }

    /// The same without any.
    pub(crate) fn without_first_touches(self) -> Self {
        Self { begun: self.begun.with_first_touches(FirstTouches::default()), ..self }
    }

    /// Goes on from there. Friction is neither frozen nor softer.
    pub(crate) fn put_back(self, contact: &mut Contact<D>) {
        contact.history.apart_at = None;
        contact.history.let_apart.clear();
        if contact.history.stiffened != self.stiffened {
            // The factor was accepted the other way.
            let _ = contact.stiffen(self.stiffened / contact.history.stiffened);
        }
        contact.put_back_multipliers(self.multipliers);
        take_up(contact, self.begun);
    }
}

/// The same for a whole search: found by the search, and taken by whoever ends it.
#[derive(Clone)]
pub(crate) struct Kept<const D: usize>(Arc<Mutex<Option<Before<D>>>>);

impl<const D: usize> Kept<D> {
    pub(crate) fn nothing() -> Self {
        Self(Arc::default())
    }

    pub(crate) fn keep(&self, before: Before<D>) {
        *self.0.lock().unwrap_or_else(PoisonError::into_inner) = Some(before);
    }

    pub(crate) fn take(&self) -> Option<Before<D>> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner).take()
    }
}
