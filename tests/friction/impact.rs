//! Energy of bodies that strike, stick and leave: all that is lost is told.

use crate::scene::Scene;
use crate::{begun, laws};
use fmc_contact::{EnergyLaw, Options};
use fmc_shapes::{Mesh, disc_tri3, rectangle_quad4};

/// Two rigid bodies of a scene in the plane: centre and angle of each, and their velocities.
type Motion = [[f64; 3]; 2];

/// Area and moment of inertia of a disc of triangles about its centre.
fn inertia(disc: &Mesh<2>) -> [f64; 3] {
    let (mut area, mut turned) = (0.0, 0.0);
    for triangle in disc.conn.chunks(3) {
        let [a, b, c] = [0, 1, 2].map(|k| disc.coords[triangle[k] as usize]);
        let part = 0.5 * ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]));
        area += part;
        let dot = |x: [f64; 2], y: [f64; 2]| x[0] * y[0] + x[1] * y[1];
        turned += part / 6.0 * (dot(a, a) + dot(b, b) + dot(c, c) + dot(a, b) + dot(b, c) + dot(c, a));
    }
    [area, area, turned]
}

fn placed(scene: &Scene<2>, at: &Motion) -> Vec<[f64; 2]> {
    let mut coords = scene.coords.clone();
    for (mesh, [x, y, angle]) in at.iter().enumerate() {
        let (sin, cos) = angle.sin_cos();
        for node in scene.nodes_of(mesh) {
            let [a, b] = scene.coords[node];
            coords[node] = [x + cos * a - sin * b, y + sin * a + cos * b];
        }
    }
    coords
}

/// Energy that is not told, and that is lost, by the energy at the start, of an oblique impact of two discs of 24 edges, in central
/// differences.
fn impact(options: Options, step: f64) -> [f64; 2] {
    let disc = disc_tri3(1.0, 24);
    let scene = Scene::of(&[&disc, &disc]);
    let mass = [inertia(&disc); 2];
    let (mut at, mut speed) = ([[-0.86, 0.0, 0.3], [1.0, 0.8, 0.1]], [[5.0, 0.0, 0.0], [0.0; 3]]);
    let mut contact = begun(&scene, options, &placed(&scene, &at));
    let kinetic = |speed: &Motion| -> f64 {
        speed.iter().zip(&mass).flat_map(|(v, m)| v.iter().zip(m)).map(|(v, m)| 0.5 * m * v * v).sum()
    };
    let start = kinetic(&speed);
    let (mut lost, mut forces, mut stored, mut touched) = (0.0, [[0.0; 3]; 2], 0.0, false);
    for _ in 0..10_000 {
        let half = |speed: &mut Motion, forces: &Motion| {
            for (body, v) in speed.iter_mut().enumerate() {
                (0..3).for_each(|k| v[k] += 0.5 * step * forces[body][k] / mass[body][k]);
            }
        };
        half(&mut speed, &forces);
        at.iter_mut().zip(&speed).for_each(|(x, v)| (0..3).for_each(|k| x[k] += step * v[k]));
        let coords = placed(&scene, &at);
        let found = contact.evaluate(&coords).expect("forces");
        contact.commit_step(&coords).expect("a step");
        forces = std::array::from_fn(|body| {
            let resultant = &found.bodies[body];
            let [x, y] = resultant.force;
            [x, y, resultant.moment[2] - at[body][0] * y + at[body][1] * x]
        });
        half(&mut speed, &forces);
        assert!(found.friction.dissipated >= 0.0);
        lost += found.friction.dissipated;
        stored = found.energy + found.friction.stored;
        touched |= found.friction.stored > 0.0;
        if touched && stored == 0.0 {
            break;
        }
    }
    assert!(touched && stored == 0.0, "the discs have struck and parted");
    let missing = start - kinetic(&speed);
    [(missing - lost) / start, missing / start]
}

/// Few facets, of which each is a large part of the contact, and leaves it with what it has stored.
#[test]
fn all_that_an_impact_loses_is_told() {
    for coefficient in [0.05, 0.2, 0.5, 1.0] {
        let mut options = laws(coefficient)[0];
        options.law = EnergyLaw::depth(1e5);
        let [[coarse, _], [fine, lost]] = [2e-4, 5e-5].map(|step| impact(options, step));
        println!("{coefficient}: {coarse:.2e} {fine:.2e} of {lost:.4}");
        // Of second order in the step; 65 % of what is lost was not told at a coefficient of 1.
        assert!(lost > 0.02 && fine.abs() < 3e-6, "{coefficient}: {fine} of {lost}");
        assert!(fine.abs() < 0.2 * coarse.abs() || fine.abs() < 3e-7, "{coefficient}: {coarse} {fine}");
    }
}

/// What is stored in a pair that parts within a step, or in some facets of one, is lost by then.
#[test]
fn what_leaves_loses_what_it_has_stored() {
    let table = |left: f64| rectangle_quad4([left, -1.0], [left + 1.0, 0.0], [1, 1]);
    let block = rectangle_quad4([-0.5, -1e-3], [0.5, 1.0], [2, 2]);
    // On two tables, each under one facet of the block.
    let scene = Scene::of(&[&table(-1.0), &table(0.0), &block]);
    let moved = |[x, left, right]: [f64; 3]| {
        let mut coords = scene.coords.clone();
        scene.nodes_of(2).for_each(|node| coords[node][0] += x);
        scene.nodes_of(0).for_each(|node| coords[node][1] -= left);
        scene.nodes_of(1).for_each(|node| coords[node][1] -= right);
        coords
    };
    for options in laws(5.0) {
        let mut contact = begun(&scene, options, &scene.coords);
        contact.commit_step(&moved([1e-4, 0.0, 0.0])).expect("a step");
        let stored = |[left, right]: [f64; 2]| {
            let found = contact.evaluate(&moved([1e-4, left, right])).expect("forces").friction;
            (found.stored, found.dissipated)
        };
        let (whole, nothing) = stored([0.0, 0.0]);
        assert!(whole > 0.0 && nothing < 1e-12 * whole, "{options:?}: {whole} {nothing}");
        for apart in [[2e-3, 0.0], [0.0, 2e-3], [2e-3, 2e-3]] {
            let (kept, lost) = stored(apart);
            assert!((kept + lost - whole).abs() < 1e-9 * whole, "{options:?} {apart:?}: {kept} {lost} of {whole}");
            assert!(kept < 0.6 * whole && (kept == 0.0) == (apart == [2e-3, 2e-3]));
        }
        // Also where friction is frozen.
        contact.freeze_friction(&moved([1e-4, 2e-3, 0.0])).expect("a step has begun");
        let frozen = contact.evaluate(&moved([1e-4, 2e-3, 0.0])).expect("forces").friction;
        assert!((frozen.stored + frozen.dissipated - whole).abs() < 1e-9 * whole, "{options:?}: {frozen:?} of {whole}");
    }
}
