//! Fields of one state as an unstructured grid.

use fmc_mesh_io::{VtkCell, VtuWriter, in_space};
use fmc_solid::dynamics::Simulation;
use fmc_solid::fem::Model;
use fmc_solid::statics::{Equilibrium, nodal_pressures};

/// The bodies where they were at the start, with what a picture needs; ParaView's "Warp By Vector" deforms them.
///
/// Of the nodes: `displacement`, `velocity`, `contact_force`. Of the cells: `stress` (Cauchy: xx, yy, zz, xy, yz, xz),
/// `von_mises`, and `body`, the number of the body in the case, from 0.
pub(super) fn grid<const D: usize>(simulation: &Simulation<D>) -> VtuWriter {
    let state = simulation.state();
    let mut grid = bodies(simulation.model(), &state.displacement);
    grid.point_vectors("velocity", &vectors(&state.velocity));
    grid.point_vectors("contact_force", &vectors(&simulation.contact_forces().forces));
    grid
}

/// The same of an equilibrium; of the nodes instead of the velocity `contact_pressure` and `stress`, the mean of the
/// cells about each.
pub(super) fn grid_at_rest<const D: usize>(equilibrium: &Equilibrium<D>) -> VtuWriter {
    let model = equilibrium.model();
    let forces = &equilibrium.balance().contact.forces;
    let mut grid = bodies(model, equilibrium.displacement());
    grid.point_vectors("contact_force", &vectors(forces));
    let mut pressures = vec![[0.0]; model.node_count()];
    for at in (0..model.parts().len()).flat_map(|part| nodal_pressures(model, part, forces)) {
        pressures[at.node] = [at.pressure];
    }
    grid.point_floats("contact_pressure", &pressures);
    let stresses = model.nodal_stresses(&model.stresses(equilibrium.displacement()));
    grid.point_floats("stress", &stresses.iter().map(|stress| stress.0).collect::<Vec<_>>());
    grid
}

/// Cells with their bodies and stresses, and the displacement of the nodes.
fn bodies<const D: usize>(model: &Model<D>, displacement: &[[f64; D]]) -> VtuWriter {
    let mut grid = VtuWriter::default();
    for x in model.coords() {
        grid.point(in_space(x));
    }
    let mut bodies = Vec::with_capacity(model.cell_count());
    for number in 0..model.parts().len() {
        for (cell_type, nodes) in model.cells(number) {
            grid.cell(VtkCell::Mesh(cell_type), nodes.iter().map(|&node| node.into()));
            bodies.push(number as i64);
        }
    }
    grid.point_vectors("displacement", &vectors(displacement));
    let stresses = model.stresses(displacement);
    grid.cell_floats("stress", &stresses.iter().map(|stress| stress.0).collect::<Vec<_>>());
    grid.cell_floats("von_mises", &stresses.iter().map(|stress| [stress.von_mises()]).collect::<Vec<_>>());
    grid.cell_integers("body", &bodies);
    grid
}

fn vectors<const D: usize>(values: &[[f64; D]]) -> Vec<[f64; 3]> {
    values.iter().map(in_space).collect()
}
