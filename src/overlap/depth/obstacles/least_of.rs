//! Parts of a facet on which one of several linear functions is the least.

use crate::geometry::primitives::convex_piece::Piece;

/// Cuts a facet to where function number `k` is positive and not above the others, all given at the facet's corners;
/// false if there is no such part. Functions that agree on the whole facet to `rounding` belong to the first of them, so
/// that a facet between two regions is counted once.
pub(crate) fn cut_to_least<const D: usize>(
    functions: &[[f64; D]],
    k: usize,
    rounding: f64,
    piece: &mut Piece<D>,
) -> bool {
    piece.reset();
    let own = &functions[k];
    if own.iter().all(|value| *value <= 0.0) {
        return false;
    }
    if own.iter().any(|value| *value < 0.0) && !piece.cut(&own.map(|value| -value)) {
        return false;
    }
    for (l, other) in functions.iter().enumerate().filter(|(l, _)| *l != k) {
        let above: [f64; D] = std::array::from_fn(|c| own[c] - other[c]);
        if above.iter().all(|a| a.abs() <= rounding) {
            if l < k {
                return false;
            }
        } else if above.iter().any(|a| *a > 0.0) && !piece.cut(&above) {
            return false;
        }
    }
    true
}

/// Functions that are the least somewhere on the facet, or may be; the order stays. `None` if none is positive there.
pub(crate) fn candidates<const D: usize>(functions: &[[f64; D]]) -> Option<Vec<usize>> {
    let largest = |f: &[f64; D]| f.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    let least = |f: &[f64; D]| f.iter().copied().fold(f64::INFINITY, f64::min);
    let bound = functions.iter().map(largest).fold(f64::INFINITY, f64::min);
    (bound > 0.0).then(|| (0..functions.len()).filter(|&k| least(&functions[k]) <= bound).collect())
}
