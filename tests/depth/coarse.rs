//! Blocks of few cells: the law has almost what it would have if the depth were the true distance from the surface
//! everywhere.

use crate::depth;
use crate::scene::Scene;
use fmc_shapes::{Diagonals, Mesh, cuboid_hex8, cuboid_tet4, rectangle_quad4, rectangle_tri3};

/// Penetrations by the size of a cell.
const BY_H: [f64; 5] = [0.01, 0.05, 0.1, 0.2, 0.4];

/// Force of a unit block of n cells a side in the middle of one three times as wide, by k δ A.
fn forces<const D: usize>(n: usize, block: impl Fn([f64; D], [f64; D], [usize; D]) -> Mesh<D>) -> [f64; 5] {
    let last = |i: usize| i + 1 == D;
    let (low, high) = ([-1.0; D], std::array::from_fn(|i| if last(i) { 0.0 } else { 2.0 }));
    let lower = block(low, high, std::array::from_fn(|i| if last(i) { n } else { 3 * n }));
    let scene = Scene::of(&[&lower, &block([0.0; D], [1.0; D], [n; D])]);
    let contact = scene.contact(depth(1.0));
    BY_H.map(|by_h| {
        let delta = by_h / n as f64;
        let mut coords = scene.coords.clone();
        scene.nodes_of(1).for_each(|node| coords[node][D - 1] -= delta);
        contact.evaluate(&coords).expect("valid coordinates").bodies[1].force[D - 1] / delta
    })
}

/// The same with the true distance, the lesser of those from the face and from a wall: below the face, the depth of the
/// block sums up to z (1 − z) at the height z above it in 2D, and to (1 − (1 − 2 z)³) / 6 in 3D, that of the lower one to z.
fn true_forces(dimension: usize, n: usize) -> [f64; 5] {
    BY_H.map(|by_h| {
        let z = by_h / n as f64;
        let of_block = if dimension == 2 { z * (1.0 - z) } else { (1.0 - (1.0 - 2.0 * z).powi(3)) / 6.0 };
        0.5 * (of_block / z + 1.0)
    })
}

/// On grids the distance is linear in all pieces but those of tetrahedra.
#[test]
fn grids_have_the_true_distance() {
    for n in [1, 2, 3, 4] {
        let in_plane = [
            forces(n, |low, high, cells| rectangle_tri3(low, high, cells, Diagonals::Same)),
            forces(n, |low, high, cells| rectangle_tri3(low, high, cells, Diagonals::Alternating)),
            forces(n, rectangle_quad4),
        ];
        let expected = true_forces(2, n);
        for found in in_plane {
            (0..5).for_each(|i| assert!((found[i] - expected[i]).abs() < 1e-9, "{n}: {found:?} for {expected:?}"));
        }
        let (found, expected) = (forces(n, cuboid_hex8), true_forces(3, n));
        (0..5).for_each(|i| assert!((found[i] - expected[i]).abs() < 1e-9, "{n}: {found:?} for {expected:?}"));
    }
}

/// Where a ridge of the distance crosses a tetrahedron, the interpolated one is less: by up to 1 % of the force, and in a
/// cube of six tetrahedra by 6 %.
#[test]
fn tetrahedra_come_near() {
    let table = [
        (1, [0.990, 0.951, 0.904, 0.817, 0.652]),
        (2, [0.995, 0.974, 0.949, 0.901, 0.817]),
        (4, [0.997, 0.986, 0.973, 0.948, 0.899]),
        (6, [0.998, 0.991, 0.982, 0.965, 0.931]),
    ];
    for (n, row) in table {
        let (found, all) = (forces(n, cuboid_tet4), true_forces(3, n));
        println!("{n}: {found:.4?} of {all:.4?}");
        for i in 0..5 {
            assert!((found[i] - row[i]).abs() < 1e-3, "{n}: {found:?} for {row:?}");
            assert!(found[i] < all[i] + 1e-9 && found[i] > all[i] - if n == 1 { 0.06 } else { 0.011 });
        }
    }
}

/// Grids whose inner nodes are at random places: their cells keep less to the ridges, and lose more.
#[test]
fn disturbed_tetrahedra_come_near() {
    for n in [2, 4] {
        let inner = |low: [f64; 3], high: [f64; 3]| {
            move |x: &[f64; 3]| (0..3).all(|i| x[i] > low[i] + 1e-9 && x[i] < high[i] - 1e-9)
        };
        let found = forces(n, |low, high, cells| cuboid_tet4(low, high, cells).jittered(0.2, 5, inner(low, high)));
        let all = true_forces(3, n);
        println!("{n}: {found:.4?} of {all:.4?}");
        (0..5).for_each(|i| assert!(found[i] < all[i] + 1e-9 && found[i] > all[i] - 0.08, "{n}: {found:?}, {all:?}"));
    }
}
