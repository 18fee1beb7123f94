//! What is the same with a direction as without one.

use super::{BODIES, DELTA, DIRECTION, across, own};
use crate::scene::size_sum;
use crate::{in_space, laws, moved};
use fmc_contact::Options;
use fmc_contact::contact::{Friction, OrthotropicFriction, PairOptions, TangentPart};
use fmc_shapes::Splitmix;

#[test]
fn with_equal_coefficients_nothing_has_a_direction() {
    for options in laws(0.0) {
        for memoryless_slip in [None, Some(2e-4)] {
            let options = Options { friction: Friction { memoryless_slip, ..Friction::default() }, ..options };
            for scene in in_space(DELTA) {
                let mut plain = scene.contact(options);
                plain.set_pair_options(BODIES, Some(PairOptions::with_friction(0.3))).expect("options");
                let mut contact = scene.contact(options);
                let same = PairOptions::with_orthotropic_friction(0.3, OrthotropicFriction::new(0.3, DIRECTION));
                contact.set_pair_options(BODIES, Some(same)).expect("options");
                let mut at = scene.coords.clone();
                for contact in [&mut plain, &mut contact] {
                    contact.begin_step(&at).expect("a step");
                }
                for by in [1e-4, 3e-4, 5e-4, -2e-4] {
                    scene
                        .nodes_of(1)
                        .for_each(|node| (at[node][0], at[node][1]) = (at[node][0] + by, at[node][1] + 0.3 * by));
                    let [one, other] = [&plain, &contact].map(|contact| contact.evaluate(&at).expect("forces"));
                    let error: Vec<[f64; 3]> = one
                        .forces
                        .iter()
                        .zip(&other.forces)
                        .map(|(f, g)| std::array::from_fn(|i| f[i] - g[i]))
                        .collect();
                    assert!(size_sum(&error) < 1e-12 * size_sum(&one.forces));
                    let lost = [one, other].map(|found| found.friction.dissipated);
                    assert!((lost[0] - lost[1]).abs() < 1e-11 * (lost[0] + lost[1]) + 1e-20, "{lost:?}");
                    let [k, l] =
                        [&plain, &contact].map(|contact| contact.tangent(&at, TangentPart::Full).expect("a tangent"));
                    let (k, l) = (k.product(&at), l.product(&at));
                    let error: Vec<[f64; 3]> =
                        k.iter().zip(&l).map(|(f, g)| std::array::from_fn(|i| f[i] - g[i])).collect();
                    assert!(size_sum(&error) < 1e-11 * size_sum(&k), "{} {}", size_sum(&error), size_sum(&k));
                    for contact in [&mut plain, &mut contact] {
                        contact.commit_step(&at).expect("a step");
                    }
                }
            }
        }
    }
}

/// Blocks of tetrahedra and hexahedra that slide at an angle: what the tangent leaves out is of the size of penetration by facet, as without
/// a direction. Frozen, it is the derivative of the forces, and symmetric.
#[test]
fn the_tangent_is_the_derivative() {
    let delta = 1e-4;
    for scene in in_space(delta) {
        let options = laws(0.0)[0];
        let mut contact = scene.contact(options);
        contact.set_pair_options(BODIES, own(across(DIRECTION))).expect("options");
        contact.begin_step(&scene.coords).expect("a step");
        let mut random = Splitmix::new(5);
        let mut at = moved(&scene, 1, |x| [x[0] + 0.8 * delta, x[1] + 0.3 * delta, x[2]]);
        at.iter_mut().flatten().for_each(|x| *x += 0.02 * delta * random.between(-1.0, 1.0));
        let shake: Vec<[f64; 3]> = at.iter().map(|_| std::array::from_fn(|_| random.between(-1.0, 1.0))).collect();
        for (is_frozen, tolerance) in [(false, 4.0 * 0.5 * delta / 0.3), (true, 1e-6)] {
            if is_frozen {
                contact.freeze_friction(&at).expect("a step has begun");
            }
            let smooth = scene.contact(options);
            let friction_at = |h: f64| -> Vec<f64> {
                let at: Vec<[f64; 3]> =
                    at.iter().zip(&shake).map(|(x, d)| std::array::from_fn(|i| x[i] + h * d[i])).collect();
                let [with, without] = [&contact, &smooth].map(|contact| contact.evaluate(&at).expect("forces").forces);
                with.into_iter().flatten().zip(without.into_iter().flatten()).map(|(f, g)| f - g).collect()
            };
            let [with, without] = [&contact, &smooth]
                .map(|contact| contact.tangent(&at, TangentPart::Full).expect("a tangent").product(&shake));
            let step = 1e-4 * delta;
            let (plus, minus) = (friction_at(step), friction_at(-step));
            let products = with.iter().flatten().zip(without.iter().flatten()).map(|(p, q)| p - q);
            let (mut error, mut largest) = (0.0f64, 0.0f64);
            for (product, (p, m)) in products.zip(plus.iter().zip(&minus)) {
                error = error.max(((m - p) / (2.0 * step) - product).abs());
                largest = largest.max(product.abs());
            }
            println!("frozen {is_frozen}: {:e}", error / largest);
            assert!(error < tolerance * largest, "frozen {is_frozen}: {error} of {largest}");
        }
    }
}

#[test]
fn a_step_is_restarted_and_threads_change_nothing() {
    let scene = &in_space(DELTA)[0];
    let new = |threads| {
        let mut contact = scene.contact(Options { threads, ..laws(0.0)[0] });
        contact.set_pair_options(BODIES, own(across(DIRECTION))).expect("options");
        contact
    };
    let at = |by: f64| moved(scene, 1, |x| [x[0] + by, x[1] + 0.7 * by, x[2]]);
    let mut contact = new(1);
    contact.begin_step(&scene.coords).expect("a step");
    contact.commit_step(&at(4e-4)).expect("a step");
    let expected = contact.evaluate(&at(5e-4)).expect("forces");
    let mut again = new(4);
    again.begin_step(&at(4e-4)).expect("a step");
    again.set_slip(&contact.slip().expect("slip")).expect("slip");
    assert_eq!(again.evaluate(&at(5e-4)).expect("forces"), expected);
}
