//! Rectangles.

use crate::{Mesh, quadrilateral_quad4};

/// How the cells of a structured mesh are cut into triangles.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Diagonals {
    /// All from the lower left to the upper right.
    Same,
    /// In turn, like the fields of a chess board.
    Alternating,
}

/// Rectangle from `min` to `max` in `cells[0] × cells[1]` quadrilaterals.
pub fn rectangle_quad4(min: [f64; 2], max: [f64; 2], cells: [usize; 2]) -> Mesh<2> {
    quadrilateral_quad4([min, [max[0], min[1]], max, [min[0], max[1]]], cells)
}

/// The same in triangles, two per quadrilateral.
pub fn rectangle_tri3(min: [f64; 2], max: [f64; 2], cells: [usize; 2], diagonals: Diagonals) -> Mesh<2> {
    let [nx, _] = cells;
    rectangle_quad4(min, max, cells)
        .cut(|cell, _| diagonals == Diagonals::Same || (cell % nx + cell / nx).is_multiple_of(2))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rectangles_fill_their_area() {
        let (min, max) = ([-1.0, 2.0], [2.0, 4.0]);
        let quads = rectangle_quad4(min, max, [5, 3]);
        let triangles = [Diagonals::Same, Diagonals::Alternating].map(|d| rectangle_tri3(min, max, [5, 3], d));
        for mesh in std::iter::once(quads).chain(triangles) {
            assert!((mesh.measure() - 6.0).abs() < 1e-13);
            assert!(mesh.smallest_jacobian() > 0.0);
            assert_eq!(mesh.euler_characteristic(), 1);
            assert_eq!(mesh.boundary().cell_count(), 16);
        }
    }
}
