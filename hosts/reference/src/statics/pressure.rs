//! Pressure on the contact surface.

use crate::fem::{Face, Model};
use std::collections::BTreeMap;

/// Pressure at a node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodalPressure<const D: usize> {
    /// Node.
    pub node: usize,
    /// Where it was, undeformed.
    pub place: [f64; D],
    /// Its part of the undeformed surface, seen along its force; 0 where it has none of its own, at the corners of triangles and
    /// of quadrilaterals of eight nodes of second order, and on the axis of bodies of revolution for edges of second order.
    pub area: f64,
    /// Force by area, Pa, positive where it presses.
    pub pressure: f64,
}

/// Pressures of the nodes of a part on which contact forces act: the force by the node's part of the surface, that is
/// ∫ N_a p dA by ∫ N_a dA.
///
/// At the corners of triangles and of quadrilaterals of eight nodes of second order ∫ N_a dA vanishes or is negative, and on the axis of bodies of revolution for edges of
/// second order: there is no such mean. They have that of the middles of the edges about them.
///
/// A face counts as far as it looks against the force, so that the sides of a block add nothing to its edges. Everything is
/// per undeformed area, as in linear theory.
pub fn nodal_pressures<const D: usize>(model: &Model<D>, part: usize, forces: &[[f64; D]]) -> Vec<NodalPressure<D>> {
    let size = |node: usize| forces[node].iter().map(|f| f * f).sum::<f64>().sqrt();
    let mut areas = vec![0.0; model.node_count()];
    let faces = model.faces_where(part, |_| true);
    for face in &faces {
        // ∫ N_a n dA of this face alone.
        let normals = model.surface_load(std::slice::from_ref(face), |_, normal| *normal);
        for &node in &face.nodes {
            let (node, size) = (node as usize, size(node as usize));
            let against: f64 = forces[node].iter().zip(&normals[node]).map(|(f, n)| -f * n).sum();
            areas[node] += (against / size.max(f64::MIN_POSITIVE)).max(0.0);
        }
    }
    let corners = corners_without_area(model, &faces, |node| (size(node), areas[node]));
    let pressure = |node: usize| {
        let (area, pressure) = match corners.get(&node) {
            Some(&pressure) => (0.0, pressure?),
            None if areas[node] > 0.0 => (areas[node], size(node) / areas[node]),
            None => return None,
        };
        (pressure > 0.0).then_some(NodalPressure { node, place: model.coords()[node], area, pressure })
    };
    model.nodes_of(part).filter_map(pressure).collect()
}

/// Pressures along an axis on the side of a part that contact pushes against: force along the axis by ∫ N_a n dA along it, over
/// the faces that look that way rather than another. Nodes without contact have the pressure 0.
pub fn nodal_tractions<const D: usize>(
    model: &Model<D>,
    part: usize,
    forces: &[[f64; D]],
    axis: usize,
) -> Vec<NodalPressure<D>> {
    let nodes = model.nodes_of(part);
    let sense: f64 = forces[nodes.clone()].iter().map(|force| force[axis]).sum();
    let faces = model.faces_where(part, |_| true);
    // Within 60° of the axis.
    let areas = model.surface_load(&faces, |_, normal| {
        let along = -normal[axis] * sense.signum();
        std::array::from_fn(|i| if i == axis && along > 0.5 { along } else { 0.0 })
    });
    let force = |node: usize| (forces[node][axis] * sense.signum()).max(0.0);
    let corners = corners_without_area(model, &faces, |node| (force(node), areas[node][axis]));
    let pressure = |node: usize| {
        let (area, pressure) = match corners.get(&node) {
            Some(&pressure) => (0.0, pressure?),
            None if areas[node][axis] > 0.0 => (areas[node][axis], force(node) / areas[node][axis]),
            None => return None,
        };
        Some(NodalPressure { node, place: model.coords()[node], area, pressure })
    };
    nodes.filter_map(pressure).collect()
}

/// Corners of the faces at which ∫ N_a dA is no area, with the pressure of the middles of the edges about them: force by area of
/// `at`, summed; none where no such middle has any.
fn corners_without_area<const D: usize>(
    model: &Model<D>,
    faces: &[Face],
    at: impl Fn(usize) -> (f64, f64),
) -> BTreeMap<usize, Option<f64>> {
    let mut sums: BTreeMap<usize, (f64, f64)> = BTreeMap::new();
    let mut add = |corner: u32, middle: u32| {
        let (sum, (force, area)) = (sums.entry(corner as usize).or_default(), at(middle as usize));
        if area > 0.0 {
            (sum.0, sum.1) = (sum.0 + force, sum.1 + area);
        }
    };
    let is_on_axis = |node: u32| model.is_axisymmetric() && model.coords()[node as usize][0] == 0.0;
    for Face { nodes, .. } in faces {
        match (D, nodes.len()) {
            (2, 3) => nodes[..2].iter().filter(|corner| is_on_axis(**corner)).for_each(|corner| add(*corner, nodes[2])),
            (3, 6 | 8) => {
                let (corners, middles) = nodes.split_at(nodes.len() / 2);
                for (k, &corner) in corners.iter().enumerate() {
                    let last = middles[(k + corners.len() - 1) % corners.len()];
                    [middles[k], last].into_iter().for_each(|middle| add(corner, middle));
                }
            }
            _ => {}
        }
    }
    sums.into_iter().map(|(node, (force, area))| (node, (area > 0.0).then(|| force / area))).collect()
}
