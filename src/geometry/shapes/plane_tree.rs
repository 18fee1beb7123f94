//! A tree over planes: of many, those below which a place is the least deep are found without looking at all.

use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;

/// Largest number of planes in a leaf.
const LEAF: usize = 4;

/// Binary tree over planes that are given by unit normal n and level n·x. Every node takes one half of its parent's planes,
/// divided where their normals differ most; planes keep their places in it as they move with a rigid body.
#[derive(Clone)]
pub(crate) struct PlaneTree {
    nodes: Vec<Node>,
    order: Vec<u32>,
}

#[derive(Clone)]
struct Node {
    /// Planes `start..end` of the order lie below it.
    start: u32,
    end: u32,
    /// Right child, the left one being the next node; 0 for a leaf.
    right: u32,
}

/// What is known of all planes below a node.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PlaneBounds<const D: usize> {
    normals: Aabb<D>,
    least_level: f64,
}

impl<const D: usize> PlaneBounds<D> {
    /// A point is no less deep below any of the planes.
    pub(crate) fn least_depth(&self, x: &Vector<D>) -> f64 {
        let Aabb { min, max } = &self.normals;
        (0..D).fold(self.least_level, |depth, i| depth - (min[i] * x[i]).max(max[i] * x[i]))
    }

    /// No normal makes a smaller scalar product with this vector.
    pub(crate) fn least_product(&self, v: &Vector<D>) -> f64 {
        let Aabb { min, max } = &self.normals;
        (0..D).map(|i| (min[i] * v[i]).min(max[i] * v[i])).sum()
    }
}

impl PlaneTree {
    /// A tree over planes with these unit normals.
    pub(crate) fn new<const D: usize>(normals: &[Vector<D>]) -> Self {
        let mut tree = Self { nodes: Vec::new(), order: (0..normals.len() as u32).collect() };
        if !normals.is_empty() {
            tree.build(normals, 0, normals.len());
        }
        tree
    }

    fn build<const D: usize>(&mut self, normals: &[Vector<D>], start: usize, end: usize) {
        let node = self.nodes.len();
        self.nodes.push(Node { start: start as u32, end: end as u32, right: 0 });
        if end - start <= LEAF {
            return;
        }
        let extent = Aabb::of(self.order[start..end].iter().map(|&k| &normals[k as usize])).extent();
        let axis = extent.imax();
        let component = |k: &u32| normals[*k as usize][axis];
        // The number breaks ties, so that the tree is a function of its input.
        self.order[start..end].sort_unstable_by(|p, q| component(p).total_cmp(&component(q)).then(p.cmp(q)));
        let middle = start + (end - start) / 2;
        self.build(normals, start, middle);
        self.nodes[node].right = self.nodes.len() as u32;
        self.build(normals, middle, end);
    }

    /// Bounds for every node, the planes being where they are now: `plane` has unit normal and level of one.
    pub(crate) fn bounds<const D: usize>(&self, plane: impl Fn(u32) -> (Vector<D>, f64)) -> Vec<PlaneBounds<D>> {
        let empty = PlaneBounds { normals: Aabb::empty(), least_level: f64::INFINITY };
        let mut bounds = vec![empty; self.nodes.len()];
        // Children come after their parents.
        for (n, node) in self.nodes.iter().enumerate().rev() {
            bounds[n] = if node.right == 0 {
                self.planes(node).iter().fold(empty, |mut all, &k| {
                    let (normal, level) = plane(k);
                    all.normals.include(&normal);
                    all.least_level = all.least_level.min(level);
                    all
                })
            } else {
                let (p, q) = (&bounds[n + 1], &bounds[node.right as usize]);
                PlaneBounds { normals: p.normals.union(&q.normals), least_level: p.least_level.min(q.least_level) }
            };
        }
        bounds
    }

    /// The least of a value of the planes that is below `limit`, or `limit`; `of_node` is no larger than that of any plane
    /// below the node.
    pub(crate) fn least<const D: usize>(
        &self,
        bounds: &[PlaneBounds<D>],
        limit: f64,
        of_node: impl Fn(&PlaneBounds<D>) -> f64,
        of_plane: impl Fn(u32) -> f64,
    ) -> f64 {
        let mut least = limit;
        let mut stack = Vec::with_capacity(32);
        if let Some(root) = bounds.first() {
            stack.push((of_node(root), 0u32));
        }
        while let Some((bound, n)) = stack.pop() {
            let node = &self.nodes[n as usize];
            if bound >= least {
                continue;
            }
            if node.right == 0 {
                least = self.planes(node).iter().fold(least, |least, &k| least.min(of_plane(k)));
                continue;
            }
            let bound_of = |child: u32| (of_node(&bounds[child as usize]), child);
            let (left, right) = (bound_of(n + 1), bound_of(node.right));
            // The lower one is looked at first.
            stack.extend(if left.0 <= right.0 { [right, left] } else { [left, right] });
        }
        least
    }

    /// Visits every plane in a leaf for which, and for all nodes above which, `accept` holds.
    pub(crate) fn visit<const D: usize>(
        &self,
        bounds: &[PlaneBounds<D>],
        accept: impl Fn(&PlaneBounds<D>) -> bool,
        mut plane: impl FnMut(u32),
    ) {
        let mut stack = Vec::with_capacity(32);
        if !self.nodes.is_empty() {
            stack.push(0u32);
        }
        while let Some(n) = stack.pop() {
            if !accept(&bounds[n as usize]) {
                continue;
            }
            let node = &self.nodes[n as usize];
            if node.right == 0 {
                self.planes(node).iter().for_each(|&k| plane(k));
            } else {
                stack.extend([node.right, n + 1]);
            }
        }
    }

    fn planes(&self, node: &Node) -> &[u32] {
        &self.order[node.start as usize..node.end as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn least_depths_against_brute_force() {
        let random =
            |i: u32, k: u32| f64::from(i.wrapping_mul(2_654_435_761u32.wrapping_mul(k)) >> 8) / 8_388_608.0 - 1.0;
        let planes: Vec<(Vector<3>, f64)> = (1..200)
            .map(|i| {
                (Vector::<3>::new(random(i, 1), random(i, 3), random(i, 7)).normalize(), 1.0 + 0.3 * random(i, 11))
            })
            .collect();
        let normals: Vec<Vector<3>> = planes.iter().map(|plane| plane.0).collect();
        let tree = PlaneTree::new(&normals);
        let bounds = tree.bounds(|k| planes[k as usize]);
        for i in 1..50 {
            let x = Vector::<3>::new(random(i, 13), random(i, 17), random(i, 19));
            let depth = |k: u32| planes[k as usize].1 - planes[k as usize].0.dot(&x);
            let expected = (0..199).map(depth).fold(f64::INFINITY, f64::min);
            assert_eq!(tree.least(&bounds, f64::INFINITY, |b| b.least_depth(&x), depth), expected);
            let mut found = Vec::new();
            tree.visit(
                &bounds,
                |b| b.least_depth(&x) <= expected + 0.2,
                |k| found.extend((depth(k) <= expected + 0.2).then_some(k)),
            );
            found.sort_unstable();
            assert_eq!(found, (0..199).filter(|&k| depth(k) <= expected + 0.2).collect::<Vec<u32>>());
            assert!(planes.iter().all(|plane| plane.0.dot(&x) >= bounds[0].least_product(&x)));
        }
    }
}
