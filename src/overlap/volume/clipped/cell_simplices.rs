//! Cells as simplices.

use crate::geometry::Vector;
use crate::geometry::mesh::cells::Cells;
use crate::geometry::primitives::simplex::Simplex;

/// Corner opposite to every face of a triangle, and of a tetrahedron.
const OPPOSITE: [&[usize]; 2] = [&[2, 0, 1], &[3, 2, 0, 1]];

/// Calls `visit` for every simplex of a cell: triangles and tetrahedra as they are, others split about the centroids of
/// the cell and of its quadrilateral faces, so that neighbours agree on the faces between them.
pub(crate) fn for_each_simplex<const D: usize>(
    cells: &Cells,
    cell: usize,
    coords: &[[f64; D]],
    mut visit: impl FnMut(Simplex<D>),
) {
    let nodes = cells.nodes(cell);
    let cell_type = cells.cell_type(cell);
    let (bounds, flipped) = (cells.boundary[cell], cells.is_flipped(cell));
    let at = |n: u32| Vector::<D>::from(coords[n as usize]);
    let mut x = [Vector::zeros(); 8];
    for (x, &n) in x.iter_mut().zip(nodes) {
        *x = at(n);
    }
    if cell_type.is_simplex() {
        let opposite = OPPOSITE[D - 2];
        let boundary = opposite.iter().enumerate().fold(0, |mask, (face, &k)| mask | (bounds >> face & 1) << k);
        Simplex::new(&x, boundary, flipped).into_iter().for_each(visit);
        return;
    }
    let center = mean(&x[..nodes.len()]);
    for (f, face) in cell_type.faces().iter().enumerate() {
        // Opposite to the last corner, the cell's centre, lies the face.
        let boundary = (bounds >> f & 1) << D;
        if D == 2 {
            Simplex::new(&[x[face[0]], x[face[1]], center], boundary, flipped).into_iter().for_each(&mut visit);
            continue;
        }
        if let [p, q, r] = **face {
            Simplex::new(&[x[q], x[p], x[r], center], boundary, flipped).into_iter().for_each(&mut visit);
            continue;
        }
        // In the order of node numbers: the same bits for both cells at the face.
        let mut four: [u32; 4] = std::array::from_fn(|k| nodes[face[k]]);
        four.sort_unstable();
        let middle = mean(&four.map(at));
        for k in 0..4 {
            let corners = [x[face[(k + 1) % 4]], x[face[k]], middle, center];
            Simplex::new(&corners, boundary, flipped).into_iter().for_each(&mut visit);
        }
    }
}

fn mean<const D: usize>(x: &[Vector<D>]) -> Vector<D> {
    x.iter().fold(Vector::zeros(), |s, x| s + x) / x.len() as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::CellType;

    #[test]
    fn opposite_corners_are_not_on_the_face() {
        for (cell_type, opposite) in [CellType::Tri3, CellType::Tet4].into_iter().zip(OPPOSITE) {
            assert!(cell_type.faces().iter().zip(opposite).all(|(face, k)| !face.contains(k)));
        }
    }
}
