//! Interfaces that are made, refused, released and found again.

use crate::scene::Scene;
use crate::{held, in_the_plane, law, moved};
use fmc_contact::contact::{Cohesive, GradientRequest, PairOptions, StaticFriction};
use fmc_contact::overlap::Partner::{Body, Obstacle as Rigid};
use fmc_contact::{EnergyLaw, Error, Obstacle, Options, Pose, Shape};
use fmc_shapes::rectangle_quad4;

#[test]
fn what_is_no_interface_is_refused_and_changes_nothing() {
    let scene = &in_the_plane(0.2)[0];
    let mut contact = scene.contact(Options::new(EnergyLaw::depth(1.0)));
    contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, 0.0]) }).expect("an obstacle");
    let mut refused = |partners, options| contact.set_pair_options(partners, Some(options)).expect_err("no interface");
    let apart = refused([Body(0), Body(1)], PairOptions::with_cohesive(Cohesive { reach: 0.1, ..law() }));
    let Error::Untied { bodies: [0, 1], distances: [reach, nearest], .. } = apart else { panic!("{apart}") };
    assert!(reach == 0.1 && (nearest - 0.2).abs() < 1e-12, "{apart}");
    // What would have no effect.
    let wide = PairOptions::with_cohesive(Cohesive { reach: 0.3, ..law() });
    for options in [
        PairOptions { excluded: true, ..wide },
        PairOptions { static_friction: Some(StaticFriction { coefficient: 0.5, weakening_slip: 0.1 }), ..wide },
    ] {
        assert!(matches!(refused([Body(0), Body(1)], options), Error::OfPair { .. }));
    }
    let wide = Cohesive { reach: 0.3, ..law() };
    for cohesive in [
        Cohesive { normal_strength: 0.0, ..wide },
        Cohesive { shear_strength: -1.0, ..wide },
        Cohesive { normal_energy: f64::NAN, ..wide },
        Cohesive { shear_energy: f64::INFINITY, ..wide },
        Cohesive { exponent: 0.5, ..wide },
        Cohesive { stiffness: -1.0, ..wide },
        // It would break where damage begins.
        Cohesive { stiffness: 20.0, ..wide },
        Cohesive { reach: -0.3, ..wide },
    ] {
        let found = refused([Body(0), Body(1)], PairOptions::with_cohesive(cohesive));
        assert!(matches!(found, Error::OfPair { .. }), "{cohesive:?}");
    }
    let whole = PairOptions::with_cohesive(wide);
    for (partners, options) in [
        ([Body(0), Rigid(0)], whole),
        ([Body(0), Body(0)], whole),
        ([Body(0), Body(1)], PairOptions { gap_offset: -0.1, ..whole }),
        ([Body(0), Body(1)], PairOptions { law: Some(EnergyLaw::depth(1.0)), ..whole }),
    ] {
        assert!(matches!(refused(partners, options), Error::OfPair { .. }));
    }
    assert_eq!(contact.cohesive([0, 1], &scene.coords), Ok(None));
    assert_eq!(contact.pair_options([Body(0), Body(1)]), Ok(None));
    assert!(contact.cohesive_points(&scene.coords).expect("none").is_empty());
}

/// It takes the place of the contact and of a tie, and they its; all other pairs are as without it, to the bit.
#[test]
fn an_interface_takes_the_place_of_the_contact() {
    let below = rectangle_quad4([0.0, 0.0], [1.0, 0.5], [2, 1]);
    let above = rectangle_quad4([0.0, 0.49], [1.0, 1.0], [3, 1]);
    let third = rectangle_quad4([0.2, 0.98], [0.8, 1.4], [2, 1]);
    let scene = Scene::of(&[&below, &above, &third]);
    // By any law: the interface has its own.
    let mut contact = scene.contact(Options::new(EnergyLaw::volume(1.0)));
    let before = contact.evaluate(&scene.coords).expect("an evaluation");
    let pair = [Body(0), Body(1)];
    contact.set_pair_options(pair, Some(PairOptions::with_cohesive(law()))).expect("an interface");
    let found = contact.evaluate(&scene.coords).expect("an evaluation");
    assert_eq!(found.pairs.len(), 2);
    assert!(found.pairs[0].energy < 1e-24 && found.pairs[1] == before.pairs[1]);
    contact.set_pair_options(pair, None).expect("options");
    assert_eq!(contact.evaluate(&scene.coords).expect("an evaluation"), before);
    contact.set_options(Options::new(EnergyLaw::depth(1.0))).expect("options");
    contact.set_pair_options(pair, Some(PairOptions::tied(0.0))).expect("a tie");
    contact.set_pair_options(pair, Some(PairOptions::with_cohesive(law()))).expect("an interface");
    assert_eq!(contact.tie([0, 1]), Ok(None));
    contact.set_pair_options(pair, Some(PairOptions::tied(0.0))).expect("a tie");
    assert!(contact.damage().expect("none").is_empty() && contact.tie([0, 1]).expect("bodies").is_some());
    contact.set_pair_options(pair, Some(PairOptions::excluded())).expect("options");
    assert_eq!(contact.evaluate(&scene.coords).expect("an evaluation").pairs.len(), 1);
}

/// The same options leave the damage, and so does another mesh without deformation, even after one on which there was no interface;
/// other options begin with a whole one.
#[test]
fn other_options_alone_make_an_interface_whole() {
    let scene = &in_the_plane(0.0)[0];
    let mut contact = held(scene, law());
    let pulled = moved(scene, [0.0, 0.05]);
    let is_whole =
        |contact: &fmc_contact::Contact<2>| contact.damage().expect("points").iter().all(|x| x.damage == 0.0);
    contact.begin_step(&scene.coords).expect("a step");
    contact.commit_step(&pulled).expect("a step");
    let same = PairOptions::with_cohesive(law());
    contact.set_pair_options([0, 1].map(Body), Some(same)).expect("options");
    assert!(!is_whole(&contact));
    let other = PairOptions::with_cohesive(Cohesive { exponent: 1.5, ..law() });
    contact.set_pair_options([0, 1].map(Body), Some(other)).expect("options");
    assert!(is_whole(&contact));
    contact.commit_step(&pulled).expect("a step");
    let damaged = contact.damage().expect("points");
    assert!(!is_whole(&contact));
    contact.set_reference(&scene.coords).expect("a reference");
    assert_eq!(contact.damage().expect("points"), damaged);
    let lifted: Vec<_> = scene.coords.iter().map(|x| [x[0], 1.5 * x[1]]).collect();
    contact.set_reference(&lifted).expect("a reference");
    assert_eq!(contact.damage().expect("points"), damaged);
    let forces = contact.evaluate(&lifted).expect("an evaluation").forces;
    assert!(forces.iter().flatten().all(|force| force.abs() < 1e-12));
    let mut torn = scene.coords.clone();
    torn[scene.first_node[1]..].iter_mut().for_each(|x| x[1] += 0.2);
    contact.set_reference(&torn).expect("a reference");
    assert!(matches!(contact.evaluate(&torn), Err(Error::Untied { .. })));
    assert!(matches!(contact.damage(), Err(Error::Untied { .. })));
    contact.set_reference(&scene.coords).expect("a reference");
    assert_eq!(contact.damage().expect("points"), damaged);
}

#[test]
fn what_does_not_know_of_it_is_refused() {
    let scene = &in_the_plane(0.0)[0];
    let contact = held(scene, law());
    let request = GradientRequest { coords: true, ..GradientRequest::default() };
    assert!(matches!(contact.vjp(&scene.coords, 1.0, None, &request), Err(Error::Unsupported { .. })));
}
