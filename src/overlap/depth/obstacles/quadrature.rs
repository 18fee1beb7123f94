//! The depth of a body below the surface of an obstacle of any shape, by quadrature.

use super::adaptive::{Adaptive, Quantity, Root};
use super::convex_volume::DepthSum;
use super::facet_moments::FacetMoments;
use crate::Error;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::simplex_rule::InSimplex;
use crate::overlap::depth::facet_sums::FacetSums;
use crate::overlap::depth::integral::DepthRequest;
use crate::overlap::pair::body_facet::BodyFacet;
use crate::overlap::pair::obstacle_distance::{Distance, ObstacleDistance};
use crate::overlap::pair::second_derivative::SecondDerivative;
use crate::overlap::pair::sides::Pair;

/// What the division of a piece may tell without being followed, in parts of the sum over all, for pieces of one, two and
/// three dimensions. There are some ten, some hundred and some thousand such pieces, whose errors have both signs; they
/// are divided once more all the same. In a volume more digits cost more than they are worth: the forces, which are
/// integrals over facets, are no differences of the energy.
const TOLERANCES: [f64; 3] = [1e-10, 1e-8, 3e-7];

impl<const D: usize> Quantity for FacetMoments<D> {
    fn difference(&self, other: &Self) -> f64 {
        self.depths().iter().zip(other.depths()).map(|(p, q)| (p - q).abs()).sum()
    }

    fn size(&self) -> f64 {
        self.depth().abs()
    }
}

impl Quantity for DepthSum {
    fn difference(&self, other: &Self) -> f64 {
        (self.depth - other.depth).abs()
    }

    fn size(&self) -> f64 {
        self.depth.abs()
    }
}

/// Sums over the facets that reach into `within`, a box around what of the obstacle the body can meet.
pub(crate) fn over_facets<const D: usize>(
    pair: &Pair<D>,
    distance: &ObstacleDistance<D>,
    within: &Aabb<D>,
    request: &DepthRequest,
) -> Result<FacetSums<D>, Error> {
    let facets = pair.a.facets_in(within);
    let facets: Vec<BodyFacet<D>> =
        facets.into_iter().filter_map(|facet| BodyFacet::new(pair.surface, &pair.a, facet)).collect();
    let roots: Vec<Root<D>> = facets
        .iter()
        .map(|facet| {
            let mut corners = [Vector::zeros(); 4];
            corners.iter_mut().zip(&facet.corners).for_each(|(corner, x)| *corner = *x);
            Root { corners, measure: facet.measure }
        })
        .collect();
    let integrand = |root: u32, w: &InSimplex, part: f64, at: &Distance<D>, sum: &mut FacetMoments<D>| {
        let gradient = -at.gradient;
        let slopes = (request.second != SecondDerivative::No).then_some(&gradient);
        sum.piece_count = 1;
        let on_facet = (&facets[root as usize], pair.weighting);
        sum.add_point(on_facet, &std::array::from_fn(|c| w[c]), part, -at.phi, slopes);
    };
    let found =
        Adaptive { pair, distance, dimension: D - 1, tolerance: TOLERANCES[D - 2], integrand }.integrals(&roots)?;
    let mut sums = FacetSums::default();
    for (facet, moments) in facets.iter().zip(&found) {
        sums.add(facet, moments, request, pair.weighting);
    }
    Ok(sums)
}

/// Sums over the overlap: over the simplices between the facets and a point, each counted with its sign.
pub(crate) fn over_volume<const D: usize>(
    pair: &Pair<D>,
    distance: &ObstacleDistance<D>,
    within: &Aabb<D>,
) -> Result<DepthSum, Error> {
    let apex = pair.a.aabb.center();
    let (mut roots, mut signs) = (Vec::new(), Vec::new());
    for facet in pair.surface_facets(false) {
        let facet = facet as usize;
        let base = pair.a.corners(facet);
        let mut aabb = Aabb::of(&base);
        aabb.include(&apex);
        let measure = area_vector(&base).dot(&(base[0] - apex)) / D as f64;
        // All of those that meet the obstacle somewhere, or none: outside the body they cancel.
        if measure == 0.0 || !aabb.meets(within) {
            continue;
        }
        let mut corners = [apex; 4];
        corners.iter_mut().zip(&base).for_each(|(corner, x)| *corner = *x);
        roots.push(Root { corners, measure: measure.abs() });
        signs.push(measure);
    }
    let integrand = |root: u32, w: &InSimplex, part: f64, at: &Distance<D>, sum: &mut DepthSum| {
        let corners = &roots[root as usize].corners;
        let x = (0..=D).fold(Vector::zeros(), |x, c| x + corners[c] * w[c]);
        let weighted = part * pair.weighting.at(&x);
        *sum += DepthSum { volume: weighted, depth: weighted * -at.phi, bare_depth: part * -at.phi, bare_volume: part };
    };
    let found = Adaptive { pair, distance, dimension: D, tolerance: TOLERANCES[D - 1], integrand }.integrals(&roots)?;
    Ok(found.iter().zip(&signs).fold(DepthSum::default(), |mut sums, (found, measure)| {
        sums += found.times(*measure);
        sums
    }))
}
