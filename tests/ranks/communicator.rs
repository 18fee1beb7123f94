//! Ranks that are threads of the test.

use fmc_contact::{AllToAll, Communicator};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::thread;

/// What all ranks have in common: a meeting at which each leaves its bytes and takes all.
struct Meeting {
    state: Mutex<State>,
    all_here: Condvar,
}

struct State {
    /// Number of the gathering.
    turn: u64,
    sent: Vec<Option<Vec<u8>>>,
    /// Of the last gathering, by rank.
    all: Vec<Vec<u8>>,
}

/// One rank of several. `fails_at` is the number of the call that fails with 7.
pub(crate) struct ThreadRank {
    rank: usize,
    size: usize,
    meeting: Arc<Meeting>,
    fails_at: Option<usize>,
    calls: Mutex<usize>,
}

impl Communicator for ThreadRank {
    fn rank(&self) -> usize {
        self.rank
    }

    fn size(&self) -> usize {
        self.size
    }

    fn all_gather(&self, send: &[u8], counts: &[usize], received: &mut [u8]) -> Result<(), i32> {
        self.meet(send, |all| {
            assert_eq!((counts[self.rank], all.concat().len()), (send.len(), counts.iter().sum()));
            received.copy_from_slice(&all.concat());
        })
    }

    fn all_to_all(&self) -> Option<&dyn AllToAll> {
        Some(self)
    }
}

impl AllToAll for ThreadRank {
    fn all_to_all(&self, send: &[u8], to: &[usize], from: &[usize], received: &mut [u8]) -> Result<(), i32> {
        assert_eq!((to.len(), from.len(), to.iter().sum()), (self.size, self.size, send.len()));
        let ends = |counts: &[usize]| -> Vec<usize> {
            counts.iter().scan(0, |end, count| Some((*end, *end += count).0)).chain([counts.iter().sum()]).collect()
        };
        let mut frame: Vec<u8> = ends(to).iter().flat_map(|end| end.to_ne_bytes()).collect();
        frame.extend_from_slice(send);
        self.meet(&frame, |all| {
            let end = |frame: &[u8], r: usize| usize::from_ne_bytes(frame[8 * r..8 * (r + 1)].try_into().unwrap());
            for ((frame, count), at) in all.iter().zip(from).zip(ends(from)) {
                let [start, end] = [end(frame, self.rank), end(frame, self.rank + 1)];
                let mine = &frame[8 * (self.size + 1)..][start..end];
                assert_eq!(mine.len(), *count);
                received[at..at + count].copy_from_slice(mine);
            }
        })
    }
}

impl ThreadRank {
    /// Leaves bytes, and takes those of all ranks once they are there.
    fn meet(&self, send: &[u8], take: impl FnOnce(&[Vec<u8>])) -> Result<(), i32> {
        let mut calls = self.calls.lock().unwrap_or_else(PoisonError::into_inner);
        *calls += 1;
        let mut state = self.meeting.state.lock().unwrap();
        let turn = state.turn;
        state.sent[self.rank] = Some(send.to_vec());
        if state.sent.iter().all(Option::is_some) {
            state.all = state.sent.iter_mut().map(|bytes| bytes.take().unwrap()).collect();
            state.turn += 1;
            self.meeting.all_here.notify_all();
        }
        while state.turn == turn {
            state = self.meeting.all_here.wait(state).unwrap();
        }
        take(&state.all);
        if self.fails_at == Some(*calls) { Err(7) } else { Ok(()) }
    }
}

/// What `work` returns on every rank; where the second is given, that rank's communicator fails at a call of this number.
pub(crate) fn on_ranks<T: Send>(
    size: usize,
    failing: Option<(usize, usize)>,
    work: impl Fn(usize, Box<dyn Communicator>) -> T + Sync,
) -> Vec<T> {
    let state = Mutex::new(State { turn: 0, sent: (0..size).map(|_| None).collect(), all: Vec::new() });
    let meeting = Arc::new(Meeting { state, all_here: Condvar::new() });
    let work = &work;
    thread::scope(|scope| {
        let start = |rank| {
            let fails_at = failing.filter(|(failing, _)| *failing == rank).map(|(_, call)| call);
            let own = ThreadRank { rank, size, meeting: meeting.clone(), fails_at, calls: Mutex::new(0) };
            scope.spawn(move || work(rank, Box::new(own)))
        };
        let ranks: Vec<_> = (0..size).map(start).collect();
        ranks.into_iter().map(|rank| rank.join().unwrap()).collect()
    })
}
