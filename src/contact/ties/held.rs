//! The ties of a contact.

use crate::Error;
use crate::contact::laws::{Answer, PairEnergy};
use crate::contact::mesh::Mesh;
use crate::contact::tangents::{Tangent, TangentPart};
use crate::geometry::{Vector, Weighting};
use crate::interfaces::{Between, Curvature, HeldFacets, Tie, TieAt};
use crate::overlap::Partner;
use std::collections::BTreeMap;

/// Ties by pair of bodies, ascending.
#[derive(Default)]
pub(crate) struct Ties<const D: usize>(BTreeMap<[usize; 2], Held<D>>);

struct Held<const D: usize> {
    between: Between,
    /// As the mesh is without deformation; an error is that of every evaluation.
    tie: Result<Tie<D>, Error>,
    /// Tractions that need no jump, by row; none at first.
    multipliers: Vec<Vector<D>>,
}

/// Multipliers by pair of bodies, and row.
pub(crate) type TieMultipliers<const D: usize> = BTreeMap<[usize; 2], Vec<Vector<D>>>;

/// What ties ask of their multipliers.
#[derive(Clone, Debug, Default)]
pub(crate) struct TieChange {
    /// The largest mean jump.
    pub(crate) largest: f64,
    work: f64,
    force: f64,
    mean_of_others: f64,
    /// By tie whose stiffness nobody has given: what it bears, and its largest jump by that which its largest traction would call up without multipliers.
    of_each: Vec<[f64; 2]>,
}

impl TieChange {
    /// Adds a tie of this stiffness by area, and whether that was given, row by row: what a row stands for, and the magnitudes of its jump and traction.
    pub(crate) fn add(&mut self, (stiffness, is_given): (f64, bool), rows: impl Iterator<Item = [f64; 3]>) {
        let (mut jump, mut traction, mut bears) = (0.0, 0.0, 0.0);
        for [measure, of_jump, of_traction] in rows {
            (jump, traction) = (of_jump.max(jump), of_traction.max(traction));
            self.work += measure * of_traction * of_jump;
            bears += measure * of_traction;
        }
        self.largest = self.largest.max(jump);
        self.force += bears;
        if traction > 0.0 && !is_given {
            self.of_each.push([bears, stiffness * jump / traction]);
        }
    }

    /// Those of others too.
    pub(crate) fn and(mut self, other: Self) -> Self {
        self.largest = self.largest.max(other.largest);
        self.mean_of_others = self.mean_of_others.max(other.mean());
        self.of_each.extend(other.of_each);
        self
    }

    /// Mean of the jumps by the tractions, of ties or of what else was added to them.
    pub(crate) fn mean(&self) -> f64 {
        if self.force > 0.0 { self.mean_of_others.max(self.work / self.force) } else { self.mean_of_others }
    }

    /// The largest part of its largest traction by which an update would change a traction, of ties that bear more than this.
    pub(crate) fn of_tractions(&self, light: f64) -> f64 {
        self.of_each.iter().filter(|[bears, _]| *bears > light).map(|[_, part]| *part).fold(0.0, f64::max)
    }
}

impl<const D: usize> Ties<D> {
    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Ties two bodies, or releases them with `None`.
    ///
    /// # Errors
    /// Those of [`Tie::new`]; the ties then stay as they are.
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
        if self.0.get(&bodies).is_some_and(|held| held.between == between && held.tie.is_ok()) {
            return Ok(());
        }
        let tie = found(mesh, weighting, &between)?;
        self.0.insert(bodies, Held { between, tie: Ok(tie), multipliers: Vec::new() });
        Ok(())
    }

    /// Finds them anew, on another mesh without deformation.
    pub(crate) fn find_again(&mut self, mesh: &Mesh<D>, weighting: Weighting) {
        for held in self.0.values_mut() {
            (held.tie, held.multipliers) = (found(mesh, weighting, &held.between), Vec::new());
        }
    }

    /// All of them, with their multipliers.
    ///
    /// # Errors
    /// Of a tie that is no longer there, since the mesh without deformation has changed.
    pub(crate) fn all(&self) -> impl Iterator<Item = Result<(&Tie<D>, &[Vector<D>]), Error>> {
        self.0.values().map(|held| match &held.tie {
            Ok(tie) => Ok((tie, &held.multipliers[..])),
            Err(error) => Err(error.clone()),
        })
    }

    /// Whether bodies are tied to any other.
    pub(crate) fn tied_bodies(&self, body_count: usize) -> Vec<bool> {
        (0..body_count).map(|body| self.0.keys().any(|bodies| bodies.contains(&body))).collect()
    }

    /// Facets that are tied of pairs of which parts alone are to be.
    pub(crate) fn facets(&self) -> impl Iterator<Item = ([usize; 2], &HeldFacets)> {
        let in_part = self.0.values().filter(|held| held.between.facets.is_some());
        in_part.filter_map(|held| held.tie.as_ref().ok().map(|tie| (held.between.bodies, &tie.facets)))
    }

    /// The tie of two bodies.
    pub(crate) fn of(&self, bodies: [usize; 2]) -> Option<Result<&Tie<D>, Error>> {
        self.0.get(&bodies).map(|held| held.tie.as_ref().map_err(Error::clone))
    }

    /// Their energies and tangents at the points of the mesh, as far as they are asked for; by pair.
    pub(crate) fn measured(
        &self,
        points: &[[f64; D]],
        stiffness: impl Fn([Partner; 2]) -> f64,
        (energy, part): (bool, Option<TangentPart>),
    ) -> Result<Vec<Answer<D>>, Error> {
        let one = |found: Result<(&Tie<D>, &[Vector<D>]), Error>| {
            let (tie, multipliers) = found?;
            let at = tie.at(points, stiffness(tie.bodies.map(Partner::Body)), multipliers);
            let energy = energy.then(|| pair_energy(tie, &at));
            let tangent = part.map(|part| {
                let which = if part == TangentPart::Semidefinite { Curvature::Semidefinite } else { Curvature::All };
                Tangent { blocks: at.curvature(which), rank_one: Vec::new() }
            });
            Ok(Answer { energy, tangent, nodal_sums: None, points: Vec::new() })
        };
        self.all().map(one).collect()
    }

    /// What an update would change at these points, and the multipliers after it: the tractions there are. With the stiffness of a pair comes
    /// whether it was given.
    pub(crate) fn change(
        &self,
        points: &[[f64; D]],
        stiffness: impl Fn([Partner; 2]) -> (f64, bool),
    ) -> Result<(TieChange, TieMultipliers<D>), Error> {
        let (mut found, mut next) = (TieChange::default(), TieMultipliers::new());
        for held in self.all() {
            let (tie, multipliers) = held?;
            let (stiffness, is_given) = stiffness(tie.bodies.map(Partner::Body));
            let at = tie.at(points, stiffness, multipliers);
            let rows = tie.rows.iter().zip(at.jumps.iter().zip(&at.tractions));
            found.add(
                (stiffness, is_given),
                rows.map(|(row, (jump, traction))| [row.measure, jump.norm(), traction.norm()]),
            );
            next.insert(tie.bodies, at.tractions);
        }
        Ok((found, next))
    }

    pub(crate) fn have_multipliers(&self) -> bool {
        self.0.values().any(|held| !held.multipliers.is_empty())
    }

    /// The multipliers of all, to be put back by [`Self::put_back`].
    pub(crate) fn multipliers(&self) -> TieMultipliers<D> {
        self.0.iter().map(|(bodies, held)| (*bodies, held.multipliers.clone())).collect()
    }

    /// Leaves a part of them.
    pub(crate) fn scale_multipliers(&mut self, part: f64) {
        self.0.values_mut().flat_map(|held| &mut held.multipliers).for_each(|traction| *traction *= part);
    }

    pub(crate) fn put_back(&mut self, mut multipliers: TieMultipliers<D>) {
        for (bodies, held) in &mut self.0 {
            held.multipliers = multipliers.remove(bodies).unwrap_or_default();
        }
    }
}

fn found<const D: usize>(mesh: &Mesh<D>, weighting: Weighting, between: &Between) -> Result<Tie<D>, Error> {
    let points = mesh.placed(mesh.surface.reference().into());
    Tie::new(&mesh.surface, &points, weighting, between)
}

fn pair_energy<const D: usize>(tie: &Tie<D>, at: &TieAt<'_, D>) -> PairEnergy<D> {
    let pressed = tie.rows.iter().zip(&at.tractions).map(|(row, traction)| row.measure * traction.norm()).sum::<f64>();
    PairEnergy::of_interface(
        tie.bodies,
        (at.energy, at.gradient()),
        (&tie.nodes, &tie.of_b),
        (tie.area, pressed / tie.area),
        tie.left_out.iter().map(|left_out| left_out.warning(tie.bodies, tie.area)).collect(),
    )
}
