//! Ranks that share the work.

use super::Host;
use super::array::{checked, unless};
use super::callbacks::{echo, fails_to_gather};
use crate::interface::*;
use crate::program::Hole;

impl Host {
    /// What is right on one rank is right on ranks that are all the same: what the others should have sent is done here.
    pub(super) fn share(&mut self, rank: i32, size: i32, fails: bool, hole: Hole) {
        // SAFETY: structs of this interface, the host's own context, and functions that keep to their contract.
        unsafe {
            let mut given = std::mem::MaybeUninit::<fmc_communicator>::zeroed().assume_init();
            let set = |given: &fmc_communicator| checked(fmc_context_set_communicator(self.context, given));
            assert!(set(&given) != OK, "a communicator that was not initialised");
            let to = unless(hole, 0, &raw mut given);
            let is_set = !to.is_null();
            assert_eq!(checked(fmc_communicator_init(to)) == OK, is_set);
            assert!(set(&given) != OK, "a communicator without a function");
            (given.rank, given.size) = (rank, size);
            given.user = std::ptr::without_provenance_mut((rank.max(0) + 256 * size.max(0)) as usize);
            if fails && self.mesh.is_ordinary() {
                given.all_gather = Some(fails_to_gather);
                if set(&given) == OK {
                    self.evaluate_refused();
                }
            }
            given.all_gather = Some(echo);
            assert_eq!(set(&given) == OK, is_set && (0..size).contains(&rank), "rank {rank} of {size}");
            let mut counts = fmc_rank_counts::default();
            let to = unless(hole, 1, &raw mut counts);
            let status = checked(fmc_context_rank_counts(self.context, to));
            assert!((status == OK) != to.is_null() && counts.own_item_count <= counts.item_count);
            if hole % 2 == 0 {
                assert_eq!(checked(fmc_context_set_communicator(self.context, std::ptr::null())), OK);
            }
        }
    }
}
