//! What hosts are told of cells of second order: facets, points, nodes, constraints, time steps.

use crate::scene::{exact, table::exactly};
use crate::{boxes, pair, rectangles};
use fmc_contact::contact::TangentPart;
use fmc_contact::{CellType, EnergyLaw, Estimator, Options};
use std::collections::BTreeSet;

#[test]
fn boundary_facets_name_cells_and_faces_as_given() {
    for mesh in boxes([0.0; 3], [1.0; 3], [2, 2, 2]) {
        let scene = pair(&mesh, &mesh);
        let cell_type = scene.blocks[0].0;
        let surface = scene.surface();
        let facets = surface.boundary_facets();
        assert_eq!(facets.len(), surface.facet_count());
        let whole: BTreeSet<_> =
            facets.iter().map(|f| (f.cell.expect("a cell"), f.local_face.expect("a face"))).collect();
        assert_eq!(whole.len(), surface.faces().len(), "{cell_type:?}");
        assert!(whole.iter().all(|(cell, face)| *cell < 2 * mesh.cell_count() && *face < cell_type.faces().len()));
        for (_, corners) in surface.faces() {
            assert!(corners.iter().all(|&node| (node as usize) < scene.coords.len()));
        }
    }
}

/// Pressure at every node of a face in contact, corners whose shape functions have no integral included.
#[test]
fn pressure_at_nodes() {
    let delta = 1e-3;
    let lower = boxes([-0.5, -0.5, -1.0], [1.5, 1.5, 0.0], [2; 3]);
    for (k, upper) in boxes([0.0, 0.0, -delta], [1.0, 1.0, 1.0], [2; 3]).iter().enumerate() {
        let scene = pair(&lower[k], upper);
        let field = scene.contact(exactly(EnergyLaw::fiber(7.0))).nodal_contact(&scene.coords).expect("a contact");
        assert_eq!(field.pressure.len(), scene.coords.len());
        for node in scene.nodes_of(1).filter(|&node| scene.coords[node][2] < 0.0) {
            assert!((field.pressure[node] - 7.0 * delta).abs() < 1e-9, "{}", field.pressure[node]);
            assert!((field.normal[node][2] + 1.0).abs() < 1e-9 && field.area[node] > 0.0);
        }
    }
}

/// g = ∫ N φ dA by row, its derivative by differences of the nodes.
#[test]
fn gap_constraints_have_derivatives_of_nodes() {
    let lower = rectangles([-0.5, -1.0], [1.5, 0.0], [3, 2]).swap_remove(1);
    let upper = rectangles([0.0, 0.02], [1.0, 1.0], [2, 2]).swap_remove(0);
    let scene = pair(&lower, &upper);
    let coords = crate::shaken(&scene.coords, 0.005, 3);
    let contact = scene.contact(exact());
    let at = contact.gap_constraints(&coords, 0.2).expect("gaps");
    assert!(at.gaps.len() > 5 && at.columns.iter().all(|&node| (node as usize) < coords.len()));
    for node in (0..coords.len()).step_by(5) {
        let at_step = |h: f64| {
            let mut moved = coords.clone();
            moved[node][1] += h;
            contact.gap_constraints(&moved, 0.2).expect("gaps").gaps
        };
        let (plus, minus) = (at_step(1e-6), at_step(-1e-6));
        for row in 0..at.gaps.len() {
            let slope = (plus[row] - minus[row]) / 2e-6;
            let entries = at.row_starts[row]..at.row_starts[row + 1];
            let found = entries.filter(|&k| at.columns[k] as usize == node).map(|k| at.slopes[k][1]).sum::<f64>();
            assert!((found - slope).abs() < 1e-6, "{found} for {slope}");
        }
    }
}

#[test]
fn overlaps_tangents_and_time_steps_are_those_of_nodes() {
    let lower = boxes([0.0, 0.0, -1.0], [1.0, 1.0, 0.0], [2; 3]).swap_remove(1);
    let upper = boxes([0.1, 0.2, -0.1], [0.9, 0.9, 0.5], [2; 3]).swap_remove(3);
    let scene = pair(&lower, &upper);
    let coords = crate::shaken(&scene.coords, 0.01, 5);
    let options =
        Options { estimator: Estimator::Exact, ..Options::new(EnergyLaw::Volume { stiffness: 3.0, exponent: 2.0 }) };
    let contact = scene.contact(options);
    let overlap = contact.overlaps(&coords).expect("an overlap").swap_remove(0);
    let forces = contact.evaluate(&coords).expect("forces");
    let mut sum = vec![[0.0; 3]; coords.len()];
    for (&node, gradient) in overlap.nodes.iter().zip(&overlap.gradient) {
        (0..3).for_each(|axis| sum[node as usize][axis] -= forces.pairs[0].pressure * gradient[axis]);
    }
    assert!(crate::scene::distance(&sum, &forces.forces) < 1e-12 * crate::scene::norm(&sum));
    let (both, tangent) = contact.evaluate_tangent(&coords, TangentPart::Full).expect("both");
    assert_eq!(both, forces);
    assert!(tangent.blocks.is_sorted_by_key(|block| (block.row, block.col)));
    assert!(tangent.places().all(|(row, col)| (row.max(col) as usize) < coords.len()));
    let masses = vec![1.0; coords.len()];
    let step = contact.stable_step(&coords, &masses).expect("a step");
    assert!(step.is_finite() && step > 0.0);
    let refused = contact.stable_step(&coords, &masses[1..]).err();
    assert!(matches!(refused, Some(fmc_contact::Error::Length { array: "masses", .. })));
    assert_eq!(scene.blocks[0].0, CellType::Hex20);
}

/// P takes nodes to points, its transpose the forces at contact points to the nodes.
#[test]
fn points_are_combinations_of_nodes() {
    let lower = boxes([-0.5, -0.5, -1.0], [1.5, 1.5, 0.0], [2; 3]);
    for (k, upper) in boxes([0.0, 0.0, -1e-3], [1.0, 1.0, 1.0], [2; 3]).iter().enumerate() {
        let scene = pair(&lower[k], upper);
        let coords = &scene.coords;
        let contact = scene.contact(exactly(EnergyLaw::fiber(7.0)));
        let weights = contact.point_weights();
        let has_middles = matches!(scene.blocks[0].0, CellType::Tet10 | CellType::Hex27);
        assert_eq!(weights.point_count() == coords.len(), has_middles, "{:?}", scene.blocks[0].0);
        let at = |point: u32| {
            let row = weights.row(point as usize);
            row.fold([0.0; 3], |x, (node, w)| std::array::from_fn(|axis| x[axis] + w * coords[node as usize][axis]))
        };
        for point in 0..weights.point_count() {
            assert!((weights.row(point).map(|(_, w)| w).sum::<f64>() - 1.0).abs() < 1e-14);
        }
        let named = contact.boundary_facets().into_iter().flat_map(|facet| facet.nodes).max();
        assert!(named.is_some_and(|point| (point as usize) < weights.point_count()));
        let mut lifts = vec![0.0; coords.len()];
        for point in contact.contact_points(coords).expect("points") {
            for (side, sign) in point.sides.iter().zip([-1.0, 1.0]) {
                let lift = sign * point.pressure * point.area * point.normal[2];
                let mut place = [0.0; 3];
                for (&number, &weight) in side.nodes[..side.node_count].iter().zip(&side.weights) {
                    (0..3).for_each(|axis| place[axis] += weight * at(number)[axis]);
                    for (node, part) in weights.row(number as usize) {
                        lifts[node as usize] += lift * weight * part;
                    }
                }
                assert!(place.iter().zip(&side.position).all(|(a, b)| (a - b).abs() < 1e-12), "{place:?}");
            }
        }
        // The pressure is uniform, so that a point in the middle of its piece stands for all of it.
        let forces = contact.evaluate(coords).expect("forces").forces;
        assert!(lifts.iter().any(|lift| *lift > 1e-4));
        for (node, lift) in lifts.iter().enumerate() {
            assert!((lift - forces[node][2]).abs() < 1e-12, "{lift} for {}", forces[node][2]);
        }
    }
}

#[test]
fn straight_cells_have_their_nodes_as_points() {
    let mesh = fmc_shapes::cuboid_hex8([0.0; 3], [1.0; 3], [1; 3]);
    let weights = pair(&mesh, &mesh).surface().point_weights();
    assert_eq!(weights.point_count(), 16);
    assert_eq!((weights.starts, weights.weights), ((0..=16).collect(), vec![1.0; 16]));
    assert_eq!(weights.nodes, (0..16).collect::<Vec<_>>());
}
