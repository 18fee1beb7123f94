//! What is refused, with the name of the array and the place in it.

use crate::{in_the_plane, pressed};
use fmc_contact::contact::{Conductance, FluxRequest};
use fmc_contact::{EnergyLaw, Error, Options};

#[test]
fn bad_input_is_named_with_its_place() {
    let scene = &in_the_plane(-0.01)[0];
    let contact = pressed(scene);
    let count = scene.coords.len();
    let good = vec![1.0; count];
    let entry = |array, entry, value| Err(Error::BadEntry { array, entry, value });
    let with = |h: &Conductance| {
        contact.flux(&scene.coords, &FluxRequest { fields: &good, of_obstacles: None, conductance: h })
    };
    let table = |by_pressure: &[[f64; 2]], by_gap: &[[f64; 2]]| Conductance {
        by_pressure: by_pressure.to_vec(),
        by_gap: by_gap.to_vec(),
    };
    assert_eq!(with(&table(&[[0.0, 1.0], [1.0, -2.0]], &[])), entry("by_pressure", 1, -2.0));
    assert_eq!(with(&table(&[[0.0, 1.0], [0.0, 2.0]], &[])), entry("pressures", 1, 0.0));
    assert_eq!(with(&table(&[[-1.0, 1.0]], &[])), entry("pressures", 0, -1.0));
    assert_eq!(with(&table(&[], &[[0.0, 1.0], [0.2, 1.0], [0.1, 1.0]])), entry("gaps", 2, 0.1));
    assert_eq!(with(&table(&[], &[[0.0, f64::INFINITY]])), entry("by_gap", 0, f64::INFINITY));
    let h = Conductance::constant(1.0);
    let of = |fields: &[f64], of_obstacles| {
        contact.flux(&scene.coords, &FluxRequest { fields, of_obstacles, conductance: &h })
    };
    let mut hot = good.clone();
    hot[5] = f64::INFINITY;
    assert_eq!(of(&hot, None), entry("fields", 5, f64::INFINITY));
    assert_eq!(of(&hot, None).expect_err("no flux").to_string(), "entry 5 of 'fields' is inf, which is not allowed");
    let expected = Error::Length { array: "fields", expected: count, found: count + 1 };
    assert_eq!(of(&[&good[..], &[1.0]].concat(), None), Err(expected));
    assert_eq!(of(&good, Some(&[1.0])), Err(Error::Length { array: "of_obstacles", expected: 0, found: 1 }));
    assert!(of(&[], None).expect("no field").flux.is_empty());
    let none = scene.contact(Options::new(EnergyLaw::depth(0.0)));
    let request = FluxRequest { fields: &good, of_obstacles: None, conductance: &h };
    assert_eq!(none.flux(&scene.coords, &request), Err(Error::NoStiffness));
    assert!(matches!(contact.flux(&scene.coords[1..], &request), Err(Error::Length { .. })));
}
