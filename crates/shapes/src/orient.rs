//! Cells turned the right way round.

use crate::Mesh;

impl<const D: usize> Mesh<D> {
    /// Every cell of negative measure with its nodes in the mirrored order, which makes it positive; mesh files often
    /// hold cells of both kinds. Cells that are positive stay as they are.
    ///
    /// # Panics
    /// For a surface.
    pub fn oriented(mut self) -> Self {
        assert!(self.nodes_per_cell > D, "the facets of a surface have no measure of their own");
        let negative: Vec<bool> = self.cells().map(|cell| self.cell_measure(cell) < 0.0).collect();
        let cells = self.conn.chunks_exact_mut(self.nodes_per_cell);
        for (cell, _) in cells.zip(negative).filter(|(_, negative)| *negative) {
            match cell.len() {
                6 => [1, 4].into_iter().for_each(|node| cell.swap(node, node + 1)),
                5 => cell.swap(1, 3),
                8 => [1, 5].into_iter().for_each(|node| cell.swap(node, node + 2)),
                4 if D == 2 => cell.swap(1, 3),
                _ => cell.swap(1, 2),
            }
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use crate::{Diagonals, Mesh, cuboid_hex8, cuboid_tet4, rectangle_quad4, rectangle_tri3};

    /// A mirrored mesh has only negative cells.
    fn mirrored_cells_become_positive<const D: usize>(mesh: Mesh<D>) {
        let mirrored = mesh.clone().mapped(|x| x.map(|x| -x)).mapped(|mut x| {
            x[0] *= if D == 2 { -1.0 } else { 1.0 };
            x
        });
        assert!(mirrored.measure() < 0.0);
        let turned = mirrored.oriented();
        assert!(turned.smallest_jacobian() > 0.0 && (turned.measure() - mesh.measure()).abs() < 1e-13);
        assert_eq!(mesh.clone().oriented(), mesh);
    }

    #[test]
    fn mirrored_cells_become_positive_in_every_type() {
        mirrored_cells_become_positive(rectangle_tri3([0.0; 2], [1.0; 2], [2, 3], Diagonals::Same));
        mirrored_cells_become_positive(rectangle_quad4([0.0; 2], [1.0; 2], [2, 3]));
        mirrored_cells_become_positive(cuboid_tet4([0.0; 3], [1.0; 3], [2; 3]));
        mirrored_cells_become_positive(cuboid_hex8([0.0; 3], [1.0; 3], [2; 3]));
    }
}
