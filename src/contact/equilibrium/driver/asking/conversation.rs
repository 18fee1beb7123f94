//! A procedure that asks while it runs: written in one piece, and continued by its caller from answer to answer.
//!
//! The procedure is a future that nothing wakes: it waits only for its caller, who polls it once for every answer. So there is no thread
//! and no executor, and the bits depend on nothing but the answers.

use super::request::{Answer, Request};
use crate::contact::evaluation::Contact;
use std::future::poll_fn;
use std::pin::Pin;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::task::{Context, Poll, Waker};

type Work<const D: usize> = Box<dyn FnOnce(&mut Contact<D>) + Send>;

/// What the procedure waits for.
enum Waiting<const D: usize> {
    Nothing,
    /// Work on the contact, which the caller lends.
    Contact(Work<D>),
    Host(Request),
    Answered(Answer),
}

/// The procedure's end of the line.
pub(crate) struct Asking<const D: usize>(Arc<Mutex<Waiting<D>>>);

/// The caller's end, with the procedure.
pub(crate) struct Conversation<const D: usize, T> {
    waiting: Arc<Mutex<Waiting<D>>>,
    procedure: Mutex<Pin<Box<dyn Future<Output = T> + Send>>>,
}

/// How far the procedure got.
pub(crate) enum Turn<T> {
    Asks(Request),
    Ended(T),
}

fn lock<T>(one: &Mutex<T>) -> MutexGuard<'_, T> {
    one.lock().unwrap_or_else(PoisonError::into_inner)
}

impl<const D: usize> Asking<D> {
    /// Asks the host.
    pub(crate) async fn host(&self, request: Request) -> Answer {
        *lock(&self.0) = Waiting::Host(request);
        poll_fn(|_| {
            let mut waiting = lock(&self.0);
            match std::mem::replace(&mut *waiting, Waiting::Nothing) {
                Waiting::Answered(answer) => Poll::Ready(answer),
                other => {
                    *waiting = other;
                    Poll::Pending
                }
            }
        })
        .await
    }

    /// What `work` makes of the contact.
    pub(crate) async fn contact<R: Send + 'static>(
        &self,
        work: impl FnOnce(&mut Contact<D>) -> R + Send + 'static,
    ) -> R {
        let made = Arc::new(Mutex::new(None));
        let found = Arc::clone(&made);
        *lock(&self.0) = Waiting::Contact(Box::new(move |contact| *lock(&found) = Some(work(contact))));
        poll_fn(|_| lock(&made).take().map_or(Poll::Pending, Poll::Ready)).await
    }
}

impl<const D: usize, T> Conversation<D, T> {
    pub(crate) fn new<F: Future<Output = T> + Send + 'static>(procedure: impl FnOnce(Asking<D>) -> F) -> Self {
        let waiting = Arc::new(Mutex::new(Waiting::Nothing));
        let procedure =
            Mutex::new(Box::pin(procedure(Asking(Arc::clone(&waiting)))) as Pin<Box<dyn Future<Output = T> + Send>>);
        Self { waiting, procedure }
    }

    /// Continues until the procedure asks the host, or ends; `None` where it waits for an answer that was not given.
    pub(crate) fn next(&mut self, contact: &mut Contact<D>, answer: Option<Answer>) -> Option<Turn<T>> {
        if let Some(answer) = answer {
            *lock(&self.waiting) = Waiting::Answered(answer);
        }
        loop {
            let mut procedure = lock(&self.procedure);
            if let Poll::Ready(end) = procedure.as_mut().poll(&mut Context::from_waker(Waker::noop())) {
                return Some(Turn::Ended(end));
            }
            let waiting = std::mem::replace(&mut *lock(&self.waiting), Waiting::Nothing);
            match waiting {
                Waiting::Contact(work) => work(contact),
                Waiting::Host(request) => return Some(Turn::Asks(request)),
                Waiting::Answered(_) | Waiting::Nothing => return None,
            }
        }
    }
}
