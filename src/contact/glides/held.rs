//! All pairs of a contact that slide and do not separate.

use crate::Error;
use crate::contact::held::{At, Finder, Found, HeldList};
use crate::contact::laws::PairEnergy;
use crate::contact::mesh::Mesh;
use crate::contact::tangents::TangentPart;
use crate::contact::ties::{HeldApart, TieChange};
use crate::geometry::Weighting;
use crate::interfaces::{Glide, GlideAt, GlideRow, HeldFacets};
use crate::overlap::{Block, Partner};
use std::collections::BTreeMap;
use std::sync::Arc;

/// By pair of bodies, ascending; a copy shares what was found.
pub(crate) type Glides<const D: usize> = HeldList<Arc<Glide<D>>, D>;

impl<const D: usize> Found<D> for Arc<Glide<D>> {
    const FINDER: Finder<Self, D> =
        |surface, points, weighting, between| Glide::new(surface, points, weighting, between).map(Arc::new);
    /// Tractions along the normal that need no gap, by point; none at first.
    type Kept = BTreeMap<u32, f64>;
    type There<'a> = GlideAt<'a, D>;

    fn facets(&self) -> &HeldFacets {
        &self.first.facets
    }

    fn there(&self, multipliers: &BTreeMap<u32, f64>, at: At<D>) -> Result<GlideAt<'_, D>, Error> {
        let stiffness = (at.stiffness)(self.first.between.bodies.map(Partner::Body));
        Ok(Glide::at(self, at.points, stiffness, multipliers))
    }

    fn pair_energy(&self, at: &GlideAt<'_, D>) -> PairEnergy<D> {
        let rows = self.rows.iter().zip(&at.tractions);
        let pressed = rows.map(|(row, traction)| row.measure * traction.abs()).sum::<f64>();
        let bodies = self.first.between.bodies;
        PairEnergy::of_interface(
            bodies,
            (at.energy, at.gradient()),
            (&self.nodes, &self.of_b),
            (self.area, pressed / self.area),
            self.left_out.iter().map(|left_out| left_out.warning(bodies, self.area)).collect(),
        )
    }

    fn blocks(at: &GlideAt<'_, D>, part: TangentPart) -> Vec<Block<D>> {
        at.curvature(part.into())
    }
}

impl<const D: usize> Glides<D> {
    /// Finds all from the beginning, on another mesh without deformation.
    pub(crate) fn find_again(&mut self, mesh: &Mesh<D>, weighting: Weighting) {
        for held in self.held.values_mut() {
            (held.found, held.kept) = (Arc::find((mesh, weighting), &held.between), BTreeMap::new());
        }
    }

    /// The same pairs with points that are found anew at these points of the mesh.
    ///
    /// # Errors
    /// [`Error::Untied`] where two bodies have slid off one another.
    pub(crate) fn moved_on(&self, mesh: &Mesh<D>, weighting: Weighting, points: &[[f64; D]]) -> Result<Self, Error> {
        let mut next = self.clone();
        if next.is_empty() {
            return Ok(next);
        }
        let rest = mesh.placed(mesh.surface.reference().into());
        for held in next.held.values_mut() {
            if let Ok(glide) = &held.found {
                held.found = Ok(Arc::new(glide.moved_on(&mesh.surface, [&rest, points], weighting)?));
            }
        }
        Ok(next)
    }

    /// All with the tractions that there are at these points of the mesh as multipliers, but where supports hold both sides, and what that changes; with
    /// the stiffness of a pair comes whether it was given.
    pub(crate) fn updated(
        &self,
        points: &[[f64; D]],
        stiffness: impl Fn([Partner; 2]) -> (f64, bool),
        is_held: impl Fn(u32, usize) -> bool,
    ) -> Result<(TieChange, Self), Error> {
        let (mut found, mut next) = (TieChange::default(), self.clone());
        for held in next.held.values_mut() {
            let glide = held.found.clone()?;
            let (stiffness, is_given) = stiffness(glide.first.between.bodies.map(Partner::Body));
            let at = glide.at(points, stiffness, &held.kept);
            let mut tractions = at.tractions.clone();
            let supported = at.follow(&glide, &is_held, &held.kept, &mut tractions);
            let before = |point: u32| held.kept.get(&point).copied().unwrap_or(0.0);
            let row = |(number, row): (usize, &GlideRow)| {
                let (gap, traction) = (at.gaps[number].abs(), tractions[number]);
                let change = if supported.get(number) == Some(&[true]) {
                    let bodies = glide.first.between.bodies;
                    found.tell_held_apart(HeldApart { bodies, point: row.point, jump: gap });
                    (traction - before(row.point)).abs() / stiffness
                } else {
                    gap
                };
                [row.measure, change, traction.abs()]
            };
            let rows: Vec<_> = glide.rows.iter().enumerate().map(row).collect();
            found.add((stiffness, is_given), rows.into_iter());
            held.kept = glide.rows.iter().map(|row| row.point).zip(tractions).collect();
        }
        Ok((found, next))
    }

    pub(crate) fn have_multipliers(&self) -> bool {
        self.held.values().any(|held| !held.kept.is_empty())
    }

    /// Leaves a part of them.
    pub(crate) fn scale_multipliers(&mut self, part: f64) {
        self.held.values_mut().flat_map(|held| held.kept.values_mut()).for_each(|traction| *traction *= part);
    }

    pub(crate) fn release_multipliers(&mut self) {
        self.held.values_mut().for_each(|held| held.kept.clear());
    }
}
