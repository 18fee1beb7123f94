//! Ranks that share the work of a context.

use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::given_struct::check_struct;
use crate::capi::boundary::pointer::{Output, optional};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::{FMC_ERROR_BAD_RANK, FMC_ERROR_NULL_POINTER};
use crate::capi::context::session::in_either;
use crate::capi::context::state::{fmc_context, read, write};
use crate::{AllToAll, Communicator, Error};
use std::ffi::c_void;

/// Sends bytes to all ranks, this one too, and receives theirs: rank r sends `counts[r]` bytes, and `received` gets the bytes
/// of all ranks, one after the other. `user` is the pointer given with the function. `fmc_mpi.h` implements it by
/// MPI_Allgatherv.
///
/// Return 0; any other value makes the evaluation fail with `FMC_ERROR_COMMUNICATION`. It is called on the thread that evaluates,
/// in the same order on all ranks. It must not call a function of the same context, throw, or jump out.
pub type fmc_all_gather = Option<
    unsafe extern "C" fn(user: *mut c_void, send: *const c_void, counts: *const u64, received: *mut c_void) -> i32,
>;

/// Sends bytes to every rank, this one too, and receives their bytes for this rank: `send` has `send_counts[r]` bytes for rank r, one
/// rank after the other, and `received` gets `received_counts[r]` of rank r. `user` is the pointer given with the function.
/// `fmc_mpi.h` implements it by MPI_Alltoallv.
///
/// Return 0; any other value makes the call of the library fail with `FMC_ERROR_COMMUNICATION`. The rules of `fmc_all_gather` apply.
pub type fmc_all_to_all = Option<
    unsafe extern "C" fn(
        user: *mut c_void,
        send: *const c_void,
        send_counts: *const u64,
        received: *mut c_void,
        received_counts: *const u64,
    ) -> i32,
>;

/// Ranks of a parallel program, as the host's message passing library has them. Initialise it with `fmc_communicator_init`.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct fmc_communicator {
    /// Set by `fmc_communicator_init`, so that the library recognises an uninitialised struct.
    pub struct_size: usize,
    /// Number of this rank, from 0, and of all ranks, at least 1.
    pub rank: i32,
    pub size: i32,
    /// Moves bytes.
    pub all_gather: fmc_all_gather,
    /// Handed to the functions.
    pub user: *mut c_void,
    /// Moves bytes to single ranks. It may be NULL, on all ranks; `all_gather` then sends these bytes to all ranks. With a mesh in
    /// parts it sends faces between ranks to the ranks that may have the other side.
    pub all_to_all: fmc_all_to_all,
    /// Zero. Room for functions of later versions.
    pub reserved: [u64; 5],
}

/// Work of this rank since the communicator was set; `item_count` is the total of all ranks.
///
/// New fields take the place of reserved ones; the size of the struct does not change.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct fmc_rank_counts {
    /// Size of this struct, as the library wrote it.
    pub struct_size: usize,
    /// Facets, bundles of lines, pieces of cells and pairs of facets that were divided among the ranks.
    pub item_count: u64,
    /// Items that this rank measured.
    pub own_item_count: u64,
    /// Calls of the communicator.
    pub call_count: u64,
    /// Bytes that this rank sent, and received, its own too.
    pub sent_bytes: u64,
    pub received_bytes: u64,
    /// Zero.
    pub reserved: [u64; 4],
}

/// Sets a communicator of one rank without a function.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_communicator_init(communicator: *mut fmc_communicator) -> fmc_status {
    entry(|| {
        let output = Output::required("communicator", communicator)?;
        let alone = fmc_communicator {
            struct_size: size_of::<fmc_communicator>(),
            rank: 0,
            size: 1,
            all_gather: None,
            user: std::ptr::null_mut(),
            all_to_all: None,
            reserved: [0; 5],
        };
        // SAFETY: the host guarantees room for a struct.
        unsafe { output.write(alone) };
        Ok(())
    })
}

/// Shares the work of the context's evaluations with other ranks; NULL ends this. The struct is copied. From then on all
/// ranks make the same calls on their contexts with the same coordinates, options, obstacles and history. Each gets the
/// whole result, bit-for-bit identical to one rank, for any number of ranks. The number of threads may differ. Ranks divide
/// the measuring of facets, lines and cells; every rank measures pairs with a signed distance function. If there is too
/// little work to share, every rank does all.
///
/// An evaluation that fails on one rank fails on all, with `FMC_ERROR_ON_OTHER_RANK` there. If ranks were given different data,
/// all return `FMC_ERROR_RANKS_DIFFER`.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_STRUCT_SIZE`, `FMC_ERROR_RESERVED_FIELD`, `FMC_ERROR_BAD_RANK`, `FMC_ERROR_BUSY`. Threads:
/// one call at a time on a context.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_set_communicator(
    context: *mut fmc_context,
    communicator: *const fmc_communicator,
) -> fmc_status {
    entry(|| {
        // SAFETY: the host passes a context, and a communicator or NULL.
        unsafe {
            write(context, |state| {
                let given = optional("communicator", communicator)?;
                let ranks = given.map(HostRanks::new).transpose()?;
                in_either!(&mut state.session, one => one.set_communicator(ranks.map(|ranks| Box::new(ranks) as Box<dyn Communicator>)))
            })
        }
    })
}

/// Work of this rank since the communicator was set; zeros without a communicator.
///
/// Errors: `FMC_ERROR_NULL_POINTER`, `FMC_ERROR_BUSY`. Threads: any number at once.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_rank_counts(
    context: *const fmc_context,
    counts: *mut fmc_rank_counts,
) -> fmc_status {
    entry(|| {
        let output = Output::required("counts", counts)?;
        // SAFETY: the host passes a context.
        let found = in_either!(&unsafe { read(context) }?.session, one => one.rank_counts());
        let counts = fmc_rank_counts {
            struct_size: size_of::<fmc_rank_counts>(),
            item_count: found.item_count,
            own_item_count: found.own_item_count,
            call_count: found.call_count,
            sent_bytes: found.sent_bytes,
            received_bytes: found.received_bytes,
            reserved: [0; 4],
        };
        // SAFETY: the host guarantees room for a struct.
        unsafe { output.write(counts) };
        Ok(())
    })
}

/// A communicator of the host.
pub(crate) struct HostRanks {
    rank: usize,
    size: usize,
    all_gather: unsafe extern "C" fn(*mut c_void, *const c_void, *const u64, *mut c_void) -> i32,
    all_to_all: Option<HostAllToAll>,
    user: *mut c_void,
}

/// Its operation for single ranks.
struct HostAllToAll {
    function: unsafe extern "C" fn(*mut c_void, *const c_void, *const u64, *mut c_void, *const u64) -> i32,
    user: *mut c_void,
}

// SAFETY: the pointer is handed through, never followed, and the functions are called by the thread that evaluates the context
// only; the host promises in `fmc_context_set_communicator` that they may be called from whichever that is.
unsafe impl Send for HostRanks {}
// SAFETY: as above; evaluations of one context exclude one another.
unsafe impl Sync for HostRanks {}

impl HostRanks {
    pub(crate) fn new(given: &fmc_communicator) -> Result<Self, Failure> {
        check_struct::<fmc_communicator>("fmc_communicator", given.struct_size, given.reserved)?;
        let (Ok(rank), Ok(size)) = (usize::try_from(given.rank), usize::try_from(given.size)) else {
            let text = format!("rank {} of {}: ranks are counted from 0", given.rank, given.size);
            return Err(Failure::new(FMC_ERROR_BAD_RANK, text));
        };
        if rank >= size {
            return Err(Error::BadRank { rank, size }.into());
        }
        let Some(all_gather) = given.all_gather else {
            return Err(Failure::new(FMC_ERROR_NULL_POINTER, "'all_gather' of the communicator is NULL"));
        };
        let all_to_all = given.all_to_all.map(|function| HostAllToAll { function, user: given.user });
        Ok(Self { rank, size, all_gather, all_to_all, user: given.user })
    }
}

impl Communicator for HostRanks {
    fn rank(&self) -> usize {
        self.rank
    }

    fn size(&self) -> usize {
        self.size
    }

    fn all_gather(&self, send: &[u8], counts: &[usize], received: &mut [u8]) -> Result<(), i32> {
        let counts = wide(counts);
        // SAFETY: there is one count for every rank, `send` has that of this one, and `received` has room for their sum; the host
        // guarantees a function that keeps to its contract.
        let code = unsafe {
            (self.all_gather)(self.user, send.as_ptr().cast(), counts.as_ptr(), received.as_mut_ptr().cast())
        };
        done(code)
    }

    fn all_to_all(&self) -> Option<&dyn AllToAll> {
        self.all_to_all.as_ref().map(|operation| operation as &dyn AllToAll)
    }
}

impl AllToAll for HostAllToAll {
    fn all_to_all(&self, send: &[u8], to: &[usize], from: &[usize], received: &mut [u8]) -> Result<(), i32> {
        let [to, from] = [to, from].map(wide);
        let (send, received) = (send.as_ptr().cast(), received.as_mut_ptr().cast());
        // SAFETY: there is one count of either kind for every rank, `send` has their sum, and `received` has room for that of the
        // others; the host guarantees a function that keeps to its contract.
        done(unsafe { (self.function)(self.user, send, to.as_ptr(), received, from.as_ptr()) })
    }
}

fn wide(counts: &[usize]) -> Vec<u64> {
    counts.iter().map(|count| *count as u64).collect()
}

/// What a function of the host returned.
fn done(code: i32) -> Result<(), i32> {
    if code == 0 { Ok(()) } else { Err(code) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::capi::boundary::status::fmc_status::{FMC_ERROR_RESERVED_FIELD, FMC_ERROR_STRUCT_SIZE, FMC_OK};

    unsafe extern "C" fn nothing(_: *mut c_void, _: *const c_void, _: *const u64, _: *mut c_void) -> i32 {
        0
    }

    #[test]
    fn what_is_no_communicator_is_refused() {
        let refused = |change: fn(&mut fmc_communicator)| {
            let mut given = std::mem::MaybeUninit::uninit();
            // SAFETY: room for a struct, which is initialised then.
            let mut given = unsafe {
                assert_eq!(fmc_communicator_init(given.as_mut_ptr()), FMC_OK);
                given.assume_init()
            };
            given.all_gather = Some(nothing);
            change(&mut given);
            HostRanks::new(&given).map(|_| ()).map_err(|failure| failure.status)
        };
        assert_eq!(refused(|_| {}), Ok(()));
        assert_eq!(refused(|given| given.struct_size -= 8), Err(FMC_ERROR_STRUCT_SIZE));
        assert_eq!(refused(|given| given.reserved[4] = 1), Err(FMC_ERROR_RESERVED_FIELD));
        assert_eq!(refused(|given| given.rank = 1), Err(FMC_ERROR_BAD_RANK));
        assert_eq!(refused(|given| given.rank = -1), Err(FMC_ERROR_BAD_RANK));
        assert_eq!(refused(|given| given.all_gather = None), Err(FMC_ERROR_NULL_POINTER));
    }
}
