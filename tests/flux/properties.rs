//! What holds for every flux.

use crate::scene::Scene;
use crate::{dot, field, flux, in_space, in_the_plane, largest, out_of, pressed};
use fmc_contact::contact::{Conductance, FluxRequest};
use fmc_contact::{EnergyLaw, Options};
use fmc_shapes::rectangle_quad4;

fn tables() -> Conductance {
    Conductance { by_pressure: vec![[0.0, 1.0], [1.0, 4.0], [2.0, 5.0]], by_gap: vec![[0.0, 1.0], [0.1, 0.4]] }
}

fn wave(count: usize, seed: f64) -> Vec<f64> {
    (0..count).map(|node| (seed + 1.7 * node as f64).sin()).collect()
}

/// Bodies bent, so that part of them is pressed and part of them apart.
fn bent<const D: usize>(scene: &Scene<D>) -> Vec<[f64; D]> {
    let lift = |mesh: usize, x: &[f64; D]| if mesh == 1 { 0.03 * (2.0 * x[0] - 1.0) * x[D - 1] } else { 0.0 };
    let lifts = field(scene, lift);
    let lifted = |(x, lift): (&[f64; D], f64)| std::array::from_fn(|i| if i + 1 == D { x[i] + lift } else { x[i] });
    scene.coords.iter().zip(lifts).map(lifted).collect()
}

fn holds<const D: usize>(scenes: &[Scene<D>]) {
    for scene in scenes {
        let (contact, coords, count) = (pressed(scene), bent(scene), scene.coords.len());
        let (one, two) = (wave(count, 0.3), wave(count, 4.1));
        let found = flux(&contact, &coords, &one, &tables());
        let size: f64 = found.flux.iter().map(|q| q.abs()).sum();
        assert!(size > 0.1, "nothing flows");
        // What leaves one body enters the other.
        assert!(found.flux.iter().sum::<f64>().abs() < 1e-14 * size && out_of(scene, &found, 0).abs() > 1e-3 * size);
        // Symmetric, and heat flows from warm to cold.
        let other = flux(&contact, &coords, &two, &tables());
        assert!((dot(&two, &found.flux) - dot(&one, &other.flux)).abs() < 1e-13 * size);
        assert!(dot(&one, &found.flux) > 0.0 && dot(&two, &other.flux) > 0.0);
        // The matrix is the derivative: the flux is linear in the field.
        let by = |row: usize| {
            let range = found.matrix.offsets[row]..found.matrix.offsets[row + 1];
            range.map(|entry| found.matrix.values[entry] * two[found.matrix.cols[entry] as usize]).sum::<f64>()
        };
        let step = 0.25;
        let moved: Vec<f64> = one.iter().zip(&two).map(|(a, b)| a + step * b).collect();
        let moved = flux(&contact, &coords, &moved, &tables()).flux;
        let off: Vec<f64> = (0..count).map(|row| (moved[row] - found.flux[row]) / step - by(row)).collect();
        assert!(largest(&off) < 1e-12 * size, "{:e}", largest(&off));
        // Rows ascend, and there is one for every node.
        assert_eq!(found.matrix.offsets.len(), count + 1);
        let ascend = |row: usize| {
            let range = found.matrix.offsets[row]..found.matrix.offsets[row + 1];
            found.matrix.cols[range].windows(2).all(|two| two[0] < two[1])
        };
        assert!((0..count).all(ascend));
        // Of what is equal everywhere nothing flows, to the bit.
        let equal = flux(&contact, &coords, &vec![293.15; count], &tables());
        assert!(equal.flux.iter().all(|q| *q == 0.0));
    }
}

#[test]
fn heat_is_kept_and_flows_from_warm_to_cold() {
    holds(&in_the_plane(-0.01));
    // Each type of cell with two others.
    holds(&in_space(-0.01).into_iter().step_by(5).collect::<Vec<_>>());
}

/// The same field on both sides has no jump: of one that is linear all that flows is rounding, whatever the cells.
#[test]
fn a_linear_field_common_to_both_bodies_flows_nowhere() {
    fn none<const D: usize>(scenes: &[Scene<D>]) {
        for scene in scenes {
            let values = field(scene, |_, x| 3.0 + 2.0 * x[0] - if D == 3 { x[1] } else { 0.0 });
            let found = flux(&pressed(scene), &scene.coords, &values, &Conductance::constant(10.0));
            assert!(largest(&found.flux) < 1e-13, "{:e}", largest(&found.flux));
        }
    }
    none(&in_the_plane(-0.01));
    none(&in_space(-0.01));
    none(&in_space(0.0).into_iter().step_by(5).collect::<Vec<_>>());
}

/// Several fields at once are those alone, and threads change no bit.
#[test]
fn fields_are_independent_and_threads_change_nothing() {
    let scene = &in_space(-0.01)[3];
    let (coords, count) = (bent(scene), scene.coords.len());
    let fields: Vec<f64> = wave(count, 0.1).into_iter().chain(wave(count, 2.0)).collect();
    let request = FluxRequest { fields: &fields, of_obstacles: None, conductance: &tables() };
    let both = pressed(scene).flux(&coords, &request).expect("fluxes");
    for (number, alone) in fields.chunks_exact(count).enumerate() {
        assert_eq!(flux(&pressed(scene), &coords, alone, &tables()).flux, both.flux[number * count..][..count]);
    }
    for threads in [1, 3] {
        let contact = scene.contact(Options { threads, ..Options::new(EnergyLaw::depth(crate::K)) });
        assert_eq!(contact.flux(&coords, &request).expect("fluxes"), both);
    }
}

/// The order of bodies changes nothing but rounding, since neither is the master.
#[test]
fn neither_body_is_the_master() {
    let below = rectangle_quad4([0.0, 0.0], [1.0, 0.5], [2, 1]);
    let above = rectangle_quad4([0.2, 0.49], [0.9, 1.0], [3, 1]).mapped(|[x, y]| [x, y + 0.02 * x * y]);
    let (one, two) = (Scene::of(&[&below, &above]), Scene::of(&[&above, &below]));
    let values = |scene: &Scene<2>| field(scene, |_, x| (3.0 * x[0] + x[1]).sin());
    let [here, there] = [&one, &two].map(|scene| flux(&pressed(scene), &scene.coords, &values(scene), &tables()).flux);
    let off: Vec<f64> = one.nodes_of(0).map(|node| here[node] - there[two.nodes_of(1).start + node]).collect();
    assert!(largest(&off) < 1e-14 && largest(&here) > 1e-3);
}

/// A body that is bent until its ends touch conducts from one to the other.
#[test]
fn a_body_conducts_to_itself() {
    let strip = rectangle_quad4([0.0, 0.0], [1.0, 1.0], [24, 1]);
    // A letter C, open, and then closed until its ends pass into one another.
    let bent = |turns: f64| {
        move |[s, t]: [f64; 2]| {
            let (radius, angle) = (1.0 + 0.3 * t, -std::f64::consts::TAU * turns * s);
            [radius * angle.cos(), radius * angle.sin()]
        }
    };
    let scene = Scene::of(&[&strip]).mapped(bent(0.95));
    let coords: Vec<[f64; 2]> = strip.coords.iter().copied().map(bent(1.003)).collect();
    let contact = scene.contact(Options { self_contact: true, ..Options::new(EnergyLaw::depth(100.0)) });
    let values: Vec<f64> = strip.coords.iter().map(|[s, _]| *s).collect();
    let found = flux(&contact, &coords, &values, &Conductance::constant(2.0));
    let out: f64 = strip.coords.iter().zip(&found.flux).filter(|([s, _], _)| *s > 0.5).map(|(_, q)| q).sum();
    // A jump of 1 across an end of 0.3.
    assert!((out - 0.6).abs() < 1e-3, "{out}");
    assert!(found.flux.iter().sum::<f64>().abs() < 1e-14);
}
