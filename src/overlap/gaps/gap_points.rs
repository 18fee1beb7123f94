//! Quadrature on the facets of a body over an obstacle, in contact with it or near it.

use super::near_surface::{NearSurface, Nearest};
use crate::Error;
use crate::geometry::primitives::convex_piece::{cut, place, whole};
use crate::geometry::primitives::quadrature::for_each_simplex;
use crate::geometry::primitives::simplex_rule::degree_5;
use crate::overlap::pair::body_facet::BodyFacet;
use crate::overlap::pair::sides::Pair;

/// A facet faces an obstacle where its normal is within 60° of the way to the nearest point there.
const FACING: f64 = 0.5;

/// Facets that a thread takes at once.
const CHUNK: usize = 64;

/// A point of a facet of the first side.
pub(crate) struct GapPoint<const D: usize> {
    /// Index within the side.
    pub(crate) facet: u32,
    /// Barycentric coordinates.
    pub(crate) weights: [f64; D],
    /// For how much area (2D: length) it stands.
    pub(crate) measure: f64,
    /// Signed distance from the obstacle, negative inside.
    pub(crate) gap: f64,
}

/// The points at which facets face an obstacle, inside it or no farther away than `reach`, in the order of the facets. Facets are cut where
/// the distance, linear between their corners, is zero.
///
/// # Errors
/// [`Error::SignedDistance`] where a function of the host fails.
pub(crate) fn gap_points<const D: usize>(pair: &Pair<D>, reach: f64) -> Result<Vec<GapPoint<D>>, Error> {
    let facets: Vec<u32> = pair.surface_facets(false).collect();
    let parts = pair.on_threads(&facets, CHUNK, |facets| {
        let mut found = Vec::new();
        for &number in facets {
            if let Some(facet) = BodyFacet::new(pair.surface, pair.side(false), number) {
                add_points(pair, &facet, reach, &mut found)?;
            }
        }
        Ok(found)
    });
    let parts: Vec<Vec<_>> = parts.into_iter().collect::<Result<_, Error>>()?;
    Ok(parts.into_iter().flatten().collect())
}

fn add_points<const D: usize>(
    pair: &Pair<D>,
    facet: &BodyFacet<D>,
    reach: f64,
    found: &mut Vec<GapPoint<D>>,
) -> Result<(), Error> {
    let size = facet.corners.iter().map(|x| (x - facet.corners[0]).norm()).fold(0.0, f64::max);
    // As far as any corner of a facet may be of which a part is within reach.
    let far = reach + 2.0 * size;
    let near = NearSurface::of(pair, true, far);
    let at_corners = near.nearest(&facet.corners)?;
    if at_corners.iter().all(Option::is_none) {
        return Ok(());
    }
    let gaps: [f64; D] = std::array::from_fn(|c| at_corners[c].as_ref().map_or(far, |found| found.distance.phi));
    let is_cut = gaps.iter().any(|gap| *gap > 0.0) && gaps.iter().any(|gap| *gap < 0.0);
    let parts = match is_cut {
        true => [1.0, -1.0].map(|sign| cut(&whole::<D>(), &gaps.map(|gap| sign * gap))).to_vec(),
        false => vec![whole::<D>()],
    };
    let (rule, mut points) = (degree_5(D - 1), Vec::new());
    for part in parts.iter().filter(|part| part.len() >= D) {
        for_each_simplex(part, |simplex, share| {
            for (at, weight) in &rule {
                let at: [f64; D] = std::array::from_fn(|c| (0..D).map(|k| at[k] * simplex[k][c]).sum());
                points.push((at, share * weight));
            }
        });
    }
    let places: Vec<_> = points.iter().map(|(at, _)| place(&facet.corners, at)).collect();
    for ((&(weights, share), x), nearest) in points.iter().zip(&places).zip(near.nearest(&places)?) {
        let faces = |one: &Nearest<D>| facet.normal.dot(&one.distance.gradient) <= -FACING;
        let Some(gap) = nearest.filter(faces).map(|one| one.distance.phi).filter(|gap| *gap <= reach) else { continue };
        let measure = share * facet.measure * pair.weighting.at(x);
        found.push(GapPoint { facet: facet.number, weights, measure, gap });
    }
    Ok(())
}
