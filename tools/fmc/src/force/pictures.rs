//! What is written to look at.

use super::assembly::Assembly;
use super::division::Division;
use fmc_contact::contact::NodalContact;
use fmc_mesh_io::{VtkCell, VtuWriter, in_space};

/// The meshes, with force, pressure, gap, area and normal of the contact at the nodes, and `body` and `mesh` of the cells.
pub(super) fn forces<const D: usize>(
    assembly: &Assembly<D>,
    division: &Division,
    forces: &[[f64; D]],
    contact: &NodalContact<D>,
) -> VtuWriter {
    let vectors = |values: &[[f64; D]]| values.iter().map(in_space).collect::<Vec<_>>();
    let scalars = |values: &[f64]| values.iter().map(|&value| [value]).collect::<Vec<_>>();
    let mut picture = VtuWriter::default();
    for x in &assembly.coords {
        picture.point(in_space(x));
    }
    for (cell_type, nodes) in assembly.cells() {
        picture.cell(VtkCell::Mesh(cell_type), nodes.iter().map(|&node| node.into()));
    }
    picture.point_vectors("contact_force", &vectors(forces));
    picture.point_floats("contact_pressure", &scalars(&contact.pressure));
    picture.point_floats("contact_gap", &scalars(&contact.gap));
    picture.point_floats("contact_area", &scalars(&contact.area));
    picture.point_vectors("contact_normal", &vectors(&contact.normal));
    picture.cell_integers("body", &division.cell_bodies);
    let meshes = assembly.meshes.iter().enumerate();
    let meshes: Vec<i64> = meshes.flat_map(|(mesh, m)| std::iter::repeat_n(mesh as i64 + 1, m.cell_count())).collect();
    picture.cell_integers("mesh", &meshes);
    picture
}
