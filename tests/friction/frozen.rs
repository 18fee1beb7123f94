//! Friction at a frozen pressure: a convex potential.

use crate::{begun, in_plane, in_space, laws, raised, slid};
use fmc_contact::contact::TangentPart;
use fmc_contact::{Contact, Options};
use fmc_shapes::Splitmix;

/// The tangent of friction alone, as a function.
fn product<const D: usize>(contact: &Contact<D>, smooth: &Contact<D>, coords: &[[f64; D]], x: &[[f64; D]]) -> Vec<f64> {
    part_of_product(contact, smooth, (coords, TangentPart::Full), x)
}

fn part_of_product<const D: usize>(
    contact: &Contact<D>,
    smooth: &Contact<D>,
    (coords, part): (&[[f64; D]], TangentPart),
    x: &[[f64; D]],
) -> Vec<f64> {
    let of = |contact: &Contact<D>| contact.tangent(coords, part).expect("a tangent").product(x);
    of(contact).iter().flatten().zip(of(smooth).iter().flatten()).map(|(p, q)| p - q).collect()
}

/// The upper block stood `above` when the step began.
fn is_a_potential<const D: usize>(scene: &crate::Scene<D>, options: Options, above: f64) {
    let mut contact = begun(scene, options, &raised(scene, above));
    let mut random = Splitmix::new(9);
    let mut shake = |size: f64| -> Vec<[f64; D]> {
        scene.coords.iter().map(|_| std::array::from_fn(|_| size * random.between(-1.0, 1.0))).collect()
    };
    let add = |x: &[[f64; D]], y: &[[f64; D]], h: f64| -> Vec<[f64; D]> {
        x.iter().zip(y).map(|(x, y)| std::array::from_fn(|i| x[i] + h * y[i])).collect()
    };
    // Some points stick, others slide.
    let base = slid(scene, 2.9e-4);
    let (base, at) = (add(&base, &shake(5e-5), 1.0), add(&base, &shake(5e-5), 1.0));
    contact.freeze_friction(&base).expect("a step has begun");
    let smooth = scene.contact(Options { friction: Default::default(), ..options });
    let found = contact.evaluate(&at).expect("forces");
    assert!(found.friction.stick_area > 0.05 && found.friction.slip_area > 0.05, "{:?}", found.friction);
    let energy = |x: &[[f64; D]]| {
        let friction = contact.evaluate(x).expect("forces").friction;
        friction.stored + friction.dissipated
    };
    let (p, q) = (shake(1.0), shake(1.0));
    let with = contact.evaluate(&at).expect("forces").forces;
    let without = smooth.evaluate(&at).expect("forces").forces;
    let along: f64 = (with.iter().flatten().zip(without.iter().flatten()).zip(p.iter().flatten()))
        .map(|((f, g), p)| (f - g) * p)
        .sum();
    let slope = (energy(&add(&at, &p, 1e-8)) - energy(&add(&at, &p, -1e-8))) / 2e-8;
    assert!((along + slope).abs() < 1e-6 * slope.abs(), "{along} {slope}");
    let dot = |x: &[f64], y: &[[f64; D]]| x.iter().zip(y.iter().flatten()).map(|(x, y)| x * y).sum::<f64>();
    let (kp, kq) = (product(&contact, &smooth, &at, &p), product(&contact, &smooth, &at, &q));
    let (pkq, qkp) = (dot(&kq, &p), dot(&kp, &q));
    let size = dot(&kp, &p) + dot(&kq, &q);
    assert!((pkq - qkp).abs() < 1e-12 * size, "{pkq} {qkp}");
    let rise = |h: f64| contact.evaluate(&add(&at, &p, h)).expect("forces").forces;
    let rise_without = |h: f64| smooth.evaluate(&add(&at, &p, h)).expect("forces").forces;
    let along_q = |forces: Vec<[f64; D]>| dot(&forces.concat(), &q);
    let of_friction = |h: f64| along_q(rise(h)) - along_q(rise_without(h));
    let slope = (of_friction(-1e-9) - of_friction(1e-9)) / 2e-9;
    assert!((slope - qkp).abs() < 1e-4 * size, "{slope} {qkp} of {size}");
    for _ in 0..20 {
        let x = shake(1.0);
        assert!(dot(&product(&contact, &smooth, &at, &x), &x) > -1e-12 * size);
    }
    // The quadratic energy of the semidefinite tangent is nowhere below the potential, however far away.
    let energy_here = energy(&at);
    for size in [1e-6, 1e-5, 1e-4, 1e-3] {
        for _ in 0..4 {
            let y = shake(size);
            let forward = dot(&with.concat(), &y) - dot(&without.concat(), &y);
            let ky = part_of_product(&contact, &smooth, (&at, TangentPart::Semidefinite), &y);
            let bound = energy_here - forward + 0.5 * dot(&ky, &y);
            let there = energy(&add(&at, &y, 1.0));
            assert!(there < bound + 1e-12 * (energy_here + there), "{there} above {bound} at {size}");
        }
    }
    // The pressure of the coordinates at hand, where they are those at which it was frozen.
    let frozen = contact.evaluate(&base).expect("forces");
    contact.release_friction();
    let current = contact.evaluate(&base).expect("forces");
    let largest = current.forces.iter().flatten().fold(0.0f64, |m, f| m.max(f.abs()));
    for (f, g) in frozen.forces.iter().flatten().zip(current.forces.iter().flatten()) {
        assert!((f - g).abs() < 1e-12 * largest);
    }
}

#[test]
fn convex_and_symmetric() {
    // It bore as much when the step began, more, or less, and touches more of its own within it.
    for above in [0.0, -1e-4, 5e-4] {
        for options in laws(0.3) {
            in_plane(1e-3).iter().for_each(|scene| is_a_potential(scene, options, above));
            in_space(1e-3).iter().for_each(|scene| is_a_potential(scene, options, above));
        }
    }
}
