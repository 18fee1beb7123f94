//! The search for the patches of contact: which facets touch together, and along which direction their lines run.
//!
//! A first, coarser pass with the standard line families finds the facets at the ends of spans. Facets that face one
//! another across a span belong together, and so do facets that share a vertex and look much the same way: a patch, whose
//! direction is the mean normal, or several where it wraps around. Two faces that meet at a corner are two patches; the
//! flanks of a wedge in a flat surface are one, by the surface. Patches of equal direction are one. Every other facet
//! belongs to the patch that is nearest along the surface.
//!
//! Of the patches of one overlap, those that are small, or deep beside another, are not contact but the way out sideways:
//! the ends of two blocks that overlap by a strip.

use super::directions::{Ends, directions, nearest};
use super::labels::{ALIKE, are_alike, at_vertices};
use super::partition::Patches;
use crate::Error;
use crate::geometry::Vector;
use crate::geometry::components::Components;
use crate::geometry::facet::area_vector;
use crate::overlap::fibers::layout::{FiberPair, Layout};
use crate::overlap::pair::sides::{Counterpart, FacetSide};
use crate::overlap::pair::surface_point::SurfacePoint;

/// Lines of the first pass are this much further apart: it needs no more than the mean normal.
const COARSER: f64 = 2.0;

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
    ends: Ends<D>,
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

    /// Measure of boundary at the ends of a span.
    fn link(&self, layout: &Layout<D>, length: f64, ends: &[SurfacePoint<D>; 2]) -> Link<D> {
        let mut link = Link { slots: [None; 2], ends: [(Vector::zeros(), 0.0); 2], length, facing: false };
        let mut normals = [Vector::zeros(); 2];
        for (((end, slot), share), facing) in ends.iter().zip(&mut link.slots).zip(&mut link.ends).zip(&mut normals) {
            let (normal, of_b) = match *end {
                SurfacePoint::Facet { of_b, facet, .. } => {
                    *slot = Some(self.slot(of_b, facet));
                    let side = self.pair.side(of_b);
                    let normal = area_vector(&side.corners(facet as usize)).try_normalize(0.0);
                    (normal.unwrap_or_else(Vector::zeros), of_b)
                }
                SurfacePoint::Point { normal, .. } => (normal, true),
            };
            let slope: f64 = self.families.iter().map(|f| f.direction().dot(&normal).abs()).sum();
            // Long spans cross a body from side to side; those of the contact are short.
            let measure = if slope > 0.0 && length > 0.0 { layout.volume_per_length / slope } else { 0.0 };
            *share = (if of_b { normal } else { -normal }, measure);
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
        let mut groups = self.components(&counted, ALIKE);
        let mut overlaps = self.components(&links.iter().collect::<Vec<_>>(), -2.0);
        let mut clusters: Vec<Cluster<D>> = Vec::new();
        let mut cluster_of_root = vec![u32::MAX; self.slot_count()];
        for link in &counted {
            let Some(&slot) = link.slots.iter().flatten().next() else { continue };
            let place = &mut cluster_of_root[groups.find(slot).0 as usize];
            if *place == u32::MAX {
                *place = clusters.len() as u32;
                clusters.push(Cluster::new(overlaps.find(slot).0));
            }
            clusters[*place as usize].add(link);
        }
        let mut patches = Patches::default();
        let labels_of_clusters = number(&clusters, rounded, &mut patches.directions);
        if patches.directions.len() < 2 {
            let direction = patches.directions.first().copied();
            return Patches::single(direction.unwrap_or(*self.families[0].direction()));
        }
        let mut seeds = vec![None; self.slot_count()];
        for slot in counted.iter().flat_map(|link| link.slots).flatten() {
            let cluster = cluster_of_root[groups.find(slot).0 as usize];
            let Some(labels) = labels_of_clusters.get(cluster as usize).filter(|labels| !labels.is_empty()) else {
                continue;
            };
            let axes: Vec<Vector<D>> = labels.iter().map(|&label| patches.directions[label as usize]).collect();
            seeds[slot as usize] = Some(labels[nearest(&axes, &self.normal(slot))]);
        }
        for (of_b, (side, first)) in self.sides().into_iter().enumerate() {
            patches.label(of_b == 1, side, &seeds[first as usize..first as usize + side.facets.len()]);
        }
        patches
    }

    /// Unit normal of a facet, or zero.
    fn normal(&self, slot: u32) -> Vector<D> {
        let sides = self.sides();
        let (side, first) = sides[usize::from(slot >= self.pair.a.facets.len() as u32)];
        area_vector(&side.corners((slot - first) as usize)).try_normalize(0.0).unwrap_or_else(Vector::zeros)
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
                    let Some(normal) =
                        link.ends.iter().zip(link.slots).find(|(_, slot)| slot.is_none()).map(|(e, _)| e.0)
                    else {
                        continue;
                    };
                    match of_shape.iter().find(|(n, _): &&(Vector<D>, u32)| n.dot(&normal) > alike) {
                        Some(&(_, q)) => drop(sets.join(p, q, false)),
                        None => of_shape.push((normal, p)),
                    }
                }
                [None, None] => {}
            }
        }
        for (side, first) in self.sides() {
            for (_, facets) in at_vertices(side, |facet| seen[(first + facet) as usize]) {
                for (n, &p) in facets.iter().enumerate() {
                    for &q in &facets[n + 1..] {
                        if are_alike(side, p, q, alike) {
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
        if let Counterpart::Facets(b) = &self.pair.counterpart {
            sides.push((b, self.pair.a.facets.len() as u32));
        }
        sides
    }

    fn slot_count(&self) -> usize {
        self.sides().iter().map(|(side, _)| side.facets.len()).sum()
    }
}

/// The spans of a patch.
struct Cluster<const D: usize> {
    /// Root of the overlap to which it belongs.
    overlap: u32,
    spans: Vec<Ends<D>>,
    measure: f64,
    /// Σ measure L.
    depths: f64,
}

impl<const D: usize> Cluster<D> {
    fn new(overlap: u32) -> Self {
        Self { overlap, spans: Vec::new(), measure: 0.0, depths: 0.0 }
    }

    fn add(&mut self, link: &Link<D>) {
        self.spans.push(link.ends);
        for (_, measure) in link.ends {
            self.measure += measure;
            self.depths += measure * link.length;
        }
    }

    /// Mean length of its spans.
    fn depth(&self) -> f64 {
        self.depths / self.measure
    }
}

/// The directions of all clusters, each once, and for every cluster the numbers of its own; none if it is no contact.
fn number<const D: usize>(clusters: &[Cluster<D>], rounded: bool, all: &mut Vec<Vector<D>>) -> Vec<Vec<u32>> {
    let mut labels = Vec::new();
    for cluster in clusters {
        let within = || clusters.iter().filter(|other| other.overlap == cluster.overlap);
        let largest = within().map(|other| other.measure).fold(0.0, f64::max);
        let is_large = |other: &&Cluster<D>| other.measure >= SMALL * largest;
        let shallowest = within().filter(is_large).map(Cluster::depth).fold(f64::INFINITY, f64::min);
        if !is_large(&cluster) || cluster.depth() > DEEP * shallowest {
            labels.push(Vec::new());
            continue;
        }
        let own = directions(&cluster.spans, rounded).into_iter().map(|direction| {
            let known = all.iter().position(|d| *d == direction);
            known.unwrap_or_else(|| {
                all.push(direction);
                all.len() - 1
            }) as u32
        });
        labels.push(own.collect());
    }
    labels
}
