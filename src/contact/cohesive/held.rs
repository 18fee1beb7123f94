//! The cohesive interfaces of a contact.

use super::carried::carried;
use super::past::{Damage, Past};
use crate::Error;
use crate::contact::laws::{Answer, PairEnergy};
use crate::contact::mesh::Mesh;
use crate::contact::tangents::{Tangent, TangentPart};
use crate::geometry::Weighting;
use crate::interfaces::{Between, Cohesion, CohesionAt, Cohesive, CohesiveLaw, HeldFacets, PointState, Softened};
use std::collections::BTreeMap;
use std::mem::replace;

/// Cohesive interfaces by pair of bodies, ascending.
#[derive(Default)]
pub(crate) struct Cohesions<const D: usize>(BTreeMap<[usize; 2], Held<D>>);

struct Held<const D: usize> {
    options: Cohesive,
    between: Between,
    /// As the mesh is without deformation; an error is that of every evaluation.
    cohesion: Result<Cohesion<D>, Error>,
    /// The last that there was, where there is none now: what its points have been through waits for the next.
    before: Option<Cohesion<D>>,
}

impl<const D: usize> Cohesions<D> {
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Holds two bodies together, or releases them with `None`; returns whether anything has changed.
    ///
    /// # Errors
    /// Those of [`Cohesion::new`]; all then stays as it is.
    pub(crate) fn set(
        &mut self,
        bodies: [usize; 2],
        options: Option<(Cohesive, Between)>,
        mesh: &Mesh<D>,
        weighting: Weighting,
    ) -> Result<bool, Error> {
        let Some((options, between)) = options else { return Ok(self.0.remove(&bodies).is_some()) };
        if self
            .0
            .get(&bodies)
            .is_some_and(|held| held.options == options && held.between == between && held.cohesion.is_ok())
        {
            return Ok(false);
        }
        let cohesion = found(mesh, weighting, &between)?;
        self.0.insert(bodies, Held { options, between, cohesion: Ok(cohesion), before: None });
        Ok(true)
    }

    /// Finds them anew, on another mesh without deformation. What is broken stays so.
    pub(crate) fn find_again(&mut self, mesh: &Mesh<D>, weighting: Weighting, damage: &mut Damage) {
        let points = mesh.placed(mesh.surface.reference().into());
        for (bodies, held) in &mut self.0 {
            let before = replace(&mut held.cohesion, found(mesh, weighting, &held.between));
            let before = before.ok().or_else(|| held.before.take());
            match (&held.cohesion, before) {
                (Ok(now), Some(before)) => {
                    if let Some(past) = damage.get_mut(bodies) {
                        *past = carried([&before, now], &points, past);
                    }
                }
                (_, before) => held.before = before,
            }
        }
    }

    /// Facets that are held of pairs of which parts alone are to be.
    pub(crate) fn facets(&self) -> impl Iterator<Item = ([usize; 2], &HeldFacets)> {
        let in_part = self.0.values().filter(|held| held.between.facets.is_some());
        in_part.filter_map(|held| held.cohesion.as_ref().ok().map(|found| (held.between.bodies, &found.facets)))
    }

    /// All of them, with their laws.
    ///
    /// # Errors
    /// Of one that is no longer there, since the mesh without deformation has changed.
    pub(crate) fn all(&self) -> impl Iterator<Item = Result<(&Cohesion<D>, CohesiveLaw), Error>> {
        self.0.values().map(|held| match &held.cohesion {
            Ok(cohesion) => Ok((cohesion, CohesiveLaw::new(&held.options))),
            Err(error) => Err(error.clone()),
        })
    }

    /// All of them at the points of the mesh, after what they have been through.
    pub(crate) fn at(
        &self,
        points: &[[f64; D]],
        past: Past<D>,
    ) -> Result<Vec<(&Cohesion<D>, CohesionAt<'_, D>)>, Error> {
        let mut all = Vec::with_capacity(self.0.len());
        for held in self.0.values() {
            let cohesion = held.cohesion.as_ref().map_err(Clone::clone)?;
            let law = past.law(&held.options, cohesion.bodies)?;
            all.push((cohesion, cohesion.at(points, &law, past.states(cohesion))));
        }
        Ok(all)
    }

    /// Their energies and tangents at the points of the mesh, as far as they are asked for; by pair.
    pub(crate) fn measured(
        &self,
        points: &[[f64; D]],
        past: Past<D>,
        (energy, part): (bool, Option<TangentPart>),
    ) -> Result<Vec<Answer<D>>, Error> {
        let one = |(cohesion, at): (&Cohesion<D>, CohesionAt<'_, D>)| {
            let energy = energy.then(|| pair_energy(cohesion, &at));
            let tangent = part.map(|part| {
                let which = match part {
                    TangentPart::Full => Softened::All,
                    TangentPart::Symmetric => Softened::Symmetric,
                    TangentPart::Semidefinite => Softened::Secant,
                };
                Tangent { blocks: at.curvature(which), rank_one: Vec::new() }
            });
            Answer { energy, tangent, nodal_sums: None, points: Vec::new() }
        };
        Ok(self.at(points, past)?.into_iter().map(one).collect())
    }

    /// What points have been through after a step that ends at these points of the mesh.
    pub(crate) fn damaged(&self, points: &[[f64; D]], past: Past<D>) -> Result<Damage, Error> {
        let one = |(cohesion, at): (&Cohesion<D>, CohesionAt<'_, D>)| {
            (cohesion.bodies, at.points().map(|(_, point)| point.state()).collect())
        };
        Ok(self.at(points, past)?.into_iter().map(one).collect())
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

fn found<const D: usize>(mesh: &Mesh<D>, weighting: Weighting, between: &Between) -> Result<Cohesion<D>, Error> {
    let points = mesh.placed(mesh.surface.reference().into());
    Cohesion::new(&mesh.surface, &points, weighting, between)
}

/// What was put into the interface, stored and dissipated: no step makes it jump. Its area is what is not broken.
fn pair_energy<const D: usize>(cohesion: &Cohesion<D>, at: &CohesionAt<'_, D>) -> PairEnergy<D> {
    let energy = at.energies().iter().sum();
    let (mut area, mut pulled) = (0.0, 0.0);
    for (point, at) in at.points() {
        area += if at.now().damage < 1.0 { point.measure } else { 0.0 };
        pulled += point.measure * at.traction.norm();
    }
    PairEnergy::of_interface(
        cohesion.bodies,
        (energy, at.gradient()),
        (&cohesion.nodes, &cohesion.of_b),
        (area, pulled / cohesion.area),
        cohesion.left_out.iter().map(|left_out| left_out.warning(cohesion.bodies, cohesion.area)).collect(),
    )
}
