//! Equilibria of all steps.

use super::pairs::{Pairs, adjustment, check_surfaces, pairs, stiffness};
use super::points::{Point, points};
use super::references::Way;
use super::result::StepResult;
use super::state::{Driven, State};
use super::symmetry::planes;
use super::{Bodies, Places, mesh_faults, outside, variants};
use crate::Fault;
use crate::read::{Deck, Note};
use fmc_contact::contact::PairOptions;
use fmc_contact::{EnergyLaw, Options};
use fmc_solid::fem::Model;
use fmc_solid::statics::{Equilibrium, Iteration, NewtonSettings, Path, Problem, StaticsError};
use std::collections::BTreeSet;
use std::ops::ControlFlow;

/// How a file is solved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SolveOptions {
    /// Threads; results do not depend on them.
    pub threads: usize,
    /// Residual by the forces.
    pub tolerance: f64,
    /// Largest mean penetration of a node, a length; 0: as small as the forces need it.
    pub penetration: f64,
}

impl Default for SolveOptions {
    fn default() -> Self {
        Self { threads: 1, tolerance: 1e-9, penetration: 0.0 }
    }
}

/// A file with its bodies, ready to be solved in `D` dimensions.
pub struct Analysis<'a, const D: usize> {
    deck: &'a Deck,
    model: Model<D>,
    places: Places,
    state: State<D>,
    pairs: Pairs,
    /// Node sets whose reactions are asked for.
    sets: Vec<(String, Vec<Point>)>,
    /// Pressure by penetration; 0: found by the search.
    stiffness: f64,
    /// See [`Problem::symmetry_planes`] and [`Problem::adjust`].
    planes: Vec<[[f64; D]; 2]>,
    adjust: Option<[f64; 2]>,
    options: SolveOptions,
    /// Where the nodes and cells of the model stand in the file: nodes, then cells, then reference nodes that are none of the model.
    pub order: [Vec<usize>; 3],
    /// What is taken in another sense than the file may mean.
    pub notes: Vec<Note>,
}

/// How it ended.
#[derive(Debug)]
pub enum Solved {
    /// All steps are solved.
    Finished,
    /// It was asked to stop in this step, from 1.
    Interrupted(usize),
    /// A step, from 1, has no equilibrium, or none was found.
    Failed(usize, StaticsError),
}

impl<'a, const D: usize> Analysis<'a, D> {
    /// Bodies, pairs and supports of a file.
    ///
    /// # Errors
    /// What the file names and does not have, and what is not solved.
    pub fn new(deck: &'a Deck, options: SolveOptions) -> Result<Self, Fault> {
        let stiffness = stiffness(deck, options.penetration)?.unwrap_or(0.0);
        let (places, model) = Places::with_model::<D>(deck, options.threads)?;
        let bodies = Bodies { model: &model, places: &places };
        check_surfaces(deck)?;
        let pairs = pairs(deck, bodies)?;
        let mut state = State::new(deck, bodies)?;
        // Every step is read once before the first is solved: a wrong name in the last is known at once.
        let mut held: Option<BTreeSet<(usize, usize)>> = None;
        for step in &deck.steps {
            let undeformed = vec![[0.0; D]; bodies.model.node_count()];
            state.begin(deck, bodies, step, &undeformed)?;
            for time in state.stages() {
                state.at(deck, bodies, time, &undeformed)?;
            }
            let now = state.held(bodies);
            held = Some(held.map_or(now.clone(), |before| before.intersection(&now).copied().collect()));
        }
        let held = held.unwrap_or_default();
        let planes = planes(bodies, &held);
        let free_on_axis = on_axis(deck, bodies, &held);
        let adjust = adjustment(deck, bodies)?;
        let left_out = state.left_out;
        let state = State::new(deck, bodies)?;
        let sets = deck.reactions.iter().map(|(set, line)| {
            let all = points(deck, bodies, &state.references, (set, *line))?;
            // Reactions are along the axes of the space.
            let of_model = |point: Point| match point {
                Point::Reference(number) => match state.references[number].way {
                    Way::Local(_) => Point::Node(state.references[number].nodes[0]),
                    _ => point,
                },
                _ => point,
            };
            Ok((set.clone(), all.into_iter().map(of_model).collect()))
        });
        let sets = sets.collect::<Result<_, Fault>>()?;
        let apart = state.references.iter().filter(|reference| reference.own.is_none() && reference.has_motion());
        let order = [places.nodes.clone(), places.cells.clone(), apart.map(|reference| reference.node).collect()];
        let notes =
            [&pairs.notes[..], free_on_axis.as_slice(), left_out.as_slice(), &variants::notes(deck, bodies)].concat();
        let notes = super::notes::notes(deck, &notes, places.is_finite)?;
        Ok(Self { deck, model, places, state, pairs, sets, stiffness, planes, adjust, options, order, notes })
    }

    /// Number of steps.
    pub fn step_count(&self) -> usize {
        self.deck.steps.len()
    }

    /// Solves all steps. `watch` is called after every iteration and may stop it; `reached` at the end of each step.
    ///
    /// # Errors
    /// If results cannot be taken, or the problem is none.
    pub fn solve(
        mut self,
        watch: &mut dyn FnMut(usize, &Iteration) -> ControlFlow<()>,
        reached: &mut dyn FnMut(&Equilibrium<D>, StepResult) -> anyhow::Result<()>,
    ) -> anyhow::Result<Solved> {
        let start = Start {
            pairs: self.pairs.options.iter().map(|(pair, options)| (*pair, *options)).collect(),
            surfaces: self.pairs.surfaces.clone(),
            stiffness: self.stiffness,
            planes: self.planes,
            adjust: self.adjust,
            options: self.options,
        };
        let label = |node: usize| self.places.nodes.get(node).map_or(0, |&node| self.deck.mesh.node_tags[node]);
        let undeformed = vec![[0.0; D]; self.model.node_count()];
        let mut largest_force: f64 = 0.0;
        let mut kept = Kept::Model(self.model);
        for (number, step) in self.deck.steps.iter().enumerate() {
            let bodies = Bodies { model: kept.model(), places: &self.places };
            self.state.begin(self.deck, bodies, step, kept.displacement().unwrap_or(&undeformed))?;
            let (mut before, mut taken, mut halvings) = (0.0, 0, kept.halvings());
            for time in self.state.stages() {
                let bodies = Bodies { model: kept.model(), places: &self.places };
                let driven = self.state.at(self.deck, bodies, time, kept.displacement().unwrap_or(&undeformed));
                let driven = driven.map_err(|fault| anyhow::anyhow!(self.deck.located(&fault)))?;
                let mut at = match kept {
                    Kept::Model(model) => {
                        let names: Vec<String> = model.parts().iter().map(|part| part.name.clone()).collect();
                        let found = start.equilibrium(model, driven);
                        found.map_err(|error| match wrong(&error, (self.deck, &self.places), &self.pairs, &names) {
                            Some(fault) => anyhow::anyhow!(self.deck.located(&fault)),
                            None => error.into(),
                        })?
                    }
                    Kept::Equilibrium(mut at) => {
                        at.next_step(driven.supports, driven.forces, driven.rigid)?;
                        *at
                    }
                };
                let steps = ((time - before) / step.period * step.count as f64 - 1e-9).ceil().max(1.0) as usize;
                let path = Path { steps, most_halvings: step.most_halvings };
                match at.follow(path, &mut |iteration| watch(number + 1, iteration)) {
                    Ok(()) => {}
                    Err(StaticsError::Interrupted) => return Ok(Solved::Interrupted(number + 1)),
                    Err(error) => {
                        let error = unheld(error, &at, &self.pairs);
                        return Ok(Solved::Failed(number + 1, in_labels(error, self.deck, &self.places)));
                    }
                }
                before = time;
                largest_force = largest_force.max(at.balance().scale);
                // Each halving makes one load step more, at least.
                taken += steps + at.halvings - halvings;
                halvings = at.halvings;
                if time == step.period {
                    let when = (number + 1, self.state.total_time(time));
                    let borne = self.state.borne(&at, self.places.is_finite);
                    let mut result = StepResult::new(&at, when, largest_force, &self.sets, borne, &label)?
                        .of_thickness(self.state.thickness);
                    let bodies = Bodies { model: at.model(), places: &self.places };
                    let (faces, thickness) = (self.state.faces(), self.state.thickness);
                    let outside = outside::sentences((self.deck, bodies), faces, &self.pairs.named, &at, thickness)?;
                    result.warnings.extend(outside);
                    if let Some(most) = step.most.filter(|most| *most < taken) {
                        result.warnings.push(format!("the step took {taken} increments, more than its INC={most}"));
                    }
                    reached(&at, result)?;
                }
                kept = Kept::Equilibrium(Box::new(at));
            }
        }
        Ok(Solved::Finished)
    }
}

/// The bodies before the first equilibrium, and after it.
enum Kept<const D: usize> {
    Model(Model<D>),
    Equilibrium(Box<Equilibrium<D>>),
}

impl<const D: usize> Kept<D> {
    fn model(&self) -> &Model<D> {
        match self {
            Self::Model(model) => model,
            Self::Equilibrium(at) => at.model(),
        }
    }

    fn displacement(&self) -> Option<&[[f64; D]]> {
        match self {
            Self::Model(_) => None,
            Self::Equilibrium(at) => Some(at.displacement()),
        }
    }

    fn halvings(&self) -> usize {
        match self {
            Self::Model(_) => 0,
            Self::Equilibrium(at) => at.halvings,
        }
    }
}

/// The first node on the axis of bodies of revolution that may leave it.
fn on_axis<const D: usize>(deck: &Deck, bodies: Bodies<D>, held: &BTreeSet<(usize, usize)>) -> Option<Note> {
    let mut nodes = bodies.model.coords().iter().enumerate().filter(|_| bodies.model.is_axisymmetric());
    let (node, _) = nodes.find(|(node, place)| place[0] == 0.0 && !held.contains(&(*node, 0)))?;
    let label = deck.mesh.node_tags[bodies.places.nodes[node]];
    let message = format!("node {label} lies on the axis r = 0 and is free to leave it: hold its degree of freedom 1");
    Some(Note { line: deck.elements.first().map_or(1, |row| row.line), message })
}

/// A body that is tied is not driven off by itself: it goes with those that it is tied to.
fn unheld<const D: usize>(error: StaticsError, at: &Equilibrium<D>, pairs: &Pairs) -> StaticsError {
    let is_tied = |name: &String| {
        let mut bodies = pairs.tied_by.keys().flatten();
        bodies.any(|&body| at.model().parts()[body].name == *name)
    };
    match error {
        StaticsError::Adrift { body, motion, .. } if is_tied(&body) => StaticsError::Unsupported { body, motion },
        error => error,
    }
}

/// What is wrong with a tie or with cells, at its line.
fn wrong(error: &StaticsError, (deck, places): (&Deck, &Places), pairs: &Pairs, names: &[String]) -> Option<Fault> {
    let of_cells = match error {
        StaticsError::Contact(error) => mesh_faults::labelled(error, deck, places),
        _ => None,
    };
    of_cells.or_else(|| untied(error, pairs, names))
}

/// An inverted cell by its label.
fn in_labels(error: StaticsError, deck: &Deck, places: &Places) -> StaticsError {
    let label = |cell: usize| deck.mesh.cell(places.cells[cell]).map_or(cell, |(_, _, label, _)| label as usize);
    match error {
        StaticsError::Inverted { load, cell } => StaticsError::Inverted { load, cell: cell.map(label) },
        error => error,
    }
}

/// What is wrong with a tie, at its line.
fn untied(error: &StaticsError, pairs: &Pairs, names: &[String]) -> Option<Fault> {
    let StaticsError::Contact(fmc_contact::Error::Untied { bodies, distances: [reach, nearest], .. }) = error else {
        return None;
    };
    let [a, b] = bodies.map(|body| names.get(body).map_or("", String::as_str));
    let where_else = match nearest.is_finite() {
        true => format!("the nearest faces are {nearest:.4e} apart. A larger POSITION TOLERANCE ties them"),
        false => "no face of one looks at a face of the other. Are both surfaces on the sides that meet?".to_owned(),
    };
    let message = format!(
        "'{a}' and '{b}' are tied, and these surfaces face one another nowhere within {reach:.4e}: {where_else}"
    );
    Some(Fault::new(*pairs.tied_by.get(bodies)?, message))
}

/// How the first step begins.
struct Start<const D: usize> {
    pairs: Vec<([usize; 2], PairOptions)>,
    surfaces: Vec<Vec<Vec<u32>>>,
    stiffness: f64,
    planes: Vec<[[f64; D]; 2]>,
    adjust: Option<[f64; 2]>,
    options: SolveOptions,
}

impl<const D: usize> Start<D> {
    fn equilibrium(
        &self,
        model: Model<D>,
        Driven { supports, forces: load, rigid }: Driven<D>,
    ) -> Result<Equilibrium<D>, StaticsError> {
        let SolveOptions { threads, tolerance, penetration } = self.options;
        let axisymmetric = model.is_axisymmetric();
        let contact = Options { threads, axisymmetric, ..Options::new(EnergyLaw::depth(self.stiffness)) };
        let (pairs, surfaces) = (self.pairs.clone(), self.surfaces.clone());
        let (symmetry_planes, adjust) = (self.planes.clone(), self.adjust);
        let problem =
            Problem { supports, load, rigid, pairs, surfaces, symmetry_planes, adjust, ..Problem::new(model, contact) };
        let mut at = Equilibrium::new(problem)?;
        at.settings = NewtonSettings { tolerance, penetration, most_iterations: 100, ..NewtonSettings::default() };
        Ok(at)
    }
}
