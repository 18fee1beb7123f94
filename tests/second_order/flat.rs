//! Uniform pressure over a flat interface loads every node by the integral of its shape function.

use crate::scene::{Scene, exact, table::exactly};
use crate::{boxes, pair, rectangles};
use fmc_contact::{CellType, EnergyLaw, Estimator, FiberOptions, Options};
use fmc_shapes::Mesh;

fn type_of<const D: usize>(mesh: &Mesh<D>) -> CellType {
    Scene::of(&[mesh]).blocks[0].0
}

fn distance<const D: usize>(x: &[f64; D], y: &[f64; D]) -> f64 {
    x.iter().zip(y).map(|(x, y)| (x - y).powi(2)).sum::<f64>().sqrt()
}

/// Part of a face's load that each of its nodes takes: corners, middles of edges, the middle.
fn parts(corners: usize, has_centre: bool) -> [f64; 3] {
    match (corners, has_centre) {
        (2, _) => [1.0 / 6.0, 2.0 / 3.0, 0.0],
        (3, _) => [0.0, 1.0 / 3.0, 0.0],
        (_, false) => [-1.0 / 12.0, 1.0 / 3.0, 0.0],
        (_, true) => [1.0 / 36.0, 1.0 / 9.0, 4.0 / 9.0],
    }
}

/// Integrals of the shape functions of straight faces at this height, where all nodes have theirs in the middle.
fn shares<const D: usize>(body: &Mesh<D>, height: f64) -> Vec<f64> {
    let cell_type = type_of(body);
    let mut shares = vec![0.0; body.coords.len()];
    let at = |node: u32| body.coords[node as usize];
    let mean = |nodes: &[u32]| -> [f64; D] {
        std::array::from_fn(|i| nodes.iter().map(|&n| at(n)[i]).sum::<f64>() / nodes.len() as f64)
    };
    for cell in body.cells() {
        for face in cell_type.faces() {
            let corners: Vec<u32> = face.iter().map(|&k| cell[k]).collect();
            if corners.iter().any(|&n| (at(n)[D - 1] - height).abs() > 1e-12) {
                continue;
            }
            let mut area = distance(&at(corners[0]), &at(corners[1]));
            if D == 3 {
                let twice = (0..corners.len()).map(|k| (at(corners[k]), at(corners[(k + 1) % corners.len()])));
                area = 0.5 * twice.map(|(p, q)| p[0] * q[1] - p[1] * q[0]).sum::<f64>().abs();
            }
            let find = |x: [f64; D]| cell.iter().copied().find(|&n| distance(&at(n), &x) < 1e-12);
            let centre = find(mean(&corners)).filter(|_| corners.len() == 4);
            let [of_corner, of_edge, of_centre] = parts(corners.len(), centre.is_some());
            let edges = if D == 2 { 1 } else { corners.len() };
            for k in 0..edges {
                let middle = find(mean(&[corners[k], corners[(k + 1) % corners.len()]])).expect("a middle");
                shares[middle as usize] += area * of_edge;
            }
            corners.iter().for_each(|&n| shares[n as usize] += area * of_corner);
            centre.iter().for_each(|&n| shares[n as usize] += area * of_centre);
        }
    }
    shares
}

fn is_uniform<const D: usize>(lower: &Mesh<D>, upper: &Mesh<D>, delta: f64, options: Options, pressure: f64) {
    let what = format!("{:?} on {:?}, {:?}", type_of(upper), type_of(lower), options.law);
    let scene = pair(lower, upper);
    let contact = scene.evaluate(options);
    for (node, share) in scene.nodes_of(1).zip(shares(upper, -delta)) {
        let found = contact.forces[node][D - 1];
        assert!((found - pressure * share).abs() < 1e-9 * pressure, "{what}: {found} for {}", pressure * share);
    }
    // Linear functions over the interface are told by the lower nodes: the load, and where it acts.
    let below = |f: &dyn Fn(&[f64; D]) -> f64| -> f64 {
        scene.nodes_of(0).map(|node| -contact.forces[node][D - 1] * f(&scene.coords[node])).sum()
    };
    assert!((below(&|_| 1.0) - pressure).abs() < 1e-9 * pressure, "{what}");
    for axis in 0..D - 1 {
        let moment = below(&|x| x[axis]);
        assert!((moment - 0.5 * pressure).abs() < 1e-9 * pressure, "{what}: {moment}");
    }
}

const DELTA: f64 = 1e-3;

fn in_plane(mut visit: impl FnMut(&Mesh<2>, &Mesh<2>)) {
    let lower = rectangles([-0.5, -1.0], [1.5, 0.0], [3, 3]);
    let upper = rectangles([0.0, -DELTA], [1.0, 1.0 - DELTA], [2, 3]);
    lower.iter().for_each(|below| upper.iter().for_each(|above| visit(below, above)));
}

fn in_space(mut visit: impl FnMut(&Mesh<3>, &Mesh<3>)) {
    let lower = boxes([-0.5, -0.5, -1.0], [1.5, 1.5, 0.0], [3, 3, 3]);
    let upper = boxes([0.0, 0.0, -DELTA], [1.0, 1.0, 1.0 - DELTA], [2, 2, 2]);
    lower.iter().for_each(|below| upper.iter().for_each(|above| visit(below, above)));
}

/// The pressure of the volume law is k, that of the law on lines k δ.
#[test]
fn every_type_on_every_other() {
    in_plane(|below, above| {
        is_uniform(below, above, DELTA, exact(), 1.0);
        is_uniform(below, above, DELTA, exactly(EnergyLaw::fiber(4.0)), 4.0 * DELTA);
    });
    in_space(|below, above| {
        is_uniform(below, above, DELTA, exact(), 1.0);
        is_uniform(below, above, DELTA, exactly(EnergyLaw::fiber(4.0)), 4.0 * DELTA);
    });
}

/// Faces of quadrilaterals that are no parallelograms: the weight of a node is that of the bilinear map.
#[test]
fn skewed_faces() {
    let skew = |x: [f64; 3]| [x[0] * (1.0 + 0.4 * x[1]), x[1] * (1.0 - 0.3 * x[0]), x[2]];
    let hexahedra = cuboid_hex8_skewed(skew);
    for nodes in [20, 27] {
        let upper = fmc_shapes::second_order(&hexahedra, nodes);
        let lower = boxes([-0.5, -0.5, -1.0], [2.0, 2.0, 0.0], [2, 3, 2]).swap_remove(0);
        let scene = pair(&lower, &upper);
        let contact = scene.evaluate(exact());
        let expected = integrals(&upper, nodes);
        for (node, share) in scene.nodes_of(1).zip(expected) {
            let found = contact.forces[node][2];
            assert!((found - share).abs() < 1e-9, "{found} for {share}");
        }
    }
}

fn cuboid_hex8_skewed(map: impl Fn([f64; 3]) -> [f64; 3]) -> Mesh<3> {
    let mut mesh = fmc_shapes::cuboid_hex8([0.0, 0.0, -DELTA], [1.0, 1.0, 1.0], [2, 2, 2]);
    mesh.coords.iter_mut().for_each(|x| *x = map(*x));
    mesh
}

/// ∫ N dA over the bottom of skewed hexahedra, by Gauss points of the bilinear map.
fn integrals(mesh: &Mesh<3>, nodes: usize) -> Vec<f64> {
    let mut sums = vec![0.0; mesh.coords.len()];
    let gauss = [(-(0.6f64).sqrt(), 5.0 / 9.0), (0.0, 8.0 / 9.0), ((0.6f64).sqrt(), 5.0 / 9.0)];
    for cell in mesh.cells().filter(|cell| mesh.coords[cell[0] as usize][2] < 0.0) {
        let x = |k: usize| mesh.coords[cell[k] as usize];
        for (u, wu) in gauss {
            for (v, wv) in gauss {
                // Corners 0 to 3, edges 8 to 11, and the middle 24 of the bottom.
                let one = |s: f64, t: f64| 0.25 * (1.0 + s * u) * (1.0 + t * v);
                let signs = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
                let mut rates = [[0.0; 2]; 2];
                for (k, (s, t)) in signs.into_iter().enumerate() {
                    for axis in 0..2 {
                        rates[0][axis] += 0.25 * s * (1.0 + t * v) * x(k)[axis];
                        rates[1][axis] += 0.25 * t * (1.0 + s * u) * x(k)[axis];
                    }
                }
                let jacobian = rates[0][0] * rates[1][1] - rates[0][1] * rates[1][0];
                let bubble = (1.0 - u * u) * (1.0 - v * v);
                let full = if nodes == 27 { bubble } else { 0.0 };
                let edge = |s: f64, t: f64| {
                    let plain = if s == 0.0 { (1.0 - u * u) * (1.0 + t * v) } else { (1.0 - v * v) * (1.0 + s * u) };
                    0.5 * plain - 0.5 * full
                };
                let edges = [(0.0, -1.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0)].map(|(s, t)| edge(s, t));
                let weight = wu * wv * jacobian;
                for k in 0..4 {
                    let (s, t) = signs[k];
                    sums[cell[k] as usize] +=
                        weight * (one(s, t) - 0.5 * (edges[k] + edges[(k + 3) % 4]) - 0.25 * full);
                    sums[cell[8 + k] as usize] += weight * edges[k];
                }
                if nodes == 27 {
                    sums[cell[24] as usize] += weight * bubble;
                }
            }
        }
    }
    sums
}

/// Straight cells with and without nodes in the middle overlap alike.
#[test]
fn straight_sides_enclose_the_same() {
    let plain = fmc_shapes::cuboid_tet4([0.2, 0.1, -0.3], [0.9, 0.8, 0.5], [2, 2, 2]);
    let block = fmc_shapes::cuboid_hex8([0.0, 0.0, -1.0], [1.0, 1.0, 0.0], [3, 2, 2]);
    let expected = pair(&block, &plain).evaluate(exact()).volume;
    for lower in boxes([0.0, 0.0, -1.0], [1.0, 1.0, 0.0], [3, 2, 2]) {
        for upper in boxes([0.2, 0.1, -0.3], [0.9, 0.8, 0.5], [2, 2, 2]) {
            let found = pair(&lower, &upper).evaluate(exact()).volume;
            assert!((found - expected).abs() < 1e-12, "{found} for {expected}");
        }
    }
}

/// The mean of six seeds, of lines as they are laid by default: in the root mean square over the nodes, all components. (Single
/// nodes are further off: of a `Tet10` on another, by the law `volume`, 6.5e-3 of the largest integral of a shape function.)
#[test]
fn sampled_by_lines() {
    for law in [EnergyLaw::volume(1.0), EnergyLaw::fiber(4.0)] {
        let pressure = if law.is_fiber() { 4.0 * DELTA } else { 1.0 };
        in_plane(|below, above| is_uniform_on_average(below, above, law, pressure));
        in_space(|below, above| is_uniform_on_average(below, above, law, pressure));
    }
}

fn is_uniform_on_average<const D: usize>(below: &Mesh<D>, above: &Mesh<D>, law: EnergyLaw, pressure: f64) {
    let what = format!("{:?} on {:?}, {law:?}", type_of(above), type_of(below));
    let scene = pair(below, above);
    let mut mean = vec![[0.0; D]; scene.coords.len()];
    for seed in 0..6 {
        let lines = FiberOptions { seed, ..FiberOptions::default() };
        let found = scene.evaluate(Options { estimator: Estimator::Fibers(lines), ..Options::new(law) });
        for (sum, force) in mean.iter_mut().zip(&found.forces) {
            (0..D).for_each(|axis| sum[axis] += force[axis] / 6.0);
        }
    }
    let shares = shares(above, -DELTA);
    let expected: Vec<[f64; D]> = shares
        .iter()
        .map(|share| std::array::from_fn(|axis| if axis == D - 1 { pressure * share } else { 0.0 }))
        .collect();
    let off = crate::scene::distance(&mean[scene.nodes_of(1)], &expected) / crate::scene::norm(&expected);
    assert!(off < 5e-3, "{what}: {off}");
}
