//! Prescribed displacements.

use std::ops::Range;

/// Displacements that are prescribed: some axes of some nodes.
#[derive(Clone, Debug, PartialEq)]
pub struct Constraints<const D: usize> {
    /// Constrained degrees of freedom as node, axis and value, ascending.
    entries: Vec<(u32, u8, f64)>,
}

impl<const D: usize> Default for Constraints<D> {
    fn default() -> Self {
        Self { entries: Vec::new() }
    }
}

impl<const D: usize> Constraints<D> {
    /// Prescribes the displacement of `nodes` along `axis`; a later value replaces an earlier one.
    ///
    /// # Panics
    /// If there is no such axis.
    pub fn prescribe(&mut self, nodes: impl IntoIterator<Item = usize>, axis: usize, value: f64) {
        assert!(axis < D, "axis {axis} in {D}D");
        for node in nodes {
            let key = (node as u32, axis as u8);
            match self.entries.binary_search_by_key(&key, |entry| (entry.0, entry.1)) {
                Ok(at) => self.entries[at].2 = value,
                Err(at) => self.entries.insert(at, (key.0, key.1, value)),
            }
        }
    }

    /// Holds `nodes` along all axes.
    pub fn fix(&mut self, nodes: impl IntoIterator<Item = usize> + Clone) {
        (0..D).for_each(|axis| self.prescribe(nodes.clone(), axis, 0.0));
    }

    /// Constrained degrees of freedom as node, axis and value, by node, then axis.
    pub fn iter(&self) -> impl Iterator<Item = (usize, usize, f64)> {
        self.entries.iter().map(|&(node, axis, value)| (node as usize, axis as usize, value))
    }

    /// Whether nothing is prescribed.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// Whether the displacement of `node` along `axis` is prescribed.
    pub fn contains(&self, node: usize, axis: usize) -> bool {
        self.entries.binary_search_by_key(&(node as u32, axis as u8), |entry| (entry.0, entry.1)).is_ok()
    }

    /// Sets the prescribed components of `displacement`.
    pub fn apply(&self, displacement: &mut [[f64; D]]) {
        self.iter().for_each(|(node, axis, value)| displacement[node][axis] = value);
    }

    /// Sets the constrained components of `vector` (force, velocity) to zero.
    pub fn clear(&self, vector: &mut [[f64; D]]) {
        self.iter().for_each(|(node, axis, _)| vector[node][axis] = 0.0);
    }

    /// Sum of the constrained components of `force` over `nodes`: what the supports of these nodes carry, if `force` is
    /// the internal less the external force.
    pub fn reaction(&self, force: &[[f64; D]], nodes: Range<usize>) -> [f64; D] {
        let mut sum = [0.0; D];
        self.iter()
            .filter(|(node, ..)| nodes.contains(node))
            .for_each(|(node, axis, _)| sum[axis] += force[node][axis]);
        sum
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn prescribed_components_are_set_and_others_kept() {
        let mut held = Constraints::<2>::default();
        held.prescribe([3, 1], 1, 0.5);
        held.fix([0]);
        held.prescribe([1], 1, -0.25);
        let mut u = vec![[1.0; 2]; 4];
        held.apply(&mut u);
        assert_eq!(u, [[0.0, 0.0], [1.0, -0.25], [1.0, 1.0], [1.0, 0.5]]);
        held.clear(&mut u);
        assert_eq!(u, [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [1.0, 0.0]]);
        assert!(held.contains(3, 1) && !held.contains(3, 0));
        assert_eq!(held.reaction(&[[1.0, 2.0], [3.0, 4.0], [5.0, 6.0], [7.0, 8.0]], 0..2), [1.0, 6.0]);
    }
}
