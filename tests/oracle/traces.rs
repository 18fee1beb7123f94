//! The fibers that are shown are those that were counted.

use crate::membership::cover;
use crate::scene::{Scene, consistent_lines, isotropic};
use fmc_contact::overlap::FiberTrace;
use fmc_shapes::{Mesh, random_polygon, random_polyhedron};

fn length<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
}

/// A point this far along a piece.
fn between<const D: usize>(a: &[f64; D], b: &[f64; D], s: f64) -> [f64; D] {
    std::array::from_fn(|i| a[i] + s * (b[i] - a[i]))
}

fn traces_are_what_is_counted<const D: usize>(a: &Mesh<D>, b: &Mesh<D>, spacing: f64) {
    let scene = Scene::of(&[a, b]);
    let contact = scene.contact(consistent_lines(spacing, 3));
    let traces: Vec<FiberTrace<D>> = contact.trace(&scene.coords).unwrap();
    let found = contact.evaluate(&scene.coords).unwrap();
    assert_eq!(traces.iter().map(|t| t.crossings.len()).sum::<usize>(), found.crossing_count);
    let mut sum = 0.0;
    for trace in &traces {
        // Crossings lie in order between the ends, and bound spans in turn.
        let place = |x: &[f64; D]| length(&trace.start, x);
        assert!(trace.crossings.windows(2).all(|w| place(&w[0]) <= place(&w[1])));
        assert!(
            trace
                .crossings
                .iter()
                .all(|x| { (place(x) + length(x, &trace.end) - length(&trace.start, &trace.end)).abs() < 1e-12 })
        );
        for span in trace.crossings.chunks(2) {
            sum += length(&span[0], &span[1]);
            // Inside both bodies within the span, and not beyond its ends; but for spans as short as rounding, and for
            // points within rounding of an inner face, in no open cell at all.
            if length(&span[0], &span[1]) > 1e-6 {
                let covers = |s: f64| {
                    let x = between(&span[0], &span[1], s);
                    (cover(a, &x), cover(b, &x))
                };
                assert_eq!(covers(0.4142135), (1, 1));
                let beyond = 1e-7 / length(&span[0], &span[1]);
                assert!([-beyond, 1.0 + beyond].iter().all(|&s| covers(s).0 * covers(s).1 == 0));
            }
        }
    }
    // D families, each an estimate of its own.
    let volume = sum * spacing.powi(D as i32 - 1) / D as f64;
    assert!((volume / found.volume - 1.0).abs() < 1e-12);
}

#[test]
fn traces_add_up_to_the_volume() {
    for seed in 0..5 {
        let (a, b) = (random_polygon(9, 1.0, 0.5, seed), random_polygon(7, 0.9, 0.5, seed + 7).translated([0.7, 0.3]));
        traces_are_what_is_counted(&a, &b, 0.02);
        let (a, b) = (random_polyhedron(1, 1.0, 0.3, 1, seed), random_polyhedron(0, 0.9, 0.3, 1, seed + 7));
        traces_are_what_is_counted(&a, &b.translated([0.6, 0.4, 0.3]), 0.1);
    }
}

/// Segments are as long as asked, and begin anywhere.
#[test]
fn segments_have_their_length() {
    let scene = Scene::of(&[&random_polygon(9, 1.0, 0.5, 1), &random_polygon(9, 1.0, 0.5, 2)]);
    let traces = scene.contact(isotropic(0.37, 2_000, 1)).trace(&scene.coords).unwrap();
    assert!(traces.len() > 100);
    assert!(traces.iter().all(|t| (length(&t.start, &t.end) - 0.37).abs() < 1e-14));
    assert!(traces.iter().flat_map(|t| t.crossings.iter().map(|x| length(&t.start, x))).all(|s| s <= 0.37 + 1e-14));
}
