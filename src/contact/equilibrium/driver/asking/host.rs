//! The host as the search asks it, and what was asked so far.

use super::conversation::Asking;
use super::request::{Answer, Request};
use super::trouble::Trouble;
use super::unknowns::{Unknowns, dot};
use crate::contact::evaluation::Contact;
use crate::contact::tangents::TangentPart;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};
use std::sync::{Mutex, PoisonError};

/// A host.
pub(crate) struct Host<const D: usize> {
    asking: Asking<D>,
    pub(crate) unknowns: Unknowns<D>,
    solves: AtomicUsize,
    /// Forces that are not there yet: they are taken off those of the host.
    offset: Mutex<Vec<f64>>,
}

/// A linear system with the contact at a state.
pub(crate) struct System<'a> {
    pub(crate) x: &'a [f64],
    pub(crate) part: TangentPart,
    pub(crate) shift: f64,
}

impl<const D: usize> Host<D> {
    pub(crate) fn new(asking: Asking<D>, unknowns: Unknowns<D>) -> Self {
        Self { asking, unknowns, solves: AtomicUsize::new(0), offset: Mutex::new(Vec::new()) }
    }

    /// Has forces taken off those of the host.
    pub(crate) fn set_offset(&self, offset: Vec<f64>) {
        let offset = if offset.iter().all(|force| *force == 0.0) { Vec::new() } else { offset };
        *self.offset.lock().unwrap_or_else(PoisonError::into_inner) = offset;
    }

    /// Linear systems solved so far.
    pub(crate) fn solves(&self) -> usize {
        self.solves.load(Relaxed)
    }

    /// What `work` makes of the contact.
    pub(crate) async fn contact<R: Send + 'static>(
        &self,
        work: impl FnOnce(&mut Contact<D>) -> R + Send + 'static,
    ) -> R {
        self.asking.contact(work).await
    }

    /// Internal less external forces, and an energy where the host has one.
    pub(crate) async fn forces(&self, x: &[f64], matrix: bool) -> Result<(Vec<f64>, Option<f64>), Trouble> {
        match self.asking.host(Request::Forces { x: x.to_vec(), matrix }).await {
            Answer::Forces { mut forces, energy } => {
                let offset = self.offset.lock().unwrap_or_else(PoisonError::into_inner);
                forces.iter_mut().zip(&*offset).for_each(|(force, off)| *force -= off);
                Ok((forces, energy.map(|energy| energy - dot(&offset, x))))
            }
            other => Err(refused(other)),
        }
    }

    pub(crate) async fn product(&self, vector: Vec<f64>, magnitudes: bool) -> Result<Vec<f64>, Trouble> {
        vector_of("a product with the matrix", self.asking.host(Request::Product { vector, magnitudes }).await)
    }

    pub(crate) async fn diagonal(&self) -> Result<Vec<f64>, Trouble> {
        vector_of("the diagonal of the matrix", self.asking.host(Request::Diagonal).await)
    }

    /// Solution of a system, zero at unknowns that are not free.
    pub(crate) async fn solve(&self, system: System<'_>, right: Vec<f64>) -> Result<Vec<f64>, Trouble> {
        self.solves.fetch_add(1, Relaxed);
        let System { x, part, shift } = system;
        let right = self.unknowns.freed(right);
        let request = Request::Solve { x: x.to_vec(), part, shift, right };
        let found = vector_of("the solution of a linear system", self.asking.host(request).await)?;
        Ok(self.unknowns.freed(found))
    }

    /// A step to the equilibrium of the contact with linear bodies, and whether these have an energy that is least there.
    pub(crate) async fn condensed(
        &self,
        x: &[f64],
        forces: &[f64],
        moved: &[f64],
        [tolerance, absolute_tolerance]: [f64; 2],
    ) -> Result<(Vec<f64>, bool), Trouble> {
        self.solves.fetch_add(1, Relaxed);
        let (x, moved, forces) = (x.to_vec(), moved.to_vec(), forces.to_vec());
        let request = Request::Condensed { x, moved, forces, tolerance, absolute_tolerance };
        match self.asking.host(request).await {
            Answer::Step { step, is_definite } => Ok((finite("a condensed step", step)?, is_definite)),
            other => Err(refused(other)),
        }
    }
}

fn vector_of(what: &str, answer: Answer) -> Result<Vec<f64>, Trouble> {
    match answer {
        Answer::Vector(vector) => finite(what, vector),
        other => Err(refused(other)),
    }
}

fn finite(what: &str, vector: Vec<f64>) -> Result<Vec<f64>, Trouble> {
    match vector.iter().position(|entry| !entry.is_finite()) {
        Some(unknown) => Err(Trouble::Host(format!("{what} is not finite: {} at unknown {unknown}", vector[unknown]))),
        None => Ok(vector),
    }
}

fn refused(answer: Answer) -> Trouble {
    Trouble::Host(match answer {
        Answer::Refused(why) => why,
        _ => "an answer of another kind than requested".into(),
    })
}
