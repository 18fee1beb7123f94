//! Samples of contact from clipped facets, for the search for patches.
//!
//! Every facet that has a part inside the other side stands for that part, and touches the facet of the other side that
//! is nearest to the part's middle: that is the shortest way out. Of a body with itself, where the nearest facet is the
//! facet itself, it touches what the way along its normal, through its own body, meets first. The normals of all
//! samples, with their measures, add up to the gradient of the overlap volume.

use super::volume::{ExactPair, Found};
use crate::Error;
use crate::configuration::FacetSide;
use crate::geometry::Vector;
use crate::geometry::facet::area_vector;
use crate::overlap::pair::sides::Counterpart;
use crate::overlap::pair::surface_point::SurfacePoint;
use crate::overlap::patches::sample::ContactSample;
use rayon::prelude::*;

/// What is hit first on a way through the overlap.
struct Hit<const D: usize> {
    t: f64,
    end: SurfacePoint<D>,
}

impl<const D: usize> ExactPair<'_, D> {
    /// One sample for every facet that is inside the other side as a whole or in part.
    pub(crate) fn samples(&self) -> Result<Vec<ContactSample<D>>, Error> {
        let Some(Found { sides, plane, .. }) = self.clipped()? else { return Ok(Vec::new()) };
        let sampled = |(of_b, facet, shares): (bool, u32, [f64; D])| {
            let side = self.pair.side(of_b);
            let corners = side.corners(facet as usize);
            let normal = area_vector(&corners).try_normalize(0.0)?;
            let measure: f64 = shares.iter().sum();
            let weights = shares.map(|share| share / measure);
            let from = (0..D).fold(Vector::zeros(), |sum, a| sum + corners[a] * weights[a]);
            let Hit { t, end } = match (&self.pair.counterpart, &plane) {
                (Counterpart::Facets(_), _) => {
                    let (facet, weights, t) = self.pair.side(!of_b).nearest(&from)?;
                    Hit { t, end: SurfacePoint::Facet { of_b: !of_b, facet, weights } }
                }
                (_, Some((normal, point))) => {
                    let t = normal.dot(&(point - from)).max(0.0);
                    Hit { t, end: SurfacePoint::Point { point: from + normal * t, normal: *normal } }
                }
                _ => hit(side, &from, &-normal)?,
            };
            let this = SurfacePoint::Facet { of_b, facet, weights };
            Some(ContactSample { ends: [this, end], measures: [measure, 0.0], length: t })
        };
        let work: Vec<(bool, u32, [f64; D])> = sides
            .iter()
            .flat_map(|(_, clipped, _)| clipped.iter().map(|c| (c.share.of_b, c.share.facet, c.share.shares)))
            .filter(|(_, _, shares)| shares.iter().sum::<f64>() > 0.0)
            .collect();
        Ok(if self.pair.parallel {
            work.into_par_iter().with_min_len(64).filter_map(sampled).collect()
        } else {
            work.into_iter().filter_map(sampled).collect()
        })
    }
}

/// The first facet through which a way leaves the body.
fn hit<const D: usize>(side: &FacetSide<D>, from: &Vector<D>, direction: &Vector<D>) -> Option<Hit<D>> {
    let rounding = side.aabb.rounding();
    let reach = side.aabb.extent().norm() + rounding;
    let mut first: Option<(f64, u32, [f64; D])> = None;
    let end = from + direction * reach;
    side.tree.boxes().visit(
        |aabb| aabb.meets_ray(from, direction, reach) && aabb.meets_ray(&end, &-direction, reach),
        |facet| {
            let corners = side.corners(facet as usize);
            let area = area_vector(&corners);
            let slope = area.dot(direction);
            if slope <= 1e-9 * area.norm() {
                return;
            }
            let t = area.dot(&(corners[0] - from)) / slope;
            // The edge between two facets belongs to both: the lower number is taken, whatever the order of the search.
            if t < -rounding || first.is_some_and(|(nearest, number, _)| (nearest, number) < (t, facet)) {
                return;
            }
            let place = from + direction * t;
            let weights: [f64; D] = std::array::from_fn(|a| {
                let mut part = corners;
                part[a] = place;
                area_vector(&part).dot(&area) / area.norm_squared()
            });
            if weights.iter().all(|w| *w >= -1e-9) {
                first = Some((t, facet, weights));
            }
        },
    );
    let (t, facet, weights) = first?;
    Some(Hit { t: t.max(0.0), end: SurfacePoint::Facet { of_b: false, facet, weights } })
}
