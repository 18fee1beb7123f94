//! Where a degree of freedom is, so that it can be fixed there.

use super::State;
use crate::analysis::Bodies;
use crate::analysis::points::Freedom;
use crate::analysis::references::Way;
use fmc_solid::statics::RigidMotion;

impl<const D: usize> State<D> {
    /// Its value at a displacement, the end of the last stage.
    pub(super) fn reached(&self, bodies: Bodies<D>, place: Freedom, displacement: &[[f64; D]]) -> f64 {
        let (first, axis) = (bodies.model.node_count(), place.1);
        let Some(number) = place.0.checked_sub(first) else { return displacement[place.0][axis] };
        let reference = &self.references[number];
        // What the step releases has been held until now.
        let held = |freedom: &Freedom| {
            let before = self.supports.get(freedom).or_else(|| self.released.get(freedom));
            before.map_or(0.0, |(value, _)| value.at(self.end))
        };
        match &reference.way {
            Way::Local(axes) => (0..D).map(|k| axes[axis][k] * displacement[reference.nodes[0]][k]).sum(),
            Way::Loose(_) => {
                let value = |(of, weight): (&Freedom, &f64)| match of.0 < first {
                    true => weight * displacement[of.0][of.1],
                    false => weight * held(of),
                };
                let followed = self.eliminated.get(&place);
                followed.map_or_else(|| held(&place), |followed| followed.iter().map(value).sum())
            }
            Way::Shares(_) => 0.0,
            Way::Follows(_) => {
                if let Some(lever) = self.levers.get(&number) {
                    return lever.motion(displacement)[axis];
                }
                let rotation = self.turned[number];
                let turn = RigidMotion { translation: [0.0; D], rotation };
                let (node, arm) = (reference.nodes[0], reference.arms[0]);
                let turned = if bodies.places.is_finite { turn.finite(arm) } else { turn.small(arm) };
                match axis {
                    3.. => rotation[axis - 3],
                    _ => displacement[node][axis] - turned[axis],
                }
            }
        }
    }
}
