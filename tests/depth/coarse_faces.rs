//! Curved faces whose cells are coarse: told where they are known no better than the penetration.

use crate::curves::ring;
use crate::depth;
use crate::scene::Scene;
use fmc_contact::overlap::{Partner, Smoothing};
use fmc_contact::{ContactForces, EnergyLaw, Warning};
use fmc_shapes::{rectangle_quad4, second_order};
use std::f64::consts::TAU;

/// Error and penetration.
fn told<const D: usize>(found: &ContactForces<D>) -> Option<[f64; 2]> {
    found.warnings.iter().find_map(|warning| match warning {
        &Warning::CoarseFaces { a: Partner::Body(0), b: Partner::Body(1), error, penetration } => {
            Some([error, penetration])
        }
        _ => None,
    })
}

/// Rigid rings of n on m facets around a circle of radius `size`, that overlap by δ everywhere.
fn rings([n, m]: [usize; 2], nodes: usize, delta: f64, size: f64) -> ContactForces<2> {
    let mut parts = [ring(0.5, 1.0 + delta, [n, 2], nodes, 0.03), ring(1.0, 1.5, [m, 2], nodes, 0.0)];
    parts.iter_mut().flat_map(|part| &mut part.coords).flatten().for_each(|x| *x *= size);
    let scene = Scene::of(&[&parts[0], &parts[1]]);
    let mut contact = scene.contact(depth(1.0));
    contact.set_surface_smoothing(if nodes == 4 { 40.0 } else { 0.0 }).expect("an angle");
    contact.evaluate(&scene.coords).expect("valid coordinates")
}

/// Rings should be δ deep everywhere: what is deeper is the error of the surfaces, and the estimate is that, from half of it to 2.5 times.
#[test]
fn the_error_of_rings_is_estimated() {
    for nodes in [9, 8, 4] {
        for counts in [[12, 16], [16, 20], [20, 28], [32, 44], [64, 84]] {
            let angle = TAU / counts[0] as f64;
            let delta = angle.powi(4) / 200.0;
            for size in [1.0, 1e3] {
                let found = rings(counts, nodes, delta, size);
                let [error, penetration] = told(&found).expect("a warning");
                let measured = found.pairs[0].penetration - delta * size;
                assert!((0.5..2.5).contains(&(error / measured)), "{nodes} {counts:?}: {error:e} for {measured:e}");
                assert!(
                    penetration > 0.5 * delta * size && penetration < found.pairs[0].penetration,
                    "{penetration:e}"
                );
            }
        }
    }
}

/// The fourth power of the angle decides, by the penetration, and no length by itself.
#[test]
fn fine_rings_and_deep_ones_are_not_told() {
    for nodes in [9, 4] {
        for (counts, delta, is_told) in [
            ([16, 20], 1e-4, true),
            ([16, 20], 2e-3, false),
            ([32, 44], 1e-5, true),
            ([32, 44], 1e-4, false),
            ([32, 44], 1e-2, false),
            ([64, 84], 1e-5, false),
        ] {
            for size in [1e-3, 1.0, 1e3] {
                let found = rings(counts, nodes, delta, size);
                assert_eq!(
                    told(&found).is_some(),
                    is_told,
                    "{nodes} {counts:?} {delta:e} {size:e}: {:?}",
                    found.warnings
                );
            }
        }
    }
}

/// Flat faces of second order, and smoothed ones, are known, however little they penetrate; so is a curved face on a flat one.
#[test]
fn flat_faces_are_not_told() {
    for nodes in [4, 9] {
        let block = |from: [f64; 2], to: [f64; 2], cells| {
            let straight = rectangle_quad4(from, to, cells);
            if nodes == 4 { straight } else { second_order(&straight, nodes) }
        };
        let mut upper = block([0.0, 0.0], [1.0, 1.0], [3, 3]);
        // Curved walls at the sides, which touch nothing.
        for x in upper.coords.iter_mut().filter(|x| x[0] == 0.0) {
            x[0] -= 0.3 * x[1] * (1.0 - x[1]);
        }
        let scene = Scene::of(&[&upper, &block([-1.0, -1.0], [2.0, 1e-7], [5, 2])]);
        let mut contact = scene.contact(depth(1.0));
        contact.set_surface_smoothing(if nodes == 4 { 30.0 } else { 0.0 }).expect("an angle");
        let found = contact.evaluate(&scene.coords).expect("valid coordinates");
        assert!(found.volume > 0.0 && told(&found).is_none(), "{nodes}: {:?}", found.warnings);
    }
    let floor = rectangle_quad4([-2.0, -3.0], [2.0, 1e-3 - 1.0], [8, 4]);
    for nodes in [4, 9] {
        let disc = ring(0.5, 1.0, [32, 2], nodes, 0.0);
        let scene = Scene::of(&[&disc, &floor]);
        let mut contact = scene.contact(depth(1.0));
        contact.set_surface_smoothing(if nodes == 4 { 30.0 } else { 0.0 }).expect("an angle");
        let found = contact.evaluate(&scene.coords).expect("valid coordinates");
        assert!(found.volume > 0.0 && told(&found).is_none(), "{nodes}: {:?}", found.warnings);
    }
}

/// Where facets meet at more than the angle of the smoothing, raising it helps.
#[test]
fn an_angle_that_is_too_small_is_told() {
    let scene = Scene::of(&[&ring(0.5, 1.0 + 1e-3, [32, 2], 4, 0.0), &ring(1.0, 1.5, [44, 2], 4, 0.0)]);
    let mut contact = scene.contact(depth(1.0));
    for (angle, expected, said) in [
        (0.0, Some(Smoothing::NotSet), "set_surface_smoothing measures"),
        (5.0, Some(Smoothing::AngleTooSmall), "raise the angle"),
        (30.0, None, ""),
    ] {
        contact.set_surface_smoothing(angle).expect("an angle");
        let found = contact.evaluate(&scene.coords).expect("valid coordinates");
        let remedies = found.warnings.iter().find_map(|w| match w {
            Warning::CurvedFaces { remedy, .. } => Some((*remedy, w.to_string())),
            _ => None,
        });
        assert_eq!(remedies.as_ref().map(|(remedy, _)| *remedy), expected, "{angle}");
        assert!(remedies.is_none_or(|(_, text)| text.contains(said)), "{angle}");
    }
}

/// Another law than `depth` does not read the smoothing, and says so.
#[test]
fn smoothing_that_has_no_effect_is_told() {
    let scene = Scene::of(&[&ring(0.5, 1.0 + 1e-2, [16, 2], 4, 0.0), &ring(1.0, 1.5, [24, 2], 4, 0.0)]);
    let unused = Warning::UnusedSmoothing { a: Partner::Body(0), b: Partner::Body(1) };
    for (law, reads) in [(EnergyLaw::fiber(1.0), false), (EnergyLaw::depth(1.0), true)] {
        let mut contact = scene.contact(crate::scene::table::exactly(law));
        for (angle, is_told) in [(0.0, false), (30.0, !reads), (0.0, false)] {
            contact.set_surface_smoothing(angle).expect("an angle");
            let found = contact.evaluate(&scene.coords).expect("valid coordinates");
            assert_eq!(found.warnings.contains(&unused), is_told, "{law:?} {angle}: {:?}", found.warnings);
        }
    }
}
