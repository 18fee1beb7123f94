//! How the law `depth` of two bodies changes with the depths and the places of the corners of their pieces, and how that in turn changes
//! as the nodes move: what a derivative by the reference coordinates stands on.
//!
//! ```text
//! J = ½ Σ_pieces ∫_{A∩P} g dx      δJ = ½ Σ_pieces Σ_k m_k (δg_k − ∇g·δy_k)      m_k = ∫_{A∩P} λ_k dx
//! ```
//!
//! where corner k of a piece P has the depth g_k and, the nodes staying, moves by δy_k. As the nodes move by v, linear in P and on facets,
//!
//! ```text
//! m_k' = m_k div v + Σ_facets of A ∫_{∂A∩P} λ_k (v_A − v_P)·n dA      ∇g' = −Σ_k ∇λ_k (v_k·∇g)
//! ```

use super::cell_pieces::CellPieces;
use super::deep_bodies::{CHUNK, DeepBodies, WEIGHT};
use super::facet_clip::{Found, clip};
use super::facet_part::FacetPart;
use crate::Error;
use crate::configuration::FacetSide;
use crate::depth_field::{CellSlopes, DepthPiece, ReferenceSlopes};
use crate::geometry::primitives::convex_piece::Piece;
use crate::geometry::{Vector, Weighting};
use crate::overlap::depth::integral::DepthRequest;
use crate::overlap::pair::body_facet::BodyFacet;
use crate::overlap::pair::bounds::Bounds;
use crate::overlap::pair::partner::Partner;
use crate::overlap::pair::region::Region;
use crate::overlap::pair::second_derivative::SecondDerivative;
use crate::overlap::pair::sides::{Counterpart, Pair};

/// What is differentiated: `energy` times J less its derivative as the nodes move by `motion`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DepthSeeds<'a, const D: usize> {
    pub(crate) energy: f64,
    /// By node of the straight mesh.
    pub(crate) motion: Option<&'a [[f64; D]]>,
}

/// The derivative by what the corners of pieces have, cell by cell.
///
/// # Errors
/// [`Error::Unsupported`] for bodies given by facets, and for a contact that begins below the surfaces if nodes move.
pub(crate) fn depth_slopes<const D: usize>(
    pair: &Pair<D>,
    slopes: &ReferenceSlopes<D>,
    seeds: &DepthSeeds<D>,
) -> Result<Vec<CellSlopes>, Error> {
    let request = DepthRequest { second: SecondDerivative::No, obstacle_node: 0, points: false };
    let bodies = DeepBodies { field: &slopes.field, ..DeepBodies::new(pair, &request)? };
    if bodies.clearance != 0.0 && seeds.motion.is_some() {
        let what = "the derivative of forces by reference coordinates with a gap offset between bodies";
        return Err(Error::Unsupported { what });
    }
    let mut found = Vec::new();
    let mut take = |pieces: &CellPieces<D>, moments: &[[f64; 4]], changes: Option<Vec<[f64; 4]>>| {
        add_pieces(&bodies, slopes, seeds, (pieces, moments, changes.as_deref()), &mut found);
    };
    match &pair.counterpart {
        Counterpart::Facets(b) => {
            let Some(region) = pair.region()? else { return Ok(found) };
            let bounds = pair.bounds(region);
            let [of_a, of_b] = [0, 1].map(|which| bodies.pieces(which, region, Some(bounds)));
            let (_, [in_a, in_b]) = bodies.inside_each_other::<[f64; 4]>([&pair.a, b], [&of_a, &of_b], region);
            let (rounding, facets) = (region.aabb.rounding(), &region.facets);
            let change = |side, facets: &[u32], pieces: &CellPieces<D>, moments: &[[f64; 4]]| {
                seeds.motion.map(|v| changes(&bodies, side, (facets, bounds, false), (pieces, moments), v, rounding))
            };
            take(&of_a, &in_a, change(b, &facets[1], &of_a, &in_a));
            take(&of_b, &in_b, change(&pair.a, &facets[0], &of_b, &in_b));
        }
        _ => {
            let a = &pair.a;
            let region = Region::new(a.aabb, [(0..a.facets.len() as u32).collect(), Vec::new()]);
            let all = bodies.pieces(0, &region, None);
            let (_, moments) = bodies.inside_itself::<[f64; 4]>(&all, &region);
            let (rounding, facets) = (a.aabb.rounding(), (&region.facets[0][..], pair.bounds(&region), true));
            let of_motion = seeds.motion.map(|v| changes(&bodies, a, facets, (&all, &moments), v, rounding));
            take(&all, &moments, of_motion);
        }
    }
    Ok(found)
}

/// How the moments of every piece change, if nodes move.
type Changes<'a> = Option<&'a [[f64; 4]]>;

/// Adds what the pieces of a body have, cell by cell.
fn add_pieces<const D: usize>(
    bodies: &DeepBodies<D>,
    slopes: &ReferenceSlopes<D>,
    seeds: &DepthSeeds<D>,
    (pieces, moments, changes): (&CellPieces<D>, &[[f64; 4]], Changes),
    found: &mut Vec<CellSlopes>,
) {
    let place = |coords: &[[f64; D]], node: u32| Vector::<D>::from(coords[node as usize]);
    let begun = found.len();
    for (number, (piece, moments)) in pieces.pieces.iter().zip(moments).enumerate() {
        let change = changes.map_or([0.0; 4], |changes| changes[number]);
        if moments.iter().chain(&change).all(|m| *m == 0.0) {
            continue;
        }
        if found[begun..].last().is_none_or(|last| last.cell != piece.cell) {
            let count = slopes.corner_count(bodies.pair.surface, piece.cell);
            found.push(CellSlopes { cell: piece.cell, depths: vec![0.0; count], weights: vec![[0.0; 8]; count] });
        }
        let Some(of_cell) = found.last_mut() else { continue };
        let nodes = bodies.cells.nodes(piece.cell as usize);
        let (g, turning) = (piece.gradient, seeds.motion.map(|v| gradient_change(piece, nodes, v)));
        for k in 0..=D {
            let corner = piece.numbers[k] as usize;
            let by_depth = WEIGHT * (seeds.energy * moments[k] - change[k]);
            of_cell.depths[corner] += by_depth;
            for (node, sum) in nodes.iter().zip(&mut of_cell.weights[corner]) {
                let from = place(bodies.pair.coords, *node) - piece.corners[0];
                *sum -= by_depth * g.dot(&from);
                if let (Some(turning), Some(v)) = (&turning, seeds.motion) {
                    *sum += WEIGHT * moments[k] * (turning.dot(&from) + g.dot(&place(v, *node)));
                }
            }
        }
    }
}

/// How the corners of a piece move.
fn motion_of<const D: usize>(piece: &DepthPiece<D>, nodes: &[u32], motion: &[[f64; D]]) -> [Vector<D>; 4] {
    piece.weights.map(|weights| {
        let terms = nodes.iter().zip(&weights).map(|(&node, w)| Vector::<D>::from(motion[node as usize]) * *w);
        terms.fold(Vector::zeros(), |sum, term| sum + term)
    })
}

/// How the gradient of the depth changes, as the nodes move.
fn gradient_change<const D: usize>(piece: &DepthPiece<D>, nodes: &[u32], motion: &[[f64; D]]) -> Vector<D> {
    let v = motion_of(piece, nodes, motion);
    (0..=D).fold(Vector::zeros(), |sum, k| sum - piece.slopes[k] * v[k].dot(&piece.gradient))
}

/// How the moments in every piece change as the nodes move.
fn changes<const D: usize>(
    bodies: &DeepBodies<D>,
    side: &FacetSide<D>,
    (facets, bounds, own): (&[u32], &Bounds<D>, bool),
    (pieces, moments): (&CellPieces<D>, &[[f64; 4]]),
    motion: &[[f64; D]],
    rounding: f64,
) -> Vec<[f64; 4]> {
    let of_piece = |piece: &DepthPiece<D>| motion_of(piece, bodies.cells.nodes(piece.cell as usize), motion);
    let by_motion: Vec<[Vector<D>; 4]> = pieces.pieces.iter().map(of_piece).collect();
    let across = Across { bodies, side, bounds, own, pieces, motion, by_motion: &by_motion, rounding };
    let mut sums: Vec<[f64; 4]> = (pieces.pieces.iter().zip(&by_motion).zip(moments))
        .map(|((piece, v), moments)| {
            let divergence: f64 = (0..=D).map(|k| v[k].dot(&piece.slopes[k])).sum();
            moments.map(|m| m * divergence)
        })
        .collect();
    // In chunks that do not depend on the number of threads, and added in their order.
    for found in bodies.pair.on_threads(facets, CHUNK, |facets| across.of_facets(facets)) {
        for (piece, change) in found {
            sums[piece as usize].iter_mut().zip(change).for_each(|(sum, x)| *sum += x);
        }
    }
    sums
}

/// The facets of one side that move through the pieces of the other body.
struct Across<'a, const D: usize> {
    bodies: &'a DeepBodies<'a, D>,
    side: &'a FacetSide<'a, D>,
    bounds: &'a Bounds<D>,
    own: bool,
    pieces: &'a CellPieces<D>,
    motion: &'a [[f64; D]],
    by_motion: &'a [[Vector<D>; 4]],
    rounding: f64,
}

impl<const D: usize> Across<'_, D> {
    /// ∫ λ_k (v_A − v_P)·n over what facets have inside pieces.
    fn of_facets(&self, facets: &[u32]) -> Vec<(u32, [f64; 4])> {
        let surface = self.bodies.pair.surface;
        let body = if let Partner::Body(body) = self.bodies.pair.partners[0] { body } else { 0 };
        let own_cell = self.own.then(|| &surface.facet_cell[surface.ranges[body].clone()]);
        let (mut work, mut part, mut found) = (Piece::default(), FacetPart::default(), Vec::new());
        for &number in facets {
            let Some(facet) = BodyFacet::new(surface, self.side, number) else { continue };
            let aabb = self.bounds.box_of_part(&facet.corners);
            if aabb.is_empty() {
                continue;
            }
            let near = aabb.inflated(self.rounding);
            let moves: [f64; D] = facet.weights.map(|weights| {
                let of_nodes = facet.nodes.iter().zip(&weights);
                of_nodes.map(|(&node, w)| w * facet.normal.dot(&Vector::from(self.motion[node as usize]))).sum()
            });
            self.pieces.tree.visit(
                |node| node.meets(&near),
                |j| {
                    let piece = &self.pieces.pieces[j as usize];
                    let is_own = own_cell.is_some_and(|cells| cells[number as usize] == piece.cell);
                    if is_own || !self.pieces.boxes[j as usize].meets(&near) {
                        return;
                    }
                    let barycentric = facet.corners.each_ref().map(|x| piece.barycentric(x));
                    let v = &self.by_motion[j as usize];
                    let past: [f64; D] = std::array::from_fn(|c| {
                        moves[c] - (0..=D).map(|k| barycentric[c][k] * facet.normal.dot(&v[k])).sum::<f64>()
                    });
                    clip(&facet.corners, &barycentric, &facet.area, piece, (&mut part, &mut work), |at| {
                        let Found::Part(inside, counts) = at else { return };
                        let products = products(&facet, inside.on_facet());
                        let factor = counts * piece.sign * facet.measure;
                        let swept: [f64; D] =
                            std::array::from_fn(|b| (0..D).map(|c| products[b][c] * past[c]).sum::<f64>() * factor);
                        let of = |k: usize| (0..D).map(|b| barycentric[b][k] * swept[b]).sum();
                        found.push((j, std::array::from_fn(|k| if k <= D { of(k) } else { 0.0 })));
                    });
                },
            );
        }
        found
    }
}

/// ∫ of the products of a facet's coordinates over a part of it, in parts of its measure.
fn products<const D: usize>(facet: &BodyFacet<D>, part: &[[f64; D]]) -> [[f64; D]; D] {
    let mut products = [[0.0; D]; D];
    Weighting::Plain.for_each_simplex(&facet.corners, part, |corners, share, _| {
        let norm = share / (D * (D + 1)) as f64;
        let sums: [f64; D] = std::array::from_fn(|a| corners.iter().map(|w| w[a]).sum());
        for a in 0..D {
            for b in 0..D {
                let same: f64 = corners.iter().map(|w| w[a] * w[b]).sum();
                products[a][b] += norm * (same + sums[a] * sums[b]);
            }
        }
    });
    products
}
