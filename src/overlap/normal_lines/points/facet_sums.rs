//! Sums over the contact points of every facet.
//!
//! All points on a facet pull along its normal, so that two numbers for each corner say all: thousands of points become
//! hundreds of facets before any node is looked up.

use super::contact_point::ContactPoint;
use crate::geometry::Vector;
use crate::geometry::primitives::facet::area_vector;
use crate::overlap::pair::sides::Pair;
use crate::overlap::pair::surface_point::SurfacePoint;
use rustc_hash::FxHashMap;

/// Points that a thread takes at once.
const CHUNK: usize = 1 << 12;

/// What the points on one facet add up to.
#[derive(Clone, Copy)]
pub(super) struct FacetSum<const D: usize> {
    pub(super) of_b: bool,
    pub(super) facet: u32,
    normal: Vector<D>,
    /// Σ ω N_a / |d·n|, and the same times ψ'.
    pub(super) volume: [f64; D],
    pub(super) energy: [f64; D],
    /// Ends of points.
    pub(super) count: usize,
}

/// The sums of all facets that have points, each once, in the order of sides and facets. `slope` is ψ'(L).
pub(super) fn facet_sums<const D: usize>(
    pair: &Pair<D>,
    directions: &[Vector<D>],
    points: &[ContactPoint<D>],
    slope: &(dyn Fn(f64) -> f64 + Sync),
) -> Vec<FacetSum<D>> {
    let chunks = pair.on_threads(points, CHUNK, |points| of_chunk(pair, directions, points, slope));
    let mut all: Vec<FacetSum<D>> = chunks.into_iter().flatten().collect();
    // Stable: what several chunks have of a facet is added in their order.
    all.sort_by_key(|sum| (sum.of_b, sum.facet));
    all.dedup_by(|next, sum| {
        let same = (next.of_b, next.facet) == (sum.of_b, sum.facet);
        if same {
            for a in 0..D {
                sum.volume[a] += next.volume[a];
                sum.energy[a] += next.energy[a];
            }
            sum.count += next.count;
        }
        same
    });
    all
}

fn of_chunk<const D: usize>(
    pair: &Pair<D>,
    directions: &[Vector<D>],
    points: &[ContactPoint<D>],
    slope: &(dyn Fn(f64) -> f64 + Sync),
) -> Vec<FacetSum<D>> {
    let mut sums: Vec<FacetSum<D>> = Vec::new();
    let mut places: FxHashMap<(bool, u32), usize> = FxHashMap::default();
    // Neighbours often have an end on the same facet.
    let mut last = [usize::MAX; 2];
    for point in points {
        let d = &directions[point.direction as usize];
        let slope = slope(point.length);
        for (end, last) in point.ends.iter().zip(&mut last) {
            let SurfacePoint::Facet { of_b, facet, weights } = *end else { continue };
            if sums.get(*last).is_none_or(|sum| (sum.of_b, sum.facet) != (of_b, facet)) {
                *last = *places.entry((of_b, facet)).or_insert_with(|| {
                    let area = area_vector(&pair.side(of_b).corners(facet as usize));
                    let normal = area.try_normalize(0.0).unwrap_or_else(Vector::zeros);
                    sums.push(FacetSum { of_b, facet, normal, volume: [0.0; D], energy: [0.0; D], count: 0 });
                    sums.len() - 1
                });
            }
            let sum = &mut sums[*last];
            let along = d.dot(&sum.normal).abs();
            // A facet without measure has no normal.
            if along > 0.0 {
                let share = point.weight / along;
                for a in 0..D {
                    sum.volume[a] += share * weights[a];
                    sum.energy[a] += share * slope * weights[a];
                }
                sum.count += 1;
            }
        }
    }
    sums
}
