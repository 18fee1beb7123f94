//! What is held and loaded, step after step.

use super::Bodies;
use super::spread::{Faces, faces, spread};
use super::timed::{Timed, When};
use crate::Fault;
use crate::read::{Amplitude, Boundary, Deck, Kind, Load, LoadKind, Step};
use fmc_solid::fem::Constraints;
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

/// Supports and loads during a step.
pub(super) struct State<const D: usize> {
    faces: Faces,
    /// By node and axis, with the line.
    supports: BTreeMap<(usize, usize), (Timed, usize)>,
    /// What was held until the step released it: where it starts, if the step holds it again.
    released: BTreeMap<(usize, usize), (Timed, usize)>,
    forces: BTreeMap<(usize, usize), (Timed, usize)>,
    /// By set and kind.
    spread: BTreeMap<String, SpreadLoad<D>>,
    end: When,
}

impl<const D: usize> State<D> {
    /// Before the first step.
    pub(super) fn new(deck: &Deck, bodies: Bodies<D>) -> Result<Self, Fault> {
        let mut state = Self {
            faces: faces(bodies),
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
        Ok(())
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

    /// Supports and loads at a time of the step.
    pub(super) fn at(&self, time: f64, node_count: usize) -> (Constraints<D>, Vec<[f64; D]>) {
        let when = When { time, ..self.end };
        let mut supports = Constraints::default();
        for (&(node, axis), (value, _)) in &self.supports {
            supports.prescribe([node], axis, value.at(when));
        }
        let mut forces = vec![[0.0; D]; node_count];
        for (&(node, axis), (value, _)) in &self.forces {
            forces[node][axis] += value.at(when);
        }
        for load in self.spread.values() {
            let value = load.value.at(when);
            for (sum, force) in forces.iter_mut().zip(&load.forces) {
                (0..D).for_each(|axis| sum[axis] += value * force[axis]);
            }
        }
        (supports, forces)
    }

    /// Nodes and axes that do not move in this step.
    pub(super) fn held(&self) -> BTreeSet<(usize, usize)> {
        let at_rest = self.supports.iter().filter(|(_, (value, _))| value.is_zero());
        at_rest.map(|(place, _)| *place).collect()
    }

    /// Time since the first step began.
    pub(super) fn total_time(&self, time: f64) -> f64 {
        self.end.begun + time
    }

    fn hold(&mut self, deck: &Deck, bodies: Bodies<D>, row: &Boundary) -> Result<(), Fault> {
        let amplitude = amplitude(deck, row.amplitude.as_ref(), row.line)?;
        for node in nodes(deck, bodies, &row.set, row.line)? {
            for axis in row.axes[0]..=row.axes[1] {
                if axis >= D {
                    // Planes have no third axis; to hold it is no error.
                    if row.value != 0.0 {
                        return Err(Fault::new(row.line, "there is no third degree of freedom in 2D"));
                    }
                    continue;
                }
                let before = self.supports.get(&(node, axis)).or_else(|| self.released.get(&(node, axis)));
                let start = before.map_or(0.0, |(value, _)| value.first(self.end));
                let value = Timed::new(start, row.value, amplitude.clone());
                let now = self.supports.get(&(node, axis)).filter(|(_, line)| *line != 0);
                if let Some((_, line)) = now.filter(|(other, _)| !other.goes_with(&value)) {
                    let label = deck.mesh.node_tags[bodies.places.nodes[node]];
                    let text = format!(
                        "node {label} is moved elsewhere along axis {} by line {line} in the same step",
                        axis + 1
                    );
                    return Err(Fault::new(row.line, text));
                }
                self.supports.insert((node, axis), (value, row.line));
            }
        }
        Ok(())
    }

    fn load(&mut self, deck: &Deck, bodies: Bodies<D>, load: &Load) -> Result<(), Fault> {
        let amplitude = amplitude(deck, load.amplitude.as_ref(), load.line)?;
        let twice = |line: usize| Fault::new(load.line, format!("this is loaded by line {line} in the same step"));
        if let LoadKind::Force(axis) = load.kind {
            for node in nodes(deck, bodies, &load.set, load.line)? {
                if axis >= D {
                    return Err(Fault::new(load.line, "there is no third degree of freedom in 2D"));
                }
                let before = self.forces.get(&(node, axis));
                if let Some((_, line)) = before.filter(|(_, line)| *line != 0) {
                    return Err(twice(*line));
                }
                let start = before.map_or(0.0, |(value, _)| value.first(self.end));
                self.forces.insert((node, axis), (Timed::new(start, load.value, amplitude.clone()), load.line));
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

/// Nodes of the model of a set, ascending.
pub(super) fn nodes<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    set: &str,
    line: usize,
) -> Result<Vec<usize>, Fault> {
    let model_node = |node: usize| {
        let label = deck.mesh.node_tags[node];
        bodies.places.node_of[node]
            .ok_or_else(|| Fault::new(line, format!("node {label} of '{set}' belongs to no element")))
    };
    let found: Result<Vec<usize>, Fault> =
        deck.names.find(Kind::Node, None, set, line)?.into_iter().map(model_node).collect();
    let mut found = found?;
    found.sort_unstable();
    Ok(found)
}
