//! A tree of boxes.

use super::aabb::Aabb;
use crate::geometry::Vector;

/// Largest number of items in a leaf. Between 2 and 8 the queries take the same time; above, boxes become loose.
const LEAF: usize = 8;

/// Binary tree over boxes. Items are sorted along a curve that fills space (their centres' Morton codes), and every
/// node takes one half of its parent's.
///
/// Why not parry's `Bvh` (0.31, `enhanced-determinism`): on the 163 840 facets of two spheres, one run of
/// benches/trees.rs on a busy machine, it takes 6.0 (binned) or 7.8 (PLOC) times as long to build, 12 times to refit
/// with new leaves, 1.3 times for queries by a box, and 0.2 times for the pairs of two trees: 47, 1.4, 0.31 and 0.87 ms
/// here. A refit comes with every new coordinate, so that refit and pairs together take 2.2 ms against 16.2 ms.
pub(crate) struct Tree<const D: usize> {
    nodes: Vec<Node<D>>,
    items: Vec<u32>,
}

struct Node<const D: usize> {
    aabb: Aabb<D>,
    /// Items `start..end` of the order lie below it.
    start: u32,
    end: u32,
    /// Right child, the left one being the next node; 0 for a leaf.
    right: u32,
    /// Number of the first leaf below it.
    leaf: u32,
}

/// Centres nearer to one another than this are one place: a quotient by less may be no double.
const SMALLEST: f64 = 1e-290;

/// Items below a node from which on its two halves are refitted by different threads.
const SHARED: u32 = 1 << 13;

impl<const D: usize> Tree<D> {
    pub(crate) fn new(boxes: &[Aabb<D>]) -> Self {
        // Twice the centre serves as well.
        let center = |b: &Aabb<D>| b.min + b.max;
        let centers = boxes.iter().fold(Aabb::<D>::empty(), |a, b| {
            let c = center(b);
            Aabb { min: a.min.inf(&c), max: a.max.sup(&c) }
        });
        // One scale for all axes, so that a flat set is not split across its thickness.
        let extent = centers.extent().amax();
        let scale = if extent > SMALLEST { f64::from(1u32 << BITS) / extent } else { 0.0 };
        let code = |b: &Aabb<D>| morton(&((center(b) - centers.min) * scale));
        // The item's number breaks ties, so that the tree is a function of its input.
        let mut order: Vec<(u64, u32)> = boxes.iter().enumerate().map(|(i, b)| (code(b), i as u32)).collect();
        order.sort_unstable();
        let items: Vec<u32> = order.into_iter().map(|(_, item)| item).collect();
        let mut tree = Self { nodes: Vec::with_capacity(4 * items.len() / LEAF + 1), items };
        if !boxes.is_empty() {
            tree.build(boxes, 0, boxes.len(), &mut 0);
        }
        tree
    }

    /// Box around all items.
    pub(crate) fn aabb(&self) -> Aabb<D> {
        self.nodes.first().map_or(Aabb::empty(), |root| root.aabb)
    }

    /// The items of every leaf, in the order of the leaves' numbers.
    pub(crate) fn leaves(&self) -> impl Iterator<Item = &[u32]> {
        let leaves = self.nodes.iter().filter(|node| node.right == 0);
        leaves.map(|node| &self.items[node.start as usize..node.end as usize])
    }

    /// Makes the boxes anew after the items have moved, given those around the leaves by their numbers; which item
    /// stands where stays as it is. With `parallel`, on the threads of the pool that calls: the result is the same.
    ///
    /// Returns the sum of the extents of all leaves, which grows as the items leave the places at which the tree was
    /// built.
    pub(crate) fn refit(&mut self, leaf_box: &(impl Fn(usize) -> Aabb<D> + Sync), parallel: bool) -> f64 {
        refit(&mut self.nodes, 0, &|node: &Node<D>| leaf_box(node.leaf as usize), parallel).1
    }

    /// The same, given the boxes of all items.
    pub(crate) fn refit_to(&mut self, boxes: &[Aabb<D>]) -> f64 {
        let Self { nodes, items } = self;
        let of_leaf = |node: &Node<D>| {
            let items = &items[node.start as usize..node.end as usize];
            items.iter().fold(Aabb::empty(), |sum, &i| sum.union(&boxes[i as usize]))
        };
        refit(nodes, 0, &of_leaf, false).1
    }

    /// Adds the node over items `start..end` and those below it; returns its box.
    fn build(&mut self, boxes: &[Aabb<D>], start: usize, end: usize, leaf: &mut u32) -> Aabb<D> {
        let node = self.nodes.len();
        self.nodes.push(Node { aabb: Aabb::empty(), start: start as u32, end: end as u32, right: 0, leaf: *leaf });
        let aabb = if end - start <= LEAF {
            *leaf += 1;
            self.items[start..end].iter().fold(Aabb::empty(), |a, &i| a.union(&boxes[i as usize]))
        } else {
            let middle = start + (end - start) / 2;
            let left = self.build(boxes, start, middle, leaf);
            self.nodes[node].right = self.nodes.len() as u32;
            left.union(&self.build(boxes, middle, end, leaf))
        };
        self.nodes[node].aabb = aabb;
        aabb
    }

    /// Visits every item that lies in a leaf whose box, and those of all nodes above it, `accept`s.
    pub(crate) fn visit(&self, accept: impl Fn(&Aabb<D>) -> bool, mut item: impl FnMut(u32)) {
        let mut stack = Vec::with_capacity(64);
        if !self.nodes.is_empty() {
            stack.push(0u32);
        }
        while let Some(node) = stack.pop() {
            let Node { aabb, start, end, right, .. } = &self.nodes[node as usize];
            if !accept(aabb) {
                continue;
            }
            if *right == 0 {
                self.items[*start as usize..*end as usize].iter().for_each(|&i| item(i));
            } else {
                stack.push(*right);
                stack.push(node + 1);
            }
        }
    }

    /// The least squared distance of the items from `x`, if it is below `limit`, or `limit`. `nearer(item, least)` is the
    /// item's own if that is below `least`; no item is nearer than its box.
    pub(crate) fn least_squared_distance(
        &self,
        x: &Vector<D>,
        limit: f64,
        nearer: impl Fn(u32, f64) -> Option<f64>,
    ) -> f64 {
        let mut least = limit;
        let mut stack = Vec::with_capacity(64);
        if let Some(root) = self.nodes.first() {
            stack.push((root.aabb.squared_distance(x), 0u32));
        }
        while let Some((bound, node)) = stack.pop() {
            let Node { start, end, right, .. } = &self.nodes[node as usize];
            if bound >= least {
                continue;
            }
            if *right == 0 {
                for &item in &self.items[*start as usize..*end as usize] {
                    least = nearer(item, least).unwrap_or(least);
                }
                continue;
            }
            let bound_of = |child: u32| (self.nodes[child as usize].aabb.squared_distance(x), child);
            let (near, far) = (bound_of(node + 1), bound_of(*right));
            // The nearer one is looked at first.
            stack.extend(if near.0 <= far.0 { [far, near] } else { [near, far] });
        }
        least
    }

    /// Visits every pair of items, the first of `self`, whose boxes meet; `boxes` are those that the trees were made
    /// of.
    pub(crate) fn visit_pairs(&self, other: &Self, boxes: [&[Aabb<D>]; 2], mut pair: impl FnMut(u32, u32)) {
        let mut stack = Vec::with_capacity(64);
        if !self.nodes.is_empty() && !other.nodes.is_empty() {
            stack.push((0u32, 0u32));
        }
        while let Some((p, q)) = stack.pop() {
            let (here, there) = (&self.nodes[p as usize], &other.nodes[q as usize]);
            if !here.aabb.meets(&there.aabb) {
                continue;
            }
            match (here.right, there.right) {
                (0, 0) => {
                    for &i in &self.items[here.start as usize..here.end as usize] {
                        let aabb = &boxes[0][i as usize];
                        if aabb.meets(&there.aabb) {
                            let others = &other.items[there.start as usize..there.end as usize];
                            others.iter().filter(|&&j| boxes[1][j as usize].meets(aabb)).for_each(|&j| pair(i, j));
                        }
                    }
                }
                // The larger of the two is opened.
                (right, other_right)
                    if other_right == 0 || right != 0 && here.aabb.extent().amax() >= there.aabb.extent().amax() =>
                {
                    stack.extend([(right, q), (p + 1, q)]);
                }
                (_, right) => stack.extend([(p, right), (p, q + 1)]),
            }
        }
    }
}

impl<const D: usize> Tree<D> {
    /// Visits every two items whose leaves' boxes come nearer to each other than `reach`, by axis, once, until `go_on` is
    /// false. An item of which `may_meet` says that it meets nothing in the box of the other's leaf is passed over.
    pub(crate) fn visit_own_pairs(
        &self,
        reach: &Vector<D>,
        may_meet: impl Fn(u32, &Aabb<D>) -> bool,
        mut go_on: impl FnMut(u32, u32) -> bool,
    ) {
        let mut stack = Vec::with_capacity(64);
        if !self.nodes.is_empty() {
            stack.push((0u32, 0u32));
        }
        while let Some((p, q)) = stack.pop() {
            let (here, there) = (&self.nodes[p as usize], &self.nodes[q as usize]);
            let near = Aabb { min: here.aabb.min - reach, max: here.aabb.max + reach };
            if p != q && !near.meets(&there.aabb) {
                continue;
            }
            match (here.right, there.right) {
                (0, 0) => {
                    let items = &self.items[here.start as usize..here.end as usize];
                    for (n, &i) in items.iter().enumerate() {
                        if p != q && !may_meet(i, &there.aabb) {
                            continue;
                        }
                        let others = &self.items[there.start as usize..there.end as usize];
                        let others = if p == q { &others[n + 1..] } else { others };
                        if others.iter().any(|&j| !go_on(i, j)) {
                            return;
                        }
                    }
                }
                (right, _) if p == q => stack.extend([(p + 1, p + 1), (p + 1, right), (right, right)]),
                (right, other_right)
                    if other_right == 0 || right != 0 && here.aabb.extent().amax() >= there.aabb.extent().amax() =>
                {
                    stack.extend([(right, q), (p + 1, q)]);
                }
                (_, right) => stack.extend([(p, right), (p, q + 1)]),
            }
        }
    }
}

/// Refits the node that stands first in `nodes`, which has number `first` in its tree, and those below it; returns its
/// box and the sum of the extents of the leaves below.
fn refit<const D: usize>(
    nodes: &mut [Node<D>],
    first: u32,
    leaf_box: &(impl Fn(&Node<D>) -> Aabb<D> + Sync),
    parallel: bool,
) -> (Aabb<D>, f64) {
    let Some((node, below)) = nodes.split_first_mut() else { return (Aabb::empty(), 0.0) };
    if node.right == 0 {
        node.aabb = leaf_box(node);
        return (node.aabb, node.aabb.extent().sum());
    }
    let right = node.right;
    let (left_nodes, right_nodes) = below.split_at_mut((right - first - 1) as usize);
    let left = |nodes| refit(nodes, first + 1, leaf_box, parallel);
    let rest = |nodes| refit(nodes, right, leaf_box, parallel);
    let ((left, l), (rest, r)) = if parallel && node.end - node.start >= SHARED {
        rayon::join(|| left(left_nodes), || rest(right_nodes))
    } else {
        (left(left_nodes), rest(right_nodes))
    };
    node.aabb = left.union(&rest);
    (node.aabb, l + r)
}

/// Bits of a coordinate in a Morton code.
const BITS: u32 = 21;

/// The bits of coordinates below 2^[`BITS`] in turn, the highest first.
fn morton<const D: usize>(x: &Vector<D>) -> u64 {
    let mut code = 0;
    for axis in 0..D {
        // Centres on the upper bound go with those just below it.
        let mut spread = (x[axis] as u64).min((1 << BITS) - 1);
        // Every step halves the groups of bits and moves them apart, to twice (2D) or three times their places.
        let steps: [(u32, u64); 5] = if D == 2 {
            [
                (16, 0x0000_ffff_0000_ffff),
                (8, 0x00ff_00ff_00ff_00ff),
                (4, 0x0f0f_0f0f_0f0f_0f0f),
                (2, 0x3333_3333_3333_3333),
                (1, 0x5555_5555_5555_5555),
            ]
        } else {
            [
                (32, 0x001f_0000_0000_ffff),
                (16, 0x001f_0000_ff00_00ff),
                (8, 0x100f_00f0_0f00_f00f),
                (4, 0x10c3_0c30_c30c_30c3),
                (2, 0x1249_2492_4924_9249),
            ]
        };
        for (shift, mask) in steps {
            spread = (spread | spread << shift) & mask;
        }
        code |= spread << axis;
    }
    code
}

#[cfg(test)]
mod tests {
    use super::*;

    fn boxes(count: u32, size: f64) -> Vec<Aabb<3>> {
        let random = |i: u32, k: u32| (i.wrapping_mul(2654435761u32.wrapping_mul(k)) >> 8) as f64 / 16777216.0;
        (0..count)
            .map(|i| {
                let min = Vector::<3>::new(random(i, 1), random(i, 3), random(i, 7));
                Aabb { min, max: min.add_scalar(size) }
            })
            .collect()
    }

    #[test]
    fn pairs_against_brute_force() {
        let (here, there) = (boxes(300, 0.05), boxes(170, 0.2));
        let mut found = Vec::new();
        Tree::new(&here).visit_pairs(&Tree::new(&there), [&here, &there], |i, j| found.push((i, j)));
        found.sort_unstable();
        let all = (0..300).flat_map(|i| (0..170).map(move |j| (i, j)));
        let expected: Vec<(u32, u32)> = all.filter(|&(i, j)| here[i as usize].meets(&there[j as usize])).collect();
        assert!(expected.len() > 100);
        assert_eq!(found, expected);
        Tree::new(&here).visit_pairs(&Tree::new(&[]), [&here, &[]], |_, _| panic!("nothing meets an empty tree"));
    }

    /// A tree whose items have moved finds what a new one finds.
    #[test]
    fn refitted_tree_against_brute_force() {
        let mut tree = Tree::new(&boxes(20_000, 0.01));
        let moved: Vec<Aabb<3>> = boxes(20_000, 0.02).iter().map(|b| b.inflated(0.01)).rev().collect();
        let of_leaf: Vec<Aabb<3>> = tree
            .leaves()
            .map(|items| items.iter().fold(Aabb::empty(), |sum, &i| sum.union(&moved[i as usize])))
            .collect();
        let mut boxes_of_nodes = Vec::new();
        for parallel in [false, true] {
            tree.refit(&|leaf| of_leaf[leaf], parallel);
            boxes_of_nodes.push(tree.nodes.iter().map(|node| node.aabb).collect::<Vec<_>>());
        }
        assert!(boxes_of_nodes[0] == boxes_of_nodes[1]);
        assert_eq!(tree.aabb(), moved.iter().fold(Aabb::empty(), |sum, b| sum.union(b)));
        let query = moved[3].inflated(0.03);
        let mut found = Vec::new();
        let near = |i: &u32| moved[*i as usize].meets(&query);
        tree.visit(|b| b.meets(&query), |i| found.extend(Some(i).filter(near)));
        found.sort_unstable();
        let expected: Vec<u32> = (0..20_000).filter(near).collect();
        assert!(expected.len() > 10);
        assert_eq!(found, expected);
    }

    #[test]
    fn morton_codes_take_bits_in_turn() {
        let plane = |x: f64, y: f64| morton(&Vector::<2>::new(x, y));
        let solid = |x: f64, y: f64, z: f64| morton(&Vector::<3>::new(x, y, z));
        assert_eq!((plane(1.0, 0.0), plane(0.0, 1.0), plane(3.0, 1.0)), (1, 2, 7));
        assert_eq!((solid(1.0, 0.0, 0.0), solid(0.0, 2.0, 0.0), solid(0.0, 0.0, 5.0)), (1, 1 << 4, 4 | 1 << 8));
        let last = f64::from((1u32 << BITS) - 1);
        assert_eq!((plane(last, last), solid(last, last, last)), ((1 << 42) - 1, (1 << 63) - 1));
        assert_eq!(solid(f64::NAN, 3e6, -1.0), solid(0.0, last, 0.0));
    }

    #[test]
    fn tree_against_brute_force() {
        let boxes = boxes(500, 0.05);
        let tree = Tree::new(&boxes);
        let query = boxes[7].inflated(0.1);
        let mut found = Vec::new();
        tree.visit(
            |b| b.meets(&query),
            |i| {
                if boxes[i as usize].meets(&query) {
                    found.push(i)
                }
            },
        );
        found.sort_unstable();
        let expected: Vec<u32> = (0..500).filter(|&i| boxes[i as usize].meets(&query)).collect();
        assert!(expected.len() > 1);
        assert_eq!(found, expected);
    }
}
