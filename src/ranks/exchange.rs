//! What is for single ranks.

use super::communicator::AllToAll;
use super::packed::Packed;
use super::shared_work::{Ranks, tag};
use crate::Error;

impl Ranks {
    /// What ranks have for this one, by rank; `lists` is what this one has for each. Where the host has no operation for that, all
    /// get all, and take what is theirs.
    ///
    /// # Errors
    /// [`Error::Communication`], [`Error::RanksDiffer`].
    pub(crate) fn exchange<T: Packed + Clone>(&self, lists: &[Vec<T>]) -> Result<Vec<Vec<T>>, Error> {
        if let Some(host) = self.communicator.all_to_all() {
            let received = self.to_single(host, lists);
            return self.lists_in(received);
        }
        let sent: Vec<(usize, T)> = lists
            .iter()
            .enumerate()
            .flat_map(|(rank, list)| list.iter().map(move |item| (rank, item.clone())))
            .collect();
        let own = |list: Vec<(usize, T)>| {
            list.into_iter().filter(|(rank, _)| *rank == self.rank()).map(|(_, item)| item).collect()
        };
        Ok(self.gather_lists(&sent)?.into_iter().map(own).collect())
    }

    /// Lists for this rank, one after the other; `None` where they cannot be had, or the ranks do not do the same.
    fn to_single<T: Packed>(&self, host: &dyn AllToAll, lists: &[Vec<T>]) -> Option<Vec<u8>> {
        if self.has_failed() {
            return None;
        }
        let (mut send, mut counts) = (Vec::new(), Vec::with_capacity(self.size));
        for list in lists {
            let before = send.len();
            list.pack(&mut send);
            counts.push(send.len() - before);
        }
        // That all do the same; what follows is by pairs.
        self.lengths(send.len(), tag::<T>(0, 1))?;
        let (mut about, each) = (Vec::new(), vec![size_of::<usize>(); self.size]);
        counts.iter().for_each(|count| count.pack(&mut about));
        let move_all = |send: &[u8], to: &[usize], from: &[usize]| {
            self.received(send.len(), from, |received| host.all_to_all(send, to, from, received))
        };
        let received = move_all(&about, &each, &each)?;
        let mut bytes = &received[..];
        let from: Vec<usize> = std::iter::from_fn(|| usize::unpack(&mut bytes)).collect();
        move_all(&send, &counts, &from)
    }
}
