//! Force and tangent against differences, and the balance of forces, with nodes moved at random: every face is curved.

use crate::scene::{Scene, cross, norm, size_sum, table::exactly};
use crate::{boxes, pair, rectangles, shaken};
use fmc_contact::contact::TangentPart;
use fmc_contact::{Contact, EnergyLaw, Options};
use fmc_shapes::Splitmix;

fn moved<const D: usize>(coords: &[[f64; D]], direction: &[[f64; D]], h: f64) -> Vec<[f64; D]> {
    coords.iter().zip(direction).map(|(x, d)| std::array::from_fn(|i| x[i] + h * d[i])).collect()
}

fn balanced<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) {
    let at = contact.evaluate(coords).expect("valid coordinates");
    let sizes = size_sum(&at.forces);
    let force: [f64; D] = std::array::from_fn(|i| at.forces.iter().map(|f| f[i]).sum());
    let moment: [f64; 3] = std::array::from_fn(|i| coords.iter().zip(&at.forces).map(|(x, f)| cross(x, f)[i]).sum());
    assert!(norm(&[force]) < 1e-12 * sizes && norm(&[moment]) < 1e-12 * sizes, "{force:?} {moment:?} of {sizes}");
    let of_body: f64 = at.bodies.iter().map(|body| norm(&[body.force])).sum();
    assert!(of_body > 1e-6 * sizes);
}

/// Central differences with a step of 1e-5, or the better of 1e-6 and 1e-7 for the tangent, which jumps in its slope where
/// a facet passes an edge within the step.
fn slopes_are_right<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]], within: f64) {
    let at = contact.evaluate(coords).expect("valid coordinates");
    assert!(at.volume > 1e-3);
    let sizes = size_sum(&at.forces);
    let tangent = contact.tangent(coords, TangentPart::Full).expect("valid coordinates");
    let mut random = Splitmix::new(7);
    for _ in 0..3 {
        let direction: Vec<[f64; D]> =
            coords.iter().map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect();
        let at_step = |h: f64| contact.evaluate(&moved(coords, &direction, h)).expect("valid coordinates");
        let slope = (at_step(1e-5).energy - at_step(-1e-5).energy) / 2e-5;
        let along: f64 = at.forces.iter().flatten().zip(direction.iter().flatten()).map(|(f, d)| f * d).sum();
        assert!((along + slope).abs() < 1e-6 * sizes, "{along} against {slope}; {:?}", contact.options().law);
        let product = tangent.product(&direction);
        let error = |h: f64| {
            let (plus, minus) = (at_step(h).forces, at_step(-h).forces);
            let slopes = plus.iter().flatten().zip(minus.iter().flatten()).map(|(p, m)| (m - p) / (2.0 * h));
            slopes.zip(product.iter().flatten()).map(|(s, p)| (s - p).abs()).fold(0.0, f64::max)
        };
        let largest = product.iter().flatten().fold(0.0f64, |m, x| m.max(x.abs()));
        let found = error(1e-6).min(error(1e-7));
        assert!(found < within * largest, "{found} of {largest}; {:?}", contact.options().law);
    }
}

fn kept<const D: usize>(scene: &Scene<D>, options: Options, coords: &[[f64; D]]) -> Contact<D> {
    let mut contact = scene.contact(options);
    contact.keep_patches(coords).expect("valid coordinates");
    contact
}

fn laws() -> [(EnergyLaw, f64); 3] {
    // The law on lines has kinks within the step at quadrilaterals, as on straight cells.
    [(EnergyLaw::volume(1.0), 1e-6), (EnergyLaw::depth(5.0), 1e-6), (EnergyLaw::fiber(5.0), 1e-5)]
}

#[test]
fn in_the_plane() {
    let lower = rectangles([0.0, -1.0], [1.5, 0.0], [3, 3]);
    let upper = rectangles([0.3, -0.2], [1.3, 0.6], [2, 3]);
    for k in 0..lower.len() {
        let scene = pair(&lower[k], &upper[(k + 1) % upper.len()]);
        let coords = shaken(&scene.coords, 0.02, k as u64);
        for (law, within) in laws() {
            let contact = kept(&scene, exactly(law), &coords);
            if !law.is_fiber() {
                balanced(&contact, &coords);
            }
            slopes_are_right(&contact, &coords, within);
        }
    }
}

#[test]
fn in_space() {
    let lower = boxes([0.0, 0.0, -1.0], [1.5, 1.2, 0.0], [2, 2, 2]);
    let upper = boxes([0.3, 0.1, -0.2], [1.3, 1.0, 0.6], [1, 2, 1]);
    for k in 0..lower.len() {
        let scene = pair(&lower[k], &upper[(k + 2) % upper.len()]);
        let coords = shaken(&scene.coords, 0.02, k as u64);
        for (law, within) in laws() {
            let contact = kept(&scene, exactly(law), &coords);
            if !law.is_fiber() {
                balanced(&contact, &coords);
            }
            slopes_are_right(&contact, &coords, within);
        }
    }
}
