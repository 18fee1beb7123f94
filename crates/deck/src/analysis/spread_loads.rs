//! Loads on faces and volumes during a step.

use super::Bodies;
use super::spread::{Faces, spread};
use super::timed::{Timed, When};
use crate::Fault;
use crate::read::{Amplitude, Deck, Load, LoadKind};
use std::collections::{BTreeMap, BTreeSet};

/// A load on faces or volumes, of one set.
struct SpreadLoad<const D: usize> {
    /// Its line in this step; 0: of an earlier step.
    line: usize,
    value: Timed,
    forces: Vec<[f64; D]>,
    faces: BTreeSet<Vec<u32>>,
    /// The set on which it acts as gravity.
    pulled: Option<String>,
}

/// All loads on faces and volumes, by kind and set.
pub(super) struct SpreadLoads<const D: usize>(BTreeMap<String, SpreadLoad<D>>);

impl<const D: usize> SpreadLoads<D> {
    /// None.
    pub(super) fn new() -> Self {
        Self(BTreeMap::new())
    }

    /// What goes on in the step after one that ends, or fades in it.
    pub(super) fn begin(&mut self, end: When, is_new: bool) {
        for load in self.0.values_mut() {
            load.line = 0;
            load.value.go_on(end);
            if is_new {
                load.value.fade(end);
                load.faces.clear();
            }
        }
    }

    /// Adds a load: in the place of one of an earlier step on the same set, and on top of those of the same step.
    ///
    /// # Errors
    /// Names that are not there, faces inside of bodies, two amplitudes of one set, gravity that turns.
    pub(super) fn add(
        &mut self,
        (deck, bodies, faces): (&Deck, Bodies<D>, &Faces),
        load: &Load,
        amplitude: Option<Amplitude>,
        end: When,
    ) -> Result<(), Fault> {
        let key = format!("{:?} {}", load.kind, load.set.to_uppercase());
        let before = self.0.get_mut(&key);
        let start = before.as_ref().map_or(0.0, |before| before.value.first(end));
        if let Some(before) = before.filter(|before| before.line != 0) {
            return match before.value.increase(load.value, amplitude.as_ref()) {
                true => Ok(()),
                false => Err(two_amplitudes(load, before.line)),
            };
        }
        let pulled = matches!(load.kind, LoadKind::Gravity(_)).then(|| load.set.to_uppercase());
        let is_other = |(other, load): (&String, &SpreadLoad<D>)| {
            *other != key && load.line == 0 && load.value.goes_on() && pulled.is_some() && load.pulled == pulled
        };
        if self.0.iter().any(is_other) {
            let message = "gravity of another direction acts since an earlier step: name that direction, or say OP=NEW";
            return Err(Fault::new(load.line, message));
        }
        let new = spread(deck, bodies, faces, load)?;
        let faces = new.faces.into_iter().collect();
        let value = Timed::new(start, load.value, amplitude);
        self.0.insert(key, SpreadLoad { line: load.line, value, forces: new.forces, faces, pulled });
        Ok(())
    }

    /// Of loads that share faces, all are of this step or none is: what is left of an earlier one would be unclear.
    pub(super) fn check(&self) -> Result<(), Fault> {
        for new in self.0.values().filter(|load| load.line != 0) {
            let shares = |old: &&SpreadLoad<D>| old.line == 0 && !old.faces.is_disjoint(&new.faces);
            if self.0.values().any(|old| shares(&old)) {
                let message =
                    "this acts on a face that a load of an earlier step acts on: name the same set, or say OP=NEW";
                return Err(Fault::new(new.line, message));
            }
        }
        Ok(())
    }

    /// Their values over the step.
    pub(super) fn values(&self) -> impl Iterator<Item = &Timed> {
        self.0.values().map(|load| &load.value)
    }

    /// Adds the forces on all nodes at a time.
    pub(super) fn add_forces(&self, when: When, forces: &mut [[f64; D]]) {
        for load in self.0.values() {
            let value = load.value.at(when);
            for (sum, force) in forces.iter_mut().zip(&load.forces) {
                (0..D).for_each(|axis| sum[axis] += value * force[axis]);
            }
        }
    }
}

/// Loads of one step on the same place are one sum, which grows in one way.
pub(super) fn two_amplitudes(load: &Load, first: usize) -> Fault {
    let message =
        format!("line {first} of the same step loads this with another AMPLITUDE: loads that add up need one");
    Fault::new(load.line, message)
}
