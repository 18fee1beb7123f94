//! Faces that meet several smaller ones: where a mesh is refined in part, nodes hang in the middle of larger faces.
//!
//! An edge may meet its two halves; a triangle four triangles or two; a quadrilateral four, or two halves, or two triangles.
//! They are recognised by their nodes, and checked by geometry.

use crate::Error;
use crate::geometry::Vector;
use std::collections::{BTreeMap, BTreeSet};

/// How far a hanging node may lie from the middle of what it hangs in, in lengths of the edge or face. What misses it by more,
/// up to [`MISSED`], is refused; beyond that it is a hole.
const WITHIN: f64 = 1e-9;
const MISSED: f64 = 1e-2;

/// A face without a neighbour that has the same nodes.
#[derive(Clone, Debug)]
pub(in crate::geometry) struct LoneFace {
    pub(in crate::geometry) cell: u32,
    pub(in crate::geometry) face: u8,
    /// Body, as far as it is known.
    pub(in crate::geometry) id: i64,
    /// In the order of its cell.
    pub(in crate::geometry) nodes: Vec<u32>,
}

/// A face and the smaller ones that it meets, by their places in the list.
#[derive(Debug, PartialEq)]
pub(in crate::geometry) struct Meeting {
    pub(in crate::geometry) large: usize,
    pub(in crate::geometry) small: Vec<usize>,
}

/// A node that hangs, and the nodes in whose middle it does.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct HangingNode {
    pub(crate) node: u32,
    pub(crate) parents: Vec<u32>,
}

struct Finder<'a, const D: usize> {
    faces: &'a [LoneFace],
    coords: &'a [[f64; D]],
    by_nodes: BTreeMap<Vec<u32>, usize>,
    /// Nodes at the other ends of edges.
    next: BTreeMap<u32, BTreeSet<u32>>,
    /// Faces at a node.
    at: BTreeMap<u32, Vec<usize>>,
}

/// All meetings among `faces`, and the nodes that hang, ascending.
///
/// # Errors
/// [`Error::NonConforming`] for faces that would meet were it not for a node that lies beside the middle.
pub(in crate::geometry) fn meetings<const D: usize>(
    faces: &[LoneFace],
    coords: &[[f64; D]],
) -> Result<(Vec<Meeting>, Vec<HangingNode>), Error> {
    let mut finder = Finder { faces, coords, by_nodes: BTreeMap::new(), next: BTreeMap::new(), at: BTreeMap::new() };
    for (number, face) in faces.iter().enumerate() {
        finder.by_nodes.insert(sorted(face.nodes.clone()), number);
        for (k, &node) in face.nodes.iter().enumerate() {
            let other = face.nodes[(k + 1) % face.nodes.len()];
            finder.next.entry(node).or_default().insert(other);
            finder.next.entry(other).or_default().insert(node);
            finder.at.entry(node).or_default().push(number);
        }
    }
    let (mut found, mut hanging) = (Vec::new(), BTreeMap::new());
    for large in 0..faces.len() {
        let Some((small, middles)) = finder.meeting(large) else { continue };
        finder.check(large, &small, &middles)?;
        found.push(Meeting { large, small });
        hanging.extend(middles.into_iter().map(|middle| (middle.node, middle)));
    }
    Ok((found, hanging.into_values().collect()))
}

fn sorted(mut nodes: Vec<u32>) -> Vec<u32> {
    nodes.sort_unstable();
    nodes
}

impl<const D: usize> Finder<'_, D> {
    /// The smaller faces that a face meets by their nodes, and what hangs in it.
    fn meeting(&self, large: usize) -> Option<(Vec<usize>, Vec<HangingNode>)> {
        let nodes = &self.faces[large].nodes;
        match nodes[..] {
            [a, b] => {
                let m = self.middle(&[a, b])?;
                self.all(large, vec![vec![a, m.node], vec![m.node, b]], vec![m])
            }
            [a, b, c] => self.four_triangles(large, [a, b, c]).or_else(|| {
                let halves = |[a, b, c]: [u32; 3]| {
                    let m = self.middle(&[a, b])?;
                    self.all(large, vec![vec![a, m.node, c], vec![m.node, b, c]], vec![m])
                };
                halves([a, b, c]).or_else(|| halves([b, c, a])).or_else(|| halves([c, a, b]))
            }),
            [a, b, c, d] => {
                let halves = |[a, b, c, d]: [u32; 4]| {
                    let (p, q) = (self.middle(&[a, b])?, self.middle(&[c, d])?);
                    let small = vec![vec![a, p.node, q.node, d], vec![p.node, b, c, q.node]];
                    self.all(large, small, vec![p, q])
                };
                self.quarters(large, [a, b, c, d])
                    .or_else(|| halves([a, b, c, d]))
                    .or_else(|| halves([b, c, d, a]))
                    .or_else(|| self.all(large, vec![vec![a, b, c], vec![a, c, d]], Vec::new()))
                    .or_else(|| self.all(large, vec![vec![b, c, d], vec![b, d, a]], Vec::new()))
            }
            _ => None,
        }
    }

    fn four_triangles(&self, large: usize, [a, b, c]: [u32; 3]) -> Option<(Vec<usize>, Vec<HangingNode>)> {
        let [p, q, r] = [self.middle(&[a, b])?, self.middle(&[b, c])?, self.middle(&[c, a])?];
        let [ab, bc, ca] = [p.node, q.node, r.node];
        let small = vec![vec![a, ab, ca], vec![ab, b, bc], vec![ca, bc, c], vec![ab, bc, ca]];
        self.all(large, small, vec![p, q, r])
    }

    fn quarters(&self, large: usize, corners: [u32; 4]) -> Option<(Vec<usize>, Vec<HangingNode>)> {
        let mut middles = Vec::new();
        for k in 0..4 {
            middles.push(self.middle(&[corners[k], corners[(k + 1) % 4]])?);
        }
        let edges: [u32; 4] = std::array::from_fn(|k| middles[k].node);
        let known = [corners[0], edges[0], edges[3]];
        let centre = self.at.get(&corners[0])?.iter().find_map(|&face| {
            let nodes = &self.faces[face].nodes;
            let fits = nodes.len() == 4 && known.iter().all(|node| nodes.contains(node));
            fits.then(|| nodes.iter().copied().find(|node| !known.contains(node))).flatten()
        })?;
        let small = (0..4).map(|k| vec![corners[k], edges[k], centre, edges[(k + 3) % 4]]).collect();
        middles.push(HangingNode { node: centre, parents: corners.to_vec() });
        self.all(large, small, middles)
    }

    /// The faces with these nodes, if all of them are there and of the same body.
    fn all(
        &self,
        large: usize,
        small: Vec<Vec<u32>>,
        middles: Vec<HangingNode>,
    ) -> Option<(Vec<usize>, Vec<HangingNode>)> {
        let LoneFace { id, cell, .. } = self.faces[large];
        // A flat cell has a node in the middle of its own edge.
        let fits = |face: &usize| self.faces[*face].id == id && self.faces[*face].cell != cell;
        let find = |nodes| self.by_nodes.get(&sorted(nodes)).copied().filter(fits);
        let found: Option<Vec<usize>> = small.into_iter().map(find).collect();
        Some((found?, middles))
    }

    /// The node nearest to the middle of two among those joined to both by an edge, if there is one near it.
    fn middle(&self, ends: &[u32; 2]) -> Option<HangingNode> {
        let [one, other] = ends.map(|end| self.next.get(&end));
        let both = one?.intersection(other?);
        let near = both.map(|&node| (self.beside(node, ends), node)).filter(|(off, _)| *off < MISSED);
        let (_, node) = near.min_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal))?;
        Some(HangingNode { node, parents: ends.to_vec() })
    }

    /// Distance of a node from the middle of others, in lengths of what they span.
    fn beside(&self, node: u32, parents: &[u32]) -> f64 {
        let x = |node: u32| Vector::<D>::from(self.coords[node as usize]);
        let mean = parents.iter().map(|&parent| x(parent)).sum::<Vector<D>>() / parents.len() as f64;
        let size = parents.iter().map(|&parent| (x(parent) - mean).norm()).fold(0.0, f64::max);
        (x(node) - mean).norm() / (2.0 * size)
    }

    fn check(&self, large: usize, small: &[usize], middles: &[HangingNode]) -> Result<(), Error> {
        let is_off = |middle: &HangingNode| self.beside(middle.node, &middle.parents) > WITHIN;
        let corners = &self.faces[large].nodes;
        // Halves along a diagonal lie on the face if its own middle lies on both diagonals.
        let is_bent = middles.is_empty() && {
            let x = |k: usize| Vector::<D>::from(self.coords[corners[k] as usize]);
            let (p, q, r) = (x(1) - x(0), x(2) - x(0), x(3) - x(0));
            let size = p.norm().max(q.norm()).max(r.norm());
            // Volume of the tetrahedron of the corners, by Gram's determinant: zero where they lie in one plane.
            let gram = nalgebra::Matrix3::new(
                p.dot(&p),
                p.dot(&q),
                p.dot(&r),
                q.dot(&p),
                q.dot(&q),
                q.dot(&r),
                r.dot(&p),
                r.dot(&q),
                r.dot(&r),
            );
            gram.determinant().max(0.0).sqrt() > WITHIN * size.powi(3)
        };
        if is_bent || middles.iter().any(is_off) {
            let [one, other] = [large, small[0]].map(|face| self.faces[face].cell as usize);
            return Err(Error::NonConforming { cells: [one.min(other), one.max(other)] });
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn faces(all: &[&[u32]]) -> Vec<LoneFace> {
        let face =
            |(cell, nodes): (usize, &&[u32])| LoneFace { cell: cell as u32, face: 0, id: 0, nodes: nodes.to_vec() };
        all.iter().enumerate().map(face).collect()
    }

    #[test]
    fn an_edge_and_its_halves() {
        let x = [[0.0, 0.0], [1.0, 1.0], [0.5, 0.5], [3.0, 0.0]];
        let lone = faces(&[&[0, 1], &[2, 0], &[1, 2], &[1, 3], &[3, 0]]);
        let (met, hanging) = meetings(&lone, &x).expect("a middle");
        assert_eq!(met, [Meeting { large: 0, small: vec![1, 2] }]);
        assert_eq!(hanging, [HangingNode { node: 2, parents: vec![0, 1] }]);
        let mut beside = x;
        beside[2][0] += 1e-6;
        assert_eq!(meetings(&lone, &beside), Err(Error::NonConforming { cells: [0, 1] }));
        // A hole.
        beside[2][0] += 0.2;
        assert_eq!(meetings(&lone, &beside), Ok((Vec::new(), Vec::new())));
    }

    #[test]
    fn a_flat_cell_meets_nothing_of_its_own() {
        let x = [[0.0, 0.0], [1.0, 0.0], [0.5, 1e-4]];
        let mut lone = faces(&[&[0, 1], &[1, 2], &[2, 0]]);
        lone.iter_mut().for_each(|face| face.cell = 0);
        assert_eq!(meetings(&lone, &x), Ok((Vec::new(), Vec::new())));
    }

    #[test]
    fn quadrilaterals_and_triangles() {
        let mut x: Vec<[f64; 3]> = (0..9).map(|k| [f64::from(k % 3), f64::from(k / 3), 0.0]).collect();
        let quarters: [&[u32]; 5] = [&[0, 2, 8, 6], &[0, 3, 4, 1], &[1, 4, 5, 2], &[3, 6, 7, 4], &[4, 7, 8, 5]];
        let (met, hanging) = meetings(&faces(&quarters), &x).expect("quarters");
        assert_eq!(met.len(), 1);
        assert_eq!(sorted(met[0].small.iter().map(|&k| k as u32).collect()), [1, 2, 3, 4]);
        assert_eq!(hanging.iter().map(|h| h.node).collect::<Vec<_>>(), [1, 3, 4, 5, 7]);
        assert_eq!(hanging[2].parents, [0, 2, 8, 6]);
        let halves: [&[u32]; 3] = [&[0, 2, 8, 6], &[0, 6, 7, 1], &[1, 7, 8, 2]];
        assert_eq!(meetings(&faces(&halves), &x).expect("halves").0.len(), 1);
        let triangles: [&[u32]; 3] = [&[0, 2, 8, 6], &[0, 8, 2], &[0, 6, 8]];
        assert_eq!(meetings(&faces(&triangles), &x).expect("triangles").0.len(), 1);
        x[8][2] = 1e-3;
        assert_eq!(meetings(&faces(&triangles), &x), Err(Error::NonConforming { cells: [0, 1] }));
        let four: [&[u32]; 5] = [&[0, 2, 6], &[0, 3, 1], &[1, 4, 2], &[3, 6, 4], &[1, 3, 4]];
        x[4] = [1.0, 1.0, 0.0];
        assert_eq!(meetings(&faces(&four), &x).expect("four triangles").0.len(), 1);
    }
}
