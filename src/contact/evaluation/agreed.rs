//! What ranks that share the work must have in common.

use super::parts::Contact;
use crate::contact::method::Options;
use std::hash::Hasher;

/// Hash of what an evaluation depends on, but for the history, and of the request.
pub(crate) fn hash_in_common<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]], request: &str) -> u64 {
    let mut hasher = rustc_hash::FxHasher::default();
    let mut add = |x: f64| hasher.write_u64(x.to_bits());
    coords.as_flattened().iter().for_each(|x| add(*x));
    contact.mesh.offsets().numbers().iter().for_each(|x| add(*x));
    for rigid in contact.partners.obstacles.iter().flatten() {
        let pose = &rigid.obstacle.pose;
        pose.position.iter().chain(pose.rotation.as_flattened()).for_each(|x| add(*x));
        add(pose.scale);
    }
    let options = Options { threads: 1, ..*contact.method.options() };
    hasher.write(format!("{options:?}").as_bytes());
    hasher.write(request.as_bytes());
    hasher.write_usize(contact.mesh.surface.facet_count());
    hasher.finish()
}
