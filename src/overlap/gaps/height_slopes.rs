//! How the height of a curved face at the foot of a point changes as the point and the facet move.

use crate::geometry::Vector;

/// Derivatives of the height h(λ), λ being the barycentric coordinates of the foot p of a point x on a facet.
///
/// With r = x − p, which is perpendicular to the facet or to the edge on which the foot lies, and g = Σ ∂h/∂λ_k ∇λ_k along it, δh =
/// g · (δx − Σ λ_j δv_j) + Σ (g · ∇λ_j) r · δv_j: the second term is what a facet that tilts moves the foot by.
pub(crate) struct HeightSlopes<const D: usize> {
    pub(crate) by_point: Vector<D>,
    pub(crate) by_corners: [Vector<D>; D],
}

impl<const D: usize> HeightSlopes<D> {
    /// `from` is r, `slopes` are ∂h/∂λ. A foot on a corner stays there.
    pub(crate) fn new(corners: &[Vector<D>; D], weights: &[f64; D], from: &Vector<D>, slopes: [f64; D]) -> Self {
        let gradients = foot_gradients(corners, weights);
        let by_point = gradients.iter().zip(slopes).fold(Vector::zeros(), |sum, (along, slope)| sum + along * slope);
        let by_corners = std::array::from_fn(|k| from * by_point.dot(&gradients[k]) - by_point * weights[k]);
        Self { by_point, by_corners }
    }
}

/// ∇λ of the facet, or of the edge on which the foot lies; zero at a corner.
fn foot_gradients<const D: usize>(corners: &[Vector<D>; D], weights: &[f64; D]) -> [Vector<D>; D] {
    let mut found = [Vector::zeros(); D];
    let on: Vec<usize> = (0..D).filter(|&k| weights[k] > 0.0).collect();
    match on[..] {
        [a, b] => {
            let way = corners[b] - corners[a];
            found[b] = way / way.norm_squared();
            found[a] = -found[b];
        }
        [a, b, c] => {
            let (s, t) = (corners[b] - corners[a], corners[c] - corners[a]);
            let (ss, st, tt) = (s.norm_squared(), s.dot(&t), t.norm_squared());
            let of_both = ss * tt - st * st;
            found[b] = (s * tt - t * st) / of_both;
            found[c] = (t * ss - s * st) / of_both;
            found[a] = -(found[b] + found[c]);
        }
        _ => {}
    }
    found
}
