//! The rotation of an obstacle in the tangent.
//!
//! Energy does not change when both sides of a pair turn together. So with the gradient g and its derivative K at the nodes
//! of the body, which lie at r from the position of the obstacle, and at its translation, and a rotation of the obstacle
//! about its position,
//!
//! ```text
//! ∂w/∂θ = −Σ_a r_a × g_a      ∂²w/∂θ∂x_b = −Σ_a [r_a]ₓ K_ab + [g_b]ₓ      ∂²w/∂θ² = −sym Σ_a [r_a]ₓ ∂²w/∂x_a∂θ
//! ```
//!
//! where a runs over nodes, and b over nodes and the translation.

use crate::Error;
use crate::contact::laws::{Answer, Measured};
use crate::contact::tangents::{RankOne, Tangent, TangentPart};
use crate::geometry::cross_matrix;
use crate::overlap::{Block, Partner};
use std::collections::BTreeMap;

type Matrix<const D: usize> = [[f64; D]; D];

/// Adds the rotation of its obstacle, of so many, to the tangent of a pair, whose gradient is known.
///
/// # Errors
/// [`Error::Unsupported`] for a local law: its lines do not turn along, so that its energy changes as both sides turn.
pub(crate) fn add_rotation<const D: usize>(
    measured: &Measured<D>,
    answer: &mut Answer<D>,
    part: TangentPart,
    obstacle_count: usize,
) -> Result<(), Error> {
    let (Partner::Obstacle(obstacle), Some(tangent), Some(energy)) =
        (measured.pair.partners[1], answer.tangent.take(), &answer.energy)
    else {
        return Ok(());
    };
    let (coords, Some(pose)) = (measured.pair.coords, measured.pair.pose) else { return Ok(()) };
    let number = (coords.len() + obstacle_count + obstacle) as u32;
    let gradient = energy.nodes.iter().zip(&energy.gradient).map(|(&node, g)| (node, (*g).into()));
    if measured.law.is_local() {
        return Err(Error::Unsupported { what: "the rotation of obstacles in the tangent with the law fiber" });
    }
    let mut gradient: Vec<(u32, [f64; D])> = gradient.collect();
    let of_obstacle = std::array::from_fn(|i| -gradient.iter().map(|(_, g)| g[i]).sum::<f64>());
    gradient.push((measured.obstacle_node(), of_obstacle));
    if part == TangentPart::Semidefinite {
        // What turns the force can be of either sign.
        gradient.clear();
    }
    let arm = |node: u32| -> Option<[f64; D]> {
        coords.get(node as usize).map(|x| std::array::from_fn(|i| x[i] - pose.position[i]))
    };
    answer.tangent = Some(with_rotation(tangent, arm, &gradient, number));
    Ok(())
}

/// `arm` leads to a node of the mesh.
fn with_rotation<const D: usize>(
    mut tangent: Tangent<D>,
    arm: impl Fn(u32) -> Option<[f64; D]>,
    gradient: &[(u32, [f64; D])],
    number: u32,
) -> Tangent<D> {
    let place = |node: u32| arm(node).map(|arm| cross_matrix(&arm));
    // ∂²w/∂θ∂x, by node.
    let mut rows: BTreeMap<u32, Matrix<D>> = BTreeMap::new();
    for (node, g) in gradient {
        add(rows.entry(*node).or_insert([[0.0; D]; D]), 1.0, &cross_matrix(g));
    }
    for block in &tangent.blocks {
        if let Some(cross) = place(block.row) {
            add(rows.entry(block.col).or_insert([[0.0; D]; D]), -1.0, &product(&cross, &block.value));
        }
    }
    let mut own = [[0.0; D]; D];
    for (&node, row) in &rows {
        if let Some(cross) = place(node) {
            let product = product(&cross, &transposed(row));
            add(&mut own, -0.5, &product);
            add(&mut own, -0.5, &transposed(&product));
        }
    }
    for RankOne { nodes, vector, .. } in &mut tangent.rank_one {
        let mut along = [0.0; D];
        for (cross, g) in nodes.iter().zip(&*vector).filter_map(|(&node, g)| Some((place(node)?, g))) {
            along.iter_mut().zip(cross).for_each(|(sum, row)| *sum -= (0..D).map(|j| row[j] * g[j]).sum::<f64>());
        }
        nodes.push(number);
        vector.push(along);
    }
    let down = rows.iter().map(|(&row, value)| Block { row, col: number, value: transposed(value) });
    let across = rows.iter().map(|(&col, value)| Block { row: number, col, value: *value });
    let blocks = down.chain(across).chain([Block { row: number, col: number, value: own }]).collect();
    Tangent::sum(vec![tangent, Tangent { blocks, rank_one: Vec::new() }])
}

fn add<const D: usize>(sum: &mut Matrix<D>, factor: f64, value: &Matrix<D>) {
    sum.as_flattened_mut().iter_mut().zip(value.as_flattened()).for_each(|(sum, x)| *sum += factor * x);
}

fn product<const D: usize>(a: &Matrix<D>, b: &Matrix<D>) -> Matrix<D> {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..D).map(|k| a[i][k] * b[k][j]).sum()))
}

fn transposed<const D: usize>(a: &Matrix<D>) -> Matrix<D> {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}
