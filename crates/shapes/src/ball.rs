//! Balls.

use crate::{Mesh, coned, icosphere};

/// Ball about the origin in tetrahedra: the icosphere of `level`, in `layers` layers of equal thickness to the centre.
///
/// 20·4^level·(3·layers − 2) cells.
pub fn ball_tet4(radius: f64, level: usize, layers: usize) -> Mesh<3> {
    coned(&icosphere(radius, level), [0.0; 3], layers)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ball_fills_its_sphere() {
        for layers in [1, 4] {
            let ball = ball_tet4(1.5, 2, layers);
            assert!((ball.measure() - icosphere(1.5, 2).measure()).abs() < 1e-12);
            assert!(ball.smallest_jacobian() > 0.0);
            assert_eq!(ball.boundary().facets().len(), 320);
            assert_eq!(ball.boundary().euler_characteristic(), 2);
        }
    }
}
