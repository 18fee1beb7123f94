//! Pairs of random bodies that overlap.

use crate::scene::Scene;
use fmc_shapes::{Mesh, Splitmix, random_polygon, random_polyhedron, random_rotation};

/// Two concave polygons of different size, the smaller with its centre near the rim of the larger.
pub(crate) fn plane_pair(seed: u64) -> [Mesh<2>; 2] {
    let mut random = Splitmix::new(seed ^ 0xa5a5);
    let a = random_polygon(6 + (seed % 9) as usize, 1.0, 0.5, seed);
    let b = random_polygon(5 + (seed % 5) as usize, 0.7, 0.4, seed + 1_000);
    let angle = random.between(0.0, 6.3);
    [a, b.translated([random.between(0.5, 0.9), random.between(-0.2, 0.4)]).rotated(angle)]
}

/// Two concave polyhedra of 80 and 20 facets.
pub(crate) fn solid_pair(seed: u64) -> [Mesh<3>; 2] {
    let mut random = Splitmix::new(seed ^ 0x5a5a);
    let a = random_polyhedron(1, 1.0, 0.3, 1, seed);
    let b = random_polyhedron(0, 0.7, 0.3, 2, seed + 1_000).translated([random.between(0.6, 0.9), 0.3, 0.1]);
    [a.rotated_by(random_rotation(seed)), b.rotated_by(random_rotation(seed + 1))]
}

pub(crate) fn plane_scene(seed: u64) -> Scene<2> {
    let [a, b] = plane_pair(seed);
    Scene::of(&[&a, &b])
}

pub(crate) fn solid_scene(seed: u64) -> Scene<3> {
    let [a, b] = solid_pair(seed);
    Scene::of(&[&a, &b])
}
