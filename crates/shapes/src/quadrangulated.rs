//! Triangles cut into quadrilaterals.

use crate::Mesh;

impl Mesh<2> {
    /// `Tri6` cells cut into three `Quad4` each, from the nodes in the middle of their edges to the cell's own middle.
    ///
    /// # Panics
    /// For other cells.
    pub fn quadrangulated(&self) -> Self {
        assert_eq!(self.nodes_per_cell, 6, "only triangles of second order are cut at their middles");
        let mut coords = self.coords.clone();
        let mut conn = Vec::with_capacity(12 * self.cell_count());
        for cell in self.cells() {
            let centre = coords.len() as u32;
            // Shape functions at the centroid: −1/9 of the corners, 4/9 of the middles.
            coords.push([0, 1].map(|i| {
                let sum = |nodes: &[u32]| nodes.iter().map(|&node| self.coords[node as usize][i]).sum::<f64>();
                (4.0 * sum(&cell[3..]) - sum(&cell[..3])) / 9.0
            }));
            (0..3).for_each(|k| conn.extend([cell[k], cell[3 + k], centre, cell[3 + (k + 2) % 3]]));
        }
        Self { coords, conn, nodes_per_cell: 4 }
    }
}

#[cfg(test)]
mod tests {
    use crate::{disc_tri3, second_order};

    #[test]
    fn quadrilaterals_fill_the_triangles() {
        let triangles = disc_tri3(2.0, 12);
        let quads = second_order(&triangles, 6).quadrangulated();
        assert_eq!((quads.cell_count(), quads.euler_characteristic()), (3 * triangles.cell_count(), 1));
        assert!((quads.measure() - triangles.measure()).abs() < 1e-13 && quads.smallest_jacobian() > 0.0);
    }
}
