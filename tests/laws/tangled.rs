//! What would take hours is refused before it does.

use crate::scene::Scene;
use crate::scene::table::exactly;
use fmc_contact::{EnergyLaw, Error};
use fmc_shapes::{Mesh, Splitmix, icosphere};

/// A closed surface whose vertices lie anywhere: every facet passes through most others.
fn crumpled(level: usize, seed: u64) -> Mesh<3> {
    let mut ball = icosphere(1.0, level);
    let mut random = Splitmix::new(seed);
    ball.coords.iter_mut().flatten().for_each(|x| *x = random.between(0.0, 1.0));
    ball
}

#[test]
fn surfaces_folded_through_each_other_all_over_are_refused_by_name() {
    // Facets that point inwards on the whole are turned over.
    let mesh = |seed: u64| {
        let mesh = crumpled(3, seed);
        let turned: Vec<u32> = mesh.conn.chunks(3).flat_map(|f| [f[0], f[2], f[1]]).collect();
        let is_inside_out = mesh.measure() < 0.0;
        if is_inside_out { Mesh { conn: turned, ..mesh } } else { mesh }
    };
    let scene = Scene::of(&[&mesh(1), &mesh(2)]);
    let error = scene.contact(exactly(EnergyLaw::fiber(1.0))).evaluate(&scene.coords).unwrap_err();
    assert!(matches!(error, Error::TooManyPieces { sides: [("body", 0), ("body", 1)], limit } if limit >= 1_000_000));
    assert!(error.to_string().contains("body 0 and body 1"), "{error}");
}
