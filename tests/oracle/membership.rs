//! Volumes by throwing points: a point lies in a shape or it does not, and the error is known.

use fmc_contact::{Pose, Shape};
use fmc_shapes::{Mesh, Splitmix};

/// Whether a point lies in a rigid shape, written down from its definition.
pub(crate) fn in_shape<const D: usize>(shape: &Shape<D>, pose: &Pose<D>, x: &[f64; D]) -> bool {
    // X = Rᵀ (x − position) / scale
    let y: [f64; D] = std::array::from_fn(|j| {
        (0..D).map(|i| pose.rotation[i][j] * (x[i] - pose.position[i])).sum::<f64>() / pose.scale
    });
    let axial = y[D - 1];
    let radial = y[..D - 1].iter().map(|y| y * y).sum::<f64>().sqrt();
    match *shape {
        Shape::HalfSpace => axial <= 0.0,
        Shape::Ball { radius } => radial.hypot(axial) <= radius,
        Shape::Cuboid { half_extents } => y.iter().zip(&half_extents).all(|(y, h)| y.abs() <= *h),
        Shape::Cylinder { radius, half_height } => radial <= radius && axial.abs() <= half_height,
        Shape::Cone { radius, half_height } => {
            axial.abs() <= half_height && radial <= radius * (half_height - axial) / (2.0 * half_height)
        }
        Shape::Capsule { radius, half_height } => radial.hypot((axial.abs() - half_height).max(0.0)) <= radius,
        _ => panic!("no formula for {shape:?}"),
    }
}

/// In how many simplices of a mesh a point lies: 0, 1, or more where the mesh covers itself.
pub(crate) fn cover<const D: usize>(mesh: &Mesh<D>, x: &[f64; D]) -> usize {
    mesh.cells()
        .filter(|cell| {
            let corners: Vec<[f64; D]> = cell.iter().map(|&node| mesh.coords[node as usize]).collect();
            // The simplex with corner k replaced by the point keeps its sign, for every k.
            (0..=D).all(|k| {
                let mut other = corners.clone();
                other[k] = *x;
                determinant(&other) * determinant(&corners) > 0.0
            })
        })
        .count()
}

fn determinant<const D: usize>(x: &[[f64; D]]) -> f64 {
    let e = |k: usize, i: usize| x[k + 1][i] - x[0][i];
    match D {
        2 => e(0, 0) * e(1, 1) - e(0, 1) * e(1, 0),
        _ => (0..3)
            .map(|i| e(0, i) * (e(1, (i + 1) % 3) * e(2, (i + 2) % 3) - e(1, (i + 2) % 3) * e(2, (i + 1) % 3)))
            .sum(),
    }
}

/// Integral of a function with values of 0, 1, … over a box, and its standard error.
pub(crate) fn thrown<const D: usize>(
    [min, max]: [[f64; D]; 2],
    count: usize,
    seed: u64,
    value: impl Fn(&[f64; D]) -> usize,
) -> [f64; 2] {
    let mut random = Splitmix::new(seed);
    let (mut sum, mut squares) = (0.0, 0.0);
    for _ in 0..count {
        let x = std::array::from_fn(|i| random.between(min[i], max[i]));
        let v = value(&x) as f64;
        (sum, squares) = (sum + v, squares + v * v);
    }
    let volume: f64 = (0..D).map(|i| max[i] - min[i]).product();
    let (n, mean) = (count as f64, sum / count as f64);
    [volume * mean, volume * ((squares / n - mean * mean) / n).sqrt()]
}
