//! Boxes.

use crate::{Mesh, grid_hex8, grid_tet4, uniform};

/// Box from `min` to `max` in `cells[0] × cells[1] × cells[2]` hexahedra.
pub fn cuboid_hex8(min: [f64; 3], max: [f64; 3], cells: [usize; 3]) -> Mesh<3> {
    grid_hex8(planes(min, max, cells).each_ref().map(Vec::as_slice))
}

/// The same in tetrahedra, six per hexahedron, all about one diagonal.
pub fn cuboid_tet4(min: [f64; 3], max: [f64; 3], cells: [usize; 3]) -> Mesh<3> {
    grid_tet4(planes(min, max, cells).each_ref().map(Vec::as_slice))
}

/// Surface of the box in triangles, two per rectangle.
pub fn cuboid_surface(min: [f64; 3], max: [f64; 3], cells: [usize; 3]) -> Mesh<3> {
    cuboid_tet4(min, max, cells).boundary()
}

fn planes(min: [f64; 3], max: [f64; 3], cells: [usize; 3]) -> [Vec<f64>; 3] {
    std::array::from_fn(|axis| uniform(min[axis], max[axis], cells[axis]))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn boxes_fill_their_volume() {
        let (min, max, cells) = ([-1.0, 0.0, 2.0], [1.0, 3.0, 3.0], [2, 3, 4]);
        for (mesh, faces) in [(cuboid_hex8(min, max, cells), 52), (cuboid_tet4(min, max, cells), 104)] {
            assert!((mesh.measure() - 6.0).abs() < 1e-13);
            assert!(mesh.smallest_jacobian() > 0.0);
            assert_eq!(mesh.boundary_faces().len(), faces);
        }
    }

    #[test]
    fn surface_is_a_closed_sphere() {
        let surface = cuboid_surface([0.0; 3], [1.0; 3], [1; 3]);
        assert_eq!((surface.cell_count(), surface.coords.len()), (12, 8));
        assert!((surface.measure() - 1.0).abs() < 1e-14);
        assert_eq!(surface.euler_characteristic(), 2);
        assert!(surface.boundary_faces().is_empty());
    }
}
