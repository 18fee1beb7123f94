//! What releases frozen friction and kept patches, and what leaves them.

use crate::problem::{DELTA, STIFFNESS, moved, problems};
use crate::scene::Scene;
use crate::scene::fibers;
use crate::settings::Call;
use fmc_contact::contact::{Friction, PairOptions};
use fmc_contact::overlap::Partner::{Body, Obstacle as Rigid};
use fmc_contact::{Contact, EnergyLaw, Error, FiberOptions, Obstacle, Options, Pose, Shape};

fn call(call: impl Fn(&mut Contact<2>) -> Result<(), Error> + 'static) -> Call {
    Box::new(call)
}

fn with(change: impl Fn(Options) -> Options + 'static) -> Call {
    call(move |contact| contact.set_options(change(*contact.options())))
}

fn ball(x: f64) -> Obstacle<2> {
    Obstacle { shape: Shape::Ball { radius: 0.1 }, pose: Pose::at([x, 0.9]) }
}

/// What a call leaves: whether friction stays frozen, and whether patches stay kept.
type Left = (&'static str, Call, [bool; 2]);

fn calls(scene: &Scene<2>) -> Vec<Left> {
    let (start, at) = (moved(scene, 0.0, 0.5 * DELTA), moved(scene, 1e-4, 0.0));
    let pair = |options: PairOptions| call(move |contact| contact.set_pair_options([Body(0), Body(1)], Some(options)));
    let reference: Vec<[f64; 2]> = scene.coords.iter().map(|[x, y]| [1.01 * x, *y]).collect();
    vec![
        ("nothing", call(|_| Ok(())), [true, true]),
        ("begin", call(move |contact| contact.begin_step(&start)), [false, true]),
        ("commit", call(move |contact| contact.commit_step(&at)), [false, true]),
        (
            "slip",
            call(|contact| {
                let slip = contact.slip()?.to_vec();
                contact.set_slip(&slip)
            }),
            [false, true],
        ),
        (
            "other friction",
            with(|o| Options { friction: Friction { coefficient: 0.1, ..o.friction }, ..o }),
            [false, true],
        ),
        ("friction of a pair", pair(PairOptions::with_friction(0.1)), [false, true]),
        ("the same friction of a pair", pair(PairOptions::with_friction(0.3)), [true, true]),
        ("self-contact", with(|o| Options { self_contact: true, ..o }), [true, true]),
        ("estimator", with(|o| Options { estimator: fibers(FiberOptions::default()).estimator, ..o }), [true, false]),
        ("axisymmetry", with(|o| Options { axisymmetric: true, ..o }), [false, false]),
        ("threads", with(|o| Options { threads: 2, ..o }), [true, true]),
        ("checks", with(|o| Options { check_cells: false, ..o }), [true, true]),
        ("stiffness", with(|o| Options { law: o.law.stiffened(2.0), ..o }), [true, true]),
        ("law of a pair", pair(PairOptions::with_law(EnergyLaw::fiber(0.5 * STIFFNESS))), [true, true]),
        ("pose", call(|contact| contact.set_pose(1, Pose::at([2.4, 0.35]))), [true, true]),
        ("another obstacle", call(|contact| contact.add_obstacle(ball(1.2)).map(drop)), [true, true]),
        (
            "another obstacle with options",
            call(|contact| {
                let index = contact.add_obstacle(ball(9.0))?;
                contact.set_pair_options([Body(1), Rigid(index)], Some(PairOptions::with_gap_offset(0.01)))
            }),
            [true, true],
        ),
        ("one obstacle less", call(|contact| contact.remove_obstacle(1)), [true, true]),
        ("reference", call(move |contact| contact.set_reference(&reference)), [true, true]),
        ("symmetry", call(|contact| contact.set_symmetry_nodes(&[])), [true, true]),
        ("ranks", call(|contact| contact.set_communicator(None)), [true, true]),
    ]
}

/// Whether a call changes the forces.
fn is_seen(contact: &mut Contact<2>, coords: &[[f64; 2]], release: fn(&mut Contact<2>)) -> bool {
    let before = contact.evaluate(coords).expect("forces");
    release(contact);
    contact.evaluate(coords).expect("forces") != before
}

#[test]
fn frozen_friction_and_kept_patches() {
    let scene = crate::problem::scene();
    // Patches are kept where the upper body leans.
    let leaning: Vec<[f64; 2]> =
        moved(&scene, 0.0, 0.0).iter().map(|[x, y]| [x - 0.02 * y, y + 0.02 * x - 0.02]).collect();
    let (frozen_at, now) = (moved(&scene, 2e-4, 0.0), moved(&scene, 5e-4, -2e-4));
    for problem in problems().into_iter().filter(|problem| problem.freezes) {
        for (name, call, [stays_frozen, stays_kept]) in calls(&scene) {
            let options = Options { self_contact: false, ..problem.options };
            let begun = || {
                let mut contact = crate::problem::Problem { options, ..problem }.contact(&scene);
                contact.begin_step(&scene.coords).expect("a step");
                contact
            };
            let mut frozen = begun();
            frozen.freeze_friction(&frozen_at).expect("a step has begun");
            call(&mut frozen).expect(name);
            assert_eq!(
                is_seen(&mut frozen, &now, Contact::release_friction),
                stays_frozen,
                "{:?}: {name}",
                options.law
            );
            if options.law.is_fiber() {
                let mut kept = begun();
                assert!(kept.keep_patches(&leaning).expect("patches") > 0);
                call(&mut kept).expect(name);
                assert_eq!(is_seen(&mut kept, &now, Contact::release_patches), stays_kept, "{name}");
            }
        }
    }
}

/// Friction that ends releases what is frozen of that pair alone.
#[test]
fn friction_that_ends_does_not_rub_where_it_is_frozen() {
    let scene = crate::problem::scene();
    let (frozen_at, now) = (moved(&scene, 2e-4, 0.0), moved(&scene, 5e-4, -2e-4));
    let between = [Body(0), Body(1)];
    for problem in problems().into_iter().filter(|problem| problem.freezes) {
        let frozen = |ends_before: bool, ends: &dyn Fn(&mut Contact<2>)| {
            let mut contact = problem.contact(&scene);
            if ends_before {
                ends(&mut contact);
            }
            contact.begin_step(&scene.coords).expect("a step");
            contact.freeze_friction(&frozen_at).expect("a step has begun");
            if !ends_before {
                ends(&mut contact);
            }
            contact.evaluate(&now).expect("forces")
        };
        let of_pair = |contact: &mut Contact<2>| {
            contact.set_pair_options(between, Some(PairOptions::with_friction(0.0))).expect("a pair");
        };
        let of_all = |contact: &mut Contact<2>| {
            contact.set_options(Options { friction: Friction::default(), ..problem.options }).expect("options");
        };
        let of_itself = |contact: &mut Contact<2>| {
            contact.set_options(Options { self_contact: false, ..problem.options }).expect("options");
        };
        for ends in [&of_pair as &dyn Fn(&mut Contact<2>), &of_all, &of_itself] {
            assert_eq!(frozen(false, ends), frozen(true, ends), "{:?}", problem.options.law);
        }
    }
}
