//! Planes of symmetry, as supports make them.

use super::Bodies;
use std::collections::BTreeSet;

/// Part of the size of all bodies up to which a node lies in a plane: files have seven digits.
const IN_PLANE: f64 = 1e-6;

/// Planes x, y or z = const that bound all bodies but rigid surfaces, all of whose faces are held across them: each by a point and a normal. Nothing can come
/// to such faces from behind, so they are no surface that contact could press. `held` are the nodes and axes that never move. None at all
/// where a body would have no surface left.
pub(super) fn planes<const D: usize>(bodies: Bodies<D>, held: &BTreeSet<(usize, usize)>) -> Vec<[[f64; D]; 2]> {
    let (coords, count) = (bodies.model.coords(), bodies.model.parts().len());
    let all: Vec<Vec<Vec<u32>>> = (0..count)
        .map(|part| bodies.model.faces_where(part, |_| true).into_iter().map(|face| face.nodes).collect())
        .collect();
    let ends = |axis: usize| {
        // Rigid surfaces may go on beyond a plane.
        let solid =
            (0..count).filter(|&part| !bodies.places.is_layer[part]).flat_map(|part| bodies.model.nodes_of(part));
        let along = solid.map(|node| coords[node][axis]);
        along.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], x| [low.min(x), high.max(x)])
    };
    let size = (0..D).map(|axis| ends(axis)[1] - ends(axis)[0]).fold(0.0, f64::max);
    let is_in = |nodes: &[u32], axis: usize, at: f64| {
        nodes.iter().all(|&node| (coords[node as usize][axis] - at).abs() <= IN_PLANE * size)
    };
    let mut found: Vec<(usize, f64)> = Vec::new();
    // Cylinders are no planes, and the axis of bodies of revolution the library knows.
    let first = usize::from(bodies.model.is_axisymmetric());
    for axis in first..D {
        for at in ends(axis) {
            let mut faces = all.iter().flatten().filter(|nodes| is_in(nodes, axis, at)).peekable();
            let is_held = |nodes: &Vec<u32>| nodes.iter().all(|&node| held.contains(&(node as usize, axis)));
            if faces.peek().is_some() && faces.all(is_held) {
                found.push((axis, at));
            }
        }
    }
    let is_surface = |nodes: &Vec<u32>| !found.iter().any(|&(axis, at)| is_in(nodes, axis, at));
    if !all.iter().all(|faces| faces.iter().any(is_surface)) {
        return Vec::new();
    }
    let plane = |(axis, at)| {
        let along = |value| std::array::from_fn(|k| if k == axis { value } else { 0.0 });
        [along(at), along(1.0)]
    };
    found.into_iter().map(plane).collect()
}
