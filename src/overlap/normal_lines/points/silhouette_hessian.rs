//! Second derivatives at the edges of notches: see [`SilhouettePoint`].

use super::contact_points::ContactPoints;
use super::edge_terms::SilhouettePoint;
use super::end_motion::for_each_node;
use super::hessian::OfLength;
use crate::geometry::Vector;
use crate::overlap::pair::sides::Pair;
use crate::overlap::sums::block_sum::BlockSum;

impl<const D: usize> ContactPoints<D> {
    /// Adds what one point of a notch's edge contributes, given ψ and ψ'.
    pub(crate) fn add_silhouette(
        &self,
        pair: &Pair<D>,
        silhouette: &SilhouettePoint<D>,
        [value, slope]: [OfLength; 2],
        obstacle_node: u32,
        sum: &mut BlockSum<D>,
    ) {
        // ∇J at a fixed line, by node.
        let mut gradient: Vec<(u32, Vector<D>)> = Vec::new();
        let (mut jump, mut as_one) = (0.0, 0.0);
        for span in &silhouette.spans {
            let whole = pair.weight_between(&span.ends);
            as_one += if whole > 0.0 { span.weight / whole * value(span.length) } else { 0.0 };
            let Some(ends) = self.end_motions(pair, span, obstacle_node) else { return };
            jump += span.weight * value(span.length);
            for end in &ends {
                let along = end.m * (end.sign * span.weight * slope(span.length));
                let aside = end.eta * (span.across * value(span.length));
                let weights = end.weights_of(&span.ends);
                for (corner, weight) in weights.iter().enumerate().take(end.corner_count()) {
                    gradient.extend(end.nodes(corner).map(|(node, part)| (node, (along - aside) * (part * weight))));
                }
            }
        }
        let mut of_line = -gradient.iter().fold(Vector::<D>::zeros(), |sum, (_, g)| sum + g);
        if !pair.weighting.is_plain() {
            // What does not change as all of it moves as one is the length of the spans, not their weight.
            of_line += pair.weighting.gradient() * as_one;
        }
        let mut of_anchors: Vec<Vec<(u32, f64)>> = Vec::new();
        for (anchor, weight) in &silhouette.weights {
            let mut nodes = Vec::new();
            for_each_node(pair, *anchor, obstacle_node, |node, part| nodes.push((node, part * weight)));
            of_anchors.push(nodes);
        }
        let swept: Vec<(u32, f64)> = of_anchors.iter().flatten().copied().collect();
        gradient.extend(swept.iter().map(|&(node, weight)| (node, of_line * (0.5 * weight))));
        let mut add = |row: u32, col: u32, value: [[f64; D]; D]| sum.add(row, col, &value);
        for (row, g) in &gradient {
            for &(col, weight) in &swept {
                let a = silhouette.across * weight;
                add(*row, col, std::array::from_fn(|i| std::array::from_fn(|j| g[i] * a[j])));
                add(col, *row, std::array::from_fn(|i| std::array::from_fn(|j| a[i] * g[j])));
            }
        }
        if let ([first, second], [u, v]) = (&of_anchors[..], &silhouette.axes) {
            // Without the weights N: the two ends of the edge.
            let ends = [first, second].map(|nodes| {
                let total: f64 = nodes.iter().map(|(_, part)| part).sum();
                nodes.iter().map(move |&(node, part)| (node, part / total)).collect::<Vec<_>>()
            });
            for &(p, of_p) in &ends[0] {
                for &(q, of_q) in &ends[1] {
                    let factor = jump * silhouette.turn * of_p * of_q;
                    let turn = |i: usize, j: usize| factor * (u[i] * v[j] - v[i] * u[j]);
                    add(p, q, std::array::from_fn(|i| std::array::from_fn(|j| -turn(i, j))));
                    add(q, p, std::array::from_fn(|i| std::array::from_fn(|j| turn(i, j))));
                }
            }
        }
    }
}
