//! A call that is refused changes nothing.

use crate::looks::{look, same};
use crate::problem::{DELTA, Problem, moved, problems};
use crate::settings::settings;
use fmc_contact::contact::{FacetSlip, Friction, Multiplier, PairOptions};
use fmc_contact::overlap::Partner::{self, Body, Obstacle as Rigid};
use fmc_contact::{Basis, Communicator, Contact, EnergyLaw, Error, Obstacle, Options, Pose, Shape};

type Refused = Box<dyn Fn(&mut Contact<2>) -> Result<(), Error>>;

/// Rank 2 of 2.
struct NoRank;

impl Communicator for NoRank {
    fn rank(&self) -> usize {
        2
    }

    fn size(&self) -> usize {
        2
    }

    fn all_gather(&self, _: &[u8], _: &[usize], _: &mut [u8]) -> Result<(), i32> {
        Err(1)
    }
}

fn refused(call: impl Fn(&mut Contact<2>) -> Result<(), Error> + 'static) -> Refused {
    Box::new(call)
}

fn options() -> Vec<Refused> {
    let with = |change: fn(Options) -> Options| refused(move |contact| contact.set_options(change(*contact.options())));
    vec![
        with(|o| Options { law: EnergyLaw::depth(-1.0), ..o }),
        with(|o| Options { law: EnergyLaw::fiber(f64::NAN), ..o }),
        with(|o| Options { threads: 0, ..o }),
        with(|o| Options { friction: Friction { coefficient: f64::NAN, ..o.friction }, ..o }),
        with(|o| Options { friction: Friction { shear_limit: 0.0, ..o.friction }, ..o }),
        with(|o| {
            let friction = Friction { stiffness: Some(1.0), memoryless_slip: Some(1.0), ..Friction::coulomb(0.1) };
            Options { friction, ..o }
        }),
        with(|o| Options { law: EnergyLaw::volume(1.0), friction: Friction::coulomb(0.1), ..o }),
        refused(|contact| contact.stiffen(0.0)),
        refused(|contact| contact.stiffen(f64::INFINITY)),
    ]
}

fn partners() -> Vec<Refused> {
    let pair = |pair: [Partner; 2], options: PairOptions| {
        refused(move |contact| contact.set_pair_options(pair, Some(options)))
    };
    let ball = |radius| Obstacle { shape: Shape::Ball { radius }, pose: Pose::at([0.0; 2]) };
    let flat = Pose { rotation: [[1.0, 0.0], [0.0, 0.0]], ..Pose::default() };
    vec![
        pair([Body(0), Body(9)], PairOptions::default()),
        pair([Body(0), Rigid(9)], PairOptions::default()),
        pair([Rigid(1), Rigid(0)], PairOptions::default()),
        pair([Body(0), Body(1)], PairOptions::with_law(EnergyLaw::depth(0.0))),
        pair([Body(0), Body(1)], PairOptions::with_friction(-1.0)),
        pair([Body(0), Body(1)], PairOptions::with_gap_offset(DELTA)),
        pair(
            [Body(0), Body(1)],
            PairOptions { law: Some(EnergyLaw::fiber(1.0)), ..PairOptions::with_gap_offset(-DELTA) },
        ),
        pair([Body(1), Rigid(1)], PairOptions::with_gap_offset(f64::NAN)),
        refused(move |contact| contact.add_obstacle(ball(-1.0)).map(drop)),
        refused(move |contact| contact.add_obstacle(Obstacle { pose: flat, ..ball(1.0) }).map(drop)),
        refused(move |contact| contact.set_pose(1, flat)),
        refused(move |contact| contact.set_pose(1, Pose::default().scaled(0.0))),
        refused(|contact| contact.set_pose(9, Pose::default())),
        refused(|contact| contact.remove_obstacle(9)),
        refused(|contact| contact.set_communicator(Some(Box::new(NoRank)))),
    ]
}

fn mesh(coords: &[[f64; 2]]) -> Vec<Refused> {
    let (count, short) = (coords.len(), coords[1..].to_vec());
    let mirrored: Vec<[f64; 2]> = coords.iter().map(|[x, y]| [-x, *y]).collect();
    let all: Vec<u32> = (0..count as u32).collect();
    let basis = move |unknown_count, weight: f64| {
        refused(move |contact| {
            let (row_starts, unknowns): (Vec<usize>, Vec<u32>) = ((0..=count).collect(), (0..count as u32).collect());
            let weights = vec![weight; count];
            contact.set_basis(Some(&Basis {
                unknown_count,
                row_starts: &row_starts,
                unknowns: &unknowns,
                weights: &weights,
            }))
        })
    };
    vec![
        refused(move |contact| contact.set_reference(&short)),
        refused(move |contact| contact.set_reference(&mirrored)),
        refused(move |contact| contact.set_symmetry_nodes(&all)),
        refused(move |contact| contact.set_symmetry_nodes(&[0, count as u32])),
        refused(|contact| contact.set_symmetry_planes(&[[[0.0; 2], [1.0, 0.0]], [[0.0; 2], [0.0; 2]]])),
        basis(count - 1, 1.0),
        basis(count, f64::NAN),
    ]
}

/// Coordinates of another number, one of them no number, and cells that are turned over.
fn bad_coords(coords: &[[f64; 2]]) -> [Vec<[f64; 2]>; 3] {
    let mut broken = coords.to_vec();
    broken[3][1] = f64::NAN;
    [coords[1..].to_vec(), broken, coords.iter().map(|[x, y]| [3.0 - x, *y]).collect()]
}

fn history(coords: &[[f64; 2]]) -> Vec<Refused> {
    let row = |node, partner, shift, towards| Multiplier { node, partners: [Body(1), partner], shift, towards };
    let multipliers = move |row: Multiplier<2>| refused(move |contact| contact.set_multipliers(&[row]));
    let slips = |facet, partner, is_second, size| {
        refused(move |contact| {
            contact.set_slip(&[FacetSlip { facet, partner, is_second, slip: [size, 0.0], slid: 0.0 }])
        })
    };
    let mut calls = vec![
        multipliers(row(9_999, Body(0), 1e-4, [0.0, 1.0])),
        multipliers(row(3, Rigid(7), 1e-4, [0.0, 1.0])),
        multipliers(row(3, Body(0), 0.0, [0.0, 1.0])),
        multipliers(row(3, Body(0), 1e-4, [0.0, 0.0])),
        slips(9_999, Body(1), false, 0.0),
        slips(0, Body(7), false, 0.0),
        slips(0, Rigid(7), false, 0.0),
        slips(0, Rigid(0), true, 0.0),
        slips(0, Body(1), true, 0.0),
        slips(0, Body(1), false, f64::INFINITY),
        refused(|contact| {
            let one = FacetSlip { facet: 0, partner: Body(1), is_second: false, slip: [1e-6, 0.0], slid: 0.0 };
            contact.set_slip(&[one, one])
        }),
    ];
    let good = coords.to_vec();
    calls.push(refused(move |contact| contact.augment(&good, f64::NAN, 0.0).map(drop)));
    for bad in bad_coords(coords) {
        // Nothing is measured to begin a step without friction, or to keep patches where no law has any.
        let (begun, committed, frozen) = (bad.clone(), bad.clone(), bad.clone());
        calls.push(refused(move |contact| contact.commit_step(&committed)));
        calls.push(refused(move |contact| contact.freeze_friction(&frozen)));
        calls.push(refused(move |contact| contact.augment(&bad, 0.0, 0.0).map(drop)));
        calls.push(refused(move |contact| match contact.options().friction.is_active() {
            true => contact.begin_step(&begun),
            false => contact.evaluate(&begun).map(drop),
        }));
    }
    calls
}

fn calls(problem: Problem, coords: &[[f64; 2]]) -> Vec<Refused> {
    let mut all = options();
    all.extend(partners());
    all.extend(mesh(coords));
    all.extend(history(coords));
    if problem.options.law.is_fiber() {
        for bad in bad_coords(coords) {
            all.push(refused(move |contact| contact.keep_patches(&bad).map(drop)));
        }
    }
    all
}

#[test]
fn what_is_refused_changes_nothing() {
    let scene = crate::problem::scene();
    let now = moved(&scene, 4e-4, -2e-4);
    for problem in problems() {
        let mut contact = problem.contact(&scene);
        settings(problem, &scene).iter().for_each(|setting| (setting.last)(&mut contact).expect(setting.name));
        let expected = look(&contact, &now);
        for (number, call) in calls(problem, &scene.coords).iter().enumerate() {
            assert!(call(&mut contact).is_err(), "{:?}: call {number} is not refused", problem.options);
            same(&look(&contact, &now), &expected, &|| format!("{problem:?}, refused call {number}"));
        }
        // Threads that fail to start, say, would leave no step behind.
        assert!(contact.slip().is_ok() == problem.has_friction());
    }
}
