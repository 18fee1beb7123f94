//! From the facets whose patch is known to all facets, and the borders between patches.

use super::partition::Patches;
use crate::geometry::components::Components;
use crate::geometry::facet::area_vector;
use crate::overlap::pair::sides::FacetSide;

/// Facets of one side that share a vertex look the same way if the cosine between their normals is larger: 32°.
pub(crate) const ALIKE: f64 = 0.85;

/// Facets of a side at every vertex, both ascending, as far as they are wanted.
pub(crate) fn at_vertices<const D: usize>(side: &FacetSide<D>, wanted: impl Fn(u32) -> bool) -> Vec<(u32, Vec<u32>)> {
    let mut pairs: Vec<(u32, u32)> = Vec::new();
    for (facet, vertices) in side.facets.iter().enumerate().filter(|(facet, _)| wanted(*facet as u32)) {
        pairs.extend(vertices.iter().map(|&v| (v, facet as u32)));
    }
    pairs.sort_unstable();
    pairs.chunk_by(|p, q| p.0 == q.0).map(|chunk| (chunk[0].0, chunk.iter().map(|pair| pair.1).collect())).collect()
}

/// Whether two facets of a side look the same way; all do if `alike` is below −1.
pub(crate) fn are_alike<const D: usize>(side: &FacetSide<D>, p: u32, q: u32, alike: f64) -> bool {
    if alike < -1.0 {
        return true;
    }
    let normal = |facet: u32| area_vector(&side.corners(facet as usize)).try_normalize(0.0);
    normal(p).zip(normal(q)).is_some_and(|(p, q)| p.dot(&q) > alike)
}

impl<const D: usize> Patches<D> {
    /// Sets the labels of one side from those of some of its facets, and blends the patches where they meet on a smooth
    /// surface.
    pub(crate) fn label(&mut self, of_b: bool, side: &FacetSide<D>, seeds: &[Option<u32>]) {
        let at_vertices = at_vertices(side, |_| true);
        let labels = spread(side, seeds, &at_vertices);
        self.labels[usize::from(of_b)].clone_from(&labels);
        for (vertex, facets) in &at_vertices {
            if facets.iter().all(|&f| labels[f as usize] == labels[facets[0] as usize]) {
                continue;
            }
            // The fans of facets that look alike pass smoothly from patch to patch; others meet in an edge.
            let mut fans = Components::new(facets.len());
            for p in 0..facets.len() {
                for q in p + 1..facets.len() {
                    if are_alike(side, facets[p], facets[q], ALIKE) {
                        fans.join(p as u32, q as u32, false);
                    }
                }
            }
            let roots: Vec<u32> = (0..facets.len() as u32).map(|k| fans.find(k).0).collect();
            for (k, &facet) in facets.iter().enumerate() {
                let fan = || (0..facets.len()).filter(|&other| roots[other] == roots[k]).map(|other| facets[other]);
                if fan().all(|other| labels[other as usize] == labels[facet as usize]) {
                    continue;
                }
                let corner = side.facets[facet as usize].iter().position(|v| v == vertex);
                let Some(corner) = corner else { continue };
                let blend = self.blend(of_b, facet, labels[facet as usize]);
                for (direction, at_corners) in blend.iter_mut().enumerate() {
                    let of_patch = fan().filter(|&other| labels[other as usize] as usize == direction).count();
                    at_corners[corner] = of_patch as f64 / fan().count() as f64;
                }
            }
        }
    }

    /// The parts of all directions at the corners of a facet with this label.
    fn blend(&mut self, of_b: bool, facet: u32, label: u32) -> &mut Vec<[f64; D]> {
        let count = self.directions.len();
        let place = &mut self.labels[usize::from(of_b)][facet as usize];
        if (*place as usize) < count {
            *place = (count + self.blends.len()) as u32;
            self.blends.push((0..count).map(|d| [f64::from(d == label as usize); D]).collect());
        }
        &mut self.blends[*place as usize - count]
    }
}

/// Labels of all facets of a side from those of some: breadth first over shared vertices, around edges only where there
/// is no smooth way.
fn spread<const D: usize>(side: &FacetSide<D>, seeds: &[Option<u32>], at_vertices: &[(u32, Vec<u32>)]) -> Vec<u32> {
    let mut labels = seeds.to_vec();
    let reach = |labels: &mut Vec<Option<u32>>, from: &[u32], alike: f64| {
        let mut reached = Vec::new();
        for &facet in from {
            for &vertex in &side.facets[facet as usize] {
                let place = at_vertices.partition_point(|(v, _)| *v < vertex);
                for &neighbour in &at_vertices[place].1 {
                    if labels[neighbour as usize].is_none() && are_alike(side, facet, neighbour, alike) {
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
    labels.into_iter().map(|label| label.unwrap_or(0)).collect()
}
