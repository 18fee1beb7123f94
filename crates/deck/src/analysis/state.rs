//! What is held and loaded, step after step.

mod borne;
mod fixed;

use super::Bodies;
use super::equations::{self, Eliminated, Equation, Known};
use super::follow::{self, Stage, Values};
use super::levers::Lever;
use super::local_axes;
use super::points::{Asked, Freedom, Point, freedom, points};
use super::references::{Reference, Way, references};
use super::spread::{Faces, faces};
use super::spread_loads::{SpreadLoads, two_amplitudes};
use super::thickness::thickness;
use super::timed::{Timed, When};
use crate::Fault;
use crate::read::{Amplitude, Boundary, Deck, Load, LoadKind, Note, Step};
use fmc_solid::fem::Constraints;
use fmc_solid::statics::{Follower, Rigid};
use std::collections::{BTreeMap, BTreeSet};

/// What holds and drives the bodies.
pub(super) struct Driven<const D: usize> {
    pub(super) supports: Constraints<D>,
    pub(super) forces: Vec<[f64; D]>,
    pub(super) rigid: Rigid<D>,
}

/// Supports and loads during a step.
pub(super) struct State<const D: usize> {
    faces: Faces,
    pub(super) references: Vec<Reference<D>>,
    equations: Vec<Equation>,
    /// What follows by the equations, and reference nodes that turn freely, by their numbers: of the last stage.
    eliminated: Eliminated,
    levers: BTreeMap<usize, Lever<D>>,
    /// Of all bodies; loads on points are divided by it.
    pub(super) thickness: f64,
    /// Rotations of the reference nodes at the end of the last stage.
    turned: Vec<[f64; 3]>,
    supports: Values,
    /// What was held until the step released it: where it starts, if the step holds it again.
    released: Values,
    forces: Values,
    spread: SpreadLoads<D>,
    end: When,
    /// The first node of a solid whose turns a row holds by their numbers, and what is said of it.
    pub(super) left_out: Option<Note>,
}

impl<const D: usize> State<D> {
    /// Before the first step.
    pub(super) fn new(deck: &Deck, bodies: Bodies<D>) -> Result<Self, Fault> {
        let faces = faces(bodies);
        let mut references = references(deck, bodies, &faces)?;
        local_axes::add_local(deck, bodies, &mut references)?;
        equations::add_loose(deck, bodies, &mut references)?;
        let of_axes = equations::of_axes(&references, bodies.model.node_count());
        let equations = [equations::equations(deck, bodies, &references)?, of_axes].into_iter().flatten().collect();
        let mut state = Self {
            faces,
            turned: vec![[0.0; 3]; references.len()],
            equations,
            eliminated: Eliminated::new(),
            levers: BTreeMap::new(),
            references,
            thickness: thickness(deck, D)?,
            supports: BTreeMap::new(),
            released: BTreeMap::new(),
            forces: BTreeMap::new(),
            spread: SpreadLoads::new(),
            end: When { time: 0.0, period: 0.0, begun: 0.0 },
            left_out: None,
        };
        let undeformed = vec![[0.0; D]; bodies.model.node_count()];
        for row in &deck.initial.boundaries {
            if row.is_fixed {
                return Err(Fault::new(
                    row.line,
                    "FIXED of *BOUNDARY stands within a *STEP: it holds nodes where the step finds them",
                ));
            }
            state.hold(deck, bodies, row, &undeformed)?;
        }
        Ok(state)
    }

    /// Faces of the boundary of all bodies.
    pub(super) fn faces(&self) -> &Faces {
        &self.faces
    }

    /// Begins a step at a displacement; what it does not mention stays.
    pub(super) fn begin(
        &mut self,
        deck: &Deck,
        bodies: Bodies<D>,
        step: &Step,
        displacement: &[[f64; D]],
    ) -> Result<(), Fault> {
        let end = self.end;
        let point_values = self.supports.values_mut().chain(self.forces.values_mut()).map(|(value, line)| {
            *line = 0;
            value
        });
        point_values.for_each(|value| value.go_on(end));
        self.spread.begin(end, step.is_new[2]);
        self.released.clear();
        if step.is_new[0] {
            std::mem::swap(&mut self.supports, &mut self.released);
        }
        if step.is_new[1] {
            self.forces.values_mut().for_each(|(value, _)| value.fade(end));
        }
        let begun = end.begun + end.period;
        for row in &step.boundaries {
            self.hold(deck, bodies, row, displacement)?;
        }
        for load in &step.loads {
            self.load(deck, bodies, load)?;
        }
        self.spread.check()?;
        self.end = When { time: step.period, period: step.period, begun };
        let first = bodies.model.node_count();
        if bodies.model.is_axisymmetric() {
            follow::check_rings(&self.references, first, &self.supports, step.line)?;
        }
        follow::check(&self.references, first, &self.supports, (step.line, bodies.places.is_finite))
    }

    /// Times at which stages of the step end: where something bends, and the end.
    pub(super) fn stages(&self) -> Vec<f64> {
        let When { period, begun, .. } = self.end;
        let points = self.supports.values().chain(self.forces.values()).map(|(value, _)| value);
        let values = points.chain(self.spread.values());
        let mut times: Vec<f64> = values.flat_map(|value| value.bends(begun)).collect();
        times.retain(|time| *time > 1e-9 * period && *time < (1.0 - 1e-9) * period);
        times.push(period);
        times.sort_by(f64::total_cmp);
        times.dedup();
        times
    }

    /// Supports, loads and rigid motions at a time of the step: the end of a stage that begins at a displacement.
    ///
    /// # Errors
    /// Equations that cannot hold, and rotations that no node feels.
    pub(super) fn at(
        &mut self,
        deck: &Deck,
        bodies: Bodies<D>,
        time: f64,
        displacement: &[[f64; D]],
    ) -> Result<Driven<D>, Fault> {
        let (when, first) = (When { time, ..self.end }, bodies.model.node_count());
        let (mut supports, mut rigid) = (Constraints::default(), Rigid::default());
        for (&(node, axis), (value, _)) in self.supports.range(..(first, 0)) {
            supports.prescribe([node], axis, value.at(when));
        }
        let stage = Stage { bodies, first, when, displacement };
        self.levers.clear();
        for (number, (reference, turned)) in self.references.iter().zip(&mut self.turned).enumerate() {
            let lever = stage.add((number, reference), &self.supports, turned, (&mut supports, &mut rigid))?;
            lever.into_iter().for_each(|lever| drop(self.levers.insert(number, lever)));
        }
        self.eliminate((deck, bodies), when, (&supports, &mut rigid))?;
        let mut forces = vec![[0.0; D]; first];
        for (&(place, axis), (value, _)) in &self.forces {
            let value = value.at(when) / self.thickness;
            let number = place.checked_sub(first);
            match number.map(|number| &self.references[number]) {
                None => forces[place][axis] += value,
                Some(Reference { way: Way::Loose(_) | Way::Local(_), .. }) => {
                    let followed = self.eliminated.get(&(place, axis)).into_iter().flatten();
                    let of_model = followed.filter(|((place, _), _)| *place < first);
                    of_model.for_each(|(&(node, axis), weight)| forces[node][axis] += weight * value);
                }
                Some(_) if number.is_some_and(|number| self.levers.contains_key(&number)) => {
                    let lever = number.and_then(|number| self.levers.get(&number));
                    let loads = lever.into_iter().flat_map(|lever| lever.load(axis, value));
                    loads.for_each(|(node, axis, force)| forces[node][axis] += force);
                }
                Some(Reference { way: Way::Shares(shares), nodes, .. }) => {
                    for (&node, share) in nodes.iter().zip(shares[axis].iter().flatten()) {
                        (0..D).for_each(|k| forces[node][k] += value * share[k]);
                    }
                }
                // Its nodes move as one: what is on one of them is on all. Its moments its supports bear.
                Some(reference) if axis < D => forces[reference.nodes[0]][axis] += value,
                Some(_) => {}
            }
        }
        self.spread.add_forces(when, &mut forces);
        Ok(Driven { supports, forces, rigid })
    }

    /// What follows by the equations at a time, and how.
    fn eliminate(
        &mut self,
        (deck, bodies): (&Deck, Bodies<D>),
        when: When,
        (supports, rigid): (&Constraints<D>, &mut Rigid<D>),
    ) -> Result<(), Fault> {
        if self.equations.is_empty() {
            return Ok(());
        }
        let first = bodies.model.node_count();
        let of_nodes: BTreeMap<Freedom, f64> =
            supports.iter().map(|(node, axis, value)| ((node, axis), value)).collect();
        let held = |freedom: Freedom| match freedom.0 < first {
            true => of_nodes.get(&freedom).copied(),
            false => self.supports.get(&freedom).map(|(value, _)| value.at(when)),
        };
        let joined = rigid.joined.iter().flatten().copied();
        let led: BTreeSet<usize> = joined.chain(rigid.followers.iter().map(|f| f.freedom)).collect();
        let leads: BTreeSet<usize> = rigid.followers.iter().flat_map(|f| f.of.iter().map(|(of, _)| *of)).collect();
        let is_led = |(place, axis): Freedom| {
            let freedom = place * D + axis;
            place < first && (led.contains(&freedom) || leads.contains(&freedom))
        };
        let label = |place: usize| match place.checked_sub(first) {
            None => deck.mesh.node_tags[bodies.places.nodes[place]],
            Some(number) => self.references[number].label,
        };
        let known = Known { first, held: &held, is_led: &is_led, label: &label };
        let eliminated = equations::eliminated(&self.equations, &known)?;
        for (&(place, axis), followed) in eliminated.range(..(first, 0)) {
            let of = followed.range(..(first, 0)).map(|(&(node, axis), &weight)| (node * D + axis, weight));
            let loose = followed.range((first, 0)..);
            let apart = loose.map(|(&freedom, weight)| weight * held(freedom).unwrap_or(0.0)).sum();
            rigid.followers.push(Follower { freedom: place * D + axis, of: of.collect(), apart: Some(apart) });
        }
        self.eliminated = eliminated;
        Ok(())
    }

    /// Nodes and axes that do not move in this step.
    pub(super) fn held(&self, bodies: Bodies<D>) -> BTreeSet<(usize, usize)> {
        let first = bodies.model.node_count();
        let at_rest = self.supports.range(..(first, 0)).filter(|(_, (value, _))| value.is_zero());
        let following = follow::at_rest(&self.references, first, &self.supports);
        at_rest.map(|(place, _)| *place).chain(following).collect()
    }

    /// Time since the first step began.
    pub(super) fn total_time(&self, time: f64) -> f64 {
        self.end.begun + time
    }

    fn hold(&mut self, deck: &Deck, bodies: Bodies<D>, row: &Boundary, displacement: &[[f64; D]]) -> Result<(), Fault> {
        let amplitude = amplitude(deck, row.amplitude.as_ref(), row.line)?;
        let asked = Asked { line: row.line, is_motion: true, is_named: row.is_named, value: row.value };
        for point in points(deck, bodies, &self.references, (&row.set, row.line))? {
            for axis in row.axes[0]..=row.axes[1] {
                let place = freedom((deck, bodies), &self.references, (point, axis), &asked)?;
                let Some(place) = place else {
                    self.leave_out((deck, bodies), (point, axis), row);
                    continue;
                };
                let fixed = row.is_fixed.then(|| self.reached(bodies, place, displacement));
                let before = self.supports.get(&place).or_else(|| self.released.get(&place));
                let start = before.map_or(0.0, |(value, _)| value.first(self.end));
                let value = Timed::new(fixed.unwrap_or(start), fixed.unwrap_or(row.value), amplitude.clone());
                let now = self.supports.get(&place).filter(|(_, line)| *line != 0);
                if let Some((_, line)) = now.filter(|(other, _)| !other.goes_with(&value)) {
                    let label = match point {
                        Point::Node(node) => deck.mesh.node_tags[bodies.places.nodes[node]],
                        Point::Reference(number) | Point::Rotating(number) => self.references[number].label,
                    };
                    let text = format!(
                        "node {label} is moved elsewhere along axis {} by line {line} in the same step",
                        place.1 + 1
                    );
                    return Err(Fault::new(row.line, text));
                }
                self.supports.insert(place, (value, row.line));
            }
        }
        Ok(())
    }

    /// Says once that nodes of solids do not turn, where a row does not name its degrees of freedom by a word.
    fn leave_out(&mut self, (deck, bodies): (&Deck, Bodies<D>), (point, axis): (Point, usize), row: &Boundary) {
        if let (Point::Node(node), 3..) = (point, axis)
            && !row.is_named
            && self.left_out.is_none()
        {
            let label = deck.mesh.node_tags[bodies.places.nodes[node]];
            let message =
                format!("degrees of freedom 4 to 6 of nodes of solids, as {label}, are left out: these do not turn");
            self.left_out = Some(Note { line: row.line, message });
        }
    }

    fn load(&mut self, deck: &Deck, bodies: Bodies<D>, load: &Load) -> Result<(), Fault> {
        let amplitude = amplitude(deck, load.amplitude.as_ref(), load.line)?;
        let LoadKind::Force(axis) = load.kind else {
            return self.spread.add((deck, bodies, &self.faces), load, amplitude, self.end);
        };
        let asked = Asked { line: load.line, is_motion: false, is_named: false, value: load.value };
        for point in points(deck, bodies, &self.references, (&load.set, load.line))? {
            let place = freedom((deck, bodies), &self.references, (point, axis), &asked)?;
            let Some(place) = place else { continue };
            // Loads of one step add up, and take the place of those of earlier ones.
            match self.forces.get_mut(&place) {
                Some((value, line)) if *line != 0 => {
                    if !value.increase(load.value, amplitude.as_ref()) {
                        return Err(two_amplitudes(load, *line));
                    }
                }
                before => {
                    let start = before.map_or(0.0, |(value, _)| value.first(self.end));
                    self.forces.insert(place, (Timed::new(start, load.value, amplitude.clone()), load.line));
                }
            }
        }
        Ok(())
    }
}

fn amplitude(deck: &Deck, name: Option<&String>, line: usize) -> Result<Option<Amplitude>, Fault> {
    let Some(name) = name else { return Ok(None) };
    let found = deck.amplitudes.get(name).cloned();
    found.map(Some).ok_or_else(|| Fault::new(line, format!("there is no amplitude '{name}'")))
}
