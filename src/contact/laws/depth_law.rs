//! w = k/2 ∫ over the overlap of g_A + g_B, the depths below both surfaces: no direction, no patches, and an energy
//! without a step wherever corners, edges and whole bodies go.

use super::pair_energy::PairEnergy;
use super::pair_law::{Answer, Asked, Measured, PairLaw};
use super::pressure_point::of_depth_points;
use crate::Error;
use crate::contact::tangents::Tangent;
use crate::overlap::volume::estimate as volume;
use crate::overlap::{DepthIntegral, DepthRequest, NodalSum, NodalSums, Overlap, Pair, depth_integral};

/// The depth law.
pub(super) struct DepthLaw {
    /// k.
    pub(super) stiffness: f64,
}

impl DepthLaw {
    fn energy_of<const D: usize>(&self, depth: DepthIntegral<D>) -> PairEnergy<D> {
        let k = self.stiffness;
        PairEnergy {
            energy: k * depth.value,
            pressure: k * depth.mean_depth.max(0.0),
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

    /// The pressure of a point of a facet is k times its depth.
    fn nodal_sums<const D: usize>(&self, depth: &DepthIntegral<D>, pair: &Pair<D>) -> NodalSums {
        let mut sums = Vec::with_capacity(D * depth.facets.len());
        depth.for_each_share(pair, |node, area, penetration| {
            sums.push(NodalSum { node, area, pressure: self.stiffness * penetration, penetration });
        });
        NodalSums { sums, largest_pressure: self.stiffness * depth.overlap.penetration.max(0.0), is_exact: true }
    }
}

impl<const D: usize> PairLaw<D> for DepthLaw {
    /// With sums at the nodes, the forces on inner nodes come at the surface above them.
    fn measure(&self, measured: &Measured<D>, asked: &Asked) -> Result<Option<Answer<D>>, Error> {
        let (second, obstacle_node) = (asked.second_derivative(), measured.obstacle_node());
        let request = DepthRequest { second, obstacle_node, points: asked.points || asked.slides };
        let Some(mut depth) = depth_integral(measured.pair, &request)? else { return Ok(None) };
        let tangent = asked.tangent.map(|_| self.tangent_of(&mut depth));
        let pressure = |depth: f64| self.stiffness * depth.max(0.0);
        let derivative = |_| self.stiffness;
        let points = of_depth_points(std::mem::take(&mut depth.points), measured.pair, pressure, derivative);
        let nodal_sums = asked.nodal_sums.then(|| {
            depth.bring_to_surface(measured.pair);
            self.nodal_sums(&depth, measured.pair)
        });
        Ok(Some(Answer { energy: asked.energy.then(|| self.energy_of(depth)), tangent, nodal_sums, points }))
    }

    /// The volume of the overlap and its gradient, as the law `volume` has them.
    fn overlap(&self, measured: &Measured<D>) -> Result<Option<Overlap<D>>, Error> {
        Ok(volume::overlap(measured.estimator, measured.pair)?.filter(Overlap::has_content))
    }

    fn is_local(&self) -> bool {
        false
    }

    fn needs_depth(&self) -> bool {
        true
    }

    fn pressure(&self, penetration: f64) -> Option<f64> {
        Some(self.stiffness * penetration.max(0.0))
    }

    fn initial_stiffness(&self) -> Option<f64> {
        Some(self.stiffness)
    }
}
