//! What the curvature of a profile that is not quadratic adds to the second derivative.
//!
//! ```text
//! ∫_{A∩B} φ''(g_A + g_B) { (∇g_B·v_B) ∇g_A·(w_A − w_B) + (∇g_A·v_A) ∇g_B·(w_B − w_A) } dx
//! ```
//!
//! Along with the motion w_B of B, where −∫ φ' ∇g_B·v_B dx is otherwise what it is with φ' = 1/2, g_B stays, and g_A changes
//! by ∇g_A·(w_B − w_A); and the same the other way round.

use super::line_sums::{LineSums, Span};
use crate::geometry::cells::Cells;
use crate::overlap::depth::cell_pieces::CellPieces;
use crate::overlap::depth_integral::DepthProfile;
use crate::overlap::points::block_sum::{BlockSum, product};

/// Adds it; `of` are the pieces of both sides, those of a body with itself once.
pub(super) fn add_curvature<const D: usize>(
    cells: &Cells,
    of: &[CellPieces<D>],
    sums: &[LineSums<D>],
    (profile, per_length): (DepthProfile, f64),
    hessian: &mut BlockSum<D>,
) {
    // A line in two pieces is a span of either, one after the other: without a clearance none is left out.
    let mut both: Vec<[&Span; 2]> =
        sums.iter().flat_map(|sum| sum.spans.chunks_exact(2)).map(|s| [&s[0], &s[1]]).collect();
    both.sort_by_key(|spans| spans.map(|span| span.piece));
    let mut values = Vec::new();
    for of_two in both.chunk_by(|p, q| p.map(|span| span.piece) == q.map(|span| span.piece)) {
        let pieces = of_two[0].map(|span| &of[usize::from(span.of_b)].pieces[span.piece as usize]);
        let counts = pieces.map(|piece| cells.nodes(piece.cell as usize).len());
        let nodes: Vec<u32> = pieces.iter().flat_map(|piece| cells.nodes(piece.cell as usize)).copied().collect();
        let mut products = vec![0.0; nodes.len() * nodes.len()];
        for spans in of_two {
            let mut at_points = Vec::new();
            spans[0].for_each_point(|at, s, part| at_points.push((*at, per_length * part * profile.curvature(s))));
            let mut point = at_points.iter();
            spans[1].for_each_point(|of_second, _, _| {
                let Some((of_first, factor)) = point.next() else { return };
                let of_nodes = [pieces[0].at_nodes(of_first), pieces[1].at_nodes(of_second)];
                let shapes = || (0..2).flat_map(|side| of_nodes[side].into_iter().take(counts[side]));
                for (row, a) in products.chunks_exact_mut(nodes.len()).zip(shapes()) {
                    row.iter_mut().zip(shapes()).for_each(|(sum, b)| *sum += factor * a * b);
                }
            });
        }
        let side = |n: usize| usize::from(n >= counts[0]);
        values.clear();
        for (number, factor) in products.iter().enumerate() {
            let [row, col] = [number / nodes.len(), number % nodes.len()].map(side);
            let factor = if row == col { -factor } else { *factor };
            values.push(product(factor, &pieces[row].gradient, &pieces[1 - row].gradient));
        }
        hessian.add_square(&nodes, &values);
    }
}
