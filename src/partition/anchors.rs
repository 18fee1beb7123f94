//! The cells from whose facets depths are measured.
//!
//! The depth of a point of a cell is its distance from the nearest facet without deformation. With b the distance of the cell's
//! middle from any facet of its body, and ρ that of its farthest node, that facet is within b + 2ρ of the middle.

use super::own_mesh::{OwnMesh, SentCell};
use crate::Error;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::tree::Tree;
use crate::geometry::{Surface, Vector};
use crate::ranks::Ranks;

/// Own surface facets without deformation, by body of the whole mesh.
pub(super) struct Anchors<const D: usize> {
    bodies: Vec<BodyFacets<D>>,
    /// Whether some facets of the surface are not measured from.
    are_some_left_out: bool,
}

#[derive(Default)]
struct BodyFacets<const D: usize> {
    /// Cell of each facet, as given.
    cells: Vec<u32>,
    boxes: Vec<Aabb<D>>,
    tree: Option<Tree<D>>,
}

/// Ball around a cell: that around its box, no smaller than the distance of its farthest node.
struct Ball<const D: usize> {
    body: usize,
    aabb: Aabb<D>,
    middle: Vector<D>,
    radius: f64,
}

/// Whether a body goes on behind a facet with these nodes.
pub(super) type GoesOn<'a> = &'a dyn Fn(&[u32]) -> bool;

impl<const D: usize> Anchors<D> {
    /// Of the own facets, but for those behind which the body goes on: they lie in planes of symmetry, or on an axis.
    pub(super) fn new(own: &OwnMesh<D>, goes_on: Option<GoesOn>) -> Self {
        let mut bodies: Vec<BodyFacets<D>> = own.body_ids.iter().map(|_| BodyFacets::default()).collect();
        for surface in own.surface.iter() {
            let points = surface.points(surface.reference());
            let facets = surface.boundary_facets();
            for (body, range) in surface.ranges.iter().enumerate() {
                let of_body = &mut bodies[own.body_of(surface, body)];
                let is_no_surface = |facet: usize| {
                    let nodes = facets[facet].nodes.iter().copied().filter(|&node| (node as usize) < own.node_count());
                    goes_on.is_some_and(|goes_on| goes_on(&nodes.collect::<Vec<_>>()))
                };
                for facet in range.clone().filter(|&facet| surface.is_surface_facet(facet) && !is_no_surface(facet)) {
                    of_body.cells.push(facets[facet].cell.unwrap_or(0) as u32);
                    of_body.boxes.push(box_of(surface, facet, &points));
                }
                of_body.tree = Some(Tree::new(&of_body.boxes));
            }
        }
        Self { bodies, are_some_left_out: goes_on.is_some() }
    }

    /// Own cells that have facets from which depths in some cells, of all ranks and without deformation, may be measured.
    pub(super) fn of_cells(
        &self,
        cells: &[SentCell],
        place: impl Fn(u64) -> Vector<D>,
        ranks: &Ranks,
    ) -> Result<Vec<u32>, Error> {
        let balls: Vec<Ball<D>> = cells
            .iter()
            .map(|cell| {
                let aabb = Aabb::of(&cell.nodes.iter().map(|&node| place(node)).collect::<Vec<_>>());
                let reach = |node: &u64| (place(*node) - aabb.center()).norm();
                // Points of cells of second order lie beyond their nodes, as far as half of the extent.
                let radius = cell.nodes.iter().map(reach).fold(0.5 * aabb.extent().max(), f64::max);
                Ball { body: cell.body as usize, aabb, middle: aabb.center(), radius }
            })
            .collect();
        // A node on the surface is one of a facet.
        let has_facet = |cell: &SentCell| cell.surface_faces != 0 && !self.are_some_left_out;
        let bounds =
            cells.iter().zip(&balls).map(|(cell, ball)| if has_facet(cell) { ball.radius } else { f64::INFINITY });
        let mut bounds: Vec<f64> = bounds.collect();
        let inner: Vec<usize> = (0..cells.len()).filter(|&cell| bounds[cell].is_infinite()).collect();
        // All ranks have these cells: what is told is only what is nearer than those of them that have facets.
        let mut gathered: Vec<BodyFacets<D>> = self.bodies.iter().map(|_| BodyFacets::default()).collect();
        for (_, ball) in cells.iter().zip(&balls).filter(|(cell, _)| has_facet(cell)) {
            gathered[ball.body].boxes.push(ball.aabb);
        }
        gathered.iter_mut().for_each(|of_body| of_body.tree = Some(Tree::new(&of_body.boxes)));
        let mut nearer: Vec<(u64, f64)> = Vec::new();
        for cell in inner {
            let Ball { body, middle, .. } = &balls[cell];
            bounds[cell] = gathered[*body].bound(middle);
            let own = self.bodies[*body].bound(middle);
            if own < bounds[cell] {
                nearer.push((cell as u64, own));
            }
        }
        for (cell, bound) in ranks.gather_lists(&nearer)?.into_iter().flatten() {
            bounds[cell as usize] = bounds[cell as usize].min(bound);
        }
        let mut found = Vec::new();
        for (ball, bound) in balls.iter().zip(bounds).filter(|(_, bound)| bound.is_finite()) {
            let reach = (bound + 2.0 * ball.radius) * (1.0 + 1e-9);
            self.bodies[ball.body].within(&ball.middle, reach * reach, &mut found);
        }
        found.sort_unstable();
        found.dedup();
        Ok(found)
    }
}

impl<const D: usize> BodyFacets<D> {
    /// No more than the distance of the farthest point of the facet whose box is nearest.
    fn bound(&self, x: &Vector<D>) -> f64 {
        let farthest = |aabb: &Aabb<D>| {
            (0..D).map(|i| (aabb.max[i] - x[i]).abs().max((x[i] - aabb.min[i]).abs()).powi(2)).sum::<f64>()
        };
        let nearer = |item: u32, least: f64| Some(farthest(&self.boxes[item as usize])).filter(|far| *far < least);
        self.tree.as_ref().map_or(f64::INFINITY, |tree| tree.least_squared_distance(x, f64::INFINITY, nearer).sqrt())
    }

    /// Adds the cells of facets whose boxes come so near.
    fn within(&self, x: &Vector<D>, squared: f64, found: &mut Vec<u32>) {
        let is_near = |aabb: &Aabb<D>| aabb.squared_distance(x) <= squared;
        if let Some(tree) = &self.tree {
            tree.visit(is_near, |item| {
                if is_near(&self.boxes[item as usize]) {
                    found.push(self.cells[item as usize]);
                }
            });
        }
    }
}

fn box_of<const D: usize>(surface: &Surface<D>, facet: usize, points: &[Vector<D>]) -> Aabb<D> {
    Aabb::of(surface.facets[facet].iter().map(|&vertex| &points[vertex as usize]))
}
