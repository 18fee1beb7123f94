//! Round boundaries of cells of second order.

use crate::Mesh;
use crate::second_order::middles;
use std::collections::BTreeSet;

impl<const D: usize> Mesh<D> {
    /// The cells of second order with the nodes in the middle of boundary edges on a circle (3D: sphere), where both ends of the
    /// edge are: moved along the radius. Nodes in the middle of faces stay the mean of those around them.
    ///
    /// # Panics
    /// For cells of first order.
    pub fn rounded(mut self, centre: [f64; D], radius: f64) -> Self {
        let Some((corners, middles)) = middles(D, self.nodes_per_cell) else {
            panic!("cells of {} nodes have no middles", self.nodes_per_cell);
        };
        let away = |x: &[f64; D]| (0..D).map(|i| (x[i] - centre[i]).powi(2)).sum::<f64>().sqrt();
        let is_round = |x: &[f64; D]| (away(x) - radius).abs() <= 1e-9 * radius;
        let surface: BTreeSet<u32> = self.boundary_faces().concat().into_iter().collect();
        let mut moved = BTreeSet::new();
        for cell in 0..self.cell_count() {
            for (middle, around) in middles.iter().enumerate().filter(|(_, around)| around.len() == 2) {
                let at = |local: usize| self.conn[cell * self.nodes_per_cell + local];
                let node = at(corners + middle);
                let ends = around.iter().all(|&corner| is_round(&self.coords[at(corner) as usize]));
                // An edge through the body may have both its ends on the sphere.
                if ends && surface.contains(&node) && moved.insert(node) {
                    let x = &mut self.coords[node as usize];
                    let scale = radius / away(x);
                    *x = std::array::from_fn(|i| centre[i] + scale * (x[i] - centre[i]));
                }
            }
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use crate::{disc_tri3, second_order};

    /// The middle of every boundary edge is on the circle, and no other node has moved.
    #[test]
    fn middles_of_the_boundary_come_to_the_circle() {
        let straight = second_order(&disc_tri3(2.0, 12), 6);
        let round = straight.clone().rounded([0.0; 2], 2.0);
        let boundary = straight.boundary_faces();
        assert_eq!(boundary, round.boundary_faces());
        let moved = (0..straight.coords.len()).filter(|&node| straight.coords[node] != round.coords[node]);
        let mut middles: Vec<usize> = boundary.iter().map(|face| face[2] as usize).collect();
        middles.sort_unstable();
        assert_eq!(moved.collect::<Vec<_>>(), middles);
        for node in middles {
            assert!((round.coords[node][0].hypot(round.coords[node][1]) - 2.0).abs() < 1e-14);
        }
    }
}
