//! The settings of a contact, in the order in which each stands on those before it.
//!
//! A new one is one entry here, and every test of this suite takes it up.

use crate::one_rank::OneRank;
use crate::problem::{DELTA, Problem, STIFFNESS, moved, wall};
use crate::scene::Scene;
use crate::scene::fibers;
use fmc_contact::contact::{FacetSlip, Friction, Multiplier, PairOptions};
use fmc_contact::overlap::Partner::{self, Body, Obstacle as Rigid};
use fmc_contact::{Basis, Contact, EnergyLaw, Error, FiberOptions, Obstacle, Options, Pose, Shape};

/// A call, or several that go together.
pub(crate) type Call = Box<dyn Fn(&mut Contact<2>) -> Result<(), Error>>;

/// A part of a contact that calls give a value.
pub(crate) struct Setting {
    pub(crate) name: &'static str,
    /// Gives it the value of the end.
    pub(crate) last: Call,
    /// Other values, which it may have had before.
    pub(crate) others: Vec<Call>,
    /// Later settings that another value releases, so that they are set again.
    pub(crate) releases: &'static [&'static str],
}

/// All that make sense in a problem.
pub(crate) fn settings(problem: Problem, scene: &Scene<2>) -> Vec<Setting> {
    // All coordinates are those of its unknowns.
    let mut all = vec![new("basis", |c| c.set_basis(None), vec![call(reversed(scene.coords.len()))], &[])];
    all.extend(of_options(problem));
    all.extend(of_partners(problem));
    all.extend(of_mesh(scene));
    all.push(new(
        "ranks",
        |c| c.set_communicator(None),
        vec![call(|c| c.set_communicator(Some(Box::new(OneRank))))],
        &[],
    ));
    if !problem.has_friction() {
        all.extend(without_friction(problem, scene));
    }
    if problem.options.law.is_fiber() {
        all.push(patches(scene));
    }
    if problem.has_friction() {
        all.extend(steps(problem, scene));
    }
    all
}

fn call(call: impl Fn(&mut Contact<2>) -> Result<(), Error> + 'static) -> Call {
    Box::new(call)
}

fn new(
    name: &'static str,
    last: impl Fn(&mut Contact<2>) -> Result<(), Error> + 'static,
    others: Vec<Call>,
    releases: &'static [&'static str],
) -> Setting {
    Setting { name, last: Box::new(last), others, releases }
}

/// The options with one of them as `change` says.
fn with(change: impl Fn(Options) -> Options + 'static) -> Call {
    call(move |contact| contact.set_options(change(*contact.options())))
}

fn of_options(problem: Problem) -> Vec<Setting> {
    let last = problem.options;
    let law = |law| with(move |options| Options { law, ..options });
    let friction = |friction| with(move |options| Options { friction, ..options });
    let rough = Friction { stiffness: Some(STIFFNESS), ..Friction::coulomb(0.1) };
    let (frozen, kept_and_frozen) = (&["frozen friction"][..], &["patches", "frozen friction"][..]);
    let changes: Vec<(&'static str, Call, Vec<Call>, &'static [&'static str])> = vec![
        (
            "law",
            law(last.law),
            vec![
                law(EnergyLaw::depth(STIFFNESS)),
                law(EnergyLaw::fiber(STIFFNESS)),
                law(EnergyLaw::Volume { stiffness: 3.0, exponent: 2.0 }),
                law(last.law.stiffened(0.5)),
            ],
            &[],
        ),
        (
            "estimator",
            with(move |o| Options { estimator: last.estimator, ..o }),
            vec![with(|o| Options { estimator: fibers(FiberOptions::default()).estimator, ..o })],
            &["patches"],
        ),
        ("threads", with(|o| Options { threads: 1, ..o }), vec![with(|o| Options { threads: 3, ..o })], &[]),
        (
            "self-contact",
            with(move |o| Options { self_contact: last.self_contact, ..o }),
            vec![with(move |o| Options { self_contact: !last.self_contact, ..o })],
            frozen,
        ),
        (
            "axisymmetry",
            with(|o| Options { axisymmetric: false, ..o }),
            vec![with(|o| Options { axisymmetric: true, ..o })],
            kept_and_frozen,
        ),
        (
            "checks",
            with(|o| Options { check_cells: true, ..o }),
            vec![with(|o| Options { check_cells: false, ..o })],
            &[],
        ),
        (
            "friction",
            friction(last.friction),
            vec![
                friction(Friction::default()),
                friction(rough),
                friction(Friction { cohesion: 0.1, ..rough }),
                friction(Friction { stiffness: None, memoryless_slip: Some(1e-4), ..rough }),
            ],
            frozen,
        ),
    ];
    changes.into_iter().map(|(name, last, others, releases)| Setting { name, last, others, releases }).collect()
}

fn of_partners(problem: Problem) -> Vec<Setting> {
    // Of a pair that is left out, or that rubs otherwise.
    let of_pair = &["frozen friction", "multipliers"][..];
    let pose = |pose: Pose<2>| call(move |contact| contact.set_pose(1, pose));
    let pair =
        |pair: [Partner; 2], options: Option<PairOptions>| call(move |contact| contact.set_pair_options(pair, options));
    let [between, itself, on_plane, on_wall] =
        [[Body(0), Body(1)], [Body(1), Body(1)], [Body(0), Rigid(0)], [Body(1), Rigid(1)]];
    // At a distance from a box only depths are measured exactly.
    let at_wall = match problem.options.law {
        EnergyLaw::Depth { .. } => Some(PairOptions::with_gap_offset(0.1 * DELTA)),
        _ => None,
    };
    let own_law = |law| Some(PairOptions::with_law(law));
    let rub = |coefficient| problem.has_friction().then(|| PairOptions::with_friction(coefficient));
    let others = |of: [Partner; 2]| -> Vec<Call> {
        let laws = [EnergyLaw::fiber(2.0 * STIFFNESS), EnergyLaw::depth(3.0)];
        let values = [None, Some(PairOptions::excluded()), rub(0.1), Some(PairOptions::default())];
        values.into_iter().chain(laws.map(own_law)).map(|options| pair(of, options)).collect()
    };
    let mut on_wall_before = others(on_wall);
    on_wall_before.push(pair(on_wall, Some(PairOptions::with_gap_offset(-0.5 * DELTA))));
    let last_itself = problem.options.self_contact.then(PairOptions::default);
    let added = |contact: &mut Contact<2>| {
        let ball = Obstacle { shape: Shape::Ball { radius: 0.2 }, pose: Pose::at([1.5, 0.6]) };
        let index = contact.add_obstacle(ball)?;
        contact.set_pair_options([Rigid(index), Body(1)], Some(PairOptions::with_gap_offset(0.01)))?;
        contact.remove_obstacle(index)
    };
    vec![
        new(
            "pose",
            move |contact| contact.set_pose(1, wall()),
            vec![pose(Pose::at([2.4, 0.3])), pose(Pose::at([2.25, 0.3]).turned(0.1)), pose(wall().scaled(1.1))],
            &[],
        ),
        Setting { name: "an obstacle that is gone", last: call(added), others: Vec::new(), releases: &[] },
        Setting { name: "pair of bodies", last: pair(between, rub(0.2)), others: others(between), releases: of_pair },
        Setting {
            name: "body with the plane",
            last: pair(on_plane, Some(PairOptions::with_gap_offset(0.1 * DELTA))),
            others: others(on_plane),
            releases: of_pair,
        },
        Setting {
            name: "body with itself",
            last: pair(itself, last_itself),
            others: vec![pair(itself, None), pair(itself, Some(PairOptions::excluded()))],
            releases: of_pair,
        },
        Setting {
            name: "body with the wall",
            last: pair(on_wall, at_wall.or(rub(0.2))),
            others: on_wall_before,
            releases: of_pair,
        },
    ]
}

/// Nodes that are moved by as many unknowns in the opposite order.
fn reversed(count: usize) -> impl Fn(&mut Contact<2>) -> Result<(), Error> {
    move |contact| {
        let (row_starts, unknowns): (Vec<usize>, Vec<u32>) = ((0..=count).collect(), (0..count as u32).rev().collect());
        let weights = vec![1.0; count];
        let basis = Basis { unknown_count: count, row_starts: &row_starts, unknowns: &unknowns, weights: &weights };
        contact.set_basis(Some(&basis))
    }
}

fn of_mesh(scene: &Scene<2>) -> Vec<Setting> {
    let given = scene.coords.clone();
    let stretched: Vec<[f64; 2]> = given.iter().map(|[x, y]| [1.01 * x, y - 0.01 * x]).collect();
    let left: Vec<u32> = scene.nodes_of(1).filter(|&n| given[n][0] == 1.0).map(|n| n as u32).collect();
    let (count, adjusted) = (given.len(), moved(scene, 1e-4, 0.0));
    let aside = move |by: f64| (0..count).map(|n| [by * (n as f64).sin(), -by]).collect::<Vec<[f64; 2]>>();
    // So far that the last bits of places are lost on the way.
    let (beside, far) = (aside(-1e-4), aside(0.3));
    vec![
        new("reference", move |c| c.set_reference(&stretched), vec![call(move |c| c.set_reference(&given))], &[]),
        new(
            "offsets",
            move |c| c.set_offsets(&aside(2e-4)),
            vec![
                call(|c| c.set_offsets(&[])),
                call(move |c| c.set_offsets(&beside)),
                call(move |c| c.set_offsets(&far)),
                call(move |c| c.adjust(&adjusted, 0.0, 0.1 * DELTA).map(drop)),
            ],
            &[],
        ),
        new(
            "nodes of symmetry",
            move |c| c.set_symmetry_nodes(&left),
            vec![call(|c| c.set_symmetry_nodes(&[]))],
            &["planes of symmetry"],
        ),
        new(
            "planes of symmetry",
            |c| c.set_symmetry_planes(&[[[0.0; 2], [1.0, 0.0]]]),
            vec![call(|c| c.set_symmetry_nodes(&[])), call(|c| c.set_symmetry_planes(&[]))],
            &[],
        ),
    ]
}

/// Surfaces that are moved out, and rotations of obstacles: neither goes with friction.
fn without_friction(problem: Problem, scene: &Scene<2>) -> Vec<Setting> {
    let rotations = |on| {
        call(move |contact| {
            contact.set_obstacle_rotations(on);
            Ok(())
        })
    };
    let rotations = Setting {
        name: "rotations of obstacles",
        last: rotations(!problem.options.law.is_fiber()),
        others: vec![rotations(false), rotations(true)],
        releases: &[],
    };
    if matches!(problem.options.law, EnergyLaw::Volume { .. }) {
        return vec![rotations];
    }
    let (corner, coords) = (scene.nodes_of(1).start as u32, moved(scene, 1e-4, 0.0));
    let row =
        move |partner, shift| Multiplier { node: corner, partners: [Body(1), partner], shift, towards: [0.6, -0.8] };
    let multipliers = new(
        "multipliers",
        move |contact| contact.set_multipliers(&[row(Body(0), 0.2 * DELTA), row(Rigid(1), 0.1 * DELTA)]),
        vec![
            call(|contact| contact.set_multipliers(&[])),
            call(move |contact| contact.set_multipliers(&[row(Body(0), 0.3 * DELTA)])),
            call(move |contact| contact.augment(&coords, 0.02, 0.0).map(drop)),
        ],
        &[],
    );
    vec![rotations, multipliers]
}

fn patches(scene: &Scene<2>) -> Setting {
    let keep = |coords: Vec<[f64; 2]>| call(move |contact| contact.keep_patches(&coords).map(drop));
    let release = call(|contact| {
        contact.release_patches();
        Ok(())
    });
    Setting {
        name: "patches",
        last: keep(moved(scene, 1e-4, 0.0)),
        others: vec![keep(moved(scene, 0.0, -DELTA)), release],
        releases: &[],
    }
}

/// A step that has begun, and friction that is frozen in it.
fn steps(problem: Problem, scene: &Scene<2>) -> Vec<Setting> {
    let (start, elsewhere, at) = (moved(scene, 0.0, 0.5 * DELTA), moved(scene, -2e-4, 0.0), moved(scene, 3e-4, 0.0));
    let begin = |coords: Vec<[f64; 2]>| call(move |contact| contact.begin_step(&coords));
    let (before, after) = (elsewhere.clone(), at.clone());
    let committed = call(move |contact| {
        contact.begin_step(&before)?;
        contact.commit_step(&after)
    });
    let begun = new(
        "step",
        move |contact| {
            contact.begin_step(&start)?;
            let facets = contact.boundary_facets();
            let slip: Vec<FacetSlip<2>> = (facets.iter().enumerate())
                .map(|(facet, of)| FacetSlip {
                    facet,
                    partner: Body(1 - of.body),
                    is_second: of.body == 1,
                    slip: [1e-6 * (facet as f64 - 9.0), 0.0],
                    slid: 0.0,
                })
                .collect();
            contact.set_slip(&slip)
        },
        vec![begin(elsewhere.clone()), committed],
        &["frozen friction"],
    );
    let freeze = |coords: Vec<[f64; 2]>| call(move |contact| contact.freeze_friction(&coords));
    let release = || {
        call(|contact| {
            contact.release_friction();
            Ok(())
        })
    };
    let frozen = Setting {
        name: "frozen friction",
        last: if problem.freezes { freeze(at.clone()) } else { release() },
        others: vec![freeze(elsewhere), release()],
        releases: &[],
    };
    vec![begun, frozen]
}
