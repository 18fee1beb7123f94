//! Discs and half-discs.
//!
//! Triangles lie in concentric rings of near-equal edges. Quadrilaterals lie in an O-grid: a square in the middle and
//! blocks from its sides to the circle.
//!
//! ```text
//!        .--*--.          half: the part above the dots,
//!      *  \ . /  *        its flat side on the x axis
//!     |   +---+   |
//!     | · | · | · |
//!     |   +---+   |
//!      *  /   \  *
//!        '--*--'
//! ```

use crate::polygon::on_circle;
use crate::{Mesh, patch_quad4};

/// Corners of the middle square of the O-grid, as a fraction of the radius along the axes: cells of the middle and of
/// the blocks around it are then of like size.
const SQUARE: f64 = 0.42;

/// Disc about the origin in triangles, with `edges ≥ 3` edges on the circle.
pub fn disc_tri3(radius: f64, edges: usize) -> Mesh<2> {
    rings(radius, edges, 1.0)
}

/// Upper half of a disc in triangles, with `edges ≥ 2` edges on its arc and the flat side on the x axis.
pub fn half_disc_tri3(radius: f64, edges: usize) -> Mesh<2> {
    rings(radius, edges, 0.5)
}

/// Triangles from the first node, in the middle, to every edge of a closed polygon that it sees: `edges` cells.
pub fn fan_tri3(centre: [f64; 2], polygon: &Mesh<2>) -> Mesh<2> {
    let coords = std::iter::once(centre).chain(polygon.coords.iter().copied()).collect();
    let conn = polygon.facets().iter().flat_map(|e| [0, e[0] + 1, e[1] + 1]).collect();
    Mesh { coords, conn, nodes_per_cell: 3 }
}

/// Disc about the origin in quadrilaterals, with `edges` edges on the circle, a multiple of 4.
pub fn disc_quad4(radius: f64, edges: usize) -> Mesh<2> {
    assert!(edges.is_multiple_of(4) && edges > 0, "{edges} edges do not go round four blocks");
    let n = edges / 4;
    let a = SQUARE * radius;
    let mut mesh = patch_quad4([n, n], |u, v| [a * (2.0 * u - 1.0), a * (2.0 * v - 1.0)]);
    for k in 0..4 {
        let turn = 0.25 * k as f64;
        mesh.append(&sector(radius, n, n, turn - 0.125, turn + 0.125));
    }
    mesh.welded(1e-9 * radius)
}

/// Upper half of a disc in quadrilaterals, with `edges` edges on its arc, a multiple of 4, the flat side on the x axis.
pub fn half_disc_quad4(radius: f64, edges: usize) -> Mesh<2> {
    assert!(edges.is_multiple_of(4) && edges > 0, "{edges} edges do not go round four blocks");
    let n = edges / 4;
    let a = SQUARE * radius;
    let mut mesh = patch_quad4([2 * n, n], |u, v| [a * (2.0 * u - 1.0), a * v]);
    mesh.append(&sector(radius, n, n, 0.0, 0.125));
    mesh.append(&sector(radius, n, 2 * n, 0.125, 0.375));
    mesh.append(&sector(radius, n, n, 0.375, 0.5));
    mesh.welded(1e-9 * radius)
}

/// Block from the middle square to the arc between two fractions of a turn.
fn sector(radius: f64, layers: usize, edges: usize, from: f64, to: f64) -> Mesh<2> {
    let on_square = |turn: f64| {
        let x = on_circle(1.0, turn);
        x.map(|c| c * SQUARE * radius / x[0].abs().max(x[1].abs()))
    };
    let (a, b) = (on_square(from), on_square(to));
    patch_quad4([layers, edges], |u, v| {
        let outer = on_circle(radius, from + v * (to - from));
        std::array::from_fn(|i| (1.0 - u) * (a[i] + v * (b[i] - a[i])) + u * outer[i])
    })
}

/// Rings about the centre, ring k of K with k/K of the outer edges, joined by strips of triangles.
fn rings(radius: f64, edges: usize, turn: f64) -> Mesh<2> {
    let closed = turn == 1.0;
    assert!(edges >= if closed { 3 } else { 2 }, "{edges} edges do not make a disc");
    // As many rings as make their distance the length of an edge.
    let ring_count = ((edges as f64 / (std::f64::consts::TAU * turn)).round() as usize).max(1);
    let least = if closed { 3 } else { 2 };
    let mut mesh = Mesh { coords: vec![[0.0; 2]], conn: Vec::new(), nodes_per_cell: 3 };
    let mut inner = Ring { first: 0, edges: 0, closed };
    for ring in 1..=ring_count {
        let edges = (edges * ring).div_ceil(ring_count).max(least);
        let outer = Ring { first: mesh.coords.len() as u32, edges, closed };
        let r = radius * ring as f64 / ring_count as f64;
        let nodes = if closed { edges } else { edges + 1 };
        mesh.coords.extend((0..nodes).map(|k| on_circle(r, turn * k as f64 / edges as f64)));
        // The end of a half-disc's arc lies on the x axis, not a rounding error off it.
        if !closed {
            mesh.coords.last_mut().unwrap()[1] = 0.0;
        }
        inner.join(&outer, &mut mesh.conn);
        inner = outer;
    }
    mesh
}

/// Nodes `first, first + 1, …` on a circle; the last edge of a closed ring ends at the first node.
struct Ring {
    first: u32,
    edges: usize,
    closed: bool,
}

impl Ring {
    fn node(&self, k: usize) -> u32 {
        self.first + if self.closed && k == self.edges { 0 } else { k as u32 }
    }

    /// Triangles between this ring and the next, always advancing on the one that lags behind.
    fn join(&self, outer: &Ring, conn: &mut Vec<u32>) {
        let (mut i, mut k) = (0, 0);
        while i < self.edges || k < outer.edges {
            // Middle of the next edge, inner against outer, as fractions of the arc.
            let outer_first = (2 * k + 1) * self.edges.max(1) <= (2 * i + 1) * outer.edges;
            if k < outer.edges && (i == self.edges || outer_first) {
                conn.extend([self.node(i), outer.node(k), outer.node(k + 1)]);
                k += 1;
            } else {
                conn.extend([self.node(i), outer.node(k), self.node(i + 1)]);
                i += 1;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::regular_polygon;
    use std::f64::consts::{PI, TAU};

    #[test]
    fn discs_fill_their_polygon() {
        for edges in [4, 12, 40, 100] {
            let area = 4.5 * edges as f64 * (TAU / edges as f64).sin();
            let fan = fan_tri3([0.0; 2], &regular_polygon(edges, 3.0));
            for mesh in [disc_tri3(3.0, edges), disc_quad4(3.0, edges), fan] {
                check(&mesh, area, edges);
            }
        }
        check(&disc_tri3(3.0, 7), 4.5 * 7.0 * (TAU / 7.0).sin(), 7);
    }

    #[test]
    fn half_discs_fill_their_polygon() {
        for edges in [4, 12, 40, 100] {
            let area = 4.5 * edges as f64 * (PI / edges as f64).sin();
            for mesh in [half_disc_tri3(3.0, edges), half_disc_quad4(3.0, edges)] {
                let flat = mesh
                    .boundary_faces()
                    .iter()
                    .filter(|f| f.iter().all(|&n| mesh.coords[n as usize][1] < 1e-9))
                    .count();
                check(&mesh, area, edges + flat);
            }
        }
    }

    fn check(mesh: &Mesh<2>, area: f64, boundary_edges: usize) {
        assert!((mesh.measure() / area - 1.0).abs() < 1e-13, "{} instead of {area}", mesh.measure());
        assert!(mesh.smallest_jacobian() > 0.0);
        assert_eq!(mesh.euler_characteristic(), 1);
        assert_eq!(mesh.boundary().cell_count(), boundary_edges);
    }
}
