//! The context: a mesh in contact that is evaluated again and again.

use super::found::Found;
use super::session::{Session, in_either};
use crate::capi::boundary::entry::{entry, guarded};
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::index::IndexSize;
use crate::capi::boundary::pointer::{Output, reference};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_BUSY;
use crate::capi::structs::contact_point::fmc_contact_point;
use crate::capi::structs::evaluation::{Evaluation, fmc_result};
use crate::capi::structs::gap_constraint::KeptGaps;
use crate::capi::structs::kept_tangent::Kept;
use crate::capi::structs::options::fmc_options;
use crate::capi::structs::view::fmc_coords;
use crate::contact::{CompressedRows, Pattern};
use std::ffi::{c_char, c_void};
use std::sync::{RwLock, RwLockReadGuard, TryLockError};

/// Level of a warning: the result is valid, but the user should read the message.
pub const FMC_LOG_WARNING: i32 = 1;

/// Receives messages: a level, and a sentence that is valid during the call. `user` is the pointer given with it.
///
/// It is called at the end of an evaluation, on its thread, and may call the getters. It must not free the context,
/// throw, or jump out.
pub type fmc_log_callback = Option<unsafe extern "C" fn(user: *mut c_void, level: i32, text: *const c_char)>;

/// Facets, search trees and obstacles of a mesh in contact, and the results of the last evaluation. Opaque.
///
/// Contexts share nothing, so different threads may use different contexts at once. Threads may use one context one
/// after another. Concurrent calls on it, from two threads or from inside a callback, return `FMC_ERROR_BUSY`.
pub struct fmc_context {
    state: RwLock<State>,
}

/// What the lock guards.
pub(crate) struct State {
    pub(crate) session: Session,
    pub(crate) evaluation: Evaluation,
    pub(crate) tangent: Kept,
    points: Found<Vec<fmc_contact_point>>,
    gaps: Found<KeptGaps>,
    /// What conducts, as the last flux found it.
    pub(crate) flux: CompressedRows<f64>,
    /// How often the context was changed, or could have been.
    calls: u64,
    /// Of the compressed rows, while it is kept.
    pub(crate) pattern: Option<Pattern>,
    /// Width of the numbers of nodes, cells and degrees of freedom, and what the first one is.
    pub(crate) index_size: IndexSize,
    pub(crate) index_base: i32,
    /// As they were set; the stiffness in force is the session's.
    pub(crate) options: fmc_options,
    log: fmc_log_callback,
    log_user: LogUser,
}

impl fmc_context {
    pub(crate) fn new(state: State) -> Self {
        Self { state: RwLock::new(state) }
    }
}

/// A matrix without rows.
fn nothing() -> CompressedRows<f64> {
    CompressedRows { offsets: vec![0], cols: Vec::new(), values: Vec::new() }
}

impl State {
    pub(crate) fn new(session: Session, index_size: IndexSize, options: &fmc_options) -> Self {
        Self {
            session,
            evaluation: Evaluation::default(),
            tangent: Kept::default(),
            points: Found::default(),
            gaps: Found::default(),
            flux: nothing(),
            calls: 0,
            pattern: None,
            index_size,
            index_base: options.index_base,
            options: *options,
            log: None,
            log_user: LogUser(std::ptr::null_mut()),
        }
    }

    /// Forgets what was kept of nodes and facets, which have other numbers now.
    pub(crate) fn renumber(&mut self) {
        (self.evaluation, self.tangent) = (Evaluation::default(), Kept::default());
        (self.points, self.gaps, self.flux) = (Found::default(), Found::default(), nothing());
        if let Some(pattern) = &mut self.pattern {
            *pattern = Pattern::default();
        }
    }

    /// The contact points at `coords`.
    ///
    /// # Safety
    /// The host guarantees the view.
    pub(crate) unsafe fn contact_points(&mut self, coords: &fmc_coords) -> Result<&[fmc_contact_point], Failure> {
        let Self { session, points, calls, index_base, .. } = self;
        // SAFETY: passed on to the caller.
        unsafe {
            let at = in_either!(session, one => one.bits(coords))?;
            Ok(points.at(at, *calls, || in_either!(session, one => one.contact_points(coords, *index_base)))?)
        }
    }

    /// The weighted gaps at `coords`.
    ///
    /// # Safety
    /// The host guarantees the view.
    pub(crate) unsafe fn gap_constraints(&mut self, coords: &fmc_coords, reach: f64) -> Result<&KeptGaps, Failure> {
        let Self { session, gaps, calls, index_base, .. } = self;
        // SAFETY: passed on to the caller.
        unsafe {
            let mut at = in_either!(session, one => one.bits(coords))?;
            at.push(reach.to_bits());
            gaps.at(at, *calls, || in_either!(session, one => one.gap_constraints(coords, reach, *index_base)))
        }
    }

    /// The weighted gaps that were found last.
    pub(crate) fn last_gaps(&self) -> &KeptGaps {
        &self.gaps.rows
    }

    /// Keeps a tangent until the next one, and its places if the pattern is kept.
    pub(crate) fn keep_tangent(&mut self, tangent: Kept) {
        if let Some(pattern) = &mut self.pattern {
            pattern.add(tangent.places.iter().copied());
        }
        self.tangent = tangent;
    }
}

/// The host's pointer for its log callback.
#[derive(Clone, Copy)]
struct LogUser(*mut c_void);

// SAFETY: it is handed through, never followed; the host promises in `fmc_context_set_log` that the callback may be
// called from whichever thread evaluates.
unsafe impl Send for LogUser {}
// SAFETY: as above.
unsafe impl Sync for LogUser {}

fn busy() -> Failure {
    Failure::new(FMC_ERROR_BUSY, "the context is in use by another call")
}

/// The state, to look at.
///
/// # Safety
/// The host guarantees a living context that is not freed during the call.
pub(crate) unsafe fn read<'a>(context: *const fmc_context) -> Result<RwLockReadGuard<'a, State>, Failure> {
    // SAFETY: passed on to the caller.
    match unsafe { reference("context", context) }?.state.try_read() {
        Ok(state) => Ok(state),
        // A panic under the lock left the state as it was: it is replaced only as the last step.
        Err(TryLockError::Poisoned(state)) => Ok(state.into_inner()),
        Err(TryLockError::WouldBlock) => Err(busy()),
    }
}

/// Runs `body` on the state; a failure counts nodes, cells and facets as the host does.
///
/// # Safety
/// The host guarantees a living context that is not freed during the call.
pub(crate) unsafe fn write<T>(
    context: *mut fmc_context,
    body: impl FnOnce(&mut State) -> Result<T, Failure>,
) -> Result<T, Failure> {
    // SAFETY: passed on to the caller.
    let mut state = match unsafe { reference("context", context.cast_const()) }?.state.try_write() {
        Ok(state) => state,
        Err(TryLockError::Poisoned(state)) => state.into_inner(),
        Err(TryLockError::WouldBlock) => return Err(busy()),
    };
    state.calls += 1;
    // A panic is caught under the lock, so that the lock is not poisoned.
    guarded(|| body(&mut state)).map_err(|failure| failure.in_numbers_from(state.index_base))
}

/// Sets the callback that receives messages; NULL, the default: none. The library never prints.
///
/// The callback and `user` must outlive the context, or be replaced before they end. They are called on the thread that
/// evaluates the context. Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUSY`. Threads: one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_log(
    context: *mut fmc_context,
    callback: fmc_log_callback,
    user: *mut c_void,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context.
        unsafe {
            write(context, |state| {
                (state.log, state.log_user) = (callback, LogUser(user));
                Ok(())
            })
        }
    })
}

/// Keeps and writes what `body` finds, and hands its warnings to the host's callback.
///
/// # Safety
/// The host guarantees a living context, and that `result`, if it is not NULL, may be written.
pub(crate) unsafe fn evaluated(
    context: *mut fmc_context,
    result: *mut fmc_result,
    body: impl FnOnce(&mut State) -> Result<Evaluation, Failure>,
) -> Result<(), Failure> {
    // SAFETY: passed on to the caller.
    let (log, user, messages) = unsafe {
        write(context, |state| {
            let output = Output::optional("result", result)?;
            let evaluation = body(state)?;
            output.write(evaluation.result);
            state.evaluation = evaluation;
            let messages = if state.log.is_some() { state.evaluation.warnings.clone() } else { Vec::new() };
            Ok((state.log, state.log_user, messages))
        })
    }?;
    // The lock is free again, so that the callback may ask the context for more.
    for (_, text) in messages {
        if let Some(log) = log {
            // SAFETY: the host gave a function that keeps to its contract, and its own pointer.
            unsafe { log(user.0, FMC_LOG_WARNING, text.as_ptr()) };
        }
    }
    Ok(())
}
