//! Forces of partly refined meshes beside those of meshes that fit.

use crate::scene::{Scene, exact, fibers, table::exactly};
use crate::{boxes, rectangles, refined};
use fmc_contact::contact::TangentPart;
use fmc_contact::{EnergyLaw, FiberOptions, Options};
use fmc_shapes::{Mesh, Splitmix, cuboid_hex8, rectangle_quad4};

const DELTA: f64 = 0.01;

fn laws() -> [Options; 4] {
    let by_fibers = FiberOptions { resolution: fmc_contact::Resolution::Spacing(0.01), ..FiberOptions::default() };
    [exact(), exactly(EnergyLaw::fiber(4.0)), exactly(EnergyLaw::depth(4.0)), fibers(by_fibers)]
}

/// The block above carries the same forces, whichever mesh is below, and all of it is measured.
fn above_the_same<const D: usize>(plain: &Mesh<D>, refined: &[Mesh<D>], upper: &Mesh<D>) {
    for options in laws() {
        let expected = Scene::of(&[plain, upper]).evaluate(options);
        for lower in refined {
            let scene = Scene::of(&[lower, upper]);
            let found = scene.evaluate(options);
            let is_sampled = !matches!(options.estimator, fmc_contact::Estimator::Exact);
            // Depth is that of the cells, which near edges differ between the meshes.
            let is_depth = matches!(options.law, EnergyLaw::Depth { .. }) && D == 3;
            let within = if is_sampled {
                1e-2
            } else if is_depth {
                1e-3
            } else {
                1e-9
            };
            assert!((found.volume / expected.volume - 1.0).abs() < within, "{} {}", found.volume, expected.volume);
            let total = expected.bodies[1].force[D - 1];
            for axis in 0..D {
                let [a, b] = [&found, &expected].map(|found| found.bodies[1].force[axis]);
                assert!((a - b).abs() < within * total.abs(), "{a} for {b}: {options:?}");
            }
        }
    }
}

#[test]
fn a_flat_block_on_top() {
    let upper = rectangle_quad4([0.13, 1.0 - DELTA], [0.77, 1.5], [3, 2]);
    above_the_same(&rectangle_quad4([0.0; 2], [1.0; 2], [4, 4]), &rectangles([0.0; 2], [1.0; 2], [4, 4]), &upper);
    let upper = cuboid_hex8([0.13, 0.2, 1.0 - DELTA], [0.77, 0.71, 1.5], [3, 2, 2]);
    above_the_same(&cuboid_hex8([0.0; 3], [1.0; 3], [3; 3]), &boxes([0.0; 3], [1.0; 3], [3; 3]), &upper);
}

/// A node that hangs is where its parents put it, and what acts on it acts on them.
#[test]
fn what_hangs_follows_its_parents() {
    let lower = refined(&rectangle_quad4([0.0; 2], [1.0; 2], [2, 1]), |cell| cell == 0);
    let upper = rectangle_quad4([0.2, 0.2], [0.8, 0.7], [2, 2]);
    let scene = Scene::of(&[&lower, &upper]);
    let hanging = scene.coords.iter().position(|x| *x == [0.5, 0.5]).expect("a node");
    let contact = scene.contact(exactly(EnergyLaw::depth(3.0)));
    let at = contact.evaluate(&scene.coords).expect("forces");
    assert_eq!(at.forces[hanging], [0.0; 2]);
    let mut coords = scene.coords.clone();
    coords[hanging] = [0.51, 0.47];
    assert_eq!(contact.evaluate(&coords).expect("forces"), at);
    let tangent = contact.tangent(&coords, TangentPart::Full).expect("a tangent");
    assert!(tangent.places().all(|(row, col)| row as usize != hanging && col as usize != hanging));
}

/// Grids that lie on one another, so that nodes meet edges in whose middle a node hangs.
#[test]
fn on_a_shared_grid() {
    let upper = cuboid_hex8([0.0, 0.0, 1.0 - DELTA], [1.0, 1.0, 1.5], [6, 6, 2]);
    above_the_same(&cuboid_hex8([0.0; 3], [1.0; 3], [3; 3]), &boxes([0.0; 3], [1.0; 3], [3; 3]), &upper);
}

/// Force and tangent are derivatives, with nodes that hang where their parents put them, and anywhere else.
#[test]
fn slopes() {
    let lower = refined(&cuboid_hex8([0.0, 0.0, -1.0], [1.5, 1.2, 0.0], [3, 3, 2]), |cell| cell % 2 == 0);
    let upper = boxes([0.31, 0.12, -0.3], [1.27, 1.03, 0.6], [2, 2, 2]);
    for (k, upper) in upper.iter().enumerate() {
        let scene = Scene::of(&[&lower, upper]);
        let mut random = Splitmix::new(k as u64);
        let coords: Vec<[f64; 3]> = scene.coords.iter().map(|x| x.map(|x| x + random.between(-0.01, 0.01))).collect();
        for law in [EnergyLaw::volume(1.0), EnergyLaw::depth(5.0)] {
            let contact = scene.contact(exactly(law));
            let at = contact.evaluate(&coords).expect("forces");
            let tangent = contact.tangent(&coords, TangentPart::Full).expect("a tangent");
            let direction: Vec<[f64; 3]> =
                coords.iter().map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect();
            let at_step = |h: f64| {
                let moved: Vec<[f64; 3]> =
                    (coords.iter().zip(&direction)).map(|(x, d)| std::array::from_fn(|i| x[i] + h * d[i])).collect();
                contact.evaluate(&moved).expect("forces")
            };
            let slope = (at_step(1e-5).energy - at_step(-1e-5).energy) / 2e-5;
            let along: f64 = at.forces.iter().flatten().zip(direction.iter().flatten()).map(|(f, d)| f * d).sum();
            let sizes = crate::scene::size_sum(&at.forces);
            assert!((along + slope).abs() < 1e-6 * sizes, "{along} against {slope}: {law:?}");
            let (plus, minus) = (at_step(1e-7).forces, at_step(-1e-7).forces);
            let product = tangent.product(&direction);
            let slopes = plus.iter().flatten().zip(minus.iter().flatten()).map(|(p, m)| (m - p) / 2e-7);
            let error = slopes.zip(product.iter().flatten()).map(|(s, p)| (s - p).abs()).fold(0.0, f64::max);
            let largest = product.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
            assert!(error < 1e-6 * largest, "{error} of {largest}: {law:?}");
        }
    }
}
