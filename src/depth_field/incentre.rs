//! Points that are as high above several faces of a simplex: for all faces the centre of the inscribed ball.

use crate::geometry::Vector;
use crate::geometry::primitives::facet::area_vector;

/// Weights that add up to 1 and are zero but for the corners opposite to some faces, named by bits, in a point that is as high above each of
/// these; and its height. `None` where the simplex is flat.
pub(super) fn incentre<const D: usize>(corners: &[Vector<D>; 4], faces: u8) -> Option<([f64; 4], f64)> {
    let mut weights = [0.0; 4];
    (0..=D).filter(|k| faces >> k & 1 == 1).for_each(|k| weights[k] = opposite_area(corners, k).norm());
    let sum: f64 = weights.iter().sum();
    // The height above a face times its measure is D times the volume.
    let height = opposite_area(corners, 0).dot(&(corners[0] - corners[1])).abs() / sum;
    (height > 0.0).then(|| (weights.map(|w| w / sum), height))
}

/// The bits of all corners, or of the faces opposite to them.
pub(super) fn all_corners(dimension: usize) -> u8 {
    (1 << (dimension + 1)) - 1
}

/// Height of a corner of a simplex above its opposite face.
pub(super) fn height<const D: usize>(corners: &[Vector<D>; 4], corner: usize) -> f64 {
    let area = opposite_area(corners, corner);
    let other = corners[usize::from(corner == 0)];
    area.dot(&(corners[corner] - other)).abs() / area.norm()
}

/// By how much such a height changes as coordinates do by one rounding: far away from the origin, and above faces that are slivers, the
/// more.
pub(super) fn rounding_of_height<const D: usize>(corners: &[Vector<D>; 4], corner: usize) -> f64 {
    let farthest = corners[..=D].iter().map(|x| x.amax()).fold(0.0, f64::max);
    let face: [Vector<D>; D] = std::array::from_fn(|k| corners[k + usize::from(k >= corner)]);
    let longest = face.iter().map(|x| (x - face[0]).norm()).fold(0.0, f64::max);
    let aspect = longest.powi(D as i32 - 1) / area_vector(&face).norm();
    f64::EPSILON * farthest * aspect.max(1.0)
}

fn opposite_area<const D: usize>(corners: &[Vector<D>; 4], corner: usize) -> Vector<D> {
    let face: [Vector<D>; D] = std::array::from_fn(|k| corners[k + usize::from(k >= corner)]);
    area_vector(&face)
}
