//! Force and tangent against differences, and the balance of forces, on meshes that were moved at random.

use crate::scene::{Scene, cross, norm, size_sum, table::exactly};
use crate::{boxes, pair, shaken};
use fmc_contact::contact::TangentPart;
use fmc_contact::{Contact, EnergyLaw};
use fmc_shapes::Splitmix;

/// Disturbed blocks, each of every type on one of the next.
fn pairs(mut visit: impl FnMut(&Scene<3>, Vec<[f64; 3]>)) {
    let lower = boxes([0.0, 0.0, -1.0], [1.5, 1.2, 0.0], [3, 2, 3]);
    let upper = boxes([0.3, 0.1, -0.2], [1.3, 1.0, 0.6], [2, 2, 3]);
    for k in 0..lower.len() {
        let scene = pair(&lower[k], &upper[(k + 2) % upper.len()]);
        let coords = shaken(&scene.coords, 0.02, k as u64);
        visit(&scene, coords);
    }
}

fn moved(coords: &[[f64; 3]], direction: &[[f64; 3]], h: f64) -> Vec<[f64; 3]> {
    coords.iter().zip(direction).map(|(x, d)| std::array::from_fn(|i| x[i] + h * d[i])).collect()
}

fn balanced(contact: &Contact<3>, coords: &[[f64; 3]]) {
    let at = contact.evaluate(coords).expect("valid coordinates");
    let sizes = size_sum(&at.forces);
    let force: [f64; 3] = std::array::from_fn(|i| at.forces.iter().map(|f| f[i]).sum());
    let moment: [f64; 3] = std::array::from_fn(|i| coords.iter().zip(&at.forces).map(|(x, f)| cross(x, f)[i]).sum());
    assert!(norm(&[force]) < 1e-12 * sizes && norm(&[moment]) < 1e-12 * sizes, "{force:?} {moment:?} of {sizes}");
}

/// Central differences with a step of 1e-5, or the better of 1e-6 and 1e-7 for the tangent, which jumps in its slope where
/// a facet passes an edge within the step.
fn slopes_are_right(contact: &Contact<3>, coords: &[[f64; 3]], within: f64) {
    let at = contact.evaluate(coords).expect("valid coordinates");
    assert!(at.volume > 1e-3);
    let sizes = size_sum(&at.forces);
    let tangent = contact.tangent(coords, TangentPart::Full).expect("valid coordinates");
    let mut random = Splitmix::new(7);
    for _ in 0..3 {
        let direction: Vec<[f64; 3]> =
            coords.iter().map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect();
        let at_step = |h: f64| contact.evaluate(&moved(coords, &direction, h)).expect("valid coordinates");
        let slope = (at_step(1e-5).energy - at_step(-1e-5).energy) / 2e-5;
        let along: f64 = at.forces.iter().flatten().zip(direction.iter().flatten()).map(|(f, d)| f * d).sum();
        assert!((along + slope).abs() < 1e-6 * sizes, "{along} against {slope}");
        let product = tangent.product(&direction);
        let error = |h: f64| {
            let (plus, minus) = (at_step(h).forces, at_step(-h).forces);
            let slopes = plus.iter().flatten().zip(minus.iter().flatten()).map(|(p, m)| (m - p) / (2.0 * h));
            slopes.zip(product.iter().flatten()).map(|(s, p)| (s - p).abs()).fold(0.0, f64::max)
        };
        let largest = product.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
        let found = error(1e-6).min(error(1e-7));
        assert!(found < within * largest, "{found} of {largest}");
    }
}

#[test]
fn of_the_volume() {
    pairs(|scene, coords| {
        let contact = scene.contact(exactly(EnergyLaw::volume(3.0)));
        balanced(&contact, &coords);
        slopes_are_right(&contact, &coords, 1e-6);
    });
}

#[test]
fn of_the_depth() {
    pairs(|scene, coords| {
        let contact = scene.contact(exactly(EnergyLaw::depth(30.0)));
        balanced(&contact, &coords);
        slopes_are_right(&contact, &coords, 1e-6);
    });
}

/// With patches kept, the force on lines is the gradient of an energy too. (That of directions which do not turn: no moment
/// is balanced.) The law sees facets and no cells; on walls as rough as these its tangent is right within 1e-5, and so it is for
/// hexahedra with the same surface.
#[test]
fn of_the_fibers() {
    pairs(|scene, coords| {
        let mut contact = scene.contact(exactly(EnergyLaw::fiber(30.0)));
        contact.keep_patches(&coords).expect("valid coordinates");
        slopes_are_right(&contact, &coords, 2e-5);
    });
}
