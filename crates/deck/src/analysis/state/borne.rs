//! What supports and reference nodes bear.

use super::State;
use crate::analysis::follow::{self, Borne, Moved, ReferenceResult};
use crate::analysis::points::Freedom;
use crate::analysis::references::{Reference, Way};
use fmc_solid::statics::Equilibrium;

impl<const D: usize> State<D> {
    /// What nodes and reference nodes bear at the end of the step.
    pub(in crate::analysis) fn borne(&self, at: &Equilibrium<D>, is_finite: bool) -> Borne {
        let first = at.model().node_count();
        let one = |(number, reference): (usize, &Reference<D>)| {
            let value = |axis: usize| {
                self.forces.get(&(first + number, axis)).map_or(0.0, |(f, _)| f.at(self.end) / self.thickness)
            };
            let (lever, rotation) = (self.levers.get(&number), self.turned[number]);
            let applied = std::array::from_fn(value);
            let moved = Moved { lever, rotation, is_finite, applied };
            follow::result((number, reference), at, &moved).or_else(|| self.of_loose((number, reference), at, applied))
        };
        let results = self.references.iter().enumerate().filter_map(one).collect();
        let mut borne = follow::borne(&self.references, results, at, self.load_sum(first));
        for (number, reference) in self.references.iter().enumerate() {
            let Way::Local(axes) = &reference.way else { continue };
            for (i, axis) in axes.iter().enumerate() {
                let own = (first + number, i);
                if self.supports.contains_key(&own) {
                    let applied = self.forces.get(&own).map_or(0.0, |(f, _)| f.at(self.end) / self.thickness);
                    let force = self.handed_on(own, at) - applied;
                    (0..D).for_each(|k| borne.reactions[reference.nodes[0]][k] += force * axis[k]);
                }
            }
        }
        // What follows hands on what it bears; what is held bears it.
        for (&(place, axis), followed) in self.eliminated.range(..(first, 0)) {
            let lacking = at.balance().residual[place][axis];
            for (&(node, axis), weight) in followed.range(..(first, 0)) {
                if at.problem().supports.contains(node, axis) {
                    borne.reactions[node][axis] += weight * lacking;
                }
            }
        }
        borne
    }

    /// Sum of all forces at the end of the step: those on reference nodes as they are applied, since a moment that turns a node about a
    /// held place has forces on nodes that its support bears.
    fn load_sum(&self, node_count: usize) -> [f64; 3] {
        let mut forces = vec![[0.0; D]; node_count];
        self.spread.add_forces(self.end, &mut forces);
        let mut sum = [0.0; 3];
        forces.iter().for_each(|f| (0..D).for_each(|axis| sum[axis] += f[axis]));
        for (&(place, axis), (value, _)) in self.forces.iter().filter(|((_, axis), _)| *axis < D) {
            let value = value.at(self.end) / self.thickness;
            match place.checked_sub(node_count).map(|number| &self.references[number].way) {
                Some(Way::Local(axes)) => (0..D).for_each(|k| sum[k] += value * axes[axis][k]),
                _ => sum[axis] += value,
            }
        }
        sum
    }

    /// What a point beside the model bears of nodes that follow it.
    fn handed_on(&self, own: Freedom, at: &Equilibrium<D>) -> f64 {
        let followers = self.eliminated.range(..(at.model().node_count(), 0));
        let borne = followers.map(|(&(node, k), followed)| {
            followed.get(&own).map_or(0.0, |weight| weight * at.balance().residual[node][k])
        });
        borne.sum()
    }

    /// What holds a node of no element, and how it has moved, by the equations.
    fn of_loose(
        &self,
        (number, reference): (usize, &Reference<D>),
        at: &Equilibrium<D>,
        applied: [f64; 6],
    ) -> Option<ReferenceResult> {
        let Way::Loose(axes) = reference.way else { return None };
        let first = at.model().node_count();
        let held = |freedom: &Freedom| self.supports.get(freedom).map(|(value, _)| value.at(self.end));
        let (mut force, mut displacement) = ([0.0; 3], [0.0; 3]);
        for axis in (0..D).filter(|&axis| axes[axis]) {
            let own = (first + number, axis);
            if let Some(value) = held(&own) {
                (displacement[axis], force[axis]) = (value, self.handed_on(own, at) - applied[axis]);
            } else if let Some(followed) = self.eliminated.get(&own) {
                let value = |freedom: &Freedom| match freedom.0 < first {
                    true => at.displacement()[freedom.0][freedom.1],
                    false => held(freedom).unwrap_or(0.0),
                };
                displacement[axis] = followed.iter().map(|(freedom, weight)| weight * value(freedom)).sum();
            }
        }
        let Reference { label, own, .. } = *reference;
        Some(ReferenceResult { label, number, own, force, moment: [0.0; 3], displacement, rotation: [0.0; 3] })
    }
}
