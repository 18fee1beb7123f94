//! The boxes of all bodies, to find those that meet.

use super::facet_tree::LOOSE;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::tree::Tree;

/// A tree over the bodies' boxes, kept from one evaluation to the next.
#[derive(Default)]
pub(crate) struct BodyTree<const D: usize> {
    boxes: Vec<Aabb<D>>,
    tree: Option<Tree<D>>,
    /// Sum of the leaves' extents when the tree was built.
    looseness: f64,
}

impl<const D: usize> BodyTree<D> {
    /// Brings it to new boxes of the same bodies.
    pub(crate) fn update(&mut self, boxes: impl Iterator<Item = Aabb<D>>) {
        self.boxes.clear();
        self.boxes.extend(boxes);
        if let Some(tree) = &mut self.tree
            && tree.refit_to(&self.boxes) <= LOOSE * self.looseness
        {
            return;
        }
        let tree = self.tree.insert(Tree::new(&self.boxes));
        self.looseness = tree.refit_to(&self.boxes);
    }

    /// Pairs (i, j) with i < j of bodies whose boxes are no farther apart than `reach` along every axis, ascending.
    pub(crate) fn meeting(&self, reach: f64) -> Vec<(usize, usize)> {
        let mut pairs = Vec::new();
        let Some(tree) = &self.tree else { return pairs };
        let may_meet = |i: u32, aabb: &Aabb<D>| self.boxes[i as usize].inflated(reach).meets(aabb);
        tree.visit_own_pairs(&Vector::repeat(reach), may_meet, |i, j| {
            let [i, j] = [i.min(j) as usize, i.max(j) as usize];
            if self.boxes[i].inflated(reach).meets(&self.boxes[j]) {
                pairs.push((i, j));
            }
            true
        });
        pairs.sort_unstable();
        pairs
    }
}
