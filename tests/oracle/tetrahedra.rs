//! The exact estimator in 3D against closed forms and independent clipping, pair by pair.

use crate::halfspaces::overlap;
use crate::scene::{Scene, distance, exact, norm};
use fmc_shapes::{Mesh, Splitmix, ball_tet4, cone_tet4, cuboid_tet4, icosphere, random_polyhedron, random_rotation};

fn tetrahedron(x: [[f64; 3]; 4]) -> Mesh<3> {
    Mesh { coords: x.to_vec(), conn: vec![0, 1, 2, 3], nodes_per_cell: 4 }
}

/// x, y, z ≥ 0, x + y + z ≤ 1.
fn corner() -> Mesh<3> {
    tetrahedron([[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
}

/// The two meshes turned and moved as one.
fn posed(a: Mesh<3>, b: Mesh<3>, seed: u64, size: f64, place: f64) -> [Mesh<3>; 2] {
    let r = random_rotation(seed);
    [a, b].map(|m| m.rotated_by(r).scaled(size).translated([place, 0.5 * place, -0.3 * place].map(|x| x * size)))
}

#[test]
fn corner_moved_along_its_diagonal() {
    for (seed, s) in [0.01, 0.1, 0.2, 0.3].into_iter().enumerate() {
        for (size, place, tolerance) in [(1.0, 0.0, 1e-12), (1e-6, 0.0, 1e-12), (1e6, 0.0, 1e-12), (1.0, 1e3, 1e-9)] {
            let [a, b] = posed(corner(), corner().translated([s; 3]), seed as u64, size, place);
            let contact = Scene::of(&[&a, &b]).evaluate(exact());
            // x, y, z ≥ s, x + y + z ≤ 1: a corner of legs 1 − 3s.
            let legs = 1.0 - 3.0 * s;
            let volume = legs.powi(3) / 6.0 * size.powi(3);
            assert!((contact.volume - volume).abs() < tolerance * size.powi(3) / 6.0);
            // Moving b by δ along (1,1,1)/√3 makes that 3 δ/√3 shorter: |dV/dδ| = √3/2 legs².
            let force = contact.bodies[1].force.iter().map(|f| f * f).sum::<f64>().sqrt();
            assert!((force - 0.75f64.sqrt() * legs * legs * size * size).abs() < tolerance * size * size);
        }
    }
}

#[test]
fn corner_against_its_mirror_image() {
    // {x, y, z ≥ 0, x + y + z ≤ 1} and {x, y, z ≤ c, x + y + z ≥ 3c − 1}. With F(s) the volume of [0, c]³ where
    // x + y + z ≤ s, that is F(1) − F(3c − 1).
    for (seed, c) in [0.4, 0.5, 0.55, 0.62].into_iter().enumerate() {
        let cube = |s: f64| s.max(0.0).powi(3);
        let f = |s: f64| (cube(s) - 3.0 * cube(s - c) + 3.0 * cube(s - 2.0 * c) - cube(s - 3.0 * c)) / 6.0;
        let mirrored = tetrahedron([[c; 3], [c - 1.0, c, c], [c, c - 1.0, c], [c, c, c - 1.0]]);
        let [a, b] = posed(corner(), mirrored, seed as u64 + 10, 1.0, 0.0);
        let contact = Scene::of(&[&a, &b]).evaluate(exact());
        let volume = f(1.0) - f(3.0 * c - 1.0);
        assert!((contact.volume - volume).abs() < 1e-12 * volume, "{} instead of {volume}", contact.volume);
    }
}

/// Volume and nodal derivatives to 1e-12 of their size.
fn agrees(a: &Mesh<3>, b: &Mesh<3>) {
    let contact = Scene::of(&[a, b]).evaluate(exact());
    let (volume, mut gradient, of_b) = overlap(a, b);
    assert!((contact.volume / volume - 1.0).abs() < 1e-12, "{} instead of {volume}", contact.volume);
    gradient.extend(of_b);
    let forces: Vec<[f64; 3]> = contact.forces.iter().map(|f| f.map(|f| -f)).collect();
    assert!(distance(&forces, &gradient) < 1e-12 * norm(&gradient));
}

#[test]
fn concave_polyhedra_clip_each_other() {
    for seed in 0..6 {
        let mut random = Splitmix::new(seed);
        let mut shift = || random.between(0.2, 0.6);
        let a = random_polyhedron(1, 1.0, 0.4, 1 + seed as usize % 2, seed);
        let b = random_polyhedron(1, 0.9, 0.4, 1, seed + 50).rotated_by(random_rotation(seed));
        agrees(&a, &b.clone().translated([shift(), shift(), shift()]));
        agrees(&a, &b.scaled(0.01).translated([shift(), shift(), 0.0]));
    }
}

#[test]
fn meshes_of_every_shape() {
    let shapes = [
        ball_tet4(1.0, 1, 2),
        cone_tet4(0.8, 1.5, 9, 1),
        cuboid_tet4([-0.7; 3], [0.6, 0.8, 0.9], [2, 3, 2]).jittered(0.3, 5, |_| true),
    ];
    for (k, a) in shapes.iter().enumerate() {
        for (m, b) in shapes.iter().enumerate() {
            agrees(a, &b.clone().rotated_by(random_rotation((3 * k + m) as u64)).translated([0.41, -0.53, 0.32]));
        }
    }
}

/// Its own volume, which the divergence theorem gives from its surface.
#[test]
fn ball_within_a_box_keeps_its_volume() {
    for (level, size, place, tolerance) in
        [(1, 1.0, 0.0, 1e-12), (2, 1e-6, 0.0, 1e-12), (2, 1e6, 0.0, 1e-12), (1, 1.0, 1e3, 1e-9)]
    {
        let [outer, inner] =
            posed(cuboid_tet4([-1.5; 3], [1.2; 3], [3, 2, 4]), ball_tet4(1.0, level, 2), 77, size, place);
        let expected = icosphere(1.0, level).measure() * size.powi(3);
        let contact = Scene::of(&[&outer, &inner]).evaluate(exact());
        assert!((contact.volume / expected - 1.0).abs() < tolerance);
    }
}
