//! What is written to look at.

use super::assembly::Assembly;
use super::division::Division;
use fmc_contact::overlap::FiberTrace;
use fmc_reference::mesh::{VtkCell, VtuWriter};

/// The meshes, with `contact_force` at the nodes, and `body` and `mesh` of the cells.
pub(super) fn forces<const D: usize>(assembly: &Assembly<D>, division: &Division, forces: &[[f64; D]]) -> VtuWriter {
    let mut picture = VtuWriter::default();
    for x in &assembly.coords {
        picture.point(in_space(x));
    }
    for (cell_type, nodes) in assembly.cells() {
        picture.cell(VtkCell::Mesh(cell_type), nodes.iter().map(|&node| node.into()));
    }
    picture.point_vectors("contact_force", &forces.iter().map(in_space).collect::<Vec<_>>());
    picture.cell_integers("body", &division.cell_bodies);
    let meshes = assembly.meshes.iter().enumerate();
    let meshes: Vec<i64> = meshes.flat_map(|(mesh, m)| std::iter::repeat_n(mesh as i64 + 1, m.cell_count())).collect();
    picture.cell_integers("mesh", &meshes);
    picture
}

/// An even selection of at most `most` fibers as lines, and their crossings as vertices: `crossing` of the cells is 0
/// for the one and 1 for the other, `fiber` is the number among all fibers in the overlap.
pub(super) fn fibers<const D: usize>(traces: &[FiberTrace<D>], most: usize) -> VtuWriter {
    let mut picture = VtuWriter::default();
    let shown = traces.len().min(most);
    let (mut crossing, mut fiber) = (Vec::new(), Vec::new());
    for number in (0..shown).map(|position| position * traces.len() / shown) {
        let trace = &traces[number];
        let ends = [&trace.start, &trace.end].map(|x| picture.point(in_space(x)));
        picture.cell(VtkCell::Line, ends);
        crossing.push(0);
        for x in &trace.crossings {
            let point = picture.point(in_space(x));
            picture.cell(VtkCell::Vertex, [point]);
            crossing.push(1);
        }
        fiber.resize(picture.cell_count(), number as i64);
    }
    picture.cell_integers("crossing", &crossing);
    picture.cell_integers("fiber", &fiber);
    picture
}

fn in_space<const D: usize>(x: &[f64; D]) -> [f64; 3] {
    std::array::from_fn(|axis| x.get(axis).copied().unwrap_or(0.0))
}
