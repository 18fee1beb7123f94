//! Stars.
//!
//! Every tip is meshed alike, from its tip T to the centre C, between its two inner corners L and R. A kite of p × p
//! cells stands at the tip, a strip of rows of 2p cells follows, another kite ends at the centre:
//!
//! ```text
//!            T
//!           / \          kite: T, its point p on TL, M_p, its point p on TR
//!          /\ /\
//!         |  M_p|        rows k = p … n from point k on TL by M_k to point k on TR,
//!         |\ | /|        M_k evenly on the axis from M_p to M_n
//!         | \|/ |
//!         |  M_n|
//!         L/   \R        kite: C, R, M_n, L
//!          \   /
//!            C
//! ```
//!
//! That makes 2pn cells per tip, with n edges on each side of the star.

use crate::polygon::on_circle;
use crate::{Mesh, quadrilateral_quad4};

/// Star in quadrilaterals: `tips` tips on radius `outer`, the first on the x axis, inner corners on radius `inner`.
///
/// Each side has `side_edges` edges (n above) and each tip is `2·half_width` cells wide (p above, with n > 2p).
/// `star_quad4(4, 0.1, 0.03, 12, 2)` has 192 cells and 241 nodes.
pub fn star_quad4(tips: usize, outer: f64, inner: f64, side_edges: usize, half_width: usize) -> Mesh<2> {
    let (n, p) = (side_edges, half_width);
    assert!(tips >= 3 && p >= 1 && n > 2 * p, "a star of {tips} tips with {n} edges a side, {p} to the axis");
    let tip = spike(tips, outer, inner, n, p);
    let mut mesh = tip.clone();
    for k in 1..tips {
        mesh.append(&tip.clone().rotated(std::f64::consts::TAU * k as f64 / tips as f64));
    }
    mesh.welded(1e-9 * outer)
}

/// The same in triangles, every quadrilateral cut along its shorter diagonal.
pub fn star_tri3(tips: usize, outer: f64, inner: f64, side_edges: usize, half_width: usize) -> Mesh<2> {
    star_quad4(tips, outer, inner, side_edges, half_width).triangulated()
}

/// The tip on the x axis.
fn spike(tips: usize, outer: f64, inner: f64, n: usize, p: usize) -> Mesh<2> {
    let [foot, half] = on_circle(inner, 0.5 / tips as f64);
    let depth = outer - foot; // along the axis from T to the line LR
    assert!(depth > 0.0, "the inner corners lie outside the tips");
    // Point k on the upper side TL, and its mirror image on TR.
    let left = |k: usize| [outer - depth * k as f64 / n as f64, half * k as f64 / n as f64];
    let right = |k: usize| [left(k)[0], -left(k)[1]];
    // M_p lies beyond the line through the points p and M_n before the line LR, which makes both kites convex; M_n comes
    // after M_p because p/n < 1/2.
    let m_p = outer - 1.5 * depth * p as f64 / n as f64;
    let m_n = foot + (0.5 * foot).min(0.25 * depth);
    let middle = |k: usize| [m_p + (m_n - m_p) * (k - p) as f64 / (n - p) as f64, 0.0];

    let mut mesh = quadrilateral_quad4([[outer, 0.0], left(p), middle(p), right(p)], [p, p]);
    for k in p..n {
        mesh.append(&quadrilateral_quad4([left(k), left(k + 1), middle(k + 1), middle(k)], [1, p]));
        mesh.append(&quadrilateral_quad4([middle(k), middle(k + 1), right(k + 1), right(k)], [1, p]));
    }
    mesh.append(&quadrilateral_quad4([[0.0; 2], right(n), middle(n), left(n)], [p, p]));
    mesh
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::star_polygon;

    #[test]
    fn stars_fill_their_outline() {
        for (tips, inner, n, p) in [(4, 0.03, 12, 2), (10, 0.05, 8, 2), (3, 0.02, 3, 1), (5, 0.045, 20, 4)] {
            let area = star_polygon(tips, 0.1, inner, 1).measure();
            for mesh in [star_quad4(tips, 0.1, inner, n, p), star_tri3(tips, 0.1, inner, n, p)] {
                assert!((mesh.measure() / area - 1.0).abs() < 1e-13);
                assert!(mesh.smallest_jacobian() > 0.0);
                assert_eq!(mesh.euler_characteristic(), 1);
                assert_eq!(mesh.boundary().cell_count(), 2 * tips * n);
            }
        }
    }

    #[test]
    fn four_pointed_star_has_192_cells() {
        let mesh = star_quad4(4, 0.1, 0.03, 12, 2);
        assert_eq!((mesh.cell_count(), mesh.coords.len()), (192, 241));
    }
}
