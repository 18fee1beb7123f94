//! Bodies against each other and themselves: by coordinates and by the stiffness of pairs.

use crate::scene::{Scene, table::exactly};
use crate::{agrees, is_transpose, moved, random_rows};
use fmc_contact::contact::{Directions, PairGradient, PairOptions};
use fmc_contact::overlap::Partner::Body;
use fmc_contact::{Contact, EnergyLaw, Options};
use fmc_shapes::{Diagonals, Mesh, cuboid_hex8, cuboid_tet4, rectangle_quad4, rectangle_tri3, second_order};

fn laws() -> [EnergyLaw; 2] {
    [EnergyLaw::depth(30.0), EnergyLaw::Volume { stiffness: 30.0, exponent: 2.0 }]
}

/// Two blocks in each other, every node disturbed.
fn pressed<const D: usize>(lower: &Mesh<D>, upper: &Mesh<D>) -> (Scene<D>, Vec<[f64; D]>) {
    let scene = Scene::of(&[lower, upper]);
    let coords = moved(&scene.coords, 0.02, &random_rows(scene.coords.len(), 5));
    (scene, coords)
}

fn by_coordinates<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) {
    let rates = random_rows(coords.len(), 7);
    let along = Directions { coords: Some(&rates), ..Directions::default() };
    agrees(contact, coords, &along, |by| contact.evaluate(&moved(coords, by, &rates)).expect("forces"));
}

#[test]
fn in_the_plane() {
    let lower = rectangle_tri3([0.0, -1.0], [1.5, 0.0], [5, 3], Diagonals::Alternating);
    let upper = rectangle_quad4([0.3, -0.2], [1.3, 0.6], [3, 2]);
    let (scene, coords) = pressed(&lower, &upper);
    for law in laws() {
        by_coordinates(&scene.contact(exactly(law)), &coords);
        let (scene, coords) = pressed(&second_order(&lower, 6), &second_order(&upper, 8));
        by_coordinates(&scene.contact(exactly(law)), &coords);
    }
}

#[test]
fn in_space() {
    let lower = cuboid_tet4([0.0, 0.0, -1.0], [1.5, 1.2, 0.0], [3, 2, 2]);
    let upper = cuboid_hex8([0.3, 0.1, -0.2], [1.3, 1.0, 0.6], [2, 2, 1]);
    let (scene, coords) = pressed(&lower, &upper);
    for law in laws() {
        by_coordinates(&scene.contact(exactly(law)), &coords);
    }
    let (scene, coords) = pressed(&second_order(&lower, 10), &second_order(&upper, 20));
    by_coordinates(&scene.contact(exactly(laws()[1])), &coords);
}

#[test]
fn of_revolution() {
    let lower = rectangle_tri3([0.2, -1.0], [1.6, 0.0], [5, 3], Diagonals::Alternating);
    let (scene, coords) = pressed(&lower, &rectangle_quad4([0.4, -0.2], [1.3, 0.6], [3, 2]));
    for law in laws() {
        by_coordinates(&scene.contact(Options { axisymmetric: true, ..exactly(law) }), &coords);
    }
}

/// Two blocks that are one body, whose depths are found while they are apart.
#[test]
fn of_a_body_with_itself() {
    let lower = rectangle_tri3([0.0, -1.0], [1.5, 0.0], [5, 3], Diagonals::Alternating);
    let upper = rectangle_quad4([0.3, -0.2], [1.3, 0.6], [3, 2]);
    let (_, coords) = pressed(&lower, &upper);
    let apart = Scene::new().with(&lower, 0).with(&upper.mapped(|x| x.map(|x| x + 5.0)), 0);
    by_coordinates(&apart.contact(Options { self_contact: true, ..exactly(laws()[0]) }), &coords);
}

#[test]
fn with_kept_patches() {
    let lower = rectangle_tri3([0.0, -1.0], [1.5, 0.0], [5, 3], Diagonals::Alternating);
    let (scene, coords) = pressed(&lower, &rectangle_tri3([0.3, -0.2], [1.3, 0.6], [3, 2], Diagonals::Same));
    let mut contact = scene.contact(exactly(EnergyLaw::fiber(30.0)));
    contact.keep_patches(&coords).expect("patches");
    by_coordinates(&contact, &coords);
}

/// Three blocks in a row: two pairs, of which one has a law of its own.
#[test]
fn by_the_stiffness_of_all_pairs_and_of_one() {
    let block = |low: f64| rectangle_quad4([0.0, low], [1.0, low + 1.0], [3, 3]);
    let scene = Scene::of(&[&block(0.0), &block(0.9), &block(1.8)]);
    let coords = moved(&scene.coords, 0.02, &random_rows(scene.coords.len(), 5));
    for law in laws() {
        let with = |[of_all, of_own]: [f64; 2]| {
            let stiff = |k: f64| match law {
                EnergyLaw::Volume { exponent, .. } => EnergyLaw::Volume { stiffness: k, exponent },
                _ => EnergyLaw::depth(k),
            };
            let mut contact = scene.contact(exactly(stiff(of_all)));
            let own = PairOptions { law: Some(stiff(of_own)), ..PairOptions::default() };
            contact.set_pair_options([1, 2].map(Body), Some(own)).expect("a pair");
            contact
        };
        let contact = with([30.0, 50.0]);
        let mut own = PairGradient::new([1, 2].map(Body));
        own.stiffness = -0.4;
        // A pair that does not touch.
        let mut apart = PairGradient::new([0, 2].map(Body));
        apart.stiffness = 9.0;
        let along = Directions { stiffness: 2.0, pairs: &[own, apart], ..Directions::default() };
        agrees(&contact, &coords, &along, |by| {
            with([30.0 + 2.0 * by, 50.0 + 1.6 * by]).evaluate(&coords).expect("forces")
        });
        let rates = random_rows(coords.len(), 3);
        is_transpose(&contact, &coords, &Directions { coords: Some(&rates), ..along });
    }
}
