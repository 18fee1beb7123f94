//! An equilibrium for ParaView.

use super::fields::{pressures, stresses};
use crate::read::Deck;
use crate::{ReferenceResult, StepResult};
use fmc_mesh_io::{VtkCell, VtuWriter, in_space};
use fmc_solid::statics::Equilibrium;

/// The bodies where they were, undeformed. Of the nodes: `displacement`, `contact_force`, `contact_pressure`, `stress` (Cauchy: xx, yy, zz,
/// xy, yz, xz; carried there from the Gauss points, the mean of the cells about each), `reaction`, `label`. Of the cells: `stress`, `von_mises`, `body` from 0, `label`.
/// Reference nodes that belong to no element are points and cells of their own, of body −1; with any reference node points have a `reaction_moment`.
pub fn vtu<const D: usize>(deck: &Deck, order: &[Vec<usize>; 3], at: &Equilibrium<D>, step: &StepResult) -> VtuWriter {
    let model = at.model();
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
    // Reference nodes that no body has.
    let apart: Vec<&ReferenceResult> = step.references.iter().filter(|reference| reference.own.is_none()).collect();
    for &node in &order[2] {
        let point = grid.point(deck.mesh.points[node]);
        grid.cell(VtkCell::Vertex, [point]);
        bodies.push(-1);
    }
    let of_nodes = |values: &[[f64; D]], more: &dyn Fn(&ReferenceResult) -> [f64; 3]| -> Vec<[f64; 3]> {
        values.iter().map(in_space).chain(apart.iter().map(|reference| more(reference))).collect()
    };
    let nothing = |_: &ReferenceResult| [0.0; 3];
    let contact = &at.balance().contact;
    grid.point_vectors("displacement", &of_nodes(at.displacement(), &|reference| reference.displacement));
    let touch: Vec<[f64; D]> = contact.forces.iter().map(|force| force.map(|f| step.thickness * f)).collect();
    grid.point_vectors("contact_force", &of_nodes(&touch, &nothing));
    grid.point_vectors("reaction", &step.reactions);
    if !step.references.is_empty() {
        let mut moments = of_nodes(&vec![[0.0; D]; model.node_count()], &|reference| reference.moment);
        let own = step.references.iter().filter_map(|reference| Some((reference.own?, reference.moment)));
        own.for_each(|(node, moment)| moments[node] = moment);
        grid.point_vectors("reaction_moment", &moments);
    }
    let zeros = order[2].len();
    grid.point_floats("contact_pressure", &with_zeros(pressures(at).into_iter().map(|p| [p]), zeros));
    grid.point_floats("stress", &with_zeros(stresses(at).into_iter().map(|stress| stress.0), zeros));
    let nodes = order[0].iter().chain(&order[2]);
    grid.point_floats("label", &nodes.map(|&node| [deck.mesh.node_tags[node] as f64]).collect::<Vec<_>>());
    let cells = model.stresses(at.displacement());
    grid.cell_floats("stress", &with_zeros(cells.iter().map(|stress| stress.0), zeros));
    grid.cell_floats("von_mises", &with_zeros(cells.iter().map(|stress| [stress.von_mises()]), zeros));
    grid.cell_integers("body", &bodies);
    let labels: Vec<u64> = deck.mesh.cells().map(|(_, _, label, _)| label).collect();
    let of_cells = order[1].iter().map(|&cell| labels[cell] as i64);
    grid.cell_integers("label", &of_cells.chain(std::iter::repeat_n(0, zeros)).collect::<Vec<_>>());
    grid
}

/// Values, and zeros of reference nodes behind them.
fn with_zeros<const N: usize>(values: impl Iterator<Item = [f64; N]>, zeros: usize) -> Vec<[f64; N]> {
    values.chain(std::iter::repeat_n([0.0; N], zeros)).collect()
}
