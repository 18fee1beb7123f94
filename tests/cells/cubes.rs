//! One cube, meshed in every way, gives one answer.

use crate::scene::{Scene, consistent_lines, exact, table::exactly};
use crate::{boxes, pair};
use fmc_contact::{ContactForces, EnergyLaw};
use fmc_shapes::{ball_tet4, cuboid_hex8};

fn same_resultants(found: &ContactForces<3>, expected: &ContactForces<3>, within: f64, what: &str) {
    assert!((found.volume / expected.volume - 1.0).abs() < within, "{what}: {}, {}", found.volume, expected.volume);
    for (x, y) in found.bodies.iter().zip(&expected.bodies) {
        let size = x.force.iter().map(|f| f.abs()).sum::<f64>();
        assert!((0..3).all(|i| (x.force[i] - y.force[i]).abs() < within * size), "{what}");
        assert!((0..3).all(|i| (x.moment[i] - y.moment[i]).abs() < 3.0 * within * size), "{what}");
    }
}

/// Volume and lines see the cube and not its cells.
#[test]
fn against_a_ball_and_another_cube() {
    let ball = vec![ball_tet4(0.5, 2, 1).translated([0.9, 0.7, 0.5])];
    let cube =
        vec![cuboid_hex8([0.0; 3], [1.0; 3], [2, 3, 2]).rotated([1.0, 2.0, 0.5], 0.6).translated([0.4, 0.5, 0.3])];
    for options in [exact(), consistent_lines(0.02, 3)] {
        for other in [&ball, &cube] {
            let of = |body: &[_]| pair(body, other).evaluate(options);
            let all = boxes([0.0; 3], [1.0, 0.8, 0.6], [3, 3, 3]);
            let expected = of(&all[0]);
            all[1..].iter().enumerate().for_each(|(k, body)| {
                same_resultants(&of(body), &expected, 1e-12, &format!("mesh {k}, {:?}", options.law));
            });
        }
    }
}

/// Many cells share every edge and face with cells of another type, and none of these is surface: the boundary of the
/// mixed cube has the area of a cube, and its body is one.
#[test]
fn inner_faces_are_no_surface() {
    let mixed = fmc_shapes::cuboid_mixed([0.0; 3], [1.0; 3], [2, 2, 4]);
    let scene = Scene::new().with_mixed(&mixed, 0);
    let blocks: Vec<fmc_contact::CellBlock> =
        scene.blocks.iter().map(|(cell_type, conn)| fmc_contact::CellBlock { cell_type: *cell_type, conn }).collect();
    let surface = fmc_contact::Surface::from_cells(&scene.coords, &blocks, fmc_contact::Bodies::Connected).unwrap();
    assert_eq!(surface.body_count(), 1);
    // Below and on the walls quadrilaterals, on top triangles.
    assert_eq!(surface.facet_count(), 4 * (4 + 4 * 8) + 8);
    let quads = surface.faces().iter().filter(|(_, nodes)| nodes.len() == 4).count();
    assert_eq!((quads, surface.faces().len()), (36, 44));
}

/// With its true depth a block of width 1 with free walls bears k δ (1 − δ + ⅔ δ²) on a larger one, and so it does in hexahedra
/// and in six pyramids a cube, whose centres lie in the middle of it. In tetrahedra and wedges the depth is less near the rim of
/// the contact, where centres are nearer to the walls than to the facets below; by a part of what of a cell is sunk in.
#[test]
fn under_the_law_depth() {
    let lower = cuboid_hex8([-0.5, -0.5, -1.0], [1.5, 1.5, 0.0], [5, 5, 4]);
    for part in [1e-3, 1e-2, 0.1] {
        let delta = part / 4.0;
        let expected = 1.0 - delta + 2.0 / 3.0 * delta * delta;
        let lacking = [1e-11, 0.05 * part, 0.4 * part, 1e-11, 1e-11];
        let bodies = boxes([0.0, 0.0, -delta], [1.0, 1.0, 1.0 - delta], [4, 4, 4]);
        for (k, (body, lacking)) in bodies.iter().zip(lacking).enumerate() {
            let found = pair(std::slice::from_ref(&lower), body).evaluate(exactly(EnergyLaw::depth(1.0)));
            let force = found.bodies[1].force[2] / delta;
            assert!((found.volume / delta - 1.0).abs() < 1e-12);
            assert!(force < expected + 1e-11 && force > expected - lacking, "mesh {k}, {part}: {force} for {expected}");
        }
    }
}
