//! What is told, and what is refused.

use super::{BODIES, DELTA, DIRECTION, MU, ON_FLOOR, across, level, on_floor, own, slid_to_rest};
use crate::scene::{Scene, norm};
use crate::{begun, in_plane, in_space, laws, slid};
use fmc_contact::contact::{Cohesive, Friction, GradientRequest, OrthotropicFriction, PairOptions, StaticFriction};
use fmc_contact::overlap::{Partner, Warning};
use fmc_contact::{Error, Obstacle, Options, Pose, Shape};

#[test]
fn faces_across_the_direction_are_told() {
    // The floor's normal is the direction: all slip is across it.
    let (scene, contact) = on_floor(laws(0.0)[0], own(across([0.0, 0.0, 2.0])));
    let mut contact = contact;
    let way = [0.6, -0.8, 0.0];
    let at = slid_to_rest(&mut contact, &scene.coords, way, 4);
    for point in level(contact.contact_points(&at).expect("points")) {
        let error: [f64; 3] = std::array::from_fn(|i| point.friction[i] / point.pressure + MU[1] * way[i]);
        assert!(norm(&[error]) < 1e-12, "{:?}", point.friction);
    }
    let warnings = contact.evaluate(&at).expect("forces").warnings;
    let [Warning::NoFrictionDirection { a, b, facet, part }] = warnings[..] else { panic!("{warnings:?}") };
    let place = contact.boundary_facets()[facet].clone();
    assert!([a, b] == ON_FLOOR && part > 0.99 && part <= 1.0, "{part} {place:?}");
    assert!(warnings[0].clone().counted_from(1).to_string().contains(&format!("facet {} the most", facet + 1)));
    // Walls that are sunk in beside the contact are not: they bear little.
    let (scene, mut contact) = on_floor(laws(0.0)[0], own(across([1.0, 0.0, 0.0])));
    let at = slid_to_rest(&mut contact, &scene.coords, way, 2);
    assert_eq!(contact.evaluate(&at).expect("forces").warnings, []);
}

#[test]
fn what_has_no_meaning_is_refused() {
    let scene = &in_space(DELTA)[0];
    let mut contact = scene.contact(laws(0.0)[0]);
    let with = |friction| own(friction);
    let cause = |found: Result<(), Error>| match found {
        Err(Error::OfPair { cause, .. }) => *cause,
        other => panic!("{other:?}"),
    };
    for value in [-0.1, f64::NAN, f64::INFINITY] {
        let found = cause(contact.set_pair_options(BODIES, with(OrthotropicFriction::new(value, DIRECTION))));
        assert!(matches!(found, Error::NotPositive { name: "transverse_coefficient", .. }), "{found:?}");
    }
    for (entry, value) in [(0, f64::NAN), (1, f64::INFINITY), (2, f64::NEG_INFINITY)] {
        let mut direction = DIRECTION;
        direction[entry] = value;
        let found = cause(contact.set_pair_options(BODIES, with(across(direction))));
        assert!(matches!(found, Error::BadEntry { array: "direction", entry: at, .. } if at == entry), "{found:?}");
    }
    let found = cause(contact.set_pair_options(BODIES, with(across([0.0; 3]))));
    assert!(matches!(found, Error::NotPositive { name: "length of direction", value: 0.0 }), "{found:?}");
    let unsupported = |found: Error, text: &str| {
        assert!(matches!(&found, Error::Unsupported { what } if what.contains(text)), "{found:?}");
    };
    let own_body = [Partner::Body(0); 2];
    unsupported(cause(contact.set_pair_options(own_body, with(across(DIRECTION)))), "a body with itself");
    let rough = PairOptions { orthotropic: Some(across(DIRECTION)), ..PairOptions::rough() };
    unsupported(cause(contact.set_pair_options(BODIES, Some(rough))), "rough pair");
    let glued = PairOptions {
        orthotropic: Some(across(DIRECTION)),
        friction_coefficient: Some(MU[0]),
        ..PairOptions::with_cohesive(Cohesive::new(2.0, 0.25))
    };
    unsupported(cause(contact.set_pair_options(BODIES, Some(glued))), "cohesive interface");
    let endless = PairOptions::with_orthotropic_friction(f64::INFINITY, across(DIRECTION));
    unsupported(cause(contact.set_pair_options(BODIES, Some(endless))), "infinite coefficient");
    let at_rest = Some(StaticFriction { coefficient: 0.5, weakening_slip: 0.1 });
    let none =
        PairOptions { static_friction: at_rest, ..PairOptions::with_orthotropic_friction(0.0, across(DIRECTION)) };
    unsupported(cause(contact.set_pair_options(BODIES, Some(none))), "static_coefficient");
    // What the options of the contact have later is refused there.
    contact.set_pair_options(BODIES, with(across(DIRECTION))).expect("options");
    let friction = Friction { cohesion: 0.1, ..Friction::default() };
    let found = cause(contact.set_options(Options { friction, ..laws(0.0)[0] }));
    unsupported(found, "cohesion or a shear limit");
    assert_eq!(contact.pair_options(BODIES).expect("a pair"), with(across(DIRECTION)));
    // In the plane there is one direction to slide; a surface has no coordinates without deformation.
    let mut plane = in_plane(DELTA)[0].contact(laws(0.0)[0]);
    unsupported(cause(plane.set_pair_options(BODIES, with(across(DIRECTION)))), "2D");
    let shell = fmc_shapes::cuboid_surface([-0.5, -0.4, -DELTA], [0.5, 0.4, 0.7], [1, 1, 1]);
    let mut shell = Scene::of(&[&shell]).contact(laws(0.0)[1]);
    shell.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0; 3]) }).expect("a plane");
    let found = shell.set_pair_options(ON_FLOOR, with(across(DIRECTION))).unwrap_err();
    unsupported(found, "a body without cells");
    let of_floor = OrthotropicFriction { of_second: true, ..across(DIRECTION) };
    shell.set_pair_options(ON_FLOOR, with(of_floor)).expect("the floor has its frame");
    // The derivative by the coefficient is that by both, in no proportion that is known.
    contact.begin_step(&scene.coords).expect("a step");
    let at = slid(scene, 1e-3);
    let request = GradientRequest { friction: true, ..GradientRequest::default() };
    let adjoint = vec![[1.0; 3]; at.len()];
    let found = contact.vjp(&at, 0.0, Some(&adjoint), &request).expect_err("no derivative");
    assert!(found.to_string().contains("friction along a direction"), "{found}");
    assert!(begun(scene, laws(0.3)[0], &scene.coords).vjp(&at, 0.0, Some(&adjoint), &request).is_ok());
}
