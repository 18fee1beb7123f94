//! w = w(V): one traction for the whole pair.

use super::energy_law::EnergyLaw;
use super::pair_energy::PairEnergy;
use super::pair_law::{EnergyAndTangent, Measured, PairLaw};
use crate::Error;
use crate::contact::momentum_correction::balance;
use crate::contact::tangent::{Tangent, TangentPart};
use crate::overlap::Overlap;

/// The volume law.
pub(super) struct VolumeLaw(pub(super) EnergyLaw);

impl VolumeLaw {
    /// The overlap with its imbalance put right.
    fn corrected<const D: usize>(overlap: Option<Overlap<D>>, measured: &Measured<D>) -> Option<Overlap<D>> {
        let mut overlap = overlap.filter(Overlap::has_content);
        if let (Some(o), Some(expected)) = (&mut overlap, measured.estimator.imbalance_of_volume(measured.pair)) {
            balance(o, measured.pair, expected);
        }
        overlap
    }

    /// The tangent on the overlap as it was measured.
    fn tangent_of<const D: usize>(
        &self,
        overlap: Option<&Overlap<D>>,
        measured: &Measured<D>,
        part: TangentPart,
        obstacle_node: u32,
    ) -> Result<Option<Tangent<D>>, Error> {
        let Some(overlap) = overlap.filter(|overlap| overlap.volume > 0.0) else { return Ok(None) };
        let blocks = match part {
            TangentPart::Semidefinite => Vec::new(),
            TangentPart::Full => measured.estimator.volume_hessian(measured.pair, obstacle_node)?,
        };
        Ok(Some(Tangent::of_volume(overlap, blocks, &self.0, obstacle_node)))
    }
}

impl<const D: usize> PairLaw<D> for VolumeLaw {
    fn energy(&self, measured: &Measured<D>) -> Result<Option<PairEnergy<D>>, Error> {
        Ok(self.overlap(measured)?.map(|overlap| PairEnergy::of_volume(overlap, &self.0)))
    }

    fn tangent(
        &self,
        measured: &Measured<D>,
        part: TangentPart,
        obstacle_node: u32,
    ) -> Result<Option<Tangent<D>>, Error> {
        measured.estimator.check_tangent(measured.pair)?;
        let overlap = measured.estimator.overlap(measured.pair)?;
        self.tangent_of(overlap.as_ref(), measured, part, obstacle_node)
    }

    fn energy_and_tangent(
        &self,
        measured: &Measured<D>,
        part: TangentPart,
        obstacle_node: u32,
    ) -> Result<EnergyAndTangent<D>, Error> {
        measured.estimator.check_tangent(measured.pair)?;
        let overlap = measured.estimator.overlap(measured.pair)?;
        let tangent = self.tangent_of(overlap.as_ref(), measured, part, obstacle_node)?;
        let corrected = Self::corrected(overlap, measured);
        Ok((corrected.map(|overlap| PairEnergy::of_volume(overlap, &self.0)), tangent))
    }

    fn overlap(&self, measured: &Measured<D>) -> Result<Option<Overlap<D>>, Error> {
        Ok(Self::corrected(measured.estimator.overlap(measured.pair)?, measured))
    }

    fn is_local(&self) -> bool {
        false
    }
}
