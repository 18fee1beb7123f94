//! The search for an equilibrium of a host's bodies in contact, one load step at a time.
//!
//! By reverse communication: [`Equilibrium::next`] says what it needs, forces, products with the bodies' matrix or the solution of a
//! linear system, and the host, which keeps its matrices and solvers, answers. What it does, in this order:
//!
//! - `layers`: where the law has no stiffness, each pair gets one from the host's matrix;
//! - `motions`, `settle`: bodies that nothing holds move rigidly until contact balances their loads, or are refused by name;
//! - `stood`, `passed`, `half_turns`: obstacles that were moved through a body before the search, or turned so far that nobody knows which way, are told;
//! - `overlaps`: overlaps that loads do not explain are told;
//! - `unchanged`: a load step in which nothing changes takes up what the last one has found;
//! - `falling_load`: multipliers of another load fall with it;
//! - `parts`: what is prescribed moves as far as nothing passes through anything, then the next part;
//! - `unloaded`: bodies whose load is gone come to rest undeformed beside one another, if they can;
//! - `stuck` (with `falling`, what is known of it): where a load falls that friction is borne with, the first step has nothing slide;
//! - `levels`, `nearest` (with `secant`, `turned`), `softly` (friction that sticks softly first), `downhill` (with `along`): the equilibrium, where the one
//!   before has not found it;
//! - `updates`: multipliers, until what is left of the penetration does not matter; `within_facets`: where there are none;
//! - `patches`: those of the law `fiber`, where they are not left to the host;
//! - `rounded`: forces that are hardly more than what coordinates are rounded to are told;
//! - `uncommitted`, `locking`: steps that were never accepted, and cohesive interfaces too stiff for cells that do not match, are told;
//! - `standing`: whether bodies that only contact holds stand;
//! - `breaking`, `told_breaking`: cohesive interfaces that break on the way, for what is said where there is no equilibrium.
//!
//! `asking` (what a search asks, and whom) · `bodies` (what is known of them) · `progress` (where it is) · `ways` (to an equilibrium) · `told` (what is said
//! of it) · `steps` (the order of things)

mod asking;
mod bodies;
mod progress;
mod steps;
mod told;
mod ways;

pub use asking::options::DriverOptions;
pub use asking::outcome::{Found, Refusal, Way};
pub use asking::request::{Answer, Request};
pub use asking::trouble::Unheld;
pub use asking::unknowns::Unknowns;
pub use bodies::limit::StepLimit;
pub(super) use bodies::limit::step_limit;
pub(super) use bodies::masses::layers_of_masses;

use crate::Error;
use crate::contact::evaluation::Contact;
use asking::conversation::{Conversation, Turn};
use progress::before::Kept;
use steps::attempt::LoadStep;
use steps::check::check_host;
use steps::load_step::load_step;

/// A search for the equilibrium at the end of one load step.
pub struct Equilibrium<const D: usize> {
    count: usize,
    conversation: Conversation<D, Result<Found<D>, Refusal>>,
    asked: Option<Request>,
    ended: Option<Box<Result<Found<D>, Refusal>>>,
    kept: Kept<D>,
}

/// What comes next.
#[derive(Debug)]
pub enum Next<'a, const D: usize> {
    /// The host is asked for something.
    Asked(&'a Request),
    /// The equilibrium.
    Found(&'a Found<D>),
    /// There is none, or none was found. The contact's history is that of before.
    Refused(&'a Refusal),
}

impl<const D: usize> Equilibrium<D> {
    /// From `x`, with unknowns that are not free at `prescribed` in the end; `None`: where they are.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::UnknownOutOfRange`], [`Error::NonFiniteCoordinate`], [`Error::NotPositive`].
    #[inline(never)]
    pub fn new(
        contact: &Contact<D>,
        unknowns: Unknowns<D>,
        x: &[f64],
        prescribed: Option<&[f64]>,
        options: DriverOptions,
    ) -> Result<Self, Error> {
        options.check()?;
        unknowns.check(contact.surface().unknown_count())?;
        for (array, given) in [("x", Some(x)), ("prescribed", prescribed)] {
            let found = given.map_or(unknowns.count, <[f64]>::len);
            if found != unknowns.count {
                return Err(Error::Length { array, expected: unknowns.count, found });
            }
            if let Some(entry) = given.and_then(|given| given.iter().position(|entry| !entry.is_finite())) {
                return Err(Error::NonFiniteStiffness { array, entry });
            }
        }
        let target = prescribed.unwrap_or(x);
        let moved = |unknown: usize| if unknowns.free[unknown] { 0.0 } else { target[unknown] - x[unknown] };
        let (moved, count) = ((0..unknowns.count).map(moved).collect(), unknowns.count);
        let step = LoadStep { unknowns, x: x.to_vec(), moved, options };
        let kept = Kept::nothing();
        let conversation = match options.is_check {
            true => Conversation::new(|asking| check_host(asking, step)),
            false => Conversation::new(|asking| load_step(asking, step, kept.clone())),
        };
        Ok(Self { count, conversation, asked: None, ended: None, kept })
    }

    /// Takes the answer to what was asked last, and goes on. Without an answer it asks the same again.
    ///
    /// # Errors
    /// [`Error::Length`] for an answer of another length than there are unknowns, [`Error::Unsupported`] for one of another kind than was
    /// asked for; the question then stays.
    #[inline(never)]
    pub fn next(&mut self, contact: &mut Contact<D>, answer: Option<Answer>) -> Result<Next<'_, D>, Error> {
        let goes_on = match (&self.asked, &answer) {
            _ if self.ended.is_some() => false,
            (None, _) => true,
            (Some(request), Some(answer)) => {
                check(request, answer, self.count)?;
                true
            }
            (Some(_), None) => false,
        };
        if goes_on {
            let answer = answer.filter(|_| self.asked.is_some());
            match self.conversation.next(contact, answer) {
                Some(Turn::Asks(request)) => self.asked = Some(request),
                Some(Turn::Ended(end)) => self.end(contact, end),
                None => {}
            }
        }
        self.now().ok_or(Error::Unsupported { what: "a search that has asked for nothing" })
    }

    /// Gives the search up, as where the host can answer no more: the contact's friction and multipliers are what they were before, and the
    /// search has ended with a refusal. Does nothing where it has ended.
    #[inline(never)]
    pub fn abandon(&mut self, contact: &mut Contact<D>) {
        if self.ended.is_none() {
            self.end(contact, Err(Refusal::abandoned()));
        }
    }

    fn end(&mut self, contact: &mut Contact<D>, end: Result<Found<D>, Refusal>) {
        if let Some(before) = self.kept.take().filter(|_| end.is_err()) {
            before.put_back(contact);
        }
        self.ended = Some(Box::new(end));
    }

    /// Goes on to the end, with a host that answers at once.
    ///
    /// # Errors
    /// As [`Self::next`].
    pub fn run(
        &mut self,
        contact: &mut Contact<D>,
        mut host: impl FnMut(&Contact<D>, &Request) -> Answer,
    ) -> Result<Result<&Found<D>, &Refusal>, Error> {
        let mut answer = None;
        while let Next::Asked(request) = self.next(contact, answer)? {
            answer = Some(host(contact, request));
        }
        match self.ended.as_deref() {
            Some(Ok(found)) => Ok(Ok(found)),
            Some(Err(refusal)) => Ok(Err(refusal)),
            None => Err(Error::Unsupported { what: "a search that has not ended" }),
        }
    }

    /// What was asked for last, or how the search has ended; `None` before it has begun.
    pub fn now(&self) -> Option<Next<'_, D>> {
        match (self.ended.as_deref(), &self.asked) {
            (Some(Ok(found)), _) => Some(Next::Found(found)),
            (Some(Err(refusal)), _) => Some(Next::Refused(refusal)),
            (None, asked) => asked.as_ref().map(Next::Asked),
        }
    }
}

fn check(request: &Request, answer: &Answer, expected: usize) -> Result<(), Error> {
    let length = |array, found: usize| match found {
        found if found == expected => Ok(()),
        found => Err(Error::Length { array, expected, found }),
    };
    match (request, answer) {
        (_, Answer::Refused(_)) => Ok(()),
        (Request::Forces { .. }, Answer::Forces { forces, .. }) => length("forces", forces.len()),
        (Request::Product { .. } | Request::Diagonal | Request::Solve { .. }, Answer::Vector(vector)) => {
            length("vector", vector.len())
        }
        (Request::Condensed { .. }, Answer::Step { step, .. }) => length("step", step.len()),
        _ => Err(Error::Unsupported { what: "an answer of another kind than requested" }),
    }
}
