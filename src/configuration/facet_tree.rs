//! A search tree over the facets of one body, kept from one evaluation to the next.

use crate::geometry::Vector;
use crate::geometry::aabb::Aabb;
use crate::geometry::tree::Tree;

/// A tree is built anew once its leaves are this much looser than when it was built: it costs as much as some ten
/// refits, and queries of a tree twice as loose take about twice the time.
const LOOSE: f64 = 1.5;

/// Tree of boxes over facets. A leaf has some eight facets, which share most of their vertices: its box is made from
/// these.
pub(crate) struct FacetTree<const D: usize> {
    tree: Tree<D>,
    /// Different vertices of the facets of leaf l: `offsets[l]..offsets[l + 1]`.
    vertices: Vec<u32>,
    offsets: Vec<u32>,
    /// Sum of the leaves' extents when the tree was built.
    looseness: f64,
}

impl<const D: usize> FacetTree<D> {
    /// Tree over `facets` with vertices at `points`.
    pub(crate) fn new(facets: &[[u32; D]], points: &[Vector<D>]) -> Self {
        let boxes: Vec<Aabb<D>> = facets.iter().map(|f| Aabb::of(f.iter().map(|&v| &points[v as usize]))).collect();
        let tree = Tree::new(&boxes);
        let (mut vertices, mut offsets, mut of_leaf) = (Vec::new(), vec![0], Vec::new());
        for items in tree.leaves() {
            of_leaf.clear();
            of_leaf.extend(items.iter().flat_map(|&facet| facets[facet as usize]));
            of_leaf.sort_unstable();
            of_leaf.dedup();
            vertices.extend_from_slice(&of_leaf);
            offsets.push(vertices.len() as u32);
        }
        vertices.shrink_to_fit();
        offsets.shrink_to_fit();
        let mut tree = Self { tree, vertices, offsets, looseness: 0.0 };
        tree.looseness = tree.refit(points, false);
        tree
    }

    /// Brings the tree to new positions of the vertices.
    pub(crate) fn update(&mut self, facets: &[[u32; D]], points: &[Vector<D>], parallel: bool) {
        if self.refit(points, parallel) > LOOSE * self.looseness {
            *self = Self::new(facets, points);
        }
    }

    fn refit(&mut self, points: &[Vector<D>], parallel: bool) -> f64 {
        let Self { tree, vertices, offsets, .. } = self;
        let leaf_box = |leaf: usize| {
            let of_leaf = &vertices[offsets[leaf] as usize..offsets[leaf + 1] as usize];
            Aabb::of(of_leaf.iter().map(|&v| &points[v as usize]))
        };
        tree.refit(&leaf_box, parallel)
    }

    /// Box around all facets.
    pub(crate) fn aabb(&self) -> Aabb<D> {
        self.tree.aabb()
    }

    /// The tree itself.
    pub(crate) fn boxes(&self) -> &Tree<D> {
        &self.tree
    }
}
