//! What a law of the host costs beside the library's own.

use crate::scene::Scene;
use crate::{held, waved};
use fmc_contact::contact::{Cohesive, InterfaceLaw, LawFailure, LawPoints, LawResponse, PairOptions, TangentPart};
use fmc_contact::overlap::Partner::Body;
use fmc_contact::{Contact, EnergyLaw, Options};
use fmc_shapes::cuboid_hex8;
use std::time::{Duration, Instant};

/// The bilinear law of `laws::bilinear` in space, written into the arrays at once.
struct Swift;

impl InterfaceLaw for Swift {
    fn history_count(&self) -> usize {
        2
    }

    fn respond(&self, points: &LawPoints<'_>, response: &mut LawResponse<'_>) -> Result<(), LawFailure> {
        let (m, k_n, energy) = (100.0, 2000.0, [0.1, 0.4]);
        let k_t = k_n * 0.25 * 2.25;
        for point in 0..points.count {
            let jump: [f64; 3] = std::array::from_fn(|axis| points.jumps[3 * point + axis]);
            let before = points.history[2 * point];
            let open = jump[0].max(0.0);
            let full = [k_n * open, k_t * jump[1], k_t * jump[2]];
            let y_t = 0.5 * (full[1] * jump[1] + full[2] * jump[2]);
            let y = 0.5 * full[0] * open + y_t;
            let (mut damage, mut growth) = (before, [0.0; 3]);
            if y > 0.0 && before < 1.0 {
                let b = y_t / y;
                let g = energy[0] + (energy[1] - energy[0]) * b * b;
                let q = (y * m / g).sqrt();
                let wanted = if q <= 1.0 { 0.0 } else { (m * (q - 1.0) / (q * (m - 1.0))).min(1.0) };
                if wanted > before {
                    damage = wanted;
                    let reached = m / (m - before * (m - 1.0));
                    response.history[2 * point + 1] += g / m * (m * (q.min(m) - reached) / (m - 1.0));
                    let slope = if q >= m { 0.0 } else { m / ((m - 1.0) * q) };
                    for axis in 0..3 {
                        let own = if axis == 0 { 0.0 } else { full[axis] };
                        let by_part = (energy[1] - energy[0]) * 2.0 * b * (own - b * full[axis]) / y;
                        growth[axis] = slope * (full[axis] / (2.0 * y) - by_part / (2.0 * g));
                    }
                }
            }
            response.history[2 * point] = damage;
            let (left, pressed) = (1.0 - damage, jump[0].min(0.0));
            let own = [if jump[0] > 0.0 { left * k_n } else { k_n }, left * k_t, left * k_t];
            for i in 0..3 {
                response.tractions[3 * point + i] = left * full[i] + if i == 0 { k_n * pressed } else { 0.0 };
                for j in 0..3 {
                    let plain = if i == j { own[i] } else { 0.0 };
                    response.tangents[9 * point + 3 * i + j] = plain - full[i] * growth[j];
                }
            }
            response.stored[point] = left * y + 0.5 * k_n * pressed * pressed;
            response.dissipated[point] = response.history[2 * point + 1];
        }
        Ok(())
    }
}

/// 24 by 24 facets on 20 by 20, forces, and both: the best of several, by turns. `cargo test --release --test own_law -- --ignored --nocapture cost` prints them.
#[test]
#[ignore = "a measurement, which other programs disturb"]
fn cost_of_a_law_of_the_host() {
    let below = cuboid_hex8([0.0; 3], [1.0, 1.0, 0.5], [24, 24, 1]);
    let above = cuboid_hex8([0.0, 0.0, 0.5], [1.0, 1.0, 1.0], [20, 20, 1]);
    let scene = Scene::of(&[&below, &above]);
    let own = held(&scene, Swift);
    let mut library = scene.contact(Options::new(EnergyLaw::depth(1.0)));
    let law = Cohesive { shear_strength: 3.0, shear_energy: 0.4, reach: 0.1, ..Cohesive::new(2.0, 0.1) };
    library.set_pair_options([Body(0), Body(1)], Some(PairOptions::with_cohesive(law))).expect("an interface");
    let coords = waved(&scene, 0.002, 0.3);
    let [a, b] = [&own, &library].map(|one| one.evaluate(&coords).expect("an evaluation"));
    assert!((a.energy - b.energy).abs() < 1e-12 * b.energy, "{} {}", a.energy, b.energy);
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
