//! The tractions of a pair, summed at its nodes.

use super::facet_sums::Row;
use super::side_motion::Mover;
use super::slip_facets::{SlipFacet, SlipFacets};
use super::traction::Traction;
use crate::contact::tangents::{Tangent, TangentPart};
use crate::geometry::{Vector, moment};
use crate::overlap::{BlockSum, NodeSums, Partner};
use nalgebra::SMatrix;

/// Friction of a pair.
pub(crate) struct Tractions<const D: usize> {
    pub(crate) partners: [Partner; 2],
    /// Forces on nodes, and the side to which each belongs.
    pub(crate) nodes: Vec<u32>,
    pub(crate) of_b: Vec<bool>,
    pub(crate) forces: Vec<Vector<D>>,
    /// Force on an obstacle, and its moment about the origin.
    pub(crate) on_obstacle: (Vector<D>, [f64; 3]),
    pub(crate) tangent: Tangent<D>,
    pub(crate) totals: FrictionTotals,
    /// The part of the forces on nodes that grows with the limits, times these; empty unless it is asked for.
    pub(crate) limited: Vec<(u32, Vector<D>)>,
    pub(crate) undirected: Option<Undirected>,
}

/// Facets to which the direction of their friction is perpendicular.
#[derive(Clone, Copy)]
pub(crate) struct Undirected {
    /// That of them with the largest limit, by its index within the surface.
    pub(crate) facet: usize,
    /// Their part of the limit of the pair.
    pub(crate) part: f64,
}

/// What friction does in sum; all zero without.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct FrictionTotals {
    /// Energy stored in the stick.
    pub stored: f64,
    /// Energy dissipated since the step began, never negative.
    pub dissipated: f64,
    /// Area that sticks.
    pub stick_area: f64,
    /// Area that slides.
    pub slip_area: f64,
    /// Largest slip since the step began that was not elastic; also of pairs without friction that wear.
    pub largest_slip: f64,
}

impl FrictionTotals {
    fn add<const D: usize>(&mut self, facet: &SlipFacet<D>, traction: &Traction<D>) {
        self.stored += facet.area * traction.stored;
        self.dissipated += facet.area * facet.dissipated(traction);
        match traction.slides {
            true => self.slip_area += facet.area,
            false => self.stick_area += facet.area,
        }
        self.largest_slip = self.largest_slip.max((facet.trial - traction.elastic).norm());
    }

    /// Both together.
    pub(crate) fn plus(self, other: Self) -> Self {
        Self {
            stored: self.stored + other.stored,
            dissipated: self.dissipated + other.dissipated,
            stick_area: self.stick_area + other.stick_area,
            slip_area: self.slip_area + other.slip_area,
            largest_slip: self.largest_slip.max(other.largest_slip),
        }
    }
}

impl<const D: usize> Tractions<D> {
    /// Of a pair that is not in contact any more, and has lost what was stored in it.
    pub(crate) fn released(partners: [Partner; 2], energy: f64) -> Self {
        Self {
            partners,
            nodes: Vec::new(),
            of_b: Vec::new(),
            forces: Vec::new(),
            on_obstacle: (Vector::zeros(), [0.0; 3]),
            tangent: Tangent { blocks: Vec::new(), rank_one: Vec::new() },
            totals: FrictionTotals { dissipated: energy, ..FrictionTotals::default() },
            limited: Vec::new(),
            undirected: None,
        }
    }

    /// Forces and, if asked for, the tangent, of which `Full` knows that the limit grows with the pressure, with the rotations of so many
    /// obstacles if these are given.
    pub(crate) fn new(
        slipping: &SlipFacets<D>,
        node_count: usize,
        part: Option<TangentPart>,
        rotations: Option<usize>,
    ) -> Self {
        let (mut sums, mut on_obstacle) = (NodeSums::default(), (Vector::zeros(), [0.0; 3]));
        let (mut totals, mut blocks) = (FrictionTotals::default(), BlockSum::default());
        let mut scratch = Scratch { nodes: Vec::new(), values: Vec::new() };
        for (facet, rows, traction) in slipping.tractions() {
            totals.add(facet, &traction);
            let along = traction.value * facet.area;
            for row in rows.iter().filter(|row| !row.mover.turns) {
                let force = -(row.slip.transpose() * along);
                if (row.mover.node as usize) < node_count {
                    sums.add(row.mover.node, row.of_b, &force);
                } else {
                    on_obstacle.0 += force;
                    on_obstacle.1.iter_mut().zip(moment(&facet.position, &force)).for_each(|(sum, m)| *sum += m);
                }
            }
            if let Some(part) = part {
                let number = |mover: Mover| match rotations {
                    _ if !mover.turns => Some(mover.node),
                    count => Some(mover.node + count? as u32),
                };
                scratch.add_blocks(facet, (rows, number), (&traction, part), &mut blocks);
            }
        }
        totals.dissipated += slipping.released();
        let (nodes, of_b, forces) = sums.into_nodes();
        let tangent = Tangent { blocks: blocks.into_blocks(), rank_one: Vec::new() };
        let (partners, undirected) = (slipping.partners, slipping.undirected());
        Self { partners, nodes, of_b, forces, on_obstacle, tangent, totals, limited: Vec::new(), undirected }
    }

    /// The same with what grows with the limits.
    pub(crate) fn with_limited(mut self, slipping: &SlipFacets<D>, node_count: usize) -> Self {
        for (facet, rows, traction) in slipping.tractions() {
            let along = traction.by_limit * (facet.slider.limit * facet.area);
            for row in rows.iter().filter(|row| !row.mover.turns && (row.mover.node as usize) < node_count) {
                self.limited.push((row.mover.node, -(row.slip.transpose() * along)));
            }
        }
        self
    }
}

impl<const D: usize> SlipFacets<D> {
    /// Of a pair that slides freely, of which only the slip is asked.
    pub(crate) fn without_friction(&self) -> Tractions<D> {
        let slips = self.tractions().map(|(facet, _, traction)| (facet.trial - traction.elastic).norm());
        let totals = FrictionTotals { largest_slip: slips.fold(0.0, f64::max), ..FrictionTotals::default() };
        Tractions { totals, ..Tractions::released(self.partners, 0.0) }
    }

    fn undirected(&self) -> Option<Undirected> {
        let limit = |facet: &SlipFacet<D>| facet.area * facet.slider.limit;
        let found = || self.facets.iter().filter(|facet| facet.is_undirected);
        let facet = found().max_by(|one, other| limit(one).total_cmp(&limit(other)))?.facet;
        let all: f64 = self.facets.iter().map(limit).sum();
        Some(Undirected { facet, part: found().map(limit).sum::<f64>() / all })
    }
}

/// Memory that is used again.
struct Scratch<const D: usize> {
    nodes: Vec<u32>,
    values: Vec<[[f64; D]; D]>,
}

impl<const D: usize> Scratch<D> {
    /// Adds c Bᵀ C B, C = ∂q/∂s by the part of the step that counts, of what is frozen and wanted semidefinite the secant. The full tangent
    /// also has what is not symmetric: Bᵀ ∂q/∂τ times the derivative of the limit τ, and that of this part.
    fn add_blocks(
        &mut self,
        facet: &SlipFacet<D>,
        (rows, number): (&[Row<D>], impl Fn(Mover) -> Option<u32>),
        (traction, part): (&Traction<D>, TangentPart),
        blocks: &mut BlockSum<D>,
    ) {
        let Scratch { nodes, values } = self;
        let tangential = SMatrix::<f64, D, D>::identity() - facet.normal * facet.normal.transpose();
        let with_limit = part == TangentPart::Full;
        let is_secant = facet.is_frozen && part == TangentPart::Semidefinite;
        let by_slip = if is_secant { traction.secant(&facet.trial, &facet.dual) } else { traction.stiffness };
        let mut stiffness = tangential * by_slip * tangential * (facet.area * facet.counted);
        if with_limit && facet.by_approach != Vector::<D>::zeros() {
            // The nearer they come in the step, the more of it counts.
            stiffness += tangential * traction.stiffness * facet.by_approach * facet.normal.transpose() * facet.area;
        }
        let pushed = (with_limit && traction.by_limit != Vector::<D>::zeros()).then_some(traction.by_limit);
        nodes.clear();
        nodes.extend(rows.iter().filter_map(|row| number(row.mover)));
        let rows = || rows.iter().filter(|row| number(row.mover).is_some());
        values.clear();
        for row in rows() {
            let left = row.slip.transpose() * stiffness;
            let along = pushed.map(|s| row.slip.transpose() * s);
            for col in rows() {
                let mut value = left * col.slip;
                if let Some(along) = along {
                    value += along * col.limit.transpose();
                }
                values.push(std::array::from_fn(|i| std::array::from_fn(|j| value[(i, j)])));
            }
        }
        blocks.add_square(nodes, values);
    }
}
