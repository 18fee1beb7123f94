//! Which facets touch together, and along how many directions their lines run: what local laws measure by.

use crate::scene::Scene;
use crate::scene::table::{exactly, uncorrected};
use fmc_contact::{Contact, ContactForces, EnergyLaw, Obstacle, Options, Pose, Shape};
use fmc_shapes::{Diagonals, Mesh, Splitmix, cuboid_tet4, fan_tri3, polygon, rectangle_quad4, rectangle_tri3};

const K: f64 = 7.0;

/// Exact, and by lines fine enough for the tests here.
fn estimators() -> [Options; 2] {
    let law = EnergyLaw::fiber(K);
    [exactly(law), uncorrected(law, 1e-4, 1)]
}

/// Directions kept, and what is found with them.
fn kept<const D: usize>(mut contact: Contact<D>, scene: &Scene<D>) -> (usize, ContactForces<D>) {
    let directions = contact.keep_patches(&scene.coords).unwrap();
    (directions, contact.evaluate(&scene.coords).unwrap())
}

/// Force to this part of each expected component, small ones by the largest.
fn close(found: [f64; 2], expected: [f64; 2], part: f64, what: &str) {
    let largest = expected.iter().fold(0.0, |m: f64, f| m.max(f.abs()));
    for axis in 0..2 {
        let size = if expected[axis].abs() < 0.1 * largest { largest } else { expected[axis].abs() };
        assert!((found[axis] - expected[axis]).abs() < part * size, "{what}: {found:?} instead of {expected:?}");
    }
}

/// Tips so steep that no flank faces what it stands in: ∫ ½ k L² = k tan α h³ / 3.
#[test]
#[ignore = "normals of steep flanks nearly cancel, so that their sampled mean leans and the energy is a fifth too small"]
fn steep_tips_are_measured_upright() {
    let (depth, half_width) = (0.2, 0.05);
    let block = rectangle_tri3([-1.0, -1.0], [1.0, 0.0], [9, 5], Diagonals::Alternating);
    let tip = polygon(&[[0.03, -depth], [0.03 + 2.0 * half_width, depth], [0.03 - 2.0 * half_width, depth]], 2);
    for angle in [0.0, 0.4, 1.9] {
        let scene = Scene::of(&[&block.clone().rotated(angle), &fan_tri3([0.03, 0.1], &tip).rotated(angle)]);
        for options in estimators() {
            let (directions, found) = kept(scene.contact(options), &scene);
            assert_eq!(directions, 1);
            // The mean normal of steep flanks is known to some hundredths, and a tenth of that tilts them away.
            let energy = K * (half_width / depth) * depth.powi(3) / 3.0;
            assert!((found.energy / energy - 1.0).abs() < 2e-2, "angle {angle}: {}", found.energy / energy);
        }
    }
}

/// An overlap four times as long as it is deep is left across, not along, however it lies to the lines of the search.
#[test]
fn strips_are_left_across_at_every_angle() {
    let (deep, long) = (0.2, 0.8);
    for step in 0..24 {
        let angle = f64::from(step) * std::f64::consts::PI / 24.0;
        let square = |x: f64, y: f64| rectangle_quad4([x, y], [x + 1.0, y + 1.0], [2, 2]).rotated(angle);
        let scene = Scene::of(&[&square(0.0, 0.0), &square(1.0 - deep, long - 1.0)]);
        let (directions, found) = kept(scene.contact(exactly(EnergyLaw::fiber(K))), &scene);
        assert_eq!(directions, 1, "angle {angle}");
        let (s, c) = angle.sin_cos();
        let push = K * deep * long;
        // At its corners, where walls of either body end, the mean normal is known to some hundredths.
        close(found.bodies[1].force, [c * push, s * push], 5e-2, "strip");
    }
}

/// Floor and wall of one body, as a mesh.
fn corner() -> Mesh<2> {
    let mut corner = rectangle_quad4([0.0, -1.0], [2.0, 0.0], [8, 3]);
    corner.append(&rectangle_quad4([-1.0, -1.0], [0.0, 2.0], [4, 12]));
    corner.welded(1e-9)
}

/// An upright block in a floor as deep as a fifth of its width: its side walls lie in the floor too, and are no contact.
#[test]
fn side_walls_of_a_block_are_not_contact() {
    let floor = rectangle_tri3([-1.0, -1.0], [1.0, 0.0], [9, 5], Diagonals::Alternating);
    for depth in [0.01, 0.05, 0.1] {
        let block = rectangle_quad4([-0.23, -depth], [0.27, 1.0], [3, 7]);
        let scene = Scene::of(&[&floor, &block]);
        for options in estimators() {
            let (directions, found) = kept(scene.contact(options), &scene);
            assert_eq!(directions, 1, "depth {depth}");
            // A line more or less of 5 000, of a direction of which the samples know 1e-3.
            close(found.bodies[1].force, [0.0, K * depth * 0.5], 2e-3, "upright");
        }
    }
}

/// A block with a notch at its corner in a corner: two faces of different length and depth, each as if it were alone.
#[test]
fn patches_keep_their_forces_beside_others() {
    // Shallower by half; with a quarter of the length.
    for (aside, down, height) in [(0.01, 0.01, 1.0), (0.005, 0.01, 1.0), (0.01, 0.005, 1.0), (0.01, 0.01, 0.25)] {
        let outline =
            [[0.2, -down], [1.2, -down], [1.2, 0.2 + height], [-aside, 0.2 + height], [-aside, 0.2], [0.2, 0.2]];
        let block = fan_tri3([0.6, 0.3], &polygon(&outline, 2));
        let scene = Scene::of(&[&corner(), &block]);
        for options in estimators() {
            let (directions, found) = kept(scene.contact(options), &scene);
            assert_eq!(directions, 2);
            close(found.bodies[1].force, [K * aside * height, K * down], 3e-3, "notched block");
        }
    }
}

/// A flat foot on a floor and a wedge of 45° in its wall: the flanks face the wall as well as a flat face would.
#[test]
fn oblique_faces_count() {
    let (down, tip) = (0.02, 0.08);
    let outline = [[0.3, -down], [1.0, -down], [1.0, 0.9], [0.3, 0.9], [-tip, 0.6], [0.3, 0.22]];
    let block = fan_tri3([0.6, 0.5], &polygon(&outline, 3));
    let scene = Scene::of(&[&corner(), &block]);
    for options in estimators() {
        let (directions, found) = kept(scene.contact(options), &scene);
        assert_eq!(directions, 2);
        // Along the wall's normal: flanks rise 0.3 and fall 0.38 over 0.38 of length.
        let width = tip * (0.3 + 0.38) / (0.3 + tip);
        close(found.bodies[1].force, [K * 0.5 * tip * width, K * down * 0.7], 3e-2, "wedge and foot");
    }
}

/// Two feet of a table on one tilted plane stand in the same way: they are one patch through the plane between them.
#[test]
fn feet_on_one_plane_share_a_direction() {
    let mut table = rectangle_quad4([0.0, 0.2], [1.0, 0.4], [10, 2]);
    table.append(&rectangle_quad4([0.0, 0.0], [0.2, 0.2], [2, 2]));
    table.append(&rectangle_quad4([0.7, 0.0], [1.0, 0.2], [3, 2]));
    let table = table.welded(1e-9);
    for angle in [0.0, 0.3, 1.1, 4.0] {
        // The plane's own axis turns with it.
        let depth = 0.01;
        let put = table.clone().translated([0.0, -depth]).rotated(angle);
        let scene = Scene::of(&[&put]);
        for options in estimators() {
            let mut contact = scene.contact(options);
            let pose = Pose::at([0.0; 2]).turned(angle);
            contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose }).unwrap();
            let (directions, found) = kept(contact, &scene);
            assert_eq!(directions, 1, "angle {angle}");
            let (s, c) = angle.sin_cos();
            let push = K * depth * 0.5;
            close(found.bodies[0].force, [-s * push, c * push], 5e-3, "feet");
        }
    }
}

/// A bracket that hugs the corner of a rigid cuboid, with a notch in its own: top and side are two patches, though all
/// facets are of one body and all faces of one shape.
#[test]
fn faces_of_one_obstacle_are_patches_of_their_own() {
    let mut bracket = rectangle_quad4([0.2, -0.5], [0.5, -0.1], [3, 4]);
    bracket.append(&rectangle_quad4([0.3, -0.1], [0.5, 0.1], [2, 2]));
    bracket.append(&rectangle_quad4([-0.5, 0.1], [0.5, 0.3], [10, 2]));
    bracket.append(&rectangle_quad4([-0.5, 0.0], [0.1, 0.1], [6, 1]));
    let bracket = bracket.welded(1e-9);
    let (aside, down) = (0.01, 0.015);
    let pose = Pose::at([0.2 + aside - 1.0, down - 1.0]);
    let scene = Scene::of(&[&bracket]);
    for options in estimators() {
        let mut contact = scene.contact(options);
        contact.add_obstacle(Obstacle { shape: Shape::Cuboid { half_extents: [1.0, 1.0] }, pose }).unwrap();
        let (directions, found) = kept(contact, &scene);
        assert_eq!(directions, 2);
        close(found.bodies[0].force, [K * aside * 0.4, K * down * 0.6], 3e-3, "bracket");
    }
}

/// Two blocks with flat faces whose nodes are off by a millionth of a cell: from the side, rows of slivers that hide one another
/// in one place, which the search for patches had to go through piece by piece, and gave up.
#[test]
fn flat_faces_may_be_off_by_a_millionth_of_a_cell() {
    let n = 48;
    let h = 1.0 / n as f64;
    let block = |low: f64| cuboid_tet4([0.0, 0.0, low], [1.0, 1.0, low + 4.0 * h], [n, n, 4]);
    let upper = block(-0.01 * h).rotated([0.0, 0.0, 1.0], 0.1).translated([0.013, 0.017, 0.0]);
    let flat = Scene::of(&[&block(-4.0 * h), &upper]);
    let mut random = Splitmix::new(5);
    let off = 1e-6 * h;
    let coords = flat.coords.iter().map(|x| x.map(|x| x + random.between(-off, off))).collect();
    let contact = flat.contact(exactly(EnergyLaw::fiber(K)));
    let [expected, found] = [&flat.coords, &coords].map(|x: &Vec<[f64; 3]>| contact.evaluate(x).expect("an answer"));
    // The penetration is known to a ten thousandth, and the direction as well.
    assert!((found.energy / expected.energy - 1.0).abs() < 1e-3, "{} {}", found.energy, expected.energy);
    for axis in 0..3 {
        let [p, q] = [&found, &expected].map(|found| found.bodies[1].force[axis]);
        assert!((p - q).abs() < 1e-3 * expected.bodies[1].force[2].abs(), "{p} {q}");
    }
}
