//! The simplices of cells on which their depth is linear.

/// Nodes that a cell has at most.
pub(crate) const MOST_NODES: usize = 8;

/// A point of a cell that is no node.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct CellPoint {
    /// Weights of the cell's nodes.
    pub(super) weights: [f64; MOST_NODES],
    /// Its depth; `None` for that of the nodes, interpolated.
    pub(super) depth: Option<f64>,
}

impl CellPoint {
    /// Its depth, given those of the cell's nodes.
    pub(super) fn depth(&self, of_node: impl Fn(usize) -> f64, node_count: usize) -> f64 {
        self.depth.unwrap_or_else(|| (0..node_count).map(|n| self.weights[n] * of_node(n)).sum())
    }
}

/// A simplex of a cell on which its depth is linear.
#[derive(Clone, Copy, Debug)]
pub(super) struct CellSimplex {
    /// Numbers of its corners: first the cell's nodes, then its points.
    pub(super) corners: [u8; 4],
    /// Whether the depth is the height above a facet of the body, which the simplex has for a face.
    pub(super) is_at_surface: bool,
}

/// Points and simplices of several cells, one after the other.
#[derive(Default)]
pub(super) struct Divisions {
    points: Vec<CellPoint>,
    simplices: Vec<CellSimplex>,
    /// Where those of each end.
    ends: Vec<[usize; 2]>,
}

impl Divisions {
    /// Adds a division, which has this number from now on.
    pub(super) fn add(&mut self, points: &[CellPoint], simplices: &[CellSimplex]) -> u32 {
        self.points.extend_from_slice(points);
        self.simplices.extend_from_slice(simplices);
        self.ends.push([self.points.len(), self.simplices.len()]);
        self.ends.len() as u32 - 1
    }

    pub(super) fn get(&self, number: u32) -> (&[CellPoint], &[CellSimplex]) {
        let number = number as usize;
        let [points, simplices] = number.checked_sub(1).map_or([0; 2], |before| self.ends[before]);
        let end = self.ends[number];
        (&self.points[points..end[0]], &self.simplices[simplices..end[1]])
    }
}
