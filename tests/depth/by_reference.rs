//! Derivatives by the coordinates without deformation, against differences of a contact that is told others.

use crate::depth;
use crate::scene::{Scene, distance, size_sum};
use fmc_contact::Contact;
use fmc_contact::contact::GradientRequest;
use fmc_shapes::{Diagonals, Mesh, Splitmix, cuboid_hex8, cuboid_pyramid5, cuboid_tet4, cuboid_wedge6};
use fmc_shapes::{rectangle_quad4, rectangle_tri3};

const REFERENCE: GradientRequest = GradientRequest {
    coords: false,
    reference: true,
    stiffness: false,
    gap_offsets: false,
    friction: false,
    slip: false,
    positions: false,
    rotations: false,
};

fn moved<const D: usize>(x: &[[f64; D]], by: f64, along: &[[f64; D]]) -> Vec<[f64; D]> {
    x.iter().zip(along).map(|(x, v)| std::array::from_fn(|i| x[i] + by * v[i])).collect()
}

fn random_rows<const D: usize>(count: usize, random: &mut Splitmix) -> Vec<[f64; D]> {
    (0..count).map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect()
}

fn dot<const D: usize>(a: &[[f64; D]], b: &[[f64; D]]) -> f64 {
    a.iter().flatten().zip(b.iter().flatten()).map(|(a, b)| a * b).sum()
}

/// The largest difference of derivatives along random directions, of energy and of forces, by their sizes.
///
/// Central differences with a step of 1e-6: rounding is 1e-10 of the energy by it; a depth that passes a kink within the step is off by more,
/// which half of the directions would then show.
fn differences<const D: usize>(contact: &mut Contact<D>, reference: &[[f64; D]], coords: &[[f64; D]]) -> [f64; 2] {
    let mut random = Splitmix::new(5);
    let mut worst = [0.0f64; 2];
    for _ in 0..3 {
        let adjoint = random_rows::<D>(coords.len(), &mut random);
        let direction = random_rows::<D>(coords.len(), &mut random);
        contact.set_reference(reference).expect("a valid mesh");
        let of_energy = contact.vjp(coords, 1.0, None, &REFERENCE).expect("derivatives").reference;
        let of_forces = contact.vjp(coords, 0.0, Some(&adjoint), &REFERENCE).expect("derivatives").reference;
        let mut at = |by: f64| {
            contact.set_reference(&moved(reference, by, &direction)).expect("a valid mesh");
            let found = contact.evaluate(coords).expect("forces");
            [found.energy, dot(&found.forces, &adjoint)]
        };
        let h = 1e-6;
        let (up, down) = (at(h), at(-h));
        for (k, gradient) in [of_energy, of_forces].iter().enumerate() {
            let expected = (up[k] - down[k]) / (2.0 * h);
            let size = gradient.iter().flatten().map(|x| x * x).sum::<f64>().sqrt();
            assert!(size > 0.0);
            worst[k] = worst[k].max((dot(gradient, &direction) - expected).abs() / size);
        }
    }
    worst
}

/// Two blocks, whose reference is disturbed by `noise` and which then were moved into each other and disturbed.
fn compared<const D: usize>(meshes: [Mesh<D>; 2], noise: f64, seed: u64) -> [f64; 2] {
    let scene = Scene::of(&[&meshes[0], &meshes[1]]);
    let mut random = Splitmix::new(seed);
    let reference = moved(&scene.coords, noise, &random_rows::<D>(scene.coords.len(), &mut random));
    let mut coords = moved(&reference, 0.02, &random_rows::<D>(reference.len(), &mut random));
    let turn = random.between(-0.3, 0.3);
    for node in scene.nodes_of(1) {
        let x = &mut coords[node];
        (x[0], x[D - 1]) = (x[0] * turn.cos() - x[D - 1] * turn.sin(), x[0] * turn.sin() + x[D - 1] * turn.cos());
        x[D - 1] -= 0.25;
    }
    let mut contact = scene.contact(depth(30.0));
    differences(&mut contact, &reference, &coords)
}

fn of_plane() -> Vec<[Mesh<2>; 2]> {
    let (below, above) = (([0.0, -1.0], [1.5, 0.0]), ([0.3, 0.0], [1.3, 0.8]));
    let upper = rectangle_tri3(above.0, above.1, [3, 3], Diagonals::Same);
    vec![
        [rectangle_tri3(below.0, below.1, [5, 3], Diagonals::Alternating), upper.clone()],
        [rectangle_quad4(below.0, below.1, [4, 3]), rectangle_quad4(above.0, above.1, [2, 1])],
        [rectangle_quad4(below.0, below.1, [5, 2]), upper],
    ]
}

fn of_space() -> Vec<[Mesh<3>; 2]> {
    let (below, above) = (([0.0, 0.0, -1.0], [1.5, 1.2, 0.0]), ([0.3, 0.1, 0.0], [1.3, 1.0, 0.8]));
    vec![
        [cuboid_tet4(below.0, below.1, [3, 2, 2]), cuboid_tet4(above.0, above.1, [2, 2, 2])],
        [cuboid_hex8(below.0, below.1, [3, 2, 2]), cuboid_tet4(above.0, above.1, [1, 2, 1])],
        [cuboid_wedge6(below.0, below.1, [2, 2, 3]), cuboid_hex8(above.0, above.1, [2, 2, 1])],
        [cuboid_pyramid5(below.0, below.1, [2, 2, 2]), cuboid_hex8(above.0, above.1, [2, 2, 2])],
    ]
}

/// Where no two faces are equally near.
#[test]
fn they_are_those_of_differences() {
    for (seed, meshes) in of_plane().into_iter().enumerate() {
        let found = compared(meshes, 0.02, seed as u64);
        assert!(found.iter().all(|difference| *difference < 1e-8), "{seed}: {found:?}");
    }
    for (seed, meshes) in of_space().into_iter().enumerate() {
        let found = compared(meshes, 0.02, seed as u64);
        assert!(found.iter().all(|difference| *difference < 1e-8), "{seed}: {found:?}");
    }
}

/// Lattices of an odd number of cells, in which no node that matters is as near to two opposite faces; their division changes as soon as
/// the reference moves. Where it does, slopes change by the step of the differences.
#[test]
fn they_are_those_of_lattices() {
    let (below, above) = (([0.0, -1.0], [1.5, 0.0]), ([0.3, 0.0], [1.3, 0.8]));
    let flat = [rectangle_quad4(below.0, below.1, [5, 3]), rectangle_quad4(above.0, above.1, [3, 3])];
    let found = compared(flat, 0.0, 1);
    assert!(found.iter().all(|difference| *difference < 1e-5), "{found:?}");
    let (below, above) = (([0.0, 0.0, -1.0], [1.5, 1.2, 0.0]), ([0.3, 0.1, 0.0], [1.3, 1.0, 0.8]));
    let bricks = [cuboid_hex8(below.0, below.1, [4, 3, 3]), cuboid_hex8(above.0, above.1, [3, 3, 3])];
    let found = compared(bricks, 0.0, 1);
    assert!(found.iter().all(|difference| *difference < 1e-5), "{found:?}");
}

/// Lattices of triangles and tetrahedra, also one cell thick, whose depths must not hang on faces that are equally near but for rounding: the
/// reference moves by 1e-9, and forces by no more than a force changes over so little.
fn no_jump<const D: usize>(lower: &Mesh<D>, upper: &Mesh<D>) {
    let scene = Scene::of(&[lower, upper]);
    let mut coords = scene.coords.clone();
    scene.nodes_of(1).for_each(|node| coords[node][D - 1] -= 0.25);
    let mut contact = scene.contact(depth(30.0));
    let on_the_lattice = contact.evaluate(&coords).expect("forces");
    let mut random = Splitmix::new(3);
    for _ in 0..4 {
        let near = moved(&scene.coords, 1e-9, &random_rows::<D>(scene.coords.len(), &mut random));
        contact.set_reference(&near).expect("a valid mesh");
        let found = contact.evaluate(&coords).expect("forces");
        let off = distance(&found.forces, &on_the_lattice.forces) / size_sum(&on_the_lattice.forces);
        assert!(off < 1e-7, "{off:e}");
    }
}

#[test]
fn depths_do_not_jump_where_faces_are_equally_near() {
    for cells in [[1, 1], [1, 2], [2, 1], [2, 2], [4, 2], [3, 3]] {
        for diagonals in [Diagonals::Same, Diagonals::Alternating] {
            let lower = rectangle_tri3([0.0, -1.0], [1.5, 0.0], cells, diagonals);
            no_jump(&lower, &rectangle_tri3([0.3, 0.0], [1.3, 0.8], [cells[1], cells[0]], diagonals));
            no_jump(&lower, &rectangle_quad4([0.3, 0.0], [1.3, 0.8], cells));
        }
    }
    for cells in [[1, 1, 1], [2, 2, 2], [3, 2, 2], [2, 3, 1]] {
        let lower = cuboid_tet4([0.0, 0.0, -1.0], [1.5, 1.2, 0.0], cells);
        no_jump(&lower, &cuboid_tet4([0.3, 0.1, 0.0], [1.3, 1.0, 0.8], [cells[2], cells[0], cells[1]]));
        no_jump(&lower, &cuboid_wedge6([0.3, 0.1, 0.0], [1.3, 1.0, 0.8], cells));
        no_jump(&lower, &cuboid_pyramid5([0.3, 0.1, 0.0], [1.3, 1.0, 0.8], cells));
    }
}
