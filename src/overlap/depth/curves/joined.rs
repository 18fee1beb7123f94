//! What is shallow, on surfaces, and what is deep, by the overlap.

use super::facet_points::{FacetPoints, PointsFound};
use super::layer::Layer;
use super::rules::Rules;
use super::shell::Shell;
use super::tent::Tent;
use crate::Error;
use crate::configuration::FacetSide;
use crate::depth_field::Curves;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::overlap::depth::bodies::{CHUNK, CellPieces, DeepBodies};
use crate::overlap::depth::curved_faces::curved_faces;
use crate::overlap::depth::facet_sums::FacetSums;
use crate::overlap::depth::integral::{DepthIntegral, DepthRequest};
use crate::overlap::pair::partner::Partner;
use crate::overlap::pair::second_derivative::SecondDerivative;
use crate::overlap::pair::sides::{Counterpart, Pair};
use crate::overlap::pair::warning::Warning;
use crate::overlap::sums::block_sum::{Block, merged};

/// How many times the largest height of a curved face the tent's top is, and the layer is thick.
const TOP: f64 = 2.0;
const LAYER: f64 = 2.0;

/// J of two bodies one of which has curved faces; `None` where it is to be measured on straight ones.
///
/// # Errors
/// Those of [`DeepBodies::new`].
pub(crate) fn of_curved_bodies<const D: usize>(
    pair: &Pair<D>,
    request: &DepthRequest,
) -> Result<Option<Option<DepthIntegral<D>>>, Error> {
    let Counterpart::Facets(b) = &pair.counterpart else { return Ok(None) };
    let [Partner::Body(first), Partner::Body(second)] = pair.partners else { return Ok(None) };
    let Some(curves) = pair.depth.and_then(|field| field.curves()) else { return Ok(None) };
    let [of_a, of_b] = [first, second].map(|body| curves.height(body));
    let height = of_a + of_b;
    if height == 0.0 {
        return Ok(None);
    }
    let top = TOP * of_a.max(of_b);
    let bodies = DeepBodies::new(pair, request)?;
    let joined = Joined { bodies, curves, bodies_of: [first, second], tent: Tent { top }, layer: LAYER * height };
    joined.integral([&pair.a, b]).map(Some)
}

struct Joined<'a, const D: usize> {
    bodies: DeepBodies<'a, D>,
    curves: &'a Curves<D>,
    /// Both bodies, by number.
    bodies_of: [usize; 2],
    tent: Tent,
    /// Thickness of the layer in which curved faces are looked for.
    layer: f64,
}

impl<const D: usize> Joined<'_, D> {
    fn integral(&self, sides: [&FacetSide<D>; 2]) -> Result<Option<DepthIntegral<D>>, Error> {
        let (pair, request) = (self.bodies.pair, self.bodies.request);
        let ([found_a, found_b], has_core_inside) = self.on_surfaces(sides);
        let is_deep = has_core_inside || found_a.deepest.max(found_b.deepest) > self.tent.top;
        let energy = found_a.energy + found_b.energy;
        let mut volume = found_a.volume + found_b.volume;
        let mut errors = found_a.errors;
        errors.add_all(&found_b.errors);
        let facets = [found_a.sums, found_b.sums];
        let inside = || facets.iter().filter(|part| part.area > 0.0);
        let area: f64 = inside().map(|part| part.area).sum();
        let depth: f64 = inside().map(|part| part.depth / part.area).sum();
        let count = inside().count() as f64;
        let mut sums = FacetSums::of_parts(facets);
        let (mut value, mut blocks, mut warnings) = (energy, Vec::new(), Vec::new());
        // Points are those on the surfaces, and so is a part that is semidefinite.
        let second = if request.second == SecondDerivative::Full { request.second } else { SecondDerivative::No };
        let of_overlap = DepthRequest { second, points: false, ..*request };
        if is_deep && let (Counterpart::Facets(b), Some(region)) = (&pair.counterpart, pair.region()?) {
            for (beyond, part) in [self.tent.top, self.tent.end()].into_iter().zip(Tent::BEYOND) {
                let clearance = self.bodies.clearance + beyond;
                let Some(deep) = (DeepBodies { clearance, request: &of_overlap, ..self.bodies }).two(b, region) else {
                    continue;
                };
                if beyond == self.tent.top {
                    volume += deep.overlap.volume;
                    sums.deepest = sums.deepest.max(deep.overlap.penetration);
                    sums.piece_count += deep.overlap.crossing_count;
                    // Those of faces are found on the surfaces.
                    let is_of_faces =
                        |w: &Warning| matches!(w, Warning::CurvedFaces { .. } | Warning::FlushFaces { .. });
                    warnings.extend(deep.overlap.warnings.into_iter().filter(|warning| !is_of_faces(warning)));
                }
                value += part * deep.value;
                for ((&node, &of_b), gradient) in deep.nodes.iter().zip(&deep.of_b).zip(&deep.gradient) {
                    sums.gradient.add(node, of_b, &(gradient * part));
                }
                blocks.push(times(deep.hessian, part));
            }
        }
        let Some(mut overlap) = sums.overlap(pair, volume, 0.5 * area) else { return Ok(None) };
        overlap.warnings = warnings;
        overlap.warnings.extend(self.bodies.flush_faces(sums.flush, area));
        overlap.warnings.extend(curved_faces(pair, &sums.facets, Some(self.curves)));
        overlap.warnings.extend(errors.warning(pair));
        let (nodes, of_b, gradient) = sums.gradient.into_nodes();
        blocks.insert(0, sums.hessian.into_blocks());
        Ok(Some(DepthIntegral {
            value: value.max(0.0),
            nodes,
            of_b,
            gradient,
            pose_gradient: None,
            hessian: merged(blocks),
            facets: sums.facets,
            points: sums.points,
            mean_depth: if count > 0.0 { depth / count } else { 0.0 },
            overlap,
        }))
    }

    /// What the facets of either side have in the shell of the other, and whether one has its core in the other.
    fn on_surfaces(&self, sides: [&FacetSide<D>; 2]) -> ([PointsFound<D>; 2], bool) {
        let (pair, surface) = (self.bodies.pair, self.bodies.pair.surface);
        let within = sides[0].aabb.inflated(self.layer).intersection(&sides[1].aabb.inflated(self.layer));
        if within.is_empty() {
            return ([PointsFound::default(), PointsFound::default()], false);
        }
        let facets = sides.map(|side| side.facets_in(&within));
        let first = self.bodies_of.map(|body| surface.ranges[body].start);
        let shell = |which: usize| {
            let (side, other) = (sides[which], sides[1 - which]);
            // Where facets of the other are.
            let boxes = facets[1 - which].iter().map(|&facet| other.facet_box(facet as usize));
            let region =
                boxes.fold(Aabb::empty(), |all, aabb| all.union(&aabb)).inflated(self.layer).intersection(&within);
            let (body, clearance) = (self.bodies_of[which], self.bodies.clearance);
            let own = side.facets_in(&region);
            let pieces =
                CellPieces::new(pair, self.bodies.cells, self.bodies.field, body, (&own, &region), None, clearance);
            let over = Layer {
                surface,
                cells: self.bodies.cells,
                curves: self.curves,
                side,
                first: first[which],
                thickness: self.layer,
            };
            Shell::new(pieces, &over, &own)
        };
        let (shell_a, shell_b) = pair.both(|| shell(0), || shell(1));
        let rounding = within.rounding();
        let of_side = |which: usize, shell: &Shell<D>| {
            let points = FacetPoints {
                surface,
                cells: self.bodies.cells,
                curves: self.curves,
                side: sides[which],
                first: first[which],
                beside: self.bodies_of[1 - which],
                of_b: which == 1,
                shell,
                tent: self.tent,
                weighting: pair.weighting,
                clearance: self.bodies.clearance,
                request: self.bodies.request,
                rules: Rules::new::<D>(),
            };
            let parts = pair.in_chunks(&facets[which], CHUNK, |facets| points.sums(facets, rounding));
            PointsFound::of_parts(parts)
        };
        let (a, b) = pair.both(|| of_side(0, &shell_b), || of_side(1, &shell_a));
        let has_core_inside = self.has_core_inside(sides[1], &within, (self.bodies_of[0], &shell_a))
            || self.has_core_inside(sides[0], &within, (self.bodies_of[1], &shell_b));
        ([a, b], has_core_inside)
    }

    /// Whether either body may have its core, what of it is deeper than the tent's top, in the other where no facet is so deep: one point
    /// of it tells, where it hangs together.
    fn has_core_inside(&self, side: &FacetSide<D>, within: &Aabb<D>, (body, shell): (usize, &Shell<D>)) -> bool {
        if !self.bodies.field.is_connected(body) {
            return true;
        }
        let corners = shell.pieces.pieces.iter().flat_map(|piece| piece.corners.iter().zip(&piece.depths).take(D + 1));
        let is_core =
            |(x, depth): &(&Vector<D>, &f64)| **depth > self.tent.top && within.contains(&Aabb { min: **x, max: **x });
        corners.into_iter().find(is_core).is_some_and(|(x, _)| side.winding_number(x) != 0)
    }
}

impl<const D: usize> PointsFound<D> {
    /// The sum of several parts, in their order.
    fn of_parts(parts: Vec<Self>) -> Self {
        let mut all = Self::default();
        let mut sums = Vec::with_capacity(parts.len());
        for part in parts {
            all.energy += part.energy;
            all.volume += part.volume;
            all.deepest = all.deepest.max(part.deepest);
            all.errors.add_all(&part.errors);
            sums.push(part.sums);
        }
        all.sums = FacetSums::of_parts(sums);
        all
    }
}

fn times<const D: usize>(mut blocks: Vec<Block<D>>, factor: f64) -> Vec<Block<D>> {
    blocks.iter_mut().flat_map(|block| block.value.iter_mut().flatten()).for_each(|x| *x *= factor);
    blocks
}
