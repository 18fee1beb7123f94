//! A caller's wish to end a call that takes long.
//!
//! Loops whose work is shared ask between two pieces of work. What stops them is an unwinding with a payload of its own: results of
//! pieces are put together in many ways, none of which has a use for half of them. Nothing is left half done by it, since state is
//! replaced only by what is complete; whoever called catches it ([`caught`]).

use crate::Error;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

/// How often a caller is asked, at most.
const PAUSE: Duration = Duration::from_millis(50);

/// Whether a call is to end, as the caller says.
pub type Asked = Box<dyn Fn() -> bool + Send + Sync>;

/// Asks the caller, on its own thread alone, and tells all threads that work for it.
pub(crate) struct Interrupt {
    asked: Asked,
    is_over: AtomicBool,
    /// When it was asked last.
    last: Mutex<Option<Instant>>,
}

/// What unwinds.
struct Interrupted;

impl Interrupt {
    pub(crate) fn new(asked: Asked) -> Self {
        Self { asked, is_over: AtomicBool::new(false), last: Mutex::new(None) }
    }

    /// A piece of work is about to begin: ends all of it if the caller has said so. Threads of a pool know it from the thread that called.
    pub(crate) fn check(&self) {
        if rayon::current_thread_index().is_none() {
            self.ask();
        }
        if self.is_over.load(Ordering::Relaxed) {
            resume_unwind(Box::new(Interrupted));
        }
    }

    /// Asks the caller, unless that was just done, or all has been said.
    fn ask(&self) {
        if self.is_over.load(Ordering::Relaxed) {
            return;
        }
        let mut last = self.last.lock().unwrap_or_else(PoisonError::into_inner);
        if last.is_none_or(|last| last.elapsed() >= PAUSE) {
            *last = Some(Instant::now());
            drop(last);
            if (self.asked)() {
                self.is_over.store(true, Ordering::Relaxed);
            }
        }
    }

    /// Work on the threads of a pool, while this thread asks the caller.
    fn while_asking<T: Send>(&self, pool: &rayon::ThreadPool, work: impl FnOnce() -> T + Send) -> Option<T> {
        self.ask();
        let (sender, receiver) = channel();
        pool.in_place_scope(|scope| {
            scope.spawn(move |_| {
                // Nobody waits for it only where this thread has unwound.
                let _ = sender.send(work());
            });
            loop {
                match receiver.recv_timeout(PAUSE) {
                    Ok(found) => return Some(found),
                    Err(RecvTimeoutError::Timeout) => self.ask(),
                    // The work has unwound, and so does the scope.
                    Err(RecvTimeoutError::Disconnected) => return None,
                }
            }
        })
    }
}

/// Work on the threads of a pool; a caller who may end it is asked meanwhile.
pub(crate) fn on_threads_of<T: Send>(
    pool: &rayon::ThreadPool,
    interrupt: Option<&Interrupt>,
    work: impl FnOnce() -> T + Send,
) -> T {
    match interrupt {
        // A thread of a pool does not wait: what it waits for may be its own to do.
        Some(interrupt) if rayon::current_thread_index().is_none() => {
            interrupt.while_asking(pool, work).unwrap_or_else(|| resume_unwind(Box::new(Interrupted)))
        }
        _ => pool.install(work),
    }
}

/// Does work that a caller may end.
///
/// # Errors
/// [`Error::Interrupted`] if the caller did; those of the work.
pub(crate) fn caught<T>(interrupt: Option<&Interrupt>, work: impl FnOnce() -> Result<T, Error>) -> Result<T, Error> {
    let Some(interrupt) = interrupt else { return work() };
    // What is left half done is what unwinding leaves anywhere: see above.
    let done = catch_unwind(AssertUnwindSafe(work));
    interrupt.is_over.store(false, Ordering::Relaxed);
    done.unwrap_or_else(|payload| match payload.is::<Interrupted>() {
        true => Err(Error::Interrupted),
        false => resume_unwind(payload),
    })
}
