//! A facet clipped by a piece of a cell.

use crate::depth_field::DepthPiece;
use crate::geometry::Vector;
use crate::geometry::convex_piece::Piece;
use crate::geometry::simplex::Simplex;

/// A facet all of whose corners are nearer to a face than this part of the height above it may lie in the face but for
/// rounding: digits are lost there, and two pieces at the face must agree to which of them it belongs.
const CLOSE: f64 = 1e-5;

/// Calls `visit(piece of the facet inside, how much of it counts)`. A facet in a face counts half.
pub(crate) fn clip<const D: usize>(
    corners: &[Vector<D>; D],
    barycentric: &[[f64; 4]; D],
    area: &Vector<D>,
    piece: &DepthPiece<D>,
    work: &mut Piece<D>,
    mut visit: impl FnMut(&Piece<D>, f64),
) {
    let (mut is_close, mut cuts, mut count) = (false, [[0.0; D]; 4], 0);
    for k in 0..=D {
        let heights: [f64; D] = std::array::from_fn(|c| barycentric[c][k]);
        let (mut least, mut largest) = (f64::INFINITY, f64::NEG_INFINITY);
        for h in heights {
            (least, largest) = (least.min(h), largest.max(h));
        }
        if largest < CLOSE && least > -CLOSE {
            is_close = true;
        } else if largest <= 0.0 {
            return;
        } else if least < 0.0 {
            cuts[count] = heights.map(|h| -h);
            count += 1;
        }
    }
    if is_close {
        if let Some(simplex) = Simplex::new(&piece.corners[..=D], 0, false) {
            simplex.clip(corners, area, 0.0, work, visit);
        }
        return;
    }
    work.reset();
    if cuts[..count].iter().all(|cut| work.cut(cut)) {
        visit(work, 1.0);
    }
}
