//! Sizes of facets, and whether they are curved.

use super::Bodies;
use fmc_solid::fem::Face;

/// Corners of a facet by the number of its nodes.
pub(crate) fn corner_count<const D: usize>(node_count: usize) -> usize {
    match (D, node_count) {
        (2, _) => 2,
        (_, 3 | 6) => 3,
        _ => 4,
    }
}

/// Area of a facet between its corners, in 2D its length: `nodes` are its nodes, corners first.
pub(crate) fn area<const D: usize>(coords: &[[f64; D]], nodes: &[u32]) -> f64 {
    let between = |p: usize, q: usize| -> [f64; 3] {
        let [p, q] = [p, q].map(|k| coords[nodes[k] as usize]);
        std::array::from_fn(|axis| q.get(axis).zip(p.get(axis)).map_or(0.0, |(q, p)| q - p))
    };
    let length = |v: [f64; 3]| v.iter().map(|x| x * x).sum::<f64>().sqrt();
    let cross =
        |a: [f64; 3], b: [f64; 3]| [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    match corner_count::<D>(nodes.len()) {
        2 => length(between(0, 1)),
        3 => 0.5 * length(cross(between(0, 1), between(0, 2))),
        _ => 0.5 * length(cross(between(0, 2), between(1, 3))),
    }
}

/// Part of the length of an edge by which its middle node lies beside the middle of its corners, so that it is curved: files have seven digits.
const CURVED: f64 = 1e-6;

/// Whether a body has faces of second order that are not flat between straight edges.
pub(super) fn has_curved_faces<const D: usize>(bodies: Bodies<D>, body: usize) -> bool {
    let coords = bodies.model.coords();
    let is_curved = |face: &Face| {
        let count = corner_count::<D>(face.nodes.len());
        let edges = if D == 2 { 1 } else { count };
        (0..edges).any(|edge| {
            let Some(&middle) = face.nodes.get(count + edge) else { return false };
            let [p, q, x] =
                [face.nodes[edge], face.nodes[(edge + 1) % count], middle].map(|node| coords[node as usize]);
            let [off, long] = [|p: f64, q, x| x - 0.5 * (p + q), |p: f64, q, _| q - p]
                .map(|of: fn(f64, f64, f64) -> f64| (0..D).map(|k| of(p[k], q[k], x[k]).powi(2)).sum::<f64>().sqrt());
            off > CURVED * long
        })
    };
    bodies.model.faces_where(body, |_| true).iter().any(is_curved)
}

#[cfg(test)]
mod tests {
    use super::area;

    #[test]
    fn facets_have_their_area() {
        let coords = [[0.0, 0.0, 1.0], [2.0, 0.0, 1.0], [2.0, 3.0, 1.0], [0.0, 3.0, 1.0]];
        assert_eq!(area(&coords, &[0, 1, 2, 3]), 6.0);
        assert_eq!(area(&coords, &[0, 1, 2]), 3.0);
        assert_eq!(area(&[[0.0, 0.0], [3.0, 4.0]], &[0, 1]), 5.0);
    }
}
