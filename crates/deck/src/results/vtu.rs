//! An equilibrium for ParaView.

use super::fields::{pressures, stresses};
use crate::read::Deck;
use fmc_mesh_io::{VtkCell, VtuWriter, in_space};
use fmc_solid::statics::Equilibrium;

/// The bodies where they were, undeformed. Of the nodes: `displacement`, `contact_force`, `contact_pressure`, `stress` (Cauchy: xx, yy, zz,
/// xy, yz, xz; carried there from the Gauss points, the mean of the cells about each), `reaction`, `label`. Of the cells: `stress`, `von_mises`, `body` from 0, `label`.
pub fn vtu<const D: usize>(deck: &Deck, order: &[Vec<usize>; 2], at: &Equilibrium<D>) -> VtuWriter {
    let model = at.model();
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
    let vectors = |values: &[[f64; D]]| values.iter().map(in_space).collect::<Vec<_>>();
    let balance = at.balance();
    let mut reactions = vec![[0.0; D]; model.node_count()];
    at.problem().supports.iter().for_each(|(node, axis, _)| reactions[node][axis] = balance.residual[node][axis]);
    grid.point_vectors("displacement", &vectors(at.displacement()));
    grid.point_vectors("contact_force", &vectors(&balance.contact.forces));
    grid.point_vectors("reaction", &vectors(&reactions));
    grid.point_floats("contact_pressure", &pressures(at).into_iter().map(|p| [p]).collect::<Vec<_>>());
    grid.point_floats("stress", &stresses(at).into_iter().map(|stress| stress.0).collect::<Vec<_>>());
    grid.point_floats("label", &order[0].iter().map(|&node| [deck.mesh.node_tags[node] as f64]).collect::<Vec<_>>());
    let cells = model.stresses(at.displacement());
    grid.cell_floats("stress", &cells.iter().map(|stress| stress.0).collect::<Vec<_>>());
    grid.cell_floats("von_mises", &cells.iter().map(|stress| [stress.von_mises()]).collect::<Vec<_>>());
    grid.cell_integers("body", &bodies);
    let labels: Vec<u64> = deck.mesh.cells().map(|(_, _, label, _)| label).collect();
    grid.cell_integers("label", &order[1].iter().map(|&cell| labels[cell] as i64).collect::<Vec<_>>());
    grid
}
