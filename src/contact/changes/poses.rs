//! Obstacles where they stood at another time.

use crate::contact::evaluation::Contact;
use crate::contact::partners::Poses;

/// What `work` returns with obstacles at other poses.
pub(crate) fn with_poses<const D: usize, T>(
    contact: &mut Contact<D>,
    poses: &Poses<D>,
    work: impl FnOnce(&mut Contact<D>) -> T,
) -> T {
    let mut own = poses.clone();
    contact.partners.obstacles.exchange_poses(&mut own);
    contact.state.forget_found();
    let found = work(contact);
    contact.partners.obstacles.exchange_poses(&mut own);
    contact.state.forget_found();
    found
}
