//! Fields of an equilibrium on the nodes.

use crate::analysis::area;
use fmc_solid::fem::{Model, Stress};
use fmc_solid::statics::{Equilibrium, nodal_pressures};

/// Part of a node's share of the surface that is in contact, below which the node has no pressure: at the far end of a face that another
/// body touches at its edge alone, it is the square of the penetration by the size of the face.
const TOUCHED: f64 = 1e-2;

/// Pressure of contact at every node, 0 where there is none: the normal force by the node's part of the surface. Only nodes whose own faces
/// are in contact have one: ties have none, and of friction nothing counts.
pub(super) fn pressures<const D: usize>(at: &Equilibrium<D>) -> Vec<f64> {
    let (model, mut forces) = (at.model(), at.balance().contact.forces.clone());
    if let Ok(nodal) = at.nodal_contact() {
        let shares = shares(model);
        for (node, force) in forces.iter_mut().enumerate() {
            // None where nothing touches: ties, and what the law passes on to nodes inside.
            let normal = nodal.normal[node];
            let along: f64 = force.iter().zip(normal).map(|(f, n)| f * n).sum();
            let along = if nodal.area[node] > TOUCHED * shares[node] { along.min(0.0) } else { 0.0 };
            *force = normal.map(|n| along * n);
        }
    }
    let mut pressures = vec![0.0; model.node_count()];
    for found in (0..model.parts().len()).flat_map(|part| nodal_pressures(model, part, &forces)) {
        pressures[found.node] = found.pressure;
    }
    pressures
}

/// Area of the faces about every node, each in equal parts.
fn shares<const D: usize>(model: &Model<D>) -> Vec<f64> {
    let mut shares = vec![0.0; model.node_count()];
    for face in (0..model.parts().len()).flat_map(|part| model.faces_where(part, |_| true)) {
        let area = area(model.coords(), &face.nodes);
        face.nodes.iter().for_each(|&node| shares[node as usize] += area / face.nodes.len() as f64);
    }
    shares
}

/// Stress at every node, carried there from the Gauss points: the mean of the cells about it, as CalculiX has it.
pub(super) fn stresses<const D: usize>(at: &Equilibrium<D>) -> Vec<Stress> {
    at.model().extrapolated_stresses(at.displacement())
}
