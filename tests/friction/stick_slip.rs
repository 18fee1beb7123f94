//! A coefficient of friction at rest that is larger than that of what slides.

use crate::scene::Scene;
use crate::{STIFFNESS, begun, in_plane, laws, slid};
use fmc_contact::contact::{Friction, PairOptions, StaticFriction};
use fmc_contact::overlap::Partner;
use fmc_contact::{Contact, Error, Obstacle, Options, Pose, Shape};
use fmc_shapes::rectangle_quad4;

const AT_REST: StaticFriction = StaticFriction { coefficient: 0.5, weakening_slip: 4e-3 };

fn falling(at_rest: StaticFriction) -> Friction {
    Friction { at_rest: Some(at_rest), ..Friction::coulomb(0.3) }
}

/// Friction by the normal force, of the upper block.
fn ratio(contact: &Contact<2>, coords: &[[f64; 2]]) -> f64 {
    let block = &contact.evaluate(coords).expect("forces").bodies[1];
    block.friction[0].abs() / (block.force[1] - block.friction[1])
}

/// It falls in proportion to what has slid, and is whole again once a facet has stuck throughout a step; so of a pair.
#[test]
fn it_falls_as_facets_slide_and_heals_at_rest() {
    for options in laws(0.0) {
        let scene = &in_plane(1e-3)[0];
        let by_pair = |contact: &mut Contact<2>| {
            let own = PairOptions { static_friction: Some(AT_REST), ..PairOptions::with_friction(0.3) };
            contact.set_pair_options([Partner::Body(0), Partner::Body(1)], Some(own)).expect("a pair");
        };
        for of_pair in [false, true] {
            let friction = if of_pair { Friction::default() } else { falling(AT_REST) };
            let mut contact = scene.contact(Options { friction, ..options });
            if of_pair {
                by_pair(&mut contact);
            }
            contact.begin_step(&scene.coords).expect("a step");
            let limit = |contact: &Contact<2>, by: f64| ratio(contact, &slid(scene, by));
            // At rest, though tried far.
            assert!((limit(&contact, 5e-3) - 0.5).abs() < 2e-3, "{options:?}");
            contact.commit_step(&slid(scene, 2.5e-3)).expect("a step");
            // It has slid by 2.5e-3 less the elastic slip at the limit.
            let expected = 0.5 - 0.2 * (2.5e-3 - 0.5e-3) / AT_REST.weakening_slip;
            assert!((limit(&contact, 5e-3) - expected).abs() < 2e-3, "{options:?}: {}", limit(&contact, 5e-3));
            contact.commit_step(&slid(scene, 9e-3)).expect("a step");
            assert!((limit(&contact, 2e-2) - 0.3).abs() < 2e-3, "{options:?}");
            // The coefficient of a step is that at its start: the next one slides by the lower one.
            contact.commit_step(&slid(scene, 9.5e-3)).expect("a step");
            let back = slid(scene, 9.5e-3 - 1e-5);
            contact.commit_step(&back).expect("a step");
            let healed = limit(&contact, 2e-2);
            assert!((healed - 0.5).abs() < 2e-3, "{options:?}: {healed} {:?}", contact.slip());
        }
    }
}

/// What has slid is carried over by a restart.
#[test]
fn a_restart_knows_what_has_slid() {
    for options in laws(0.0) {
        let scene = &in_plane(1e-3)[1];
        let options = Options { friction: falling(AT_REST), ..options };
        let (middle, end) = (slid(scene, 2.5e-3), slid(scene, 5e-3));
        let mut contact = begun(scene, options, &scene.coords);
        contact.commit_step(&middle).expect("a step");
        let mut other = begun(scene, options, &middle);
        other.set_slip(&contact.slip().expect("a step")).expect("a slip");
        assert_eq!(other.evaluate(&end), contact.evaluate(&end));
        assert!(contact.slip().expect("a step").iter().any(|one| one.slid > 1e-3));
        let bad: Vec<_> = contact
            .slip()
            .expect("a step")
            .into_iter()
            .map(|one| fmc_contact::contact::FacetSlip { slid: -1.0, ..one })
            .collect();
        assert!(matches!(other.set_slip(&bad), Err(Error::NonFiniteSlip { .. })));
    }
}

#[test]
fn what_is_refused() {
    let scene = &in_plane(1e-3)[0];
    let memoryless = Friction { memoryless_slip: Some(1e-3), ..falling(AT_REST) };
    for friction in [
        falling(StaticFriction { coefficient: 0.2, ..AT_REST }),
        falling(StaticFriction { coefficient: f64::NAN, ..AT_REST }),
        falling(StaticFriction { weakening_slip: 0.0, ..AT_REST }),
        memoryless,
    ] {
        let options = Options { friction, ..laws(0.0)[0] };
        assert!(Contact::new(scene.surface(), options).is_err(), "{friction:?}");
    }
}

/// A rigid block on a plane, pulled by a spring at constant speed: it sticks until the spring pulls by the coefficient at rest, slides
/// through as half an oscillation about the other, and sticks again. Implicit Euler, whose steps let the stiff stick come to rest.
#[test]
fn a_block_pulled_by_a_spring() {
    let (mass, spring, rest, slides) = (2.0, 50.0, 0.5, 0.3);
    let scene = Scene::of(&[&rectangle_quad4([0.0, 0.0], [1.0, 1.0], [1, 1])]);
    let floor = Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0, 1e-2]) };
    let normal = STIFFNESS * 1e-2;
    // Spring force above that of sliding when it begins to slide, as a stretch.
    let (most, frequency) = ((rest - slides) * normal / spring, f64::sqrt(spring / mass));
    let speed = 0.5 * most * frequency;
    let (step, stick) = (3e-3 / frequency, 1e8 * spring);
    let friction = Friction {
        stiffness: Some(stick),
        ..falling(StaticFriction { coefficient: rest, weakening_slip: 1e-6 * most })
    };
    let mut contact = scene.contact(Options { friction, ..laws(0.0)[0] });
    contact.add_obstacle(floor).expect("a plane");
    let at = |x: f64| -> Vec<[f64; 2]> { scene.coords.iter().map(|node| [node[0] + x, node[1]]).collect() };
    contact.begin_step(&at(0.0)).expect("a step");
    let (mut x, mut velocity, mut time) = (0.0, 0.0, 0.0);
    let (mut work, mut lost, mut stored, mut last) = (0.0, 0.0, 0.0, 0.0);
    // Stretch and time at every onset and end of sliding.
    let (mut onsets, mut ends, mut slid_before) = (Vec::new(), Vec::new(), false);
    while onsets.len() < 3 {
        assert!(time < 1e3 * most / speed, "{onsets:?} {ends:?}");
        time += step;
        let of = |x_next: f64| contact.evaluate(&at(x_next)).expect("forces");
        let residual = |x_next: f64| {
            let inertia = mass * ((x_next - x) / step - velocity) / step;
            inertia - spring * (speed * time - x_next) - of(x_next).bodies[0].friction[0]
        };
        // All sticks, or all slides; else what lies between.
        let inertia = mass / (step * step);
        let free = inertia * (x + step * velocity) + spring * speed * time;
        let force = |x: f64| of(x).bodies[0].friction[0];
        let stuck = (free + force(x) + stick * x) / (inertia + spring + stick);
        let far = x + step * speed * (stuck - x).signum();
        let slid = || (free + force(far)) / (inertia + spring);
        let solves = |x: &f64| residual(*x).abs() < 1e-7 * normal;
        let next = Some(stuck).filter(solves).or_else(|| Some(slid()).filter(solves));
        let next = next.unwrap_or_else(|| root(&residual, x, x + step * velocity, step * speed));
        let found = of(next);
        let slides = found.friction.slip_area > 0.0 && (next - x) > 0.01 * step * speed;
        let stretch = speed * time - next;
        if slides != slid_before {
            if slides { onsets.push((time, stretch)) } else { ends.push((time, stretch)) }
        }
        slid_before = slides;
        let force = -found.bodies[0].friction[0];
        work += 0.5 * (force + last) * (next - x);
        (lost, stored, last) = (lost + found.friction.dissipated, found.friction.stored, force);
        contact.commit_step(&at(next)).expect("a step");
        (velocity, x) = ((next - x) / step, next);
    }
    let period = 2.0 * most / speed + (std::f64::consts::TAU - 2.0 * (most * frequency / speed).atan()) / frequency;
    let peak = rest * normal / spring;
    for (onset, end) in onsets.iter().zip(&ends) {
        println!("peak {} drop {}", onset.1 / peak, (onset.1 - end.1) / (2.0 * most));
        assert!((onset.1 / peak - 1.0).abs() < 0.01, "peak {} of {peak}", onset.1);
        assert!(((onset.1 - end.1) / (2.0 * most) - 1.0).abs() < 0.01, "drop {} of {}", onset.1 - end.1, 2.0 * most);
    }
    for pair in onsets.windows(2) {
        let found = pair[1].0 - pair[0].0;
        println!("period {}", found / period);
        assert!((found / period - 1.0).abs() < 0.01, "period {found} of {period}");
    }
    println!("work {work} lost {lost} stored {stored}");
    assert!((work - lost - stored).abs() < 2e-3 * work, "{work} {lost} {stored}");
}

/// Of a function that grows, near two guesses.
fn root(of: &impl Fn(f64) -> f64, one: f64, other: f64, size: f64) -> f64 {
    let (mut low, mut high) = (one.min(other) - size, one.max(other) + size);
    let (mut at_low, mut at_high) = (of(low), of(high));
    assert!(at_low < 0.0 && at_high > 0.0, "{at_low} {at_high}");
    for _ in 0..200 {
        // Illinois: the end that stays counts half.
        let next = (low * at_high - high * at_low) / (at_high - at_low);
        let found = of(next);
        if found.abs() < 1e-9 || high - low < 1e-15 {
            return next;
        }
        if found < 0.0 {
            (low, at_low, at_high) = (next, found, 0.5 * at_high);
        } else {
            (high, at_high, at_low) = (next, found, 0.5 * at_low);
        }
    }
    0.5 * (low + high)
}
