//! Contact that becomes stiffer within a step: pressures, tractions and work are those of the step all the same.

use crate::scene::Scene;
use crate::{begun, in_plane, in_space, laws, raised, slid};
use fmc_contact::{Contact, EnergyLaw, Options};

const DELTA: f64 = 1e-3;

/// Work of friction by force times way, of the upper block that slides to `end`.
fn work_of<const D: usize>(contact: &mut Contact<D>, end: &[[f64; D]], way: f64) -> f64 {
    let found = contact.evaluate(end).expect("forces");
    found.friction.dissipated / (found.bodies[1].friction[0].abs() * way)
}

/// The blocks just touch, pressed by multipliers, and the search finds that it has to be stiffer.
fn moved_out<const D: usize>(scene: &Scene<D>, options: Options, factor: f64, way: f64) -> f64 {
    let mut contact = begun(scene, options, &scene.coords);
    contact.augment(&scene.coords, 0.1, 0.0).expect("multipliers");
    contact.commit_step(&scene.coords).expect("a step");
    let touching = raised(scene, DELTA);
    contact.commit_step(&touching).expect("a step");
    let mut end = slid(scene, way);
    end.iter_mut().zip(&touching).for_each(|(x, touching)| x[D - 1] = touching[D - 1]);
    contact.evaluate(&end).expect("forces");
    contact.stiffen(factor).expect("a stiffness");
    work_of(&mut contact, &end, way)
}

/// They penetrate; the host makes the law stiffer, and they press with the same force less deep.
fn penetrating<const D: usize>(scene: &Scene<D>, options: Options, factor: f64, way: f64) -> f64 {
    let mut contact = begun(scene, options, &scene.coords);
    contact.commit_step(&slid(scene, 0.01)).expect("a step");
    contact.set_options(Options { law: stiffer(options.law, factor), ..options }).expect("options");
    let higher = raised(scene, DELTA * (1.0 - 1.0 / factor));
    let mut end = slid(scene, 0.01 + way);
    end.iter_mut().zip(&higher).for_each(|(x, higher)| x[D - 1] = higher[D - 1]);
    work_of(&mut contact, &end, way)
}

fn stiffer(law: EnergyLaw, factor: f64) -> EnergyLaw {
    match law {
        EnergyLaw::Depth { stiffness } => EnergyLaw::depth(factor * stiffness),
        EnergyLaw::Fiber(law) => EnergyLaw::fiber(factor * law.stiffness),
        other => other,
    }
}

fn all<const D: usize>(scene: &Scene<D>) {
    for options in laws(0.3) {
        for factor in [4.0, 16.0, 0.5] {
            let way = 0.1;
            let found = [moved_out(scene, options, factor, way), penetrating(scene, options, factor, way)];
            // An elastic slip of 3e-4 by a way of 0.1, which is gone back to the stiffness of now, and rims as wide as the penetration.
            assert!(found.iter().all(|work| (work - 1.0).abs() < 1e-2), "{factor}: {found:?} {:?}", options.law);
        }
    }
}

#[test]
fn the_work_of_a_step_is_that_of_its_pressures() {
    in_plane(DELTA).iter().for_each(all);
    in_space(DELTA).iter().for_each(all);
}
