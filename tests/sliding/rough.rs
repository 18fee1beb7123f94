//! What is rough never slides where it touches, and opens as contact does: friction without a limit.

use crate::scene::Scene;
use crate::{K, largest, shifted, with};
use fmc_contact::contact::{Friction, GradientRequest, Interface, PairOptions, TangentPart};
use fmc_contact::overlap::Partner::{Body, Obstacle as Rigid};
use fmc_contact::{Contact, EnergyLaw, Error, Obstacle, Options, Pose, Shape};
use fmc_shapes::{cuboid_hex8, rectangle_quad4};

fn plane() -> Scene<2> {
    Scene::of(&[&rectangle_quad4([0.0, 0.0], [2.0, 1.0], [5, 1]), &rectangle_quad4([0.4, 1.0], [1.4, 2.0], [3, 1])])
}

/// The contact after a first step that presses the block by 0.01.
fn pressed(options: PairOptions) -> Contact<2> {
    let scene = plane();
    let mut contact = with(&scene, options);
    contact.begin_step(&scene.coords).expect("a step");
    contact.commit_step(&shifted(&scene, [0.0, -0.01])).expect("a step");
    contact
}

/// Sheared by 50 times its depth under a pressure of 1: by 1e6 times the pressure it does not slide either, and all is the same to the bit
/// but for the part of the limit in the tangent, which is none while both stick.
#[test]
fn rough_is_an_endless_coefficient() {
    let scene = plane();
    let rough = pressed(PairOptions::rough());
    for options in [PairOptions::with_friction(1e6), PairOptions::with_friction(f64::INFINITY)] {
        let other = pressed(options);
        for by in [[0.5, -0.01], [-0.3, -0.005], [0.01, -0.02]] {
            let at = shifted(&scene, by);
            let found = rough.evaluate(&at).expect("an evaluation");
            assert_eq!(found, other.evaluate(&at).expect("an evaluation"));
            assert!(found.friction.slip_area == 0.0 && found.friction.stick_area > 0.6);
            let products =
                [&rough, &other].map(|one| one.tangent(&at, TangentPart::Full).expect("a tangent").product(&at));
            assert_eq!(products[0], products[1]);
        }
    }
    let found = rough.evaluate(&shifted(&scene, [0.05, -0.01])).expect("an evaluation");
    // k_T times the slip over the area of 1; without a limit, far more than any friction of the pressure K/100.
    assert!((found.bodies[1].force[0] + K * 0.05).abs() < 1e-9 * K, "{:?}", found.bodies[1]);
    assert!((found.bodies[1].force[1] - K * 0.01).abs() < 1e-3 * K, "{:?}", found.bodies[1]);
}

#[test]
fn rough_opens_and_forgets() {
    let scene = plane();
    let mut contact = pressed(PairOptions::rough());
    let sheared = shifted(&scene, [0.05, -0.01]);
    contact.commit_step(&sheared).expect("a step");
    let lifted = shifted(&scene, [0.05, 0.01]);
    let found = contact.evaluate(&lifted).expect("an evaluation");
    assert!(largest(&found.forces) == 0.0 && found.friction.stored == 0.0 && found.friction.dissipated > 0.0);
    contact.commit_step(&lifted).expect("a step");
    // What touches anew is not sheared, wherever it does so.
    let found = contact.evaluate(&sheared).expect("an evaluation");
    assert!(found.bodies[1].force[0].abs() < 1e-12 * K && found.bodies[1].force[1] > 0.5e-2 * K);
}

/// In space, frozen, and against an obstacle: numbers are finite, and nothing slides.
#[test]
fn everything_that_friction_has_is_finite() {
    let scene = Scene::of(&[
        &cuboid_hex8([0.0; 3], [2.0, 2.0, 1.0], [3, 2, 1]),
        &cuboid_hex8([0.5, 0.5, 0.99], [1.5, 1.5, 2.0], [2, 2, 1]),
    ]);
    let mut contact = with(&scene, PairOptions::rough());
    contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, 0.0, 0.01]) }).expect("an obstacle");
    contact.set_pair_options([Body(0), Rigid(0)], Some(PairOptions::rough())).expect("options");
    contact.begin_step(&scene.coords).expect("a step");
    let at = shifted(&scene, [0.3, -0.2, -0.01]);
    for frozen in [false, true] {
        if frozen {
            contact.freeze_friction(&at).expect("a step");
        }
        let (found, tangent) = contact.evaluate_tangent(&at, TangentPart::Full).expect("an evaluation");
        assert!(found.forces.iter().flatten().all(|f| f.is_finite()) && found.friction.slip_area == 0.0);
        assert!(found.friction.stored > 0.0 && found.friction.dissipated.is_finite());
        assert!(tangent.product(&at).iter().flatten().all(|f| f.is_finite()));
    }
    contact.release_friction();
    contact.commit_step(&at).expect("a step");
    assert!(contact.evaluate(&at).expect("an evaluation").friction.stored.is_finite());
    let request = GradientRequest { friction: true, ..GradientRequest::default() };
    assert!(matches!(contact.vjp(&at, 0.0, Some(&at), &request), Err(Error::Unsupported { .. })));
}

#[test]
fn what_would_have_no_effect_is_refused() {
    let scene = plane();
    let mut contact = scene.contact(Options::new(EnergyLaw::depth(K)));
    let plain = PairOptions::rough();
    for (options, named) in [
        (PairOptions { friction_coefficient: Some(0.3), ..plain }, "never slides"),
        (PairOptions { excluded: true, ..plain }, "excluded and rough"),
        (PairOptions::with_friction(-1.0), "friction_coefficient"),
        (PairOptions::with_friction(f64::NAN), "friction_coefficient"),
        (PairOptions::with_friction(f64::NEG_INFINITY), "friction_coefficient"),
    ] {
        let error = contact.set_pair_options([Body(0), Body(1)], Some(options)).expect_err("refused");
        assert!(matches!(error, Error::OfPair { .. }) && error.to_string().contains(named), "{error}");
    }
    contact.set_pair_options([Body(0), Body(1)], Some(plain)).expect("options");
    let found = contact.pair_options([Body(0), Body(1)]).expect("a pair").expect("options");
    assert!(found == plain && found.interface == Interface::Rough);
    // Without memory it would creep.
    let creeping = Friction { memoryless_slip: Some(1e-3), ..Friction::default() };
    let error = contact.set_options(Options { friction: creeping, ..Options::new(EnergyLaw::depth(K)) });
    assert!(matches!(error, Err(Error::OfPair { .. })), "{error:?}");
    // A limit of the shear traction is that of the options, and a rough pair has none.
    let limited = Friction { shear_limit: 0.1, ..Friction::default() };
    contact.set_options(Options { friction: limited, ..Options::new(EnergyLaw::depth(K)) }).expect("options");
    contact.begin_step(&scene.coords).expect("a step");
    let found = contact.evaluate(&shifted(&scene, [0.5, -0.01])).expect("an evaluation");
    assert!(found.friction.slip_area == 0.0 && found.bodies[1].force[0] < -1.0);
}
