//! Memory for what comes in large numbers.

use super::Error;

impl Error {
    /// An empty list with room for so many entries, for what comes in large numbers: a list that grows ends the process where there is
    /// no memory.
    pub(crate) fn room<T>(what: &'static str, count: usize) -> Result<Vec<T>, Self> {
        let mut list = Vec::new();
        let bytes = count.saturating_mul(size_of::<T>());
        list.try_reserve_exact(count).map_err(|_| Error::Memory { what, bytes })?;
        Ok(list)
    }

    /// A list of so many entries.
    pub(crate) fn collected<T>(what: &'static str, entries: impl ExactSizeIterator<Item = T>) -> Result<Vec<T>, Self> {
        let mut list = Self::room(what, entries.len())?;
        list.extend(entries);
        Ok(list)
    }

    /// Whether some bytes can be had at all, before work begins that takes them by and by.
    pub(crate) fn check_room(what: &'static str, bytes: usize) -> Result<(), Self> {
        Self::room::<u8>(what, bytes).map(drop)
    }
}
