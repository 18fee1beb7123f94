//! w = w(V): one traction for the whole pair.

use super::energy_law::EnergyLaw;
use super::momentum_correction::balance;
use super::pair_energy::PairEnergy;
use super::pair_law::{Answer, Asked, Measured, PairLaw};
use super::pressure_point::{PressurePoint, of_depth_points};
use crate::Error;
use crate::contact::tangents::Tangent;
use crate::overlap::volume::estimate as volume;
use crate::overlap::{DepthRequest, Overlap, SecondDerivative, depth_integral};

/// The volume law.
pub(super) struct VolumeLaw(pub(super) EnergyLaw);

impl VolumeLaw {
    /// The overlap with its imbalance put right.
    fn corrected<const D: usize>(overlap: Option<Overlap<D>>, measured: &Measured<D>) -> Option<Overlap<D>> {
        let mut overlap = overlap.filter(Overlap::has_content);
        if let (Some(o), Some(expected)) = (&mut overlap, volume::imbalance(measured.estimator, measured.pair)) {
            balance(o, measured.pair, expected);
        }
        overlap
    }

    /// Where the facets of either side lie inside the other, under the one pressure of the pair. That the pressure grows with
    /// the volume is left out: it would couple every point with every node.
    fn points<const D: usize>(
        &self,
        overlap: &Overlap<D>,
        measured: &Measured<D>,
    ) -> Result<Vec<PressurePoint<D>>, Error> {
        let (second, obstacle_node) = (SecondDerivative::No, measured.obstacle_node());
        let request = DepthRequest { second, obstacle_node, points: true };
        let Some(depth) = depth_integral(measured.pair, &request)? else { return Ok(Vec::new()) };
        let pressure = self.0.energy_gradient(overlap.volume);
        Ok(of_depth_points(depth.points, measured.pair, |_| pressure, |_| 0.0))
    }
}

impl<const D: usize> PairLaw<D> for VolumeLaw {
    fn measure(&self, measured: &Measured<D>, asked: &Asked) -> Result<Option<Answer<D>>, Error> {
        let (second, obstacle_node) = (asked.second_derivative(), measured.obstacle_node());
        let found = volume::overlap_and_hessian(measured.estimator, measured.pair, second, obstacle_node)?;
        let (overlap, blocks) = found.unzip();
        let of_tangent = overlap.as_ref().filter(|overlap| asked.tangent.is_some() && overlap.has_volume());
        let tangent =
            of_tangent.zip(blocks).map(|(overlap, blocks)| Tangent::of_volume(overlap, blocks, &self.0, obstacle_node));
        let points = match &overlap {
            Some(overlap) if asked.slides => self.points(overlap, measured)?,
            _ => Vec::new(),
        };
        let corrected = if asked.energy { Self::corrected(overlap, measured) } else { None };
        let energy = corrected.map(|overlap| PairEnergy::of_volume(overlap, &self.0));
        let is_empty = energy.is_none() && tangent.is_none() && points.is_empty();
        Ok((!is_empty).then_some(Answer { energy, tangent, nodal_sums: None, points }))
    }

    fn overlap(&self, measured: &Measured<D>) -> Result<Option<Overlap<D>>, Error> {
        Ok(Self::corrected(volume::overlap(measured.estimator, measured.pair)?, measured))
    }

    fn is_local(&self) -> bool {
        false
    }
}
