//! Bodies of cells, each with a depth: how what their facets and pieces have inside the other adds up.

use super::cell_integrals::{CellMoments, cell_integrals};
use super::cell_pieces::CellPieces;
use crate::Error;
use crate::depth_field::DepthField;
use crate::geometry::Vector;
use crate::geometry::mesh::cells::Cells;
use crate::overlap::depth::curved_faces::curved_faces;
use crate::overlap::depth::facet_sums::FacetSums;
use crate::overlap::depth::integral::{DepthIntegral, DepthRequest};
use crate::overlap::pair::bounds::Bounds;
use crate::overlap::pair::partner::Partner;
use crate::overlap::pair::region::Region;
use crate::overlap::pair::sides::Pair;
use crate::overlap::pair::warning::Warning;

/// Bodies of cells.
#[derive(Clone, Copy)]
pub(crate) struct DeepBodies<'a, const D: usize> {
    pub(crate) pair: &'a Pair<'a, D>,
    pub(crate) cells: &'a Cells,
    pub(crate) field: &'a DepthField<D>,
    pub(crate) request: &'a DepthRequest,
    /// How deep below the surfaces the contact begins.
    pub(crate) clearance: f64,
}

/// Part of the forces that may be missing where bodies go on behind planes of symmetry.
const MISTAKEN: f64 = 0.1;

/// Part of the faces within the other body below which faces in one plane matter to no force.
const FLUSH: f64 = 1e-6;

/// Facets, or pieces, that a thread takes at once.
pub(crate) const CHUNK: usize = 64;

/// Part with which the depth of either body counts.
pub(crate) const WEIGHT: f64 = 0.5;

impl<'a, const D: usize> DeepBodies<'a, D> {
    /// The bodies of a pair.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for bodies that are given by facets only.
    pub(crate) fn new(pair: &'a Pair<'a, D>, request: &'a DepthRequest) -> Result<Self, Error> {
        let what = "the law depth, or friction with the law volume, between bodies given by facets: give cells";
        let (Some(field), Some(cells)) = (pair.depth, &pair.surface.cells) else {
            return Err(Error::Unsupported { what });
        };
        Ok(Self { pair, cells, field, request, clearance: pair.clearance })
    }

    /// From what the facets of either side have inside the other, and the moments of its pieces.
    pub(crate) fn assemble(
        &self,
        facets: Vec<FacetSums<D>>,
        cells: &[(&CellPieces<D>, &CellMoments)],
    ) -> Option<DepthIntegral<D>> {
        let inside = || facets.iter().filter(|part| part.area > 0.0);
        let area: f64 = inside().map(|part| part.area).sum();
        let depth: f64 = inside().map(|part| part.depth / part.area).sum();
        let sides = inside().count() as f64;
        let mut sums = FacetSums::of_parts(facets);
        let (mut volume, mut value) = (0.0, 0.0);
        for (which, (pieces, moments)) in cells.iter().enumerate() {
            let FacetSums { gradient, hessian, .. } = &mut sums;
            let side = (which == 1, WEIGHT);
            let how = (self.request.second, self.pair.weighting);
            let found = cell_integrals(self.cells, pieces, moments, side, how, gradient, hessian);
            value += WEIGHT * found.depth;
            volume += 0.5 * found.volume;
        }
        let mut overlap = sums.overlap(self.pair, volume, 0.5 * area)?;
        overlap.warnings.extend(self.flush_faces(sums.flush, area));
        overlap.warnings.extend(curved_faces(self.pair, &sums.facets, None));
        let (nodes, of_b, gradient) = sums.gradient.into_nodes();
        let imbalance = self.imbalance(&of_b, &gradient);
        if self.field.is_surface_told() && imbalance > MISTAKEN {
            let (a, b) = (overlap.a, overlap.b);
            overlap.warnings.push(Warning::Unbalanced { a, b, imbalance });
        }
        Some(DepthIntegral {
            value: value.max(0.0),
            nodes,
            of_b,
            gradient,
            pose_gradient: None,
            hessian: sums.hessian.into_blocks(),
            facets: sums.facets,
            points: sums.points,
            mean_depth: if sides > 0.0 { depth / sides } else { 0.0 },
            overlap,
        })
    }

    /// The warning of faces of so large an area that lie in one plane and look the same way, where it was not said which are surface.
    /// `inside`: of all faces within the other body, of which it must be more than next to nothing.
    pub(crate) fn flush_faces(&self, area: f64, inside: f64) -> Option<Warning> {
        let [a, b] = self.pair.partners;
        (area > FLUSH * inside && !self.field.is_surface_told()).then_some(Warning::FlushFaces { a, b, area })
    }

    /// The sum of all forces by the larger resultant of a side. Behind a plane of symmetry the overlap goes on, and presses on the plane by
    /// the part of its depth in its length; faces that are pressed are none of a plane of symmetry, and leave all of their force.
    fn imbalance(&self, of_b: &[bool], gradient: &[Vector<D>]) -> f64 {
        let mut sides = [Vector::<D>::zeros(); 2];
        of_b.iter().zip(gradient).for_each(|(&of_b, g)| sides[usize::from(of_b)] += g);
        // What a body presses on itself is one side, whose sum is none.
        let largest = match self.pair.is_own() {
            true => gradient.iter().map(Vector::norm).sum(),
            false => sides[0].norm().max(sides[1].norm()),
        };
        if !self.pair.weighting.is_plain() {
            // Radial forces are not in balance.
            sides.iter_mut().for_each(|side| side[0] = 0.0);
        }
        if largest > 0.0 { (sides[0] + sides[1]).norm() / largest } else { 0.0 }
    }

    /// The pieces of one side in the region, with their boxes as far as they lie within the bounds.
    pub(crate) fn pieces(&self, which: usize, region: &Region<D>, bounds: Option<&Bounds<D>>) -> CellPieces<D> {
        let body = if let Partner::Body(body) = self.pair.partners[which] { body } else { 0 };
        let region = (&region.facets[which][..], &region.aabb);
        CellPieces::new(self.pair, self.cells, self.field, body, region, bounds, self.clearance)
    }
}
