//! From the facets whose patch is known to all facets, and the borders between patches.

use super::directions::nearest;
use super::partition::{Labels, Patches};
use crate::configuration::FacetSide;
use crate::geometry::Vector;
use crate::geometry::mesh::components::Components;
use crate::geometry::primitives::facet::area_vector;

/// Facets of one side that share a vertex look the same way if the cosine between their normals is larger: 32°.
pub(crate) const ALIKE: f64 = 0.85;

/// Some facets of a side at every vertex, under the numbers that are given with them; both ascending.
pub(super) fn at_vertices<const D: usize>(
    side: &FacetSide<D>,
    facets: impl Iterator<Item = (u32, u32)>,
) -> Vec<(u32, Vec<u32>)> {
    let mut pairs: Vec<(u32, u32)> = Vec::new();
    for (facet, number) in facets {
        pairs.extend(side.facets[facet as usize].iter().map(|&v| (v, number)));
    }
    pairs.sort_unstable();
    pairs.chunk_by(|p, q| p.0 == q.0).map(|chunk| (chunk[0].0, chunk.iter().map(|pair| pair.1).collect())).collect()
}

/// Whether two unit normals point much the same way; all do if `alike` is below −1, and zero points nowhere.
pub(super) fn are_alike<const D: usize>(p: &Vector<D>, q: &Vector<D>, alike: f64) -> bool {
    p.dot(q) > alike
}

impl<const D: usize> Patches<D> {
    /// Sets the labels of some facets of one side, ascending, from those that are known of them, and blends the patches
    /// where they meet on a smooth surface.
    pub(super) fn label(&mut self, of_b: bool, side: &FacetSide<D>, facets: Vec<u32>, seeds: &[Option<u32>]) {
        let at_vertices = at_vertices(side, facets.iter().copied().zip(0..));
        let normal =
            |&facet: &u32| area_vector(&side.corners(facet as usize)).try_normalize(0.0).unwrap_or_else(Vector::zeros);
        let normals: Vec<Vector<D>> = facets.iter().map(normal).collect();
        // Facets that hang together with none that is known go by their normals.
        let labels: Vec<u32> = spread(side, &facets, &normals, seeds, &at_vertices)
            .into_iter()
            .zip(&normals)
            .map(|(label, normal)| label.unwrap_or_else(|| nearest(&self.directions, normal) as u32))
            .collect();
        let mut blended = labels.clone();
        for (vertex, around) in &at_vertices {
            if around.iter().all(|&f| labels[f as usize] == labels[around[0] as usize]) {
                continue;
            }
            // The fans of facets that look alike pass smoothly from patch to patch; others meet in an edge.
            let mut fans = Components::new(around.len());
            for p in 0..around.len() {
                for q in p + 1..around.len() {
                    if are_alike(&normals[around[p] as usize], &normals[around[q] as usize], ALIKE) {
                        fans.join(p as u32, q as u32, false);
                    }
                }
            }
            let roots: Vec<u32> = (0..around.len() as u32).map(|k| fans.find(k).0).collect();
            for (k, &facet) in around.iter().enumerate() {
                let fan = || (0..around.len()).filter(|&other| roots[other] == roots[k]).map(|other| around[other]);
                if fan().all(|other| labels[other as usize] == labels[facet as usize]) {
                    continue;
                }
                let corners = side.facets[facets[facet as usize] as usize];
                let Some(corner) = corners.iter().position(|v| v == vertex) else { continue };
                let blend = self.blend(&mut blended[facet as usize], labels[facet as usize]);
                for (direction, at_corners) in blend.iter_mut().enumerate() {
                    let of_patch = fan().filter(|&other| labels[other as usize] as usize == direction).count();
                    at_corners[corner] = of_patch as f64 / fan().count() as f64;
                }
            }
        }
        self.labels[usize::from(of_b)] = Labels { facets, labels: blended };
    }

    /// The parts of all directions at the corners of a facet with this label; `place` is where its label stands.
    fn blend(&mut self, place: &mut u32, label: u32) -> &mut Vec<[f64; D]> {
        let count = self.directions.len();
        if (*place as usize) < count {
            *place = (count + self.blends.len()) as u32;
            self.blends.push((0..count).map(|d| [f64::from(d == label as usize); D]).collect());
        }
        &mut self.blends[*place as usize - count]
    }
}

/// Labels of some facets of a side from those that are known: breadth first over shared vertices, around edges only
/// where there is no smooth way.
fn spread<const D: usize>(
    side: &FacetSide<D>,
    facets: &[u32],
    normals: &[Vector<D>],
    seeds: &[Option<u32>],
    at_vertices: &[(u32, Vec<u32>)],
) -> Vec<Option<u32>> {
    let mut labels = seeds.to_vec();
    let reach = |labels: &mut Vec<Option<u32>>, from: &[u32], alike: f64| {
        let mut reached = Vec::new();
        for &facet in from {
            for &vertex in &side.facets[facets[facet as usize] as usize] {
                let place = at_vertices.partition_point(|(v, _)| *v < vertex);
                for &neighbour in &at_vertices[place].1 {
                    let are_alike = || are_alike(&normals[facet as usize], &normals[neighbour as usize], alike);
                    if labels[neighbour as usize].is_none() && are_alike() {
                        labels[neighbour as usize] = labels[facet as usize];
                        reached.push(neighbour);
                    }
                }
            }
        }
        reached
    };
    let mut labelled: Vec<u32> = (0..seeds.len() as u32).filter(|&f| seeds[f as usize].is_some()).collect();
    let mut front = labelled.clone();
    while !front.is_empty() {
        while !front.is_empty() {
            front = reach(&mut labels, &front, ALIKE);
            labelled.extend_from_slice(&front);
        }
        front = reach(&mut labels, &labelled, -2.0);
        labelled.extend_from_slice(&front);
    }
    labels
}
