//! Nothing flows through matter: neither to the outer face of a thin body that is tied, nor to what another face hides.

use crate::scene::Scene;
use crate::thin_bodies::{below_a_shelf, below_a_shelf_in_space, plates, plates_in_space, turned};
use crate::{flux, out_of, pressed};
use fmc_contact::contact::{Conductance, PairOptions};
use fmc_contact::overlap::Partner::Body;

/// What flows between a first body of 1 degree and all others of 0.
fn flows<const D: usize>(scene: &Scene<D>, reach: Option<f64>) -> f64 {
    let mut contact = pressed(scene);
    if let Some(reach) = reach {
        contact.set_pair_options([0, 1].map(Body), Some(PairOptions::tied(reach))).expect("a tie");
    }
    // The same by pressure and across each gap up to 1.
    let h = Conductance { by_pressure: vec![[0.0, 3.0]], by_gap: vec![[0.0, 3.0], [1.0, 3.0]] };
    let field: Vec<f64> = (0..scene.coords.len()).map(|node| f64::from(u8::from(node < scene.first_node[1]))).collect();
    out_of(scene, &flux(&contact, &scene.coords, &field, &h), 0)
}

fn check<const D: usize>(scene: &Scene<D>, reach: Option<f64>) {
    let found = flows(scene, reach);
    assert!((found - 3.0).abs() < 1e-11, "{found} within {reach:?}");
}

#[test]
fn ties_conduct_once() {
    for reach in [0.15, 10.0] {
        for gap in [0.0, 0.009, -0.009] {
            check(&turned(plates(&[0.02, 0.03], gap), 0.3), Some(reach));
            check(&turned(plates_in_space(&[0.02, 0.03], gap), 0.3), Some(reach));
        }
    }
    for reach in [0.25, 10.0] {
        check(&below_a_shelf(), Some(reach));
        check(&below_a_shelf_in_space(), Some(reach));
    }
}

/// Gaps conduct to what lies next.
#[test]
fn gaps_conduct_to_what_is_seen() {
    check(&turned(plates(&[0.02, 0.03], 0.1), 0.3), None);
    check(&turned(plates_in_space(&[0.02, 0.03], 0.1), 0.3), None);
    check(&below_a_shelf(), None);
    check(&below_a_shelf_in_space(), None);
}
