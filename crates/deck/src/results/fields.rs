//! Fields of an equilibrium on the nodes.

use fmc_solid::fem::Stress;
use fmc_solid::statics::{Equilibrium, nodal_pressures};

/// Pressure of contact at every node, 0 where there is none.
pub(super) fn pressures<const D: usize>(at: &Equilibrium<D>) -> Vec<f64> {
    let (model, forces) = (at.model(), &at.balance().contact.forces);
    let mut pressures = vec![0.0; model.node_count()];
    for found in (0..model.parts().len()).flat_map(|part| nodal_pressures(model, part, forces)) {
        pressures[found.node] = found.pressure;
    }
    pressures
}

/// Stress at every node, carried there from the Gauss points: the mean of the cells about it, as CalculiX has it.
pub(super) fn stresses<const D: usize>(at: &Equilibrium<D>) -> Vec<Stress> {
    at.model().extrapolated_stresses(at.displacement())
}
