//! Cells of every type in space, alone and in one body.

#[path = "../scene/scene.rs"]
mod scene;

mod collapsed;
mod cubes;
mod derivatives;
mod fields;
mod flat;
mod numbers;
mod single;

use fmc_shapes::{Mesh, cuboid_hex8, cuboid_mixed, cuboid_pyramid5, cuboid_tet4, cuboid_wedge6};
use scene::Scene;

/// A box in cells of each type, then of all four; meshes of one entry share their nodes.
fn boxes(min: [f64; 3], max: [f64; 3], cells: [usize; 3]) -> Vec<Vec<Mesh<3>>> {
    let makers = [cuboid_hex8, cuboid_tet4, cuboid_wedge6, cuboid_pyramid5];
    let pure = makers.map(|make: fn([f64; 3], [f64; 3], [usize; 3]) -> Mesh<3>| vec![make(min, max, cells)]);
    pure.into_iter().chain([cuboid_mixed(min, max, cells).to_vec()]).collect()
}

/// Bodies 0 and 1.
fn pair(lower: &[Mesh<3>], upper: &[Mesh<3>]) -> Scene<3> {
    Scene::new().with_mixed(lower, 0).with_mixed(upper, 1)
}

/// All nodes moved at random by up to this much.
fn shaken(coords: &[[f64; 3]], by: f64, seed: u64) -> Vec<[f64; 3]> {
    let mut random = fmc_shapes::Splitmix::new(seed);
    coords.iter().map(|x| x.map(|x| x + random.between(-by, by))).collect()
}
