//! Pressure on the contact surface.

use crate::fem::Model;

/// Pressure at a node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NodalPressure<const D: usize> {
    /// Node.
    pub node: usize,
    /// Where it was, undeformed.
    pub place: [f64; D],
    /// Its part of the undeformed surface, seen along its force.
    pub area: f64,
    /// Force by area, Pa, positive where it presses.
    pub pressure: f64,
}

/// Pressures of the nodes of a part on which contact forces act: the force by the node's part of the surface, that is
/// ∫ N_a p dA by ∫ N_a dA.
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
    let touched = model.nodes_of(part).filter(|&node| size(node) > 0.0 && areas[node] > 0.0);
    let pressure = |node| NodalPressure {
        node,
        place: model.coords()[node],
        area: areas[node],
        pressure: size(node) / areas[node],
    };
    touched.map(pressure).collect()
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
    let touched = nodes.filter(|&node| areas[node][axis] > 0.0);
    let pressure = |node: usize| NodalPressure {
        node,
        place: model.coords()[node],
        area: areas[node][axis],
        pressure: (forces[node][axis] * sense.signum() / areas[node][axis]).max(0.0),
    };
    touched.map(pressure).collect()
}
