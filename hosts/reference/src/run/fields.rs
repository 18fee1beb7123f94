//! Fields of one step as an unstructured grid.

use crate::dynamics::Simulation;
use crate::mesh::{VtkCell, VtuWriter};

/// The bodies where they were at the start, with what a picture needs; ParaView's "Warp By Vector" deforms them.
///
/// Of the nodes: `displacement`, `velocity`, `contact_force`. Of the cells: `stress` (Cauchy: xx, yy, zz, xy, yz, xz),
/// `von_mises`, and `body`, the number of the body in the case, from 0.
pub(super) fn grid<const D: usize>(simulation: &Simulation<D>) -> VtuWriter {
    let model = simulation.model();
    let mut grid = VtuWriter::default();
    for x in model.coords() {
        grid.point(in_space(x));
    }
    let mut bodies = Vec::with_capacity(model.cell_count());
    for (number, part) in model.parts().iter().enumerate() {
        for nodes in model.conn(number).chunks_exact(part.cell_type.node_count()) {
            grid.cell(VtkCell::Mesh(part.cell_type), nodes.iter().map(|&node| node.into()));
            bodies.push(number as i64);
        }
    }
    let state = simulation.state();
    let vectors = |values: &[[f64; D]]| values.iter().map(in_space).collect::<Vec<_>>();
    grid.point_vectors("displacement", &vectors(&state.displacement));
    grid.point_vectors("velocity", &vectors(&state.velocity));
    grid.point_vectors("contact_force", &vectors(&simulation.contact_forces().forces));
    let stresses = model.stresses(&state.displacement);
    grid.cell_floats("stress", &stresses.iter().map(|stress| stress.0).collect::<Vec<_>>());
    grid.cell_floats("von_mises", &stresses.iter().map(|stress| [stress.von_mises()]).collect::<Vec<_>>());
    grid.cell_integers("body", &bodies);
    grid
}

fn in_space<const D: usize>(x: &[f64; D]) -> [f64; 3] {
    std::array::from_fn(|axis| x.get(axis).copied().unwrap_or(0.0))
}
