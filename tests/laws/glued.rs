//! Bodies that share their nodes at a seam, like two materials of one mesh, do not push each other.

use crate::scene::table::{by_laws, laws, none_at_a_seam};
use crate::scene::{Scene, exact, fibers, isotropic, lines};
use fmc_contact::{ContactForces, FiberOptions, Options};
use fmc_shapes::{Diagonals, Mesh, cuboid_hex8, cuboid_tet4, random_rotation, rectangle_quad4, rectangle_tri3};

/// Coincident facets carry nothing at all: not a force that cancels, and not a rounding error but where the law makes one.
fn no_force<const D: usize>(contact: &ContactForces<D>, options: Options) {
    let none = none_at_a_seam(&options.law);
    assert!(
        contact.volume <= none && contact.energy <= none * none,
        "{options:?}: {:e} {:e}",
        contact.volume,
        contact.energy
    );
    let largest = contact.forces.iter().flatten().fold(0.0, |largest: f64, f| largest.max(f.abs()));
    assert!(largest <= none, "{options:?}: {largest:e}");
}

fn estimators() -> Vec<Options> {
    vec![exact(), fibers(FiberOptions::default()), lines(0.013, 1), isotropic(0.3, 3_000, 1)]
}

/// One mesh in two bodies, divided by where the first node of each cell lies.
fn divided<const D: usize>(mesh: &Mesh<D>, second: impl Fn(&[f64; D]) -> bool) -> Scene<D> {
    let mut scene = Scene::of(&[mesh]);
    let body = |cell: &[u32]| {
        let middle =
            std::array::from_fn(|i| cell.iter().map(|&n| mesh.coords[n as usize][i]).sum::<f64>() / cell.len() as f64);
        i64::from(second(&middle))
    };
    scene.ids = mesh.cells().map(body).collect();
    assert_eq!(scene.surface().body_count(), 2);
    scene
}

#[test]
fn plane_materials_do_not_push_each_other() {
    let (min, max, cells) = ([0.0; 2], [1.0, 0.8], [6, 5]);
    for seed in 0..10 {
        let meshes = [rectangle_tri3(min, max, cells, Diagonals::Alternating), rectangle_quad4(min, max, cells)];
        for mesh in meshes {
            // A seam with corners, tilted so that rounding differs from node to node.
            let mesh = mesh.jittered(if seed % 2 == 0 { 0.0 } else { 0.2 }, seed, |_| true);
            let scene = divided(&mesh, |[x, y]| (x - 0.5).abs() + (y - 0.4).abs() < 0.33);
            let r = random_rotation::<2>(seed);
            let turn = |x: [f64; 2]| r.map(|row| row[0] * x[0] + row[1] * x[1] + 0.3);
            by_laws(estimators(), &laws(1.0))
                .into_iter()
                .for_each(|options| no_force(&scene.clone().mapped(turn).evaluate(options), options));
        }
    }
}

#[test]
fn solid_materials_do_not_push_each_other() {
    let (min, max, cells) = ([0.0; 3], [1.0, 0.8, 0.6], [4, 3, 3]);
    for seed in 0..6 {
        let meshes = [cuboid_tet4(min, max, cells), cuboid_hex8(min, max, cells)];
        for mesh in meshes {
            let mesh = mesh.jittered(if seed % 2 == 0 { 0.0 } else { 0.2 }, seed, |_| true);
            let scene = divided(&mesh, |[x, y, z]| (x - 0.4).abs() + (y - 0.5).abs() + (z - 0.2).abs() < 0.5);
            let r = random_rotation::<3>(seed);
            let turn = |x: [f64; 3]| r.map(|row| row[0] * x[0] + row[1] * x[1] + row[2] * x[2] + 0.3);
            by_laws(estimators(), &laws(1.0))
                .into_iter()
                .for_each(|options| no_force(&scene.clone().mapped(turn).evaluate(options), options));
        }
    }
}

/// The seam stays silent while a third body presses on both sides of it, which feel what one body would feel.
#[test]
fn third_body_presses_on_the_seam() {
    let block = rectangle_tri3([-1.0, -1.0], [1.0, 0.0], [8, 4], Diagonals::Alternating);
    let punch = rectangle_quad4([-0.3, 0.0], [0.4, 0.5], [3, 2]).rotated(0.1).translated([0.0, -0.05]);
    let two = divided(&block, |[x, _]| *x > 0.0).with(&punch, 2);
    let one = Scene::of(&[&block, &punch]);
    for options in [exact(), lines(0.003, 1)] {
        let (two, one) = (two.evaluate(options), one.evaluate(options));
        assert_eq!(two.pairs.len(), 2);
        // The overlap is divided where the seam reaches into it; its pieces are summed in another order. The balance
        // correction of lines acts on each pair by itself and may differ by the sampling error.
        let tolerance = if options == exact() { 1e-14 } else { 1e-3 };
        assert!((two.volume - one.volume).abs() < tolerance);
        let (of_two, of_one) = (&two.bodies[2], &one.bodies[1]);
        assert!((0..2).all(|i| (of_two.force[i] - of_one.force[i]).abs() < 10.0 * tolerance));
    }
}
