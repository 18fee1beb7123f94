//! A tree of boxes.

use super::aabb::Aabb;

/// Largest number of items in a leaf. Between 2 and 8 the queries take the same time; above, boxes become loose.
const LEAF: usize = 4;

/// Binary tree over boxes, split at the median of the longest axis.
pub(crate) struct Tree<const D: usize> {
    nodes: Vec<Node<D>>,
    items: Vec<u32>,
}

struct Node<const D: usize> {
    aabb: Aabb<D>,
    /// Leaf: items `start..end`. Otherwise: left child is the next node, right child is `right`.
    start: u32,
    end: u32,
    right: u32,
}

impl<const D: usize> Tree<D> {
    pub(crate) fn new(boxes: &[Aabb<D>]) -> Self {
        let mut tree = Self { nodes: Vec::new(), items: (0..boxes.len() as u32).collect() };
        if !boxes.is_empty() {
            tree.build(boxes, 0, boxes.len());
        }
        tree
    }

    fn build(&mut self, boxes: &[Aabb<D>], start: usize, end: usize) {
        let items = &mut self.items[start..end];
        let aabb = items.iter().fold(Aabb::empty(), |a, &i| a.union(&boxes[i as usize]));
        let centers = items.iter().fold(Aabb::<D>::empty(), |a, &i| {
            let c = boxes[i as usize].center();
            Aabb { min: a.min.inf(&c), max: a.max.sup(&c) }
        });
        let node = self.nodes.len();
        self.nodes.push(Node { aabb, start: start as u32, end: end as u32, right: 0 });
        if items.len() <= LEAF {
            return;
        }
        let axis = centers.extent().imax();
        let middle = items.len() / 2;
        // The item's number breaks ties, so that the tree is a function of its input.
        items.select_nth_unstable_by(middle, |&i, &j| {
            let (ci, cj) = (boxes[i as usize].center()[axis], boxes[j as usize].center()[axis]);
            ci.total_cmp(&cj).then(i.cmp(&j))
        });
        self.build(boxes, start, start + middle);
        self.nodes[node].right = self.nodes.len() as u32;
        self.build(boxes, start + middle, end);
    }

    /// Visits every item that lies in a leaf whose box, and those of all nodes above it, `accept`s.
    pub(crate) fn visit(&self, accept: impl Fn(&Aabb<D>) -> bool, mut item: impl FnMut(u32)) {
        let mut stack = Vec::with_capacity(64);
        if !self.nodes.is_empty() {
            stack.push(0u32);
        }
        while let Some(node) = stack.pop() {
            let Node { aabb, start, end, right } = &self.nodes[node as usize];
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
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Vector;

    #[test]
    fn tree_against_brute_force() {
        let boxes: Vec<Aabb<3>> = (0..500u32)
            .map(|i| {
                let f = |k: u32| ((i * 2654435761u32.wrapping_mul(k)) >> 8) as f64 / 16777216.0;
                let min = Vector::<3>::new(f(1), f(3), f(7));
                Aabb { min, max: min.add_scalar(0.05) }
            })
            .collect();
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
