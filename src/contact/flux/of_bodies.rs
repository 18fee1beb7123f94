//! What flows between two bodies, or between parts of one.

use super::conductance::Conductance;
use super::shares::Shares;
use crate::Error;
use crate::contact::laws::{Asked, Measured};
use crate::interfaces::FacingSurfaces;
use crate::overlap::{Block, BlockSum, Pair, Partner};

/// Pairs of facets that a thread takes at once.
const CHUNK: usize = 64;

/// Facets of both sides count with half of what they have in common with the others: neither is the master.
const HALF: f64 = 0.5;

/// How much deeper than the penetration a facet may lie below another along its normal, which faces it within 60°.
const ALONG: f64 = 2.0;

/// The derivative of the flux out of the nodes by the field, of a pair of bodies. Pressure is that of the law at the penetration of the point.
///
/// # Errors
/// Those of the law.
pub(crate) fn of_bodies<const D: usize>(
    measured: &Measured<D>,
    conductance: &Conductance,
) -> Result<Vec<Block<1>>, Error> {
    let (pair, law) = (measured.pair, measured.law);
    let asked = Asked { energy: true, ..Asked::default() };
    let touches = law.measure(measured, &asked)?.and_then(|answer| answer.energy);
    let (deepest, of_pair) = touches.map_or((0.0, 0.0), |energy| {
        let mean = energy.overlap.volume / energy.overlap.contact_area.max(f64::MIN_POSITIVE);
        (energy.overlap.penetration.max(mean).max(0.0), energy.pressure)
    });
    let [a, b] = [pair.side(false), pair.side(true)];
    let rounding = a.aabb.rounding().max(b.aabb.rounding());
    let heights = heights(pair);
    // Along normals of straight facets, without the gap offset.
    let least = -ALONG * (deepest + rounding) - pair.clearance.abs() - heights;
    let most = conductance.reach().max(rounding) + heights - pair.clearance;
    let facets = [false, true].map(|of_b| facets_near(pair, of_b, least.abs().max(most)));
    let surfaces = FacingSurfaces::new(pair.surface, a.points, pair.weighting, facets, [least, most.max(rounding)]);
    let mut candidates = surfaces.candidates(false);
    if !pair.is_own() {
        candidates.extend(surfaces.candidates(true));
    }
    let height = |facet: usize, of_b: bool, at: &[f64; D]| {
        let Partner::Body(body) = pair.partners[usize::from(of_b)] else { return 0.0 };
        pair.height(of_b, (facet - pair.surface.ranges[body].start) as u32, at)
    };
    let first_of_b = match pair.partners[1] {
        Partner::Body(body) if !pair.is_own() => pair.surface.ranges[body].clone(),
        _ => 0..0,
    };
    let parts = pair.on_threads(&candidates, CHUNK, |candidates| {
        let mut shares = Shares::default();
        for &facets in candidates {
            let of_b = facets.map(|facet| first_of_b.contains(&facet));
            surfaces.for_each_point(facets, rounding - pair.clearance, |point| {
                let [own, other] = [0, 1].map(|side| height(facets[side], of_b[side], &point.places[side]));
                let gap = point.gap + pair.clearance - own - other;
                let h = match gap <= rounding {
                    true => conductance.pressed(law.pressure(-gap).unwrap_or(of_pair)),
                    false => conductance.apart(gap),
                };
                if h > 0.0 {
                    let [near, far] = [0, 1].map(|side| surfaces.shape(facets[side], &point.places[side]));
                    shares.add(HALF * h * point.measure, &near, &far);
                }
            });
            shares.end_part();
        }
        shares.into_sum()
    });
    let mut sum = BlockSum::default();
    parts.into_iter().for_each(|part| sum.add_sum(part));
    Ok(sum.into_blocks())
}

/// Facets of a side, by number in the surface, that may be within reach of the other.
fn facets_near<const D: usize>(pair: &Pair<D>, of_b: bool, reach: f64) -> Vec<usize> {
    let Partner::Body(body) = pair.partners[usize::from(of_b)] else { return Vec::new() };
    let first = pair.surface.ranges[body].start;
    let around = pair.side(!of_b).aabb.inflated(reach);
    let of_contact = pair.side(of_b).facets_in(&around).into_iter().filter(|&facet| !pair.is_tied(of_b, facet));
    of_contact.map(|facet| first + facet as usize).collect()
}

/// How far both curved surfaces together may lie outside of their straight facets, where they are measured as curved.
fn heights<const D: usize>(pair: &Pair<D>) -> f64 {
    let Some(field) = pair.depth.filter(|field| field.curves().is_some() && !pair.is_own()) else { return 0.0 };
    let largest = |partner: Partner| match partner {
        Partner::Body(body) => {
            field.sags()[pair.surface.ranges[body].clone()].iter().fold(0.0f64, |m, x| m.max(x.abs()))
        }
        Partner::Obstacle(_) => 0.0,
    };
    2.0 * pair.partners.map(largest).iter().sum::<f64>()
}
