//! Lines that run through nodes and edges of the mesh are counted like any other: bodies are built on the very lines that
//! measure them.

use crate::scene::{Scene, exact, lines};
use fmc_contact::overlap::FiberTrace;
use fmc_shapes::{Diagonals, Mesh, cuboid_tet4, icosphere, rectangle_tri3};

/// Lines as points and unit directions, from the traces of a large overlap.
fn laid_lines<const D: usize>(blocks: &Scene<D>, spacing: f64, seed: u64) -> Vec<([f64; D], [f64; D])> {
    let traces: Vec<FiberTrace<D>> = blocks.contact(lines(spacing, seed)).trace(&blocks.coords).unwrap();
    let direction = |t: &FiberTrace<D>| {
        let e: [f64; D] = std::array::from_fn(|i| t.end[i] - t.start[i]);
        let length = e.iter().map(|e| e * e).sum::<f64>().sqrt();
        e.map(|e| e / length)
    };
    traces.iter().map(|t| (t.start, direction(t))).collect()
}

/// Every node moved onto the line nearest to it; twice, for a second family at right angles to the first.
fn onto_lines<const D: usize>(mesh: &Mesh<D>, lines: &[([f64; D], [f64; D])], families: usize) -> Mesh<D> {
    let dot = |a: &[f64; D], b: &[f64; D]| (0..D).map(|i| a[i] * b[i]).sum::<f64>();
    mesh.clone().mapped(|mut x| {
        let mut used: Vec<[f64; D]> = Vec::new();
        for _ in 0..families {
            let across = |(start, d): &([f64; D], [f64; D])| -> [f64; D] {
                let e: [f64; D] = std::array::from_fn(|i| start[i] - x[i]);
                let along = dot(&e, d);
                std::array::from_fn(|i| e[i] - along * d[i])
            };
            let unused = lines.iter().filter(|l| used.iter().all(|u| dot(u, &l.1).abs() < 0.5));
            let nearest = unused.min_by(|p, q| {
                let (p, q) = (across(p), across(q));
                dot(&p, &p).total_cmp(&dot(&q, &q))
            });
            let nearest = nearest.expect("the lines fill the block");
            let e = across(nearest);
            used.push(nearest.1);
            x = std::array::from_fn(|i| x[i] + e[i]);
        }
        x
    })
}

/// One missed or doubled crossing shifts the estimate by a line of the body's own length times spacingᴰ⁻¹. Below half of
/// that, and of the order of what moving on by a part of the spacing gives, there is none.
fn no_line_leaks<const D: usize>(inner: &Mesh<D>, outer: &Mesh<D>, spacing: f64, seed: u64, sampling: f64) {
    let on_lines = Scene::of(&[inner, outer]);
    let contact = on_lines.evaluate(lines(spacing, seed));
    let expected = on_lines.evaluate(exact()).volume;
    let error = (contact.volume / expected - 1.0).abs();
    assert!(error < sampling, "error {error:e} with nodes on the lines");
    // An open span would run on to the other end of the block and carry a force on it.
    assert!(on_lines.nodes_of(1).all(|node| contact.forces[node] == [0.0; D]));
    // Its Σ x·∂V/∂x, by the lines' own crossings.
    let virial: f64 = (on_lines.nodes_of(0))
        .map(|n| -(0..D).map(|i| on_lines.coords[n][i] * contact.forces[n][i]).sum::<f64>())
        .sum();
    assert!((virial / (D as f64 * expected) - 1.0).abs() < 3.0 * sampling, "{virial} of {expected}");
}

#[test]
fn lines_through_nodes_of_polygons_count_once() {
    let spacing = 0.05;
    let block = rectangle_tri3([-2.0; 2], [2.0; 2], [3, 3], Diagonals::Same);
    for seed in 0..6 {
        let lines = laid_lines(&Scene::of(&[&block, &block]), spacing, seed);
        let square =
            rectangle_tri3([-0.7, -0.6], [0.8, 0.9], [4, 5], Diagonals::Alternating).rotated(0.2 * seed as f64);
        for families in [1, 2] {
            // Some 30 lines of length 1.5 per family; the ends are off by up to half a spacing each, at random.
            no_line_leaks(&onto_lines(&square, &lines, families), &block, spacing, seed, 1.5e-2);
        }
    }
}

/// Sides along the lines themselves: whole edges lie on lines.
#[test]
fn lines_along_edges_count_once() {
    let spacing = 0.05;
    let block = rectangle_tri3([-2.0; 2], [2.0; 2], [3, 3], Diagonals::Same);
    for seed in 0..6 {
        let lines = laid_lines(&Scene::of(&[&block, &block]), spacing, seed);
        let d = lines[0].1;
        // A square of 20 × 20 cells of the lattice with its sides on lines: its area is that of 400 cells, up to the
        // lines along its sides, which count or do not.
        let square =
            rectangle_tri3([-0.5; 2], [0.5; 2], [5, 5], Diagonals::Same).rotated_by([[d[0], -d[1]], [d[1], d[0]]]);
        no_line_leaks(&onto_lines(&square, &lines, 2), &block, spacing, seed, 1.0 / 20.0 + 1e-9);
    }
}

#[test]
fn lines_through_nodes_of_polyhedra_count_once() {
    let spacing = 0.1;
    let block = cuboid_tet4([-2.0; 3], [2.0; 3], [2; 3]);
    for seed in 0..3 {
        let lines = laid_lines(&Scene::of(&[&block, &block]), spacing, seed);
        let ball = icosphere(0.9, 2).rotated([0.2, 1.0, 0.4], seed as f64);
        let on_lines = onto_lines(&ball, &lines, 1);
        let inner = fmc_shapes::coned(&on_lines, [0.01, 0.02, 0.03], 1);
        // Some 250 lines of length 1.2 per family, ends off by less than a spacing: 0.1·√2/(1.2·√250).
        no_line_leaks(&inner, &block, spacing, seed, 1e-2);
    }
}
