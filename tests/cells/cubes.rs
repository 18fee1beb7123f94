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

/// The depth is linear between nodes, so meshes differ by how far it is from the distance from the surface, and that within
/// the cells next to the contact: by less than the part of a cell that is sunk in.
#[test]
fn under_the_law_depth() {
    let lower = cuboid_hex8([-0.5, -0.5, -1.0], [1.5, 1.5, 0.0], [5, 5, 4]);
    for part in [1e-3, 1e-2, 0.1] {
        let delta = part / 4.0;
        for (k, body) in boxes([0.0, 0.0, -delta], [1.0, 1.0, 1.0 - delta], [4, 4, 4]).iter().enumerate() {
            let found = pair(&[lower.clone()], body).evaluate(exactly(EnergyLaw::depth(1.0)));
            let force = found.bodies[1].force[2] / delta;
            println!("mesh {k}, {part}: {force}");
            assert!((found.volume / delta - 1.0).abs() < 1e-12);
            assert!((force - 1.0).abs() < part, "mesh {k}, {part}: {force}");
        }
    }
}
