//! What every contact law can be asked for a pair of bodies.

use super::pair_energy::PairEnergy;
use crate::Error;
use crate::contact::tangent::{Tangent, TangentPart};
use crate::overlap::{ContactPoints, NodalSum, Overlap, OverlapEstimator, Pair, Partner, Patches, Reach, find_patches};
use std::collections::BTreeMap;
use std::sync::Mutex;

/// Energy of a pair and its derivatives. A new law is a type of this kind, and its line in
/// `by_options.rs`.
pub(crate) trait PairLaw<const D: usize>: Send + Sync {
    /// Energy and its gradient, or `None` where the sides are apart.
    fn energy(&self, measured: &Measured<D>) -> Result<Option<PairEnergy<D>>, Error>;

    /// Second derivative of the energy; the translation of the pair's obstacle has the number `obstacle_node`.
    fn tangent(
        &self,
        measured: &Measured<D>,
        part: TangentPart,
        obstacle_node: u32,
    ) -> Result<Option<Tangent<D>>, Error>;

    /// Both, from one measurement where they can share it, with the bits of each alone.
    fn energy_and_tangent(
        &self,
        measured: &Measured<D>,
        part: TangentPart,
        obstacle_node: u32,
    ) -> Result<EnergyAndTangent<D>, Error> {
        Ok((self.energy(measured)?, self.tangent(measured, part, obstacle_node)?))
    }

    /// Energy, and of a law that acts at contact points their sums at the nodes, from one measurement.
    fn energy_and_nodal_sums(&self, measured: &Measured<D>) -> Result<Option<EnergyAndSums<D>>, Error> {
        Ok(self.energy(measured)?.map(|energy| (energy, None)))
    }

    /// The overlap on which the law stands.
    fn overlap(&self, measured: &Measured<D>) -> Result<Option<Overlap<D>>, Error>;

    /// Whether it acts at contact points, along the directions of patches.
    fn is_local(&self) -> bool;

    /// Whether it asks how deep the cells of bodies lie below their surfaces.
    fn needs_depth(&self) -> bool {
        false
    }

    /// Pressure where the penetration is given; of a law whose pressure follows it.
    fn pressure_at(&self, _penetration: f64) -> f64 {
        0.0
    }
}

/// Energy with its gradient, and its second derivative, each `None` where the sides are apart.
pub(crate) type EnergyAndTangent<const D: usize> = (Option<PairEnergy<D>>, Option<Tangent<D>>);

/// Energy with its gradient, and sums at the nodes where there are contact points.
pub(crate) type EnergyAndSums<const D: usize> = (PairEnergy<D>, Option<Vec<NodalSum>>);

/// Patches that were found at the coordinates in force, by pair.
#[derive(Default)]
pub(crate) struct FoundPatches<const D: usize>(Mutex<BTreeMap<[Partner; 2], Option<Patches<D>>>>);

/// A pair, and how it is measured.
pub(crate) struct Measured<'a, const D: usize> {
    pub(crate) pair: &'a Pair<'a, D>,
    /// The law that the pair follows.
    pub(crate) law: &'a dyn PairLaw<D>,
    pub(crate) estimator: &'a dyn OverlapEstimator<D>,
    /// Patches that are kept during a solve.
    pub(crate) kept: Option<&'a Patches<D>>,
    pub(crate) found: &'a FoundPatches<D>,
}

impl<const D: usize> Measured<'_, D> {
    /// Contact points on the kept patches, or on those that are found now; `None` where the sides are apart.
    pub(crate) fn contact_points(&self, derivative: bool) -> Result<Option<ContactPoints<D>>, Error> {
        let points = match self.kept {
            Some(patches) => self.estimator.contact_points(self.pair, patches, derivative)?,
            None => match self.patches(Reach::Region)? {
                Some(patches) => self.estimator.contact_points(self.pair, &patches, derivative)?,
                None => None,
            },
        };
        Ok(points.filter(|points| !points.points.is_empty() || !points.warnings.is_empty()))
    }

    /// The patches of the pair here, or `None` where it does not touch.
    pub(crate) fn patches(&self, reach: Reach) -> Result<Option<Patches<D>>, Error> {
        let key = self.pair.partners;
        // A signed distance function may have changed since, without a word.
        let is_kept = reach == Reach::Region && !self.pair.counterpart.is_marched();
        // A lock that a panicking thread has left holds nothing half done: entries are inserted whole.
        let lock = || self.found.0.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        if is_kept && let Some(found) = lock().get(&key) {
            return Ok(found.clone());
        }
        let samples = self.estimator.samples(self.pair)?;
        let patches = find_patches(self.pair, &samples, reach)?;
        if is_kept {
            lock().insert(key, patches.clone());
        }
        Ok(patches)
    }
}
