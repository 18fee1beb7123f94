//! Rectangles and boxes between given lines, uniform, graded or any other way.

use crate::{Diagonals, Mesh};

/// Ends of `cells` cells of equal length between `from` and `to`, `[cells + 1]`.
pub fn uniform(from: f64, to: f64, cells: usize) -> Vec<f64> {
    let at = |k: usize| k as f64 / cells as f64;
    (0..=cells).map(|k| (1.0 - at(k)) * from + at(k) * to).collect()
}

/// Ends of `cells` cells between `from` and `to`, `[cells + 1]`, each longer than the one before by the same factor; the
/// last is `ratio` times as long as the first.
pub fn geometric(from: f64, to: f64, cells: usize, ratio: f64) -> Vec<f64> {
    assert!(ratio > 0.0 && cells > 0, "{cells} cells with a ratio of {ratio}");
    let factor = if cells > 1 { ratio.powf(1.0 / (cells - 1) as f64) } else { 1.0 };
    let lengths: Vec<f64> = (0..cells).map(|k| factor.powi(k as i32)).collect();
    let total: f64 = lengths.iter().sum();
    let mut ends = vec![from];
    let mut sum = 0.0;
    for length in &lengths[..cells - 1] {
        sum += length;
        ends.push(from + (to - from) * sum / total);
    }
    ends.push(to);
    ends
}

/// Quadrilaterals between lines at the ascending places `lines[axis]`.
pub fn grid_quad4(lines: [&[f64]; 2]) -> Mesh<2> {
    let [nx, ny] = cell_counts(lines);
    let id = |x: usize, y: usize| (y * (nx + 1) + x) as u32;
    let coords = lines[1].iter().flat_map(|&y| lines[0].iter().map(move |&x| [x, y])).collect();
    let conn = (0..ny)
        .flat_map(|y| (0..nx).flat_map(move |x| [id(x, y), id(x + 1, y), id(x + 1, y + 1), id(x, y + 1)]))
        .collect();
    Mesh { coords, conn, nodes_per_cell: 4 }
}

/// The same in triangles, two per quadrilateral.
pub fn grid_tri3(lines: [&[f64]; 2], diagonals: Diagonals) -> Mesh<2> {
    let [nx, _] = cell_counts(lines);
    grid_quad4(lines).cut(|cell, _| diagonals == Diagonals::Same || (cell % nx + cell / nx).is_multiple_of(2))
}

/// Hexahedra between planes at the ascending places `planes[axis]`.
pub fn grid_hex8(planes: [&[f64]; 3]) -> Mesh<3> {
    let conn = corners(cell_counts(planes)).flat_map(|c| [c[0], c[1], c[3], c[2], c[4], c[5], c[7], c[6]]).collect();
    Mesh { coords: nodes(planes), conn, nodes_per_cell: 8 }
}

/// The same in tetrahedra, six per hexahedron (Kuhn): one for every way from the lowest corner to the highest along
/// the axes. All share that diagonal, and neighbouring cells cut their common face alike.
pub fn grid_tet4(planes: [&[f64]; 3]) -> Mesh<3> {
    // Axes in the order walked; an odd order makes a negative tetrahedron, whose middle nodes change places.
    const WAYS: [([usize; 3], bool); 6] = [
        ([0, 1, 2], true),
        ([1, 2, 0], true),
        ([2, 0, 1], true),
        ([0, 2, 1], false),
        ([1, 0, 2], false),
        ([2, 1, 0], false),
    ];
    let conn = corners(cell_counts(planes))
        .flat_map(|c| {
            WAYS.into_iter().flat_map(move |([i, j, _], even)| {
                let (a, b) = (c[1 << i], c[1 << i | 1 << j]);
                if even { [c[0], a, b, c[7]] } else { [c[0], b, a, c[7]] }
            })
        })
        .collect();
    Mesh { coords: nodes(planes), conn, nodes_per_cell: 4 }
}

fn cell_counts<const D: usize>(lines: [&[f64]; D]) -> [usize; D] {
    lines.map(|ends| {
        assert!(ends.len() > 1 && ends.is_sorted_by(|a, b| a < b), "no ascending ends of cells: {ends:?}");
        ends.len() - 1
    })
}

/// Nodes, x first.
fn nodes([x, y, z]: [&[f64]; 3]) -> Vec<[f64; 3]> {
    z.iter().flat_map(|&z| y.iter().flat_map(move |&y| x.iter().map(move |&x| [x, y, z]))).collect()
}

/// Corners of every cell; the bits of a corner's number say on which side it lies, x in the lowest.
fn corners([nx, ny, nz]: [usize; 3]) -> impl Iterator<Item = [u32; 8]> {
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
    fn graded_cells_grow_by_one_factor() {
        let ends = geometric(-1.0, 2.0, 6, 32.0);
        let lengths: Vec<f64> = ends.windows(2).map(|e| e[1] - e[0]).collect();
        assert_eq!((ends[0], ends[6], ends.len()), (-1.0, 2.0, 7));
        lengths.windows(2).for_each(|l| assert!((l[1] / l[0] - 2.0).abs() < 1e-13));
        let (one, two) = (geometric(0.0, 3.0, 3, 1.0), uniform(0.0, 3.0, 3));
        one.iter().zip(&two).for_each(|(a, b)| assert!((a - b).abs() < 1e-15));
        assert_eq!(geometric(0.0, 1.0, 1, 5.0), [0.0, 1.0]);
    }

    #[test]
    fn grids_fill_their_measure() {
        let (x, y, z) = (geometric(-1.0, 2.0, 5, 8.0), geometric(0.0, 2.0, 4, 0.1), uniform(1.0, 2.0, 3));
        let flat = [grid_quad4([&x, &y]), grid_tri3([&x, &y], Diagonals::Alternating)];
        for mesh in flat {
            assert!((mesh.measure() - 6.0).abs() < 1e-13 && mesh.smallest_jacobian() > 0.0);
            assert_eq!((mesh.euler_characteristic(), mesh.boundary().cell_count()), (1, 18));
        }
        for (mesh, faces) in [(grid_hex8([&x, &y, &z]), 94), (grid_tet4([&x, &y, &z]), 188)] {
            assert!((mesh.measure() - 6.0).abs() < 1e-13 && mesh.smallest_jacobian() > 0.0);
            assert_eq!(mesh.boundary_faces().len(), faces);
        }
    }
}
