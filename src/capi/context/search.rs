//! A search for an equilibrium, of either dimension.

use super::session::Session;
use crate::Error;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::index::IndexSize;
use crate::capi::structs::equilibrium::{
    fmc_equilibrium_problem, fmc_equilibrium_request, fmc_equilibrium_request_kind,
};
use crate::capi::structs::equilibrium_result::fmc_equilibrium_result;
use crate::contact::Contact;
use crate::contact::equilibrium::{Answer, DriverOptions, Equilibrium, Next, Request};

/// [`Equilibrium`] in either dimension.
pub(crate) enum Search {
    Plane(Box<Equilibrium<2>>),
    Space(Box<Equilibrium<3>>),
}

macro_rules! of_either {
    ($search:expr, $one:ident => $work:expr) => {
        match $search {
            Search::Plane($one) => $work,
            Search::Space($one) => $work,
        }
    };
}

impl Search {
    /// A search on a contact.
    ///
    /// # Safety
    /// The host guarantees the arrays of the problem.
    pub(crate) unsafe fn new(
        session: &mut Session,
        problem: &fmc_equilibrium_problem,
        options: DriverOptions,
        size: IndexSize,
        index_base: i32,
    ) -> Result<Self, Failure> {
        // SAFETY: passed on to the caller.
        unsafe {
            match session {
                Session::Plane(one) => made(one.contact_mut()?, problem, options, size, index_base).map(Search::Plane),
                Session::Space(one) => made(one.contact_mut()?, problem, options, size, index_base).map(Search::Space),
            }
        }
    }

    /// Goes on with an answer, on the contact that it was made for.
    pub(crate) fn next(&mut self, session: &mut Session, answer: Option<Answer>) -> Result<(), Failure> {
        match (self, session) {
            (Search::Plane(search), Session::Plane(one)) => search.next(one.contact_mut()?, answer).map(drop)?,
            (Search::Space(search), Session::Space(one)) => search.next(one.contact_mut()?, answer).map(drop)?,
            _ => return Err(of_another_dimension()),
        }
        Ok(())
    }

    /// Gives it up, on the same contact.
    pub(crate) fn abandon(&mut self, session: &mut Session) -> Result<(), Failure> {
        match (self, session) {
            (Search::Plane(search), Session::Plane(one)) => search.abandon(one.contact_mut()?),
            (Search::Space(search), Session::Space(one)) => search.abandon(one.contact_mut()?),
            _ => return Err(of_another_dimension()),
        }
        Ok(())
    }

    /// What was asked for last, while the search goes on.
    pub(crate) fn asked(&self) -> Option<&Request> {
        of_either!(self, one => match one.now() {
            Some(Next::Asked(request)) => Some(request),
            _ => None,
        })
    }

    /// The same for the host, or how the search has ended.
    pub(crate) fn request(&self) -> fmc_equilibrium_request {
        let ended =
            |kind: fmc_equilibrium_request_kind| fmc_equilibrium_request { kind: kind as i32, ..Default::default() };
        of_either!(self, one => match one.now() {
            Some(Next::Asked(request)) => request.into(),
            Some(Next::Found(_)) => ended(fmc_equilibrium_request_kind::FMC_REQUEST_FOUND),
            Some(Next::Refused(_)) | None => ended(fmc_equilibrium_request_kind::FMC_REQUEST_REFUSED),
        })
    }

    /// How it has ended, and what is said of it; `None` while it goes on.
    pub(crate) fn result(&self) -> Option<(fmc_equilibrium_result, Vec<String>)> {
        of_either!(self, one => match one.now()? {
            Next::Asked(_) => None,
            Next::Found(found) => Some((found.into(), found.warnings.clone())),
            Next::Refused(refusal) => Some((refusal.into(), vec![refusal.text.clone()])),
        })
    }
}

fn of_another_dimension() -> Failure {
    Error::Unsupported { what: "an equilibrium on a context of another dimension" }.into()
}

/// # Safety
/// The host guarantees the arrays of the problem.
unsafe fn made<const D: usize>(
    contact: &Contact<D>,
    problem: &fmc_equilibrium_problem,
    options: DriverOptions,
    size: IndexSize,
    index_base: i32,
) -> Result<Box<Equilibrium<D>>, Failure> {
    // SAFETY: passed on to the caller.
    let (unknowns, x, prescribed) = unsafe { problem.read::<D>(size, index_base) }?;
    Ok(Box::new(Equilibrium::new(contact, unknowns, &x, prescribed.as_deref(), options)?))
}
