//! Cauchy stress.

use super::Model;
use super::elements::Elements;
use super::response::Response;

/// Cauchy stress as xx, yy, zz, xy, yz, zx, in Pa, tension positive; in plane strain with its zz. In bodies of revolution x is r, y is z, and the third axis that of the hoop.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Stress(pub [f64; 6]);

impl Stress {
    /// Von Mises' equivalent stress √(3/2 s:s), s the deviator.
    pub fn von_mises(&self) -> f64 {
        let [xx, yy, zz, xy, yz, zx] = self.0;
        let normal = (xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2);
        (0.5 * normal + 3.0 * (xy * xy + yz * yz + zx * zx)).sqrt()
    }

    fn add(&mut self, weight: f64, other: &Self) {
        self.0.iter_mut().zip(other.0).for_each(|(sum, component)| *sum += weight * component);
    }

    fn divided(self, by: f64) -> Self {
        Self(self.0.map(|component| component / by))
    }
}

impl<const D: usize> Model<D> {
    /// Stress of every cell, the mean over its undeformed volume; cells part after part. For a linear elastic part it is
    /// Hooke's stress of the small strain.
    ///
    /// # Panics
    /// If `displacement` is not `[node_count, D]`.
    pub fn stresses(&self, displacement: &[[f64; D]]) -> Vec<Stress> {
        let mut stresses = Vec::with_capacity(self.cell_count());
        self.for_each_point(displacement, |elements, cell, points| {
            let (mut sum, mut volume) = (Stress::default(), 0.0);
            for (point, stress) in points.iter().enumerate() {
                let weight = elements.volumes[cell * elements.points_per_cell + point];
                sum.add(weight, stress);
                volume += weight;
            }
            stresses.push(sum.divided(volume));
        });
        stresses
    }

    /// Stress at every Gauss point of every cell, cell after cell.
    ///
    /// # Panics
    /// If `displacement` is not `[node_count, D]`.
    pub fn point_stresses(&self, displacement: &[[f64; D]]) -> Vec<Stress> {
        let mut stresses = Vec::new();
        self.for_each_point(displacement, |_, _, points| stresses.extend_from_slice(points));
        stresses
    }

    /// Calls `take` with every cell and the stresses of its Gauss points.
    fn for_each_point(&self, displacement: &[[f64; D]], mut take: impl FnMut(&Elements<D>, usize, &[Stress])) {
        assert_eq!(displacement.len(), self.node_count());
        let mut stresses = Vec::new();
        for elements in &self.elements {
            let response = Response::new(&elements.material);
            for (cell, nodes) in elements.conn.chunks_exact(elements.cell_type.node_count()).enumerate() {
                stresses.clear();
                for point in cell * elements.points_per_cell..(cell + 1) * elements.points_per_cell {
                    let s = response.cauchy(&elements.gradient_in_space(point, nodes, displacement));
                    stresses.push(Stress([s[0][0], s[1][1], s[2][2], s[0][1], s[1][2], s[2][0]]));
                }
                take(elements, cell, &stresses);
            }
        }
    }

    /// Stress at every node from those of the cells: the mean of the cells about it, weighted with their volumes.
    ///
    /// # Panics
    /// If there is not one stress per cell.
    pub fn nodal_stresses(&self, cells: &[Stress]) -> Vec<Stress> {
        assert_eq!(cells.len(), self.cell_count());
        let mut sums = vec![(Stress::default(), 0.0); self.node_count()];
        let mut stresses = cells.iter();
        for elements in &self.elements {
            let nodes = elements.conn.chunks_exact(elements.cell_type.node_count());
            let volumes = elements.volumes.chunks_exact(elements.points_per_cell);
            for ((nodes, volumes), stress) in nodes.zip(volumes).zip(&mut stresses) {
                let volume: f64 = volumes.iter().sum();
                for &node in nodes {
                    let (sum, weight) = &mut sums[node as usize];
                    sum.add(volume, stress);
                    *weight += volume;
                }
            }
        }
        sums.into_iter().map(|(sum, weight)| sum.divided(weight)).collect()
    }
}
