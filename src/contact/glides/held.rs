//! All pairs of a contact that slide and do not separate.

use crate::Error;
use crate::contact::laws::{Answer, PairEnergy};
use crate::contact::mesh::Mesh;
use crate::contact::tangents::{Tangent, TangentPart};
use crate::contact::ties::TieChange;
use crate::geometry::Weighting;
use crate::interfaces::{Between, Curvature, Glide, GlideAt, HeldFacets};
use crate::overlap::Partner;
use std::collections::BTreeMap;
use std::sync::Arc;

/// By pair of bodies, ascending; a copy shares what was found.
#[derive(Clone, Default)]
pub(crate) struct Glides<const D: usize>(BTreeMap<[usize; 2], Held<D>>);

#[derive(Clone)]
struct Held<const D: usize> {
    between: Between,
    /// At first as the mesh is without deformation; an error is that of every evaluation.
    glide: Result<Arc<Glide<D>>, Error>,
    /// Tractions along the normal that need no gap, by point; none at first.
    multipliers: BTreeMap<u32, f64>,
}

/// One pair, with its multipliers by point.
type One<'a, const D: usize> = (&'a Glide<D>, &'a BTreeMap<u32, f64>);

impl<const D: usize> Glides<D> {
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Holds two bodies so, or releases them with `None`.
    ///
    /// # Errors
    /// Those of [`Glide::new`]; all then stays as it is.
    pub(crate) fn set(
        &mut self,
        bodies: [usize; 2],
        between: Option<Between>,
        mesh: &Mesh<D>,
        weighting: Weighting,
    ) -> Result<(), Error> {
        let Some(between) = between else {
            self.0.remove(&bodies);
            return Ok(());
        };
        if self.0.get(&bodies).is_some_and(|held| held.between == between && held.glide.is_ok()) {
            return Ok(());
        }
        let glide = Ok(found(mesh, weighting, &between)?);
        self.0.insert(bodies, Held { between, glide, multipliers: BTreeMap::new() });
        Ok(())
    }

    /// Finds all from the beginning, on another mesh without deformation.
    pub(crate) fn find_again(&mut self, mesh: &Mesh<D>, weighting: Weighting) {
        for held in self.0.values_mut() {
            (held.glide, held.multipliers) = (found(mesh, weighting, &held.between), BTreeMap::new());
        }
    }

    /// The same pairs with points that are found anew at these points of the mesh.
    ///
    /// # Errors
    /// [`Error::Untied`] where two bodies have slid off one another.
    pub(crate) fn moved_on(&self, mesh: &Mesh<D>, weighting: Weighting, points: &[[f64; D]]) -> Result<Self, Error> {
        let mut next = self.clone();
        if next.0.is_empty() {
            return Ok(next);
        }
        let rest = mesh.placed(mesh.surface.reference().into());
        for held in next.0.values_mut() {
            if let Ok(glide) = &held.glide {
                held.glide = Ok(Arc::new(glide.moved_on(&mesh.surface, [&rest, points], weighting)?));
            }
        }
        Ok(next)
    }

    /// All of them.
    ///
    /// # Errors
    /// Of one that is no longer there, since the mesh without deformation has changed.
    pub(crate) fn all(&self) -> impl Iterator<Item = Result<One<'_, D>, Error>> {
        self.0.values().map(|held| match &held.glide {
            Ok(glide) => Ok((&**glide, &held.multipliers)),
            Err(error) => Err(error.clone()),
        })
    }

    /// Facets that are held of pairs of which parts alone are to be.
    pub(crate) fn facets(&self) -> impl Iterator<Item = ([usize; 2], &HeldFacets)> {
        let in_part = self.0.values().filter(|held| held.between.facets.is_some());
        in_part.filter_map(|held| held.glide.as_ref().ok().map(|glide| (held.between.bodies, &glide.first.facets)))
    }

    /// That of two bodies.
    pub(crate) fn of(&self, bodies: [usize; 2]) -> Option<Result<&Glide<D>, Error>> {
        self.0.get(&bodies).map(|held| held.glide.as_deref().map_err(Error::clone))
    }

    /// Their energies and tangents at the points of the mesh, as far as they are asked for; by pair.
    pub(crate) fn measured(
        &self,
        points: &[[f64; D]],
        stiffness: impl Fn([Partner; 2]) -> f64,
        (energy, part): (bool, Option<TangentPart>),
    ) -> Result<Vec<Answer<D>>, Error> {
        let one = |found: Result<One<'_, D>, Error>| {
            let (glide, multipliers) = found?;
            let at = glide.at(points, stiffness(glide.first.between.bodies.map(Partner::Body)), multipliers);
            let energy = energy.then(|| pair_energy(glide, &at));
            let tangent = part.map(|part| {
                let which = if part == TangentPart::Semidefinite { Curvature::Semidefinite } else { Curvature::All };
                Tangent { blocks: at.curvature(which), rank_one: Vec::new() }
            });
            Ok(Answer { energy, tangent, nodal_sums: None, points: Vec::new() })
        };
        self.all().map(one).collect()
    }

    /// The same with the tractions that there are at these points of the mesh as multipliers, and what that changes; with the
    /// stiffness of a pair comes whether it was given.
    pub(crate) fn updated(
        &self,
        points: &[[f64; D]],
        stiffness: impl Fn([Partner; 2]) -> (f64, bool),
    ) -> Result<(TieChange, Self), Error> {
        let (mut found, mut next) = (TieChange::default(), self.clone());
        for held in next.0.values_mut() {
            let glide = held.glide.clone()?;
            let (stiffness, is_given) = stiffness(glide.first.between.bodies.map(Partner::Body));
            let at = glide.at(points, stiffness, &held.multipliers);
            let rows = glide.rows.iter().zip(at.gaps.iter().zip(&at.tractions));
            found.add(
                (stiffness, is_given),
                rows.map(|(row, (gap, traction))| [row.measure, gap.abs(), traction.abs()]),
            );
            held.multipliers = glide.rows.iter().map(|row| row.point).zip(at.tractions.iter().copied()).collect();
        }
        Ok((found, next))
    }

    pub(crate) fn have_multipliers(&self) -> bool {
        self.0.values().any(|held| !held.multipliers.is_empty())
    }

    /// Leaves a part of them.
    pub(crate) fn scale_multipliers(&mut self, part: f64) {
        self.0.values_mut().flat_map(|held| held.multipliers.values_mut()).for_each(|traction| *traction *= part);
    }

    pub(crate) fn release_multipliers(&mut self) {
        self.0.values_mut().for_each(|held| held.multipliers.clear());
    }
}

fn found<const D: usize>(mesh: &Mesh<D>, weighting: Weighting, between: &Between) -> Result<Arc<Glide<D>>, Error> {
    let points = mesh.placed(mesh.surface.reference().into());
    Glide::new(&mesh.surface, &points, weighting, between).map(Arc::new)
}

fn pair_energy<const D: usize>(glide: &Glide<D>, at: &GlideAt<'_, D>) -> PairEnergy<D> {
    let pressed = glide.rows.iter().zip(&at.tractions).map(|(row, traction)| row.measure * traction.abs()).sum::<f64>();
    let bodies = glide.first.between.bodies;
    PairEnergy::of_interface(
        bodies,
        (at.energy, at.gradient()),
        (&glide.nodes, &glide.of_b),
        (glide.area, pressed / glide.area),
        glide.left_out.iter().map(|left_out| left_out.warning(bodies, glide.area)).collect(),
    )
}
