//! Planes of symmetry in meshes whose contact faces have corners between them, and in slices of one cell.

use crate::depth;
use crate::scene::Scene;
use fmc_contact::{Contact, Error, Options, Warning};
use fmc_shapes::{Mesh, cuboid_hex8, cuboid_tet4, cuboid_wedge6, rectangle_quad4};

const DELTA: f64 = 1e-3;

type Block = fn([f64; 3], [f64; 3], [usize; 3]) -> Mesh<3>;

/// A mesh with its mirror images at x = 0, and y = 0, the nodes in these planes shared.
fn with_images(mesh: &Mesh<3>, axes: &[usize]) -> Mesh<3> {
    axes.iter().fold(mesh.clone(), |mut mesh, &axis| {
        let (count, own) = (mesh.coords.len() as u32, mesh.clone());
        let mut image: Vec<u32> = Vec::new();
        for (node, x) in (0..count).zip(&own.coords) {
            if x[axis] == 0.0 {
                image.push(node);
            } else {
                image.push(mesh.coords.len() as u32);
                mesh.coords.push(std::array::from_fn(|i| if i == axis { -x[i] } else { x[i] }));
            }
        }
        // The other orientation: lower and upper faces change places, or two corners.
        for cell in own.cells() {
            let order: &[usize] = match (cell.len(), axis) {
                (4, _) => &[1, 0, 2, 3],
                (6, _) => &[3, 4, 5, 0, 1, 2],
                (_, 0) => &[1, 0, 3, 2, 5, 4, 7, 6],
                _ => &[3, 2, 1, 0, 7, 6, 5, 4],
            };
            mesh.conn.extend(order.iter().map(|&k| image[cell[k] as usize]));
        }
        mesh
    })
}

fn force(contact: &Contact<3>, scene: &Scene<3>) -> f64 {
    contact.evaluate(&scene.coords).expect("valid coordinates").bodies[1].force[2]
}

/// Blocks on blocks: a quarter, or half, bears its part of what the full model bears, with planes named by themselves or by their nodes;
/// with either diagonal in the corner.
#[test]
fn parts_bear_as_the_full_model_does() {
    for block in [cuboid_hex8 as Block, cuboid_tet4, cuboid_wedge6] {
        for axes in [&[0][..], &[0, 1]] {
            for is_turned in [false, true] {
                let at = |x: [f64; 3], w: f64| if is_turned { [w - x[0], w - x[1], x[2]] } else { x };
                let lower = block([0.0, 0.0, -1.0], [1.0, 1.0, 0.0], [3, 3, 2]).mapped(|x| at(x, 1.0));
                // No walls in one plane, but for planes of symmetry.
                let aside = if axes.len() == 1 { 0.1 } else { 0.0 };
                let upper =
                    block([0.0; 3], [0.8; 3], [4, 4, 2]).mapped(|x| at(x, 0.8)).translated([0.0, aside, -DELTA]);
                let part = Scene::of(&[&lower, &upper]);
                let full = Scene::of(&[&with_images(&lower, axes), &with_images(&upper, axes)]);
                let expected = force(&full.contact(depth(1.0)), &full) / f64::from(1 << axes.len());
                let mut by_planes = part.contact(depth(1.0));
                let planes: Vec<[[f64; 3]; 2]> = axes.iter().map(|&axis| [[0.0; 3], unit(axis)]).collect();
                by_planes.set_symmetry_planes(&planes).expect("planes");
                let mut by_nodes = part.contact(depth(1.0));
                let is_named = |x: &[f64; 3]| axes.iter().any(|&axis| x[axis] == 0.0);
                let nodes: Vec<u32> = (0..).zip(&part.coords).filter(|(_, x)| is_named(x)).map(|(n, _)| n).collect();
                by_nodes.set_symmetry_nodes(&nodes).expect("nodes");
                // Tetrahedra in edges are divided in the order of their nodes, which images have otherwise.
                let tolerance = if lower.nodes_per_cell == 4 { 1e-4 } else { 1e-9 };
                for contact in [by_planes, by_nodes] {
                    let found = force(&contact, &part);
                    assert!(
                        (found / expected - 1.0).abs() < tolerance,
                        "{axes:?}, turned {is_turned}: {found} of {expected}"
                    );
                }
            }
        }
    }
}

fn unit(axis: usize) -> [f64; 3] {
    std::array::from_fn(|i| f64::from(u8::from(i == axis)))
}

/// Plane strain as a slice of one cell or two: the force by the thickness is that of the plane.
#[test]
fn slices_are_planes() {
    let plane = {
        let lower = rectangle_quad4([0.0, -1.0], [2.0, 0.0], [8, 4]);
        let upper = rectangle_quad4([0.5, -DELTA], [1.5, 1.0 - DELTA], [5, 5]);
        Scene::of(&[&lower, &upper]).evaluate(depth(1.0)).bodies[1].force[1]
    };
    let thickness = 0.25;
    for layers in [1, 2] {
        let lower = cuboid_hex8([0.0, 0.0, -1.0], [2.0, thickness, 0.0], [8, layers, 4]);
        let upper = cuboid_hex8([0.5, 0.0, -DELTA], [1.5, thickness, 1.0 - DELTA], [5, layers, 5]);
        let scene = Scene::of(&[&lower, &upper]);
        let mut contact = scene.contact(depth(1.0));
        contact.set_symmetry_planes(&[[[0.0; 3], unit(1)], [[0.0, thickness, 0.0], unit(1)]]).expect("planes");
        let found = force(&contact, &scene) / thickness;
        assert!((found / plane - 1.0).abs() < 1e-9, "{layers}: {found} of {plane}");
        let is_named = |x: &[f64; 3]| x[1] == 0.0 || x[1] == thickness;
        let nodes: Vec<u32> = (0..).zip(&scene.coords).filter(|(_, x)| is_named(x)).map(|(n, _)| n).collect();
        contact.set_symmetry_nodes(&nodes).expect("nodes");
        assert_eq!(force(&contact, &scene) / thickness, found);
    }
}

/// A face in contact that is named by mistake leaves its force, which is told; planes where they are leave no more than is so.
#[test]
fn what_is_named_by_mistake_is_told() {
    let lower = rectangle_quad4([0.0, -1.0], [1.0, 0.0], [4, 4]);
    let upper = rectangle_quad4([0.0, -0.02], [0.6, 1.0], [3, 5]);
    let scene = Scene::of(&[&lower, &upper]);
    let mut contact = scene.contact(depth(1.0));
    let mut is_told = |plane: [[f64; 2]; 2]| {
        contact.set_symmetry_planes(&[plane]).expect("a plane");
        let found = contact.evaluate(&scene.coords).expect("valid coordinates");
        found.warnings.iter().any(|warning| matches!(warning, Warning::Unbalanced { .. }))
    };
    assert!(!is_told([[0.0; 2], [-3.0, 0.0]]));
    assert!(is_told([[0.5, 0.0], [0.0, 1.0]]));
}

/// The halves of a body that overlap beside a plane of symmetry are one body or two: what it presses on itself is in balance.
#[test]
fn a_body_that_presses_on_itself_beside_a_plane_is_in_balance() {
    let lower = rectangle_quad4([0.0, -1.0], [1.0, -DELTA], [4, 4]);
    let upper = rectangle_quad4([0.0, 0.0], [0.6, 1.0], [3, 5]);
    let scene = Scene::new().with(&lower, 0).with(&upper, 0);
    let mut contact = scene.contact(Options { self_contact: true, ..depth(1.0) });
    contact.set_symmetry_planes(&[[[0.0; 2], [1.0, 0.0]]]).expect("a plane");
    let mut coords = scene.coords.clone();
    let first = lower.coords.len();
    coords[first..].iter_mut().for_each(|x| x[1] -= 2.0 * DELTA);
    let found = contact.evaluate(&coords).expect("valid coordinates");
    assert!(found.energy > 0.0);
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
}

/// Without deformation a body shrinks into planes that bound it: nothing would be left of its surface.
#[test]
fn coordinates_that_leave_no_surface_are_refused_and_change_nothing() {
    let lower = rectangle_quad4([0.0, -1.0], [2.0, 0.0], [4, 2]);
    let upper = rectangle_quad4([0.0, -DELTA], [2.0, 2.0], [3, 3]);
    let scene = Scene::of(&[&lower, &upper]);
    let bounds = [[[0.0; 2], [1.0, 0.0]], [[1.0; 2], [1.0, 0.0]], [[0.0; 2], [0.0, 1.0]], [[1.0; 2], [0.0, 1.0]]];
    let mut contact = scene.contact(depth(1.0));
    contact.set_symmetry_planes(&bounds).expect("bodies with a surface");
    let before = contact.evaluate(&scene.coords).expect("valid coordinates");
    let of_upper = scene.nodes_of(1);
    let mut shrunk = scene.coords.clone();
    of_upper.for_each(|node| shrunk[node] = [0.5 * shrunk[node][0], (shrunk[node][1] + DELTA) / (2.0 + DELTA)]);
    assert!(matches!(contact.set_reference(&shrunk), Err(Error::Unsupported { .. })));
    assert_eq!(contact.evaluate(&scene.coords).expect("valid coordinates"), before);
    contact.set_reference(&scene.coords).expect("the coordinates before");
    assert_eq!(contact.evaluate(&scene.coords).expect("valid coordinates"), before);
}
