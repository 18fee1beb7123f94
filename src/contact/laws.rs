//! Contact laws: from the overlap of a pair, or from its contact points, to its energy.

#[cfg(test)]
mod constant_pressure;
mod depth_law;
mod energy_law;
mod fiber_law;
mod momentum_correction;
mod pair_energy;
mod pair_law;
mod pair_tangent;
mod penetration_law;
mod pressure_point;
mod stiffness;
mod volume_law;

pub use energy_law::EnergyLaw;
pub(super) use pair_energy::PairEnergy;
pub(super) use pair_law::{Answer, Asked, FoundPatches, Measured, PairLaw};
pub use penetration_law::{EnergyProfile, PenetrationLaw};
pub(super) use pressure_point::{PointOnSide, PressurePoint};
pub use stiffness::{StiffnessFrom, suggest_fiber_stiffness, suggest_stiffness};

use depth_law::DepthLaw;
use fiber_law::FiberLaw;
use volume_law::VolumeLaw;

/// The law as pairs of bodies follow it.
pub(super) fn pair_law<const D: usize>(law: &EnergyLaw) -> Box<dyn PairLaw<D>> {
    match law {
        EnergyLaw::Volume { .. } => Box::new(VolumeLaw(*law)),
        EnergyLaw::Depth { stiffness } => Box::new(DepthLaw { stiffness: *stiffness }),
        EnergyLaw::Fiber(law) => Box::new(FiberLaw(*law)),
    }
}
