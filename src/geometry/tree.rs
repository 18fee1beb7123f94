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

impl<const D: usize> Tree<D> {
    /// Visits every pair of items, the first of `self`, that lie in leaves whose boxes meet.
    pub(crate) fn visit_pairs(&self, other: &Self, mut pair: impl FnMut(u32, u32)) {
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
                        other.items[there.start as usize..there.end as usize].iter().for_each(|&j| pair(i, j));
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Vector;

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
        Tree::new(&here).visit_pairs(&Tree::new(&there), |i, j| {
            if here[i as usize].meets(&there[j as usize]) {
                found.push((i, j));
            }
        });
        found.sort_unstable();
        let all = (0..300).flat_map(|i| (0..170).map(move |j| (i, j)));
        let expected: Vec<(u32, u32)> = all.filter(|&(i, j)| here[i as usize].meets(&there[j as usize])).collect();
        assert!(expected.len() > 100);
        assert_eq!(found, expected);
        Tree::new(&here).visit_pairs(&Tree::new(&[]), |_, _| panic!("nothing meets an empty tree"));
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
