//! Memory that a call has taken and nobody can give back: counted at the allocator, since the sanitizer that looks for it
//! would halve the number of runs.

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicIsize, Ordering::Relaxed};
use std::time::Duration;

/// The system's allocator, which counts.
pub struct Counting;

/// Bytes that are taken.
static TAKEN: AtomicIsize = AtomicIsize::new(0);

// SAFETY: all is left to the system's.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        TAKEN.fetch_add(layout.size() as isize, Relaxed);
        // SAFETY: the caller's.
        unsafe { System.alloc(layout) }
    }

    unsafe fn dealloc(&self, pointer: *mut u8, layout: Layout) {
        TAKEN.fetch_sub(layout.size() as isize, Relaxed);
        // SAFETY: the caller's.
        unsafe { System.dealloc(pointer, layout) }
    }
}

/// Times that something may be taken for good on the first call: a text of the last error, pools of threads, kept mappings.
const TRIES: usize = 5;

/// Threads of a pool that has been given up end in their own time: mostly at once, on a busy machine after a while.
const FIRST_WAIT: Duration = Duration::from_micros(20);
/// What they leave is freed when epochs have passed (crossbeam's, under rayon): others that work would make them pass.
const EPOCHS: usize = 8;
/// Each wait is twice the one before. After the first run, which may take something for good, little is waited: running again
/// costs no more.
const MOST_WAITS: [u32; 2] = [5, 18];

/// Runs, and if more is taken than before, runs again: what is taken every time is lost.
pub fn none_from(run: impl Fn()) {
    let mut grown = [0; TRIES];
    for attempt in 0..TRIES {
        let before = TAKEN.load(Relaxed);
        run();
        let growth = || TAKEN.load(Relaxed) - before;
        for wait in 0..MOST_WAITS[attempt.min(1)] {
            if growth() <= 0 {
                break;
            }
            (0..EPOCHS).for_each(|_| crossbeam_epoch::pin().flush());
            if growth() > 0 {
                std::thread::sleep(FIRST_WAIT * 2u32.pow(wait));
            }
        }
        grown[attempt] = growth();
        if grown[attempt] <= 0 {
            return;
        }
    }
    panic!("memory is lost at every call: {grown:?} bytes");
}
