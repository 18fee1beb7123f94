//! A communicator of one rank.

use fmc_contact::Communicator;

pub(crate) struct OneRank;

impl Communicator for OneRank {
    fn rank(&self) -> usize {
        0
    }

    fn size(&self) -> usize {
        1
    }

    fn all_gather(&self, send: &[u8], _: &[usize], received: &mut [u8]) -> Result<(), i32> {
        received.copy_from_slice(send);
        Ok(())
    }
}
