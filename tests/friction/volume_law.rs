//! Friction with the law `volume`: one pressure for the whole pair, on every facet inside the other body.

use crate::scene::{Scene, norm, table::exactly};
use crate::{begun, in_plane, in_space, slid};
use fmc_contact::contact::{Friction, NodeStatus, TangentPart};
use fmc_contact::{EnergyLaw, Error, Estimator, FiberOptions, FiberPattern, Obstacle, Options, Pose, Shape};
use fmc_shapes::cuboid_hex8;

const PRESSURE: f64 = 2.0;
const STIFFNESS: f64 = 1e3;
const MU: f64 = 0.3;

fn options() -> Options {
    let friction = Friction { stiffness: Some(STIFFNESS), ..Friction::coulomb(MU) };
    Options { friction, ..exactly(EnergyLaw::volume(PRESSURE)) }
}

/// The faces, and half of either body's walls: that is what is inside the other, each side counting by half.
fn pushed<const D: usize>(scene: &Scene<D>, area: f64) {
    let contact = begun(scene, options(), &scene.coords);
    let limit = MU * PRESSURE / STIFFNESS;
    for by in [0.4 * limit, -5.0 * limit] {
        let coords = slid(scene, by);
        let found = contact.evaluate(&coords).expect("valid coordinates");
        let sum: [f64; D] = std::array::from_fn(|i| found.forces.iter().map(|f| f[i]).sum());
        assert!(norm(&[sum]) < 1e-12 * norm(&found.forces));
        let traction = -(STIFFNESS * by).clamp(-MU * PRESSURE, MU * PRESSURE);
        // Walls that look along the way slip along their normal, which is no slip.
        let force = found.bodies[1].friction[0] / (traction * area);
        assert!((force - 1.0).abs() < 2e-3, "{force}");
        let sliding = by.abs() > limit;
        let status = contact.nodal_contact(&coords).expect("valid coordinates").status;
        let expected = if sliding { NodeStatus::Sliding } else { NodeStatus::Sticking };
        for node in scene.nodes_of(1).filter(|&node| coords[node][D - 1] < 0.0) {
            assert_eq!(status[node], expected);
        }
    }
}

#[test]
fn a_block_sticks_and_slides() {
    let delta = 1e-3;
    in_plane(delta).iter().for_each(|scene| pushed(scene, 1.0));
    // Two sunken walls along the way, half of their area.
    in_space(delta).iter().for_each(|scene| pushed(scene, 0.8 + delta));
}

/// The pressure is the law's, whatever the estimator of the volume, and so is the pull of what slides.
#[test]
fn estimators_of_the_volume_have_no_part_in_it() {
    fn check<const D: usize>(scene: &Scene<D>) {
        let pull = |options: Options| {
            let contact = begun(scene, options, &scene.coords);
            contact.evaluate(&slid(scene, 5.0 * MU * PRESSURE / STIFFNESS)).expect("valid coordinates").bodies[1]
                .friction[0]
        };
        let exact = pull(options());
        for pattern in [FiberPattern::Lines, FiberPattern::Isotropic { length: None }] {
            let estimator = Estimator::Fibers(FiberOptions { pattern, ..FiberOptions::default() });
            let found = pull(Options { estimator, ..options() });
            assert!(exact < 0.0 && (found / exact - 1.0).abs() < 1e-12, "{found} instead of {exact}");
        }
    }
    in_plane(1e-3).iter().for_each(check);
    in_space(1e-3).iter().for_each(check);
}

/// A block that is held by a rigid plane, which moves along.
#[test]
fn on_an_obstacle() {
    let scene = Scene::of(&[&cuboid_hex8([-0.5, -0.4, 0.0], [0.5, 0.4, 0.7], [3, 2, 2])]);
    let mut contact = scene.contact(options());
    let at = |x: f64| Pose::at([x, 0.0, 1e-3]);
    contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: at(0.0) }).expect("an obstacle");
    contact.begin_step(&scene.coords).expect("valid coordinates");
    contact.set_pose(0, at(0.1)).expect("a pose");
    let found = contact.evaluate(&scene.coords).expect("valid coordinates");
    // All of the surface inside: the face, and four walls, of which those along the way slide as it does.
    let expected = MU * PRESSURE * (0.8 + 2e-3);
    assert!((found.bodies[0].friction[0] / expected - 1.0).abs() < 1e-9, "{:?}", found.bodies[0].friction);
    assert!((found.obstacles[0].friction[0] + found.bodies[0].friction[0]).abs() < 1e-14);
}

/// Stuck, the tangent is that of a spring on every facet; the pressure does not enter.
#[test]
fn the_tangent_of_what_sticks() {
    let scene = &in_plane(1e-3)[1];
    let rubbed = begun(scene, options(), &scene.coords);
    let smooth = scene.contact(Options { friction: Friction::default(), ..options() });
    let along: Vec<[f64; 2]> =
        (0..scene.coords.len()).map(|n| [(1.7 * n as f64).sin(), (2.3 * n as f64).cos()]).collect();
    let coords = slid(scene, 1e-5);
    let friction_at = |h: f64| -> Vec<[f64; 2]> {
        let x: Vec<[f64; 2]> =
            coords.iter().zip(&along).map(|(x, d)| std::array::from_fn(|i| x[i] + h * d[i])).collect();
        let [with, without] = [&rubbed, &smooth].map(|contact| contact.evaluate(&x).expect("valid coordinates").forces);
        with.iter().zip(&without).map(|(a, b)| std::array::from_fn(|i| a[i] - b[i])).collect()
    };
    let h = 1e-7;
    let [up, down] = [h, -h].map(friction_at);
    let products = [&rubbed, &smooth].map(|contact| {
        let tangent = contact.tangent(&coords, TangentPart::Full).expect("a tangent");
        let mut sum = vec![[0.0; 2]; coords.len()];
        for block in &tangent.blocks {
            let [row, col] = [block.row, block.col].map(|n| n as usize);
            for i in 0..2 {
                sum[row][i] -= (0..2).map(|j| block.value[i][j] * along[col][j]).sum::<f64>();
            }
        }
        sum
    });
    let size = norm(&up.iter().zip(&down).map(|(a, b)| [a[0] - b[0], a[1] - b[1]]).collect::<Vec<_>>()) / (2.0 * h);
    for node in 0..coords.len() {
        for i in 0..2 {
            let expected = (up[node][i] - down[node][i]) / (2.0 * h);
            let found = products[0][node][i] - products[1][node][i];
            // How points move over facets is left out: of the size of the penetration by that of the facets.
            assert!((found - expected).abs() < 1e-2 * size, "{node}: {found} {expected} of {size}");
        }
    }
}

#[test]
fn what_it_does_not_know_is_refused() {
    let scene = &in_plane(1e-3)[0];
    let mut contact = scene.contact(Options { friction: Friction::default(), ..options() });
    let none = Friction { stiffness: None, ..options().friction };
    let refused = contact.set_options(Options { friction: none, ..options() }).expect_err("no stiffness");
    assert!(matches!(refused, Error::Unsupported { what } if what.contains("friction_stiffness")), "{refused:?}");
}
