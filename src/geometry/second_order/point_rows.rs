//! The points of a division as combinations of the nodes of their cell.

use super::entities::Entities;

/// κ: how much farther from its chord the point of an edge is than the node in its middle.
const RISE: f64 = 4.0 / 3.0;

/// The weights of nodes at a point that is no corner; `local` are the points before it, and `given` is its own node.
///
/// A tensor product in each case: of the edge's weights −1/6, 4/3, −1/6 where there is a node in every middle, else of their
/// serendipity part, linear ones and κ times the bubbles of the edges.
pub(super) fn row(entities: &Entities, point: usize, local: &[u32], given: Option<u32>) -> Vec<(u32, f64)> {
    let aside = (1.0 - RISE) / 2.0;
    let corners = entities.around(point);
    let nodes = |points: &[usize], weight: f64| points.iter().map(|&p| (local[p], weight)).collect::<Vec<_>>();
    let between = |corners: &[usize]| {
        let mut middles = Vec::new();
        for (k, &p) in corners.iter().enumerate() {
            for &q in &corners[..k] {
                let middle = entities.between(p, q);
                let is_edge = (entities.corners..entities.corners + entities.edges.len()).contains(&middle);
                middles.extend(is_edge.then_some(middle));
            }
        }
        middles
    };
    let rows = match (corners.len(), given) {
        (2, Some(node)) => vec![nodes(&corners, aside), vec![(node, RISE)]],
        (4, None) => vec![nodes(&corners, 0.25 - RISE / 2.0), nodes(&between(&corners), RISE / 2.0)],
        (4, Some(node)) => {
            vec![nodes(&corners, aside * aside), nodes(&between(&corners), RISE * aside), vec![(node, RISE * RISE)]]
        }
        (_, None) => vec![nodes(&corners, 0.125 - 3.0 * RISE / 8.0), nodes(&between(&corners), RISE / 4.0)],
        (_, Some(node)) => {
            let first = entities.corners + entities.edges.len();
            let faces: Vec<usize> = (first..first + entities.quads.len()).collect();
            vec![
                nodes(&corners, aside * aside * aside),
                nodes(&between(&corners), RISE * aside * aside),
                nodes(&faces, RISE * RISE * aside),
                vec![(node, RISE * RISE * RISE)],
            ]
        }
    };
    rows.concat()
}
