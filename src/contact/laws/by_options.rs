//! From the options to the law.

use super::depth_law::DepthLaw;
use super::energy_law::EnergyLaw;
use super::fiber_law::FiberLaw;
use super::pair_law::PairLaw;
use super::volume_law::VolumeLaw;

/// The law as pairs of bodies follow it.
pub(crate) fn pair_law<const D: usize>(law: &EnergyLaw) -> Box<dyn PairLaw<D>> {
    match law {
        EnergyLaw::Volume { .. } => Box::new(VolumeLaw(*law)),
        EnergyLaw::Depth { stiffness } => Box::new(DepthLaw { stiffness: *stiffness }),
        EnergyLaw::Fiber(law) => Box::new(FiberLaw(*law)),
    }
}
