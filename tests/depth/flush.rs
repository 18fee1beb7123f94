//! Fields at nodes and contact points where walls of two bodies lie in one plane, and sums over them are rounding.

use crate::depth;
use crate::scene::{Scene, norm, size_sum};
use fmc_contact::overlap::Partner;
use fmc_shapes::{Mesh, Splitmix, cuboid_hex8, cuboid_tet4, random_rotation, rectangle_quad4};

/// Areas, weights, places and Σ p A n of two blocks.
fn check<const D: usize>(scene: &Scene<D>, label: &str) {
    let contact = scene.contact(depth(1.0));
    let found = contact.evaluate(&scene.coords).expect("valid coordinates");
    let field = contact.nodal_contact(&scene.coords).expect("fields");
    // The area of each body's surface: 2 D faces of 1.
    let areas: Vec<f64> = (0..2).map(|body| scene.nodes_of(body).map(|node| field.area[node]).sum()).collect();
    assert!(areas.iter().all(|area| *area <= 2.0 * D as f64 * (1.0 + 1e-9)), "{label}: {areas:?}");
    // Walls that touch press by their area, 1, times the rounding of a depth.
    let size = size_sum(&found.forces).max(1e-3);
    for body in 0..2 {
        let mut sum = [0.0; D];
        for node in scene.nodes_of(body) {
            let part = field.pressure[node] * field.area[node];
            (0..D).for_each(|i| sum[i] -= part * field.normal[node][i]);
            let largest = found.pairs.first().map_or(0.0, |pair| pair.penetration);
            assert!(field.local_pressure[node] <= largest * (1.0 + 1e-9), "{label}: {}", field.local_pressure[node]);
        }
        let off = (0..D).map(|i| (sum[i] - found.bodies[body].force[i]).abs()).fold(0.0, f64::max);
        assert!(off <= 1e-12 * size, "{label}: {off:.1e} of {size:.1e}");
    }
    let mut force = [0.0; D];
    for point in contact.contact_points(&scene.coords).expect("points") {
        (0..D).for_each(|i| force[i] -= point.pressure * point.area * point.normal[i]);
        for (side, partner) in point.sides.iter().zip(point.partners) {
            let Partner::Body(body) = partner else { panic!("{label}: a body") };
            let weights = &side.weights[..side.node_count];
            assert!(weights.iter().all(|w| (0.0..=1.0).contains(w)), "{label}: {weights:?}");
            assert!((weights.iter().sum::<f64>() - 1.0).abs() < 1e-12, "{label}: {weights:?}");
            let is_in_box = (0..D).all(|i| {
                let along = || scene.nodes_of(body).map(|node| scene.coords[node][i]);
                let (low, high) = (along().fold(f64::INFINITY, f64::min), along().fold(f64::NEG_INFINITY, f64::max));
                (low - 1e-9..=high + 1e-9).contains(&side.position[i])
            });
            assert!(is_in_box, "{label}: {:?}", side.position);
        }
        let apart =
            norm(&[std::array::from_fn::<f64, D, _>(|i| point.sides[0].position[i] - point.sides[1].position[i])]);
        assert!(apart < 1e-6, "{label}: the sides are {apart:.1e} apart");
    }
    let off = (0..D).map(|i| (force[i] - found.bodies[0].force[i]).abs()).fold(0.0, f64::max);
    assert!(off <= 1e-12 * size, "{label}: {off:.1e} of {size:.1e}");
}

/// Blocks of one to three cells in many positions, walls flush or all but, on grids that are straight or turned, 0 to 1000 roundings from
/// where they should be.
fn in_many_positions<const D: usize>(
    blocks: &[&dyn Fn(usize) -> Mesh<D>],
    turn: impl Fn(&mut [f64; D], u64),
    count: u64,
) {
    let shifts = [0.0, 0.25, 1.0 / 3.0, 0.5, 0.9, 0.99, 1.0 - 1e-9, 1.0];
    for seed in 0..count {
        let mut random = Splitmix::new(seed);
        let mut below = |count: usize| (random.between(0.0, count as f64) as usize).min(count - 1);
        let (kinds, cells) = ([below(blocks.len()), below(blocks.len())], [1 + below(3), 1 + below(3)]);
        let shift = std::array::from_fn(|_| shifts[below(shifts.len())]);
        let (roundings, is_turned) = ([0.0, 1.0, 10.0, 1e3][below(4)], below(2) == 1);
        let upper = blocks[kinds[1]](cells[1]).translated(shift);
        let mut scene = Scene::of(&[&blocks[kinds[0]](cells[0]), &upper]);
        for x in &mut scene.coords {
            x.iter_mut().for_each(|x| *x += roundings * f64::EPSILON * random.between(-1.0, 1.0));
            if is_turned {
                turn(x, seed);
            }
        }
        check(&scene, &format!("{D}D, seed {seed}: {cells:?} cells, shifted by {shift:?}"));
    }
}

#[test]
fn squares() {
    let turn = |x: &mut [f64; 2], seed: u64| {
        let (sin, cos) = (seed as f64).sin_cos();
        *x = [cos * x[0] - sin * x[1], sin * x[0] + cos * x[1]];
    };
    in_many_positions(&[&|n| rectangle_quad4([0.0; 2], [1.0; 2], [n, n])], turn, 300);
}

#[test]
fn cubes() {
    let turn = |x: &mut [f64; 3], seed: u64| {
        let rows = random_rotation(seed);
        *x = rows.map(|row| row.iter().zip(&*x).map(|(r, x)| r * x).sum());
    };
    let blocks: [&dyn Fn(usize) -> Mesh<3>; 2] =
        [&|n| cuboid_hex8([0.0; 3], [1.0; 3], [n; 3]), &|n| cuboid_tet4([0.0; 3], [1.0; 3], [n; 3])];
    in_many_positions(&blocks, turn, 60);
}
