//! A body as a set of simplices, for the exact estimator.

use super::cell_simplices::for_each_simplex;
use super::cell_walk::{CellWalk, Slab};
use super::near_facets::Facets;
use crate::configuration::FacetSide;
use crate::geometry::mesh::cells::Cells;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::simplex::Simplex;
use crate::geometry::primitives::tree::Tree;

/// A body as simplices that can be found by place.
pub(crate) enum Solid<'a, const D: usize> {
    /// Cells that are walked to from the boundary facets near by. It serves facets that the boundary comes near to.
    Cells {
        cells: &'a Cells,
        coords: &'a [[f64; D]],
        /// Boundary facets of the body in the region of interest, and the cell of each facet of the body.
        facets: &'a Facets<D>,
        facet_cell: &'a [u32],
    },
    /// Simplices in a tree.
    Simplices {
        simplices: Vec<Simplex<D>>,
        boxes: Vec<Aabb<D>>,
        /// Cell (or facet, for surfaces without cells) of every simplex.
        origins: Vec<u32>,
        tree: Tree<D>,
    },
}

impl<const D: usize> Solid<'_, D> {
    /// All cells of one body.
    pub(crate) fn from_cells(cells: &Cells, body: usize, coords: &[[f64; D]]) -> Self {
        let (mut simplices, mut origins) = (Vec::new(), Vec::new());
        for cell in (0..cells.len()).filter(|&cell| cells.body[cell] as usize == body) {
            for_each_simplex(cells, cell, coords, |simplex| {
                simplices.push(simplex);
                origins.push(cell as u32);
            });
        }
        Self::new(simplices, origins)
    }

    /// A body bounded by facets only, as signed simplices from its middle to every facet; those that meet `region`.
    pub(crate) fn from_facets(side: &FacetSide<D>, region: &Aabb<D>) -> Self {
        let (mut simplices, mut origins) = (Vec::new(), Vec::new());
        let middle = side.aabb.center();
        let point = Aabb { min: middle, max: middle };
        for facet in side.facets_where(|aabb| aabb.union(&point).meets(region)) {
            let x = side.corners(facet as usize);
            let mut corners = [middle; 4];
            corners[..D].copy_from_slice(&x);
            // Seen from inside, the facet's corners run clockwise: in 3D they make a negative volume with the
            // middle.
            if D == 3 {
                corners.swap(0, 1);
            }
            if !Aabb::of(&corners[..=D]).meets(region) {
                continue;
            }
            // Opposite to the last corner, the middle, lies the facet.
            if let Some(simplex) = Simplex::new(&corners, 1 << D, false) {
                simplices.push(simplex);
                origins.push(facet);
            }
        }
        Self::new(simplices, origins)
    }

    fn new(simplices: Vec<Simplex<D>>, origins: Vec<u32>) -> Self {
        let boxes: Vec<Aabb<D>> = simplices.iter().map(Simplex::aabb).collect();
        let tree = Tree::new(&boxes);
        Solid::Simplices { simplices, boxes, origins, tree }
    }

    /// Calls `visit(simplex, origin)` for every simplex that may meet `slab`, in a fixed order.
    pub(crate) fn for_each_near(
        &self,
        slab: &Slab<D>,
        walk: &mut CellWalk,
        found: &mut Vec<u32>,
        mut visit: impl FnMut(&Simplex<D>, u32),
    ) {
        found.clear();
        let query = &slab.aabb;
        match self {
            Solid::Cells { cells, coords, facets, facet_cell } => {
                facets.tree.visit(
                    |aabb| aabb.meets(query),
                    |f| {
                        if slab.meets(facets.corners[f as usize].iter().copied()) {
                            found.push(facet_cell[facets.numbers[f as usize] as usize]);
                        }
                    },
                );
                for &cell in walk.around(cells, coords, found.iter().copied(), slab) {
                    for_each_simplex(cells, cell as usize, coords, |simplex| {
                        if simplex.aabb().meets(query) {
                            visit(&simplex, cell);
                        }
                    });
                }
            }
            Solid::Simplices { simplices, boxes, origins, tree } => {
                tree.visit(
                    |aabb| aabb.meets(query),
                    |s| {
                        if boxes[s as usize].meets(query) {
                            found.push(s);
                        }
                    },
                );
                found.sort_unstable();
                for &s in found.iter() {
                    visit(&simplices[s as usize], origins[s as usize]);
                }
            }
        }
    }
}
