//! What is no axisymmetry is refused by name.

use crate::depth;
use crate::scene::Scene;
use fmc_contact::{Contact, EnergyLaw, Error, Estimator, FiberOptions, FiberPattern, Options};
use fmc_shapes::{Diagonals, cuboid_hex8, rectangle_tri3};

#[test]
fn nodes_beyond_the_axis() {
    let mesh = rectangle_tri3([0.0, 0.0], [1.0, 1.0], [2, 2], Diagonals::Same);
    let contact = Scene::of(&[&mesh]).contact(depth(1.0));
    let mut coords = mesh.coords.clone();
    let on_axis = coords.iter().position(|x| x[0] == 0.0).unwrap();
    coords[on_axis][0] = -1e-15;
    assert!(contact.evaluate(&coords).is_ok());
    coords[on_axis][0] = -1e-3;
    assert_eq!(contact.evaluate(&coords).unwrap_err(), Error::NegativeRadius { node: on_axis, radius: -1e-3 });
    let mut options = depth(1.0);
    options.axisymmetric = false;
    assert!(Scene::of(&[&mesh]).contact(options).evaluate(&coords).is_ok());
}

#[test]
fn space_and_isotropic_fibers() {
    let is_refused =
        |result: Result<(), Error>| assert!(matches!(result, Err(Error::Unsupported { .. })), "{result:?}");
    let cube = Scene::of(&[&cuboid_hex8([0.0; 3], [1.0; 3], [1; 3])]);
    is_refused(Contact::new(cube.surface(), depth(1.0)).map(drop));
    let square = Scene::of(&[&rectangle_tri3([0.0, 0.0], [1.0, 1.0], [1, 1], Diagonals::Same)]);
    let pattern = FiberPattern::Isotropic { length: None };
    let estimator = Estimator::Fibers(FiberOptions { pattern, ..FiberOptions::default() });
    is_refused(
        Contact::new(square.surface(), Options { estimator, law: EnergyLaw::volume(1.0), ..depth(1.0) }).map(drop),
    );
}
