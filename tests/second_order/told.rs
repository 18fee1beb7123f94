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
    let (both, tangent) = contact.evaluate_with_tangent(&coords, TangentPart::Full).expect("both");
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
