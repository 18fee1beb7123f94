//! Why a part of a search ended without an equilibrium.

use super::assembly::Mover;
use crate::Error;

/// Why.
#[derive(Debug)]
pub(crate) enum Trouble {
    /// The contact could not be evaluated.
    Contact(Error),
    /// The host could not do what was asked.
    Host(String),
    /// No part of a load step helps.
    Hopeless(String),
    /// A body that nothing stops.
    Unheld(Unheld, String),
    /// A body that comes to no rest; in smaller parts of a load step it may.
    Adrift(Unheld, String),
    /// Anything else.
    Failed(String),
}

/// A body that contact and the host's supports do not hold.
#[derive(Clone, Debug, PartialEq)]
pub struct Unheld {
    /// Id of the body, as the host gave it.
    pub body: i64,
    /// Unit vector along which it goes; zeros where it turns.
    pub direction: Vec<f64>,
    /// Whether it turns.
    pub is_rotation: bool,
}

impl<const D: usize> From<&Mover<D>> for Unheld {
    fn from(mover: &Mover<D>) -> Self {
        let direction = mover.direction.iter().copied().collect();
        Self { body: mover.id, direction, is_rotation: mover.is_rotation }
    }
}

impl Trouble {
    pub(crate) fn unheld<const D: usize>(mover: &Mover<D>, what: &str) -> Self {
        Trouble::Unheld(mover.into(), format!("{mover}: {what}"))
    }

    pub(crate) fn adrift<const D: usize>(mover: &Mover<D>) -> Self {
        Trouble::Adrift(mover.into(), format!("{mover}: it does not come to rest"))
    }
}

impl Trouble {
    /// With more to be said of it.
    pub(crate) fn and(self, more: &str) -> Self {
        let with = |text: String| format!("{text}; {more}");
        match self {
            Trouble::Contact(_) => self,
            Trouble::Host(text) => Trouble::Host(with(text)),
            Trouble::Hopeless(text) => Trouble::Hopeless(with(text)),
            Trouble::Unheld(unheld, text) => Trouble::Unheld(unheld, with(text)),
            Trouble::Adrift(unheld, text) => Trouble::Adrift(unheld, with(text)),
            Trouble::Failed(text) => Trouble::Failed(with(text)),
        }
    }
}

impl std::fmt::Display for Trouble {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Trouble::Contact(error) => error.fmt(f),
            Trouble::Host(text)
            | Trouble::Unheld(_, text)
            | Trouble::Adrift(_, text)
            | Trouble::Failed(text)
            | Trouble::Hopeless(text) => text.fmt(f),
        }
    }
}

impl From<Error> for Trouble {
    fn from(error: Error) -> Self {
        match error {
            // Not to be tried another way.
            Error::Interrupted => Trouble::Failed(error.to_string()),
            error => Trouble::Contact(error),
        }
    }
}
