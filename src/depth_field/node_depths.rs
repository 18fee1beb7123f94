//! Depth of nodes.

use super::distances::Distances;
use crate::geometry::Vector;
use crate::geometry::mesh::cells::Cells;
use crate::geometry::mesh::hanging::HangingNode;

/// Cells between two looks at whether the work is to end.
pub(super) const CELLS_BETWEEN: usize = 256;

/// Depth of every node that a cell has, 0 on the surface of a body, and the facet that is nearest to it.
pub(super) fn node_depths<const D: usize>(
    cells: &Cells,
    coords: &[[f64; D]],
    surface_faces: &[u8],
    distances: &Distances<D>,
    check: &dyn Fn(),
) -> (Vec<f64>, Vec<u32>) {
    const UNSEEN: f64 = -1.0;
    let (mut depths, mut anchors) = (vec![UNSEEN; coords.len()], vec![0; coords.len()]);
    for cell in 0..cells.len() {
        for face in (0..8).filter(|face| surface_faces[cell] >> face & 1 == 1) {
            cells.face_nodes(cell, face).into_iter().for_each(|n| depths[n as usize] = 0.0);
        }
    }
    for cell in 0..cells.len() {
        if cell.is_multiple_of(CELLS_BETWEEN) {
            check();
        }
        let nodes = cells.nodes(cell);
        for &node in nodes {
            if depths[node as usize] != UNSEEN {
                continue;
            }
            // No farther than another node of the cell and the way there.
            let x = Vector::<D>::from(coords[node as usize]);
            let known = nodes.iter().map(|&n| (n as usize, depths[n as usize])).filter(|(_, depth)| *depth != UNSEEN);
            let limit =
                known.map(|(n, depth)| depth + (x - Vector::from(coords[n])).norm()).fold(f64::INFINITY, f64::min);
            let body = cells.body[cell] as usize;
            (depths[node as usize], anchors[node as usize]) = distances.of_point(body, &x, limit);
        }
    }
    follow_parents(cells, &mut depths);
    (depths, anchors)
}

/// Nodes in the middle of a larger cell's edge get the depth that this cell has there, so that depth does not jump between the
/// two: the mean of the ends. Where both ends lie on the surface and the edge does not, the larger cell has a point in its
/// middle, with the true depth, as the node has it.
fn follow_parents(cells: &Cells, depths: &mut [f64]) {
    // The ends may hang themselves: as often as nodes hang at most.
    for _ in 0..cells.hanging().len() {
        let mut has_changed = false;
        for HangingNode { node, parents } in cells.hanging() {
            let [p, q] = parents[..] else { continue };
            let mean = 0.5 * (depths[p as usize] + depths[q as usize]);
            if mean > 0.0 && depths[*node as usize] != mean {
                depths[*node as usize] = mean;
                has_changed = true;
            }
        }
        if !has_changed {
            break;
        }
    }
}
