//! What is held and loaded, step after step.

use super::Bodies;
use super::follow::{self, Borne, Stage, Values};
use super::points::{Asked, Point, freedom, points};
use super::references::{Reference, Way, references};
use super::spread::{Faces, faces, spread};
use super::thickness::thickness;
use super::timed::{Timed, When};
use crate::Fault;
use crate::read::{Amplitude, Boundary, Deck, Load, LoadKind, Step};
use fmc_solid::fem::Constraints;
use fmc_solid::statics::{Equilibrium, Rigid};
use std::collections::{BTreeMap, BTreeSet};

/// A load on faces or volumes.
struct SpreadLoad<const D: usize> {
    line: usize,
    value: Timed,
    forces: Vec<[f64; D]>,
    faces: BTreeSet<Vec<u32>>,
    /// The set on which it acts as gravity.
    pulled: Option<String>,
}

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
    /// Of all bodies; loads on points are divided by it.
    pub(super) thickness: f64,
    /// Rotations of the reference nodes at the end of the last stage.
    turned: Vec<[f64; 3]>,
    supports: Values,
    /// What was held until the step released it: where it starts, if the step holds it again.
    released: Values,
    forces: Values,
    /// By set and kind.
    spread: BTreeMap<String, SpreadLoad<D>>,
    end: When,
}

impl<const D: usize> State<D> {
    /// Before the first step.
    pub(super) fn new(deck: &Deck, bodies: Bodies<D>) -> Result<Self, Fault> {
        let faces = faces(bodies);
        let references = references(deck, bodies, &faces)?;
        let mut state = Self {
            faces,
            turned: vec![[0.0; 3]; references.len()],
            references,
            thickness: thickness(deck, D)?,
            supports: BTreeMap::new(),
            released: BTreeMap::new(),
            forces: BTreeMap::new(),
            spread: BTreeMap::new(),
            end: When { time: 0.0, period: 0.0, begun: 0.0 },
        };
        for row in &deck.initial.boundaries {
            state.hold(deck, bodies, row)?;
        }
        Ok(state)
    }

    /// Begins a step; what it does not mention stays.
    pub(super) fn begin(&mut self, deck: &Deck, bodies: Bodies<D>, step: &Step) -> Result<(), Fault> {
        let end = self.end;
        let point_values = self.supports.values_mut().chain(self.forces.values_mut()).map(|(value, line)| {
            *line = 0;
            value
        });
        let spread_values = self.spread.values_mut().map(|load| {
            load.line = 0;
            &mut load.value
        });
        point_values.chain(spread_values).for_each(|value| value.go_on(end));
        self.released.clear();
        if step.is_new[0] {
            std::mem::swap(&mut self.supports, &mut self.released);
        }
        if step.is_new[1] {
            self.forces.values_mut().for_each(|(value, _)| value.fade(end));
        }
        if step.is_new[2] {
            self.spread.values_mut().for_each(|load| {
                load.value.fade(end);
                load.faces.clear();
            });
        }
        let begun = end.begun + end.period;
        for row in &step.boundaries {
            self.hold(deck, bodies, row)?;
        }
        for load in &step.loads {
            self.load(deck, bodies, load)?;
        }
        self.end = When { time: step.period, period: step.period, begun };
        let first = bodies.model.node_count();
        follow::check(&self.references, first, &self.supports, (step.line, bodies.places.is_finite))
    }

    /// Times at which stages of the step end: where something bends, and the end.
    pub(super) fn stages(&self) -> Vec<f64> {
        let When { period, begun, .. } = self.end;
        let points = self.supports.values().chain(self.forces.values()).map(|(value, _)| value);
        let values = points.chain(self.spread.values().map(|load| &load.value));
        let mut times: Vec<f64> = values.flat_map(|value| value.bends(begun)).collect();
        times.retain(|time| *time > 1e-9 * period && *time < (1.0 - 1e-9) * period);
        times.push(period);
        times.sort_by(f64::total_cmp);
        times.dedup();
        times
    }

    /// Supports, loads and rigid motions at a time of the step: the end of a stage that begins at a displacement.
    pub(super) fn at(&mut self, bodies: Bodies<D>, time: f64, displacement: &[[f64; D]]) -> Driven<D> {
        let (when, first) = (When { time, ..self.end }, bodies.model.node_count());
        let (mut supports, mut rigid) = (Constraints::default(), Rigid::default());
        for (&(node, axis), (value, _)) in self.supports.range(..(first, 0)) {
            supports.prescribe([node], axis, value.at(when));
        }
        let stage = Stage { bodies, first, when, displacement };
        for (number, (reference, turned)) in self.references.iter().zip(&mut self.turned).enumerate() {
            stage.add((number, reference), &self.supports, turned, (&mut supports, &mut rigid));
        }
        let mut forces = vec![[0.0; D]; first];
        for (&(place, axis), (value, _)) in &self.forces {
            let value = value.at(when) / self.thickness;
            match place.checked_sub(first).map(|number| &self.references[number]) {
                None => forces[place][axis] += value,
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
        for load in self.spread.values() {
            let value = load.value.at(when);
            for (sum, force) in forces.iter_mut().zip(&load.forces) {
                (0..D).for_each(|axis| sum[axis] += value * force[axis]);
            }
        }
        Driven { supports, forces, rigid }
    }

    /// Nodes and axes that do not move in this step.
    pub(super) fn held(&self, bodies: Bodies<D>) -> BTreeSet<(usize, usize)> {
        let first = bodies.model.node_count();
        let at_rest = self.supports.range(..(first, 0)).filter(|(_, (value, _))| value.is_zero());
        let following = follow::at_rest(&self.references, first, &self.supports);
        at_rest.map(|(place, _)| *place).chain(following).collect()
    }

    /// What nodes and reference nodes bear at the end of the step.
    pub(super) fn borne(&self, at: &Equilibrium<D>, is_finite: bool) -> Borne {
        let first = at.model().node_count();
        let one = |(number, reference): (usize, &Reference<D>)| {
            let value = |axis: usize| {
                self.forces.get(&(first + number, axis)).map_or(0.0, |(f, _)| f.at(self.end) / self.thickness)
            };
            follow::result((number, reference), at, (self.turned[number], is_finite), std::array::from_fn(value))
        };
        let results = self.references.iter().enumerate().filter_map(one).collect();
        follow::borne(&self.references, results, at)
    }

    /// Time since the first step began.
    pub(super) fn total_time(&self, time: f64) -> f64 {
        self.end.begun + time
    }

    fn hold(&mut self, deck: &Deck, bodies: Bodies<D>, row: &Boundary) -> Result<(), Fault> {
        let amplitude = amplitude(deck, row.amplitude.as_ref(), row.line)?;
        let asked = Asked { line: row.line, is_motion: true, is_named: row.is_named, value: row.value };
        for point in points(deck, bodies, &self.references, (&row.set, row.line))? {
            for axis in row.axes[0]..=row.axes[1] {
                let place = freedom((deck, bodies), &self.references, (point, axis), &asked)?;
                let Some(place) = place else { continue };
                let before = self.supports.get(&place).or_else(|| self.released.get(&place));
                let start = before.map_or(0.0, |(value, _)| value.first(self.end));
                let value = Timed::new(start, row.value, amplitude.clone());
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

    fn load(&mut self, deck: &Deck, bodies: Bodies<D>, load: &Load) -> Result<(), Fault> {
        let amplitude = amplitude(deck, load.amplitude.as_ref(), load.line)?;
        let twice = |line: usize| Fault::new(load.line, format!("this is loaded by line {line} in the same step"));
        if let LoadKind::Force(axis) = load.kind {
            let asked = Asked { line: load.line, is_motion: false, is_named: false, value: load.value };
            for point in points(deck, bodies, &self.references, (&load.set, load.line))? {
                let place = freedom((deck, bodies), &self.references, (point, axis), &asked)?;
                let Some(place) = place else { continue };
                let before = self.forces.get(&place);
                if let Some((_, line)) = before.filter(|(_, line)| *line != 0) {
                    return Err(twice(*line));
                }
                let start = before.map_or(0.0, |(value, _)| value.first(self.end));
                self.forces.insert(place, (Timed::new(start, load.value, amplitude.clone()), load.line));
            }
            return Ok(());
        }
        let key = format!("{:?} {}", load.kind, load.set.to_uppercase());
        let before = self.spread.get(&key);
        if let Some(before) = before.filter(|before| before.line != 0) {
            return Err(twice(before.line));
        }
        let start = before.map_or(0.0, |before| before.value.first(self.end));
        let pulled = matches!(load.kind, LoadKind::Gravity(_)).then(|| load.set.to_uppercase());
        let is_other = |(other, load): (&String, &SpreadLoad<D>)| {
            *other != key && load.line == 0 && load.value.goes_on() && pulled.is_some() && load.pulled == pulled
        };
        if self.spread.iter().any(is_other) {
            let message = "gravity of another direction acts since an earlier step: name that direction, or say OP=NEW";
            return Err(Fault::new(load.line, message));
        }
        let new = spread(deck, bodies, &self.faces, load)?;
        let faces: BTreeSet<Vec<u32>> = new.faces.into_iter().collect();
        if self.spread.iter().any(|(other, load)| *other != key && !load.faces.is_disjoint(&faces)) {
            let message = "this acts on a face that another load acts on: name the same set, or say OP=NEW";
            return Err(Fault::new(load.line, message));
        }
        let value = Timed::new(start, load.value, amplitude);
        self.spread.insert(key, SpreadLoad { line: load.line, value, forces: new.forces, faces, pulled });
        Ok(())
    }
}

fn amplitude(deck: &Deck, name: Option<&String>, line: usize) -> Result<Option<Amplitude>, Fault> {
    let Some(name) = name else { return Ok(None) };
    let found = deck.amplitudes.get(name).cloned();
    found.map(Some).ok_or_else(|| Fault::new(line, format!("there is no amplitude '{name}'")))
}
