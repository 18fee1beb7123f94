//! Gaps closed and overlaps removed without strain, beside bodies that were made to touch.

use crate::scene::Scene;
use crate::scene::table::exactly;
use fmc_contact::contact::{Cohesive, Friction, PairOptions, TangentPart};
use fmc_contact::overlap::Partner::Body;
use fmc_contact::{Contact, EnergyLaw, Error, Obstacle, Options, Pose, Shape};
use fmc_shapes::rectangle_quad4;

const K: f64 = 1e3;

/// A block on a longer one, a gap above it.
fn blocks(gap: f64) -> Scene<2> {
    let below = rectangle_quad4([-0.3, -1.0], [1.4, 0.0], [6, 3]);
    Scene::of(&[&below, &rectangle_quad4([0.0, gap], [1.0, 1.0 + gap], [4, 4])])
}

/// The upper block moved.
fn moved(scene: &Scene<2>, way: [f64; 2]) -> Vec<[f64; 2]> {
    let mut coords = scene.coords.clone();
    for node in scene.nodes_of(1) {
        coords[node] = [coords[node][0] + way[0], coords[node][1] + way[1]];
    }
    coords
}

fn options() -> Vec<Options> {
    let friction = Friction { stiffness: Some(K), ..Friction::coulomb(0.3) };
    let laws = [EnergyLaw::depth(K), EnergyLaw::fiber(K), EnergyLaw::Volume { stiffness: K, exponent: 1.0 }];
    laws.into_iter().flat_map(|law| [exactly(law), Options { friction, ..exactly(law) }]).collect()
}

fn begun(scene: &Scene<2>, options: Options) -> Contact<2> {
    let mut contact = scene.contact(options);
    contact.begin_step(&scene.coords).expect("a step");
    contact
}

/// Faces that are flat and apart, or in one another, press as those that touch, under every law, with friction too.
#[test]
fn flat_faces_press_as_if_they_had_touched() {
    for options in options() {
        for gap in [0.05, -0.05] {
            let (touching, apart) = (blocks(0.0), blocks(gap));
            let (expected, mut contact) = (begun(&touching, options), begun(&apart, options));
            let found = contact.adjust(&apart.coords, 0.1, 0.1).expect("an adjustment");
            let (closed, removed) = (found.closed, found.removed);
            assert!(if gap > 0.0 { closed >= gap && removed == 0.0 } else { removed > 0.7 * -gap && closed <= 0.1 });
            assert!(found.left < 0.01 * gap.abs() && found.count > 0, "{found:?}");
            contact.begin_step(&apart.coords).expect("a step");
            let way = [0.004, -0.01];
            let pressed = contact.evaluate(&moved(&apart, way)).expect("forces");
            let wanted = expected.evaluate(&moved(&touching, way)).expect("forces");
            // Points beside the upper block's rim see a part of it alone, and lie where the mean over that part is zero.
            let size = wanted.bodies[1].force[1].abs();
            for axis in 0..2 {
                let (found, wanted) = (pressed.bodies[1].force[axis], wanted.bodies[1].force[axis]);
                assert!((found - wanted).abs() <= 0.1 * size, "{options:?} {gap}: {found} {wanted}");
            }
        }
    }
}

/// Nodes of an obstacle do not move: those of the body go all of the way. Nothing happens beyond the lengths that were given.
#[test]
fn a_body_goes_all_of_the_way_to_an_obstacle() {
    let scene = Scene::of(&[&rectangle_quad4([0.0, 0.02], [1.0, 1.0], [3, 3])]);
    let mut contact = scene.contact(exactly(EnergyLaw::depth(K)));
    contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::default() }).expect("an obstacle");
    assert_eq!(contact.adjust(&scene.coords, 0.01, 0.5).expect("nothing").count, 0);
    assert!(contact.offsets().iter().all(|offset| *offset == [0.0; 2]));
    let found = contact.adjust(&scene.coords, 0.03, 0.0).expect("an adjustment");
    assert_eq!(found.count, 4);
    assert!((found.closed - 0.02).abs() < 1e-15 && found.left < 1e-15, "{found:?}");
    assert_eq!(contact.evaluate(&scene.coords).expect("forces").energy, 0.0);
    // Parts of the offsets are parts of the fit.
    let half: Vec<[f64; 2]> = contact.offsets().iter().map(|[x, y]| [0.5 * x, 0.5 * y]).collect();
    contact.set_offsets(&half).expect("offsets");
    let lower: Vec<[f64; 2]> = scene.coords.iter().map(|[x, y]| [*x, y - 0.015]).collect();
    let energy = contact.evaluate(&lower).expect("forces").energy;
    assert!((energy - 0.5 * K * 0.005f64.powi(2)).abs() < 1e-9, "{energy}");
}

/// Forces stay those of one energy: the tangent is their derivative.
#[test]
fn the_tangent_is_that_of_the_surfaces_where_they_lie() {
    let scene = blocks(0.03);
    let mut contact = scene.contact(exactly(EnergyLaw::depth(K)));
    contact.adjust(&scene.coords, 0.05, 0.0).expect("an adjustment");
    let at = moved(&scene, [0.003, -0.01]);
    let direction: Vec<[f64; 2]> = (0..at.len()).map(|n| [(n as f64).sin(), (2.0 * n as f64).cos()]).collect();
    let to = |t: f64| -> Vec<[f64; 2]> {
        at.iter().zip(&direction).map(|(x, d)| [x[0] + t * d[0], x[1] + t * d[1]]).collect()
    };
    let step = 1e-6;
    let [ahead, behind] = [step, -step].map(|t| contact.evaluate(&to(t)).expect("forces").forces);
    let product = contact.tangent(&at, TangentPart::Full).expect("a tangent").product(&direction);
    let largest = product.as_flattened().iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    for (node, product) in product.iter().enumerate() {
        for axis in 0..2 {
            let by_differences = (behind[node][axis] - ahead[node][axis]) / (2.0 * step);
            assert!((by_differences - product[axis]).abs() < 1e-6 * largest);
        }
    }
}

/// What surfaces are given or lose is no slip, and nothing that is refused changes anything.
#[test]
fn offsets_make_no_slip_and_refusals_change_nothing() {
    let scene = blocks(-0.01);
    let friction = Friction { stiffness: Some(K), ..Friction::coulomb(0.3) };
    let mut contact = begun(&scene, Options { friction, ..exactly(EnergyLaw::depth(K)) });
    let upper: Vec<[f64; 2]> = {
        let mut all = vec![[0.0; 2]; scene.coords.len()];
        scene.nodes_of(1).for_each(|node| all[node] = [0.003, 0.001]);
        all
    };
    contact.set_offsets(&upper).expect("offsets");
    let found = contact.evaluate(&scene.coords).expect("forces");
    assert!(found.bodies[1].force[1] > 0.0 && found.friction.stored < 1e-20 && found.bodies[1].force[0].abs() < 1e-9);
    let mut short = upper.clone();
    short.pop();
    assert!(matches!(contact.set_offsets(&short), Err(Error::Length { array: "offsets", .. })));
    let mut wrong = upper.clone();
    wrong[3] = [0.0, f64::NAN];
    assert_eq!(contact.set_offsets(&wrong), Err(Error::NonFiniteStiffness { array: "offsets", entry: 7 }));
    for (close, remove) in [(-1.0, 0.0), (0.0, f64::NAN), (f64::INFINITY, 0.0)] {
        assert!(matches!(contact.adjust(&scene.coords, close, remove), Err(Error::NotPositive { .. })));
    }
    assert_eq!(contact.offsets(), upper);
    contact.set_offsets(&[]).expect("none");
    assert!(contact.offsets().iter().all(|offset| *offset == [0.0; 2]));
}

/// Bodies that are held together keep their gap: adjusting them later would do nothing. Adjusted first, they have none.
#[test]
fn what_is_held_together_across_a_gap_is_adjusted_first() {
    let scene = blocks(0.02);
    let pair = [Body(0), Body(1)];
    let held = [
        PairOptions::tied(0.1),
        PairOptions::no_separation(0.1),
        PairOptions::with_cohesive(Cohesive { reach: 0.1, ..Cohesive::new(1.0, 0.1) }),
    ];
    for options in held {
        let mut contact = scene.contact(Options::new(EnergyLaw::depth(K)));
        contact.set_pair_options(pair, Some(options)).expect("an interface");
        let refused = contact.adjust(&scene.coords, 0.05, 0.0).expect_err("no adjustment").to_string();
        assert!(refused.contains("body 0 and body 1") && refused.contains("adjust first"), "{refused}");
        assert!(contact.offsets().iter().all(|offset| *offset == [0.0; 2]));
        contact.set_pair_options(pair, None).expect("a contact");
        assert!(contact.adjust(&scene.coords, 0.05, 0.0).expect("an adjustment").count > 0);
        contact.set_pair_options(pair, Some(options)).expect("an interface");
        // What the adjustment left is no gap.
        contact.adjust(&scene.coords, 0.05, 0.0).expect("an adjustment");
    }
}
