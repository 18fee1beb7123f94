//! Tetrahedra between a surface and a point.

use crate::Mesh;

/// Fills the cone from `apex` over the triangles of `base` with tetrahedra, in `layers` layers of equal thickness.
///
/// Triangles must turn their back to the apex: it lies on the inner side of each. The layer at the apex is one
/// tetrahedron per triangle, every other one a prism of three. A prism's sides are cut from the node of lowest number,
/// so that neighbours agree.
pub fn coned(base: &Mesh<3>, apex: [f64; 3], layers: usize) -> Mesh<3> {
    assert!(layers > 0, "a cone needs a layer");
    let n = base.coords.len() as u32;
    let mut coords = base.coords.clone();
    for layer in 1..layers {
        let s = layer as f64 / layers as f64;
        coords.extend(base.coords.iter().map(|x| std::array::from_fn(|i| (1.0 - s) * x[i] + s * apex[i])));
    }
    coords.push(apex);
    let apex = coords.len() as u32 - 1;

    let mut conn = Vec::new();
    for layer in 0..layers as u32 {
        for t in base.cells() {
            let low = [t[0], t[1], t[2]].map(|node| node + layer * n);
            if layer + 1 == layers as u32 {
                conn.extend([low[0], low[2], low[1], apex]);
                continue;
            }
            let (v, even) = sorted(low);
            let w = v.map(|node| node + n);
            for [a, b, c, d] in [[v[0], v[2], v[1], w[2]], [v[0], v[1], w[1], w[2]], [v[0], w[0], w[2], w[1]]] {
                conn.extend(if even { [a, b, c, d] } else { [a, c, b, d] });
            }
        }
    }
    Mesh { coords, conn, nodes_per_cell: 4 }
}

/// Nodes in ascending order, and whether that keeps the orientation.
fn sorted(mut t: [u32; 3]) -> ([u32; 3], bool) {
    let lowest = (0..3).min_by_key(|&k| t[k]).unwrap();
    t.rotate_left(lowest);
    if t[1] < t[2] { (t, true) } else { ([t[0], t[2], t[1]], false) }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cuboid_surface;

    #[test]
    fn layers_fill_the_solid() {
        let surface = cuboid_surface([0.0; 3], [1.0, 2.0, 3.0], [2, 3, 2]);
        for layers in [1, 2, 5] {
            let mesh = coned(&surface, [0.4, 0.7, 1.6], layers);
            assert_eq!(mesh.cell_count(), surface.cell_count() * (3 * layers - 2));
            assert!((mesh.measure() - 6.0).abs() < 1e-13);
            assert!(mesh.smallest_jacobian() > 0.0);
            assert_eq!(mesh.boundary().cell_count(), surface.cell_count());
        }
    }
}
