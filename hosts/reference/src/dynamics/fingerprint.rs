//! A number that tells one setup from another.

use super::Setup;
use fmc_contact::{Options, Shape};
use std::fmt::Write;

/// FNV-1a, 64 bits: short, and the same on every machine. It guards against mistakes, not against malice.
pub(super) struct Fnv(pub(super) u64);

impl Fnv {
    pub(super) fn new() -> Self {
        Self(0xcbf2_9ce4_8422_2325)
    }

    pub(super) fn bytes(&mut self, bytes: &[u8]) {
        for byte in bytes {
            self.0 = (self.0 ^ u64::from(*byte)).wrapping_mul(0x0000_0100_0000_01b3);
        }
    }
}

impl Write for Fnv {
    fn write_str(&mut self, text: &str) -> std::fmt::Result {
        self.bytes(text.as_bytes());
        Ok(())
    }
}

/// Fingerprint of all that decides how a simulation goes on, but for its state and its step. Threads do not count, nor
/// does how often the step is checked. What a signed distance function returns cannot be known.
///
/// It hashes the text that `Debug` writes: shortest decimal numbers that read back as the same bits.
pub(super) fn fingerprint<const D: usize>(setup: &Setup<D>) -> u64 {
    let mut hash = Fnv::new();
    let contact = Options { threads: 1, ..setup.contact };
    let polytopes: Vec<_> = (setup.obstacles.iter())
        .filter_map(|o| if let Shape::Polytope { points, facets } = &o.shape { Some((points, facets)) } else { None })
        .collect();
    let Setup { obstacles, supports, load, damping, contact_substeps, new_fibers_every_step, .. } = setup;
    let settings = (contact, obstacles, polytopes, supports, load, damping, contact_substeps, new_fibers_every_step);
    let mut written = write!(hash, "{D} {settings:?}");
    for part in setup.model.parts() {
        let text = (&part.name, part.cell_type, &part.mesh, &part.material);
        written = written.and(write!(hash, "{text:?}"));
    }
    debug_assert!(written.is_ok(), "a hash takes any text");
    hash.0
}
