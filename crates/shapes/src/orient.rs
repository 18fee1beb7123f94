//! Cells turned the right way round.

use crate::Mesh;
use crate::second_order::middles;
use std::collections::BTreeSet;

impl<const D: usize> Mesh<D> {
    /// Every cell of negative measure with its nodes in the mirrored order, which makes it positive; mesh files often
    /// hold cells of both kinds. Cells that are positive stay as they are. The sign of a cell of second order is that of its
    /// corners.
    ///
    /// # Panics
    /// For a surface.
    pub fn oriented(mut self) -> Self {
        assert!(self.nodes_per_cell > D, "the facets of a surface have no measure of their own");
        let (corners, middles) = middles(D, self.nodes_per_cell).unwrap_or((self.nodes_per_cell, Vec::new()));
        let negative: Vec<bool> = self.cells().map(|cell| self.cell_measure(&cell[..corners]) < 0.0).collect();
        let mut order: Vec<usize> = (0..corners).collect();
        match corners {
            6 => [1, 4].into_iter().for_each(|node| order.swap(node, node + 1)),
            5 => order.swap(1, 3),
            8 => [1, 5].into_iter().for_each(|node| order.swap(node, node + 2)),
            4 if D == 2 => order.swap(1, 3),
            _ => order.swap(1, 2),
        }
        // What lay between corners lies between those that take their places.
        for around in &middles {
            let wanted: BTreeSet<usize> = around.iter().map(|&corner| order[corner]).collect();
            let same = |other: &Vec<usize>| other.iter().copied().collect::<BTreeSet<_>>() == wanted;
            let middle = middles.iter().position(same).expect("the mirror image of a cell is one");
            order.push(corners + middle);
        }
        let cells = self.conn.chunks_exact_mut(self.nodes_per_cell);
        for (cell, _) in cells.zip(negative).filter(|(_, negative)| *negative) {
            let turned: Vec<u32> = order.iter().map(|&place| cell[place]).collect();
            cell.copy_from_slice(&turned);
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use crate::{Diagonals, Mesh, cuboid_hex8, cuboid_tet4, rectangle_quad4, rectangle_tri3, second_order};

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

    /// Cells of second order have their middles where the mirrored corners have them.
    #[test]
    fn middles_are_turned_with_their_corners() {
        let (square, cube) = (rectangle_quad4([0.0; 2], [1.0; 2], [1, 1]), cuboid_hex8([0.0; 3], [1.0; 3], [1; 3]));
        let turned = |x: &mut [[f64; 3]]| x.iter_mut().for_each(|x| x[0] = -x[0]);
        for (straight, nodes) in [(cuboid_tet4([0.0; 3], [1.0; 3], [1; 3]), 10), (cube.clone(), 20), (cube, 27)] {
            let mut mesh = second_order(&straight, nodes);
            let mut corners = straight;
            turned(&mut mesh.coords);
            turned(&mut corners.coords);
            let wanted = second_order(&corners.oriented(), nodes);
            let at = |mesh: &Mesh<3>| mesh.conn.iter().map(|&n| mesh.coords[n as usize]).collect::<Vec<_>>();
            assert_eq!(at(&mesh.oriented()), at(&wanted));
        }
        for nodes in [8, 9] {
            let mesh = second_order(&square, nodes).mapped(|[x, y]| [-x, y]);
            let wanted = second_order(&square.clone().mapped(|[x, y]| [-x, y]).oriented(), nodes);
            let at = |mesh: &Mesh<2>| mesh.conn.iter().map(|&n| mesh.coords[n as usize]).collect::<Vec<_>>();
            assert_eq!(at(&mesh.oriented()), at(&wanted));
        }
    }

    #[test]
    fn mirrored_cells_become_positive_in_every_type() {
        mirrored_cells_become_positive(rectangle_tri3([0.0; 2], [1.0; 2], [2, 3], Diagonals::Same));
        mirrored_cells_become_positive(rectangle_quad4([0.0; 2], [1.0; 2], [2, 3]));
        mirrored_cells_become_positive(cuboid_tet4([0.0; 3], [1.0; 3], [2; 3]));
        mirrored_cells_become_positive(cuboid_hex8([0.0; 3], [1.0; 3], [2; 3]));
    }
}
