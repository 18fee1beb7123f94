//! A plane without friction pushes along its normal, whichever shape it is given as.

use crate::scene::table::exactly;
use crate::scene::{Scene, distance, norm};
use fmc_contact::contact::TangentPart;
use fmc_contact::{Contact, ContactForces, EnergyLaw, Obstacle, Pose, Shape};
use fmc_shapes::{cuboid_hex8, rectangle_quad4};

const K: f64 = 1e6;

fn laws() -> [EnergyLaw; 2] {
    [EnergyLaw::depth(K), EnergyLaw::fiber(K)]
}

/// A mesh with the upper face of a half-space, or of a wide cuboid, in it.
fn on<const D: usize>(scene: &Scene<D>, law: EnergyLaw, as_cuboid: bool) -> Contact<D> {
    let (shape, height) = match as_cuboid {
        true => (Shape::Cuboid { half_extents: [4.0; D] }, -4.0),
        false => (Shape::HalfSpace, 0.0),
    };
    let mut position = [0.0; D];
    position[D - 1] = height;
    let mut contact = scene.contact(exactly(law));
    contact.add_obstacle(Obstacle { shape, pose: Pose::at(position) }).expect("a valid obstacle");
    contact
}

/// A block this deep below the plane, turned by part of the angle at which one end of it would be free.
fn tilted_2d(depth: f64, part: f64) -> Scene<2> {
    let block = rectangle_quad4([-0.3, 0.0], [0.3, 0.4], [7, 4]);
    Scene::of(&[&block.rotated(part * depth / 0.3).translated([0.0, -depth])])
}

fn tilted_3d(depth: f64, part: f64) -> Scene<3> {
    let block = cuboid_hex8([-0.3, -0.2, 0.0], [0.3, 0.2, 0.4], [4, 3, 2]);
    Scene::of(&[&block.rotated([0.3, 1.0, 0.0], part * depth / 0.3).translated([0.0, 0.0, -depth])])
}

/// Along the plane nothing acts but rounding by the block's width over the penetration, and both shapes give the same forces, which their obstacles feel with the other sign.
fn pushes_along_its_normal<const D: usize>(scene: &Scene<D>) {
    laws().into_iter().for_each(|law| pushes_along_its_normal_under(scene, law));
}

fn pushes_along_its_normal_under<const D: usize>(scene: &Scene<D>, law: EnergyLaw) {
    let [plane, cuboid]: [ContactForces<D>; 2] =
        [false, true].map(|as_cuboid| on(scene, law, as_cuboid).evaluate(&scene.coords).expect("valid coordinates"));
    for found in [&plane, &cuboid] {
        let (force, back) = (found.bodies[0].force, found.obstacles[0].force);
        let normal = force[D - 1];
        for axis in 0..D - 1 {
            assert!(force[axis].abs() < 1e-10 * normal, "{force:?}");
        }
        assert!((0..D).all(|axis| (force[axis] + back[axis]).abs() < 1e-10 * normal), "{force:?} and {back:?}");
    }
    assert!((plane.energy - cuboid.energy).abs() < 1e-10 * cuboid.energy);
    let worst = distance(&plane.forces, &cuboid.forces);
    assert!(worst < 1e-10 * norm(&cuboid.forces), "{worst:e} of {:e}", norm(&cuboid.forces));
}

#[test]
fn of_a_tilted_block() {
    for depth in [1e-2, 1e-4] {
        for part in [0.1, 0.5, 0.9] {
            pushes_along_its_normal(&tilted_2d(depth, part));
            pushes_along_its_normal(&tilted_3d(depth, part));
        }
    }
}

/// On kept patches the tangent is the derivative of the force, also where walls of the block reach through the plane.
fn tangent_is_the_derivative_of_the_force<const D: usize>(scene: &Scene<D>) {
    laws().into_iter().for_each(|law| tangent_is_the_derivative_under(scene, law));
}

fn tangent_is_the_derivative_under<const D: usize>(scene: &Scene<D>, law: EnergyLaw) {
    let mut contact = on(scene, law, false);
    contact.keep_patches(&scene.coords).expect("valid coordinates");
    let tangent = contact.tangent(&scene.coords, TangentPart::Full).expect("a tangent");
    // Truncation is the square of the step by the depth; rounding 1e-16 of the forces over the step.
    let step = 1e-6;
    let change: Vec<[f64; D]> =
        (0..scene.coords.len()).map(|n| std::array::from_fn(|i| ((7 * n + 3 * i) as f64).sin())).collect();
    let forces = |sign: f64| {
        let mut moved = scene.coords.clone();
        moved.iter_mut().zip(&change).for_each(|(x, d)| (0..D).for_each(|i| x[i] += sign * step * d[i]));
        contact.evaluate(&moved).expect("valid coordinates").forces
    };
    let (high, low) = (forces(1.0), forces(-1.0));
    let mut found = vec![[0.0; D]; scene.coords.len()];
    for (row, column, value) in tangent.triplets() {
        if row.max(column) < D * found.len() {
            found[row / D][row % D] -= value * change[column / D][column % D];
        }
    }
    let differences: Vec<[f64; D]> =
        high.iter().zip(&low).map(|(p, q)| std::array::from_fn(|i| (p[i] - q[i]) / (2.0 * step))).collect();
    let error = distance(&found, &differences);
    assert!(error < 1e-6 * norm(&differences), "{error:e} of {:e}", norm(&differences));
}

#[test]
fn its_tangent_is_the_derivative_of_the_force() {
    for part in [0.1, 0.5, 0.9] {
        tangent_is_the_derivative_of_the_force(&tilted_2d(1e-2, part));
        tangent_is_the_derivative_of_the_force(&tilted_3d(1e-2, part));
    }
}
