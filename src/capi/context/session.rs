//! A mesh in contact, of either dimension.

use super::resident::Resident;

/// Number of nodes, facets and bodies.
pub(crate) struct Counts {
    pub(crate) nodes: usize,
    /// Rows of coordinates: nodes, or unknowns of a basis.
    pub(crate) unknowns: usize,
    pub(crate) facets: usize,
    pub(crate) bodies: usize,
}

/// [`Contact`](crate::Contact) in either dimension.
pub(crate) enum Session {
    Plane(Box<Resident<2>>),
    Space(Box<Resident<3>>),
}

/// What `$work` makes of the contact of a session, in whichever dimension.
macro_rules! in_either {
    ($session:expr, $one:ident => $work:expr) => {
        match $session {
            $crate::capi::context::session::Session::Plane($one) => $work,
            $crate::capi::context::session::Session::Space($one) => $work,
        }
    };
}
pub(crate) use in_either;

impl From<Resident<2>> for Session {
    fn from(one: Resident<2>) -> Self {
        Session::Plane(Box::new(one))
    }
}

impl From<Resident<3>> for Session {
    fn from(one: Resident<3>) -> Self {
        Session::Space(Box::new(one))
    }
}
