//! Pieces of facets of one body that face a facet of another.

use crate::geometry::aabb::Aabb;
use crate::geometry::convex_piece::{Corners, Piece, place};
use crate::geometry::facet::{area_vector, determinant};
use crate::geometry::tree::Tree;
use crate::geometry::{Surface, Vector};

/// Cosine of the largest angle, 60°, between a normal and the reversed one of a facet that it faces.
const FACING: f64 = 0.5;

/// Part of a facet below which a piece is rounding.
const ROUNDING: f64 = 1e-14;

/// A piece of a facet, and the facet that it faces.
pub(super) struct CommonPiece<const D: usize> {
    /// Numbers of both facets in the surface.
    pub(super) facets: [usize; 2],
    /// Corners of the piece, in barycentric coordinates of the first facet.
    pub(super) corners: Corners<D>,
    /// Barycentric coordinates in the second facet, along the normal of the first, at the corners of the first facet.
    pub(super) across: [[f64; D]; D],
}

/// Facets of two bodies that come within reach of one another and face one another, ordered by the first.
pub(super) struct Facing<'a, const D: usize> {
    pub(super) surface: &'a Surface<D>,
    /// Positions of the surface's vertices.
    pub(super) vertices: &'a [Vector<D>],
    /// How far apart facets may be, or how far they may overlap.
    pub(super) reach: f64,
}

impl<const D: usize> Facing<'_, D> {
    pub(super) fn corners(&self, facet: usize) -> [Vector<D>; D] {
        self.surface.facets[facet].map(|vertex| self.vertices[vertex as usize])
    }

    /// Pairs of facets that may have a common piece.
    pub(super) fn candidates(&self, bodies: [usize; 2]) -> Vec<[usize; 2]> {
        let boxes = bodies.map(|body| {
            let facets = self.surface.ranges[body].clone();
            facets.map(|facet| Aabb::of(&self.corners(facet)).inflated(self.reach)).collect::<Vec<_>>()
        });
        let [first, second] = bodies.map(|body| self.surface.ranges[body].start);
        let mut found = Vec::new();
        Tree::new(&boxes[0]).visit_pairs(&Tree::new(&boxes[1]), [&boxes[0], &boxes[1]], |i, j| {
            found.push([first + i as usize, second + j as usize]);
        });
        found.retain(|&[here, there]| self.face(here, there));
        found.sort_unstable();
        found
    }

    fn face(&self, here: usize, there: usize) -> bool {
        let [n, m] = [here, there].map(|facet| area_vector(&self.corners(facet)));
        n.dot(&m) < -FACING * n.norm() * m.norm()
    }

    /// The piece of the first facet that faces the second within reach.
    pub(super) fn common(&self, facets: [usize; 2]) -> Option<CommonPiece<D>> {
        let [x, y] = facets.map(|facet| self.corners(facet));
        let n = area_vector(&x).try_normalize(0.0)?;
        let whole = seen(&y, &n);
        if whole == 0.0 {
            return None;
        }
        let across = x.map(|x| std::array::from_fn(|k| seen(&with(&y, k, x), &n) / whole));
        let mut piece = Piece::default();
        piece.reset();
        for k in 0..D {
            if !piece.cut(&across.map(|at: [f64; D]| -at[k])) {
                return None;
            }
        }
        let gap: [f64; D] = std::array::from_fn(|c| (place(&y, &across[c]) - x[c]).dot(&n));
        let is_within = piece.cut(&gap.map(|gap| gap - self.reach)) && piece.cut(&gap.map(|gap| -gap - self.reach));
        let size: f64 = if is_within { piece.moments().iter().sum() } else { 0.0 };
        let corners = piece.corners().iter().copied().collect();
        (size > ROUNDING).then_some(CommonPiece { facets, corners, across })
    }
}

/// What a facet with these corners measures, seen along n, up to a factor.
fn seen<const D: usize>(y: &[Vector<D>; D], n: &Vector<D>) -> f64 {
    determinant(&std::array::from_fn(|k| if k + 1 < D { y[k + 1] - y[0] } else { *n }))
}

fn with<const D: usize>(y: &[Vector<D>; D], k: usize, x: Vector<D>) -> [Vector<D>; D] {
    std::array::from_fn(|c| if c == k { x } else { y[c] })
}
