//! Joining blocks of a mesh at coincident nodes.

use crate::Mesh;

impl<const D: usize> Mesh<D> {
    /// Nodes closer than `tolerance` in every coordinate become one, the first of them.
    pub fn welded(self, tolerance: f64) -> Self {
        let mut by_x: Vec<u32> = (0..self.coords.len() as u32).collect();
        let x = |node: u32| &self.coords[node as usize];
        by_x.sort_by(|&a, &b| x(a)[0].total_cmp(&x(b)[0]).then(a.cmp(&b)));
        let mut representative: Vec<u32> = (0..self.coords.len() as u32).collect();
        for (rank, &node) in by_x.iter().enumerate() {
            for &other in by_x[rank + 1..].iter().take_while(|&&other| x(other)[0] - x(node)[0] <= tolerance) {
                if (0..D).all(|i| (x(other)[i] - x(node)[i]).abs() <= tolerance) {
                    let first = representative[node as usize].min(representative[other as usize]);
                    representative[node as usize] = first;
                    representative[other as usize] = first;
                }
            }
        }
        // A chain of merges is followed to its first node, which has the lowest id and so stands before.
        for node in 0..representative.len() {
            representative[node] = representative[representative[node] as usize];
        }
        let conn = self.conn.iter().map(|&node| representative[node as usize]).collect();
        Self { conn, ..self }.without_unused_nodes()
    }
}

#[cfg(test)]
mod tests {
    use crate::rectangle_quad4;

    #[test]
    fn welded_blocks_share_their_seam() {
        let mut mesh = rectangle_quad4([0.0; 2], [1.0; 2], [3, 3]);
        mesh.append(&rectangle_quad4([1.0, 0.0], [2.0, 1.0], [2, 3]));
        let mesh = mesh.welded(1e-9);
        assert_eq!(mesh.coords.len(), 6 * 4);
        assert_eq!(mesh.boundary().cell_count(), 16);
    }
}
