//! What is refused is named as hosts know it, and what is accepted loses nothing by rounding.

use crate::{held, in_the_plane, law, moved};
use fmc_contact::contact::{Cohesive, PairOptions, PointDamage};
use fmc_contact::overlap::Partner::Body;
use fmc_contact::{EnergyLaw, Error, Obstacle, Options, Pose, Shape};

fn refused(options: PairOptions, gap: f64) -> String {
    let mut contact = in_the_plane(gap)[0].contact(Options::new(EnergyLaw::depth(1.0)));
    contact.set_pair_options([Body(0), Body(1)], Some(options)).expect_err("no interface").to_string()
}

#[test]
fn messages_name_the_option_and_the_interface() {
    let exponent = refused(PairOptions::with_cohesive(Cohesive { exponent: 0.5, ..law() }), 0.0);
    assert!(exponent.contains("'mixed_mode_exponent' is 0.5"), "{exponent}");
    let apart = refused(PairOptions::with_cohesive(law()), 0.2);
    assert!(apart.contains("bodies 0 and 1 are joined by a cohesive interface, and face"), "{apart}");
    assert!(refused(PairOptions::tied(0.1), 0.2).contains("bodies 0 and 1 are tied, and face"));
    // Whatever the law says: it has no effect.
    let with_law = PairOptions {
        law: Some(EnergyLaw::depth(0.0)),
        ..PairOptions::with_cohesive(Cohesive { reach: 0.1, ..law() })
    };
    assert!(refused(with_law, 0.0).contains("a law of bodies with a cohesive interface"));
    let scene = &in_the_plane(0.0)[0];
    let mut contact = held(scene, law());
    let ended = contact.commit_step(&scene.coords).expect_err("no step").to_string();
    assert!(ended.contains("no step has begun: call begin_step") && ended.contains("before commit_step"), "{ended}");
    let mut damage = contact.damage().expect("damage");
    for value in [-0.1, 1.1, f64::NAN] {
        damage[2] = PointDamage { damage: value, dissipated: 0.0 };
        let error = contact.set_damage(&damage).expect_err("no damage");
        assert!(matches!(error, Error::NotPositive { name: "damage", .. }), "{error}");
    }
}

#[test]
fn the_area_of_no_points_is_a_plain_zero() {
    let scene = &in_the_plane(0.0)[0];
    let found = held(scene, law()).cohesive([0, 1], &scene.coords).expect("bodies").expect("an interface");
    assert_eq!([found.damaged_area, found.broken_area].map(f64::to_bits), [0, 0]);
}

/// 1 − d is 1/m in the middle of the softening: rounding of d takes 1e-16 m of the traction, 1e-6 of it at the largest stiffness. Coordinates
/// of 1 at an opening of 0.05 add 1e-14.
#[test]
fn the_stiffest_interface_softens_by_the_closed_form() {
    let scene = &in_the_plane(0.0)[0];
    let most = 5e9 * 2.0 * 2.0 / 0.1;
    let mut contact = held(scene, Cohesive { stiffness: most, ..law() });
    contact.begin_step(&scene.coords).expect("a step");
    for opening in [0.02, 0.05, 0.08] {
        let coords = moved(scene, [0.0, opening]);
        let points = contact.cohesive_points(&coords).expect("points");
        let expected = 2.0 * (1.0 - opening / 0.1);
        assert!(points.iter().all(|point| (point.traction[1].abs() - expected).abs() < 1e-5 * expected), "{opening}");
        contact.commit_step(&coords).expect("a step");
    }
    for stiffness in [1.01 * most, 1e50] {
        let found = refused(PairOptions::with_cohesive(Cohesive { stiffness, ..law() }), 0.0);
        assert!(found.contains("above 5e9 strength² / energy"), "{found}");
    }
}

/// An interface has its own stiffness; all else that presses or holds needs that of the law.
#[test]
fn a_stiffness_is_asked_for_where_a_pair_needs_it() {
    let scene = &in_the_plane(0.0)[0];
    let coords = moved(scene, [0.0, 0.01]);
    let pair = [Body(0), Body(1)];
    let mut contact = scene.contact(Options::new(EnergyLaw::depth(0.0)));
    assert!(matches!(contact.evaluate(&coords), Err(Error::NoStiffness)));
    contact.set_pair_options(pair, Some(PairOptions::with_cohesive(law()))).expect("an interface");
    contact.begin_step(&scene.coords).expect("a step");
    let mut other = held(scene, law());
    other.begin_step(&scene.coords).expect("a step");
    let [own, given] = [&mut contact, &mut other].map(|contact| contact.evaluate(&coords).expect("forces").forces);
    assert_eq!(own, given);
    contact.set_pair_options(pair, Some(PairOptions::tied(0.1))).expect("a tie");
    assert!(matches!(contact.evaluate(&coords), Err(Error::NoStiffness)));
    contact.set_pair_options(pair, Some(PairOptions::with_law(EnergyLaw::depth(2.0)))).expect("a law");
    contact.evaluate(&coords).expect("forces");
    contact.set_pair_options(pair, Some(PairOptions::with_cohesive(law()))).expect("an interface");
    contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, -1.0]) }).expect("an obstacle");
    assert!(matches!(contact.evaluate(&coords), Err(Error::NoStiffness)));
}
