//! Quadratures on facets and on borders.

use crate::geometry::primitives::simplex_rule::degree_5;

/// Points on a simplex of a facet, and their weights.
pub(super) struct Rules {
    /// Of degree 2 in space: all that is summed up is of that degree on flat faces.
    pub(super) flat: Vec<([f64; 4], f64)>,
    pub(super) curved: Vec<([f64; 4], f64)>,
}

impl Rules {
    pub(super) fn new<const D: usize>() -> Self {
        let curved = degree_5(D - 1);
        let own = |own: usize| {
            let at = |c: usize| if c == own { 2.0 / 3.0 } else { 1.0 / 6.0 };
            ([at(0), at(1), at(2), 0.0], 1.0 / 3.0)
        };
        Self { flat: if D == 2 { curved.clone() } else { (0..3).map(own).collect() }, curved }
    }
}

/// Points on a border and their weights: the point itself in the plane, two of Gauss on an edge.
pub(super) fn border_points<const D: usize>() -> impl Iterator<Item = (f64, f64)> {
    let aside = 0.5 - (1.0 / 12.0f64).sqrt();
    let of_edge = [(aside, 0.5), (1.0 - aside, 0.5)];
    let of_point = [(0.0, 1.0), (0.0, 0.0)];
    (if D == 2 { of_point } else { of_edge }).into_iter().take(D - 1)
}
