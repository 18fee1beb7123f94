//! Ties as equations.

use crate::scene::Scene;
use crate::{in_space, in_the_plane, tied};
use fmc_contact::Error;

/// Rows of weights that vanish for every linear displacement of both bodies together, and are the jumps of all others.
fn rows_are_jumps<const D: usize>(scenes: &[Scene<D>]) {
    for scene in scenes {
        let contact = tied(scene, 0.0);
        let rows = contact.tie_constraints().expect("equations");
        let count = contact.tie([0, 1]).expect("bodies").expect("a tie").count;
        assert_eq!(rows.row_starts.len(), count + 1);
        let wave = |node: usize, axis: usize| 0.01 * (1.3 * node as f64 + axis as f64).sin();
        let coords: Vec<[f64; D]> =
            (0..).zip(&scene.coords).map(|(node, x)| std::array::from_fn(|axis| x[axis] + wave(node, axis))).collect();
        let jumps = contact.tie_nodes(&coords).expect("nodes");
        for (row, node) in jumps.iter().enumerate() {
            let range = rows.row_starts[row]..rows.row_starts[row + 1];
            let at = |of: &dyn Fn(usize) -> f64| {
                rows.columns[range.clone()]
                    .iter()
                    .zip(&rows.weights[range.clone()])
                    .map(|(node, w)| w * of(*node as usize))
                    .sum::<f64>()
            };
            assert!(at(&|_| 1.0).abs() < 1e-12);
            for axis in 0..D {
                assert!(at(&|node| scene.coords[node][axis]).abs() < 1e-12);
                assert!((at(&|node| coords[node][axis]) - node.jump[axis]).abs() < 1e-12);
            }
        }
    }
}

#[test]
fn equations_are_the_jumps() {
    rows_are_jumps(&in_the_plane(0.0));
    rows_are_jumps(&in_space(0.0));
}

#[test]
fn a_gap_that_is_kept_has_none() {
    let scene = &in_the_plane(0.02)[0];
    let contact = tied(scene, 0.1);
    assert!((contact.tie([1, 0]).expect("bodies").expect("a tie").largest_gap - 0.02).abs() < 1e-12);
    assert!(matches!(contact.tie_constraints(), Err(Error::Unsupported { .. })));
}
