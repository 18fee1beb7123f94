//! The cohesive interfaces of a contact.

use super::carried::carried;
use crate::Error;
use crate::contact::held::{At, Damage, Finder, Found, HeldList};
use crate::contact::laws::PairEnergy;
use crate::contact::mesh::Mesh;
use crate::contact::tangents::TangentPart;
use crate::geometry::Weighting;
use crate::interfaces::{Cohesion, CohesionAt, Cohesive, HeldFacets, PointState, Softened};
use crate::overlap::Block;
use std::mem::replace;

/// Cohesive interfaces by pair of bodies, ascending.
pub(crate) type Cohesions<const D: usize> = HeldList<Cohesion<D>, D>;

impl<const D: usize> Found<D> for Cohesion<D> {
    const FINDER: Finder<Self, D> = Self::new;
    /// Its options, and the last that there was, where there is none now: what its points have been through waits for the next.
    type Kept = (Cohesive, Option<Self>);
    type There<'a> = CohesionAt<'a, D>;

    fn facets(&self) -> &HeldFacets {
        &self.facets
    }

    /// After what its points have been through.
    fn there(&self, (options, _): &Self::Kept, at: At<D>) -> Result<CohesionAt<'_, D>, Error> {
        Ok(self.at(at.points, &at.past.law(options, self.bodies)?, at.past.states(self)))
    }

    /// What was put into the interface, stored and dissipated: no step makes it jump. Its area is what is not broken.
    fn pair_energy(&self, at: &CohesionAt<'_, D>) -> PairEnergy<D> {
        let energy = at.energies().iter().sum();
        let (mut area, mut pulled) = (0.0, 0.0);
        for (point, at) in at.points() {
            area += if at.now().damage < 1.0 { point.measure } else { 0.0 };
            pulled += point.measure * at.traction.norm();
        }
        PairEnergy::of_interface(
            self.bodies,
            (energy, at.gradient()),
            (&self.nodes, &self.of_b),
            (area, pulled / self.area),
            self.left_out.iter().map(|left_out| left_out.warning(self.bodies, self.area)).collect(),
        )
    }

    fn blocks(at: &CohesionAt<'_, D>, part: TangentPart) -> Vec<Block<D>> {
        at.curvature(match part {
            TangentPart::Full => Softened::All,
            TangentPart::Symmetric => Softened::Symmetric,
            TangentPart::Semidefinite => Softened::Secant,
        })
    }
}

impl<const D: usize> Cohesions<D> {
    /// Finds them anew, on another mesh without deformation. What is broken stays so.
    pub(crate) fn find_again(&mut self, mesh: &Mesh<D>, weighting: Weighting, damage: &mut Damage) {
        let points = mesh.placed(mesh.surface.reference().into());
        for ((bodies, _), held) in &mut self.held {
            let before = replace(&mut held.found, Cohesion::find((mesh, weighting), &held.between));
            let before = before.ok().or_else(|| held.kept.1.take());
            match (&held.found, before) {
                (Ok(now), Some(before)) => {
                    if let Some(past) = damage.get_mut(bodies) {
                        *past = carried([&before, now], &points, past);
                    }
                }
                (_, before) => held.kept.1 = before,
            }
        }
    }

    /// What points have been through after a step that ends at these points of the mesh.
    pub(crate) fn damaged(&self, at: At<D>) -> Result<Damage, Error> {
        let one = |(cohesion, at, _): (&Cohesion<D>, CohesionAt<'_, D>, usize)| {
            (cohesion.bodies, at.points().map(|(_, point)| point.state()).collect())
        };
        Ok(self.there(at)?.into_iter().map(one).collect())
    }

    /// The same as one list, by pair and point.
    pub(crate) fn list(&self, damage: &Damage) -> Result<Vec<PointState>, Error> {
        let mut list = Vec::new();
        for found in self.all() {
            let (cohesion, _) = found?;
            let known = damage.get(&cohesion.bodies).map_or(&[][..], Vec::as_slice);
            list.extend((0..cohesion.points.len()).map(|point| known.get(point).copied().unwrap_or_default()));
        }
        Ok(list)
    }

    /// Of such a list, whose values are `checked` one by one; `array` is its name.
    ///
    /// # Errors
    /// [`Error::Length`]; those of a value.
    pub(crate) fn of_list<T>(
        &self,
        damage: &Damage,
        (array, list): (&'static str, &[T]),
        put: impl Fn(&mut PointState, &T) -> Result<(), Error>,
    ) -> Result<Damage, Error> {
        let mut all = self.list(damage)?;
        // A wrong value is named before a wrong number of them.
        list.iter().try_for_each(|one| put(&mut PointState::default(), one))?;
        if list.len() != all.len() {
            return Err(Error::Length { array, expected: all.len(), found: list.len() });
        }
        all.iter_mut().zip(list).try_for_each(|(state, one)| put(state, one))?;
        let mut rest = all.into_iter();
        let found = self.all().map(|found| found.map(|(cohesion, _)| cohesion));
        found.map(|found| found.map(|one| (one.bodies, rest.by_ref().take(one.points.len()).collect()))).collect()
    }
}
