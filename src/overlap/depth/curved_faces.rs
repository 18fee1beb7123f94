//! Whether straight facets stand for a round surface well enough.

use super::integral::FacetDepth;
use crate::depth_field::Curves;
use crate::geometry::boundary::facet_sags::Bend;
use crate::overlap::pair::partner::Partner;
use crate::overlap::pair::sides::Pair;
use crate::overlap::pair::warning::{Smoothing, Warning};

/// A warning where the facets in contact lie farther beside the surfaces that they stand for than the penetration, both as means over the
/// area of contact: where such faces conform, their facets touch by waves, with pressures that are wrong by factors. A surface that
/// multipliers move out has the penetration that would give its pressure. Facets whose surface is `known` count as that, but for those along a
/// rim, as far as what presses them does not fit them.
pub(crate) fn curved_faces<const D: usize>(
    pair: &Pair<D>,
    facets: &[FacetDepth<D>],
    known: Option<&Curves<D>>,
) -> Option<Warning> {
    let sags = pair.depth?.sags();
    let mut of_side = [[0.0; 2]; 2];
    // By bend: sums over facets along rims, and the area of all.
    let mut by_bend = [[[0.0; 2]; 3]; 2];
    let (mut depth, mut area) = (0.0, 0.0);
    for found in facets {
        let Partner::Body(body) = pair.partners[usize::from(found.of_b && !pair.is_own())] else { continue };
        let inside: f64 = found.areas.iter().sum();
        let [sum, of_area] = &mut of_side[usize::from(found.of_b)];
        let facet = pair.surface.ranges[body].start + found.facet as usize;
        if known.is_none_or(|curves| curves.facet(facet).is_flat()) {
            *sum += inside * sags[facet];
        }
        if let Some(curves) = known {
            let [at_rims, of_bend] = &mut by_bend[usize::from(found.of_b)][curves.bend(facet, body) as usize];
            *of_bend += inside;
            if curves.is_at_rim(facet) {
                *at_rims += inside * sags[facet];
            }
        }
        *of_area += inside;
        area += inside;
        depth += found.depths.iter().sum::<f64>();
    }
    let mut at_rims = 0.0;
    for side in 0..2 {
        let [_, of_other] = of_side[1 - side];
        for bend in Bend::ALL {
            let fits = |other: &Bend| other.fits(bend);
            let fitting: f64 =
                Bend::ALL.into_iter().filter(fits).map(|other| by_bend[1 - side][other as usize][1]).sum();
            let unfit = if of_other > 0.0 { 1.0 - fitting / of_other } else { 1.0 };
            of_side[side][0] += by_bend[side][bend as usize][0] * unfit;
            at_rims += by_bend[side][bend as usize][0] * unfit;
        }
    }
    let sag: f64 = of_side.iter().filter(|[_, area]| *area > 0.0).map(|[sum, area]| sum / area).sum();
    let [a, b] = pair.partners;
    let remedy = match (a, b) {
        (Partner::Body(_), Partner::Body(_)) if !pair.is_own() => {
            if at_rims > 0.0 {
                Smoothing::AtRims
            } else if pair.depth?.is_smoothed() {
                Smoothing::AngleTooSmall
            } else {
                Smoothing::NotSet
            }
        }
        _ => Smoothing::NotForSuchPairs,
    };
    // What is no deeper than rounding may be less than nothing.
    (depth > 0.0 && sag * area > depth).then(|| Warning::CurvedFaces { a, b, sag, penetration: depth / area, remedy })
}
