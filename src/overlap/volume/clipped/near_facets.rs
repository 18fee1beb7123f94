//! Which facets of two sides keep clear of the boundary of the other side.

use crate::configuration::FacetSide;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::tree::Tree;
use crate::overlap::pair::region::Region;
use crate::overlap::pair::sides::Pair;

/// The facets of two sides in their common region, and how they stand to the other side.
pub(crate) struct NearFacets<const D: usize> {
    pub(crate) sides: [Facets<D>; 2],
    /// Distances up to this are rounding.
    pub(crate) tolerance: f64,
}

/// The facets of one side in the region, ascending.
pub(crate) struct Facets<const D: usize> {
    /// Number of each facet in its side.
    pub(crate) numbers: Vec<u32>,
    pub(crate) corners: Vec<[Vector<D>; D]>,
    /// Unit outward normals; zero where a facet has no measure.
    pub(crate) normals: Vec<Vector<D>>,
    /// Boxes, wider by the tolerance.
    pub(crate) boxes: Vec<Aabb<D>>,
    pub(crate) tree: Tree<D>,
    /// Whether a facet may touch or cross the boundary of the other side.
    pub(crate) is_near: Vec<bool>,
}

impl<const D: usize> NearFacets<D> {
    /// Facets keep clear of each other if their boxes do or if one lies on one side of the plane of the other, by more
    /// than rounding. Other facets may keep clear too: that costs time, and nothing else.
    pub(crate) fn new(pair: &Pair<D>, b: &FacetSide<D>, region: &Region<D>) -> Self {
        let tolerance = region.aabb.rounding();
        let [of_a, of_b] = region.facets.clone();
        let (of_a, of_b) = pair.both(|| Facets::new(&pair.a, of_a, tolerance), || Facets::new(b, of_b, tolerance));
        let mut sides = [of_a, of_b];
        let [a, b] = &mut sides;
        a.tree.visit_pairs(&b.tree, [&a.boxes, &b.boxes], |f, g| {
            let (f, g) = (f as usize, g as usize);
            if a.is_near[f] && b.is_near[g] {
                return;
            }
            let apart = is_beside(&a.corners[f], &b.corners[g], &b.normals[g], tolerance)
                || is_beside(&b.corners[g], &a.corners[f], &a.normals[f], tolerance);
            if !apart {
                (a.is_near[f], b.is_near[g]) = (true, true);
            }
        });
        Self { sides, tolerance }
    }
}

impl<const D: usize> Facets<D> {
    fn new(side: &FacetSide<D>, numbers: Vec<u32>, tolerance: f64) -> Self {
        let corners: Vec<[Vector<D>; D]> = numbers.iter().map(|&f| side.corners(f as usize)).collect();
        let unit = |x: &[Vector<D>; D]| area_vector(x).try_normalize(0.0).unwrap_or_else(Vector::zeros);
        let boxes: Vec<Aabb<D>> = corners.iter().map(|x| Aabb::of(x).inflated(tolerance)).collect();
        Self {
            normals: corners.iter().map(unit).collect(),
            tree: Tree::new(&boxes),
            is_near: vec![false; numbers.len()],
            numbers,
            corners,
            boxes,
        }
    }
}

/// Whether `x` lies on one side of the plane through `corners`, and farther from it than the tolerance.
fn is_beside<const D: usize>(x: &[Vector<D>; D], corners: &[Vector<D>; D], normal: &Vector<D>, tolerance: f64) -> bool {
    let (mut low, mut high) = (f64::INFINITY, f64::NEG_INFINITY);
    for x in x {
        let height = normal.dot(&(x - corners[0]));
        (low, high) = (low.min(height), high.max(height));
    }
    low > tolerance || high < -tolerance
}
