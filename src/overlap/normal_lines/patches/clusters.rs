//! Facets that touch together.

use super::directions::{Ends, directions};
use super::labels::{are_alike, at_vertices};
use super::partition::LeftOut;
use super::sample::ContactSample;
use crate::geometry::Vector;
use crate::geometry::mesh::components::Components;
use crate::overlap::pair::sides::{Counterpart, Pair};
use crate::overlap::pair::surface_point::SurfacePoint;
use nalgebra::{Matrix3, Vector3};

/// A patch with less than this part of the largest one's measure lies at the edge of another: such as the side walls of
/// a block that is a little way in.
const SMALL: f64 = 0.05;

/// A patch whose samples are on average this much longer than those of another of the same overlap is no way out.
const DEEP: f64 = 3.0;

/// The facets at the ends of samples, and the ends as these have them.
pub(super) struct Touching<const D: usize> {
    /// Side and number of each facet once, ascending, and its unit normal.
    pub(super) facets: Vec<(bool, u32)>,
    pub(super) normals: Vec<Vector<D>>,
    pub(super) ends: Vec<[TouchingEnd<D>; 2]>,
}

/// One end of a sample.
#[derive(Clone, Copy)]
pub(super) struct TouchingEnd<const D: usize> {
    /// Number of its facet among those that touch.
    pub(super) facet: Option<u32>,
    /// Unit outward normal of its side.
    pub(super) outward: Vector<D>,
    /// Unit normal, outwards of the first side and into the second.
    pub(super) normal: Vector<D>,
}

impl<const D: usize> Touching<D> {
    pub(super) fn new(pair: &Pair<D>, samples: &[ContactSample<D>]) -> Self {
        let of_end = |end: &SurfacePoint<D>| match *end {
            SurfacePoint::Facet { of_b, facet, .. } => Some((of_b, facet)),
            SurfacePoint::Point { .. } => None,
        };
        let mut facets: Vec<(bool, u32)> = samples.iter().flat_map(|sample| &sample.ends).filter_map(of_end).collect();
        facets.sort_unstable();
        facets.dedup();
        let normal =
            |&(of_b, facet): &(bool, u32)| pair.normal_at(&SurfacePoint::Facet { of_b, facet, weights: [0.0; D] });
        let normals: Vec<Vector<D>> = facets.iter().map(normal).collect();
        let end = |end: &SurfacePoint<D>| {
            let facet = of_end(end).and_then(|facet| facets.binary_search(&facet).ok());
            let outward = facet.map_or_else(|| pair.normal_at(end), |facet| normals[facet]);
            let of_b = of_end(end).is_none_or(|(of_b, _)| of_b);
            TouchingEnd { facet: facet.map(|f| f as u32), outward, normal: if of_b { -outward } else { outward } }
        };
        let ends = samples.iter().map(|sample| sample.ends.each_ref().map(end)).collect();
        Self { facets, normals, ends }
    }

    /// Facets that are joined by some of the samples, or by a vertex if the cosine between their normals exceeds
    /// `alike`.
    pub(super) fn components(&self, pair: &Pair<D>, samples: &[usize], alike: f64) -> Components {
        let mut sets = Components::new(self.facets.len());
        let mut is_met = vec![false; self.facets.len()];
        let mut of_shape: Vec<(Vector<D>, u32)> = Vec::new();
        for [p, q] in samples.iter().map(|&sample| &self.ends[sample]) {
            for facet in [p.facet, q.facet].into_iter().flatten() {
                is_met[facet as usize] = true;
            }
            match (p.facet, q.facet) {
                (Some(p), Some(q)) => drop(sets.join(p, q, false)),
                (Some(facet), None) | (None, Some(facet)) => {
                    let normal = if p.facet.is_none() { p.normal } else { q.normal };
                    match of_shape.iter().find(|(n, _): &&(Vector<D>, u32)| n.dot(&normal) > alike) {
                        Some(&(_, other)) => drop(sets.join(facet, other, false)),
                        None => of_shape.push((normal, facet)),
                    }
                }
                (None, None) => {}
            }
        }
        let of_second = self.facets.partition_point(|(of_b, _)| !of_b);
        for (of_b, range) in [(false, 0..of_second), (true, of_second..self.facets.len())] {
            if of_b && !matches!(pair.counterpart, Counterpart::Facets(_)) {
                continue;
            }
            let side = pair.side(of_b);
            let met = range.filter(|&f| is_met[f]).map(|f| (self.facets[f].1, f as u32));
            for (_, facets) in at_vertices(side, met) {
                for (n, &p) in facets.iter().enumerate() {
                    for &q in &facets[n + 1..] {
                        if are_alike(&self.normals[p as usize], &self.normals[q as usize], alike) {
                            sets.join(p, q, false);
                        }
                    }
                }
            }
        }
        sets
    }
}

/// The samples of a patch.
pub(super) struct Cluster<const D: usize> {
    /// Root of the overlap to which it belongs.
    overlap: u32,
    ends: Vec<Ends<D>>,
    /// Number of the sample of each of these.
    samples: Vec<usize>,
    measure: f64,
    /// Σ measure L.
    depths: f64,
}

impl<const D: usize> Cluster<D> {
    pub(super) fn new(overlap: u32) -> Self {
        Self { overlap, ends: Vec::new(), samples: Vec::new(), measure: 0.0, depths: 0.0 }
    }

    /// Adds a sample, which has this number.
    pub(super) fn add(&mut self, ends: Ends<D>, sample: usize, length: f64) {
        self.ends.push(ends);
        self.samples.push(sample);
        for (_, measure) in ends {
            self.measure += measure;
            self.depths += measure * length;
        }
    }

    /// Mean length of its samples.
    fn depth(&self) -> f64 {
        self.depths / self.measure
    }

    /// Least extent across `normal`, that of a rectangle with the same moments.
    fn extent(&self, normal: &Vector<D>, pair: &Pair<D>, samples: &[ContactSample<D>]) -> f64 {
        let padded = |x: Vector<D>| Vector3::from_fn(|i, _| if i < D { x[i] } else { 0.0 });
        let n = padded(*normal);
        // Moments about a place in the patch.
        let origin = pair.position(&samples[self.samples[0]].ends[0]);
        let (mut first, mut second) = (Vector3::zeros(), Matrix3::zeros());
        for sample in self.samples.iter().map(|&sample| &samples[sample]) {
            for (end, measure) in sample.ends.iter().zip(sample.measures) {
                let x = padded(pair.position(end) - origin);
                first += x * measure;
                second += x * x.transpose() * measure;
            }
        }
        let mean = first / self.measure;
        let spread = second / self.measure - mean * mean.transpose();
        let across = Matrix3::identity() - n * n.transpose();
        let mut variances = (across * spread * across).symmetric_eigenvalues();
        variances.as_mut_slice().sort_unstable_by(f64::total_cmp);
        // In 2D a second one belongs to no axis of the plane.
        let least = if D == 2 { variances[2] } else { variances[1] };
        (12.0 * least.max(0.0)).sqrt()
    }

    /// What is left out with it: nothing worth a word where it is deeper than wide, as the way out sideways is.
    pub(super) fn left_out(&self, pair: &Pair<D>, samples: &[ContactSample<D>]) -> Option<LeftOut<D>> {
        let [area, depth] = [0.5 * self.measure, self.depth()];
        let resultant: Vector<D> = self.ends.iter().flatten().map(|(normal, measure)| normal * *measure).sum();
        let normal = resultant.try_normalize(0.0)?;
        (self.extent(&normal, pair, samples) > depth).then_some(LeftOut { normal, area, depth })
    }
}

/// The directions of all clusters, each once, and for every cluster the numbers of its own; none if it is no contact.
pub(super) fn number<const D: usize>(
    clusters: &[Cluster<D>],
    is_own: bool,
    rounded: bool,
    all: &mut Vec<Vector<D>>,
) -> Vec<Vec<u32>> {
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
        let own = directions(&cluster.ends, is_own, rounded).into_iter().map(|direction| {
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
