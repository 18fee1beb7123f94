//! Slices of rings between planes of symmetry: in space they are measured as in the plane.

use crate::depth;
use crate::scene::{Scene, distance, norm};
use fmc_shapes::{Mesh, cuboid_hex8, cuboid_tet4, cuboid_wedge6, second_order};
use std::f64::consts::FRAC_PI_2;

const HEIGHT: f64 = 0.5;

/// A quarter of a ring, in cells of so many nodes.
fn quarter([from, to]: [f64; 2], cells: [usize; 3], nodes: usize) -> Mesh<3> {
    let (low, high) = ([0.0, from, 0.0], [1.0, to, HEIGHT]);
    let straight = match nodes {
        4 | 10 => cuboid_tet4(low, high, cells),
        6 | 15 => cuboid_wedge6(low, high, cells),
        _ => cuboid_hex8(low, high, cells),
    };
    let mut mesh = if straight.nodes_per_cell == nodes { straight } else { second_order(&straight, nodes) };
    for x in &mut mesh.coords {
        let (angle, radius) = (FRAC_PI_2 * x[0], x[1]);
        // Against the clock outwards and around is a left-handed pair.
        (x[0], x[1]) = (radius * angle.sin(), radius * angle.cos());
    }
    mesh
}

/// Heights at a corner are those of all facets there, and none of their sums may hang on the order of the facets: what is left is the rounding of
/// coordinates in depths of 1e-3 of the radius.
#[test]
fn nodes_of_curved_cells_in_another_order() {
    let bodies = [quarter([0.6, 1.0025], [8, 1, 1], 20), quarter([1.0, 1.5], [10, 1, 1], 20)];
    let reversed = bodies.clone().map(|mut mesh| {
        let last = mesh.coords.len() as u32 - 1;
        mesh.coords.reverse();
        mesh.conn.iter_mut().for_each(|node| *node = last - *node);
        mesh
    });
    let [first, second] = [bodies, reversed].map(|[inner, outer]| {
        let scene = Scene::of(&[&inner, &outer]);
        let found = scene.evaluate(depth(1.0));
        let of_body = |body: usize| scene.nodes_of(body).map(|node| found.forces[node]).collect::<Vec<_>>();
        ([of_body(0), of_body(1)], found.energy)
    });
    assert!((second.1 / first.1 - 1.0).abs() < 1e-9, "{} {}", first.1, second.1);
    for (one, mut other) in first.0.into_iter().zip(second.0) {
        other.reverse();
        assert!(distance(&one, &other) < 1e-8 * norm(&one), "{}", distance(&one, &other) / norm(&one));
    }
}

/// Rigid rings that overlap by δ everywhere, and whose facets lie up to 5 δ beside their arcs: pressed by k δ, with no point deeper than δ
/// and the error of the curves. That falls with the fourth power of the cells' angle, 11° here: 0.1 δ for second order, 0.4 δ for the circles
/// through smoothed facets.
#[test]
fn rings_that_overlap_in_space() {
    let delta = 1e-3;
    for (nodes, smoothing, within, deepest) in
        [(20, 0.0, 5e-3, 0.2), (27, 0.0, 5e-3, 0.2), (10, 0.0, 1e-2, 0.2), (15, 0.0, 1e-2, 0.2), (8, 30.0, 2e-2, 0.5)]
    {
        for (layers, pieces) in [(1, [8, 8]), (1, [8, 11]), (2, [9, 8])] {
            let [inner, outer] = pieces.map(|pieces| [pieces, 2, layers]);
            let scene = Scene::of(&[&quarter([0.6, 1.0 + delta], inner, nodes), &quarter([1.0, 1.5], outer, nodes)]);
            let mut contact = scene.contact(depth(1.0));
            contact.set_surface_smoothing(smoothing).expect("an angle");
            let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
            let planes = [[[0.0; 3], x], [[0.0; 3], y], [[0.0; 3], z], [[0.0, 0.0, HEIGHT], z]];
            contact.set_symmetry_planes(&planes).expect("planes");
            let found = contact.evaluate(&scene.coords).expect("valid coordinates");
            let outwards = |node: usize| {
                let (x, f) = (scene.coords[node], found.forces[node]);
                (f[0] * x[0] + f[1] * x[1]) / x[0].hypot(x[1])
            };
            let force = -scene.nodes_of(0).map(outwards).sum::<f64>() / (FRAC_PI_2 * HEIGHT * delta);
            let pair = &found.pairs[0];
            assert!((force - 1.0).abs() < within, "{nodes} {pieces:?} {layers}: {force}");
            let over = pair.penetration / delta - 1.0;
            assert!((0.0..deepest).contains(&over), "{nodes} {pieces:?} {layers}: {over}");
            let area = pair.contact_area / (FRAC_PI_2 * HEIGHT);
            assert!((area - 1.0).abs() < 5e-3, "{nodes} {pieces:?} {layers}: {area}");
        }
    }
}
