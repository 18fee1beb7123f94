//! Which equations a matrix couples.

use super::Lower;

/// Equations in groups, of which all of one are eliminated together, and the neighbours of every group.
pub(super) struct Graph {
    /// First equation of every group among those that are eliminated, and their number.
    groups: Vec<usize>,
    starts: Vec<usize>,
    neighbours: Vec<u32>,
}

impl Graph {
    /// Of the equations `of` a matrix, ascending; neighbours in this list at one place are a group.
    pub(super) fn new(matrix: &Lower, of: &[usize], places: &[[f64; 3]]) -> Self {
        let (mut groups, mut group) = (Vec::new(), vec![u32::MAX; matrix.size()]);
        for (k, &equation) in of.iter().enumerate() {
            if k == 0 || places.get(equation).is_none_or(|place| *place != places[of[k - 1]]) {
                groups.push(k);
            }
            group[equation] = groups.len() as u32 - 1;
        }
        let count = groups.len();
        groups.push(of.len());
        // Every edge once: by its first end.
        let (mut edges, mut seen) = (Vec::new(), vec![u32::MAX; count]);
        for (at, range) in groups.windows(2).enumerate() {
            for &equation in &of[range[0]..range[1]] {
                for &row in matrix.rows_of(equation) {
                    let other = group[row];
                    if other != u32::MAX && other != at as u32 && seen[other as usize] != at as u32 {
                        seen[other as usize] = at as u32;
                        edges.push((at as u32, other));
                    }
                }
            }
        }
        let mut starts = vec![0; count + 1];
        edges.iter().for_each(|(a, b)| [a, b].into_iter().for_each(|end| starts[*end as usize + 1] += 1));
        (0..count).for_each(|k| starts[k + 1] += starts[k]);
        let (mut next, mut neighbours) = (starts.clone(), vec![0; 2 * edges.len()]);
        for (a, b) in edges {
            for (from, to) in [(a, b), (b, a)] {
                neighbours[next[from as usize]] = to;
                next[from as usize] += 1;
            }
        }
        Self { groups, starts, neighbours }
    }

    /// Number of groups.
    pub(super) fn count(&self) -> usize {
        self.starts.len() - 1
    }

    /// Equations of a group, by their place in the list.
    pub(super) fn equations(&self, group: u32) -> std::ops::Range<usize> {
        self.groups[group as usize]..self.groups[group as usize + 1]
    }

    /// Groups that share an entry with one.
    pub(super) fn neighbours(&self, group: u32) -> &[u32] {
        &self.neighbours[self.starts[group as usize]..self.starts[group as usize + 1]]
    }
}
