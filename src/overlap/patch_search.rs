//! The search for the patches of contact: which facets touch together, and along which direction their lines run.
//!
//! A first, coarser pass with the standard line families finds the facets at the ends of spans. Facets that face one
//! another across a span belong together, and so do facets that share a vertex and look much the same way: a patch, whose
//! direction is the mean normal, ∂V summed over it, so that L is the penetration depth. Two faces that meet at a corner
//! are two patches; the flanks of a wedge in a flat surface are one, by the surface. Patches of equal direction are one.
//! Every other facet belongs to the patch that is nearest along the surface.
//!
//! Of the patches of one overlap, those that are small, or deep beside another, are not contact but the way out sideways:
//! the ends of two blocks that overlap by a strip.

use super::layout::{FiberPair, Layout};
use super::patch::Patches;
use super::side::{FacetSide, Opponent};
use super::span::End;
use crate::Error;
use crate::geometry::Vector;
use crate::geometry::components::Components;
use crate::geometry::facet::area_vector;
use nalgebra::{Matrix3, Vector3};

/// Lines of the first pass are this much further apart: it needs no more than the mean normal.
const COARSER: f64 = 2.0;

/// Directions are rounded to this part of their length, unless they are kept: while a patch turns less, the lines stay
/// where they are and the forces are those of one energy. It makes L wrong by 2e-7 of itself.
const ROUNDING: f64 = 1.0 / 1024.0;

/// A resultant below this part of the contact area has no direction: one side swallows the other.
const CANCELLED: f64 = 1e-6;

/// Facets of one side that share a vertex look the same way if their normals are closer than 32°; so do two points of a
/// rigid shape, wherever they are.
const ALIKE: f64 = 0.85;

/// Facets at the ends of a span face one another if their normals are within 60° of opposite.
const FACING: f64 = -0.5;

/// A patch with less than this part of the largest one's measure is the rim of another: such as the side walls of a
/// block that is a little way in.
const SMALL: f64 = 0.05;

/// A patch whose spans are on average this much longer than those of another of the same overlap is no way out.
const DEEP: f64 = 3.0;

/// One span of the first pass: slots of the facets at its ends, if it has them, and what they add to the resultant.
struct Link<const D: usize> {
    slots: [Option<u32>; 2],
    shares: [(Vector<D>, f64); 2],
    /// Of the span.
    length: f64,
    facing: bool,
}

impl<const D: usize> FiberPair<'_, D> {
    /// The patches of the pair, or `None` where it has no overlap. With `rounded`, directions are rounded.
    pub(crate) fn patches(&self, rounded: bool) -> Result<Option<Patches<D>>, Error> {
        let links = self.with_layout(COARSER, |layout| {
            let links = self.for_each_bundle(layout, |bundle| {
                let mut links = Vec::new();
                self.visit_spans(bundle, layout, 0, |sampled| {
                    links.push(self.link(layout, sampled.span.length, &sampled.span.ends));
                })?;
                Ok(links)
            })?;
            Ok(links.into_iter().flatten().collect::<Vec<Link<D>>>())
        })?;
        Ok(links.filter(|links| !links.is_empty()).map(|links| self.join(&links, rounded)))
    }

    /// Measure of boundary at the ends of a span, as vectors towards the first side.
    fn link(&self, layout: &Layout<D>, length: f64, ends: &[End<D>; 2]) -> Link<D> {
        let mut link = Link { slots: [None; 2], shares: [(Vector::zeros(), 0.0); 2], length, facing: false };
        let mut normals = [Vector::zeros(); 2];
        for (((end, slot), share), facing) in ends.iter().zip(&mut link.slots).zip(&mut link.shares).zip(&mut normals) {
            let (normal, of_b) = match *end {
                End::Facet { of_b, facet, .. } => {
                    *slot = Some(self.slot(of_b, facet));
                    let side = self.pair.side(of_b);
                    let normal = area_vector(&side.corners(facet as usize)).try_normalize(0.0);
                    (normal.unwrap_or_else(Vector::zeros), of_b)
                }
                End::Point { normal, .. } => (normal, true),
            };
            let slope: f64 = self.families.iter().map(|f| f.direction().dot(&normal).abs()).sum();
            // Long spans cross a body from side to side; those of the contact are short.
            let measure = if slope > 0.0 && length > 0.0 { layout.volume_per_length / slope } else { 0.0 };
            *share = (normal * if of_b { measure } else { -measure }, measure);
            *facing = normal;
        }
        link.facing = normals[0].dot(&normals[1]) < FACING;
        link
    }

    fn slot(&self, of_b: bool, facet: u32) -> u32 {
        if of_b { self.pair.a.facets.len() as u32 + facet } else { facet }
    }

    fn join(&self, links: &[Link<D>], rounded: bool) -> Patches<D> {
        // Where nothing faces anything, as deep inside one another, every span counts.
        let some_face = links.iter().any(|link| link.facing);
        let counted: Vec<&Link<D>> = links.iter().filter(|link| link.facing || !some_face).collect();
        let mut patches = self.components(&counted, ALIKE);
        let mut overlaps = self.components(&links.iter().collect::<Vec<_>>(), -2.0);
        let mut clusters: Vec<Cluster<D>> = Vec::new();
        let mut cluster_of_root = vec![u32::MAX; self.slot_count()];
        for link in &counted {
            let Some(&slot) = link.slots.iter().flatten().next() else { continue };
            let place = &mut cluster_of_root[patches.find(slot).0 as usize];
            if *place == u32::MAX {
                *place = clusters.len() as u32;
                clusters.push(Cluster::new(overlaps.find(slot).0));
            }
            clusters[*place as usize].add(link);
        }
        let mut directions: Vec<Vector<D>> = Vec::new();
        let mut labels_of_clusters: Vec<Option<u32>> = Vec::new();
        for cluster in &clusters {
            let within = || clusters.iter().filter(|other| other.overlap == cluster.overlap);
            let largest = within().map(|other| other.measure).fold(0.0, f64::max);
            let is_large = |other: &&Cluster<D>| other.measure >= SMALL * largest;
            let shallowest = within().filter(is_large).map(Cluster::depth).fold(f64::INFINITY, f64::min);
            if !is_large(&cluster) || cluster.depth() > DEEP * shallowest {
                labels_of_clusters.push(None);
                continue;
            }
            let direction = cluster.direction(rounded);
            let label = directions.iter().position(|d| *d == direction).unwrap_or_else(|| {
                directions.push(direction);
                directions.len() - 1
            });
            labels_of_clusters.push(Some(label as u32));
        }
        if directions.len() < 2 {
            return Patches::single(directions.first().copied().unwrap_or(*self.families[0].direction()));
        }
        let mut seeds = vec![None; self.slot_count()];
        for slot in counted.iter().flat_map(|link| link.slots).flatten() {
            let cluster = cluster_of_root[patches.find(slot).0 as usize];
            seeds[slot as usize] = labels_of_clusters.get(cluster as usize).copied().flatten();
        }
        let mut labels = [Vec::new(), Vec::new()];
        for ((side, first), labels) in self.sides().into_iter().zip(&mut labels) {
            *labels = spread(side, &seeds[first as usize..first as usize + side.facets.len()]);
        }
        Patches { directions, spacing: None, labels }
    }

    /// Facets that are joined by spans, or by a vertex if the cosine between their normals exceeds `alike`.
    fn components(&self, links: &[&Link<D>], alike: f64) -> Components {
        let mut sets = Components::new(self.slot_count());
        let mut seen = vec![false; self.slot_count()];
        let mut of_shape: Vec<(Vector<D>, u32)> = Vec::new();
        for link in links {
            for slot in link.slots.iter().flatten() {
                seen[*slot as usize] = true;
            }
            match link.slots {
                [Some(p), Some(q)] => drop(sets.join(p, q, false)),
                [Some(p), None] | [None, Some(p)] => {
                    let normal = link.shares.iter().zip(link.slots).find(|(_, slot)| slot.is_none()).map(|(s, _)| s.0);
                    let Some(normal) = normal.and_then(|n| n.try_normalize(0.0)) else { continue };
                    match of_shape.iter().find(|(n, _): &&(Vector<D>, u32)| n.dot(&normal) > alike) {
                        Some(&(_, q)) => drop(sets.join(p, q, false)),
                        None => of_shape.push((normal, p)),
                    }
                }
                [None, None] => {}
            }
        }
        for (side, first) in self.sides() {
            let normal = |slot: u32| area_vector(&side.corners((slot - first) as usize)).try_normalize(0.0);
            for (_, slots) in at_vertices(side, |facet| seen[(first + facet) as usize]) {
                for (n, &p) in slots.iter().enumerate() {
                    for &q in &slots[n + 1..] {
                        let alike = |(p, q): (Vector<D>, Vector<D>)| p.dot(&q) > alike;
                        if normal(first + p).zip(normal(first + q)).is_some_and(alike) {
                            sets.join(first + p, first + q, false);
                        }
                    }
                }
            }
        }
        sets
    }

    fn sides(&self) -> Vec<(&FacetSide<'_, D>, u32)> {
        let mut sides = vec![(&self.pair.a, 0)];
        if let Opponent::Facets(b) = &self.pair.opponent {
            sides.push((b, self.pair.a.facets.len() as u32));
        }
        sides
    }

    fn slot_count(&self) -> usize {
        self.sides().iter().map(|(side, _)| side.facets.len()).sum()
    }
}

/// What is summed over a patch.
struct Cluster<const D: usize> {
    /// Root of the overlap to which it belongs.
    overlap: u32,
    resultant: Vector<D>,
    /// Σ measure n nᵀ.
    moments: Matrix3<f64>,
    measure: f64,
    /// Σ measure L.
    depths: f64,
}

impl<const D: usize> Cluster<D> {
    fn new(overlap: u32) -> Self {
        Self { overlap, resultant: Vector::zeros(), moments: Matrix3::zeros(), measure: 0.0, depths: 0.0 }
    }

    fn add(&mut self, link: &Link<D>) {
        for (vector, measure) in link.shares {
            self.resultant += vector;
            if measure > 0.0 {
                let v = Vector3::from_fn(|i, _| if i < D { vector[i] } else { 0.0 });
                self.moments += v * v.transpose() / measure;
            }
            self.measure += measure;
            self.depths += measure * link.length;
        }
    }

    /// Mean length of its spans.
    fn depth(&self) -> f64 {
        self.depths / self.measure
    }

    /// That of the resultant, or, where that cancels, the direction to which most normals are parallel. Its largest
    /// component is positive, so that it does not depend on the order of the sides.
    fn direction(&self, rounded: bool) -> Vector<D> {
        let mut d = self.resultant;
        if d.norm() <= CANCELLED * self.measure {
            let eigen = self.moments.symmetric_eigen();
            let most = eigen.eigenvectors.column(eigen.eigenvalues.imax());
            d = Vector::from_fn(|i, _| most[i]);
        }
        d /= d[d.iamax()];
        if rounded {
            d = d.map(|x| (x / ROUNDING).round() * ROUNDING);
        }
        d.normalize()
    }
}

/// Labels of all facets of a side from those of some: breadth first over shared vertices.
fn spread<const D: usize>(side: &FacetSide<D>, seeds: &[Option<u32>]) -> Vec<u32> {
    let at_vertices = at_vertices(side, |_| true);
    let mut labels = seeds.to_vec();
    let mut front: Vec<u32> = (0..seeds.len() as u32).filter(|&f| seeds[f as usize].is_some()).collect();
    while !front.is_empty() {
        let mut next = Vec::new();
        for facet in front {
            let label = labels[facet as usize];
            for &vertex in &side.facets[facet as usize] {
                let place = at_vertices.partition_point(|(v, _)| *v < vertex);
                for &neighbour in &at_vertices[place].1 {
                    if labels[neighbour as usize].is_none() {
                        labels[neighbour as usize] = label;
                        next.push(neighbour);
                    }
                }
            }
        }
        front = next;
    }
    labels.into_iter().map(|label| label.unwrap_or(0)).collect()
}

/// Facets of a side at every vertex, both ascending, as far as they are wanted.
fn at_vertices<const D: usize>(side: &FacetSide<D>, wanted: impl Fn(u32) -> bool) -> Vec<(u32, Vec<u32>)> {
    let mut pairs: Vec<(u32, u32)> = Vec::new();
    for (facet, vertices) in side.facets.iter().enumerate().filter(|(facet, _)| wanted(*facet as u32)) {
        pairs.extend(vertices.iter().map(|&v| (v, facet as u32)));
    }
    pairs.sort_unstable();
    pairs.chunk_by(|p, q| p.0 == q.0).map(|chunk| (chunk[0].0, chunk.iter().map(|pair| pair.1).collect())).collect()
}
