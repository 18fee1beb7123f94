//! What every contact law can be asked for a pair of bodies.

use super::pair_energy::PairEnergy;
use super::pressure_point::PressurePoint;
use crate::Error;
use crate::contact::tangents::{Tangent, TangentPart};
use crate::overlap::normal_lines::estimate as normal_lines;
use crate::overlap::{
    ContactPoints, NodalSums, Overlap, Pair, PairEstimator, Partner, Patches, Reach, SecondDerivative, find_patches,
};
use std::collections::BTreeMap;
use std::sync::Mutex;

/// Energy of a pair and its derivatives. A new law is a type of this kind, and its line in `laws.rs`.
pub(crate) trait PairLaw<const D: usize>: Send + Sync {
    /// What is asked for, from one measurement; what is asked for beside changes no bit of any part. `None` where the
    /// sides are apart.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for a part that the law does not have.
    fn measure(&self, measured: &Measured<D>, asked: &Asked) -> Result<Option<Answer<D>>, Error>;

    /// The overlap on which the law stands.
    fn overlap(&self, measured: &Measured<D>) -> Result<Option<Overlap<D>>, Error>;

    /// Whether it acts at contact points, along the directions of patches.
    fn is_local(&self) -> bool;

    /// Whether it asks how deep the cells of bodies lie below their surfaces.
    fn needs_depth(&self) -> bool {
        false
    }

    /// Its pressure at a penetration; `None` where that is one for the whole pair.
    fn pressure(&self, _penetration: f64) -> Option<f64> {
        None
    }

    /// The stiffness of its pressure at a first touch, per penetration, where it has one.
    fn initial_stiffness(&self) -> Option<f64> {
        None
    }
}

/// What is asked of a law.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Asked {
    /// Energy and its gradient.
    pub(crate) energy: bool,
    /// Its second derivative.
    pub(crate) tangent: Option<TangentPart>,
    /// Sums at the nodes, of a law that presses point by point.
    pub(crate) nodal_sums: bool,
    /// The points at which it presses.
    pub(crate) points: bool,
    /// These for friction: also of a law that has one pressure for the whole pair, which then presses everywhere.
    pub(crate) slides: bool,
    /// The rotation of the obstacle in the tangent, which needs the gradient.
    pub(crate) rotations: bool,
    /// The part of frictional forces that grows with their limits.
    pub(crate) limited: bool,
    /// What interfaces hold alone, with all surfaces apart.
    pub(crate) apart: bool,
}

impl Asked {
    /// Which second derivatives of the overlap that takes.
    pub(crate) fn second_derivative(&self) -> SecondDerivative {
        match self.tangent {
            None => SecondDerivative::No,
            Some(TangentPart::Full | TangentPart::Symmetric) => SecondDerivative::Full,
            Some(TangentPart::Semidefinite) => SecondDerivative::Semidefinite,
        }
    }
}

/// What a law answers: the parts that were asked for.
pub(crate) struct Answer<const D: usize> {
    pub(crate) energy: Option<PairEnergy<D>>,
    pub(crate) tangent: Option<Tangent<D>>,
    pub(crate) nodal_sums: Option<NodalSums>,
    /// Empty for a law that has one pressure for the whole pair, but for friction.
    pub(crate) points: Vec<PressurePoint<D>>,
}

/// Patches that were found at the coordinates in force, by pair.
#[derive(Default)]
pub(crate) struct FoundPatches<const D: usize>(Mutex<BTreeMap<[Partner; 2], Option<Patches<D>>>>);

/// A pair, and how it is measured.
pub(crate) struct Measured<'a, const D: usize> {
    pub(crate) pair: &'a Pair<'a, D>,
    /// The law that the pair follows.
    pub(crate) law: &'a dyn PairLaw<D>,
    pub(crate) estimator: &'a PairEstimator<D>,
    /// Patches that are kept during a solve.
    pub(crate) kept: Option<&'a Patches<D>>,
    pub(crate) found: &'a FoundPatches<D>,
}

impl<const D: usize> Measured<'_, D> {
    /// The number of the translation of the pair's obstacle, if it has one, in tangents.
    pub(crate) fn obstacle_node(&self) -> u32 {
        let obstacle = if let Partner::Obstacle(obstacle) = self.pair.partners[1] { obstacle } else { 0 };
        (self.pair.coords.len() + obstacle) as u32
    }

    /// Contact points on the kept patches, or on those that are found now; `None` where the sides are apart.
    pub(crate) fn contact_points(&self, derivative: bool) -> Result<Option<ContactPoints<D>>, Error> {
        let points = match self.kept {
            Some(patches) => normal_lines::contact_points(self.estimator, self.pair, patches, derivative)?,
            None => match self.patches(Reach::Region)? {
                Some(patches) => normal_lines::contact_points(self.estimator, self.pair, &patches, derivative)?,
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
        let samples = normal_lines::samples(self.estimator, self.pair)?;
        let patches = find_patches(self.pair, &samples, reach)?;
        if is_kept {
            lock().insert(key, patches.clone());
        }
        Ok(patches)
    }
}
