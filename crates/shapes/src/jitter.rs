//! Disturbed meshes whose cells stay valid.

use crate::{Mesh, Splitmix};

/// A cell may lose this much of its smallest corner determinant, not more: it stays far from degenerate.
const LEAST_JACOBIAN: f64 = 0.2;

impl<const D: usize> Mesh<D> {
    /// Nodes where `movable` holds moved at random, by up to `amplitude` times their shortest edge in every direction.
    ///
    /// Where that would spoil a cell, its nodes move half as far, again and again: any amplitude gives valid cells.
    pub fn jittered(self, amplitude: f64, seed: u64, movable: impl Fn(&[f64; D]) -> bool) -> Self {
        let mut random = Splitmix::new(seed);
        let shortest = self.shortest_edges();
        let mut shift: Vec<[f64; D]> = Vec::with_capacity(self.coords.len());
        for (x, edge) in self.coords.iter().zip(&shortest) {
            let direction: [f64; D] = std::array::from_fn(|_| random.between(-1.0, 1.0));
            shift.push(if movable(x) { direction.map(|d| d * amplitude * edge) } else { [0.0; D] });
        }
        let least: Vec<f64> = self.cells().map(|cell| LEAST_JACOBIAN * self.cell_jacobian(cell)).collect();
        loop {
            let mut moved = self.clone();
            for (x, s) in moved.coords.iter_mut().zip(&shift) {
                *x = std::array::from_fn(|i| x[i] + s[i]);
            }
            let spoiled: Vec<&[u32]> = self
                .cells()
                .zip(&least)
                .filter(|(cell, least)| moved.cell_jacobian(cell) < **least)
                .map(|c| c.0)
                .collect();
            if spoiled.is_empty() {
                return moved;
            }
            let mut nodes = spoiled.concat();
            nodes.sort_unstable();
            nodes.dedup();
            nodes.iter().for_each(|&node| shift[node as usize] = shift[node as usize].map(|s| 0.5 * s));
        }
    }

    /// Shortest distance of each node to another node of its cells.
    fn shortest_edges(&self) -> Vec<f64> {
        let mut shortest = vec![f64::INFINITY; self.coords.len()];
        for cell in self.cells() {
            for &a in cell {
                for &b in cell.iter().filter(|&&b| b != a) {
                    let (x, y) = (self.coords[a as usize], self.coords[b as usize]);
                    let distance = (0..D).map(|i| (x[i] - y[i]).powi(2)).sum::<f64>().sqrt();
                    shortest[a as usize] = shortest[a as usize].min(distance);
                }
            }
        }
        shortest
    }
}

#[cfg(test)]
mod tests {
    use crate::{cuboid_hex8, cuboid_tet4, rectangle_quad4};

    #[test]
    fn jittered_cells_stay_valid() {
        for seed in 0..10 {
            assert!(
                rectangle_quad4([0.0; 2], [1.0; 2], [6, 6]).jittered(0.9, seed, |_| true).smallest_jacobian() > 0.0
            );
            assert!(cuboid_hex8([0.0; 3], [1.0; 3], [3; 3]).jittered(0.9, seed, |_| true).smallest_jacobian() > 0.0);
            assert!(cuboid_tet4([0.0; 3], [1.0; 3], [3; 3]).jittered(0.5, seed, |_| true).smallest_jacobian() > 0.0);
        }
    }

    #[test]
    fn fixed_nodes_keep_the_shape() {
        let inside = |x: &[f64; 2]| x.iter().all(|x| *x > 1e-9 && *x < 1.0 - 1e-9);
        let mesh = rectangle_quad4([0.0; 2], [1.0; 2], [6, 6]);
        let moved = mesh.clone().jittered(0.3, 3, inside);
        assert_ne!(mesh, moved);
        assert!((moved.measure() - 1.0).abs() < 1e-14);
    }
}
