//! A search tree over the facets of one body, kept from one evaluation to the next.

use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::tree::Tree;
use rayon::prelude::*;

/// A tree is built anew once its leaves are this much looser than when it was built: it costs as much as some ten
/// refits, and queries of a tree twice as loose take about twice the time.
pub(super) const LOOSE: f64 = 1.5;

/// Boxes are made anew once displacements differ by more than this part of a leaf's mean extent: so much wider queries
/// take them.
const SPREAD: f64 = 0.25;

/// Vertices that a thread takes at once.
const CHUNK: usize = 1 << 13;

/// Tree of boxes over facets. A leaf has some eight facets, which share most of their vertices: its box is made from
/// these.
///
/// Boxes stay where the body was, as long as all its vertices have moved by nearly the same: queries add the bounds of
/// the displacement. That costs one pass over the vertices in the order of memory.
pub(crate) struct FacetTree<const D: usize> {
    tree: Tree<D>,
    /// Different vertices of the facets of leaf l: `offsets[l]..offsets[l + 1]`.
    of_leaves: Vec<u32>,
    offsets: Vec<u32>,
    /// Sum of the leaves' extents when the tree was built.
    looseness: f64,
    /// Positions of the body's vertices for which the boxes were made.
    fitted: Vec<Vector<D>>,
    /// Bounds of the displacement since.
    moved: Aabb<D>,
    aabb: Aabb<D>,
}

impl<const D: usize> FacetTree<D> {
    /// Tree over `facets`, whose vertices (ascending) lie at `points`.
    pub(crate) fn new(facets: &[[u32; D]], vertices: &[u32], points: &[Vector<D>]) -> Self {
        let boxes: Vec<Aabb<D>> = facets.iter().map(|f| Aabb::of(f.iter().map(|&v| &points[v as usize]))).collect();
        let tree = Tree::new(&boxes);
        let (mut of_leaves, mut offsets, mut of_leaf) = (Vec::new(), vec![0], Vec::new());
        for items in tree.leaves() {
            of_leaf.clear();
            of_leaf.extend(items.iter().flat_map(|&facet| facets[facet as usize]));
            of_leaf.sort_unstable();
            of_leaf.dedup();
            of_leaves.extend_from_slice(&of_leaf);
            offsets.push(of_leaves.len() as u32);
        }
        of_leaves.shrink_to_fit();
        offsets.shrink_to_fit();
        let fitted = Vec::with_capacity(vertices.len());
        let (moved, aabb) = (Aabb::empty(), Aabb::empty());
        let mut tree = Self { tree, of_leaves, offsets, looseness: 0.0, fitted, moved, aabb };
        tree.looseness = tree.refit(vertices, points, false);
        tree.aabb = tree.tree.aabb();
        tree
    }

    /// Brings the tree to new positions of the vertices.
    pub(crate) fn update(&mut self, facets: &[[u32; D]], vertices: &[u32], points: &[Vector<D>], parallel: bool) {
        self.measure(vertices, points, parallel);
        let leaves = (self.offsets.len() - 1) as f64;
        if self.moved.extent().sum() <= SPREAD * self.looseness / leaves {
            return;
        }
        if self.refit(vertices, points, parallel) > LOOSE * self.looseness {
            *self = Self::new(facets, vertices, points);
        }
    }

    /// Finds the body's box and the bounds of its displacement.
    fn measure(&mut self, vertices: &[u32], points: &[Vector<D>], parallel: bool) {
        let of_part = |(vertices, fitted): (&[u32], &[Vector<D>])| {
            let mut bounds = [Aabb::empty(); 2];
            let mut include = |x: &Vector<D>, from: &Vector<D>| {
                bounds[0].include(x);
                bounds[1].include(&(x - from));
            };
            match vertices {
                // Numbers without a gap, as most meshes have them.
                [first, .., last] if (last - first) as usize + 1 == vertices.len() => {
                    let points = &points[*first as usize..=*last as usize];
                    points.iter().zip(fitted).for_each(|(x, from)| include(x, from));
                }
                _ => vertices.iter().zip(fitted).for_each(|(&v, from)| include(&points[v as usize], from)),
            }
            bounds
        };
        let both = |[a, b]: [Aabb<D>; 2], [c, d]: [Aabb<D>; 2]| [a.union(&c), b.union(&d)];
        [self.aabb, self.moved] = if parallel && vertices.len() > CHUNK {
            let parts = vertices.par_chunks(CHUNK).zip(self.fitted.par_chunks(CHUNK));
            parts.map(of_part).reduce(|| [Aabb::empty(); 2], both)
        } else {
            of_part((vertices, &self.fitted))
        };
        // A displacement is rounded, and so is its sum with a box.
        self.moved = self.moved.inflated(self.aabb.union(&self.tree.aabb()).rounding());
    }

    fn refit(&mut self, vertices: &[u32], points: &[Vector<D>], parallel: bool) -> f64 {
        let Self { tree, of_leaves, offsets, .. } = self;
        let leaf_box = |leaf: usize| {
            let of_leaf = &of_leaves[offsets[leaf] as usize..offsets[leaf + 1] as usize];
            Aabb::of(of_leaf.iter().map(|&v| &points[v as usize]))
        };
        let looseness = tree.refit(&leaf_box, parallel);
        self.fitted.clear();
        self.fitted.extend(vertices.iter().map(|&v| points[v as usize]));
        self.moved = Aabb { min: Vector::zeros(), max: Vector::zeros() };
        looseness
    }

    /// Box around all facets.
    pub(crate) fn aabb(&self) -> Aabb<D> {
        self.aabb
    }

    /// Visits every facet in a leaf whose box, and those of all nodes above it, `accept`s. A box may be wider than what
    /// lies in it.
    pub(crate) fn visit(&self, accept: impl Fn(&Aabb<D>) -> bool, facet: impl FnMut(u32)) {
        self.tree.visit(|aabb| accept(&aabb.sum(&self.moved)), facet);
    }

    /// Visits every two facets whose leaves' boxes meet, once, until `go_on` is false. A facet of which `may_meet` says that it
    /// meets nothing in the box of the other's leaf is passed over.
    pub(crate) fn visit_own_pairs(
        &self,
        may_meet: impl Fn(u32, &Aabb<D>) -> bool,
        go_on: impl FnMut(u32, u32) -> bool,
    ) {
        // Two boxes that are moved by the same bounds come nearer by their extent.
        let may_meet = |facet: u32, aabb: &Aabb<D>| may_meet(facet, &aabb.sum(&self.moved));
        self.tree.visit_own_pairs(&self.moved.extent(), may_meet, go_on);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::configuration::FacetSide;
    use crate::geometry::{Bodies, Surface};
    use fmc_shapes::icosphere;

    /// A tree that has followed a body for a while finds what a look at every facet finds, be it shifted, turned, or
    /// deformed a little or much.
    #[test]
    fn followed_bodies_are_found() {
        let ball = icosphere(1.0, 4);
        let facets = ball.facets();
        let surface = Surface::from_facets(&ball.coords, &facets, Bodies::Ids(&vec![0; facets.len()])).expect("a ball");
        let vertices = &surface.vertices[0];
        let mut tree = FacetTree::new(&surface.facets, vertices, &surface.points(&ball.coords));
        let (mut kept, mut found_in_all) = (0, 0);
        for step in 0..60 {
            let s = f64::from(step);
            let size = [1e-9, 1e-4, 0.02][step as usize / 20] * s;
            let turned = ball.clone().rotated([1.0, 2.0, 3.0], size).translated([3.0 * s, 0.1 * s, -s]);
            let bent: Vec<[f64; 3]> = turned.coords.iter().map(|x| [x[0] + size * x[1].sin(), x[1], x[2]]).collect();
            let points = surface.points(&bent);
            let before = tree.fitted.clone();
            tree.update(&surface.facets, vertices, &points, step % 2 == 0);
            kept += usize::from(tree.fitted == before);
            assert_eq!(tree.aabb(), Aabb::of(&points));
            let side = FacetSide {
                facets: &surface.facets,
                points: &points,
                tree: &tree,
                aabb: tree.aabb(),
                is_upright: false,
                rigid: None,
            };
            let middle = points[step as usize * 7 % points.len()];
            let query = Aabb { min: middle, max: middle }.inflated(0.05);
            let all = 0..surface.facets.len() as u32;
            let expected: Vec<u32> = all.filter(|&f| side.facet_box(f as usize).meets(&query)).collect();
            found_in_all += expected.len();
            assert_eq!(side.facets_in(&query), expected, "step {step}");
        }
        assert!(kept > 10 && kept < 50 && found_in_all > 300, "{kept} kept, {found_in_all} found");
    }
}
