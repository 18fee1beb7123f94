//! What hosts ask of ties.

use crate::Error;
use crate::contact::evaluation::Contact;
use crate::contact::results::OntoNodes;
use crate::contact::tangents::{Tangent, TangentPart};
use crate::contact::ties::{TieConstraints, TieNode, TieSummary};
use crate::geometry::Vector;
use crate::overlap::Partner;
use std::collections::BTreeMap;

impl<const D: usize> Contact<D> {
    /// The tie of two bodies, or what of them slides and does not separate; `None` where they are neither.
    ///
    /// # Errors
    /// [`Error::BodyOutOfRange`]; [`Error::Untied`] where they were tied on another mesh without deformation, and are not on this one.
    #[inline(never)]
    pub fn tie(&self, bodies: [usize; 2]) -> Result<Option<TieSummary>, Error> {
        let pair = self.partners.checked_pair(bodies.map(Partner::Body), self.mesh.surface.body_count())?;
        let [Partner::Body(a), Partner::Body(b)] = pair else { return Ok(None) };
        let found = self.ties.of([a, b]).transpose()?;
        let summary = |[area, largest_gap, reach]: [f64; 3], count| TieSummary { area, largest_gap, reach, count };
        let of_tie = found.map(|tie| summary([tie.area, tie.largest_gap, tie.given], tie.rows.len()));
        let glide = self.glides.of([a, b]).transpose()?;
        Ok(of_tie
            .or(glide.map(|glide| summary([glide.area, glide.first.largest_gap, glide.first.reach], glide.rows.len()))))
    }

    /// Traction and jump of all ties at `coords`, by pair and node; of bodies that do not separate along their normals.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::NonFiniteCoordinate`], [`Error::NoStiffness`], [`Error::Untied`].
    #[inline(never)]
    pub fn tie_nodes(&self, coords: &[[f64; D]]) -> Result<Vec<TieNode<D>>, Error> {
        self.check_stiffness()?;
        let points = self.mesh.points(coords)?;
        self.mesh.surface.check_coords(&points, false)?;
        let mut found = Vec::new();
        for (tie, at, _) in self.at_points(&points, |at| self.ties.there(at))? {
            let [a, b] = tie.bodies;
            let bodies = if tie.is_second { [b, a] } else { [a, b] };
            for (row, (jump, traction)) in tie.rows.iter().zip(at.jumps.iter().zip(&at.tractions)) {
                found.push(TieNode {
                    node: row.point,
                    bodies,
                    area: row.measure,
                    traction: (-traction).into(),
                    jump: (*jump).into(),
                });
            }
        }
        for (glide, at, _) in self.at_points(&points, |at| self.glides.there(at))? {
            let [a, b] = glide.first.between.bodies;
            let bodies = if glide.first.is_second { [b, a] } else { [a, b] };
            for (number, (row, (gap, traction))) in glide.rows.iter().zip(at.gaps.iter().zip(&at.tractions)).enumerate()
            {
                let normal = at.normal(number);
                let (traction, jump) = ((normal * -*traction).into(), (normal * *gap).into());
                found.push(TieNode { node: row.point, bodies, area: row.measure, traction, jump });
            }
        }
        found.sort_by_key(|one| (one.bodies[0].min(one.bodies[1]), one.bodies[0].max(one.bodies[1])));
        Ok(found)
    }

    /// Products of the part of the tangent that ties, what does not separate and cohesive interfaces have with motions of all rows of `coords`; none without these.
    pub(crate) fn held_by_interfaces(
        &self,
        coords: &[[f64; D]],
        motions: &[Vec<[f64; D]>],
    ) -> Result<Vec<Vec<[f64; D]>>, Error> {
        if !self.has_held() {
            return Ok(Vec::new());
        }
        let points = self.mesh.points(coords)?;
        let parts = self.answers_of_held(&points, (false, Some(TangentPart::Semidefinite)))?;
        let tangent = Tangent::sum(parts.into_iter().filter_map(|part| part.tangent).collect());
        let tangent = match self.mesh.surface.division() {
            Some(division) => tangent.onto_nodes(division),
            None => tangent,
        };
        Ok(motions.iter().map(|motion| tangent.product(motion)).collect())
    }

    /// The ties as equations of the nodes, or of a host's unknowns, a row for each of [`Self::tie_nodes`]: for hosts that eliminate, or have
    /// multipliers of their own. Those of a tie with a period hold for displacements.
    ///
    /// # Errors
    /// [`Error::Unsupported`] where a tie has a jump, where a gap is kept, along which a row depends on how facets turn, and with bodies that do not separate;
    /// [`Error::Untied`].
    #[inline(never)]
    pub fn tie_constraints(&self) -> Result<TieConstraints, Error> {
        if !self.glides.is_empty() {
            return Err(Error::Unsupported { what: "equations of bodies that do not separate, whose normals turn" });
        }
        let mut found = TieConstraints { row_starts: vec![0], ..TieConstraints::default() };
        for held in self.ties.all() {
            let (tie, _) = held?;
            if tie.largest_gap > 0.0 {
                return Err(Error::Unsupported { what: "equations of a tie that keeps a gap" });
            }
            if tie.jump != Vector::<D>::zeros() {
                return Err(Error::Unsupported { what: "equations of a tie with a jump, whose right sides are not 0" });
            }
            for row in &tie.rows {
                let mut sums: BTreeMap<u32, f64> = BTreeMap::new();
                for &(node, weight) in &row.jump {
                    let point = tie.nodes[node as usize];
                    let add =
                        |(node, share): (u32, f64)| *sums.entry(node).or_default() += weight / row.measure * share;
                    match self.mesh.surface.division() {
                        Some(division) => division.map().row(point as usize).for_each(add),
                        None => std::iter::once((point, 1.0)).for_each(add),
                    }
                }
                found.columns.extend(sums.keys());
                found.weights.extend(sums.values());
                found.row_starts.push(found.columns.len());
            }
        }
        Ok(found)
    }
}
