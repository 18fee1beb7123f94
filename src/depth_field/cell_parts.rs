//! Cells as simplices.

use crate::geometry::CellType;

/// A simplex of a cell: D + 1 corners that make a positive volume in a cell which does.
///
/// Corners are numbers: first those of the cell's nodes, then those of its points. Cells that are no simplices have points
/// at the centroids of their faces, one after the other, and then in the middle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Part {
    pub(super) corners: [u8; 4],
    /// The face of the cell in which the simplex's face opposite to its last corner lies.
    face: Option<usize>,
}

impl Part {
    /// The face of the cell on which the part's face opposite to a corner lies, if it lies on one.
    pub(super) fn cell_face(&self, cell_type: CellType, opposite: usize) -> Option<usize> {
        match self.face {
            Some(face) => (opposite == cell_type.dimension()).then_some(face),
            None => cell_type.faces().iter().position(|face| !face.contains(&opposite)),
        }
    }
}

/// The parts of a cell: triangles and tetrahedra as they are, others split about the centroids of the cell and of its
/// quadrilateral faces, as facets and exact clipping have it. The parts of such a cell have one face on the cell's.
pub(super) fn parts(cell_type: CellType) -> impl Iterator<Item = Part> {
    let whole = cell_type.is_simplex();
    let of_whole = whole.then_some(Part { corners: [0, 1, 2, 3], face: None });
    let faces = cell_type.faces();
    let first_point = cell_type.node_count();
    let middle = (first_point + faces.len()) as u8;
    let of_faces = if whole { 0..0 } else { 0..faces.len() };
    of_whole.into_iter().chain(of_faces.flat_map(move |f| {
        let face = faces[f];
        let count = face.len();
        let centroid = (first_point + f) as u8;
        let sides = if count == 4 { 0..count } else { 0..1 };
        sides.map(move |k| {
            let [p, q] = [face[k] as u8, face[(k + 1) % count] as u8];
            // Seen from inside, the nodes of the face run clockwise.
            let corners = match count {
                2 => [p, q, middle, middle],
                3 => [q, p, face[2] as u8, middle],
                _ => [q, p, centroid, middle],
            };
            Part { corners, face: Some(f) }
        })
    }))
}

/// Weights of a cell's nodes in the points that every cell of the type has: the centroids of faces, then the middle.
pub(super) fn own_points(cell_type: CellType) -> impl Iterator<Item = [f64; 8]> {
    let all = if cell_type.is_simplex() { 0..0 } else { 0..cell_type.faces().len() + 1 };
    all.map(move |point| match cell_type.faces().get(point) {
        Some(face) => mean(face.iter().copied()),
        None => mean(0..cell_type.node_count()),
    })
}

/// Weights of a cell's nodes in the mean of some of them.
pub(super) fn mean(nodes: impl ExactSizeIterator<Item = usize>) -> [f64; 8] {
    let mut weights = [0.0; 8];
    let weight = 1.0 / nodes.len() as f64;
    nodes.for_each(|node| weights[node] = weight);
    weights
}
