//! The ties of a contact.

use crate::Error;
use crate::contact::held::{At, Finder, Found, Held, HeldList, Key};
use crate::contact::laws::PairEnergy;
use crate::contact::mesh::Mesh;
use crate::contact::tangents::TangentPart;
use crate::geometry::{Vector, Weighting};
use crate::interfaces::{Between, Curvature, HeldFacets, Tie, TieAt, TieRow};
use crate::overlap::{Block, Partner};
use std::collections::BTreeMap;

/// Ties by pair of bodies, ascending.
pub(crate) type Ties<const D: usize> = HeldList<Tie<D>, D>;

/// What is kept of a tie beside what was found.
pub(crate) struct TieKept<const D: usize> {
    /// Tractions that need no jump, by row; none at first.
    pub(crate) multipliers: Vec<Vector<D>>,
    /// That of the tie, also after it was found anew.
    jump: Vector<D>,
    /// −1 where a host's first part is that of the second body.
    sign: f64,
}

impl<const D: usize> Default for TieKept<D> {
    fn default() -> Self {
        Self { multipliers: Vec::new(), jump: Vector::zeros(), sign: 1.0 }
    }
}

impl<const D: usize> Held<Tie<D>, TieKept<D>> {
    fn bring_jump(&mut self) {
        if let Ok(tie) = &mut self.found {
            tie.jump = self.kept.jump;
        }
    }
}

impl<const D: usize> Found<D> for Tie<D> {
    const FINDER: Finder<Self, D> = Self::new;
    type Kept = TieKept<D>;
    type There<'a> = TieAt<'a, D>;

    fn facets(&self) -> &HeldFacets {
        &self.facets
    }

    fn there(&self, kept: &TieKept<D>, at: At<D>) -> Result<TieAt<'_, D>, Error> {
        Ok(self.at(at.points, (at.stiffness)(self.bodies.map(Partner::Body)), &kept.multipliers))
    }

    fn pair_energy(&self, at: &TieAt<'_, D>) -> PairEnergy<D> {
        let rows = self.rows.iter().zip(&at.tractions);
        let pressed = rows.map(|(row, traction)| row.measure * traction.norm()).sum::<f64>();
        PairEnergy::of_interface(
            self.bodies,
            (at.energy, at.gradient()),
            (&self.nodes, &self.of_b),
            (self.area, pressed / self.area),
            self.left_out.iter().map(|left_out| left_out.warning(self.bodies, self.area)).collect(),
        )
    }

    fn blocks(at: &TieAt<'_, D>, part: TangentPart) -> Vec<Block<D>> {
        at.curvature(part.into())
    }
}

impl From<TangentPart> for Curvature {
    fn from(part: TangentPart) -> Self {
        if part == TangentPart::Semidefinite { Self::Semidefinite } else { Self::All }
    }
}

/// Multipliers by tie, and row.
pub(crate) type TieMultipliers<const D: usize> = BTreeMap<Key, Vec<Vector<D>>>;

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
    /// The largest jump where supports hold both sides.
    pub(crate) held_apart: Option<HeldApart>,
}

/// Where supports hold what is tied apart, and how far.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HeldApart {
    pub(crate) bodies: [usize; 2],
    pub(crate) point: u32,
    pub(crate) jump: f64,
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

    /// Adds a jump where supports hold both sides.
    pub(crate) fn tell_held_apart(&mut self, one: HeldApart) {
        if one.jump > self.held_apart.map_or(0.0, |found| found.jump) {
            self.held_apart = Some(one);
        }
    }

    /// Those of others too.
    pub(crate) fn and(mut self, other: Self) -> Self {
        self.largest = self.largest.max(other.largest);
        self.mean_of_others = self.mean_of_others.max(other.mean());
        self.of_each.extend(other.of_each);
        other.held_apart.into_iter().for_each(|one| self.tell_held_apart(one));
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
        let kept = TieKept { sign, ..TieKept::default() };
        self.hold((between.bodies, number), between, kept, (mesh, weighting))?;
        self.added = number;
        Ok(number)
    }

    /// The place of a tie that was added and not removed.
    fn added(&self, number: usize) -> Result<Key, Error> {
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
            held.kept.jump = jump * held.kept.sign;
            held.bring_jump();
        }
        Ok(())
    }

    /// A tie that was added, with its multipliers, and the sign of its jump and force as a host has them.
    pub(crate) fn of_number(&self, number: usize) -> Result<(&Tie<D>, &[Vector<D>], f64), Error> {
        let (tie, kept) = self.held[&self.added(number)?].get()?;
        Ok((tie, &kept.multipliers, kept.sign))
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
        for held in self.held.values_mut() {
            (held.found, held.kept.multipliers) = (Tie::find((mesh, weighting), &held.between), Vec::new());
            held.bring_jump();
        }
    }

    /// Whether bodies are tied to any other.
    pub(crate) fn tied_bodies(&self, body_count: usize) -> Vec<bool> {
        let holds = |body, bodies: &[usize; 2]| bodies.contains(&body) && bodies[0] != bodies[1];
        (0..body_count).map(|body| self.held.keys().any(|(bodies, _)| holds(body, bodies))).collect()
    }

    /// What an update would change at these points, and the multipliers after it: the tractions there are, but where supports hold both sides. With the
    /// stiffness of a pair comes whether it was given.
    pub(crate) fn change(
        &self,
        points: &[[f64; D]],
        stiffness: impl Fn([Partner; 2]) -> (f64, bool),
        is_held: impl Fn(u32, usize) -> bool,
    ) -> Result<(TieChange, TieMultipliers<D>), Error> {
        let (mut found, mut next) = (TieChange::default(), TieMultipliers::new());
        for (key, held) in &self.held {
            let (tie, kept) = held.get()?;
            let (stiffness, is_given) = stiffness(tie.bodies.map(Partner::Body));
            let TieAt { jumps, mut tractions, .. } = tie.at(points, stiffness, &kept.multipliers);
            let supported = tie.follow(&is_held, &kept.multipliers, &mut tractions);
            let before = |row: usize| kept.multipliers.get(row).copied().unwrap_or_else(Vector::zeros);
            let row = |(number, row): (usize, &TieRow<D>)| {
                let is_supported = |axes: &[bool; D]| axes.contains(&true);
                let change = match supported.get(number).filter(|axes| is_supported(axes)) {
                    Some(axes) => {
                        let apart = (0..D).filter(|&axis| axes[axis]).map(|axis| jumps[number][axis].abs());
                        let jump = apart.fold(0.0, f64::max);
                        found.tell_held_apart(HeldApart { bodies: tie.bodies, point: row.point, jump });
                        // Supports have the jump; an update changes the traction alone.
                        (tractions[number] - before(number)).norm() / stiffness
                    }
                    None => jumps[number].norm(),
                };
                [row.measure, change, tractions[number].norm()]
            };
            let rows: Vec<_> = tie.rows.iter().enumerate().map(row).collect();
            found.add((stiffness, is_given), rows.into_iter());
            next.insert(*key, tractions);
        }
        Ok((found, next))
    }

    pub(crate) fn have_multipliers(&self) -> bool {
        self.held.values().any(|held| !held.kept.multipliers.is_empty())
    }

    /// The multipliers of all, to be put back by [`Self::put_back`].
    pub(crate) fn multipliers(&self) -> TieMultipliers<D> {
        self.held.iter().map(|(key, held)| (*key, held.kept.multipliers.clone())).collect()
    }

    /// Leaves a part of them.
    pub(crate) fn scale_multipliers(&mut self, part: f64) {
        self.held.values_mut().flat_map(|held| &mut held.kept.multipliers).for_each(|traction| *traction *= part);
    }

    pub(crate) fn put_back(&mut self, mut multipliers: TieMultipliers<D>) {
        for (key, held) in &mut self.held {
            held.kept.multipliers = multipliers.remove(key).unwrap_or_default();
        }
    }
}
