//! The facets of two sides, found by place.

use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::tree::Tree;
use std::collections::BTreeMap;

/// The facets of two bodies, to be found by place.
pub(super) struct NearFacets<const D: usize> {
    /// Numbers in the surface, ascending, and to which sides they belong: a bit each, both where a body faces itself.
    facets: Vec<(usize, u8)>,
    boxes: Vec<Aabb<D>>,
    tree: Tree<D>,
}

impl<const D: usize> NearFacets<D> {
    pub(super) fn new(sides: &[Vec<usize>; 2], corners: impl Fn(usize) -> [Vector<D>; D]) -> Self {
        let mut facets = BTreeMap::<usize, u8>::new();
        for (list, side) in sides.iter().zip([1, 2]) {
            list.iter().for_each(|facet| *facets.entry(*facet).or_default() |= side);
        }
        let boxes: Vec<_> = facets.keys().map(|facet| Aabb::of(&corners(*facet))).collect();
        let tree = Tree::new(&boxes);
        Self { facets: facets.into_iter().collect(), boxes, tree }
    }

    /// The sides of a facet.
    pub(super) fn sides(&self, facet: usize) -> u8 {
        self.facets.binary_search_by_key(&facet, |(facet, _)| *facet).map_or(0, |found| self.facets[found].1)
    }

    /// Those whose boxes meet a region, ascending.
    pub(super) fn near(&self, region: &Aabb<D>) -> Vec<(usize, u8)> {
        let mut found = Vec::new();
        self.tree.visit(|aabb| aabb.meets(region), |item| found.push(item as usize));
        found.retain(|item| self.boxes[*item].meets(region));
        found.sort_unstable();
        found.into_iter().map(|item| self.facets[item]).collect()
    }
}
