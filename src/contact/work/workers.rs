//! Threads that share the work of one contact.

use crate::Error;
use std::process;

/// Most threads of one contact: more than the largest machines have cores, and few enough for any to start.
const MOST_THREADS: usize = 1024;

/// Threads of one contact, which the process has that started them. A child that was forked from it has none of them: it does
/// the work alone, with the same results.
pub(crate) struct Workers {
    /// Always there until the end.
    pool: Option<rayon::ThreadPool>,
    process: u32,
}

impl Workers {
    /// None are started for one.
    pub(crate) fn new(threads: usize) -> Result<Option<Self>, Error> {
        if threads == 1 {
            return Ok(None);
        }
        if threads > MOST_THREADS {
            return Err(Error::Threads { threads });
        }
        let name = |index| format!("fmc-contact-{index}");
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).thread_name(name).build();
        let pool = pool.map_err(|_| Error::Threads { threads })?;
        Ok(Some(Self { pool: Some(pool), process: process::id() }))
    }

    /// The pool, if its threads are of this process.
    pub(crate) fn pool(&self) -> Option<&rayon::ThreadPool> {
        self.pool.as_ref().filter(|_| self.process == process::id())
    }
}

impl Drop for Workers {
    fn drop(&mut self) {
        // Threads of another process cannot be told to end; what they had locked may be locked for ever.
        if self.process != process::id() {
            std::mem::forget(self.pool.take());
        }
    }
}
