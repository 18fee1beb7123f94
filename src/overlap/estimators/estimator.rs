//! What every estimator can be asked for a pair of bodies.

use crate::Error;
use crate::overlap::normal_lines::patches::partition::Patches;
use crate::overlap::normal_lines::patches::sample::ContactSample;
use crate::overlap::normal_lines::points::contact_points::ContactPoints;
use crate::overlap::pair::fiber_trace::FiberTrace;
use crate::overlap::pair::overlap::Overlap;
use crate::overlap::pair::sides::Pair;
use crate::overlap::sums::block_sum::Block;

/// Measures the overlap of a pair. A new estimator is a type of this kind and its line in `by_options.rs`.
pub(crate) trait OverlapEstimator<const D: usize>: Send + Sync {
    /// Volume and its gradient, or `None` where the sides are apart.
    fn overlap(&self, pair: &Pair<D>) -> Result<Option<Overlap<D>>, Error>;

    /// The same with the second derivative of the volume, as blocks sorted by row and column; the translation of the pair's
    /// obstacle has the number `obstacle_node`. Empty where the volume is zero.
    fn overlap_and_hessian(&self, pair: &Pair<D>, obstacle_node: u32) -> Result<Option<WithHessian<D>>, Error>;

    /// Where the sides touch, for the search for patches; few samples are enough.
    fn samples(&self, pair: &Pair<D>) -> Result<Vec<ContactSample<D>>, Error>;

    /// Contact points along the directions of `patches`, or `None` where the sides are apart. `derivative` asks also
    /// for what only the second derivative of a local law needs.
    fn contact_points(
        &self,
        pair: &Pair<D>,
        patches: &Patches<D>,
        derivative: bool,
    ) -> Result<Option<ContactPoints<D>>, Error>;

    /// Distance between the lines along the directions of `patches`, where there are lines.
    fn spacing(&self, pair: &Pair<D>, patches: &Patches<D>) -> Result<Option<f64>, Error>;

    /// Whether the volume has a second derivative.
    ///
    /// # Errors
    /// [`Error::Unsupported`] if not.
    fn check_tangent(&self, pair: &Pair<D>) -> Result<(), Error>;

    /// Lines that cross the overlap, to look at; none where there are no lines.
    fn trace(&self, pair: &Pair<D>) -> Result<Vec<FiberTrace<D>>, Error>;

    /// What is expected of the balance of the forces of a volume law, which is put right; `None`: it is not.
    fn imbalance_of_volume(&self, pair: &Pair<D>) -> Option<Imbalance>;

    /// The same for a local law.
    fn imbalance_of_points(&self, pair: &Pair<D>) -> Option<Imbalance>;

    /// Whether obstacles with flat sides are to come as facets where they need not.
    fn prefers_facets(&self) -> bool;
}

/// An overlap and the second derivative of its volume.
pub(crate) type WithHessian<const D: usize> = (Overlap<D>, Vec<Block<D>>);

/// What is expected of ΣF and ΣM, in parts of the sizes of forces and of their moments.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Imbalance {
    /// Up to this the forces stay as they are.
    pub(crate) rounding: f64,
    /// From this on there is a warning.
    pub(crate) doubtful: f64,
}
