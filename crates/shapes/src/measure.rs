//! Lengths, areas and volumes, and whether cells are valid.

use crate::Mesh;
use crate::boundary::faces;

/// Determinant of the edge vectors from `x[0]`: D! times the measure of a simplex.
fn determinant<const D: usize>(x: &[[f64; D]]) -> f64 {
    let e = |k: usize, i: usize| x[k][i] - x[0][i];
    match D {
        2 => e(1, 0) * e(2, 1) - e(1, 1) * e(2, 0),
        3 => (0..3)
            .map(|i| {
                let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                e(1, i) * (e(2, j) * e(3, k) - e(2, k) * e(3, j))
            })
            .sum(),
        _ => panic!("meshes are of dimension 2 or 3, not {D}"),
    }
}

/// Edges at each corner of a wedge, in the order of a positive triple product.
const WEDGE_CORNERS: [[usize; 4]; 6] =
    [[0, 1, 2, 3], [1, 2, 0, 4], [2, 0, 1, 5], [3, 5, 4, 0], [4, 3, 5, 1], [5, 4, 3, 2]];

/// The same at the corners of a pyramid's base.
const PYRAMID_CORNERS: [[usize; 4]; 4] = [[0, 1, 3, 4], [1, 2, 0, 4], [2, 3, 1, 4], [3, 0, 2, 4]];

/// Edges at each corner of a hexahedron, in the order of a positive triple product.
const HEX_CORNERS: [[usize; 4]; 8] =
    [[0, 1, 3, 4], [1, 2, 0, 5], [2, 3, 1, 6], [3, 0, 2, 7], [4, 7, 5, 0], [5, 4, 6, 1], [6, 5, 7, 2], [7, 6, 4, 3]];

impl<const D: usize> Mesh<D> {
    /// Area (2D) or volume (3D) of all cells; of a closed surface, what it encloses.
    ///
    /// Cells are taken with each quadrilateral face split into four triangles about its centroid, which agrees between neighbours.
    pub fn measure(&self) -> f64 {
        self.cells().map(|cell| self.cell_measure(cell)).sum()
    }

    /// Measure of one cell; of a facet, of the cone from the first node of the mesh over it.
    pub(crate) fn cell_measure(&self, cell: &[u32]) -> f64 {
        let x: Vec<[f64; D]> = cell.iter().map(|&node| self.coords[node as usize]).collect();
        let factorial = if D == 2 { 2.0 } else { 6.0 };
        if x.len() == D {
            let cone: Vec<_> = std::iter::once(self.coords[0]).chain(x).collect();
            return determinant(&cone) / factorial;
        }
        match (D, x.len()) {
            (2, 3) | (3, 4) => determinant(&x) / factorial,
            (2, 4) => (determinant(&x[..3]) + determinant(&[x[0], x[2], x[3]])) / factorial,
            (3, 5 | 6 | 8) => {
                let cone = |face: &&[usize]| {
                    if let [p, q, r] = **face {
                        return determinant(&[x[0], x[p], x[q], x[r]]);
                    }
                    let centre = std::array::from_fn(|i| face.iter().map(|&k| x[k][i]).sum::<f64>() / 4.0);
                    (0..4).map(|k| determinant(&[x[0], centre, x[face[k]], x[face[(k + 1) % 4]]])).sum::<f64>()
                };
                faces(D, x.len()).iter().map(cone).sum::<f64>() / factorial
            }
            (d, n) => panic!("no cell of dimension {d} with {n} nodes"),
        }
    }

    /// Smallest determinant of the edges at a corner, over all cells: positive if every cell is valid.
    ///
    /// # Panics
    /// For a surface.
    pub fn smallest_jacobian(&self) -> f64 {
        self.cells().map(|cell| self.cell_jacobian(cell)).fold(f64::INFINITY, f64::min)
    }

    /// Smallest determinant of the edges at a corner of one cell.
    pub(crate) fn cell_jacobian(&self, cell: &[u32]) -> f64 {
        let at = |corner: &[usize]| {
            let x: Vec<[f64; D]> = corner.iter().map(|&k| self.coords[cell[k] as usize]).collect();
            determinant(&x)
        };
        match (D, cell.len()) {
            (2, 3) => at(&[0, 1, 2]),
            (3, 4) => at(&[0, 1, 2, 3]),
            (2, 4) => (0..4).map(|k| at(&[k, (k + 1) % 4, (k + 3) % 4])).fold(f64::INFINITY, f64::min),
            (3, 5) => PYRAMID_CORNERS.iter().map(|corner| at(corner)).fold(f64::INFINITY, f64::min),
            (3, 6) => WEDGE_CORNERS.iter().map(|corner| at(corner)).fold(f64::INFINITY, f64::min),
            (3, 8) => HEX_CORNERS.iter().map(|corner| at(corner)).fold(f64::INFINITY, f64::min),
            (d, n) => panic!("no cell of dimension {d} with {n} nodes"),
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::Mesh;

    #[test]
    fn inverted_cells_are_negative() {
        let coords = vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        let mesh = |conn| Mesh { coords: coords.clone(), conn, nodes_per_cell: 3 };
        assert_eq!((mesh(vec![0, 1, 2]).measure(), mesh(vec![0, 1, 2]).smallest_jacobian()), (0.5, 1.0));
        assert_eq!((mesh(vec![0, 2, 1]).measure(), mesh(vec![0, 2, 1]).smallest_jacobian()), (-0.5, -1.0));
    }
}
