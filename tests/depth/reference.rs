//! What the depth is measured from: coordinates without deformation, and faces that are no surface.

use crate::depth;
use crate::scene::Scene;
use fmc_contact::{Contact, Error, Warning};
use fmc_shapes::{Diagonals, cuboid_tet4, rectangle_quad4, rectangle_tri3};

/// A block that was made half as high as it is without deformation, pressed into a rigid-like large one. The upper block's
/// own depth is the reference's, twice as much: k pen (1 + 1/λ) / 2 with λ = 1/2.
#[test]
fn depth_is_that_of_the_reference() {
    let lower = rectangle_tri3([-0.5, -1.0], [1.5, 0.0], [10, 5], Diagonals::Same);
    let upper = rectangle_tri3([0.0, 0.0], [1.0, 0.5], [40, 20], Diagonals::Same);
    let scene = Scene::of(&[&lower, &upper]);
    let mut reference = scene.coords.clone();
    scene.nodes_of(1).for_each(|n| reference[n][1] *= 2.0);
    let mut pressed = scene.coords.clone();
    let delta = 1e-3;
    scene.nodes_of(1).for_each(|n| pressed[n][1] -= delta);
    let mut contact = scene.contact(depth(1.0));
    let as_made = contact.evaluate(&pressed).expect("valid coordinates").bodies[1].force[1] / delta;
    contact.set_reference(&reference).expect("valid coordinates");
    let found = contact.evaluate(&pressed).expect("valid coordinates").bodies[1].force[1] / delta;
    // At the two corners less is borne, in the width of a cell's inscribed ball: 0.25 % of the width each.
    assert!((as_made - 1.0).abs() < 0.02, "{as_made}");
    assert!((found - 1.5).abs() < 0.03, "{found}");
    let made_there = Scene { coords: reference, ..scene }.contact(depth(1.0));
    assert_eq!(made_there.evaluate(&pressed), contact.evaluate(&pressed));
}

/// Half a block with its plane of symmetry bears half the force, as deep as it may be, with the same pressure along the
/// plane as in the middle of the whole.
#[test]
fn faces_in_a_plane_of_symmetry_are_no_surface() {
    let delta = 0.05;
    let whole = {
        let lower = rectangle_quad4([-1.0, -1.0], [1.0, 0.0], [8, 4]);
        let upper = rectangle_quad4([-0.6, 0.0], [0.6, 1.0], [6, 5]).translated([0.0, -delta]);
        Scene::of(&[&lower, &upper]).evaluate(depth(1.0)).bodies[1].force[1]
    };
    let lower = rectangle_quad4([0.0, -1.0], [1.0, 0.0], [4, 4]);
    let upper = rectangle_quad4([0.0, 0.0], [0.6, 1.0], [3, 5]).translated([0.0, -delta]);
    let scene = Scene::of(&[&lower, &upper]);
    let mut contact = scene.contact(depth(1.0));
    let force = |contact: &Contact<2>| contact.evaluate(&scene.coords).expect("valid coordinates").bodies[1].force[1];
    let with_walls = force(&contact);
    let on_plane = |x: &[f64; 2]| x[0] == 0.0;
    let nodes: Vec<u32> = (0..).zip(&scene.coords).filter(|(_, x)| on_plane(x)).map(|(n, _)| n).collect();
    contact.set_symmetry_nodes(&nodes).expect("nodes of the mesh");
    let found = force(&contact);
    assert!((found / (0.5 * whole) - 1.0).abs() < 1e-12, "{found} of {whole}");
    assert!((with_walls / (0.5 * whole) - 1.0).abs() > 3e-3, "{with_walls}: the test would not see the plane");
    contact.set_symmetry_nodes(&[]).expect("no nodes");
    assert_eq!(force(&contact), with_walls);
}

#[test]
fn what_cannot_be_is_refused_and_changes_nothing() {
    let scene = Scene::of(&[&cuboid_tet4([0.0; 3], [1.0; 3], [2, 2, 2])]);
    let mut contact = scene.contact(depth(1.0));
    let count = scene.coords.len();
    let bad = contact.set_symmetry_nodes(&[0, 1, count as u32]);
    assert_eq!(bad, Err(Error::NodeOutOfRange { cell: 2, node: count as i64, node_count: count }));
    let all: Vec<u32> = (0..count as u32).collect();
    assert!(matches!(contact.set_symmetry_nodes(&all), Err(Error::Unsupported { .. })));
    assert!(matches!(contact.set_reference(&scene.coords[1..]), Err(Error::Length { .. })));
    let mut turned = scene.coords.clone();
    turned.iter_mut().for_each(|x| x[0] = -x[0]);
    assert!(matches!(contact.set_reference(&turned), Err(Error::InvertedCell { .. })));
    turned[3][1] = f64::NAN;
    assert!(matches!(contact.set_reference(&turned), Err(Error::NonFiniteCoordinate { node: 3, axis: 1 })));
    assert_eq!(contact.set_reference(&scene.coords), Ok(()));
}

/// Walls of two bodies in one plane are warned of with their area, until the host says what they are.
#[test]
fn flush_faces_are_warned_of() {
    fn flush<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) -> Vec<f64> {
        let found = contact.evaluate(coords).expect("valid coordinates");
        let area = |warning: &Warning| match warning {
            Warning::FlushFaces { area, .. } => Some(*area),
            _ => None,
        };
        found.warnings.iter().filter_map(area).collect()
    }
    let delta = 0.05;
    let lower = rectangle_quad4([0.0, -1.0], [1.0, 0.0], [4, 4]);
    let upper = rectangle_tri3([0.0, 0.0], [0.6, 1.0], [3, 5], Diagonals::Same).translated([0.0, -delta]);
    let mut scene = Scene::of(&[&lower, &upper]);
    for noise in [0.0, 1e-14] {
        let mut random = fmc_shapes::Splitmix::new(1);
        scene.coords.iter_mut().flatten().for_each(|x| *x += noise * random.between(-1.0, 1.0));
        let found = flush(&scene.contact(depth(1.0)), &scene.coords);
        assert!(found.len() == 1 && (found[0] / delta - 1.0).abs() < 1e-6, "{found:?}");
    }
    let mut contact = scene.contact(depth(1.0));
    contact.set_symmetry_nodes(&[]).expect("no nodes");
    assert!(flush(&contact, &scene.coords).is_empty());
    let apart = Scene::of(&[&lower, &upper.translated([1e-3, 0.0])]);
    assert!(flush(&apart.contact(depth(1.0)), &apart.coords).is_empty());
    let lower = cuboid_tet4([0.0, 0.0, -1.0], [1.0, 1.0, 0.0], [2, 2, 2]);
    let upper = cuboid_tet4([0.0, 0.0, -delta], [1.0, 0.5, 1.0], [3, 2, 2]);
    let scene = Scene::of(&[&lower, &upper]);
    let found = flush(&scene.contact(depth(1.0)), &scene.coords);
    // Two walls of 1/2 and one of 1.
    assert!(found.len() == 1 && (found[0] / (2.0 * delta) - 1.0).abs() < 1e-6, "{found:?}");
}
