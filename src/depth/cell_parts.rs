//! Cells as simplices, with what their corners are made of.

use crate::geometry::CellType;
use crate::geometry::cells::Cells;

/// A corner of a part of a cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Corner {
    /// A node of the cell, by its place there.
    Node(usize),
    /// The mean of the nodes of a face.
    Face(usize),
    /// The mean of all nodes.
    Middle,
}

/// A simplex of a cell: D + 1 corners that make a positive volume in a cell which does.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    pub(super) corners: [Corner; 4],
    /// The face of the cell in which the simplex's face opposite to its last corner lies.
    pub(super) face: Option<usize>,
}

/// The parts of a cell: triangles and tetrahedra as they are, others split about the centroids of the cell and of its
/// faces, as facets and exact clipping have it. The parts of such a cell have one face on the cell's.
pub(super) fn parts(cell_type: CellType) -> impl Iterator<Item = Part> {
    let whole = matches!(cell_type, CellType::Tri3 | CellType::Tet4);
    let of_whole = whole.then(|| Part { corners: std::array::from_fn(Corner::Node), face: None });
    let of_faces = if whole { 0..0 } else { 0..cell_type.faces().len() };
    of_whole.into_iter().chain(of_faces.flat_map(move |f| {
        let face = cell_type.faces()[f];
        let sides = if face.len() == 2 { 0..1 } else { 0..face.len() };
        sides.map(move |k| {
            let corners = match face.len() {
                2 => [Corner::Node(face[0]), Corner::Node(face[1]), Corner::Middle, Corner::Middle],
                // Seen from inside, the nodes of the face run clockwise.
                count => [Corner::Node(face[(k + 1) % count]), Corner::Node(face[k]), Corner::Face(f), Corner::Middle],
            };
            Part { corners, face: Some(f) }
        })
    }))
}

/// Whether face `opposite` of a part (opposite to that corner) lies on face `f` of a cell.
pub(super) fn cell_face(cell_type: CellType, dimension: usize, part: &Part, opposite: usize) -> Option<usize> {
    match part.face {
        Some(face) => (opposite == dimension).then_some(face),
        None => cell_type.faces().iter().position(|face| !face.contains(&opposite)),
    }
}

/// Weights of a cell's nodes in a corner.
pub(super) fn weights(cells: &Cells, cell: usize, corner: Corner) -> [f64; 8] {
    let mut weights = [0.0; 8];
    match corner {
        Corner::Node(node) => weights[node] = 1.0,
        Corner::Face(face) => {
            let nodes = cells.cell_type(cell).faces()[face];
            nodes.iter().for_each(|&node| weights[node] = 1.0 / nodes.len() as f64);
        }
        Corner::Middle => {
            let count = cells.nodes(cell).len();
            weights[..count].fill(1.0 / count as f64);
        }
    }
    weights
}
