//! The points at which a cell is divided: its corners, the middles of edges and quadrilaterals, and its own.

use crate::geometry::CellType;

/// The points of a cell's division by local number: corners, middles of edges, of quadrilateral faces, of the cell.
#[derive(Clone, Copy)]
pub(super) struct Entities {
    /// Corners.
    pub(super) corners: usize,
    /// Ends of every edge with a node in its middle.
    pub(super) edges: &'static [[usize; 2]],
    /// Corners of every quadrilateral that is divided; in 2D the cell itself.
    pub(super) quads: &'static [[usize; 4]],
    /// Whether the cell is divided at its own middle, beside those of quadrilaterals.
    pub(super) has_middle: bool,
}

const HEX_EDGES: [[usize; 2]; 12] =
    [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4], [0, 4], [1, 5], [2, 6], [3, 7]];
const HEX_QUADS: [[usize; 4]; 6] = [[0, 4, 7, 3], [1, 2, 6, 5], [0, 1, 5, 4], [3, 7, 6, 2], [0, 3, 2, 1], [4, 5, 6, 7]];

impl Entities {
    /// Those of a cell of second order; `None` for straight cells.
    pub(super) fn of(cell_type: CellType) -> Option<Self> {
        let of = |corners, edges, quads, has_middle| Some(Self { corners, edges, quads, has_middle });
        match cell_type {
            CellType::Tri6 => of(3, &[[0, 1], [1, 2], [2, 0]], &[], false),
            CellType::Quad8 | CellType::Quad9 => of(4, &[[0, 1], [1, 2], [2, 3], [3, 0]], &[[0, 1, 2, 3]], false),
            CellType::Tet10 => of(4, &[[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]], &[], false),
            CellType::Hex20 | CellType::Hex27 => of(8, &HEX_EDGES, &HEX_QUADS, true),
            CellType::Wedge15 => of(
                6,
                &[[0, 1], [1, 2], [2, 0], [3, 4], [4, 5], [5, 3], [0, 3], [1, 4], [2, 5]],
                &[[0, 1, 4, 3], [1, 2, 5, 4], [2, 0, 3, 5]],
                false,
            ),
            CellType::Pyramid13 => {
                of(5, &[[0, 1], [1, 2], [2, 3], [3, 0], [0, 4], [1, 4], [2, 4], [3, 4]], &[[0, 3, 2, 1]], false)
            }
            _ => None,
        }
    }

    /// How many points there are.
    pub(super) fn count(&self) -> usize {
        self.corners + self.edges.len() + self.quads.len() + usize::from(self.has_middle)
    }

    /// The point half-way between two corners: a corner, the middle of an edge, of a quadrilateral, or of the cell.
    pub(super) fn between(&self, p: usize, q: usize) -> usize {
        if p == q {
            return p;
        }
        if let Some(edge) = self.edges.iter().position(|ends| ends.contains(&p) && ends.contains(&q)) {
            return self.corners + edge;
        }
        let quad = self.quads.iter().position(|quad| quad.contains(&p) && quad.contains(&q));
        self.corners + self.edges.len() + quad.unwrap_or(self.quads.len())
    }

    /// The corners around a point: itself, both ends, the four of a quadrilateral, or all.
    pub(super) fn around(&self, point: usize) -> Vec<usize> {
        let of_edges = self.corners + self.edges.len();
        match point {
            corner if corner < self.corners => vec![corner],
            edge if edge < of_edges => self.edges[edge - self.corners].to_vec(),
            quad if quad < of_edges + self.quads.len() => self.quads[quad - of_edges].to_vec(),
            _ => (0..self.corners).collect(),
        }
    }
}
