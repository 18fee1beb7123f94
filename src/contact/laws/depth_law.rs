//! w = k/2 ∫ over the overlap of g_A + g_B, the depths below both surfaces: no direction, no patches, and an energy
//! without a step wherever corners, edges and whole bodies go.

use super::pair_energy::PairEnergy;
use super::pair_law::{EnergyAndSums, EnergyAndTangent, Measured, PairLaw};
use crate::Error;
use crate::contact::tangent::{Tangent, TangentPart};
use crate::overlap::{DepthIntegral, NodalSum, Overlap, SecondDerivative};

/// The depth law.
pub(super) struct DepthLaw {
    pub(super) stiffness: f64,
}

impl DepthLaw {
    fn energy_of<const D: usize>(&self, depth: DepthIntegral<D>) -> PairEnergy<D> {
        let k = self.stiffness;
        PairEnergy {
            energy: k * depth.value,
            pressure: k * depth.mean_depth,
            nodes: depth.nodes,
            gradient: depth.gradient.into_iter().map(|g| g * k).collect(),
            of_b: depth.of_b,
            pose_gradient: depth.pose_gradient.map(|pose| pose.scaled(k)),
            overlap: depth.overlap,
        }
    }

    fn tangent_of<const D: usize>(&self, depth: &mut DepthIntegral<D>) -> Tangent<D> {
        let mut blocks = std::mem::take(&mut depth.hessian);
        blocks.iter_mut().flat_map(|block| block.value.iter_mut().flatten()).for_each(|x| *x *= self.stiffness);
        Tangent { blocks, rank_one: Vec::new() }
    }
}

fn second(part: TangentPart) -> SecondDerivative {
    match part {
        TangentPart::Full => SecondDerivative::Full,
        TangentPart::Semidefinite => SecondDerivative::Semidefinite,
    }
}

impl<const D: usize> PairLaw<D> for DepthLaw {
    fn energy(&self, measured: &Measured<D>) -> Result<Option<PairEnergy<D>>, Error> {
        let depth = measured.estimator.depth_integral(measured.pair, SecondDerivative::No, 0)?;
        Ok(depth.map(|depth| self.energy_of(depth)))
    }

    fn tangent(
        &self,
        measured: &Measured<D>,
        part: TangentPart,
        obstacle_node: u32,
    ) -> Result<Option<Tangent<D>>, Error> {
        let depth = measured.estimator.depth_integral(measured.pair, second(part), obstacle_node)?;
        Ok(depth.map(|mut depth| self.tangent_of(&mut depth)))
    }

    fn energy_and_tangent(
        &self,
        measured: &Measured<D>,
        part: TangentPart,
        obstacle_node: u32,
    ) -> Result<EnergyAndTangent<D>, Error> {
        let Some(mut depth) = measured.estimator.depth_integral(measured.pair, second(part), obstacle_node)? else {
            return Ok((None, None));
        };
        let tangent = self.tangent_of(&mut depth);
        Ok((Some(self.energy_of(depth)), Some(tangent)))
    }

    /// With the forces on inner nodes at the surface above them; the pressure of a point of a facet is k times its depth.
    fn energy_and_nodal_sums(&self, measured: &Measured<D>) -> Result<Option<EnergyAndSums<D>>, Error> {
        let Some(mut depth) = measured.estimator.depth_integral(measured.pair, SecondDerivative::No, 0)? else {
            return Ok(None);
        };
        depth.bring_to_surface(measured.pair);
        let mut sums = Vec::with_capacity(D * depth.facets.len());
        depth.for_each_share(measured.pair, |node, area, penetration| {
            sums.push(NodalSum { node, area, pressure: self.stiffness * penetration, penetration });
        });
        Ok(Some((self.energy_of(depth), Some(sums))))
    }

    /// The volume of the overlap and its gradient, as the law `volume` has them.
    fn overlap(&self, measured: &Measured<D>) -> Result<Option<Overlap<D>>, Error> {
        Ok(measured.estimator.overlap(measured.pair)?.filter(Overlap::has_content))
    }

    fn is_local(&self) -> bool {
        false
    }

    fn needs_depth(&self) -> bool {
        true
    }

    fn pressure_at(&self, penetration: f64) -> f64 {
        self.stiffness * penetration
    }
}
