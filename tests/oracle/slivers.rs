//! The exact estimator in overlaps far thinner than the cells, against closed forms of the coordinates as rounded.

use crate::scene::{Scene, exact, size_sum};
use fmc_shapes::{Diagonals, Mesh, cuboid_hex8, cuboid_tet4, rectangle_quad4, rectangle_tri3};

/// Volume between the straight lower edge (2D) or face (3D) of a body of one cell, from `low` to `high` in x, and a flat
/// top above it. Differences of nearly equal numbers are exact, so this is the volume of the rounded coordinates.
fn between(low: [f64; 2], high: [f64; 2], top: f64, width: f64) -> f64 {
    let (a, b) = (top - low[1], top - high[1]);
    let length = high[0] - low[0];
    let area = match (a > 0.0, b > 0.0) {
        (true, true) => 0.5 * (a + b) * length,
        (true, false) => 0.5 * a * length * a / (a - b),
        (false, true) => 0.5 * b * length * b / (b - a),
        (false, false) => 0.0,
    };
    area * width
}

/// One cell over a block of finer cells, its lower face `depth` below the block's top and falling by `slope · depth`.
fn check<const D: usize>(one: &Mesh<D>, block: &Mesh<D>) {
    for place in [0.0, 1e3] {
        for depth in [1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12] {
            for slope in [0.0, 0.5, 1.9, 3.0, 100.0] {
                let rounding = f64::EPSILON * (1.0 + place);
                // Within some hundred roundings of a coordinate there is no telling touch from overlap.
                if depth < 200.0 * rounding || slope * depth > 0.2 {
                    continue;
                }
                let up = D - 1;
                let mut scene = Scene::of(&[one, block]);
                for node in scene.nodes_of(0) {
                    let x = scene.coords[node];
                    scene.coords[node][up] += -depth + slope * depth * (x[0] - 0.5);
                }
                let scene = scene.mapped(|x| x.map(|x| x + place));
                let lower = |far: bool| {
                    let nodes = scene.nodes_of(0).map(|n| scene.coords[n]);
                    let side = nodes.filter(|x| (x[0] > 0.5 + place) == far);
                    side.min_by(|x, y| x[up].total_cmp(&y[up])).map(|x| [x[0], x[up]]).unwrap_or_default()
                };
                let top = scene.nodes_of(1).map(|n| scene.coords[n][up]).fold(f64::NEG_INFINITY, f64::max);
                let width = if D == 2 { 1.0 } else { extent(&scene, 1) };
                let expected = between(lower(false), lower(true), top, width);
                let contact = scene.evaluate(exact());
                // The planes of facets are known to some roundings of a coordinate, which is what they may miss of the
                // depth; and the place where they cross moves by that over their angle.
                let tolerance = 1e-13 + 20.0 * rounding / depth;
                assert!(
                    (contact.volume / expected - 1.0).abs() < tolerance,
                    "{place} {depth:e} {slope}: {:e} instead of {expected:e}",
                    contact.volume
                );
                let mut sum = [[0.0; D]];
                contact.forces.iter().for_each(|f| (0..D).for_each(|i| sum[0][i] += f[i]));
                assert!(size_sum(&sum) < 1e-12 * size_sum(&contact.forces), "{place} {depth:e} {slope}: {sum:?}");
            }
        }
    }
}

/// Extent of the first body along an axis.
fn extent<const D: usize>(scene: &Scene<D>, axis: usize) -> f64 {
    let along = |n: usize| scene.coords[n][axis];
    let low = scene.nodes_of(0).map(along).fold(f64::INFINITY, f64::min);
    scene.nodes_of(0).map(along).fold(f64::NEG_INFINITY, f64::max) - low
}

#[test]
fn edge_a_little_below_an_edge() {
    let one = rectangle_quad4([0.137, 0.0], [0.871, 0.5], [1, 1]);
    check(&one, &rectangle_quad4([0.0, -0.5], [1.0, 0.0], [8, 3]));
    check(&one, &rectangle_tri3([0.0, -0.5], [1.0, 0.0], [9, 4], Diagonals::Alternating));
}

#[test]
fn face_a_little_below_a_face() {
    let one = cuboid_tet4([0.137, 0.211, 0.0], [0.871, 0.853, 0.5], [1, 1, 1]);
    check(&one, &cuboid_tet4([0.0, 0.0, -0.5], [1.0, 1.0, 0.0], [5, 4, 3]));
    check(&one, &cuboid_hex8([0.0, 0.0, -0.5], [1.0, 1.0, 0.0], [4, 3, 2]));
}
