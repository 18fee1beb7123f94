//! Boxes.

use crate::Mesh;

/// Box from `min` to `max` in `cells[0] × cells[1] × cells[2]` hexahedra.
pub fn cuboid_hex8(min: [f64; 3], max: [f64; 3], cells: [usize; 3]) -> Mesh<3> {
    let conn = corners(cells).flat_map(|c| [c[0], c[1], c[3], c[2], c[4], c[5], c[7], c[6]]).collect();
    Mesh { coords: nodes(min, max, cells), conn, nodes_per_cell: 8 }
}

/// The same in tetrahedra, six per hexahedron (Kuhn): one for every way from the lowest corner to the highest along
/// the axes. All share that diagonal, and neighbouring cells cut their common face alike.
pub fn cuboid_tet4(min: [f64; 3], max: [f64; 3], cells: [usize; 3]) -> Mesh<3> {
    // Axes in the order walked; an odd order makes a negative tetrahedron, whose middle nodes change places.
    const WAYS: [([usize; 3], bool); 6] = [
        ([0, 1, 2], true),
        ([1, 2, 0], true),
        ([2, 0, 1], true),
        ([0, 2, 1], false),
        ([1, 0, 2], false),
        ([2, 1, 0], false),
    ];
    let conn = corners(cells)
        .flat_map(|c| {
            WAYS.into_iter().flat_map(move |([i, j, _], even)| {
                let (a, b) = (c[1 << i], c[1 << i | 1 << j]);
                if even { [c[0], a, b, c[7]] } else { [c[0], b, a, c[7]] }
            })
        })
        .collect();
    Mesh { coords: nodes(min, max, cells), conn, nodes_per_cell: 4 }
}

/// Surface of the box in triangles, two per rectangle.
pub fn cuboid_surface(min: [f64; 3], max: [f64; 3], cells: [usize; 3]) -> Mesh<3> {
    cuboid_tet4(min, max, cells).boundary()
}

/// Nodes, x first.
fn nodes(min: [f64; 3], max: [f64; 3], cells: [usize; 3]) -> Vec<[f64; 3]> {
    let [nx, ny, nz] = cells;
    assert!(nx * ny * nz > 0, "a box of {nx} × {ny} × {nz} cells is empty");
    let at = |i: usize, k: usize| {
        let s = k as f64 / cells[i] as f64;
        (1.0 - s) * min[i] + s * max[i]
    };
    (0..=nz).flat_map(|z| (0..=ny).flat_map(move |y| (0..=nx).map(move |x| [at(0, x), at(1, y), at(2, z)]))).collect()
}

/// Corners of every cell; the bits of a corner's number say on which side it lies, x in the lowest.
fn corners(cells: [usize; 3]) -> impl Iterator<Item = [u32; 8]> {
    let [nx, ny, nz] = cells;
    let id = move |x: usize, y: usize, z: usize| ((z * (ny + 1) + y) * (nx + 1) + x) as u32;
    (0..nz).flat_map(move |z| {
        (0..ny).flat_map(move |y| {
            (0..nx).map(move |x| std::array::from_fn(|c| id(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2))))
        })
    })
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
