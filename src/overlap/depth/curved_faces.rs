//! Whether straight facets stand for a round surface well enough.

use super::integral::FacetDepth;
use crate::depth_field::Curves;
use crate::overlap::pair::partner::Partner;
use crate::overlap::pair::sides::Pair;
use crate::overlap::pair::warning::{Smoothing, Warning};

/// A warning where the facets in contact lie farther beside the surfaces that they stand for than the penetration, both as means over the
/// area of contact: where such faces conform, their facets touch by waves, with pressures that are wrong by factors. A surface that
/// multipliers move out has the penetration that would give its pressure. Facets whose surface is `known` count as that, but for those along a
/// rim.
pub(crate) fn curved_faces<const D: usize>(
    pair: &Pair<D>,
    facets: &[FacetDepth<D>],
    known: Option<&Curves<D>>,
) -> Option<Warning> {
    let sags = pair.depth?.sags();
    let mut of_side = [[0.0; 2]; 2];
    let (mut depth, mut area, mut is_rim) = (0.0, 0.0, false);
    for found in facets {
        let Partner::Body(body) = pair.partners[usize::from(found.of_b && !pair.is_own())] else { continue };
        let inside: f64 = found.areas.iter().sum();
        let [sum, of_area] = &mut of_side[usize::from(found.of_b)];
        let facet = pair.surface.ranges[body].start + found.facet as usize;
        let is_at_rim = inside > 0.0 && known.is_some_and(|curves| curves.is_at_rim(facet));
        if is_at_rim || known.is_none_or(|curves| curves.facet(facet).is_flat()) {
            *sum += inside * sags[facet];
        }
        is_rim |= is_at_rim;
        *of_area += inside;
        area += inside;
        depth += found.depths.iter().sum::<f64>();
    }
    let sag: f64 = of_side.iter().filter(|[_, area]| *area > 0.0).map(|[sum, area]| sum / area).sum();
    let [a, b] = pair.partners;
    let remedy = match (a, b) {
        (Partner::Body(_), Partner::Body(_)) if !pair.is_own() => {
            if is_rim {
                Smoothing::AtRims
            } else if pair.depth?.is_smoothed() {
                Smoothing::AngleTooSmall
            } else {
                Smoothing::NotSet
            }
        }
        _ => Smoothing::NotForSuchPairs,
    };
    (sag * area > depth).then(|| Warning::CurvedFaces { a, b, sag, penetration: depth / area, remedy })
}
