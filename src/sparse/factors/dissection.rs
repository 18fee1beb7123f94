//! Order of elimination by nested dissection: a part is cut in two, each half is eliminated by itself, and then the groups along
//! the cut.
//!
//! With equations that are kept for the end minimum degree fills far more, since it does not see them: what is eliminated next
//! to them couples them all, early. Halves couple those alone that lie about them.

use super::graph::Graph;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::SymbolicSparseColMatRef;
use faer::sparse::linalg::amd;

/// Groups of a part that is not cut any more, but ordered by minimum degree.
const LEAF: usize = 60;

/// Weight of the halves' difference, as a part of all, beside the groups along the cut.
const UNEVEN: f64 = 0.5;

/// Searches for a group that is far from all others.
const SEARCHES: usize = 3;

/// Order of the groups, which are at these places.
pub(super) fn dissect(graph: &Graph, places: &[[f64; 3]]) -> Vec<u32> {
    let count = graph.count();
    let (part, value, order) = (vec![0; count], vec![0.0; count], Vec::with_capacity(count));
    let mut dissection = Dissection { graph, places, part, parts: 0, value, order };
    dissection.eliminate((0..count as u32).collect());
    dissection.order
}

struct Dissection<'a> {
    graph: &'a Graph,
    places: &'a [[f64; 3]],
    /// Part of which every group is one, and parts so far.
    part: Vec<u32>,
    parts: u32,
    /// Number or distance of every group in its part.
    value: Vec<f64>,
    order: Vec<u32>,
}

/// Halves of a part, and what lies between them.
#[derive(Default)]
struct Cut {
    halves: [Vec<u32>; 2],
    between: Vec<u32>,
}

impl Dissection<'_> {
    fn eliminate(&mut self, groups: Vec<u32>) {
        let cut = if groups.len() > LEAF { self.cut(&groups) } else { Cut::default() };
        let Cut { halves: [low, high], between } = cut;
        if low.is_empty() || high.is_empty() {
            return self.minimum_degree(&groups);
        }
        self.eliminate(low);
        self.eliminate(high);
        self.minimum_degree(&between);
    }

    /// The best of some cuts: across every axis, and between the nearer and the farther half from a group at the rim.
    fn cut(&mut self, groups: &[u32]) -> Cut {
        let (mut best, mut least) = (Cut::default(), f64::INFINITY);
        for axis in 0..4 {
            if axis < 3 {
                groups.iter().for_each(|&g| self.value[g as usize] = self.places[g as usize][axis]);
            } else if !self.distances(groups) {
                break;
            }
            let mut sorted = groups.to_vec();
            let value = |group: &u32| self.value[*group as usize];
            let half = sorted.len() / 2;
            sorted.select_nth_unstable_by(half, |a, b| value(a).total_cmp(&value(b)).then(a.cmp(b)));
            let parts = [self.name(&sorted[..half]), self.name(&sorted[half..])];
            for [mine, other] in [parts, [parts[1], parts[0]]] {
                let mut cut = Cut::default();
                for &group in groups {
                    let is_at = |part: u32| self.graph.neighbours(group).iter().any(|n| self.part[*n as usize] == part);
                    let own = self.part[group as usize];
                    if own == mine && is_at(other) {
                        cut.between.push(group);
                    } else {
                        cut.halves[usize::from(own == parts[1])].push(group);
                    }
                }
                let [low, high] = [0, 1].map(|half| cut.halves[half].len() as f64);
                let cost = cut.between.len() as f64 * (1.0 + UNEVEN * (low - high).abs() / groups.len() as f64);
                if cost < least {
                    (best, least) = (cut, cost);
                }
            }
        }
        best
    }

    /// Makes groups a part of their own; its number.
    fn name(&mut self, groups: &[u32]) -> u32 {
        self.parts += 1;
        groups.iter().for_each(|&group| self.part[group as usize] = self.parts);
        self.parts
    }

    /// Edges from a group at the rim to every other one; `false` if there is no way to some.
    fn distances(&mut self, groups: &[u32]) -> bool {
        let own = self.name(groups);
        let mut from = groups[0];
        for _ in 0..SEARCHES {
            groups.iter().for_each(|&group| self.value[group as usize] = f64::INFINITY);
            self.value[from as usize] = 0.0;
            let (mut reached, mut next) = (vec![from], 0);
            while let Some(&group) = reached.get(next) {
                for &other in self.graph.neighbours(group) {
                    if self.part[other as usize] == own && self.value[other as usize] == f64::INFINITY {
                        self.value[other as usize] = self.value[group as usize] + 1.0;
                        reached.push(other);
                    }
                }
                next += 1;
            }
            if reached.len() < groups.len() {
                return false;
            }
            from = reached[next - 1];
        }
        true
    }

    fn minimum_degree(&mut self, groups: &[u32]) {
        let own = self.name(groups);
        groups.iter().enumerate().for_each(|(k, &group)| self.value[group as usize] = k as f64);
        let (mut starts, mut rows) = (vec![0], Vec::new());
        for &group in groups {
            let mine = self.graph.neighbours(group).iter().filter(|other| self.part[**other as usize] == own);
            rows.extend(mine.map(|other| self.value[*other as usize] as usize));
            rows[*starts.last().expect("a start")..].sort_unstable();
            starts.push(rows.len());
        }
        let count = groups.len();
        let pattern = SymbolicSparseColMatRef::new_checked(count, count, &starts, None, &rows);
        let (mut order, mut inverse) = (vec![0usize; count], vec![0usize; count]);
        let mut memory = MemBuffer::new(amd::order_scratch::<usize>(count, rows.len()));
        let stack = MemStack::new(&mut memory);
        match amd::order(&mut order, &mut inverse, pattern, amd::Control::default(), stack) {
            Ok(_) => self.order.extend(order.into_iter().map(|k| groups[k])),
            Err(_) => self.order.extend(groups),
        }
    }
}
