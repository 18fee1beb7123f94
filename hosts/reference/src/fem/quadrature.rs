//! Gauss points of the cell types, with shape functions there.

use super::shape::{CORNERS, second_order};
use super::wedge::{FAR, NEAR, wedge};
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

/// Gauss points of a cell type: one for simplices, whose gradients are constant, two per axis for quadrilaterals and
/// hexahedra; three in a triangle of second order, four in such a tetrahedron, three per axis in the others. In wedges three in the triangle times
/// two along the axis, of second order three.
pub(super) fn gauss_points(cell_type: CellType) -> Vec<GaussPoint> {
    let dimension = cell_type.dimension();
    let node_count = cell_type.node_count();
    if cell_type.straight() == CellType::Wedge6 {
        return wedge_points(node_count);
    }
    if cell_type != cell_type.straight() {
        let of = |(xi, weight): ([f64; 3], f64)| {
            let shapes = second_order(cell_type, xi)?;
            let (shape, derivative) = shapes.into_iter().unzip();
            Some(GaussPoint { weight, shape, derivative })
        };
        return rule(cell_type).into_iter().filter_map(of).collect();
    }
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

/// Gauss points of a wedge: three in the triangle, each near a corner, times two along the axis, of second order three.
fn wedge_points(count: usize) -> Vec<GaussPoint> {
    let two = [-1.0, 1.0].map(|sign| (sign / 3f64.sqrt(), 1.0));
    let along: &[(f64, f64)] = if count == 6 { &two } else { &GAUSS };
    let near = [[FAR, FAR], [NEAR, FAR], [FAR, NEAR]];
    let point = |zeta: f64, weight: f64, [xi, eta]: [f64; 2]| {
        let (shape, derivative) = wedge(count, [xi, eta, zeta]).into_iter().unzip();
        GaussPoint { weight: weight / 6.0, shape, derivative }
    };
    along.iter().flat_map(|&(zeta, weight)| near.map(|xi| point(zeta, weight, xi))).collect()
}

/// Points and weights in cells of second order. All weights are positive and no element has more motions without energy
/// than those of a rigid body. Exact for the stiffness of a cell of straight, evenly divided edges (parallelograms), and, in 2D
/// and for hexahedra, for uniform stress in any cell; in tetrahedra, for uniform stress where the edges are straight.
fn rule(cell_type: CellType) -> Vec<([f64; 3], f64)> {
    let barycentric = |count: usize, near: f64, far: f64, weight: f64| {
        (0..count).map(move |node| {
            let place = std::array::from_fn(|axis| match axis + 1 {
                k if k >= count => 0.0,
                k if k == node => near,
                _ => far,
            });
            (place, weight)
        })
    };
    match cell_type {
        CellType::Tri6 => barycentric(3, 2.0 / 3.0, 1.0 / 6.0, 1.0 / 6.0).collect(),
        CellType::Tet10 => {
            let far = (5.0 - 5f64.sqrt()) / 20.0;
            barycentric(4, 1.0 - 3.0 * far, far, 1.0 / 24.0).collect()
        }
        _ if cell_type.dimension() == 2 => {
            let points = GAUSS.iter().flat_map(|&(y, w)| GAUSS.map(|(x, v)| ([x, y, 0.0], v * w)));
            points.collect()
        }
        _ => {
            let layer =
                |(z, u): (f64, f64)| GAUSS.iter().flat_map(move |&(y, w)| GAUSS.map(|(x, v)| ([x, y, z], u * v * w)));
            GAUSS.into_iter().flat_map(layer).collect()
        }
    }
}

/// Gauss' three points on [−1, 1], ±√(3/5), and their weights.
pub(super) const GAUSS: [(f64, f64); 3] =
    [(-0.774_596_669_241_483_4, 5.0 / 9.0), (0.0, 8.0 / 9.0), (0.774_596_669_241_483_4, 5.0 / 9.0)];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shape_functions_add_up_to_one() {
        for (cell_type, measure) in [
            (CellType::Tri3, 0.5),
            (CellType::Quad4, 4.0),
            (CellType::Tet4, 1.0 / 6.0),
            (CellType::Hex8, 8.0),
            (CellType::Wedge6, 1.0),
            (CellType::Wedge15, 1.0),
            (CellType::Tri6, 0.5),
            (CellType::Quad8, 4.0),
            (CellType::Quad9, 4.0),
            (CellType::Tet10, 1.0 / 6.0),
            (CellType::Hex20, 8.0),
            (CellType::Hex27, 8.0),
        ] {
            let points = gauss_points(cell_type);
            assert!((points.iter().map(|p| p.weight).sum::<f64>() - measure).abs() < 1e-14);
            for point in points {
                assert!((point.shape.iter().sum::<f64>() - 1.0).abs() < 1e-14);
                for axis in 0..3 {
                    assert!(point.derivative.iter().map(|d| d[axis]).sum::<f64>().abs() < 1e-14);
                }
            }
        }
    }
}
