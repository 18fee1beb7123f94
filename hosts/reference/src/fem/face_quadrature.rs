//! Gauss points of faces.

use super::quadrature::GAUSS;
use super::shape::{Shape, second_order, second_order_edge};
use fmc_contact::CellType;

/// A Gauss point of a face.
pub(super) struct FacePoint {
    /// Shape functions of the face's nodes.
    pub(super) shape: Vec<f64>,
    /// Their derivatives by the face's coordinates; `None` on faces of first order, whose tangents follow from `shape`.
    pub(super) slopes: Option<Vec<[f64; 3]>>,
    /// Weight.
    pub(super) weight: f64,
}

/// Places nearest a corner, and weight, of the rule of degree 4 in a triangle: two orbits of three points. Dunavant, "High
/// degree efficient symmetrical Gaussian quadrature rules for the triangle".
const TRIANGLE: [(f64, f64); 2] =
    [(0.108_103_018_168_070_23, 0.111_690_794_839_005_73), (0.816_847_572_980_458_5, 0.054_975_871_827_660_935)];

/// Gauss points of a face with as many nodes.
///
/// Edges: two points; triangles: three inside; quadrilaterals: two per axis. Of second order, exact for uniform pressure on
/// curved faces: edges: three; triangles: six; quadrilaterals: three per axis.
pub(super) fn face_points(dimension: usize, node_count: usize) -> Vec<FacePoint> {
    let at = 0.5 - 0.5 / 3f64.sqrt();
    let straight = |(shape, weight): (Vec<f64>, f64)| FacePoint { shape, slopes: None, weight };
    let curved = |(shapes, weight): (Vec<Shape>, f64)| {
        let (shape, slopes): (Vec<f64>, Vec<[f64; 3]>) = shapes.into_iter().unzip();
        FacePoint { shape, slopes: Some(slopes), weight }
    };
    let of = |cell_type: CellType, xi: [f64; 3], weight: f64| Some(curved((second_order(cell_type, xi)?, weight)));
    match (dimension, node_count) {
        (2, 2) => [at, 1.0 - at].map(|s| straight((vec![1.0 - s, s], 0.5))).into(),
        (2, _) => GAUSS.map(|(x, weight)| curved((second_order_edge(0.5 + 0.5 * x), 0.5 * weight))).into(),
        (_, 3) => [0, 1, 2]
            .map(|node| straight(((0..3).map(|k| if k == node { 2.0 / 3.0 } else { 1.0 / 6.0 }).collect(), 1.0 / 6.0)))
            .into(),
        (_, 4) => [[at, at], [1.0 - at, at], [1.0 - at, 1.0 - at], [at, 1.0 - at]]
            .map(|[s, t]| straight((vec![(1.0 - s) * (1.0 - t), s * (1.0 - t), s * t, (1.0 - s) * t], 0.25)))
            .into(),
        (_, 6) => {
            let orbit = |(near, weight): (f64, f64)| {
                let far = 0.5 - 0.5 * near;
                [[far, far], [near, far], [far, near]].map(|[s, t]| of(CellType::Tri6, [s, t, 0.0], weight))
            };
            TRIANGLE.into_iter().flat_map(orbit).flatten().collect()
        }
        _ => {
            let cell_type = if node_count == 8 { CellType::Quad8 } else { CellType::Quad9 };
            let row = |(y, w): (f64, f64)| GAUSS.map(|(x, v)| of(cell_type, [x, y, 0.0], v * w));
            GAUSS.into_iter().flat_map(row).flatten().collect()
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Weights of the rules and, for second order, the integrals of the shape functions: Simpson's 1/6 and 2/3 on an edge, 0
    /// and 1/3 of a triangle, −1/12 and 1/3 of a quadrilateral of eight nodes, 1/36, 1/9 and 4/9 of one of nine.
    #[test]
    fn shape_functions_have_their_integrals() {
        let integrals: [(usize, usize, f64, [f64; 3]); 4] = [
            (2, 3, 1.0, [1.0 / 6.0, 2.0 / 3.0, 0.0]),
            (3, 6, 0.5, [0.0, 1.0 / 3.0, 0.0]),
            (3, 8, 4.0, [-1.0 / 12.0, 1.0 / 3.0, 0.0]),
            (3, 9, 4.0, [1.0 / 36.0, 1.0 / 9.0, 4.0 / 9.0]),
        ];
        for (dimension, count, measure, [corner, edge, middle]) in integrals {
            let points = face_points(dimension, count);
            assert!((points.iter().map(|point| point.weight).sum::<f64>() - measure).abs() < 1e-14);
            let corners = if count == 9 { 4 } else { count.div_ceil(2) };
            for node in 0..count {
                let share = points.iter().map(|point| point.weight * point.shape[node]).sum::<f64>() / measure;
                let expected = if node < corners {
                    corner
                } else if node < 2 * corners {
                    edge
                } else {
                    middle
                };
                assert!((share - expected).abs() < 1e-15, "{count} nodes: {share} at {node}");
            }
        }
    }
}
