//! An elastic block on a rigid plane, pressed down and pulled along by its top.

use crate::scene::{exact, material};
use fmc_contact::contact::Friction;
use fmc_contact::{CellType, EnergyLaw, Obstacle, Options, Pose, Shape};
use fmc_shapes::rectangle_quad4;
use fmc_solid::fem::{Constraints, Law, Model, Part};
use fmc_solid::statics::{Equilibrium, FrictionPressure, Path, Problem};
use std::ops::ControlFlow;

const MU: f64 = 0.3;
const DOWN: f64 = 0.01;
const PULL: f64 = 0.02;

/// 2 by 1, k = 10 E/h.
fn block(law: EnergyLaw, pull: f64) -> Problem<2> {
    let mesh = rectangle_quad4([0.0; 2], [2.0, 1.0], [16, 8]);
    let block = Part { name: "block".into(), cell_type: CellType::Quad4, mesh, material: material(200.0) };
    let model = Model::new(vec![block]).unwrap();
    let contact = Options { friction: Friction::coulomb(MU), ..exact(law) };
    let plane = Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0; 2]) };
    let supports = held(&model, pull);
    Problem { supports, obstacles: vec![plane], ..Problem::new(model, contact) }
}

fn held(model: &Model<2>, pull: f64) -> Constraints<2> {
    let mut supports = Constraints::default();
    let top = model.nodes_where(0, |x| x[1] > 1.0 - 1e-9);
    supports.prescribe(top.clone(), 0, pull);
    supports.prescribe(top, 1, -DOWN);
    supports
}

fn laws() -> [EnergyLaw; 2] {
    [EnergyLaw::depth(16e3), EnergyLaw::fiber(16e3)]
}

/// Friction on the plane by what presses on it.
fn ratio(at: &Equilibrium<2>) -> f64 {
    let plane = &at.balance().contact.obstacles[0];
    plane.friction[0] / (plane.friction[1] - plane.force[1])
}

fn pulled(
    problem: Problem<2>,
    friction: FrictionPressure,
    path: Path,
    reached: &mut dyn FnMut(&Equilibrium<2>),
) -> Equilibrium<2> {
    let law = problem.contact.law;
    let mut at = Equilibrium::new(problem).unwrap();
    at.settings.friction = friction;
    let mut watch = |iteration: &_| {
        println!("{iteration}");
        ControlFlow::Continue(())
    };
    at.follow(Path::default(), &mut watch).unwrap();
    let supports = held(at.model(), PULL);
    at.next_stage(supports).unwrap();
    at.follow_telling(path, &mut watch, reached).unwrap();
    let (iterations, of_contact, evaluations) = (at.iterations, at.contact_iterations, at.evaluations);
    println!("{law:?} {friction:?}: {iterations} iterations, {of_contact} of the contact, {evaluations} evaluations");
    at
}

/// Both ways to find an equilibrium lead to the same.
#[test]
fn a_block_that_is_pulled_slides_at_mu_times_its_pressure() {
    for law in laws() {
        let ends = [FrictionPressure::Lagged, FrictionPressure::Current].map(|friction| {
            let mut ratios = Vec::new();
            let at = pulled(block(law, 0.0), friction, Path { steps: 10, ..Path::default() }, &mut |at| {
                let friction = at.balance().contact.friction;
                println!("{:.3}: {:.9} {friction:?}", at.load(), ratio(at));
                assert!(friction.dissipated >= 0.0);
                ratios.push(ratio(at));
            });
            // The residual of 1e-10 is that of all forces, of which friction is about a hundredth; patches are found to it
            // in turns.
            assert!(ratios.windows(2).all(|pair| pair[1] > pair[0] - 1e-7 * MU), "{ratios:?}");
            assert!(at.balance().contact.friction.stick_area == 0.0);
            assert!((ratio(&at) - MU).abs() < 1e-7 * MU, "{}", ratio(&at));
            assert_eq!(at.halvings, 0);
            (ratios, at.displacement().to_vec())
        });
        let [lagged, current] = &ends;
        lagged.0.iter().zip(&current.0).for_each(|(p, q)| assert!((p - q).abs() < 1e-7, "{p} and {q}"));
        let apart = lagged.1.iter().flatten().zip(current.1.iter().flatten()).map(|(p, q)| (p - q).abs());
        // Residuals of 1e-10 of the forces move nodes by 1e-10 of the displacements, times the condition of the contact.
        let largest = apart.fold(0.0, f64::max);
        assert!(largest < 1e-8 * PULL, "{largest:e}");
    }
}

/// Steps that fail leave no trace: the loads that were reached lead to the same state when they are gone to straight. The
/// block is neo-Hookean, and two solves are too little for long steps.
#[test]
fn steps_that_are_cut_back_change_nothing() {
    let soft = || {
        let mut problem = block(EnergyLaw::depth(16e3), 0.0);
        let mut part = problem.model.parts()[0].clone();
        part.material.law = Law::NeoHookean;
        problem.model = Model::new(vec![part]).unwrap();
        problem
    };
    let watch: &mut dyn FnMut(&_) -> _ = &mut |_| ControlFlow::Continue(());
    for friction in [FrictionPressure::Lagged, FrictionPressure::Current] {
        let start = || {
            let mut at = Equilibrium::new(soft()).unwrap();
            at.settings.friction = friction;
            at.follow(Path { steps: 4, ..Path::default() }, &mut |_| ControlFlow::Continue(())).unwrap();
            at
        };
        let mut cut = start();
        let before = cut.halvings;
        let supports = held(cut.model(), PULL);
        cut.next_stage(supports).unwrap();
        let (settings, path) = (cut.settings, Path { steps: 2, ..Path::default() });
        cut.settings.most_iterations = 2;
        let mut loads = Vec::new();
        let end = cut.follow_telling(path, watch, &mut |at| loads.push(at.load()));
        // Frozen friction takes nearly as many solves in a short step as in a long one: after steps of all lengths have failed, enough.
        assert_eq!(end.is_err(), friction == FrictionPressure::Lagged, "{end:?}");
        cut.settings = settings;
        cut.follow_telling(path, watch, &mut |at| loads.push(at.load())).unwrap();
        println!("{friction:?}: {} halvings, loads {loads:?}", cut.halvings);
        assert!(cut.halvings > before, "no step failed");
        let mut straight = start();
        for load in loads {
            let supports = held(straight.model(), load * PULL);
            straight.next_stage(supports).unwrap();
            straight.follow(Path { most_halvings: 0, ..Path::default() }, watch).unwrap();
        }
        let apart = |p: &[[f64; 2]], q: &[[f64; 2]]| {
            p.iter().flatten().zip(q.iter().flatten()).map(|(p, q)| (p - q).abs()).fold(0.0, f64::max)
        };
        let displacements = apart(cut.displacement(), straight.displacement());
        assert!(displacements < 1e-8 * PULL, "{displacements:e}");
        let (p, q) = (ratio(&cut), ratio(&straight));
        assert!((p - q).abs() < 1e-7, "{p} and {q}");
    }
}

#[test]
fn what_it_cannot_solve_is_refused() {
    let friction = Friction { memoryless_slip: Some(1e-3), ..Friction::coulomb(MU) };
    let mut problem = block(laws()[0], PULL);
    problem.contact.friction = friction;
    let refused = Equilibrium::new(problem).err().expect("refused").to_string();
    assert!(refused.contains("friction without memory"), "{refused}");
}
