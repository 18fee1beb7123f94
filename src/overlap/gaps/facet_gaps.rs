//! The gap of one facet over the surface of the other side.

use super::near_surface::NearSurface;
use crate::Error;
use crate::geometry::Vector;
use crate::geometry::primitives::convex_piece::place;
use crate::geometry::primitives::facet::area_slopes;
use crate::geometry::primitives::simplex_rule::degree_5;
use crate::overlap::pair::body_facet::BodyFacet;
use crate::overlap::pair::sides::Pair;

/// A facet faces the other side where its normal is within 60° of the way to the nearest point there. The walls beside a face
/// that is pressed do not: counted in, they would hide the gap at its rim.
const FACING: f64 = 0.5;

/// Of every corner, N being its barycentric coordinate.
pub(crate) struct FacetGap<const D: usize> {
    /// ∫ N φ dA over the part that is within reach and faces the other side.
    pub(crate) gaps: [f64; D],
    /// ∫ N dA over it.
    pub(crate) areas: [f64; D],
    /// ∫ N ∇φ dA over it, of the curved surfaces where faces are curved: away from the other side.
    pub(crate) away: [Vector<D>; D],
    /// Derivatives of the gaps with respect to nodes, each of which may come several times.
    pub(crate) gradients: [Vec<(u32, Vector<D>)>; D],
    /// Whether there is such a part.
    pub(crate) is_near: bool,
}

/// By quadrature of degree 5. Where φ is smooth over the facet its derivative is exact: the nearest point of the other
/// surface moves along that surface, which changes the distance by nothing, and the height of a curved face there by its slope.
///
/// # Errors
/// [`Error::SignedDistance`] where a function of the host fails.
pub(crate) fn facet_gap<const D: usize>(
    pair: &Pair<D>,
    (facet, of_b): (&BodyFacet<D>, bool),
    surface: &NearSurface<D>,
) -> Result<FacetGap<D>, Error> {
    let rule = degree_5(D - 1);
    let weights: Vec<[f64; D]> = rule.iter().map(|(at, _)| std::array::from_fn(|c| at[c])).collect();
    let points: Vec<Vector<D>> = weights.iter().map(|at| place(&facet.corners, at)).collect();
    let mut gap = FacetGap {
        gaps: [0.0; D],
        areas: [0.0; D],
        away: [Vector::zeros(); D],
        gradients: std::array::from_fn(|_| Vec::new()),
        is_near: false,
    };
    let weighting = pair.weighting;
    for ((((_, bare), at), x), found) in rule.iter().zip(&weights).zip(&points).zip(surface.nearest(&points)?) {
        let share = bare * weighting.at(x);
        let Some(found) = found.filter(|found| facet.normal.dot(&found.distance.gradient) <= -FACING) else { continue };
        gap.is_near = true;
        let phi = found.distance.phi + pair.clearance - found.height - pair.height(of_b, facet.number, at);
        for corner in 0..D {
            gap.areas[corner] += share * facet.measure * at[corner];
            gap.gaps[corner] += share * facet.measure * at[corner] * phi;
        }
        for corner in 0..D {
            let by = found.distance.gradient * (share * facet.measure * at[corner]);
            let of_weight = weighting.gradient() * (bare * facet.measure * at[corner] * phi);
            let of_height = found.of_height.as_ref();
            let by_height = of_height.map(|slopes| slopes.by_point * (share * facet.measure * at[corner]));
            let by_height = by_height.unwrap_or_else(Vector::zeros);
            gap.away[corner] += by - by_height;
            let gradient = &mut gap.gradients[corner];
            for (other, weights) in facet.weights.iter().enumerate() {
                let own = facet.nodes.iter().zip(weights).filter(|(_, weight)| **weight != 0.0);
                let of_facet = by + of_weight - by_height;
                gradient.extend(own.map(|(&node, weight)| (node, of_facet * (at[other] * weight))));
            }
            let feet = found.foot.iter().flat_map(|(vertices, at)| vertices.iter().zip(at));
            for (k, (vertex, weight)) in feet.enumerate() {
                let of_vertex = pair.surface.nodes_of_vertex(*vertex);
                gradient.extend(of_vertex.map(|(node, part)| (node, by * (-weight * part))));
                if let Some(slopes) = of_height {
                    let by = slopes.by_corners[k] * (-share * facet.measure * at[corner]);
                    gradient.extend(pair.surface.nodes_of_vertex(*vertex).map(|(node, part)| (node, by * part)));
                }
            }
        }
    }
    add_stretch(facet, &mut gap);
    Ok(gap)
}

/// What the change of the facet's area adds.
fn add_stretch<const D: usize>(facet: &BodyFacet<D>, gap: &mut FacetGap<D>) {
    for (slope, weights) in area_slopes(&facet.corners).iter().zip(&facet.weights) {
        let of_measure: [f64; D] = std::array::from_fn(|k| (0..D).map(|i| facet.normal[i] * slope[i][k]).sum());
        let by = Vector::from(of_measure) / facet.measure;
        for (value, gradient) in gap.gaps.iter().zip(&mut gap.gradients) {
            let own = facet.nodes.iter().zip(weights).filter(|(_, weight)| **weight != 0.0);
            gradient.extend(own.map(|(&node, weight)| (node, by * (value * weight))));
        }
    }
}
