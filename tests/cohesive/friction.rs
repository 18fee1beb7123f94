//! Friction of what is broken: closed form of a pressed block that is sheared off, energies, derivatives, rigid motions and restarts.

use crate::scene::Scene;
use crate::{in_space, in_the_plane, largest, law, moved};
use fmc_contact::contact::{Cohesive, Friction, PairOptions, TangentPart};
use fmc_contact::overlap::Partner::Body;
use fmc_contact::{Contact, EnergyLaw, Options};
use fmc_shapes::random_rotation;

const MU: f64 = 0.3;
/// k_n = 50 σ²/G, and k_t = k_n (G_n/G_t) (σ_t/σ_n)².
const NORMAL: f64 = 50.0 * 4.0 / 0.1;
const SHEAR: f64 = NORMAL * (0.1 / 0.4) * (9.0 / 4.0);
/// m, and the sliding where damage begins.
const BRITTLE: f64 = 100.0;
const ONSET: f64 = 3.0 / SHEAR;

fn rubbing<const D: usize>(scene: &Scene<D>, cohesive: Cohesive, coefficient: f64, threads: usize) -> Contact<D> {
    let mut contact = scene.contact(Options { threads, ..Options::new(EnergyLaw::depth(1.0)) });
    let own = PairOptions { friction_coefficient: Some(coefficient), ..PairOptions::with_cohesive(cohesive) };
    contact.set_pair_options([Body(0), Body(1)], Some(own)).expect("an interface");
    contact.begin_step(&scene.coords).expect("a step");
    contact
}

/// A way that slides the second body by `slid` along a direction of its face, pressed by `pressure`.
fn way<const D: usize>(slid: f64, pressure: f64) -> [f64; D] {
    let along: [f64; D] = std::array::from_fn(|axis| match (D, axis) {
        (2, 0) => 1.0,
        (3, 0) => 0.6,
        (3, 1) => -0.8,
        _ => 0.0,
    });
    std::array::from_fn(|axis| if axis == D - 1 { -pressure / NORMAL } else { slid * along[axis] })
}

/// The force on the second body against that way, and the force that presses it, by an area of 1.
fn resists<const D: usize>(contact: &Contact<D>, scene: &Scene<D>, by: [f64; D]) -> [f64; 2] {
    let forces = contact.evaluate(&moved(scene, by)).expect("an evaluation").forces;
    let sum: [f64; D] = std::array::from_fn(|axis| forces[scene.first_node[1]..].iter().map(|f| f[axis]).sum());
    let along = way::<D>(1.0, 0.0);
    [-(0..D - 1).map(|axis| sum[axis] * along[axis]).sum::<f64>(), sum[D - 1]]
}

/// (1 − d) k δ + d μ p of a straight fall.
fn sheared(slid: f64, limit: f64) -> f64 {
    let (q, m) = (slid / ONSET, BRITTLE);
    let damage = if q >= m { 1.0 } else { (m * (q - 1.0) / (q * (m - 1.0))).max(0.0) };
    (1.0 - damage) * SHEAR * slid + damage * limit.min(SHEAR * slid)
}

fn follows<const D: usize>(scene: &Scene<D>, pressure: f64) {
    let (mut contact, limit) = (rubbing(scene, law(), MU, 1), MU * pressure);
    // Where (1 − d) k δ + d μ p is largest.
    let at_peak = (limit * BRITTLE / 3.0).sqrt().max(1.0);
    let peak = match at_peak > 1.0 {
        true => (3.0 * BRITTLE + limit * BRITTLE - 2.0 * (limit * BRITTLE * 3.0).sqrt()) / (BRITTLE - 1.0),
        false => 3.0,
    };
    let parts = [0.0, 0.3, 1.0, at_peak, 1.5 * at_peak, 20.0, 60.0, 99.0, 100.0, 110.0, 130.0];
    let mut most: f64 = 0.0;
    for part in parts {
        let by = way(part * ONSET, pressure);
        let [shear, pressed] = resists(&contact, scene, by);
        // Rounding of coordinates of 1 by a stiffness of 1e3.
        assert!((shear - sheared(part * ONSET, limit)).abs() < 1e-10, "{shear} at {part}");
        assert!((pressed - pressure).abs() < 1e-10);
        most = most.max(shear);
        contact.commit_step(&moved(scene, by)).expect("a step");
    }
    assert!((most - peak).abs() < 1e-9, "{most} for {peak}");
    let end = 130.0 * ONSET;
    assert!((resists(&contact, scene, way(end, pressure))[0] - limit).abs() < 1e-9);
    // Twice the pressure, and back: stick, then the other way; lifted, nothing, and put down elsewhere it starts without shear.
    assert!((resists(&contact, scene, way(end + 0.1, 2.0 * pressure))[0] - 2.0 * limit).abs() < 1e-9);
    assert!((resists(&contact, scene, way(end - limit / SHEAR, pressure))[0]).abs() < 1e-9);
    assert!((resists(&contact, scene, way(end - 0.1, pressure))[0] + limit).abs() < 1e-9);
    let lifted = way(end - 0.05, -1.0);
    assert!(resists(&contact, scene, lifted)[0].abs() < 1e-12);
    contact.commit_step(&moved(scene, lifted)).expect("a step");
    assert!(resists(&contact, scene, way(end - 0.05, pressure))[0].abs() < 1e-10);
    let a_little = 0.5 * limit / SHEAR;
    assert!((resists(&contact, scene, way(end - 0.05 + a_little, pressure))[0] - 0.5 * limit).abs() < 1e-9);
}

#[test]
fn a_pressed_block_is_sheared_off_by_the_closed_form_and_rubs_on() {
    for pressure in [0.05, 1.0, 5.0] {
        in_the_plane(0.0).iter().for_each(|scene| follows(scene, pressure));
        in_space(0.0).iter().for_each(|scene| follows(scene, pressure));
    }
}

/// The coefficient of all pairs holds too, and a limit of the shear traction; what never slides sticks where it is pressed.
#[test]
fn other_options_of_friction_hold() {
    let scene = &in_the_plane(0.0)[0];
    let by = way(0.5, 1.0);
    let broken = |friction: Friction| {
        let mut contact = scene.contact(Options { friction, ..Options::new(EnergyLaw::depth(1.0)) });
        contact.set_pair_options([Body(0), Body(1)], Some(PairOptions::with_cohesive(law()))).expect("an interface");
        contact.begin_step(&scene.coords).expect("a step");
        resists(&contact, scene, by)[0]
    };
    assert!((broken(Friction::coulomb(0.4)) - 0.4).abs() < 1e-10);
    assert!((broken(Friction { shear_limit: 0.25, ..Friction::coulomb(0.4) }) - 0.25).abs() < 1e-10);
    assert!((broken(Friction::coulomb(f64::INFINITY)) - 0.5 * SHEAR).abs() < 1e-9);
    assert_eq!(broken(Friction::default()), 0.0);
}

/// Work by trapezoids of 2000 steps; closed forms of what is dissipated.
#[test]
fn work_is_what_is_stored_broken_and_rubbed() {
    let scene = &in_the_plane(0.0)[1];
    let (pressure, count, end) = (2.0, 2000, 120.0 * ONSET);
    let (mut contact, limit) = (rubbing(scene, law(), MU, 1), MU * pressure);
    contact.commit_step(&moved(scene, way(0.0, pressure))).expect("a step");
    let told = |contact: &Contact<2>, slid: f64| {
        contact.cohesive([0, 1], &moved(scene, way(slid, pressure))).expect("bodies").expect("an interface")
    };
    let (mut work, mut last) = (pressure * pressure / (2.0 * NORMAL), [0.0; 2]);
    let there = (1..=count).map(|k| end * f64::from(k) / f64::from(count));
    let back = (1..=count).map(|k| end * (1.0 - f64::from(k) / f64::from(count)));
    for slid in there.chain(back) {
        let shear = resists(&contact, scene, way(slid, pressure))[0];
        work += 0.5 * (shear + last[1]) * (slid - last[0]);
        last = [slid, shear];
        let now = told(&contact, slid);
        let energy = now.stored + now.dissipated + now.rubbed;
        assert!((energy - work).abs() < 1e-3 * work, "{energy} for {work} at {slid}");
        contact.commit_step(&moved(scene, way(slid, pressure))).expect("a step");
        if slid == end {
            // ∫ d dδ to the end of the fall, and on from there.
            let m = BRITTLE;
            let while_breaking = ONSET * m / (m - 1.0) * (m - 1.0 - m.ln());
            let rubbed = limit * (while_breaking + end - m * ONSET) - 0.5 * limit * limit / SHEAR;
            assert!((now.rubbed - rubbed).abs() < 1e-3 * rubbed, "{} for {rubbed}", now.rubbed);
            assert!((now.dissipated - 0.4).abs() < 1e-10 && (work - 0.4 - rubbed - now.stored).abs() < 1e-3 * work);
        }
    }
    let points = contact.cohesive_points(&moved(scene, way(0.0, pressure))).expect("points");
    let rubbed: f64 = points.iter().map(|point| point.area * point.rubbed).sum();
    assert!((rubbed - told(&contact, 0.0).rubbed).abs() < 1e-12 && rubbed > limit * end);
}

fn field<const D: usize>(coords: &[[f64; D]], seed: f64) -> Vec<[f64; D]> {
    let wave = |node: usize, axis: usize| (seed + 1.7 * node as f64 + 2.9 * axis as f64).sin();
    (0..coords.len()).map(|node| std::array::from_fn(|axis| wave(node, axis))).collect()
}

fn plus<const D: usize>(coords: &[[f64; D]], by: f64, step: &[[f64; D]]) -> Vec<[f64; D]> {
    coords.iter().zip(step).map(|(x, d)| std::array::from_fn(|axis| x[axis] + by * d[axis])).collect()
}

fn dot<const D: usize>(a: &[[f64; D]], b: &[[f64; D]]) -> f64 {
    a.iter().flatten().zip(b.iter().flatten()).map(|(a, b)| a * b).sum()
}

fn turned<const D: usize>(coords: &[[f64; D]]) -> Vec<[f64; D]> {
    let turn = random_rotation::<D>(5);
    let one =
        |x: &[f64; D]| -> [f64; D] { std::array::from_fn(|i| 2.0 + (0..D).map(|j| turn[i][j] * x[j]).sum::<f64>()) };
    coords.iter().map(one).collect()
}

/// Differences of forces by a step; none where a point begins to slide, to break or to open within it, by which those of half the step differ.
/// Rounding of forces of 10 by 1e-7 is 1e-8.
fn change<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]], step: &[[f64; D]]) -> Option<Vec<[f64; D]>> {
    let by = |h: f64| -> Vec<[f64; D]> {
        let at = |by: f64| contact.evaluate(&plus(coords, by, step)).expect("an evaluation").forces;
        plus(&at(h), -1.0, &at(-h)).iter().map(|f| f.map(|f| -f / (2.0 * h))).collect()
    };
    let [whole, half] = [1e-7, 0.5e-7].map(by);
    (largest(&plus(&whole, -1.0, &half)) < 1e-6 * largest(&whole)).then_some(whole)
}

/// Tangents and differences of forces; balance of forces and moments; the symmetric part and the one that is never negative.
fn differences<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) {
    let step = field(coords, 4.1);
    let nudged = |k: i32| plus(coords, 1e-5 * f64::from(k), &field(coords, 9.1));
    let smooth = (0..4).map(nudged).find_map(|coords| Some((change(contact, &coords, &step)?, coords)));
    let (change, coords) = smooth.expect("forces that are smooth");
    let coords = &coords;
    let (found, tangent) = contact.evaluate_tangent(coords, TangentPart::Full).expect("an evaluation");
    let force = found.forces.iter().flatten().map(|f| f.abs()).sum::<f64>();
    let sums = (0..D).map(|axis| found.forces.iter().map(|f| f[axis]).sum::<f64>().abs());
    assert!(sums.fold(0.0, f64::max) < 1e-13 * force);
    let moment = |i: usize, j: usize| {
        coords.iter().zip(&found.forces).map(|(x, f)| x[i] * f[j] - x[j] * f[i]).sum::<f64>().abs()
    };
    assert!((1..D).all(|j| (0..j).all(|i| moment(i, j) < 1e-12 * force)));
    let product = tangent.product(&step);
    let off = largest(&plus(&product, -1.0, &change));
    assert!(off < 1e-6 * largest(&product), "{off:e} of {:e}", largest(&product));
    let other = field(coords, 7.7);
    let symmetric = contact.tangent(coords, TangentPart::Symmetric).expect("a tangent");
    let (ab, ba) = (dot(&other, &symmetric.product(&step)), dot(&step, &symmetric.product(&other)));
    assert!((ab - ba).abs() < 1e-12 * largest(&product) * other.len() as f64);
    let both = 0.5 * (dot(&other, &product) + dot(&step, &tangent.product(&other)));
    assert!((both - ab).abs() < 1e-12 * largest(&product) * other.len() as f64);
    let secant = contact.tangent(coords, TangentPart::Semidefinite).expect("a tangent");
    for seed in 0..5 {
        let d = field(coords, f64::from(seed));
        assert!(dot(&d, &secant.product(&d)) >= 0.0);
    }
}

/// Pressed and bent: sticking and sliding points, whole and broken ones, after steps that have slid.
fn bent<const D: usize>(scene: &Scene<D>, slid: f64, pressure: f64) -> Vec<[f64; D]> {
    plus(&moved(scene, way(slid, pressure)), 2.1e-3, &field(&scene.coords, 0.3))
}

fn derivatives<const D: usize>(scenes: &[Scene<D>]) {
    for scene in scenes {
        let mut contact = rubbing(scene, Cohesive { reach: 0.1, ..law() }, MU, 1);
        for (slid, pressure) in [(0.004, 3.0), (0.05, 6.0), (0.049, 6.0), (0.3, 8.0), (0.2999, 8.0)] {
            let coords = bent(scene, slid, pressure);
            let points = contact.cohesive_points(&coords).expect("points");
            assert!(points.iter().any(|point| point.opening < 0.0 && point.damage > 0.0), "at {slid}");
            differences(&contact, &coords);
            contact.commit_step(&coords).expect("a step");
            // Turned as a whole it rubs alike.
            let here = contact.evaluate(&coords).expect("an evaluation");
            let there = contact.evaluate(&turned(&coords)).expect("an evaluation");
            assert!((here.energy - there.energy).abs() < 1e-10 * here.energy);
            let size = |x: &[f64; D]| x.iter().map(|x| x * x).sum::<f64>().sqrt();
            let pairs = here.forces.iter().zip(&there.forces);
            assert!(pairs.fold(0.0, |most: f64, (a, b)| most.max((size(a) - size(b)).abs())) < 1e-9);
        }
    }
}

#[test]
fn tangents_against_differences() {
    derivatives(&in_the_plane(0.0));
    derivatives(&in_the_plane(0.03));
    derivatives(&in_space(0.03));
}

/// In the midst of breaking and rubbing; with any number of threads.
#[test]
fn a_restart_gives_the_same_bits() {
    for scene in &in_space(0.0) {
        let mut contact = rubbing(scene, law(), MU, 1);
        let steps =
            [(0.01, 3.0), (0.1, 5.0), (0.09, 2.0), (0.3, 4.0)].map(|(slid, pressure)| bent(scene, slid, pressure));
        for coords in &steps[..2] {
            contact.commit_step(coords).expect("a step");
        }
        let (damage, history) = (contact.damage().expect("damage"), contact.cohesive_history().expect("history"));
        assert!(history.iter().any(|point| point.slip != [0.0; 2] && point.rubbed > 0.0));
        for threads in [1, 3] {
            let mut other = rubbing(scene, law(), MU, threads);
            other.begin_step(&steps[1]).expect("a step");
            other.set_damage(&damage).expect("damage");
            assert_ne!(contact.evaluate(&steps[2]), other.evaluate(&steps[2]));
            other.set_cohesive_history(&history).expect("history");
            let mut first = rubbing(scene, law(), MU, 1);
            steps[..2].iter().for_each(|coords| first.commit_step(coords).expect("a step"));
            for coords in &steps[2..] {
                assert_eq!(first.evaluate(coords), other.evaluate(coords));
                assert_eq!(first.tangent(coords, TangentPart::Full), other.tangent(coords, TangentPart::Full));
                first.commit_step(coords).expect("a step");
                other.commit_step(coords).expect("a step");
            }
            assert_eq!(first.cohesive_history(), other.cohesive_history());
        }
        let mut wrong = history.clone();
        wrong[0].slip[1] = f64::NAN;
        assert!(contact.set_cohesive_history(&wrong).is_err() && contact.set_cohesive_history(&history[1..]).is_err());
        assert_eq!(contact.cohesive_history().expect("history"), history);
        // Points that are found anew have slid as before.
        contact.set_reference(&scene.coords).expect("a reference");
        // Two points that lie at one place may change theirs, which are the same but for rounding.
        for (now, before) in contact.cohesive_history().expect("history").iter().zip(&history) {
            assert!((0..2).all(|k| (now.slip[k] - before.slip[k]).abs() < 1e-12));
            assert!((now.rubbed - before.rubbed).abs() < 1e-12);
        }
    }
}

/// A coefficient of 0 is none, to the bit.
#[test]
fn without_friction_all_is_as_it_was() {
    let scene = &in_space(0.0)[0];
    let (mut without, mut zero) = (crate::held(scene, law()), rubbing(scene, law(), 0.0, 1));
    without.begin_step(&scene.coords).expect("a step");
    for (slid, pressure) in [(0.01, 3.0), (0.1, -1.0), (0.3, 4.0)] {
        let coords = bent(scene, slid, pressure);
        assert_eq!(
            without.evaluate_tangent(&coords, TangentPart::Full),
            zero.evaluate_tangent(&coords, TangentPart::Full)
        );
        without.commit_step(&coords).expect("a step");
        zero.commit_step(&coords).expect("a step");
    }
    assert!(zero.cohesive_history().expect("history").iter().all(|point| *point == Default::default()));
}
