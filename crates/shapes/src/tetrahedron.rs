//! Tetrahedra.

use crate::{Mesh, grid_tet4, uniform};

/// Tetrahedron in `edges`³ tetrahedra.
///
/// Of a cube cut about its diagonal ([`grid_tet4`]), the part u ≥ v ≥ w is a tetrahedron.
pub fn tetrahedron_tet4(corners: [[f64; 3]; 4], edges: usize) -> Mesh<3> {
    assert!(edges > 0, "a tetrahedron without edges");
    let ends = uniform(0.0, 1.0, edges);
    let mut cube = grid_tet4([&ends, &ends, &ends]);
    let descends = |cell: &[u32]| {
        let sum = |axis: usize| cell.iter().map(|&node| cube.coords[node as usize][axis]).sum::<f64>();
        sum(0) > sum(1) && sum(1) > sum(2)
    };
    cube.conn = cube.cells().filter(|cell| descends(cell)).flatten().copied().collect();
    let [origin, ends @ ..] = corners;
    let place = |[u, v, w]: [f64; 3]| {
        let parts = [u - v, v - w, w];
        std::array::from_fn(|i| origin[i] + (0..3).map(|k| parts[k] * (ends[k][i] - origin[i])).sum::<f64>())
    };
    cube.without_unused_nodes().mapped(place).oriented()
}

#[cfg(test)]
mod tests {
    use super::tetrahedron_tet4;

    #[test]
    fn tetrahedra_fill_their_volume() {
        let corners = [[0.0; 3], [0.0, 3.0, 0.0], [2.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
        for edges in [1, 4, 5] {
            let mesh = tetrahedron_tet4(corners, edges);
            assert_eq!(mesh.cell_count(), edges.pow(3));
            assert!((mesh.measure() - 1.0).abs() < 1e-13 && mesh.smallest_jacobian() > 0.0);
            assert_eq!((mesh.boundary().euler_characteristic(), mesh.boundary_faces().len()), (2, 4 * edges * edges));
        }
    }
}
