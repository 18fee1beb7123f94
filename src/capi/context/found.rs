//! What a function found last, kept for the call that fetches it.

/// Rows that a call with room for them takes after one that asked how many there are: found once, as long as the coordinates
/// are the same to the bit and no other call has changed the context.
#[derive(Default)]
pub(crate) struct Found<T> {
    /// Bits of the coordinates, and of what else was asked with.
    at: Vec<u64>,
    /// Number of the call that used it last; 0 for none.
    call: u64,
    pub(crate) rows: T,
}

impl<T> Found<T> {
    /// The rows for call number `call`: those that the call before it used, or new ones.
    pub(crate) fn at<E>(&mut self, at: Vec<u64>, call: u64, find: impl FnOnce() -> Result<T, E>) -> Result<&T, E> {
        if self.call == 0 || self.call + 1 != call || self.at != at {
            let rows = find()?;
            (self.at, self.rows) = (at, rows);
        }
        self.call = call;
        Ok(&self.rows)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_found_once_for_two_calls_in_a_row() {
        let (mut found, mut searches) = (Found::<Vec<u64>>::default(), 0);
        let mut rows = |at: u64, call: u64| {
            let rows = found.at(vec![at], call, || {
                searches += 1;
                Ok::<_, ()>(vec![searches])
            });
            rows.cloned().unwrap()
        };
        assert_eq!([rows(5, 1), rows(5, 2), rows(5, 3)], [[1], [1], [1]]);
        assert_eq!([rows(6, 4), rows(6, 6)], [[2], [3]], "other coordinates, and another call in between");
    }
}
