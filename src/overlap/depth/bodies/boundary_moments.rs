//! Moments of what a body has inside a piece of another, from the parts of its facets there alone.
//!
//! A field that is radial from corner 0 of a piece has no flux through the faces at that corner. So what a closed surface encloses in
//! the piece is the sum of the cones from there to the parts of the surface, and to what it encloses in face 0; that is found by cones
//! from corner 1 to the edges of the parts that lie on face 0, and to what the surface encloses in the edge opposite to corner 1; and
//! this by the ends of such edges, and by how often the surface winds around the last corner. Every part adds a share of its own,
//! whatever the others are.
//!
//! The corners of pieces come in the order of their depth: of a thin overlap all cones are thin.

use super::facet_part::FacetPart;
use super::piece_moments::Moments;

/// What a part of a facet adds, in units of the measure of the piece, whose corners in their order are taken to enclose a positive one.
pub(super) fn share<M: Moments, const D: usize>(part: &FacetPart<D>) -> M {
    let mut moments = M::default();
    let at = part.in_piece();
    if D == 2 {
        let (p, q) = (&at[0], &at[1]);
        moments.add_simplex(2, p[1] * q[2] - p[2] * q[1], &[CORNERS[0], *p, *q, [0.0; 4]]);
        let mut on_face = M::default();
        for (corner, sign) in [(0, 1.0), (1, -1.0)] {
            if part.face(corner) == 0 {
                on_face.add_simplex(1, sign * at[corner][2], &[CORNERS[1], at[corner], [0.0; 4], [0.0; 4]]);
            }
        }
        moments.add(&on_face.cone(0, 2));
        return moments;
    }
    for pair in at[1..].windows(2) {
        let (p, q, r) = (&at[0], &pair[0], &pair[1]);
        let minor = |i: usize, j: usize| q[i] * r[j] - q[j] * r[i];
        let volume = p[1] * minor(2, 3) + p[2] * minor(3, 1) + p[3] * minor(1, 2);
        moments.add_simplex(3, volume, &[CORNERS[0], *p, *q, *r]);
    }
    let (mut on_face, mut on_edge, mut has_edge) = (M::default(), M::default(), false);
    for corner in 0..at.len() {
        let (before, after) = (part.face(part.before(corner)), part.face(corner));
        if after == 0 {
            // The border of what is enclosed in the face runs the other way.
            let (p, q) = (&at[part.after(corner)], &at[corner]);
            on_face.add_simplex(2, p[2] * q[3] - p[3] * q[2], &[CORNERS[1], *p, *q, [0.0; 4]]);
            has_edge = true;
        }
        if let (0, 1) | (1, 0) = (before, after) {
            let sign = if before == 0 { 1.0 } else { -1.0 };
            on_edge.add_simplex(1, sign * at[corner][3], &[CORNERS[2], at[corner], [0.0; 4], [0.0; 4]]);
        }
    }
    if has_edge {
        on_face.add(&on_edge.cone(1, 2));
        moments.add(&on_face.cone(0, 3));
    }
    moments
}

/// What it adds that the surface winds once around the last corner: the whole piece.
pub(super) fn whole<M: Moments, const D: usize>() -> M {
    let mut moments = M::default();
    moments.add_simplex(D, 1.0, &CORNERS);
    moments
}

/// Corners of a piece in its own coordinates.
const CORNERS: [[f64; 4]; 4] = [[1.0, 0.0, 0.0, 0.0], [0.0, 1.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0, 0.0, 0.0, 1.0]];
