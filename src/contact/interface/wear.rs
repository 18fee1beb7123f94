//! Wear: what hosts call.

use crate::Error;
use crate::contact::changes::friction_steps;
use crate::contact::evaluation::Contact;
use crate::contact::wear::{Wear, WornFacet};

impl<const D: usize> Contact<D> {
    /// What is worn off the bodies so far ([`PairOptions::wear_coefficients`](crate::PairOptions::wear_coefficients)), by node and body: zeros
    /// at first.
    ///
    /// In [`Self::commit_step`] a side of a pair that has slid by |s| under the pressure p loses K p |s| of its depth. The surface then lies so
    /// much farther in, wherever contact looks at it, and nowhere else: the host's mesh and its strains stay. The depth at a node is ∫ N K p |s|
    /// dA / ∫ N dA, so that the volume is ∫ K p |s| dA. Within a step surfaces do not change, and forces and tangents are those of one
    /// energy as before. Where a step begins, the worn surface turns with its facets.
    ///
    /// Slip is that of friction without its elastic part; of a pair without friction all of it, since [`Self::begin_step`]. With friction ∫ p |s| dA is
    /// its work over the coefficient, facet by facet, where facets come into contact and leave it too.
    ///
    /// # Errors
    /// [`Error::NoStep`] where worn facets were set and no step has begun; [`Error::Unsupported`] for a mesh in parts.
    #[inline(never)]
    pub fn wear(&self) -> Result<Wear, Error> {
        self.mesh.surface.refuse_submesh("wear of a mesh in parts")?;
        self.history.check_worn()?;
        let (surface, worn) = (&self.mesh.surface, &self.history.worn);
        let mut depth = worn.depths(surface.point_weights().point_count());
        if let Some(division) = surface.division() {
            depth.truncate(division.interpolation.node_count());
            for nodes in division.welds() {
                nodes.iter().for_each(|&node| depth[node as usize] = depth[nodes[0] as usize]);
            }
        }
        Ok(Wear { depth, volumes: worn.volumes(surface) })
    }

    /// The same by facet, for a restart.
    pub fn worn_facets(&self) -> Vec<WornFacet> {
        self.history.worn.list()
    }

    /// Sets what is worn off: all that no row names is not worn. For a restart before [`Self::begin_step`] and [`Self::set_slip`]; `&[]` where the
    /// host has moved its nodes to the worn surface.
    ///
    /// # Errors
    /// [`Error::NoSuchRow`], [`Error::BadEntry`], [`Error::Unsupported`] for a mesh in parts; what was worn before then stays.
    #[inline(never)]
    pub fn set_worn_facets(&mut self, worn: &[WornFacet]) -> Result<(), Error> {
        friction_steps::set_worn(self, worn)
    }

    /// As many times the wear of a step counts from now on, 1 at first: a step stands for so many cycles.
    ///
    /// # Errors
    /// [`Error::NotPositive`] unless positive and finite.
    pub fn set_wear_cycles(&mut self, cycles: f64) -> Result<(), Error> {
        if !(cycles.is_finite() && cycles > 0.0) {
            return Err(Error::NotPositive { name: "wear_cycles", value: cycles });
        }
        self.history.wear_cycles = cycles;
        Ok(())
    }
}
