//! What the table of the contact must fulfil.

use super::Check;
use crate::case::{Key, LawName};

impl Check<'_> {
    pub(super) fn contact(&mut self) {
        let (key, contact) = (Key::parse("contact"), &self.case.contact);
        self.positive(&key.then("stiffness"), contact.stiffness);
        if !(contact.exponent.is_finite() && contact.exponent >= 1.0) {
            self.flaw(&key.then("exponent"), format!("it must be at least 1, not {}", contact.exponent));
        }
        self.maybe_positive(&key.then("smoothing_length"), contact.smoothing_length);
        if (contact.law == LawName::FiberLinear) != contact.smoothing_length.is_some() {
            self.flaw(&key.then("smoothing_length"), "it belongs to the law \"fiber-linear\", and to it alone".into());
        }
        self.friction(&key);
        self.maybe_positive(&key.then("spacing"), contact.spacing);
        self.maybe_positive(&key.then("fiber_length"), contact.fiber_length);
        if contact.fibers == Some(0) {
            self.flaw(&key.then("fibers"), "it must be at least 1".into());
        }
        if contact.fibers.is_some() && contact.spacing.is_some() {
            self.flaw(&key.then("spacing"), "it cannot go together with fibers".into());
        }
    }

    fn friction(&mut self, key: &Key) {
        let contact = &self.case.contact;
        for (name, value) in [("friction_coefficient", contact.friction_coefficient), ("cohesion", contact.cohesion)] {
            if !(value.is_finite() && value >= 0.0) {
                self.flaw(&key.then(name), format!("it must be at least 0, not {value}"));
            }
        }
        self.maybe_positive(&key.then("friction_stiffness"), contact.friction_stiffness);
        self.maybe_positive(&key.then("shear_limit"), contact.shear_limit);
        if !contact.has_friction() {
            return;
        }
        if contact.linearised {
            self.flaw(&key.then("friction_coefficient"), "linearised contact knows no friction".into());
        }
        if contact.law == LawName::Volume && contact.friction_stiffness.is_none() {
            let message = "the law \"volume\" has no stiffness by penetration: friction needs one of its own";
            self.flaw(&key.then("friction_stiffness"), message.into());
        }
    }
}
