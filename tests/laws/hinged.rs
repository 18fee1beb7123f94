//! Bodies that hang together at nodes and overlap beside them: each body feels its own facets, the node both.

use crate::balance::balanced;
use crate::scene::{Scene, distance, exact, lines, norm};
use fmc_shapes::{Mesh, cuboid_tet4, random_rotation, rectangle_tri3};

/// The second mesh with its node `of_b` replaced by node `of_a` of the first, at the same place.
fn hinged<const D: usize>(a: &Mesh<D>, b: &Mesh<D>, hinge: &[(usize, usize)]) -> Scene<D> {
    let mut scene = Scene::of(&[a, b]);
    for &(of_a, of_b) in hinge {
        assert_eq!(a.coords[of_a], b.coords[of_b]);
        let (from, to) = ((a.coords.len() + of_b) as u32, of_a as u32);
        scene.blocks[1].1.iter_mut().filter(|n| **n == from).for_each(|n| *n = to);
    }
    scene
}

/// Nodes of both meshes at the same place.
fn common_nodes<const D: usize>(a: &Mesh<D>, b: &Mesh<D>) -> Vec<(usize, usize)> {
    let place = |x: &[f64; D]| a.coords.iter().position(|y| y == x);
    b.coords.iter().enumerate().filter_map(|(of_b, x)| place(x).map(|of_a| (of_a, of_b))).collect()
}

fn hinge_feels_both<const D: usize>(a: &Mesh<D>, b: &Mesh<D>, spacing: f64) {
    let hinge = common_nodes(a, b);
    assert!(!hinge.is_empty() && hinge.len() < 5);
    for options in [exact(), lines(spacing, 1)] {
        // Two bodies that only stand so, on nodes of their own.
        let apart = Scene::of(&[a, b]).evaluate(options);
        let scene = hinged(a, b, &hinge);
        let together = scene.evaluate(options);
        balanced(&together, &scene.coords);
        let ratio = together.volume / apart.volume - 1.0;
        assert!(apart.volume > 1e-3 && ratio.abs() < 1e-13, "{ratio:e} {options:?}");
        // The correction of sampled forces sees one node for two.
        let tolerance = if options == exact() { 1e-12 } else { 1e-3 };
        let size = norm(&apart.forces);
        for (x, y) in together.bodies.iter().zip(&apart.bodies) {
            assert!(distance(&[x.force], &[y.force]) < tolerance * size, "{:?} instead of {:?}", x.force, y.force);
            assert!(distance(&[x.moment], &[y.moment]) < tolerance * size);
        }
        let mut expected = apart.forces.clone();
        for &(of_a, of_b) in &hinge {
            let from = std::mem::replace(&mut expected[a.coords.len() + of_b], [0.0; D]);
            (0..D).for_each(|i| expected[of_a][i] += from[i]);
        }
        assert!(distance(&together.forces, &expected) < tolerance * size);
    }
}

#[test]
fn squares_hinged_at_a_corner() {
    let square = rectangle_tri3([0.0; 2], [1.0; 2], [3, 3], fmc_shapes::Diagonals::Alternating);
    for angle in [0.3, 0.8, 1.4] {
        hinge_feels_both(&square, &square.clone().rotated(angle), 0.005);
        hinge_feels_both(&square.clone().rotated(angle), &square, 0.005);
    }
}

#[test]
fn cubes_hinged_at_a_corner_and_at_an_edge() {
    let cube = cuboid_tet4([0.0; 3], [1.0; 3], [2; 3]);
    hinge_feels_both(&cube, &cube.clone().rotated([0.0, 0.0, 1.0], 0.7), 0.03);
    hinge_feels_both(&cube, &cube.clone().rotated_by(random_rotation(5)), 0.03);
}
