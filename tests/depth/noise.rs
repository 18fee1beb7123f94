//! Blocks cut from one grid, every wall of one in a wall of the other, with noise on their coordinates from below rounding
//! to 1e-4: energy and force are those without noise, and forces balance. And the same bits, however often and by however
//! many threads they are computed.

use crate::depth;
use crate::scene::{Scene, norm, size_sum};
use fmc_contact::contact::TangentPart;
use fmc_contact::{EnergyLaw, Estimator, FiberOptions, Options};
use fmc_shapes::{Diagonals, Mesh, Splitmix, cuboid_hex8, cuboid_tet4, rectangle_quad4, rectangle_tri3};

/// Noise from this power of ten to this one.
const NOISE: [[i32; 2]; 7] = [[-17, -16], [-16, -15], [-15, -14], [-14, -12], [-12, -10], [-10, -8], [-8, -4]];

fn flush<const D: usize>(lower: &Mesh<D>, upper: &Mesh<D>) {
    for down in [0.25, 0.1, 0.01] {
        let sunk = upper.clone().mapped(|mut x| {
            x[D - 1] -= down;
            x
        });
        let scene = Scene::of(&[lower, &sunk]);
        let contact = scene.contact(depth(1.0));
        let clean = contact.evaluate(&scene.coords).expect("valid coordinates");
        assert!((clean.volume - down).abs() < 1e-12);
        for (n, [from, to]) in NOISE.into_iter().enumerate() {
            for draw in 0..8 {
                let mut random = Splitmix::new((8 * n + draw) as u64);
                let size = 10f64.powf(random.between(from.into(), to.into()));
                let mut coords = scene.coords.clone();
                coords.iter_mut().flatten().for_each(|x| *x += random.between(-size, size));
                let found = contact.evaluate(&coords).expect("valid coordinates");
                // Second order in the depth: its slope by the noise is that of the force.
                let allowed = 1e-12 + 20.0 * size;
                assert!((found.volume - down).abs() < allowed, "{size:e}: V {} for {down}", found.volume);
                assert!((found.energy - clean.energy).abs() < allowed, "{size:e}: {} {}", found.energy, clean.energy);
                let force = |f: &fmc_contact::ContactForces<D>| f.bodies[1].force[D - 1];
                assert!((force(&found) - force(&clean)).abs() < allowed, "{size:e}: {}", force(&found));
                // Where a facet crosses a face is known to rounding by their angle, which is 1e-5 at least.
                let sum: [f64; D] = std::array::from_fn(|i| found.forces.iter().map(|f| f[i]).sum());
                assert!(norm(&[sum]) < 1e-11 * size_sum(&found.forces), "{size:e}: {sum:?}");
            }
        }
    }
}

#[test]
fn flush_walls_in_the_plane() {
    let block = |low: f64| ([0.0, low], [1.0, low + 1.0], [4, 4]);
    let (p, q) = (block(-1.0), block(0.0));
    flush(&rectangle_tri3(p.0, p.1, p.2, Diagonals::Same), &rectangle_tri3(q.0, q.1, q.2, Diagonals::Same));
    flush(&rectangle_quad4(p.0, p.1, p.2), &rectangle_quad4(q.0, q.1, q.2));
}

#[test]
fn flush_walls_in_space() {
    let block = |low: f64| ([0.0, 0.0, low], [1.0, 1.0, low + 1.0], [2, 2, 4]);
    let (p, q) = (block(-1.0), block(0.0));
    flush(&cuboid_tet4(p.0, p.1, p.2), &cuboid_tet4(q.0, q.1, q.2));
    flush(&cuboid_hex8(p.0, p.1, p.2), &cuboid_hex8(q.0, q.1, q.2));
}

#[test]
fn the_same_bits() {
    let lower = cuboid_tet4([0.0, 0.0, -1.0], [1.0, 1.0, 0.0], [5, 5, 4]);
    let upper = cuboid_hex8([0.1, 0.2, -0.1], [0.9, 0.8, 0.9], [4, 4, 4]).rotated([1.0, 2.0, 3.0], 0.03);
    let scene = Scene::of(&[&lower, &upper]);
    let options = depth(1e3);
    let contact = scene.contact(options);
    let both = |contact: &fmc_contact::Contact<3>, coords: &[[f64; 3]]| {
        contact.evaluate_tangent(coords, TangentPart::Full).expect("valid coordinates")
    };
    let first = both(&contact, &scene.coords);
    let moved: Vec<[f64; 3]> = scene.coords.iter().map(|x| x.map(|x| 1.01 * x)).collect();
    contact.evaluate(&moved).expect("valid coordinates");
    assert!(both(&contact, &scene.coords) == first, "after a look elsewhere");
    for threads in [2, 3, 8] {
        assert!(both(&scene.contact(Options { threads, ..options }), &scene.coords) == first, "{threads} threads");
    }
    let auto = Options { estimator: Estimator::Auto(FiberOptions::default()), ..Options::new(EnergyLaw::depth(1e3)) };
    assert!(both(&scene.contact(auto), &scene.coords) == first, "chosen automatically");
}
