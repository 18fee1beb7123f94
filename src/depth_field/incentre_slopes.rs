//! How the point that is as high above several faces of a simplex changes as its corners move.

use crate::geometry::Vector;
use crate::geometry::primitives::facet::{area_slopes, area_vector};

/// Derivative by the corners of Σ cₖ wₖ + r ρ, where wₖ are the weights of the corners in the point of `incentre`, and ρ is its height above the
/// faces, which are named by the bits of the corners opposite to them.
///
/// With the areas aₖ of these faces and their sum S, wₖ = aₖ/S and ρ = D V/S; the derivative of D V by a corner is the area vector of the
/// face opposite to it, towards the corner.
pub(super) fn incentre_slopes<const D: usize>(
    corners: &[Vector<D>; 4],
    faces: u8,
    of_weights: &[f64; 4],
    of_radius: f64,
) -> [Vector<D>; 4] {
    let mut slopes = [Vector::zeros(); 4];
    let face_of = |k: usize| -> [usize; D] { std::array::from_fn(|c| c + usize::from(c >= k)) };
    let face = |k: usize| face_of(k).map(|c| corners[c]);
    let is_one = |k: usize| k <= D && faces >> k & 1 == 1;
    let areas: [f64; 4] = std::array::from_fn(|k| if is_one(k) { area_vector(&face(k)).norm() } else { 0.0 });
    let sum: f64 = areas.iter().sum();
    let mean: f64 = (0..=D).map(|k| of_weights[k] * areas[k] / sum).sum();
    let height = |k: usize| area_vector(&face(k)).dot(&(corners[k] - corners[usize::from(k == 0)]));
    let radius = height(0).abs() / sum;
    for k in 0..=D {
        let area = area_vector(&face(k));
        slopes[k] += area * (height(k).signum() * of_radius / sum);
        if !is_one(k) {
            continue;
        }
        let of_area = (of_weights[k] - mean - of_radius * radius) / sum;
        let normal = area / areas[k];
        for (corner, slope) in face_of(k).into_iter().zip(area_slopes(&face(k))) {
            for j in 0..D {
                slopes[corner][j] += of_area * (0..D).map(|i| normal[i] * slope[i][j]).sum::<f64>();
            }
        }
    }
    slopes
}

#[cfg(test)]
mod tests {
    use super::super::incentre::incentre;
    use super::*;
    use fmc_shapes::Splitmix;

    fn check<const D: usize>(seed: u64, faces: u8) {
        let mut random = Splitmix::new(seed);
        let mut corners = [Vector::<D>::zeros(); 4];
        corners[..=D].iter_mut().flat_map(|x| x.iter_mut()).for_each(|x| *x = random.between(-1.0, 1.0));
        let of_weights: [f64; 4] = std::array::from_fn(|_| random.between(-1.0, 1.0));
        let value = |corners: &[Vector<D>; 4]| {
            let (weights, radius) = incentre(corners, faces).expect("not flat");
            (0..=D).map(|k| of_weights[k] * weights[k]).sum::<f64>() + 0.7 * radius
        };
        let slopes = incentre_slopes(&corners, faces, &of_weights, 0.7);
        // Central differences: truncation h² and rounding 1e-16/h.
        let h = 1e-5;
        for (k, slope) in slopes.iter().enumerate().take(D + 1) {
            for i in 0..D {
                let moved = |by: f64| {
                    let mut corners = corners;
                    corners[k][i] += by;
                    value(&corners)
                };
                let found = (moved(h) - moved(-h)) / (2.0 * h);
                assert!((found - slope[i]).abs() < 1e-7, "{found} {}", slope[i]);
            }
        }
    }

    #[test]
    fn slopes_are_those_of_differences() {
        (1..8).for_each(|faces| check::<2>(u64::from(faces), faces));
        (1..16).for_each(|faces| check::<3>(u64::from(faces), faces));
    }
}
