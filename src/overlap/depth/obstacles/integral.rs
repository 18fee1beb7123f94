//! The depth of a body below the surface of a rigid obstacle, summed over their overlap.
//!
//! ```text
//! J = ∫_A g dx,   g = max(0, −φ)        δJ(v) = ∫_∂A g v·n dA
//! ```
//!
//! for a body A that moves past an obstacle at rest, φ being its signed distance. What the obstacle feels is the opposite:
//! nothing changes if both move as one.
//!
//! With a weight ρ that is linear in space J changes also as both move, by ∫ g ∇ρ·v dx.

use super::convex_facets::facet_moments;
use super::convex_solid::ConvexSolid;
use super::convex_volume::DepthSum;
use super::quadrature::{over_facets, over_volume};
use super::rounded::Rounded;
use crate::Error;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::convex_piece::Piece;
use crate::geometry::shapes::ImplicitShape;
use crate::geometry::{Pose, Vector, moment};
use crate::overlap::depth::curved_faces::curved_faces;
use crate::overlap::depth::facet_sums::FacetSums;
use crate::overlap::depth::integral::{DepthIntegral, DepthRequest};
use crate::overlap::pair::body_facet::BodyFacet;
use crate::overlap::pair::distance_slopes::slopes_at_surface;
use crate::overlap::pair::obstacle_distance::ObstacleDistance;
use crate::overlap::pair::obstacle_region;
use crate::overlap::pair::overlap::{MotionGradient, Overlap};
use crate::overlap::pair::sides::{Counterpart, ImplicitSide, Offset, Pair};
use crate::overlap::pair::warning::Warning;
use crate::overlap::sums::block_sum::symmetric_part;

/// An obstacle with this part of the box around it inside a body is there by more than rounding, and facets with this part of the volume as
/// the integral of their depth are not.
const SWALLOWED: f64 = 1e-6;

/// Slopes of a signed distance that are told: one anywhere at its surface, as smooth edges of a shape have them nowhere; and the largest
/// of all, where the whole function is scaled.
const GENTLE: f64 = 0.5;
const ALL_GENTLE: f64 = 0.99;

/// Facets that a thread takes at once.
const CHUNK: usize = 64;

/// An obstacle by the planes of its faces.
enum OfFaces<'a, const D: usize> {
    /// The points below all of them.
    Sharp(ConvexSolid<'a, D>),
    /// With what is near to these.
    Round(Rounded<'a, D>),
}

impl<'a, const D: usize> OfFaces<'a, D> {
    /// That of the obstacle of a pair; `None` where it has no faces, or is not convex where the body is.
    fn of(pair: &'a Pair<'a, D>, pose: &Pose<D>) -> Option<Self> {
        let body = &pair.a.aabb;
        let convex = |side| ConvexSolid::within(side, pose.scale).or_else(|| ConvexSolid::near(side, body));
        match &pair.counterpart {
            Counterpart::Implicit(ImplicitSide { offset: Some(Offset { of, by }), .. })
                if ConvexSolid::is_cheap(of, body) =>
            {
                if *by < 0.0 {
                    return convex(of).map(|solid| Self::Sharp(solid.moved_in(-by)));
                }
                Rounded::new(of, pose.scale, *by).map(Self::Round)
            }
            Counterpart::Implicit(side) => side.plane().map(|plane| Self::Sharp(ConvexSolid::below(&plane))),
            Counterpart::Facets(side) if ConvexSolid::is_cheap(side, body) => convex(side).map(Self::Sharp),
            Counterpart::Facets(_) | Counterpart::Itself => None,
        }
    }
}

/// J of a body and an obstacle, or `None` where they are apart.
pub(crate) fn of_obstacle<const D: usize>(
    pair: &Pair<D>,
    pose: &Pose<D>,
    request: &DepthRequest,
) -> Result<Option<DepthIntegral<D>>, Error> {
    let outer = OfFaces::of(pair, pose);
    let within = match (&pair.counterpart, &outer) {
        (Counterpart::Implicit(ImplicitSide { offset: Some(offset), .. }), Some(_)) => {
            let around = offset.of.aabb.inflated(offset.by.max(0.0));
            Some(pair.a.aabb.intersection(&around)).filter(|aabb| !aabb.is_empty())
        }
        (Counterpart::Implicit(side), _) => obstacle_region::region(side, &pair.a.aabb)?,
        (Counterpart::Facets(side), _) => Some(pair.a.aabb.intersection(&side.aabb)).filter(|aabb| !aabb.is_empty()),
        (Counterpart::Itself, _) => None,
    };
    let Some(within) = within else { return Ok(None) };
    let facets = || pair.a.facets_in(&within);
    let is_exact = outer.is_some();
    let (sums, whole) = match outer {
        Some(OfFaces::Sharp(solid)) => (in_convex_solid(pair, &solid, &facets(), request), solid.sums(pair)),
        Some(OfFaces::Round(solid)) => (solid.over_facets(pair, &facets(), request), solid.sums(pair)),
        None => {
            let distance = ObstacleDistance::new(&pair.counterpart, pose);
            let sums = over_facets(pair, &distance, &within, request)?;
            (sums, over_volume(pair, &distance, &within)?)
        }
    };
    let Some(mut overlap) = sums.overlap(pair, whole.volume, sums.area) else { return Ok(None) };
    overlap.warnings = warnings(pair, &sums, whole.volume, (&within, is_exact))?;
    Ok(Some(assembled(pair, sums, &whole, overlap)))
}

/// What cannot be measured, or is measured too small.
fn warnings<const D: usize>(
    pair: &Pair<D>,
    sums: &FacetSums<D>,
    volume: f64,
    (within, is_exact): (&Aabb<D>, bool),
) -> Result<Vec<Warning>, Error> {
    let ([body, obstacle], mut warnings) = (pair.partners, Vec::new());
    // Without facets inside the obstacle, by more than rounding, there is no force. What touches has a volume too, by rounding.
    if sums.depth <= SWALLOWED * volume && volume > SWALLOWED * within.extent().product() {
        warnings.push(Warning::SwallowedBody { inner: obstacle, outer: body });
    }
    warnings.extend(curved_faces(pair, &sums.facets, None));
    if let Counterpart::Implicit(side) = &pair.counterpart
        && !is_exact
        && let ImplicitShape::Function(function) = side.shape
        && let Some(slopes) = slopes_at_surface(function.as_ref(), side, &pair.a.aabb)?
        && (slopes[0] < GENTLE || slopes[1] < ALL_GENTLE)
    {
        warnings.push(Warning::GentleDistance { obstacle, slopes });
    }
    Ok(warnings)
}

fn in_convex_solid<const D: usize>(
    pair: &Pair<D>,
    solid: &ConvexSolid<D>,
    facets: &[u32],
    request: &DepthRequest,
) -> FacetSums<D> {
    let rounding = pair.a.aabb.rounding();
    let parts = pair.in_chunks(facets, CHUNK, |facets| {
        let (mut sums, mut work) = (FacetSums::default(), Piece::default());
        for &facet in facets {
            if let Some(facet) = BodyFacet::new(pair.surface, &pair.a, facet) {
                let weighting = pair.weighting;
                let moments = facet_moments(solid, (&facet, weighting), (0.0, rounding), request.second, &mut work);
                sums.add(&facet, &moments, request, weighting);
            }
        }
        sums
    });
    FacetSums::of_parts(parts)
}

fn assembled<const D: usize>(
    pair: &Pair<D>,
    sums: FacetSums<D>,
    &DepthSum { depth, bare_depth, .. }: &DepthSum,
    overlap: Overlap<D>,
) -> DepthIntegral<D> {
    let (nodes, of_b, gradient) = sums.gradient.into_nodes();
    let mut reaction = MotionGradient { position: Vector::zeros(), rotation: [0.0; 3] };
    for (&node, g) in nodes.iter().zip(&gradient) {
        let x = Vector::from(pair.coords[node as usize]);
        reaction.position -= g;
        reaction.rotation.iter_mut().zip(moment(&x, g)).for_each(|(sum, m)| *sum -= m);
    }
    if !pair.weighting.is_plain() {
        // The weight is that of the place, which both have left.
        reaction.position += pair.weighting.gradient() * bare_depth;
        // Bodies of revolution do not turn.
        reaction.rotation = [0.0; 3];
    }
    DepthIntegral {
        // Where the two only touch, parts of both signs may leave a rounding error below zero; as with the volume.
        value: depth.max(0.0),
        nodes,
        of_b,
        gradient,
        pose_gradient: Some(reaction),
        hessian: symmetric_part(sums.hessian.into_blocks()),
        facets: sums.facets,
        points: sums.points,
        mean_depth: if sums.area > 0.0 { sums.depth / sums.area } else { 0.0 },
        overlap,
    }
}
