//! A number that identifies a setup.

use super::Setup;
use fmc_contact::{Options, Shape};
use fnv::FnvHasher;
use std::fmt::Write;
use std::hash::Hasher;

/// FNV-1a, 64 bits: the same on every machine and with every compiler, as a file needs it that outlives the program. It
/// guards against mistakes, not against malice.
#[derive(Default)]
struct Fingerprint(FnvHasher);

impl Write for Fingerprint {
    fn write_str(&mut self, text: &str) -> std::fmt::Result {
        self.0.write(text.as_bytes());
        Ok(())
    }
}

/// Fingerprint of all that decides how a simulation goes on, but for its state and its step. Threads do not count, nor
/// does how often the step is checked. What a signed distance function returns cannot be known.
///
/// It hashes the text that `Debug` writes: shortest decimal numbers that read back as the same bits.
pub(super) fn fingerprint<const D: usize>(setup: &Setup<D>) -> u64 {
    let mut hash = Fingerprint::default();
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
    hash.0.finish()
}
