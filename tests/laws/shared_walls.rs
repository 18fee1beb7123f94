//! Two bodies cut by a plane of symmetry: their walls coincide in it, and lines that are not quite parallel meet both at
//! once.

use crate::scene::Scene;
use fmc_contact::{EnergyLaw, Estimator, Options};
use fmc_shapes::Diagonals;
use fmc_shapes::{Mesh, Splitmix, cuboid_hex8, cuboid_tet4, random_rotation, rectangle_quad4, rectangle_tri3};

const DEPTH: f64 = 0.02;

/// A block of length 1 on one of length 2, with walls at x = 0, the surfaces between them inclined by `slope` and
/// interpenetrating by [`DEPTH`] along the last axis. Coordinates are moved and turned as rounding would.
fn on_one_another<const D: usize>(lower: &Mesh<D>, upper: &Mesh<D>, slope: f64, seed: u64) -> Scene<D> {
    let inclined = |mesh: &Mesh<D>, by: f64| {
        mesh.clone().mapped(|mut x| {
            x[D - 1] += slope * x[0] - by;
            x
        })
    };
    let mut scene = Scene::of(&[&inclined(lower, 0.0), &inclined(upper, DEPTH)]);
    let mut random = Splitmix::new(seed);
    for x in scene.coords.iter_mut().filter(|_| seed > 0).flatten() {
        *x += random.between(-1e-16, 1e-16);
    }
    let turned = random_rotation::<D>(seed);
    scene.mapped(|x| if seed > 3 { turned.map(|row| (0..D).map(|i| row[i] * x[i]).sum()) } else { x })
}

/// With k = 1: ½ ∫ L² over the lines along the normal, L being the depth but for ramps at both walls.
fn energy_of(slope: f64) -> f64 {
    let (sine, cosine) = slope.atan().sin_cos();
    0.5 * (DEPTH * cosine).powi(2) * (1.0 / cosine - DEPTH * sine.abs() / 3.0)
}

fn energy_is_that_of_the_overlap<const D: usize>(lower: &Mesh<D>, upper: &Mesh<D>) {
    for slope in [-0.3, -0.01, -1e-5, 0.0, 1e-3, 0.1] {
        for seed in 0..8 {
            let scene = on_one_another(lower, upper, slope, seed);
            let options = Options { estimator: Estimator::Exact, ..Options::new(EnergyLaw::fiber(1.0)) };
            let mut contact = scene.contact(options);
            contact.keep_patches(&scene.coords).unwrap();
            let energy = contact.evaluate(&scene.coords).unwrap().energy;
            // Rounding of coordinates of size 1 by the depth, and slivers of 1e-12 of a piece.
            let off = energy / energy_of(slope) - 1.0;
            assert!(off.abs() < 1e-10, "slope {slope}, seed {seed}: off by {off:e}");
        }
    }
}

#[test]
fn walls_in_a_plane_of_symmetry_count_once_in_2d() {
    let (low, middle, high) = ([0.0, -1.0], [2.0, 0.0], [1.0, 1.0]);
    let upper = rectangle_quad4([0.0; 2], high, [5, 5]);
    energy_is_that_of_the_overlap(&rectangle_quad4(low, middle, [7, 7]), &upper);
    energy_is_that_of_the_overlap(&rectangle_tri3(low, middle, [7, 60], Diagonals::Alternating), &upper);
}

#[test]
fn walls_in_a_plane_of_symmetry_count_once_in_3d() {
    let (low, middle, high) = ([0.0, 0.0, -1.0], [2.0, 1.0, 0.0], [1.0; 3]);
    let lower = cuboid_hex8(low, middle, [3, 2, 3]);
    energy_is_that_of_the_overlap(&lower, &cuboid_hex8([0.0; 3], high, [2; 3]));
    energy_is_that_of_the_overlap(&cuboid_tet4(low, middle, [3, 2, 4]), &cuboid_tet4([0.0; 3], high, [2; 3]));
}
