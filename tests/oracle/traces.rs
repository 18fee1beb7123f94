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

/// Where the first line of either family in 2D passes the origin, in spacings and modulo 1.
fn shifts(scene: &Scene<2>, seed: u64) -> [f64; 2] {
    let spacing = 0.1;
    let traces = scene.contact(consistent_lines(spacing, seed)).trace(&scene.coords).unwrap();
    let mut found: Vec<([f64; 2], f64)> = Vec::new();
    for trace in &traces {
        let e: [f64; 2] = std::array::from_fn(|i| trace.end[i] - trace.start[i]);
        let n = [-e[1], e[0]].map(|x| x / length(&trace.start, &trace.end));
        // One direction for a family, whichever way its lines are told.
        let n = if n[0] + 0.1 * n[1] > 0.0 { n } else { n.map(|x| -x) };
        if found.iter().all(|(m, _)| (m[0] * n[0] + m[1] * n[1]).abs() < 0.5) {
            found.push((n, ((n[0] * trace.start[0] + n[1] * trace.start[1]) / spacing).rem_euclid(1.0)));
        }
    }
    found.sort_by(|p, q| p.0[0].total_cmp(&q.0[0]));
    [found[0].1, found[1].1]
}

/// Every seed and every family has a shift of its own, anywhere in a spacing: means, squares and products are those of
/// independent uniform numbers.
#[test]
fn lattices_are_shifted_at_random() {
    let scene = Scene::of(&[&random_polygon(9, 1.0, 0.5, 1), &random_polygon(9, 1.0, 0.5, 2)]);
    let count = 2_000;
    let [mut mean, mut square, mut product] = [[0.0; 2], [0.0; 2], [0.0; 2]];
    let mut before = [0.5; 2];
    for seed in 0..count {
        let shift = shifts(&scene, seed);
        for family in 0..2 {
            mean[family] += (shift[family] - 0.5) / count as f64;
            square[family] += ((shift[family] - 0.5).powi(2) - 1.0 / 12.0) / count as f64;
        }
        // Of the two families, and of neighbouring seeds.
        product[0] += (shift[0] - 0.5) * (shift[1] - 0.5) / count as f64;
        product[1] += (shift[0] - 0.5) * (before[0] - 0.5) / count as f64;
        before = shift;
    }
    // Four standard errors: √(1/12), √(1/180) and 1/12, over √count.
    let root = (count as f64).sqrt();
    assert!(mean.iter().all(|m| m.abs() < 4.0 * 0.2887 / root), "{mean:?}");
    assert!(square.iter().all(|s| s.abs() < 4.0 * 0.0745 / root), "{square:?}");
    assert!(product.iter().all(|p| p.abs() < 4.0 / 12.0 / root), "{product:?}");
}
