//! A facet clipped by a piece of a cell.

use super::facet_part::FacetPart;
use crate::depth_field::DepthPiece;
use crate::geometry::Vector;
use crate::geometry::primitives::convex_piece::Piece;
use crate::geometry::primitives::simplex::Simplex;

/// A facet all of whose corners are nearer to a face than this part of the height above it may lie in the face but for
/// rounding: digits are lost there, and two pieces at the face must agree to which of them it belongs.
const CLOSE: f64 = 1e-5;

/// What [`clip`] finds.
pub(crate) enum Found<'a, const D: usize> {
    /// A part that counts by this factor.
    Part(&'a mut FacetPart<D>, f64),
    /// A part that tells how much of the piece lies on either side of the facet: its edges know on which faces they lie, and its corners
    /// are those that the neighbours of the facet find there, to the last bit.
    Border(&'a FacetPart<D>),
    /// The facet may lie in a face of the piece with its last corner: on which side it has that corner, rounding might decide.
    Doubt,
}

/// Clips a facet by a piece. A facet in a face counts half.
pub(crate) fn clip<const D: usize>(
    corners: &[Vector<D>; D],
    barycentric: &[[f64; 4]; D],
    area: &Vector<D>,
    piece: &DepthPiece<D>,
    (inside, work): (&mut FacetPart<D>, &mut Piece<D>),
    mut found: impl FnMut(Found<D>),
) {
    let (mut close, mut is_beside, mut cuts, mut count) = (None, false, [0; 4], 0);
    for k in 0..=D {
        let (mut least, mut largest) = (f64::INFINITY, f64::NEG_INFINITY);
        for corner in barycentric {
            (least, largest) = (least.min(corner[k]), largest.max(corner[k]));
        }
        let is_close = largest < CLOSE && least > -CLOSE;
        if is_close {
            close = close.or(Some(k));
        }
        if largest <= 0.0 {
            is_beside = true;
            if !is_close {
                return;
            }
        } else if least <= 0.0 {
            cuts[count] = k;
            count += 1;
        }
    }
    if let Some(first) = close {
        if let Some(simplex) = Simplex::new(&piece.corners[..=D], 0, false) {
            simplex.clip(corners, area, 0.0, work, |part, counts| {
                inside.set(part.corners(), barycentric);
                found(Found::Part(inside, counts));
            });
        }
        // The last corner lies in all faces but its own.
        if first < D {
            found(Found::Doubt);
            return;
        }
    }
    if is_beside {
        return;
    }
    inside.reset(barycentric);
    if cuts[..count].iter().all(|&face| inside.cut_to_face(face)) {
        found(Found::Border(inside));
        if close.is_none() {
            found(Found::Part(inside, 1.0));
        }
    }
}
