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
pub(crate) struct Ties<const D: usize> {
    held: BTreeMap<TieKey, Held<D>>,
    /// How many were ever added beside the options of pairs.
    added: usize,
}

/// Two bodies and the number of a tie that was added between them; 0 for that of the options of their pair.
pub(crate) type TieKey = ([usize; 2], usize);

struct Held<const D: usize> {
    between: Between,
    /// As the mesh is without deformation; an error is that of every evaluation.
    tie: Result<Tie<D>, Error>,
    /// Tractions that need no jump, by row; none at first.
    multipliers: Vec<Vector<D>>,
    /// That of the tie, also after it was found anew.
    jump: Vector<D>,
    /// −1 where a host's first part is that of the second body.
    sign: f64,
}

impl<const D: usize> Held<D> {
    fn find(&mut self, mesh: &Mesh<D>, weighting: Weighting) {
        (self.tie, self.multipliers) = (found(mesh, weighting, &self.between), Vec::new());
        self.bring_jump();
    }

    fn bring_jump(&mut self) {
        if let Ok(tie) = &mut self.tie {
            tie.jump = self.jump;
        }
    }
}

/// Multipliers by tie, and row.
pub(crate) type TieMultipliers<const D: usize> = BTreeMap<TieKey, Vec<Vector<D>>>;

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
        self.held.is_empty()
    }

    /// Ties two bodies as the options of their pair say, or releases them with `None`.
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
        let key = (bodies, 0);
        let Some(between) = between else {
            self.held.remove(&key);
            return Ok(());
        };
        if self.held.get(&key).is_some_and(|held| held.between == between && held.tie.is_ok()) {
            return Ok(());
        }
        self.hold(key, between, mesh, weighting)
    }

    /// Adds a tie beside those of the options of pairs; returns its number, from 1.
    ///
    /// # Errors
    /// Those of [`Tie::new`].
    pub(crate) fn add(
        &mut self,
        between: Between,
        mesh: &Mesh<D>,
        weighting: Weighting,
        sign: f64,
    ) -> Result<usize, Error> {
        let number = self.added + 1;
        let key = (between.bodies, number);
        self.hold(key, between, mesh, weighting)?;
        self.held.entry(key).and_modify(|held| held.sign = sign);
        self.added = number;
        Ok(number)
    }

    fn hold(&mut self, key: TieKey, between: Between, mesh: &Mesh<D>, weighting: Weighting) -> Result<(), Error> {
        let tie = found(mesh, weighting, &between)?;
        self.held
            .insert(key, Held { between, tie: Ok(tie), multipliers: Vec::new(), jump: Vector::zeros(), sign: 1.0 });
        Ok(())
    }

    /// The place of a tie that was added and not removed.
    fn added(&self, number: usize) -> Result<TieKey, Error> {
        let found = self.held.keys().find(|(_, added)| *added == number && number > 0);
        found.copied().ok_or(Error::NoSuchNumber { array: "ties", entry: 0, number: [number, self.added] })
    }

    /// Removes one that was added.
    pub(crate) fn remove(&mut self, number: usize) -> Result<(), Error> {
        let key = self.added(number)?;
        self.held.remove(&key);
        Ok(())
    }

    /// Has the first body of a tie that was added be so far from the second.
    pub(crate) fn set_jump(&mut self, number: usize, jump: Vector<D>) -> Result<(), Error> {
        let key = self.added(number)?;
        if let Some(held) = self.held.get_mut(&key) {
            held.jump = jump * held.sign;
            held.bring_jump();
        }
        Ok(())
    }

    /// A tie that was added, with its multipliers, and the sign of its jump and force as a host has them.
    pub(crate) fn of_number(&self, number: usize) -> Result<(&Tie<D>, &[Vector<D>], f64), Error> {
        let held = &self.held[&self.added(number)?];
        held.tie.as_ref().map(|tie| (tie, &held.multipliers[..], held.sign)).map_err(Error::clone)
    }

    /// Whether two bodies have a tie that was added, and whose faces lie on one another.
    pub(crate) fn has_added_on(&self, bodies: [usize; 2]) -> bool {
        self.held.iter().any(|((own, added), held)| *own == bodies && *added > 0 && held.between.period == [0.0; 3])
    }

    /// Whether any was added.
    pub(crate) fn has_added(&self) -> bool {
        self.held.keys().any(|(_, added)| *added > 0)
    }

    /// Finds them anew, on another mesh without deformation.
    pub(crate) fn find_again(&mut self, mesh: &Mesh<D>, weighting: Weighting) {
        self.held.values_mut().for_each(|held| held.find(mesh, weighting));
    }

    /// All of them, with their multipliers.
    ///
    /// # Errors
    /// Of a tie that is no longer there, since the mesh without deformation has changed.
    pub(crate) fn all(&self) -> impl Iterator<Item = Result<(&Tie<D>, &[Vector<D>]), Error>> {
        self.keyed().map(|(_, held)| held)
    }

    /// Those of the options of pairs alone.
    pub(crate) fn of_pairs(&self) -> impl Iterator<Item = Result<(&Tie<D>, &[Vector<D>]), Error>> {
        self.keyed().filter(|((_, added), _)| *added == 0).map(|(_, held)| held)
    }

    fn keyed(&self) -> impl Iterator<Item = (TieKey, Result<(&Tie<D>, &[Vector<D>]), Error>)> {
        self.held.iter().map(|(key, held)| match &held.tie {
            Ok(tie) => (*key, Ok((tie, &held.multipliers[..]))),
            Err(error) => (*key, Err(error.clone())),
        })
    }

    /// Whether bodies are tied to any other.
    pub(crate) fn tied_bodies(&self, body_count: usize) -> Vec<bool> {
        let holds = |body, bodies: &[usize; 2]| bodies.contains(&body) && bodies[0] != bodies[1];
        (0..body_count).map(|body| self.held.keys().any(|(bodies, _)| holds(body, bodies))).collect()
    }

    /// Facets that are tied of pairs of which parts alone are to be, by their options.
    pub(crate) fn facets(&self) -> impl Iterator<Item = ([usize; 2], &HeldFacets)> {
        let of_pairs = self.held.iter().filter(|((_, added), _)| *added == 0).map(|(_, held)| held);
        let in_part = of_pairs.filter(|held| held.between.facets.is_some());
        in_part.filter_map(|held| held.tie.as_ref().ok().map(|tie| (held.between.bodies, &tie.facets)))
    }

    /// The tie of two bodies by the options of their pair.
    pub(crate) fn of(&self, bodies: [usize; 2]) -> Option<Result<&Tie<D>, Error>> {
        self.held.get(&(bodies, 0)).map(|held| held.tie.as_ref().map_err(Error::clone))
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
        for (key, held) in self.keyed() {
            let (tie, multipliers) = held?;
            let (stiffness, is_given) = stiffness(tie.bodies.map(Partner::Body));
            let at = tie.at(points, stiffness, multipliers);
            let rows = tie.rows.iter().zip(at.jumps.iter().zip(&at.tractions));
            found.add(
                (stiffness, is_given),
                rows.map(|(row, (jump, traction))| [row.measure, jump.norm(), traction.norm()]),
            );
            next.insert(key, at.tractions);
        }
        Ok((found, next))
    }

    pub(crate) fn have_multipliers(&self) -> bool {
        self.held.values().any(|held| !held.multipliers.is_empty())
    }

    /// The multipliers of all, to be put back by [`Self::put_back`].
    pub(crate) fn multipliers(&self) -> TieMultipliers<D> {
        self.held.iter().map(|(key, held)| (*key, held.multipliers.clone())).collect()
    }

    /// Leaves a part of them.
    pub(crate) fn scale_multipliers(&mut self, part: f64) {
        self.held.values_mut().flat_map(|held| &mut held.multipliers).for_each(|traction| *traction *= part);
    }

    pub(crate) fn put_back(&mut self, mut multipliers: TieMultipliers<D>) {
        for (key, held) in &mut self.held {
            held.multipliers = multipliers.remove(key).unwrap_or_default();
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
