//! Traction and opening of two blocks that are pulled apart, in closed form.

use crate::scene::Scene;
use crate::{held, in_space, in_the_plane, law, moved};
use fmc_contact::contact::{Cohesive, PairOptions, Softening};
use fmc_contact::overlap::Partner::Body;
use fmc_contact::{Contact, EnergyLaw, Options};
use fmc_shapes::rectangle_quad4;
use std::f64::consts::TAU;

/// What the closed form says of a mode: `angle` 0 pulls apart, 90° slides.
struct Mode {
    /// Ratio of sliding to opening, and stiffness along the way.
    stiffness: [f64; 2],
    /// Way at which damage begins, and at which it ends.
    onset: f64,
    end: f64,
    energy: f64,
}

fn mode(law: &Cohesive, stiffness: f64, angle: f64) -> Mode {
    let (c, s) = (angle.cos(), angle.sin());
    let ratio = law.shear_strength / law.normal_strength;
    let stiffness = [stiffness, stiffness * law.normal_energy / law.shear_energy * ratio * ratio];
    // Energies of both modes where they break alone, and mixed by Benzeggagh and Kenane.
    let part = stiffness[1] * s * s / (stiffness[0] * c * c + stiffness[1] * s * s);
    let mixed = |n: f64, t: f64| n + (t - n) * part.powf(law.exponent);
    let energy = mixed(law.normal_energy, law.shear_energy);
    let of = |strength: f64, k: f64| strength * strength / (2.0 * k);
    let started = mixed(of(law.normal_strength, stiffness[0]), of(law.shear_strength, stiffness[1]));
    let along = stiffness[0] * c * c + stiffness[1] * s * s;
    let onset = (2.0 * started / along).sqrt();
    // A triangle with this area.
    Mode { stiffness, onset, end: 2.0 * energy / (along * onset), energy }
}

/// By how much stiffness falls at a way, without and after softening.
fn left(mode: &Mode, softening: Softening, way: f64) -> f64 {
    let (d0, d1) = (mode.onset, mode.end);
    match softening {
        _ if way <= d0 => 1.0,
        Softening::Linear => (d0 / way * (d1 - way) / (d1 - d0)).max(0.0),
        // An exponential with the same area: d0/2 + (the rest).
        Softening::Exponential | Softening::Ppr(_) => d0 / way * (-(way - d0) / (0.5 * (d1 - d0))).exp(),
    }
}

/// Forces by area on the second body, as means.
fn pulled<const D: usize>(contact: &Contact<D>, scene: &Scene<D>, area: f64, by: [f64; D]) -> [f64; D] {
    let found = contact.evaluate(&moved(scene, by)).expect("an evaluation");
    let sum = |axis: usize| found.forces[scene.first_node[1]..].iter().map(|f| f[axis]).sum::<f64>();
    std::array::from_fn(|axis| -sum(axis) / area)
}

/// Along a way: first the closed form, then the work by its trapezoids, which is exact for lines between their ends.
fn follows<const D: usize>(scene: &Scene<D>, (contact, area): (&mut Contact<D>, f64), law: &Cohesive, angle: f64) {
    let mode = mode(law, 50.0 * law.normal_strength.powi(2) / law.normal_energy, angle);
    let by = |way: f64| -> [f64; D] {
        std::array::from_fn(|axis| match axis {
            0 => way * angle.sin(),
            _ if axis == D - 1 => way * angle.cos(),
            _ => 0.0,
        })
    };
    contact.begin_step(&scene.coords).expect("a step");
    let (mut work, mut of_sliding, mut last) = (0.0, 0.0, ([0.0; 2], 0.0));
    let grid = 12;
    let mut ways: Vec<f64> = (0..=grid).map(|k| mode.onset * f64::from(k) / f64::from(grid)).collect();
    ways.extend((1..=grid).map(|k| mode.onset + (mode.end - mode.onset) * f64::from(k) / f64::from(grid)));
    ways.push(1.3 * mode.end);
    for way in ways {
        let found = pulled(contact, scene, area, by(way));
        let whole = left(&mode, law.softening, way);
        let expected = [mode.stiffness[0] * way * angle.cos() * whole, mode.stiffness[1] * way * angle.sin() * whole];
        let pair = [found[D - 1], found[0]];
        for (found, expected) in pair.iter().zip(expected) {
            // Rounding of coordinates of 1 by a stiffness of 1e3.
            assert!((found - expected).abs() < 1e-10, "{found} for {expected} at {way}, {angle}");
        }
        let step = way - last.1;
        of_sliding += 0.5 * (pair[1] + last.0[1]) * step * angle.sin();
        work += 0.5 * ((pair[0] + last.0[0]) * angle.cos() + (pair[1] + last.0[1]) * angle.sin()) * step;
        last = (pair, way);
        let told = contact.cohesive([0, 1], &moved(scene, by(way))).expect("bodies").expect("an interface");
        let energy = contact.evaluate(&moved(scene, by(way))).expect("an evaluation").energy;
        assert!((told.stored + told.dissipated - energy).abs() < 1e-12 && told.stored >= 0.0);
        if law.softening == Softening::Linear {
            assert!((energy - work * area).abs() < 1e-11 * area, "{energy} for {work} at {way}");
        }
    }
    if law.softening == Softening::Linear {
        // The mode by the work itself, and the energy that Benzeggagh and Kenane say of it.
        let mixed = law.normal_energy + (law.shear_energy - law.normal_energy) * (of_sliding / work).powf(law.exponent);
        assert!((work - mixed).abs() < 1e-10 && (work - mode.energy).abs() < 1e-10, "{work} for {mixed}");
        let told = contact.cohesive([0, 1], &moved(scene, by(1.3 * mode.end))).expect("bodies").expect("an interface");
        let lost = told.dissipated - mode.energy * area;
        assert!(lost.abs() < 1e-10 && told.stored < 1e-24, "{lost:e}, {:e}", told.stored);
        assert!((told.broken_area - area).abs() < 1e-12 && (told.area - area).abs() < 1e-12);
    }
}

#[test]
fn blocks_that_are_pulled_apart_follow_the_closed_form() {
    let exponential = Cohesive { softening: Softening::Exponential, ..law() };
    for law in [law(), exponential, Cohesive { exponent: 1.0, ..law() }, Cohesive::new(2.0, 0.1)] {
        for angle in [0.0, 0.3, 0.8, 1.3, 0.25 * TAU] {
            for scene in in_the_plane(0.0) {
                follows(&scene, (&mut held(&scene, law), 1.0), &law, angle);
            }
            if angle == 0.8 {
                for scene in in_space(0.0) {
                    follows(&scene, (&mut held(&scene, law), 1.0), &law, angle);
                }
            }
        }
    }
}

/// A gap within reach is none: it stays as it is.
#[test]
fn a_gap_is_kept() {
    let law = Cohesive { reach: 0.1, ..law() };
    for scene in in_the_plane(0.03) {
        let mut contact = held(&scene, law);
        assert!(
            (contact.cohesive([0, 1], &scene.coords).expect("bodies").expect("one").largest_gap - 0.03).abs() < 1e-15
        );
        follows(&scene, (&mut contact, 1.0), &law, 0.8);
    }
}

/// A ring on a ring: π (R² − r²).
#[test]
fn rings_have_their_area() {
    let below = rectangle_quad4([1.0, 0.0], [2.0, 0.5], [2, 1]);
    let scene = Scene::of(&[&below, &rectangle_quad4([1.0, 0.5], [2.0, 1.0], [3, 1])]);
    let mut contact = scene.contact(Options { axisymmetric: true, ..Options::new(EnergyLaw::depth(1.0)) });
    contact.set_pair_options([0, 1].map(Body), Some(PairOptions::with_cohesive(law()))).expect("an interface");
    follows(&scene, (&mut contact, 0.5 * TAU * 3.0), &law(), 0.0);
}

/// Pressed together, it is as stiff as it was, whatever it has been through.
#[test]
fn compression_is_carried_undamaged() {
    let scene = &in_the_plane(0.0)[0];
    let mut contact = held(scene, law());
    let stiffness = 50.0 * 4.0 / 0.1;
    let at = |contact: &Contact<2>| pulled(contact, scene, 1.0, [0.0, -1e-3]);
    assert!((at(&contact)[1] + 1e-3 * stiffness).abs() < 1e-10);
    contact.begin_step(&scene.coords).expect("a step");
    for way in [0.05, 0.2] {
        contact.commit_step(&moved(scene, [0.0, way])).expect("a step");
        assert!((at(&contact)[1] + 1e-3 * stiffness).abs() < 1e-10);
        // What slides while it is pressed is as damaged as ever.
        let slid = pulled(&contact, scene, 1.0, [1e-4, -1e-3]);
        assert!((slid[1] + 1e-3 * stiffness).abs() < 1e-10 && slid[0] < 0.6 * 1e-4 * stiffness);
    }
}
