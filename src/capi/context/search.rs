//! A search for an equilibrium, with its dimension hidden.

use crate::Error;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::index::IndexSize;
use crate::capi::structs::equilibrium::{
    fmc_equilibrium_problem, fmc_equilibrium_request, fmc_equilibrium_request_kind,
};
use crate::capi::structs::equilibrium_result::fmc_equilibrium_result;
use crate::contact::Contact;
use crate::contact::equilibrium::{Answer, DriverOptions, Equilibrium, Next, Request};
use std::any::Any;

/// [`Equilibrium`] in either dimension.
pub(crate) trait Search: Send {
    /// Goes on with an answer, on the contact that it was made for.
    fn next(&mut self, contact: &mut dyn Any, answer: Option<Answer>) -> Result<(), Error>;

    /// What was asked for last, while the search goes on.
    fn asked(&self) -> Option<&Request>;

    /// The same for the host, or how the search has ended.
    fn request(&self) -> fmc_equilibrium_request;

    /// How it has ended, and what is said of it; `None` while it goes on.
    fn result(&self) -> Option<(fmc_equilibrium_result, Vec<String>)>;
}

/// A search on a contact.
///
/// # Safety
/// The host guarantees the arrays of the problem.
pub(crate) unsafe fn search(
    contact: &dyn Any,
    problem: &fmc_equilibrium_problem,
    options: DriverOptions,
    size: IndexSize,
    index_base: i32,
) -> Result<Box<dyn Search>, Failure> {
    // SAFETY: passed on to the caller.
    match (contact.downcast_ref::<Contact<2>>(), contact.downcast_ref::<Contact<3>>()) {
        (Some(contact), _) => unsafe { new(contact, problem, options, size, index_base) },
        (_, Some(contact)) => unsafe { new(contact, problem, options, size, index_base) },
        _ => Err(Error::Unsupported { what: "an equilibrium on a context of this dimension" }.into()),
    }
}

unsafe fn new<const D: usize>(
    contact: &Contact<D>,
    problem: &fmc_equilibrium_problem,
    options: DriverOptions,
    size: IndexSize,
    index_base: i32,
) -> Result<Box<dyn Search>, Failure> {
    // SAFETY: passed on to the caller.
    let (unknowns, x, prescribed) = unsafe { problem.read::<D>(size, index_base) }?;
    Ok(Box::new(Equilibrium::new(contact, unknowns, &x, prescribed.as_deref(), options)?))
}

impl<const D: usize> Search for Equilibrium<D> {
    fn next(&mut self, contact: &mut dyn Any, answer: Option<Answer>) -> Result<(), Error> {
        let what = "an equilibrium on a context of another dimension";
        let contact = contact.downcast_mut::<Contact<D>>().ok_or(Error::Unsupported { what })?;
        Equilibrium::next(self, contact, answer).map(drop)
    }

    fn asked(&self) -> Option<&Request> {
        match self.now() {
            Some(Next::Asked(request)) => Some(request),
            _ => None,
        }
    }

    fn request(&self) -> fmc_equilibrium_request {
        let ended =
            |kind: fmc_equilibrium_request_kind| fmc_equilibrium_request { kind: kind as i32, ..Default::default() };
        match self.now() {
            Some(Next::Asked(request)) => request.into(),
            Some(Next::Found(_)) => ended(fmc_equilibrium_request_kind::FMC_REQUEST_FOUND),
            Some(Next::Refused(_)) | None => ended(fmc_equilibrium_request_kind::FMC_REQUEST_REFUSED),
        }
    }

    fn result(&self) -> Option<(fmc_equilibrium_result, Vec<String>)> {
        match self.now()? {
            Next::Asked(_) => None,
            Next::Found(found) => Some((found.into(), found.warnings.clone())),
            Next::Refused(refusal) => Some((refusal.into(), vec![refusal.text.clone()])),
        }
    }
}
