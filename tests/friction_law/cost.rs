//! What a law of the host costs beside the library's own.

use crate::laws::coulomb;
use crate::scene::Scene;
use crate::{BODIES, DELTA, along, depth, rub, waved};
use fmc_contact::contact::{Friction, TangentPart};
use fmc_contact::{Contact, Options};
use fmc_shapes::cuboid_hex8;
use std::time::{Duration, Instant};

/// 24 by 24 facets on 20 by 20, forces, and both: the best of several, by turns. `cargo test --release --test friction_law -- --ignored --nocapture cost` prints them.
#[test]
#[ignore = "a measurement, which other programs disturb"]
fn cost_of_a_law_of_the_host() {
    let below = cuboid_hex8([0.0; 3], [1.0, 1.0, 0.5], [24, 24, 1]);
    let above = cuboid_hex8([0.0, 0.0, 0.5 - DELTA], [1.0, 1.0, 1.0], [20, 20, 1]);
    let scene = Scene::of(&[&below, &above]);
    let mut library = scene.contact(Options { friction: Friction::coulomb(0.3), ..depth() });
    let mut own = scene.contact(depth());
    rub(&mut own, BODIES, coulomb(0.3));
    let coords = waved(&along(&scene, 3.0 * DELTA), 0.1 * DELTA);
    for contact in [&mut own, &mut library] {
        contact.begin_step(&scene.coords).expect("a step");
    }
    let mut ratios = Vec::new();
    for with_tangent in [false, true] {
        let time = |contact: &Contact<3>| {
            let start = Instant::now();
            match with_tangent {
                true => drop(contact.evaluate_tangent(&coords, TangentPart::Full).expect("an evaluation")),
                false => drop(contact.evaluate(&coords).expect("an evaluation")),
            }
            start.elapsed()
        };
        let mut best = [Duration::MAX; 2];
        for _ in 0..9 {
            best = [best[0].min(time(&own)), best[1].min(time(&library))];
        }
        let ratio = best[0].as_secs_f64() / best[1].as_secs_f64();
        println!("with tangent {with_tangent}: {:?} by {:?}, {ratio:.2}", best[0], best[1]);
        ratios.push(ratio);
    }
    assert!(ratios.iter().all(|ratio| *ratio < 1.5), "{ratios:?}");
}
