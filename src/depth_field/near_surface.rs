//! What is known of the surface where cells are divided.

use super::distances::Distances;
use crate::geometry::Vector;
use crate::geometry::mesh::cells::Cells;
use rustc_hash::FxHashSet;

/// The surface seen from cells that have nodes on it.
pub(super) struct NearSurface<'a, const D: usize> {
    pub(super) cells: &'a Cells,
    coords: &'a [[f64; D]],
    /// Depth of every node.
    depths: &'a [f64],
    surface_faces: &'a [u8],
    surface_edges: FxHashSet<[u32; 2]>,
    distances: &'a Distances<'a, D>,
}

impl<'a, const D: usize> NearSurface<'a, D> {
    /// For nodes of these depths; bit f of a cell is set where its face f is surface.
    pub(super) fn new(
        cells: &'a Cells,
        coords: &'a [[f64; D]],
        depths: &'a [f64],
        surface_faces: &'a [u8],
        distances: &'a Distances<'a, D>,
    ) -> Self {
        let mut surface_edges = FxHashSet::default();
        for cell in 0..cells.len() {
            for face in (0..8).filter(|face| surface_faces[cell] >> face & 1 == 1) {
                let nodes = cells.face_nodes(cell, face);
                let next = nodes.iter().cycle().skip(1);
                surface_edges.extend(nodes.iter().zip(next).map(|(&p, &q)| in_order(p, q)));
            }
        }
        Self { cells, coords, depths, surface_faces, surface_edges, distances }
    }

    pub(super) fn is_surface(&self, cell: usize, face: usize) -> bool {
        self.surface_faces[cell] >> face & 1 == 1
    }

    /// Whether an edge belongs to a face of the surface.
    pub(super) fn is_surface_edge(&self, p: u32, q: u32) -> bool {
        self.surface_edges.contains(&in_order(p, q))
    }

    pub(super) fn depth(&self, node: u32) -> f64 {
        self.depths[node as usize]
    }

    /// The point of a cell at which its nodes have these weights.
    pub(super) fn place(&self, cell: usize, weights: &[f64; 8]) -> Vector<D> {
        let terms = self.cells.nodes(cell).iter().zip(weights).map(|(&n, &w)| self.node(n) * w);
        terms.fold(Vector::zeros(), |x, term| x + term)
    }

    /// Distance of such a point from the surface of the body, and the nearest facet.
    pub(super) fn distance(&self, cell: usize, weights: &[f64; 8]) -> (f64, u32) {
        let x = self.place(cell, weights);
        // No farther than a node on the surface.
        let on_surface = self.cells.nodes(cell).iter().find(|&&n| self.depth(n) == 0.0);
        let limit = on_surface.map_or(f64::INFINITY, |&n| (x - self.node(n)).norm());
        self.distances.of_point(self.cells.body[cell] as usize, &x, limit)
    }

    fn node(&self, node: u32) -> Vector<D> {
        self.coords[node as usize].into()
    }
}

fn in_order(p: u32, q: u32) -> [u32; 2] {
    [p.min(q), p.max(q)]
}
