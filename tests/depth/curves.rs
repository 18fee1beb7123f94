//! Bodies with faces of second order that are curved: measured on the curves, not on straight facets.

use crate::depth;
use crate::derivatives::{force_is_the_slope_of_the_energy, forces_balance, tangent_is_the_slope_of_the_force};
use crate::scene::Scene;
use fmc_contact::{Contact, Warning};
use fmc_shapes::{
    Diagonals, Mesh, Splitmix, cuboid_hex8, cuboid_tet4, cuboid_wedge6, rectangle_quad4, rectangle_tri3, second_order,
};
use std::f64::consts::TAU;

/// A sector of a ring: the first coordinate, in parts of `angle`, runs around, the second outwards.
pub(crate) fn sector<const D: usize>(mut mesh: Mesh<D>, angle: f64) -> Mesh<D> {
    for x in &mut mesh.coords {
        let (around, radius) = (angle * x[0], x[1]);
        // Against the clock outwards and around is a left-handed pair.
        (x[0], x[1]) = (radius * around.sin(), radius * around.cos());
    }
    mesh
}

fn disturbed<const D: usize>(scene: &Scene<D>, by: f64) -> Vec<[f64; D]> {
    let mut random = Splitmix::new(5);
    scene.coords.iter().map(|x| x.map(|x| x + random.between(-by, by))).collect()
}

fn pairs_in_plane(overlap: f64) -> Vec<Scene<2>> {
    let quads = |from, to, cells| sector(second_order(&rectangle_quad4([0.0, from], [1.0, to], cells), 9), 0.3 * TAU);
    let eight = |from, to, cells| sector(second_order(&rectangle_quad4([0.0, from], [1.0, to], cells), 8), 0.3 * TAU);
    let triangles = |from, to, cells| {
        sector(second_order(&rectangle_tri3([0.0, from], [1.0, to], cells, Diagonals::Alternating), 6), 0.3 * TAU)
    };
    let straight = |from, to, cells| sector(rectangle_quad4([0.0, from], [1.0, to], cells), 0.3 * TAU);
    let top = 1.0 + overlap;
    vec![
        Scene::of(&[&quads(0.5, top, [7, 2]), &quads(1.0, 1.5, [9, 2])]),
        Scene::of(&[&eight(0.5, top, [7, 2]), &triangles(1.0, 1.5, [9, 2])]),
        Scene::of(&[&triangles(0.5, top, [5, 2]), &straight(1.0, 1.5, [13, 2])]),
    ]
}

fn pairs_in_space(overlap: f64) -> Vec<Scene<3>> {
    let low = |from: f64| [0.0, from, 0.0];
    let high = |to: f64| [1.0, to, 0.9];
    let top = 1.0 + overlap;
    let curved = |mesh: &Mesh<3>, count| sector(second_order(mesh, count), 0.2 * TAU);
    let inner = |count, cells: [usize; 3]| match count {
        10 => curved(&cuboid_tet4(low(0.5), high(top), cells), 10),
        15 => curved(&cuboid_wedge6(low(0.5), high(top), cells), 15),
        _ => curved(&cuboid_hex8(low(0.5), high(top), cells), count),
    };
    let outer = |count, cells: [usize; 3]| match count {
        10 => curved(&cuboid_tet4([-0.1, 1.0, -0.05], [1.1, 1.5, 1.0], cells), 10),
        8 => sector(cuboid_hex8([-0.1, 1.0, -0.05], [1.1, 1.5, 1.0], cells), 0.2 * TAU),
        _ => curved(&cuboid_hex8([-0.1, 1.0, -0.05], [1.1, 1.5, 1.0], cells), count),
    };
    vec![
        Scene::of(&[&inner(20, [3, 1, 1]), &outer(27, [4, 1, 1])]),
        Scene::of(&[&inner(27, [3, 1, 1]), &outer(10, [4, 1, 1])]),
        Scene::of(&[&inner(10, [3, 1, 1]), &outer(20, [4, 1, 1])]),
        Scene::of(&[&inner(15, [3, 1, 1]), &outer(8, [5, 1, 1])]),
    ]
}

/// What is summed up is a polynomial between all borders and levels, and the derivatives are exact: in space up to the rays of a quadrature.
/// Outside of the body the depths of two faces that meet at a rim differ there by up to 1.4e-5 of the force, on cells here that each turn by 24°;
/// with half the angle it is 1e-8.
fn check<const D: usize>(scene: &Scene<D>, by: f64) {
    let within = if D == 2 { [1e-7, 1e-6] } else { [2e-5, 1e-2] };
    let contact: Contact<D> = scene.contact(depth(30.0));
    let coords = disturbed(scene, by);
    forces_balance(&contact, &coords);
    force_is_the_slope_of_the_energy(&contact, &coords, within[0]);
    tangent_is_the_slope_of_the_force(&contact, &coords, within[1]);
}

#[test]
fn derivatives_in_the_plane() {
    for overlap in [5e-3, 0.05] {
        pairs_in_plane(overlap).iter().for_each(|scene| check(scene, 1e-4));
    }
}

#[test]
fn derivatives_in_space() {
    for overlap in [5e-3, 0.05] {
        pairs_in_space(overlap).iter().for_each(|scene| check(scene, 1e-4));
    }
}

/// Rings whose ends lie in the same two planes: edges of both coincide there but for rounding, which gives parts of facets corners that come
/// and go. With curved surfaces that touch by waves, and levels all over their facets, forces still move by no more than coordinates do.
#[test]
fn rounding_moves_forces_by_rounding() {
    let low = |from: f64| [0.0, from, 0.0];
    let high = |to: f64| [1.0, to, 0.5];
    for (overlap, [n, m]) in [(0.0, [8, 7]), (1e-3, [4, 6]), (0.0, [5, 5])] {
        let inner = sector(cuboid_hex8(low(0.5), high(1.0 + overlap), [n, 1, 1]), 0.25 * TAU);
        let outer = sector(cuboid_hex8(low(1.0), high(1.5), [m, 1, 2]), 0.25 * TAU);
        let scene = Scene::of(&[&inner, &outer]);
        let mut contact = scene.contact(depth(1.0));
        contact.set_surface_smoothing(30.0).expect("an angle");
        let ends = [0.0, 0.5].map(|z| [[0.0, 0.0, z], [0.0, 0.0, 1.0]]);
        contact.set_symmetry_planes(&ends).expect("planes");
        let mut random = Splitmix::new(7);
        let around = |x: &[f64; 3], by: f64, random: &mut Splitmix| {
            [x[0] + random.between(-by, by), x[1] + random.between(-by, by), x[2]]
        };
        let coords: Vec<_> = scene.coords.iter().map(|x| around(x, 1e-5, &mut random)).collect();
        let here = contact.evaluate(&coords).expect("valid coordinates");
        let largest = here.forces.as_flattened().iter().fold(0.0f64, |most, x| most.max(x.abs()));
        assert!(largest > 0.0);
        for _ in 0..4 {
            let beside: Vec<_> = coords.iter().map(|x| x.map(|x| x + random.between(-1e-13, 1e-13))).collect();
            let there = contact.evaluate(&beside).expect("valid coordinates");
            let pairs = here.forces.as_flattened().iter().zip(there.forces.as_flattened());
            let change = pairs.fold(0.0f64, |most, (a, b)| most.max((a - b).abs()));
            // They grow with a penetration of 1e-5 to 1e-3: 1e-13 is up to 1e-8 of it, of a few facets.
            assert!(change < 2e-8 * largest, "{n} on {m}: {:e}", change / largest);
        }
    }
}

/// A ring all around, in cells of second order or straight ones.
pub(crate) fn ring(from: f64, to: f64, cells: [usize; 2], nodes: usize, turn: f64) -> Mesh<2> {
    let straight = rectangle_quad4([0.0, from], [1.0, to], cells);
    let mesh = if nodes == 4 { straight } else { second_order(&straight, nodes) };
    let mut mesh = sector(mesh, TAU);
    // The ends of the rectangle fall together.
    let mut first = std::collections::BTreeMap::new();
    let key = |x: &[f64; 2]| x.map(|x| (x * 1e9).round() as i64);
    let same: Vec<u32> = (0..).zip(&mesh.coords).map(|(node, x)| *first.entry(key(x)).or_insert(node)).collect();
    mesh.conn.iter_mut().for_each(|node| *node = same[*node as usize]);
    for x in &mut mesh.coords {
        *x = [x[0] * turn.cos() - x[1] * turn.sin(), x[0] * turn.sin() + x[1] * turn.cos()];
    }
    mesh
}

/// Rigid rings that overlap by δ everywhere: each part of the circle is pressed by k δ, however they are turned, though the straight
/// facets lie up to 2 δ beside it. Facets of second order leave the fourth power of their angle, 1e-3 of δ here.
#[test]
fn rings_that_overlap() {
    let delta = 1e-3;
    for (nodes, smoothing, within) in [(9, 0.0, 1e-3), (4, 30.0, 1e-2)] {
        let mut forces = Vec::new();
        for turn in [0.0, 0.03, 0.09] {
            let scene =
                Scene::of(&[&ring(0.5, 1.0 + delta, [32, 2], nodes, turn), &ring(1.0, 1.5, [44, 2], nodes, 0.0)]);
            let mut contact = scene.contact(depth(1.0));
            contact.set_surface_smoothing(smoothing).expect("an angle");
            let found = contact.evaluate(&scene.coords).expect("valid coordinates");
            assert!(found.warnings.is_empty(), "{:?}", found.warnings);
            let outwards = |node: usize| {
                let (x, f) = (scene.coords[node], found.forces[node]);
                (f[0] * x[0] + f[1] * x[1]) / x[0].hypot(x[1])
            };
            let force: f64 = -scene.nodes_of(0).map(outwards).sum::<f64>() / (TAU * delta);
            let pair = &found.pairs[0];
            assert!((force - 1.0).abs() < within, "{nodes}: {force}");
            assert!((pair.penetration / delta - 1.0).abs() < 0.3, "{}", pair.penetration);
            assert!((pair.contact_area / TAU - 1.0).abs() < 2e-3, "{}", pair.contact_area);
            assert!((pair.volume / (TAU * delta) - 1.0).abs() < 2.0 * within, "{}", pair.volume);
            forces.push(force);
        }
        let ripple = forces.iter().fold(0.0f64, |most, force| most.max((force - forces[0]).abs()));
        assert!(ripple < 1e-4, "{nodes}: {forces:?}");
    }
}

/// Gaps as constraints are those over the curves.
#[test]
fn gaps_of_rings() {
    let clearance = 1e-3;
    for (nodes, smoothing) in [(9, 0.0), (4, 30.0)] {
        let scene =
            Scene::of(&[&ring(0.5, 1.0 - clearance, [32, 2], nodes, 0.05), &ring(1.0, 1.5, [44, 2], nodes, 0.0)]);
        let mut contact = scene.contact(depth(1.0));
        contact.set_surface_smoothing(smoothing).expect("an angle");
        let gaps = contact.gap_constraints(&scene.coords, 0.1).expect("valid coordinates");
        assert!(gaps.gaps.len() > 70, "{}", gaps.gaps.len());
        for (gap, area) in gaps.gaps.iter().zip(&gaps.areas) {
            assert!((gap / area / clearance - 1.0).abs() < 0.03, "{nodes}: {}", gap / area);
        }
    }
}

/// Their rows are the derivatives of the gaps, open and closed: the foot of a point wanders over a curved face, whose height changes on the
/// way. By differences of 1e-6, with feet that do not cross from facet to facet.
#[test]
fn rows_of_gaps_are_their_derivatives() {
    for overlap in [0.003, -0.003] {
        pairs_in_plane(overlap).iter().for_each(|scene| rows_are_derivatives(scene, 0.0));
        pairs_in_space(overlap).iter().for_each(|scene| rows_are_derivatives(scene, 0.0));
        let rings = [ring(0.5, 1.0 + overlap, [32, 2], 4, 0.05), ring(1.0, 1.5, [44, 2], 4, 0.0)];
        rows_are_derivatives(&Scene::of(&[&rings[0], &rings[1]]), 30.0);
    }
}

fn rows_are_derivatives<const D: usize>(scene: &Scene<D>, smoothing: f64) {
    let mut contact = scene.contact(depth(1.0));
    contact.set_surface_smoothing(smoothing).expect("an angle");
    let (coords, step) = (disturbed(scene, 2e-4), 1e-6);
    let mut random = Splitmix::new(7);
    let along: Vec<[f64; D]> = coords.iter().map(|x| x.map(|_| random.between(-1.0, 1.0))).collect();
    let at = |by: f64| {
        let moved: Vec<[f64; D]> =
            coords.iter().zip(&along).map(|(x, d)| std::array::from_fn(|i| x[i] + by * d[i])).collect();
        contact.gap_constraints(&moved, 0.1).expect("valid coordinates")
    };
    let (here, ahead, behind) = (at(0.0), at(step), at(-step));
    assert!(here.gaps.len() > 8 && ahead.nodes == here.nodes && behind.nodes == here.nodes, "{}", here.gaps.len());
    let mut off = 0;
    for row in 0..here.gaps.len() {
        let entries = here.row_starts[row]..here.row_starts[row + 1];
        let by_rows: f64 = entries
            .map(|at| (0..D).map(|i| here.slopes[at][i] * along[here.columns[at] as usize][i]).sum::<f64>())
            .sum();
        let by_differences = (ahead.gaps[row] - behind.gaps[row]) / (2.0 * step);
        let is_edge = (ahead.gaps[row] - 2.0 * here.gaps[row] + behind.gaps[row]).abs() > 1e-3 * step * here.areas[row];
        off += usize::from(is_edge);
        let error = (by_rows - by_differences).abs() / here.areas[row];
        assert!(is_edge || error < 1e-5, "row {row}: {by_rows} for {by_differences}, {error:.1e}");
    }
    assert!(off * 5 <= here.gaps.len(), "{off} of {} rows have an edge", here.gaps.len());
}

/// Curved faces may touch while the boxes of the straight ones are still apart.
#[test]
fn touch_before_the_straight_facets() {
    let body = |bottom: f64| {
        let mut mesh = second_order(&rectangle_quad4([-0.5, 0.0], [0.5, 1.0], [1, 1]), 9);
        for x in &mut mesh.coords {
            let below = (1.0 - x[1]) * 0.02 * (1.0 - 4.0 * x[0] * x[0]);
            x[1] = (x[1] - below) + bottom;
        }
        mesh
    };
    // The lowest node lies 0.02 below the corners; its point of the division a third of that lower.
    let floor = rectangle_quad4([-1.0, -1.0], [1.0, 0.0], [3, 2]);
    for step in 0..60 {
        let bottom = 0.035 - 5e-4 * (f64::from(step) + 0.5);
        let found = Scene::of(&[&body(bottom), &floor]).evaluate(depth(1.0));
        // A parabola over the floor: k/2 ∫ g² with g = d − 0.08 x², along ±a. Its facets are inclined by 0.05.
        let d = 0.02 - bottom;
        let a = (d.max(0.0) / 0.08).sqrt().min(0.5);
        let energy = d * d * a - 0.16 / 3.0 * d * a.powi(3) + 0.0064 / 5.0 * a.powi(5);
        assert!((found.energy - energy).abs() < 2e-8 + 0.01 * energy, "{d}: {} for {energy}", found.energy);
    }
}

/// A curved body right through a plate, and into a hole that it fills: the work along the way is the energy.
#[test]
fn energy_along_a_way() {
    let body = sector(second_order(&rectangle_quad4([0.0, 0.05], [1.0, 0.5], [12, 2]), 9), TAU / 3.0);
    let plate = second_order(&rectangle_quad4([-1.5, -0.6], [1.5, 0.05], [7, 2]), 9);
    let scene = Scene::of(&[&body, &plate]);
    let contact = scene.contact(depth(1.0));
    let (count, mut energies, mut works) = (400, Vec::new(), vec![0.0]);
    let mut before: Option<f64> = None;
    for step in 0..=count {
        let mut coords = scene.coords.clone();
        let y = 0.4 - 1.8 * f64::from(step) / f64::from(count);
        scene.nodes_of(0).for_each(|node| {
            coords[node][0] += 0.011;
            coords[node][1] += y;
        });
        let found = contact.evaluate(&coords).expect("valid coordinates");
        let force: f64 = scene.nodes_of(0).map(|node| found.forces[node][1]).sum();
        if let Some(before) = before {
            works.push(works[works.len() - 1] + 0.5 * (before + force) * 1.8 / f64::from(count));
        }
        before = Some(force);
        energies.push(found.energy);
    }
    let most = energies.iter().copied().fold(0.0, f64::max);
    assert!(energies[0] == 0.0 && most > 1e-3);
    for (step, (energy, work)) in energies.iter().zip(&works).enumerate() {
        assert!((energy - work).abs() < 2e-3 * most, "{step}: {energy} {work} of {most}");
    }
    let last = energies[count as usize] - works[count as usize];
    assert!(last.abs() < 5e-4 * most, "{last} of {most}");
}

/// Flat ends of curved bodies press evenly: nodal forces of a uniform pressure.
#[test]
fn flat_ends_of_curved_bodies() {
    let delta = 1e-3;
    let upper = sector(second_order(&cuboid_hex8([0.0, 0.4, -delta], [1.0, 1.0, 0.5], [4, 3, 4]), 20), 0.2 * TAU);
    let lower = cuboid_hex8([-0.5, -0.5, -0.5], [1.5, 1.5, 0.0], [3, 5, 2]);
    let scene = Scene::of(&[&upper, &lower]);
    let found = scene.evaluate(depth(1.0));
    let points = scene.contact(depth(1.0)).contact_points(&scene.coords).expect("valid coordinates");
    // Beside the walls of either body the other's depth is that below the wall.
    let is_inner = |x: &[f64; 3]| (0.5..0.9).contains(&x[0].hypot(x[1])) && (0.2..1.0).contains(&x[0].atan2(x[1]));
    let bottom: Vec<_> = points.iter().filter(|point| is_inner(&point.position)).collect();
    assert!(bottom.len() > 20, "{}", bottom.len());
    for point in bottom {
        assert!((point.pressure / delta - 1.0).abs() < 1e-9, "{:?}: {}", point.position, point.pressure);
    }
    let area = 0.1 * TAU * (1.0 - 0.16);
    let force: f64 = scene.nodes_of(0).map(|node| found.forces[node][2]).sum();
    // The sector's own area by parabolas; its walls reach δ into the block.
    assert!((force / (delta * area) - 1.0).abs() < 2e-3, "{force}");
}

/// A body nearly as large as the hole of its own shape that it fills.
#[test]
fn a_core_in_another_body() {
    let outer = ring(0.2, 1.0, [24, 3], 9, 0.0);
    let inner = ring(0.2 + 1e-4, 1.0 - 1e-4, [24, 3], 9, 0.0);
    let scene = Scene::of(&[&inner, &outer]);
    let found = scene.evaluate(depth(1.0));
    // ∫ of the distance from the rim over a ring, but for what is beside the middle.
    let area = std::f64::consts::PI * (1.0 - 0.04);
    // What is no deeper than a tent's top, 6e-3, lies beside flush faces, and is not told.
    assert!((found.pairs[0].volume / area - 1.0).abs() < 3e-2, "{}", found.pairs[0].volume);
    assert!(found.energy > 0.1 * area * 0.4, "{}", found.energy);
}

#[test]
fn smoothing_is_refused() {
    let scene = Scene::of(&[&ring(0.5, 1.0, [16, 2], 4, 0.0)]);
    let mut contact = scene.contact(depth(1.0));
    for angle in [-1.0, 90.0, f64::NAN] {
        assert!(contact.set_surface_smoothing(angle).is_err(), "{angle}");
    }
    contact.set_surface_smoothing(0.0).expect("none");
}

/// Faces of two rings that lie in the planes of a quarter are told of, as between straight ones, until it is said what they are.
#[test]
fn flush_faces_are_told() {
    let quarter = |from: f64, to: f64, cells, nodes| {
        let straight = rectangle_quad4([0.0, from], [1.0, to], cells);
        sector(if nodes == 4 { straight } else { second_order(&straight, nodes) }, TAU / 4.0)
    };
    let area = |nodes, smoothing| {
        let scene = Scene::of(&[&quarter(0.5, 1.0002, [16, 4], nodes), &quarter(1.0, 1.5, [21, 4], nodes)]);
        let mut contact = scene.contact(depth(1.0));
        contact.set_surface_smoothing(smoothing).expect("an angle");
        let told = |contact: &Contact<2>| {
            let found = contact.evaluate(&scene.coords).expect("valid coordinates");
            found
                .warnings
                .iter()
                .find_map(|w| if let Warning::FlushFaces { area, .. } = w { Some(*area) } else { None })
        };
        let before = told(&contact);
        contact.set_symmetry_planes(&[[[0.0; 2], [1.0, 0.0]], [[0.0; 2], [0.0, 1.0]]]).expect("planes");
        assert_eq!(told(&contact), None);
        before.expect("a warning")
    };
    let straight = area(4, 0.0);
    for (nodes, smoothing) in [(4, 30.0), (9, 0.0)] {
        assert!((area(nodes, smoothing) / straight - 1.0).abs() < 1e-6, "{nodes}: {straight}");
    }
}
