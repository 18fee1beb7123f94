//! What is not known is refused by name, as `vjp` refuses it; rates that are none are named with their place.

use crate::random_rows;
use crate::scene::{Scene, table::exactly};
use fmc_contact::contact::{Directions, Friction, GradientRequest, PairGradient, PairOptions};
use fmc_contact::overlap::Partner::{self, Body, Obstacle as Rigid};
use fmc_contact::{Contact, EnergyLaw, Error, Obstacle, Options, Pose, Shape};
use fmc_shapes::{Mesh, rectangle_quad4};

fn pressed(options: Options) -> (Contact<2>, Vec<[f64; 2]>) {
    let block = |low: f64| -> Mesh<2> { rectangle_quad4([0.0, low], [1.0, low + 1.0], [3, 3]) };
    let scene = Scene::of(&[&block(0.0), &block(0.9)]);
    let mut contact = scene.contact(options);
    let pose = Pose::at([0.0, 0.02]);
    contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose }).expect("a plane");
    contact.begin_step(&scene.coords).expect("coordinates");
    (contact, scene.coords)
}

fn depth(coefficient: f64) -> Options {
    Options { friction: Friction::coulomb(coefficient), ..exactly(EnergyLaw::depth(30.0)) }
}

#[test]
fn what_vjp_refuses_by_the_same_name() {
    let rates = random_rows(32, 1);
    let coords = Directions { coords: Some(&rates), ..Directions::default() };
    let [all, friction, gap_offset] =
        [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(|[stiffness, friction, gap_offset]| Directions {
            stiffness,
            friction,
            gap_offset,
            ..Directions::default()
        });
    let nothing = GradientRequest::default();
    let static_friction = Friction { cohesion: 0.1, ..Friction::coulomb(0.3) };
    let cohesion = Options { friction: static_friction, ..depth(0.0) };
    let of_coords = GradientRequest { coords: true, ..nothing };
    for (options, along, request) in [
        (depth(0.3), coords, of_coords),
        (exactly(EnergyLaw::fiber(30.0)), coords, of_coords),
        (cohesion, all, GradientRequest { stiffness: true, ..nothing }),
        (cohesion, friction, GradientRequest { friction: true, ..nothing }),
        (depth(0.0), friction, GradientRequest { friction: true, ..nothing }),
        (depth(0.0), gap_offset, GradientRequest { gap_offsets: true, ..nothing }),
    ] {
        let (contact, at) = pressed(options);
        let here = contact.jvp(&at, &along).expect_err("no rates");
        assert!(matches!(here, Error::Unsupported { .. }));
        assert_eq!(contact.vjp(&at, 1.0, Some(&rates), &request).expect_err("no derivatives"), here);
    }
    // An offset of the pair of one body with the plane is known beside that of the two bodies.
    let (mut contact, at) = pressed(depth(0.0));
    contact.set_pair_options([Body(0), Rigid(0)], Some(PairOptions::with_gap_offset(0.01))).expect("a pair");
    let mut own = PairGradient::new([Body(0), Rigid(0)]);
    own.gap_offset = 1.0;
    assert!(contact.jvp(&at, &Directions { pairs: &[own], ..Directions::default() }).is_ok());
}

#[test]
fn rates_that_are_none() {
    let (contact, at) = pressed(depth(0.3));
    let error = |along: Directions<2>| contact.jvp(&at, &along).expect_err("wrong rates");
    let short = random_rows(31, 1);
    let length = error(Directions { coords: Some(&short), ..Directions::default() });
    assert_eq!(length, Error::Length { array: "rates of coordinates", expected: 32, found: 31 });
    let positions = error(Directions { positions: Some(&[[0.0, f64::NAN]]), ..Directions::default() });
    assert_eq!(positions, Error::NonFiniteStiffness { array: "rates of positions", entry: 1 });
    let rotations = error(Directions { rotations: Some(&[[0.0; 3]; 2]), ..Directions::default() });
    assert_eq!(rotations, Error::Length { array: "rates of rotations", expected: 1, found: 2 });
    let of_all = error(Directions { gap_offset: f64::INFINITY, ..Directions::default() });
    assert!(matches!(of_all, Error::NonFiniteStiffness { entry: 1, .. }));
    let of_pair = |partners: [Partner; 2], stiffness: f64| {
        let mut pair = PairGradient::new(partners);
        pair.stiffness = stiffness;
        error(Directions { pairs: &[PairGradient::new([Body(0), Body(1)]), pair], ..Directions::default() })
    };
    assert!(matches!(of_pair([Body(0), Body(2)], 1.0), Error::NoSuchRow { list: "pairs", row: 1, .. }));
    assert!(matches!(of_pair([Body(1), Body(0)], 1.0), Error::NoSuchRow { row: 1, .. }));
    assert!(matches!(of_pair([Rigid(0), Rigid(0)], 1.0), Error::NoSuchRow { row: 1, .. }));
    assert!(matches!(of_pair([Body(0), Body(1)], f64::NAN), Error::NonFiniteStiffness { entry: 3, .. }));
    let nothing = contact.jvp(&at, &Directions::default()).expect("rates");
    assert!(nothing.energy == 0.0 && nothing.forces == vec![[0.0; 2]; 32]);
}
