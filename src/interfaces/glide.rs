//! Two surfaces that slide on one another and do not separate: the normal part of a tie, at points that are found anew as bodies move.
//!
//! At a point of a common piece a = x_A(ξ) − x_B(η), where ξ and η stay with the material until points are found anew. With the normal n of the
//! facet of B, as it turns, the gap is a·n. Its means over the hat functions ψ_i of one side, g_i = ∫ψ_i a·n dA / ∫ψ_i dA − γ_i, are what is
//! held; γ_i is the mean that was there at first. A hat function averages the facets of a circle: as it turns in another one, γ_i stays what
//! it is but for terms of higher order. Areas are those without deformation, so that a traction stays a force as points are found anew.

use super::between::{Between, HeldFacets};
use super::common_pieces::Facing;
use super::covered::{Covered, LeftOut};
use super::place::{Weights, of_vertices};
use super::tie::Tie;
use crate::Error;
use crate::geometry::primitives::convex_piece::place;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::{Surface, Vector, Weighting};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Two bodies that slide on one another and do not separate, at some coordinates.
pub(crate) struct Glide<const D: usize> {
    /// Points of the mesh that are moved, those of the first body before those of the second, each ascending.
    pub(crate) nodes: Vec<u32>,
    pub(crate) of_b: Vec<bool>,
    pub(crate) rows: Vec<GlideRow>,
    /// Facets whose normals count, by the nodes that move each corner.
    pub(super) frames: Vec<[Weights; D]>,
    /// What faces one another, in area (2D: length).
    pub(crate) area: f64,
    pub(crate) left_out: Option<LeftOut>,
    pub(crate) first: Arc<AtFirst>,
}

/// What was found where nothing was deformed, and stays.
pub(crate) struct AtFirst {
    pub(crate) between: Between,
    /// What faced something then.
    pub(crate) facets: HeldFacets,
    /// How far apart facets might be.
    pub(crate) reach: f64,
    /// Whether the side of the hat functions is the second body.
    pub(crate) is_second: bool,
    /// Mean gaps by point, and that of all.
    gaps: BTreeMap<u32, f64>,
    mean_gap: f64,
    /// The largest gap, or overlap, that is kept.
    pub(crate) largest_gap: f64,
}

/// A mean of the gap that is held.
pub(crate) struct GlideRow {
    /// The point of whose hat function it is the mean.
    pub(crate) point: u32,
    /// ∫ψ dA.
    pub(crate) measure: f64,
    /// By facet that is faced.
    pub(super) parts: Vec<GlidePart>,
    /// The mean that is kept.
    pub(super) gap: f64,
}

/// What a mean has of a facet.
pub(super) struct GlidePart {
    pub(super) frame: u32,
    /// ∫ψ dA over it.
    pub(super) measure: f64,
    /// ∫ψ a dA by the nodes, as places in the list; positive on the side of the hat function.
    pub(super) apart: Weights,
}

/// ∫ψ a dA over a facet, by point of either body; true on the side that is faced.
type Apart = BTreeMap<(bool, u32), f64>;

/// Sums of one row while they are made, by facet.
#[derive(Default)]
struct Sums {
    measure: f64,
    gap: f64,
    parts: BTreeMap<usize, (f64, Apart)>,
}

impl<const D: usize> Glide<D> {
    /// Of two bodies where they face one another, at these points of the straight mesh.
    ///
    /// # Errors
    /// [`Error::Untied`] where they do so nowhere; [`Error::Unsupported`] where faces of one lie above one another within reach.
    pub(crate) fn new(
        surface: &Surface<D>,
        points: &[[f64; D]],
        weighting: Weighting,
        between: &Between,
    ) -> Result<Self, Error> {
        // The side that holds a tie holds its normal part.
        let tie = Tie::new(surface, points, weighting, between)?;
        let Tie { is_second, largest_gap, given: reach, facets, .. } = tie;
        let (between, gaps) = (between.clone(), BTreeMap::new());
        let none = AtFirst { between, facets, reach, is_second, gaps, mean_gap: 0.0, largest_gap };
        let mut found = Self::found(surface, [points; 2], weighting, Arc::new(none))?;
        if largest_gap > 0.0 {
            let whole: f64 = found.rows.iter().map(|row| row.measure).sum();
            let gaps = found.rows.iter().map(|row| (row.point, row.gap)).collect();
            let mean_gap = found.rows.iter().map(|row| row.measure * row.gap).sum::<f64>() / whole;
            let AtFirst { between, facets, .. } = &*found.first;
            let (between, facets) = (between.clone(), facets.clone());
            found.first = Arc::new(AtFirst { between, facets, reach, is_second, gaps, mean_gap, largest_gap });
        }
        Ok(found)
    }

    /// Finds points anew where both have moved on, from these points of the mesh at rest to these. A row that was there at first keeps its gap,
    /// any other has the mean of all.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub(crate) fn moved_on(
        &self,
        surface: &Surface<D>,
        [rest, points]: [&[[f64; D]]; 2],
        weighting: Weighting,
    ) -> Result<Self, Error> {
        let mut found = Self::found(surface, [rest, points], weighting, Arc::clone(&self.first))?;
        for row in &mut found.rows {
            row.gap = self.first.gaps.get(&row.point).copied().unwrap_or(self.first.mean_gap);
        }
        Ok(found)
    }

    fn found(
        surface: &Surface<D>,
        [rest, points]: [&[[f64; D]]; 2],
        weighting: Weighting,
        first: Arc<AtFirst>,
    ) -> Result<Self, Error> {
        let (at_rest, vertices) = (surface.points(rest), surface.points(points));
        let facing = Facing::of_bodies(surface, &vertices, &first.between);
        let (mut sums, mut covered, mut area) = (BTreeMap::<u32, Sums>::new(), Covered::default(), 0.0);
        let candidates = facing.candidates(first.is_second);
        for piece in candidates.into_iter().flat_map(|pair| facing.common(pair)) {
            let [here, there] = piece.facets;
            covered.add(&piece);
            let corners = [&at_rest, &vertices].map(|x| surface.facets[here].map(|vertex| x[vertex as usize]));
            // What the first facet measures by area at a place.
            let size = |x: &[Vector<D>; D], at: &[f64; D]| area_vector(x).norm() * weighting.at(&place(x, at));
            facing.for_each_opposite(points, weighting, &piece, |point| {
                let part = size(&corners[0], &point.at) / size(&corners[1], &point.at);
                let of_point = point.measure * if part.is_finite() { part } else { 1.0 };
                area += of_point;
                for (hat, value) in of_vertices(surface, here, &point.at) {
                    let (sums, measure) = (sums.entry(hat).or_default(), value * of_point);
                    sums.measure += measure;
                    sums.gap += measure * point.gap;
                    let (of_part, apart) = sums.parts.entry(there).or_default();
                    *of_part += measure;
                    point.own.iter().for_each(|(node, w)| *apart.entry((false, *node)).or_default() += measure * w);
                    point.other.iter().for_each(|(node, w)| *apart.entry((true, *node)).or_default() -= measure * w);
                }
            });
        }
        covered.check()?;
        if area <= 0.0 {
            return Err(facing.untied(first.between.bodies, "kept from separating"));
        }
        let left_out = covered.left_out(&facing, weighting, area);
        Ok(Self::assembled(surface, &sums, (area, left_out), first))
    }

    fn assembled(
        surface: &Surface<D>,
        sums: &BTreeMap<u32, Sums>,
        (area, left_out): (f64, Option<LeftOut>),
        first: Arc<AtFirst>,
    ) -> Self {
        let is_second = first.is_second;
        let (mut numbers, mut frames) = (BTreeMap::<(bool, u32), u32>::new(), BTreeMap::<usize, u32>::new());
        for (&facet, (_, apart)) in sums.values().flat_map(|sums| &sums.parts) {
            // Those of the first body of the pair come first.
            numbers.extend(apart.keys().map(|&(is_other, node)| ((is_other != is_second, node), 0)));
            if frames.insert(facet, 0).is_none() {
                for (node, _) in surface.facets[facet].iter().flat_map(|&vertex| surface.nodes_of_vertex(vertex)) {
                    numbers.insert((!is_second, node), 0);
                }
            }
        }
        numbers.values_mut().zip(0..).for_each(|(number, next)| *number = next);
        frames.values_mut().zip(0..).for_each(|(number, next)| *number = next);
        let number = |is_other: bool, node: u32| numbers[&(is_other != is_second, node)];
        let part = |(facet, (measure, apart)): (&usize, &(f64, Apart))| GlidePart {
            frame: frames[facet],
            measure: *measure,
            apart: apart.iter().map(|(&(is_other, node), w)| (number(is_other, node), *w)).collect(),
        };
        let row = |(&point, sums): (&u32, &Sums)| GlideRow {
            point,
            measure: sums.measure,
            parts: sums.parts.iter().map(part).collect(),
            gap: sums.gap / sums.measure,
        };
        let corner =
            |vertex: u32| surface.nodes_of_vertex(vertex).map(|(node, w)| (number(true, node), w)).collect::<Weights>();
        Self {
            nodes: numbers.keys().map(|(_, node)| *node).collect(),
            of_b: numbers.keys().map(|(of_b, _)| *of_b).collect(),
            rows: sums.iter().filter(|(_, sums)| sums.measure > 0.0).map(row).collect(),
            frames: frames.keys().map(|facet| surface.facets[*facet].map(corner)).collect(),
            area,
            left_out,
            first,
        }
    }
}
