//! Gauss points of the cell types, with shape functions there.

use fmc_contact::CellType;

/// A Gauss point of a reference cell.
pub(super) struct GaussPoint {
    /// Weight; all weights of a cell add up to the measure of the reference cell.
    pub(super) weight: f64,
    /// Shape functions, `[node_count]`.
    pub(super) shape: Vec<f64>,
    /// Their derivatives by the reference coordinates, `[node_count, 3]`, zero beyond the dimension.
    pub(super) derivative: Vec<[f64; 3]>,
}

/// Places of the corners of the reference square and cube [−1, 1]ᴰ.
const CORNERS: [[f64; 3]; 8] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
];

/// Gauss points of a cell type: one for simplices, whose gradients are constant; two per axis for the others.
pub(super) fn gauss_points(cell_type: CellType) -> Vec<GaussPoint> {
    let dimension = cell_type.dimension();
    let node_count = cell_type.node_count();
    if node_count == dimension + 1 {
        // N_0 = 1 − Σ ξ_i, N_i = ξ_i on the simplex of measure 1/D!.
        let weight = if dimension == 2 { 0.5 } else { 1.0 / 6.0 };
        let shape = vec![1.0 / node_count as f64; node_count];
        let derivative = (0..node_count)
            .map(|node| {
                std::array::from_fn(|axis| match node {
                    0 if axis < dimension => -1.0,
                    _ if node == axis + 1 => 1.0,
                    _ => 0.0,
                })
            })
            .collect();
        return vec![GaussPoint { weight, shape, derivative }];
    }
    // N_a = Π_i (1 + ξ_i c_ai)/2 with corners c_a; the points lie at ±1/√3, in the order of the corners.
    CORNERS[..node_count]
        .iter()
        .map(|corner| {
            let xi = corner.map(|c| c / 3f64.sqrt());
            let factor = |node: usize, axis: usize| 0.5 * (1.0 + xi[axis] * CORNERS[node][axis]);
            let product = |node: usize, without: Option<usize>| -> f64 {
                (0..dimension).filter(|&axis| Some(axis) != without).map(|axis| factor(node, axis)).product()
            };
            let slope = |node: usize, axis: usize| match axis < dimension {
                true => 0.5 * CORNERS[node][axis] * product(node, Some(axis)),
                false => 0.0,
            };
            GaussPoint {
                weight: 1.0,
                shape: (0..node_count).map(|node| product(node, None)).collect(),
                derivative: (0..node_count).map(|node| std::array::from_fn(|axis| slope(node, axis))).collect(),
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shape_functions_add_up_to_one() {
        for (cell_type, measure) in
            [(CellType::Tri3, 0.5), (CellType::Quad4, 4.0), (CellType::Tet4, 1.0 / 6.0), (CellType::Hex8, 8.0)]
        {
            let points = gauss_points(cell_type);
            assert!((points.iter().map(|p| p.weight).sum::<f64>() - measure).abs() < 1e-15);
            for point in points {
                assert!((point.shape.iter().sum::<f64>() - 1.0).abs() < 1e-15);
                for axis in 0..3 {
                    assert!(point.derivative.iter().map(|d| d[axis]).sum::<f64>().abs() < 1e-15);
                }
            }
        }
    }
}
