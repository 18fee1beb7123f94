//! The depth of two bodies below each other's surfaces, summed over their overlap by lines.

use super::curvature::add_curvature;
use super::facet_touches::{FacetTouches, OfFamily};
use super::line_sums::Pieces;
use super::moments::Moments;
use crate::Error;
use crate::geometry::Vector;
use crate::overlap::depth::DeepBodies;
use crate::overlap::depth::cell_integrals::CellMoments;
use crate::overlap::depth::cell_pieces::CellPieces;
use crate::overlap::depth_integral::{DepthIntegral, DepthProfile, DepthRequest, SecondDerivative};
use crate::overlap::fibers::bundle::Bundle;
use crate::overlap::fibers::layout::{FiberPair, Layout};
use crate::overlap::pair::partner::Partner;
use crate::overlap::pair::region::Region;

/// Facets that a thread takes at once.
const CHUNK: usize = 64;

/// J of a pair, or `None` where the sides are apart.
///
/// # Errors
/// Those of [`DeepBodies::integral`] and of the layout of lines.
pub(crate) fn depth_integral<const D: usize>(
    fibers: &FiberPair<D>,
    request: &DepthRequest,
) -> Result<Option<DepthIntegral<D>>, Error> {
    DeepBodies::integral(fibers.pair, request, |bodies| {
        let found = fibers.with_layout(1.0, |layout| {
            let Some(region) = fibers.pair.region()? else { return Ok(None) };
            measured(fibers, bodies, layout, region)
        })?;
        Ok(found.flatten())
    })
}

fn measured<const D: usize>(
    fibers: &FiberPair<D>,
    bodies: &DeepBodies<D>,
    layout: &Layout<D>,
    region: &Region<D>,
) -> Result<Option<DepthIntegral<D>>, Error> {
    let pair = bodies.pair;
    let of: Vec<CellPieces<D>> = if pair.is_own() {
        vec![bodies.pieces(0, region, None)]
    } else {
        let (of_a, of_b) = pair.both(|| bodies.pieces(0, region, None), || bodies.pieces(1, region, None));
        vec![of_a, of_b]
    };
    let body = if let Partner::Body(body) = pair.partners[0] { body } else { 0 };
    let own_cell = pair.is_own().then(|| &pair.surface.facet_cell[pair.surface.ranges[body].clone()]);
    let pieces = Pieces { pair, of: &of, own_cell, tolerance: layout.tolerance };
    let mut sums = fibers.for_each_bundle(layout, |bundle| Ok(pieces.sums(bundle)))?;

    let mut touches: Vec<OfFamily<D>> = Vec::new();
    for (bundle, sum) in layout.bundles.iter().zip(&mut sums) {
        let family = bundle.family_index();
        touches.extend(std::mem::take(&mut sum.touches).into_iter().map(|touch| (touch, family)));
    }
    // Stable: the crossings of a facet in a piece come in the order of their lines.
    touches.sort_by_key(|(touch, _)| (touch.of_b, touch.facet, touch.piece));
    let by_facet: Vec<&[OfFamily<D>]> =
        touches.chunk_by(|p, q| (p.0.of_b, p.0.facet) == (q.0.of_b, q.0.facet)).collect();
    let (facets_a, facets_b) = by_facet.split_at(by_facet.partition_point(|facet| !facet[0].0.of_b));
    let measure =
        |normal: &Vector<D>, family: usize| fibers.weight(layout, fibers.families[family].direction(), normal);
    let mut facets = Vec::new();
    for (side, of_side) in [facets_a, facets_b].into_iter().enumerate().take(of.len()) {
        let other = &of[if of.len() == 1 { 0 } else { 1 - side }];
        let here = FacetTouches { bodies, other, measure: &measure, tolerance: layout.tolerance };
        facets.push(crate::overlap::depth::facet_sums::FacetSums::of_parts(
            pair.in_chunks(of_side, CHUNK, |facets| here.sums(facets)),
        ));
    }
    let per_length = layout.volume_per_length / fibers.families.len() as f64;
    let moments: Vec<CellMoments> = (0..of.len())
        .map(|side| {
            let (weighting, profile) = (pair.weighting, bodies.request.profile);
            Moments { of_b: side == 1, per_length, weighting, profile }.of(&of[side], &sums)
        })
        .collect();
    let profile = bodies.request.profile;
    if profile != DepthProfile::Quadratic
        && bodies.request.second == SecondDerivative::Full
        && let Some(sums_of_facets) = facets.first_mut()
    {
        let how = (profile, per_length);
        add_curvature(bodies.cells, &of, &sums, how, &mut sums_of_facets.hessian);
    }
    let cells: Vec<(&CellPieces<D>, &CellMoments)> = of.iter().zip(&moments).collect();
    let Some(mut integral) = bodies.assemble(facets, &cells) else { return Ok(None) };
    let overlap = &mut integral.overlap;
    let of_bundles = layout.bundles.iter().zip(&sums).map(|(bundle, sum)| (bundle.family_index(), sum.length));
    overlap.standard_error = fibers.spread(layout, of_bundles).1;
    overlap.fiber_count = layout.bundles.iter().map(Bundle::fiber_count).sum();
    overlap.spacing = layout.spacing;
    let lines_met = sums.iter().map(|sum| sum.lines_met).sum();
    overlap.warnings.extend(fibers.of_resolution(layout, lines_met, overlap.volume));
    Ok(Some(integral))
}
