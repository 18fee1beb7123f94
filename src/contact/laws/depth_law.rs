//! w = k/2 ∫ over the overlap of g_A + g_B, the depths below both surfaces: no direction, no patches, and an energy
//! without a step wherever corners, edges and whole bodies go. Other profiles are functions of that sum.

use super::energy_law::{EnergyLaw, FiberProfile};
use super::momentum_correction::correct;
use super::pair_energy::PairEnergy;
use super::pair_law::{Answer, Asked, Measured, PairLaw};
use super::pressure_point::of_depth_points;
use crate::Error;
use crate::contact::tangents::{Tangent, TangentPart};
use crate::overlap::{DepthIntegral, DepthProfile, DepthRequest, NodalSum, Overlap, Pair, SecondDerivative};

/// The depth law.
pub(super) struct DepthLaw(pub(super) EnergyLaw);

impl DepthLaw {
    fn stiffness(&self) -> f64 {
        if let EnergyLaw::Depth { stiffness, .. } = self.0 { stiffness } else { 0.0 }
    }

    fn profile(&self) -> DepthProfile {
        match self.0 {
            EnergyLaw::Depth { profile: FiberProfile::Linear { smoothing_length }, .. } => {
                DepthProfile::Linear { smoothing_length }
            }
            _ => DepthProfile::Quadratic,
        }
    }

    fn energy_of<const D: usize>(&self, depth: DepthIntegral<D>) -> PairEnergy<D> {
        let k = self.stiffness();
        PairEnergy {
            energy: k * depth.value,
            pressure: self.0.energy_gradient(depth.mean_depth),
            nodes: depth.nodes,
            gradient: depth.gradient.into_iter().map(|g| g * k).collect(),
            of_b: depth.of_b,
            pose_gradient: depth.pose_gradient.map(|pose| pose.scaled(k)),
            overlap: depth.overlap,
        }
    }

    fn tangent_of<const D: usize>(&self, depth: &mut DepthIntegral<D>) -> Tangent<D> {
        let mut blocks = std::mem::take(&mut depth.hessian);
        blocks.iter_mut().flat_map(|block| block.value.iter_mut().flatten()).for_each(|x| *x *= self.stiffness());
        Tangent { blocks, rank_one: Vec::new() }
    }

    /// The pressure of a point of a facet is k times its depth; with another profile, that of the mean depth of the facet's
    /// part of a node.
    fn nodal_sums<const D: usize>(&self, depth: &DepthIntegral<D>, pair: &Pair<D>) -> Vec<NodalSum> {
        let mut sums = Vec::with_capacity(D * depth.facets.len());
        depth.for_each_share(pair, |node, area, penetration| {
            let pressure = match self.profile() {
                DepthProfile::Quadratic => self.stiffness() * penetration,
                DepthProfile::Linear { .. } if area > 0.0 => area * self.0.energy_gradient(penetration / area),
                DepthProfile::Linear { .. } => 0.0,
            };
            sums.push(NodalSum { node, area, pressure, penetration });
        });
        sums
    }
}

fn second(part: Option<TangentPart>) -> SecondDerivative {
    match part {
        None => SecondDerivative::No,
        Some(TangentPart::Full | TangentPart::Symmetric) => SecondDerivative::Full,
        Some(TangentPart::Semidefinite) => SecondDerivative::Semidefinite,
    }
}

impl<const D: usize> PairLaw<D> for DepthLaw {
    /// With sums at the nodes, the forces on inner nodes come at the surface above them.
    fn measure(&self, measured: &Measured<D>, asked: &Asked) -> Result<Option<Answer<D>>, Error> {
        let (second, obstacle_node) = (second(asked.tangent), measured.obstacle_node());
        let profile = self.profile();
        let request = DepthRequest { profile, second, obstacle_node, points: asked.points || asked.slides };
        let Some(mut depth) = measured.estimator.depth_integral(measured.pair, &request)? else { return Ok(None) };
        if let Some(expected) = measured.estimator.imbalance_of_depth(measured.pair, profile) {
            let DepthIntegral { nodes, of_b, gradient, pose_gradient, overlap, .. } = &mut depth;
            overlap.warnings.extend(correct(nodes, of_b, gradient, pose_gradient, measured.pair, expected));
        }
        let tangent = asked.tangent.map(|_| self.tangent_of(&mut depth));
        let pressure = |depth| self.0.energy_gradient(depth);
        let derivative = |depth| self.0.energy_hessian(depth);
        let points = of_depth_points(std::mem::take(&mut depth.points), measured.pair, pressure, derivative);
        let nodal_sums = asked.nodal_sums.then(|| {
            depth.bring_to_surface(measured.pair);
            self.nodal_sums(&depth, measured.pair)
        });
        Ok(Some(Answer { energy: asked.energy.then(|| self.energy_of(depth)), tangent, nodal_sums, points }))
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

    fn initial_stiffness(&self) -> Option<f64> {
        Some(self.0.energy_hessian(0.0))
    }
}
