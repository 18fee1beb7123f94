//! State and means of a solver.

use super::balance::Balance;
use super::equations::Equations;
use super::error::StaticsError;
use super::matrices::Matrices;
use super::named_surfaces::facets_of;
use super::newton_settings::NewtonSettings;
use super::problem::Problem;
use super::rigid::Rigid;
use super::untouched::untouched;
use crate::fem::{Constraints, Model};
use fmc_contact::contact::{Adjustment, NodalContact, PointOfContact, TieSummary};
use fmc_contact::overlap::Partner;
use fmc_contact::{Contact, ContactForces, EnergyLaw, Estimator};
use std::time::Instant;

/// A problem, the last state in equilibrium that was found, and what finding it took.
pub struct Equilibrium<const D: usize> {
    pub(super) problem: Problem<D>,
    pub(super) contact: Contact<D>,
    pub(super) matrices: Matrices,
    /// Where the bodies' matrix is taken.
    pub(super) linearised_at: Vec<f64>,
    pub(super) shortest_edge: f64,
    /// How an equilibrium is sought.
    pub settings: NewtonSettings,
    pub(super) displacement: Vec<[f64; D]>,
    pub(super) balance: Balance<D>,
    pub(super) load: f64,
    /// Displacement and dead loads at which the stage began.
    pub(super) from: (Vec<[f64; D]>, Vec<[f64; D]>),
    /// See [`Equilibrium::unturned`].
    pub(super) unturned: Option<f64>,
    /// See [`Equilibrium::stalled_turn`].
    pub(super) stalled_turn: Option<f64>,
    /// Iterations: linear systems solved.
    pub iterations: usize,
    /// Iterations of the contact alone, within these.
    pub contact_iterations: usize,
    /// Updates of the multipliers, where a penetration is wanted.
    pub updates: usize,
    /// Load steps that failed and were halved.
    pub halvings: usize,
    /// Evaluations of forces and energy.
    pub evaluations: usize,
    /// What the search has said of the last equilibrium, a sentence each.
    pub warnings: Vec<String>,
    /// Seconds in the contact and in the search.
    pub contact_seconds: f64,
    /// What [`Problem::adjust`] closed and removed.
    pub adjustment: Adjustment,
}

impl<const D: usize> Equilibrium<D> {
    /// Undeformed and unloaded.
    ///
    /// # Errors
    /// [`StaticsError::Length`], [`StaticsError::Joined`]; those of the contact.
    pub fn new(mut problem: Problem<D>) -> Result<Self, StaticsError> {
        let expected = problem.model.node_count();
        if problem.load.is_empty() {
            problem.load.resize(expected, [0.0; D]);
        }
        if problem.load.len() != expected {
            return Err(StaticsError::Length { expected, found: problem.load.len() });
        }
        // Corrected forces would not be the gradient of the energy any more.
        if let (Estimator::Fibers(fibers), true) = (&mut problem.contact.estimator, problem.contact.law.is_fiber()) {
            fibers.momentum_correction = false;
        }
        let mut contact = Contact::new(problem.model.surface()?, problem.contact)?;
        for obstacle in problem.obstacles.iter().filter(|_| problem.linearised.is_none()) {
            contact.add_obstacle(obstacle.clone())?;
        }
        for facets in facets_of(&contact, &problem.surfaces) {
            contact.add_surface(&facets)?;
        }
        for (parts, options) in &problem.pairs {
            contact.set_pair_options(parts.map(Partner::Body), Some(*options))?;
        }
        if !problem.symmetry_planes.is_empty() {
            contact.set_symmetry_planes(&problem.symmetry_planes)?;
        }
        let adjustment = match problem.adjust {
            Some([close, remove]) => contact.adjust(problem.model.coords(), close, remove)?,
            None => Adjustment::default(),
        };
        problem.rigid.check(expected, &problem.supports)?;
        let matrices = matrices(&problem);
        if contact.has_friction() {
            // Its line search goes by the potential of frozen friction, stored and dissipated energy together.
            if problem.contact.friction.memoryless_slip.is_some() {
                return Err(
                    fmc_contact::Error::Unsupported { what: "an equilibrium by friction without memory" }.into()
                );
            }
            if problem.linearised.is_some() {
                return Err(fmc_contact::Error::Unsupported { what: "friction in linearised contact" }.into());
            }
            contact.begin_step(problem.model.coords())?;
        }
        let shortest_edge = shortest_edge(&contact, problem.model.coords());
        let displacement = vec![[0.0; D]; expected];
        let from = (displacement.clone(), displacement.clone());
        // The search finds the stiffness, if none is given.
        let touch = match problem.contact.law.is_without_stiffness() {
            true => untouched(contact.surface(), expected),
            false => contact.evaluate(problem.model.coords())?,
        };
        let load = |_| [0.0; D];
        let balance = Balance::new(0.0, displacement.clone(), touch, load, &displacement, &matrices.equations);
        Ok(Self {
            problem,
            contact,
            matrices,
            linearised_at: vec![0.0; expected * D],
            shortest_edge,
            settings: NewtonSettings::default(),
            displacement,
            balance,
            load: 0.0,
            from,
            halvings: 0,
            unturned: None,
            stalled_turn: None,
            updates: 0,
            iterations: 0,
            contact_iterations: 0,
            evaluations: 0,
            warnings: Vec::new(),
            contact_seconds: 0.0,
            adjustment,
        })
    }

    /// The bodies.
    pub fn model(&self) -> &Model<D> {
        &self.problem.model
    }

    /// The problem.
    pub fn problem(&self) -> &Problem<D> {
        &self.problem
    }

    /// Displacement of the last equilibrium.
    pub fn displacement(&self) -> &[[f64; D]] {
        &self.displacement
    }

    /// Forces and energies of the last equilibrium.
    pub fn balance(&self) -> &Balance<D> {
        &self.balance
    }

    /// Part of the full load at which it was found.
    pub fn load(&self) -> f64 {
        self.load
    }

    /// Coordinates of the deformed bodies.
    pub fn coords(&self) -> Vec<[f64; D]> {
        self.placed(&self.displacement)
    }

    /// Equations that are solved.
    pub fn equation_count(&self) -> usize {
        self.matrices.equations.count()
    }

    /// What contact finds at the last equilibrium where surfaces are, not where multipliers have moved them.
    ///
    /// # Errors
    /// Those of the contact.
    pub fn true_contact(&self) -> Result<ContactForces<D>, StaticsError> {
        Ok(self.contact.evaluate_true(&self.placed(&self.displacement))?)
    }

    /// Pressure, area and normal of contact at every node of the last equilibrium.
    ///
    /// # Errors
    /// Those of the contact.
    pub fn nodal_contact(&self) -> Result<NodalContact<D>, StaticsError> {
        Ok(self.contact.nodal_contact(&self.placed(&self.displacement))?)
    }

    /// The contact points of the last equilibrium, with both sides of each.
    ///
    /// # Errors
    /// Those of the contact.
    pub fn contact_points(&self) -> Result<Vec<PointOfContact<D>>, StaticsError> {
        Ok(self.contact.contact_points(&self.placed(&self.displacement))?)
    }

    /// What ties two bodies, and the nodes of the side that holds; `None` if they are not tied.
    ///
    /// # Errors
    /// Those of the contact.
    pub fn tie(&self, bodies: [usize; 2]) -> Result<Option<(TieSummary, Vec<u32>)>, StaticsError> {
        let Some(summary) = self.contact.tie(bodies)? else { return Ok(None) };
        let nodes = self.contact.tie_nodes(&self.placed(&self.displacement))?;
        let of_pair = nodes.iter().filter(|row| row.bodies == bodies || row.bodies == [bodies[1], bodies[0]]);
        Ok(Some((summary, of_pair.map(|row| row.node).collect())))
    }

    /// Contact at a displacement, with the coordinates that it is shown.
    fn touch(&self, u: &[[f64; D]], coords: &[[f64; D]]) -> Result<ContactForces<D>, fmc_contact::Error> {
        let mut touch = self.contact.evaluate(coords)?;
        if let Some(linearised) = &self.problem.linearised {
            linearised.add_to(&mut touch, &self.problem.contact.law, u);
        }
        Ok(touch)
    }

    /// Replaces the energy law; the state stays.
    ///
    /// # Errors
    /// Those of the contact.
    pub fn set_law(&mut self, law: EnergyLaw) -> Result<(), StaticsError> {
        self.problem.contact.law = law;
        Ok(self.contact.set_options(self.problem.contact)?)
    }

    /// Starts a stage that leads on from the last equilibrium, at load 0 of its own: what was brought on stays, and the
    /// supports move to other values.
    ///
    /// # Errors
    /// [`StaticsError::Length`] if they hold other degrees of freedom.
    pub fn next_stage(&mut self, supports: Constraints<D>) -> Result<(), StaticsError> {
        let held = |supports: &Constraints<D>| supports.iter().map(|(node, axis, _)| (node, axis)).collect::<Vec<_>>();
        let (before, now) = (held(&self.problem.supports), held(&supports));
        if before != now {
            return Err(StaticsError::Length { expected: before.len(), found: now.len() });
        }
        let rigid = Rigid { carried: Vec::new(), ..self.problem.rigid.clone() };
        self.next_step(supports, self.problem.load.clone(), rigid)
    }

    /// Starts a stage that leads on from the last equilibrium, at load 0 of its own, to other supports, other dead loads and other
    /// rigid motions. What is no longer held is let go: its reaction fades as the new load grows.
    ///
    /// # Errors
    /// [`StaticsError::Length`] if there is not one force for each node, and [`StaticsError::Joined`].
    pub fn next_step(
        &mut self,
        supports: Constraints<D>,
        load: Vec<[f64; D]>,
        rigid: Rigid<D>,
    ) -> Result<(), StaticsError> {
        let expected = self.problem.model.node_count();
        if load.len() != expected {
            return Err(StaticsError::Length { expected, found: load.len() });
        }
        rigid.check(expected, &supports)?;
        let mut reached: Vec<[f64; D]> = (0..expected).map(|node| self.dead_load(node, self.load)).collect();
        for (node, axis, _) in self.problem.supports.iter().filter(|(node, axis, _)| !supports.contains(*node, *axis)) {
            reached[node][axis] += self.balance.residual[node][axis];
        }
        let held = |supports: &Constraints<D>| supports.iter().map(|(node, axis, _)| (node, axis)).collect::<Vec<_>>();
        let is_other = held(&self.problem.supports) != held(&supports) || !self.problem.rigid.joins_as(&rigid);
        (self.problem.supports, self.problem.load, self.problem.rigid) = (supports, load, rigid);
        if is_other {
            self.matrices = matrices(&self.problem);
        }
        (self.from, self.load) = ((self.displacement.clone(), reached), 0.0);
        Ok(())
    }

    /// The dead load of a node at a part of the stage.
    pub(super) fn dead_load(&self, node: usize, load: f64) -> [f64; D] {
        let (from, to) = (self.from.1[node], self.problem.load[node]);
        std::array::from_fn(|axis| from[axis] + load * (to[axis] - from[axis]))
    }

    /// Largest side of the box around all bodies.
    pub fn size(&self) -> f64 {
        size(self.problem.model.coords())
    }

    pub(super) fn placed(&self, displacement: &[[f64; D]]) -> Vec<[f64; D]> {
        let coords = self.problem.model.coords().iter();
        coords.zip(displacement).map(|(x, u)| std::array::from_fn(|i| x[i] + u[i])).collect()
    }

    /// Sets what is prescribed at a load.
    pub(super) fn prescribe(&self, displacement: &mut [[f64; D]], load: f64) {
        for (node, axis, value) in self.problem.supports.iter() {
            let from = self.from.0[node][axis];
            displacement[node][axis] = from + load * (value - from);
        }
        for carried in &self.problem.rigid.carried {
            carried.place(self.problem.model.coords(), load, displacement);
        }
        for follower in &self.problem.rigid.followers {
            let from = follower.apart_at(&self.from.0);
            let apart = from + load * (follower.apart.unwrap_or(from) - from);
            displacement[follower.freedom / D][follower.freedom % D] = apart + follower.followed(displacement);
        }
    }

    /// Forces and energies at a displacement.
    pub(super) fn evaluate(&mut self, displacement: &[[f64; D]], load: f64) -> Result<Balance<D>, StaticsError> {
        let touch = self.touch_at(displacement).map_err(|error| match error {
            fmc_contact::Error::InvertedCell { cell, .. } | fmc_contact::Error::FoldedCell { cell, .. } => {
                StaticsError::Inverted { load, cell: Some(cell) }
            }
            error => StaticsError::Contact(error),
        })?;
        let mut internal = vec![[0.0; D]; displacement.len()];
        let strain = self.problem.model.internal(displacement, &mut internal);
        let external = |node: usize| self.dead_load(node, load);
        let balance = Balance::new(strain, internal, touch, external, displacement, &self.matrices.equations);
        if !balance.energy().is_finite() || !balance.norm.is_finite() {
            return Err(StaticsError::Inverted { load, cell: None });
        }
        Ok(balance)
    }

    /// Contact at a displacement.
    fn touch_at(&mut self, displacement: &[[f64; D]]) -> Result<ContactForces<D>, fmc_contact::Error> {
        let coords = self.placed(displacement);
        self.evaluations += 1;
        let clock = Instant::now();
        let touch = self.touch(displacement, &coords);
        self.contact_seconds += clock.elapsed().as_secs_f64();
        touch
    }

    /// Keeps the patches of the fiber law as they are at a displacement.
    pub(super) fn keep_patches(&mut self, displacement: &[[f64; D]]) -> Result<(), StaticsError> {
        let coords = self.placed(displacement);
        self.contact.keep_patches(&coords)?;
        Ok(())
    }

    pub(super) fn accept(&mut self, displacement: Vec<[f64; D]>, balance: Balance<D>, load: f64) {
        (self.displacement, self.balance, self.load) = (displacement, balance, load);
    }
}

/// Matrices of the degrees of freedom that are free.
fn matrices<const D: usize>(problem: &Problem<D>) -> Matrices {
    let model = &problem.model;
    let held = problem.supports.iter().map(|(node, axis, _)| node * D + axis);
    let rigid = &problem.rigid;
    let equations = Equations::new(model.node_count() * D, held, &rigid.joined, &rigid.followers);
    let place = |equation: usize| {
        let x = model.coords()[equations.freedom(equation) / D];
        std::array::from_fn(|i| if i < D { x[i] } else { 0.0 })
    };
    let places: Vec<[f64; 3]> = (0..equations.count()).map(place).collect();
    Matrices::new(equations, places)
}

/// Shortest edge of a facet: where meshes are graded, those in contact are the smallest.
fn shortest_edge<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) -> f64 {
    let length = |p: u32, q: u32| {
        let squares = (0..D).map(|i| (coords[p as usize][i] - coords[q as usize][i]).powi(2));
        squares.sum::<f64>().sqrt()
    };
    let faces = contact.surface().faces();
    let edges = faces.into_iter().flat_map(|(_, face)| {
        let pairs = (1..face.len()).map(|k| length(face[k - 1], face[k]));
        pairs.collect::<Vec<_>>()
    });
    edges.fold(f64::INFINITY, f64::min)
}

/// Largest side of the box around some points.
fn size<const D: usize>(coords: &[[f64; D]]) -> f64 {
    let extent = |axis: usize| {
        let along = coords.iter().map(|x| x[axis]);
        let (low, high) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
        high - low
    };
    (0..D).map(extent).fold(0.0, f64::max)
}
