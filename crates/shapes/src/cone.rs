//! Cones.

use crate::{Mesh, coned, disc_tri3, fan_tri3, regular_polygon};

/// Cone about the z axis in tetrahedra: base at z = 0, apex at z = `height`, `edges` edges around.
///
/// With one layer the base is a fan about its centre, `edges` cells in all; with more, a disc of like triangles, and the
/// layers grow thinner sideways towards the apex.
pub fn cone_tet4(radius: f64, height: f64, edges: usize, layers: usize) -> Mesh<3> {
    let disc = match layers {
        1 => fan_tri3([0.0; 2], &regular_polygon(edges, radius)),
        _ => disc_tri3(radius, edges),
    };
    // Seen from the apex, the base is counter-clockwise; it has to turn its back.
    let conn = disc.cells().flat_map(|t| [t[0], t[2], t[1]]).collect();
    let base = Mesh { coords: disc.coords.iter().map(|x| [x[0], x[1], 0.0]).collect(), conn, nodes_per_cell: 3 };
    coned(&base, [0.0, 0.0, height], layers)
}

/// Surface of that cone in triangles: `edges` on its base, about its centre, and `edges` on its flank.
pub fn cone_surface(radius: f64, height: f64, edges: usize) -> Mesh<3> {
    cone_tet4(radius, height, edges, 1).boundary()
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    #[test]
    fn cones_fill_their_pyramid() {
        let volume = 0.5 * 1.5 * 1.5 * 24.0 * (TAU / 24.0).sin() * 2.0 / 3.0;
        for layers in [1, 3] {
            let mesh = cone_tet4(1.5, 2.0, 24, layers);
            assert!((mesh.measure() - volume).abs() < 1e-13);
            assert!(mesh.smallest_jacobian() > 0.0);
            assert_eq!(mesh.boundary().euler_characteristic(), 2);
        }
        let surface = cone_surface(1.5, 2.0, 24);
        assert_eq!((surface.cell_count(), surface.coords.len()), (48, 26));
        assert!((surface.measure() - volume).abs() < 1e-13);
    }
}
