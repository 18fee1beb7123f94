//! Connected components, of cells and of facets.

use crate::geometry::Vector;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::inside::winding_number;

/// Ids without repetition, ascending.
pub(crate) fn sorted_ids(labels: &[i64]) -> Vec<i64> {
    let mut ids = labels.to_vec();
    ids.sort_unstable();
    ids.dedup();
    ids
}

/// Disjoint sets whose members are turned, or not, against the root of their set.
pub(crate) struct Components {
    parent: Vec<(u32, bool)>,
}

impl Components {
    pub(crate) fn new(count: usize) -> Self {
        Self { parent: (0..count as u32).map(|i| (i, false)).collect() }
    }

    /// Root of the member's set, and whether the member is turned against it.
    pub(crate) fn find(&mut self, member: u32) -> (u32, bool) {
        let (mut root, mut turned) = (member, false);
        while self.parent[root as usize].0 != root {
            let (up, flip) = self.parent[root as usize];
            (root, turned) = (up, turned != flip);
        }
        let (mut at, mut rest) = (member, turned);
        while at != root {
            let (up, flip) = self.parent[at as usize];
            self.parent[at as usize] = (root, rest);
            (at, rest) = (up, rest != flip);
        }
        (root, turned)
    }

    /// Joins two sets, the members being turned against each other or not; false if they are known to be otherwise.
    pub(crate) fn join(&mut self, a: u32, b: u32, turned: bool) -> bool {
        let ((root_a, flip_a), (root_b, flip_b)) = (self.find(a), self.find(b));
        if root_a == root_b {
            return (flip_a != flip_b) == turned;
        }
        let (low, high) = (root_a.min(root_b), root_a.max(root_b));
        self.parent[high as usize] = (low, flip_a ^ flip_b ^ turned);
        true
    }
}

/// Volume enclosed by closed, oriented facets.
pub(crate) fn enclosed_volume<const D: usize>(facets: &[[u32; D]], points: &[Vector<D>]) -> f64 {
    let origin = facets.first().map_or(Vector::zeros(), |f| points[f[0] as usize]);
    let moment = |f: &[u32; D]| {
        let x = f.map(|v| points[v as usize] - origin);
        area_vector(&x).dot(&x[0])
    };
    facets.iter().map(moment).sum::<f64>() / D as f64
}

/// Number of the component of each facet, with cavities given to the smallest body around them.
pub(crate) fn connected_labels<const D: usize>(coords: &[[f64; D]], facets: &[[u32; D]]) -> Vec<i64> {
    let mut groups = Components::new(coords.len());
    for facet in facets {
        for &node in &facet[1..] {
            groups.join(facet[0], node, false);
        }
    }
    let roots: Vec<u32> = facets.iter().map(|f| groups.find(f[0]).0).collect();
    let mut numbers: Vec<u32> = Vec::new();
    let mut component = vec![u32::MAX; coords.len()];
    let mut members: Vec<Vec<[u32; D]>> = Vec::new();
    for (facet, &root) in facets.iter().zip(&roots) {
        let number = &mut component[root as usize];
        if *number == u32::MAX {
            *number = members.len() as u32;
            members.push(Vec::new());
        }
        members[*number as usize].push(*facet);
        numbers.push(*number);
    }
    let points: Vec<Vector<D>> = coords.iter().map(|&x| x.into()).collect();
    let volumes: Vec<f64> = members.iter().map(|m| enclosed_volume(m, &points)).collect();
    let owner: Vec<i64> = (0..members.len())
        .map(|c| {
            let x = points[members[c][0][0] as usize];
            let around = |o: &usize| volumes[*o] > -volumes[c] && winding_number(&members[*o], &points, &x) > 0;
            match volumes[c] {
                v if v >= 0.0 => c as i64,
                _ => (0..members.len())
                    .filter(around)
                    .min_by(|&p, &q| volumes[p].total_cmp(&volumes[q]))
                    .map_or(c as i64, |o| o as i64),
            }
        })
        .collect();
    numbers.iter().map(|&n| owner[n as usize]).collect()
}
