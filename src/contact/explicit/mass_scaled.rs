//! How stiff a contact is against masses: M^(−1/2) K M^(−1/2), whose largest eigenvalue is the squared frequency.

use super::lanczos::{Accuracy, largest_eigenvalue, random_start};
use crate::Error;
use crate::contact::tangents::{RankOne, Tangent};
use crate::overlap::Block;

/// Largest step of central differences, 2/√λ with λ a bound of the largest eigenvalue of M⁻¹K; infinite where no
/// eigenvalue is positive. `masses` are those of the nodes; what K has beyond them, obstacles, is held.
///
/// # Errors
/// [`Error::NotPositiveMass`] for a node with a row in K; [`Error::Overflow`] for stiffness per mass beyond a double.
pub(crate) fn largest_step<const D: usize>(tangent: &Tangent<D>, masses: &[f64]) -> Result<f64, Error> {
    let nodes = nodes_with_stiffness(tangent, masses.len());
    let mut scales = Vec::with_capacity(nodes.len());
    for &node in &nodes {
        let mass = masses[node as usize];
        // Infinity is a mass: that of a node which the host holds.
        if mass.is_nan() || mass <= 0.0 {
            return Err(Error::NotPositiveMass { node: node as usize, value: mass });
        }
        scales.push(1.0 / mass.sqrt());
    }
    let place = |node: u32| nodes.binary_search(&node).ok();
    let mut scaled = Tangent::<D>::default();
    for block in &tangent.blocks {
        let (Some(row), Some(col)) = (place(block.row), place(block.col)) else { continue };
        let value = block.value.map(|values| values.map(|value| value * scales[row] * scales[col]));
        scaled.blocks.push(Block { row: row as u32, col: col as u32, value });
    }
    for part in &tangent.rank_one {
        let mut one = RankOne { factor: part.factor, nodes: Vec::new(), vector: Vec::new() };
        for (&node, vector) in part.nodes.iter().zip(&part.vector) {
            let Some(place) = place(node) else { continue };
            one.nodes.push(place as u32);
            one.vector.push(vector.map(|value| value * scales[place]));
        }
        scaled.rank_one.push(one);
    }
    let size = largest_entry(&scaled);
    if !size.is_finite() {
        return Err(Error::Overflow { quantity: "contact stiffness per mass", value: size });
    }
    if size == 0.0 {
        return Ok(f64::INFINITY);
    }
    // With a largest entry of 1 nothing overflows on the way to the eigenvalue.
    scaled.blocks.iter_mut().flat_map(|block| block.value.as_flattened_mut()).for_each(|value| *value /= size);
    scaled.rank_one.iter_mut().for_each(|part| part.factor /= size);
    let eigenvalue = largest_eigenvalue(random_start::<D>(nodes.len()), Accuracy::Bound, |x| scaled.product(x));
    let eigenvalue = eigenvalue.ok_or(Error::Overflow { quantity: "contact stiffness per mass", value: f64::NAN })?;
    Ok(if eigenvalue > 0.0 { 2.0 / (size.sqrt() * eigenvalue.sqrt()) } else { f64::INFINITY })
}

/// Nodes below `node_count` whose row is not zero, ascending.
fn nodes_with_stiffness<const D: usize>(tangent: &Tangent<D>, node_count: usize) -> Vec<u32> {
    let is_zero = |values: &[f64]| values.iter().all(|value| *value == 0.0);
    let rows = tangent.blocks.iter().filter(|block| !is_zero(block.value.as_flattened())).map(|block| block.row);
    let parts = tangent.rank_one.iter().flat_map(|part| part.nodes.iter().zip(&part.vector));
    let of_parts = parts.filter(|(_, vector)| !is_zero(vector.as_slice())).map(|(node, _)| *node);
    let mut nodes: Vec<u32> = rows.chain(of_parts).filter(|node| (*node as usize) < node_count).collect();
    nodes.sort_unstable();
    nodes.dedup();
    nodes
}

/// Size of the largest entry, rank-one parts by themselves. Not finite where an entry is not.
fn largest_entry<const D: usize>(tangent: &Tangent<D>) -> f64 {
    let of_blocks = tangent.blocks.iter().flat_map(|block| block.value.as_flattened()).map(|value| value.abs());
    let of_parts = tangent.rank_one.iter().map(|part| {
        let largest = part.vector.as_flattened().iter().fold(0.0f64, |m, g| m.max(g.abs()));
        part.factor.abs() * largest * largest
    });
    let mut largest = 0.0;
    for size in of_blocks.chain(of_parts) {
        if !size.is_finite() {
            return size;
        }
        largest = f64::max(largest, size);
    }
    largest
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two masses on a spring: the frequency is √(k (1/m + 1/M)), and 5 % more of its square is taken.
    #[test]
    fn two_masses_on_a_spring() {
        let block = |row, col, k| Block { row, col, value: [[k, 0.0], [0.0, 0.0]] };
        let spring = |k: f64| Tangent::<2> {
            blocks: vec![block(1, 1, k), block(1, 4, -k), block(4, 1, -k), block(4, 4, k)],
            rank_one: Vec::new(),
        };
        let exact = |k: f64, inverse: f64| 2.0 / (k * inverse * 1.05).sqrt();
        let masses = [0.0, 2.0, f64::NAN, -1.0, 3.0];
        for k in [4.0, 1e-300, 1e300] {
            let found = largest_step(&spring(k), &masses).expect("positive masses");
            assert!((found / exact(k, 1.0 / 2.0 + 1.0 / 3.0) - 1.0).abs() < 1e-12, "{found}");
        }
        // A node that is held, and one that is an obstacle.
        let held = largest_step(&spring(4.0), &[0.0, 2.0, 0.0, 0.0, f64::INFINITY]).expect("a node is held");
        let obstacle = largest_step(&spring(4.0), &[0.0, 2.0, 0.0, 0.0]).expect("an obstacle");
        assert!((held / exact(4.0, 0.5) - 1.0).abs() < 1e-12 && (obstacle / held - 1.0).abs() < 1e-12);
        assert_eq!(largest_step(&Tangent::<3>::default(), &[]), Ok(f64::INFINITY));
        // No eigenvalue is positive but for rounding.
        let pushed = largest_step(&spring(-4.0), &masses).expect("positive masses");
        assert!(pushed > 1e4 * exact(4.0, 1.0 / 2.0 + 1.0 / 3.0), "{pushed}");
        let refused = largest_step(&spring(4.0), &[0.0, 2.0, 0.0, 0.0, -1.0]);
        assert_eq!(refused, Err(Error::NotPositiveMass { node: 4, value: -1.0 }));
        let beyond = largest_step(&spring(1e300), &[0.0, 1e-300, 0.0, 0.0, 1.0]);
        assert!(matches!(beyond, Err(Error::Overflow { .. })), "{beyond:?}");
    }
}
