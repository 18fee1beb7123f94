//! Random shapes and rotations, the same for the same seed.

use crate::polygon::on_circle;
use crate::{Mesh, Splitmix, coned, fan_tri3, icosphere, polygon};

/// Random simple polygon about the origin in triangles: `corners` corners at radii between `(1 − spread)` and
/// `(1 + spread)` times `radius`, one in each of as many equal sectors; the first node is the centre.
///
/// With `corners ≥ 5` no two neighbours are half a turn apart, so that every triangle is positive.
pub fn random_polygon(corners: usize, radius: f64, spread: f64, seed: u64) -> Mesh<2> {
    assert!(corners >= 5 && (0.0..1.0).contains(&spread), "{corners} corners with a spread of {spread}");
    let mut random = Splitmix::new(seed);
    let corner = |k| {
        let turn = (k as f64 + random.between(0.05, 0.95)) / corners as f64;
        on_circle(radius * random.between(1.0 - spread, 1.0 + spread), turn)
    };
    fan_tri3([0.0; 2], &polygon(&(0..corners).map(corner).collect::<Vec<_>>(), 1))
}

/// Random polyhedron about the origin in tetrahedra, star-shaped: an icosphere whose nodes lie at radii between
/// `(1 − spread)` and `(1 + spread)` times `radius`, filled to the centre in `layers` layers.
pub fn random_polyhedron(level: usize, radius: f64, spread: f64, layers: usize, seed: u64) -> Mesh<3> {
    assert!((0.0..1.0).contains(&spread), "a spread of {spread}");
    let mut random = Splitmix::new(seed);
    let mut surface = icosphere(radius, level);
    for x in &mut surface.coords {
        let factor = random.between(1.0 - spread, 1.0 + spread);
        *x = x.map(|x| x * factor);
    }
    coned(&surface, [0.0; 3], layers)
}

/// Random rotation matrix, by rows, uniform over all rotations: orthonormalised normal vectors.
pub fn random_rotation<const D: usize>(seed: u64) -> [[f64; D]; D] {
    assert!(D == 2 || D == 3, "rotations are of dimension 2 or 3, not {D}");
    let mut random = Splitmix::new(seed);
    let dot = |a: &[f64; D], b: &[f64; D]| -> f64 { (0..D).map(|i| a[i] * b[i]).sum() };
    let mut r = [[0.0; D]; D];
    // The last row follows from the others and from determinant +1.
    for i in 0..D - 1 {
        r[i] = std::array::from_fn(|_| random.normal());
        for j in 0..i {
            let along = dot(&r[i], &r[j]);
            r[i] = std::array::from_fn(|k| r[i][k] - along * r[j][k]);
        }
        let length = dot(&r[i], &r[i]).sqrt();
        r[i] = r[i].map(|x| x / length);
    }
    r[D - 1] = match D {
        2 => std::array::from_fn(|k| if k == 0 { -r[0][1] } else { r[0][0] }),
        _ => std::array::from_fn(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            r[0][i] * r[1][j] - r[0][j] * r[1][i]
        }),
    };
    r
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{cuboid_tet4, rectangle_quad4};

    #[test]
    fn random_shapes_are_valid() {
        for seed in 0..50 {
            let flat = random_polygon(5 + seed as usize % 20, 2.0, 0.6, seed);
            assert!(flat.smallest_jacobian() > 0.0);
            assert_eq!(flat.euler_characteristic(), 1);
            let solid = random_polyhedron(1, 2.0, 0.4, 1 + seed as usize % 3, seed);
            assert!(solid.smallest_jacobian() > 0.0);
            assert_eq!(solid.boundary().euler_characteristic(), 2);
        }
        assert_eq!(random_polygon(7, 1.0, 0.3, 1), random_polygon(7, 1.0, 0.3, 1));
        assert_ne!(random_polygon(7, 1.0, 0.3, 1), random_polygon(7, 1.0, 0.3, 2));
    }

    #[test]
    fn random_rotations_keep_distances_and_orientation() {
        for seed in 0..20 {
            let square = rectangle_quad4([0.0; 2], [1.0; 2], [1; 2]).rotated_by(random_rotation(seed));
            assert!((square.measure() - 1.0).abs() < 1e-14);
            let cube = cuboid_tet4([0.0; 3], [1.0; 3], [1; 3]);
            let turned = cube.clone().rotated_by(random_rotation(seed));
            assert!((turned.measure() - 1.0).abs() < 1e-14);
            let squared_length = |x: &[f64; 3]| x.iter().map(|x| x * x).sum::<f64>();
            for (x, y) in cube.coords.iter().zip(&turned.coords) {
                assert!((squared_length(x) - squared_length(y)).abs() < 1e-14);
            }
        }
    }
}
