//! A body as a set of simplices, for the exact estimator.

use super::clip::Simplex;
use super::side::FacetSide;
use crate::geometry::aabb::Aabb;
use crate::geometry::cells::Cells;
use crate::geometry::tree::Tree;
use crate::geometry::{CellType, Vector};

/// The part of a body in a region, as simplices.
pub(crate) struct Solid<const D: usize> {
    simplices: Vec<Simplex<D>>,
    boxes: Vec<Aabb<D>>,
    /// Cell (or facet, for surfaces without cells) of every simplex.
    origins: Vec<u32>,
    tree: Tree<D>,
    /// Distances up to this are rounding.
    pub(crate) tie: f64,
}

impl<const D: usize> Solid<D> {
    /// Cells of one body that meet `region`: simplices as they are, others split about the centroids of the cell and of
    /// its faces, so that neighbours agree on the faces between them.
    pub(crate) fn from_cells(cells: &Cells, body: usize, coords: &[[f64; D]], region: &Aabb<D>) -> Self {
        let region = &region.inflated(region.rounding());
        let mut parts = Parts::default();
        for cell in 0..cells.len() {
            if cells.body[cell] as usize != body {
                continue;
            }
            let x: Vec<Vector<D>> = cells.nodes(cell).iter().map(|&n| coords[n as usize].into()).collect();
            if !Aabb::of(&x).meets(region) {
                continue;
            }
            let origin = cell as u32;
            let bounds = |face: usize| cells.boundary[cell] >> face & 1 == 1;
            let cell_type = cells.cell_type(cell);
            if matches!(cell_type, CellType::Tri3 | CellType::Tet4) {
                let opposite = |k: usize| cell_type.faces().iter().position(|f| !f.contains(&k)).is_some_and(bounds);
                parts.push(
                    &oriented(x, cells.is_flipped(cell)),
                    opposite_swapped(opposite, cells.is_flipped(cell)),
                    origin,
                    region,
                );
                continue;
            }
            let center = mean(&x);
            for face in 0..cell_type.faces().len() {
                let corners = cells.face_nodes(cell, face);
                let y: Vec<Vector<D>> = corners.iter().map(|&n| coords[n as usize].into()).collect();
                // Opposite to the last corner, the cell's centre, lies the face.
                let on_face = |k: usize| k == D && bounds(face);
                if D == 2 {
                    parts.push(&[y[0], y[1], center], on_face, origin, region);
                } else {
                    let middle = face_mean(&corners, coords);
                    for k in 0..4 {
                        parts.push(&[y[(k + 1) % 4], y[k], middle, center], on_face, origin, region);
                    }
                }
            }
        }
        parts.finish(region.rounding())
    }

    /// A body bounded by facets only, as signed simplices from its middle to every facet.
    pub(crate) fn from_facets(side: &FacetSide<D>, region: &Aabb<D>) -> Self {
        let region = &region.inflated(region.rounding());
        let mut parts = Parts::default();
        let center = side.aabb.center();
        for facet in 0..side.facets.len() {
            let x = side.corners(facet);
            let mut corners: Vec<Vector<D>> = x.to_vec();
            corners.push(center);
            if D == 3 {
                corners.swap(0, 1);
            }
            parts.push(&corners, |k| k == D, facet as u32, region);
        }
        parts.finish(region.rounding())
    }

    /// Calls `visit(simplex, origin)` for every simplex whose box meets `query`, in a fixed order.
    pub(crate) fn for_each_near(&self, query: &Aabb<D>, mut visit: impl FnMut(&Simplex<D>, u32)) {
        let mut found: Vec<u32> = Vec::new();
        let query = &query.inflated(self.tie);
        self.tree.visit(
            |aabb| aabb.meets(query),
            |s| {
                if self.boxes[s as usize].meets(query) {
                    found.push(s);
                }
            },
        );
        found.sort_unstable();
        for s in found {
            visit(&self.simplices[s as usize], self.origins[s as usize]);
        }
    }
}

#[derive(Default)]
struct Parts<const D: usize> {
    simplices: Vec<Simplex<D>>,
    boxes: Vec<Aabb<D>>,
    origins: Vec<u32>,
}

impl<const D: usize> Parts<D> {
    fn push(&mut self, corners: &[Vector<D>], boundary: impl Fn(usize) -> bool, origin: u32, region: &Aabb<D>) {
        let aabb = Aabb::of(corners);
        if !aabb.meets(region) {
            return;
        }
        if let Some(simplex) = Simplex::new(corners, boundary) {
            self.simplices.push(simplex);
            self.boxes.push(aabb);
            self.origins.push(origin);
        }
    }

    fn finish(self, tie: f64) -> Solid<D> {
        let tree = Tree::new(&self.boxes);
        Solid { simplices: self.simplices, boxes: self.boxes, origins: self.origins, tree, tie }
    }
}

/// Corners in the order that encloses a positive volume.
fn oriented<const D: usize>(mut corners: Vec<Vector<D>>, flipped: bool) -> Vec<Vector<D>> {
    if flipped {
        corners.swap(0, 1);
    }
    corners
}

/// `of(k)` for corners in the order of [`oriented`].
fn opposite_swapped(of: impl Fn(usize) -> bool, flipped: bool) -> impl Fn(usize) -> bool {
    move |k| of(if flipped && k < 2 { 1 - k } else { k })
}

fn mean<const D: usize>(x: &[Vector<D>]) -> Vector<D> {
    x.iter().fold(Vector::zeros(), |s, x| s + x) / x.len() as f64
}

/// Centroid of a face, summed in the order of node numbers: the same bits for both cells at the face.
fn face_mean<const D: usize>(nodes: &[u32], coords: &[[f64; D]]) -> Vector<D> {
    let mut nodes = nodes.to_vec();
    nodes.sort_unstable();
    mean(&nodes.iter().map(|&n| coords[n as usize].into()).collect::<Vec<_>>())
}
