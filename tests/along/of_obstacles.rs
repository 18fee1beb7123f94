//! By the poses of obstacles and by gap offsets.

use crate::scene::{Scene, table::exactly};
use crate::{agrees, moved, random_rows};
use fmc_contact::contact::{Directions, GradientRequest, PairGradient, PairOptions};
use fmc_contact::overlap::Partner::{Body, Obstacle as Rigid};
use fmc_contact::{EnergyLaw, Obstacle, Options, Pose, Shape};
use fmc_shapes::{Diagonals, cuboid_hex8, rectangle_tri3};

fn laws() -> [EnergyLaw; 2] {
    [EnergyLaw::depth(30.0), EnergyLaw::volume(30.0)]
}

#[test]
fn in_the_plane() {
    let scene = Scene::of(&[&rectangle_tri3([0.0, 0.0], [1.0, 0.8], [4, 3], Diagonals::Alternating)]);
    let coords = moved(&scene.coords, 0.02, &random_rows(scene.coords.len(), 5));
    let (rates, shifts, turns) =
        (random_rows(coords.len(), 1), [[0.4, -0.7], [0.2, 0.5]], [[0.0, 0.0, 0.6], [0.0, 0.0, -0.3]]);
    for law in laws() {
        let at = |by: f64| {
            let mut contact = scene.contact(exactly(law));
            let slab = Shape::Cuboid { half_extents: [0.1, 0.35] };
            let places = [(Shape::HalfSpace, [0.1, 0.11], 0.1), (slab, [0.3, 0.6], -0.4)];
            for (k, (shape, x, angle)) in places.into_iter().enumerate() {
                let position = std::array::from_fn(|i| x[i] + by * shifts[k][i]);
                let pose = Pose::at(position).turned(angle + by * turns[k][2]);
                contact.add_obstacle(Obstacle { shape, pose }).expect("a shape");
            }
            contact
        };
        let along = Directions {
            coords: Some(&rates),
            positions: Some(&shifts),
            rotations: Some(&turns),
            ..Directions::default()
        };
        agrees(&at(0.0), &coords, &along, |by| at(by).evaluate(&moved(&coords, by, &rates)).expect("forces"));
    }
}

#[test]
fn in_space() {
    let scene = Scene::of(&[&cuboid_hex8([0.0, 0.0, 0.0], [1.0, 1.0, 0.8], [2, 2, 2])]);
    let coords = moved(&scene.coords, 0.03, &random_rows(scene.coords.len(), 5));
    let (shift, turn) = ([[0.3, 0.2, -0.5]], [[0.3, -0.5, 0.2f64]]);
    for law in laws() {
        let at = |by: f64| {
            let mut contact = scene.contact(exactly(law));
            let position = std::array::from_fn(|i| [0.4, 0.5, 0.1][i] + by * shift[0][i]);
            let angle = by * turn[0].iter().map(|x| x * x).sum::<f64>().sqrt();
            let pose = Pose::at(position).turned_about([1.0, 0.0, 0.0], 0.1).turned_about(turn[0], angle);
            contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose }).expect("a shape");
            contact
        };
        let along = Directions { positions: Some(&shift), rotations: Some(&turn), ..Directions::default() };
        agrees(&at(0.0), &coords, &along, |by| at(by).evaluate(&coords).expect("forces"));
    }
}

#[test]
fn by_a_gap_offset() {
    let scene = Scene::of(&[&rectangle_tri3([0.0, 0.0], [1.0, 0.8], [4, 3], Diagonals::Alternating)]);
    let coords = moved(&scene.coords, 0.02, &random_rows(scene.coords.len(), 5));
    for law in laws() {
        let at = |by: f64| {
            let mut contact = scene.contact(exactly(law));
            let pose = Pose::at([0.1, 0.06]).turned(0.1);
            contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose }).expect("a shape");
            let options = PairOptions::with_gap_offset(0.05 + by);
            contact.set_pair_options([Body(0), Rigid(0)], Some(options)).expect("a pair");
            contact
        };
        let along = Directions { gap_offset: 1.0, ..Directions::default() };
        agrees(&at(0.0), &coords, &along, |by| at(by).evaluate(&coords).expect("forces"));
        let mut own = PairGradient::new([Body(0), Rigid(0)]);
        own.gap_offset = 2.0;
        let along = Directions { gap_offset: -1.0, pairs: &[own], ..Directions::default() };
        agrees(&at(0.0), &coords, &along, |by| at(by).evaluate(&coords).expect("forces"));
    }
}

/// Of revolution, where a plane that is tilted in the section stands for a cone. By its tilt nothing is known.
#[test]
fn of_revolution() {
    let scene = Scene::of(&[&rectangle_tri3([0.2, 0.0], [1.0, 0.8], [4, 3], Diagonals::Alternating)]);
    let coords = moved(&scene.coords, 0.02, &random_rows(scene.coords.len(), 5));
    let rates = random_rows(coords.len(), 1);
    for law in laws() {
        let at = |shift: f64| {
            let mut contact = scene.contact(Options { axisymmetric: true, ..exactly(law) });
            let pose = Pose::at([0.1, 0.06 + shift]).turned(0.1);
            contact.add_obstacle(Obstacle { shape: Shape::HalfSpace, pose }).expect("a shape");
            contact
        };
        let along = Directions { positions: Some(&[[0.0, 1.0]]), ..Directions::default() };
        agrees(&at(0.0), &coords, &along, |by| at(by).evaluate(&coords).expect("forces"));
        let along = Directions { rotations: Some(&[[0.0, 0.0, 1.0]]), ..Directions::default() };
        let error = at(0.0).jvp(&coords, &along).expect_err("no rates");
        assert!(error.to_string().contains("rotations of obstacles with axisymmetry"), "{error}");
        let request = GradientRequest { rotations: true, ..GradientRequest::default() };
        for adjoint in [None, Some(&rates[..])] {
            assert_eq!(at(0.0).vjp(&coords, 1.0, adjoint, &request).expect_err("no derivatives"), error);
        }
    }
}
