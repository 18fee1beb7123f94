//! Stresses of Gauss points carried to the nodes.
//!
//! In a cell the stress is the polynomial nearest to its values at the Gauss points: linear in simplices, linear along each axis in
//! quadrilaterals and hexahedra, and in wedges linear in the triangle and along the axis. A node in the middle of an edge or face has the mean of the corners about it.

use super::quadrature::gauss_points;
use super::shape::{CORNERS, middles};
use super::wedge::{FAR, NEAR};
use super::{Model, Stress};
use fmc_contact::CellType;

impl<const D: usize> Model<D> {
    /// Stress at every node, carried there from the Gauss points of each cell about it: the mean of these cells.
    ///
    /// # Panics
    /// If `displacement` is not `[node_count, D]`.
    pub fn extrapolated_stresses(&self, displacement: &[[f64; D]]) -> Vec<Stress> {
        let points = self.point_stresses(displacement);
        let mut sums = vec![(Stress::default(), 0.0); self.node_count()];
        let mut first = 0;
        for elements in &self.elements {
            let weights = weights(elements.cell_type);
            for nodes in elements.conn.chunks_exact(elements.cell_type.node_count()) {
                let of_cell = &points[first..first + elements.points_per_cell];
                for (&node, weights) in nodes.iter().zip(&weights) {
                    let (sum, count) = &mut sums[node as usize];
                    for (stress, weight) in of_cell.iter().zip(weights) {
                        (0..6).for_each(|k| sum.0[k] += weight * stress.0[k]);
                    }
                    *count += 1.0;
                }
                first += elements.points_per_cell;
            }
        }
        sums.into_iter().map(|(sum, count)| Stress(sum.0.map(|s| s / count))).collect()
    }
}

/// What each Gauss point counts for at each node: `[node_count, point_count]`, rows add up to 1.
fn weights(cell_type: CellType) -> Vec<Vec<f64>> {
    let (points, dimension) = (gauss_points(cell_type), cell_type.dimension());
    let corner_count = cell_type.straight().node_count();
    let is_wedge = cell_type.straight() == CellType::Wedge6;
    let is_simplex = corner_count == dimension + 1;
    // Barycentric coordinates in simplices, that along the axis in wedges, those of the square or cube elsewhere.
    let size = if is_simplex { corner_count } else { dimension };
    let size = if is_wedge { 1 } else { size };
    let corner = |k: usize| -> Vec<f64> {
        let of = |i: usize| match (is_wedge, is_simplex) {
            (true, _) => [-1.0, 1.0][k / 3],
            (_, true) => f64::from(u8::from(i == k)),
            _ => CORNERS[k][i],
        };
        (0..size).map(of).collect()
    };
    let mean = |rows: &[Vec<f64>], around: &[usize], length: usize| -> Vec<f64> {
        (0..length).map(|i| around.iter().map(|&k| rows[k][i]).sum::<f64>() / around.len() as f64).collect()
    };
    let mut places: Vec<Vec<f64>> = (0..corner_count).map(corner).collect();
    let middles = middles(cell_type);
    places.extend(middles.iter().map(|around| mean(&places, around, size)).collect::<Vec<_>>());
    let place_of = |shape: &[f64]| -> Vec<f64> {
        (0..size).map(|i| shape.iter().zip(&places).map(|(n, place)| n * place[i]).sum()).collect()
    };
    let xi: Vec<Vec<f64>> = points.iter().map(|point| place_of(&point.shape)).collect();
    let weight = |k: usize, p: usize| -> f64 {
        if points.len() == 1 {
            return 1.0;
        }
        if is_wedge {
            // One point near each edge along the axis, and Legendre polynomials along it.
            let of_triangle = (f64::from(u8::from(p % 3 == k % 3)) - FAR) / (NEAR - FAR);
            return of_triangle * 6.0 * points[p].weight * (0.5 + 1.5 * xi[p][0] * places[k][0]);
        }
        if is_simplex {
            // One point near each corner: the matrix of their coordinates is (near − far) I + far.
            let (near, far) = (xi[0][0], xi[0][1]);
            return (f64::from(u8::from(p == k)) - far) / (near - far);
        }
        // The first two Legendre polynomials along each axis.
        points[p].weight * (0..dimension).map(|i| 0.5 + 1.5 * xi[p][i] * places[k][i]).product::<f64>()
    };
    let mut rows: Vec<Vec<f64>> =
        (0..corner_count).map(|k| (0..points.len()).map(|p| weight(k, p)).collect()).collect();
    rows.extend(middles.iter().map(|around| mean(&rows, around, points.len())).collect::<Vec<_>>());
    rows
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A linear field, known at the Gauss points, is met at the nodes.
    #[test]
    fn linear_fields_are_met() {
        use CellType::*;
        for cell_type in [Quad4, Tri6, Quad8, Quad9, Hex8, Tet10, Hex20, Hex27, Wedge6, Wedge15] {
            let rows = weights(cell_type);
            let count = cell_type.node_count();
            assert_eq!(rows.len(), count);
            // Any numbers at the corners; a field that is linear between them has means in the middles.
            let corner_count = cell_type.straight().node_count();
            let is_simplex = corner_count == cell_type.dimension() + 1;
            let at = |k: usize| match (corner_count, is_simplex) {
                (6, _) => [0.3, -1.0, 2.0, 0.8, -0.5, 2.5][k],
                (_, true) => [0.3, -1.0, 2.0, 0.7][k],
                _ => {
                    0.3 + CORNERS[k][0] - 0.5 * CORNERS[k][1]
                        + if cell_type.dimension() == 3 { CORNERS[k][2] } else { 0.0 }
                }
            };
            let mut nodes: Vec<f64> = (0..corner_count).map(at).collect();
            let middle = |around: &Vec<usize>| around.iter().map(|&k| at(k)).sum::<f64>() / around.len() as f64;
            nodes.extend(middles(cell_type).iter().map(middle));
            let points = gauss_points(cell_type);
            let values: Vec<f64> =
                points.iter().map(|point| point.shape.iter().zip(&nodes).map(|(n, v)| n * v).sum()).collect();
            for (row, expected) in rows.iter().zip(&nodes) {
                let found: f64 = row.iter().zip(&values).map(|(weight, value)| weight * value).sum();
                assert!((found - expected).abs() < 1e-13, "{cell_type:?}: {found} {expected}");
            }
        }
    }
}
