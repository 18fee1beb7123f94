//! Blocks of quadrilaterals mapped from the unit square.

use crate::Mesh;

/// `cells[0] × cells[1]` quadrilaterals: the unit square mapped by `f(u, v)`, which must keep orientation.
///
/// Nodes and cells run along `u` first.
pub fn patch_quad4(cells: [usize; 2], f: impl Fn(f64, f64) -> [f64; 2]) -> Mesh<2> {
    let [nu, nv] = cells;
    assert!(nu > 0 && nv > 0, "a patch of {nu} × {nv} cells is empty");
    let nodes = (0..=nv).flat_map(|j| (0..=nu).map(move |i| (i as f64 / nu as f64, j as f64 / nv as f64)));
    let coords = nodes.map(|(u, v)| f(u, v)).collect();
    let id = |i: usize, j: usize| (j * (nu + 1) + i) as u32;
    let conn = (0..nv)
        .flat_map(|j| (0..nu).flat_map(move |i| [id(i, j), id(i + 1, j), id(i + 1, j + 1), id(i, j + 1)]))
        .collect();
    Mesh { coords, conn, nodes_per_cell: 4 }
}

/// Convex quadrilateral with the given corners, counter-clockwise, divided along its first and second side.
pub fn quadrilateral_quad4(corners: [[f64; 2]; 4], cells: [usize; 2]) -> Mesh<2> {
    patch_quad4(cells, |u, v| {
        let weights = [(1.0 - u) * (1.0 - v), u * (1.0 - v), u * v, (1.0 - u) * v];
        std::array::from_fn(|i| (0..4).map(|k| weights[k] * corners[k][i]).sum())
    })
}

#[cfg(test)]
mod tests {
    use super::quadrilateral_quad4;

    #[test]
    fn trapezium() {
        let mesh = quadrilateral_quad4([[0.0, 0.0], [3.0, 0.0], [2.0, 1.0], [1.0, 1.0]], [4, 3]);
        assert!((mesh.measure() - 2.0).abs() < 1e-14);
        assert!(mesh.smallest_jacobian() > 0.0);
        assert_eq!(mesh.euler_characteristic(), 1);
    }
}
