//! All bodies of a mesh at given coordinates.

use super::body_tree::BodyTree;
use super::{CellCheck, FacetSide, FacetTree};
use crate::Error;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::{Surface, Vector};
use std::ops::Range;

/// The bodies at one set of coordinates. It may be brought to others, for which it keeps the topology of its trees.
pub(crate) struct Configuration<const D: usize> {
    /// The coordinates, of all nodes.
    coords: Vec<[f64; D]>,
    /// Positions of the surface's vertices.
    points: Vec<Vector<D>>,
    /// Facets of every body.
    trees: Vec<FacetTree<D>>,
    /// Boxes of the whole bodies.
    boxes: Vec<Aabb<D>>,
    /// A tree over them.
    bodies: BodyTree<D>,
    /// Which boxes of a larger mesh they are.
    epoch: u64,
    cell_check: Option<CellCheck<D>>,
    /// Whether no cell is known to be inverted here.
    is_checked: bool,
    /// Whether that was asked for: what was checked at an earlier call must not show in a later one's result.
    is_upright: bool,
}

impl<const D: usize> Configuration<D> {
    /// The bodies of `surface`, nowhere yet.
    pub(crate) fn new() -> Self {
        Self {
            coords: Vec::new(),
            points: Vec::new(),
            trees: Vec::new(),
            boxes: Vec::new(),
            bodies: BodyTree::default(),
            epoch: 0,
            cell_check: None,
            is_checked: false,
            is_upright: false,
        }
    }

    /// Brings the bodies of `surface` (always the same) to `coords`; with `check_cells`, checks that no cell is
    /// inverted there. Nothing is done where they are there already. Returns whether they have moved.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::NonFiniteCoordinate`], [`Error::InvertedCell`], [`Error::ZeroMeasure`].
    pub(crate) fn update(
        &mut self,
        surface: &Surface<D>,
        coords: &[[f64; D]],
        check_cells: bool,
        parallel: bool,
    ) -> Result<bool, Error> {
        let epoch = surface.submesh.as_ref().map_or(0, |submesh| submesh.epoch);
        let is_here = !self.trees.is_empty() && self.epoch == epoch && same_bits(&self.coords, coords);
        self.is_upright = check_cells && surface.cells.is_some();
        if is_here && (self.is_checked || !check_cells) {
            return Ok(false);
        }
        surface.check_coords(coords, check_cells)?;
        if let (Some(cells), true) = (&surface.cells, check_cells) {
            self.cell_check.get_or_insert_with(|| CellCheck::new(cells, surface.curved())).check(
                cells,
                surface.curved(),
                coords,
                parallel,
            )?;
        }
        self.is_checked = self.is_upright;
        if is_here {
            return Ok(false);
        }
        self.coords.clear();
        self.coords.extend_from_slice(coords);
        surface.place(coords, &mut self.points);
        let points = &self.points;
        if self.trees.is_empty() {
            let bodies = surface.ranges.iter().zip(&surface.vertices);
            let tree =
                |(r, of_body): (&Range<usize>, &Vec<u32>)| FacetTree::new(&surface.facets[r.clone()], of_body, points);
            self.trees = bodies.map(tree).collect();
        } else {
            for ((tree, range), of_body) in self.trees.iter_mut().zip(&surface.ranges).zip(&surface.vertices) {
                tree.update(&surface.facets[range.clone()], of_body, points, parallel);
            }
        }
        self.epoch = epoch;
        self.boxes.clear();
        match &surface.submesh {
            // As far as they were brought here; else they are no smaller than what is there of them.
            Some(submesh) => {
                let boxes = submesh.body_boxes.iter().zip(&self.trees);
                self.boxes.extend(boxes.map(|(whole, tree)| whole.union(&tree.aabb())));
            }
            None => self.boxes.extend(self.trees.iter().map(FacetTree::aabb)),
        }
        self.bodies.update(self.boxes.iter().copied());
        Ok(true)
    }

    /// Coordinates of all nodes.
    pub(crate) fn coords(&self) -> &[[f64; D]] {
        &self.coords
    }

    /// One body.
    pub(crate) fn body<'a>(&'a self, surface: &'a Surface<D>, body: usize) -> FacetSide<'a, D> {
        let tree = &self.trees[body];
        FacetSide {
            facets: &surface.facets[surface.ranges[body].clone()],
            points: &self.points,
            tree,
            aabb: self.boxes[body],
            is_upright: self.is_upright,
            rigid: None,
        }
    }

    /// Box of a body.
    pub(crate) fn body_box(&self, body: usize) -> Aabb<D> {
        self.boxes[body]
    }

    /// Pairs (i, j) with i < j of bodies whose boxes are no farther apart than `reach` along every axis, ascending.
    pub(crate) fn meeting_bodies(&self, reach: f64) -> Vec<(usize, usize)> {
        self.bodies.meeting(reach)
    }
}

/// Whether two sets of coordinates are the same number for number; what is no number equals nothing.
fn same_bits<const D: usize>(a: &[[f64; D]], b: &[[f64; D]]) -> bool {
    a.len() == b.len() && a.as_flattened().iter().zip(b.as_flattened()).all(|(x, y)| x.to_bits() == y.to_bits())
}
