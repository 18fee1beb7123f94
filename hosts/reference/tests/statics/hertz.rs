//! A half-disc pressed on a rigid plane.

use crate::scene::{HALF_WIDTH, PEAK, exact, hertz, recorder, solved};
use fmc_contact::{EnergyLaw, FiberProfile};
use fmc_reference::statics::{Equilibrium, nodal_pressures};

fn report(at: &Equilibrium<2>) -> [f64; 2] {
    let pressures = nodal_pressures(at.model(), 0, &at.balance().contact.forces);
    let points: Vec<(f64, f64)> = pressures
        .iter()
        .filter(|p| p.pressure > 0.3 * PEAK)
        .map(|p| (p.place[0].powi(2), p.pressure.powi(2)))
        .collect();
    let n = points.len() as f64;
    let (sx, sy) = points.iter().fold((0.0, 0.0), |s, p| (s.0 + p.0, s.1 + p.1));
    let (mx, my) = (sx / n, sy / n);
    let slope = points.iter().map(|p| (p.0 - mx) * (p.1 - my)).sum::<f64>()
        / points.iter().map(|p| (p.0 - mx).powi(2)).sum::<f64>();
    let peak = (my - slope * mx).sqrt();
    let a = (-(my - slope * mx) / slope).sqrt();
    println!(
        "nodes {} iterations {} evals {} p0 {:+.3} % a {:+.3} % pen {:.2e} true {:.2e} force {:?}",
        pressures.len(),
        at.iterations,
        at.evaluations,
        100.0 * (peak / PEAK - 1.0),
        100.0 * (a / HALF_WIDTH - 1.0),
        at.balance().contact.penetration,
        at.true_contact().unwrap().penetration,
        at.balance().contact.bodies[0].force
    );
    [peak, a]
}

#[test]
fn trial() {
    for parts in [6.0, 12.0, 24.0] {
        for k in [2e4, 2e5, 2e6] {
            println!("parts {parts} k {k:e}");
            let clock = std::time::Instant::now();
            let (at, _) = solved(hertz(parts, exact(EnergyLaw::fiber(k))));
            report(&at);
            println!("{:?}, {} equations, contact {:.3}", clock.elapsed(), at.equation_count(), at.contact_seconds);
        }
    }
    println!("augmented");
    let (mut at, _) = solved(hertz(24.0, exact(EnergyLaw::fiber(2e5))));
    let mut log = Vec::new();
    let how = at.augment(8e-6, 10, &mut recorder(&mut log)).unwrap();
    println!("{how:?}");
    report(&at);
    println!("linear");
    let law = |epsilon| EnergyLaw::Fiber { k: 15.0, profile: FiberProfile::Linear { epsilon } };
    let (mut at, _) = solved(hertz(24.0, exact(law(8e-3))));
    let mut log = Vec::new();
    at.continue_epsilon(8e-6, &mut recorder(&mut log)).unwrap();
    report(&at);
}
