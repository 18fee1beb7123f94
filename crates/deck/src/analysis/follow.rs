//! How nodes follow their reference nodes, and what these bear.

use super::Bodies;
use super::levers::Lever;
use super::points::Freedom;
use super::references::{Reference, Way};
use super::timed::{Timed, When};
use crate::Fault;
use fmc_solid::fem::Constraints;
use fmc_solid::statics::{Balance, Carried, Equilibrium, Rigid, RigidMotion};
use std::collections::{BTreeMap, BTreeSet};

/// Values of degrees of freedom, with their lines.
pub(super) type Values = BTreeMap<Freedom, (Timed, usize)>;

/// What a reference node has borne at the end of a step.
#[derive(Clone, Debug, PartialEq)]
pub struct ReferenceResult {
    /// Its label in the file, and its number there, from 0.
    pub label: u64,
    pub(super) number: usize,
    /// The node of the model that it is, too, if any.
    pub own: Option<usize>,
    /// What holds it: a force, and a moment about it.
    pub force: [f64; 3],
    /// See `force`.
    pub moment: [f64; 3],
    /// How it has moved.
    pub displacement: [f64; 3],
    /// Its rotation vector.
    pub rotation: [f64; 3],
}

/// What nodes and reference nodes bear.
pub(super) struct Borne {
    /// See [`StepResult`](super::StepResult).
    pub(super) reactions: Vec<[f64; 3]>,
    pub(super) references: Vec<ReferenceResult>,
    /// Sum of the loads that the file names, wherever they act.
    pub(super) load: [f64; 3],
}

/// Degrees of freedom of a reference node by which it turns its nodes.
fn turns<const D: usize>(axes: [bool; 3]) -> impl Iterator<Item = usize> {
    let has_effect = move |axis: usize| (0..D).any(|k| axes[k] && k != axis);
    (0..3).filter(move |&axis| if D == 2 { axis == 2 } else { has_effect(axis) }).map(|axis| axis + 3)
}

/// With finite displacements rotations are prescribed, and rest while a translation is free: what is solved.
pub(super) fn check<const D: usize>(
    references: &[Reference<D>],
    first: usize,
    supports: &Values,
    (line, is_finite): (usize, bool),
) -> Result<(), Fault> {
    for (number, reference) in references.iter().enumerate().filter(|_| is_finite) {
        let Way::Follows(axes) = reference.way else { continue };
        let (label, name) = (reference.label, reference.name());
        let held = |axis: usize| supports.get(&(first + number, axis)).map(|(value, _)| value);
        if let Some(free) = turns::<D>(axes).find(|&axis| held(axis).is_none()) {
            let message = format!(
                "with NLGEOM, degree of freedom {} of node {label}, of {name}, is free in this step: finite rotations are not solved for. Hold it or \
                 give it a motion, leave out NLGEOM, or take a stiff elastic body",
                free + 1
            );
            return Err(Fault::new(line, message));
        }
        let free = (0..D).find(|&axis| axes[axis] && held(axis).is_none());
        let turning = turns::<D>(axes).find(|&axis| held(axis).is_some_and(|value| !value.is_constant()));
        if let (Some(free), Some(turning)) = (free, turning) {
            let message = format!(
                "with NLGEOM, node {label}, of {name}, is free along degree of freedom {} while it turns by degree of freedom {}: known is one of both",
                free + 1,
                turning + 1
            );
            return Err(Fault::new(line, message));
        }
        let is_turned = turns::<D>(axes).any(|axis| held(axis).is_some_and(|value| !value.is_zero()));
        if is_turned && !(0..D).all(|axis| axes[axis]) {
            let message =
                format!("with NLGEOM, node {label} of {name} turns, and its nodes follow along some axes alone");
            return Err(Fault::new(line, message));
        }
    }
    Ok(())
}

/// A rigid ring moves along its axis alone.
pub(super) fn check_rings<const D: usize>(
    references: &[Reference<D>],
    first: usize,
    supports: &Values,
    line: usize,
) -> Result<(), Fault> {
    for (number, reference) in references.iter().enumerate() {
        let Way::Follows(axes) = reference.way else { continue };
        let rests = |axis: usize| supports.get(&(first + number, axis)).is_some_and(|(value, _)| value.is_zero());
        let moving = [0].into_iter().filter(|_| axes[0]).chain(turns::<D>(axes)).find(|&axis| !rests(axis));
        if let Some(axis) = moving {
            let message = format!(
                "degree of freedom {} of node {}, of {}, is not held at 0 in this step: a rigid body of revolution moves along its axis alone",
                axis + 1,
                reference.label,
                reference.name()
            );
            return Err(Fault::new(line, message));
        }
    }
    Ok(())
}

/// Nodes and axes that rest with their reference nodes.
pub(super) fn at_rest<const D: usize>(
    references: &[Reference<D>],
    first: usize,
    supports: &Values,
) -> BTreeSet<(usize, usize)> {
    let mut found = BTreeSet::new();
    for (number, reference) in references.iter().enumerate() {
        let Way::Follows(axes) = reference.way else { continue };
        let rests = |axis: usize| supports.get(&(first + number, axis)).is_some_and(|(value, _)| value.is_zero());
        if turns::<D>(axes).all(rests) {
            let resting = (0..D).filter(|&axis| axes[axis] && rests(axis));
            resting.for_each(|axis| found.extend(reference.nodes.iter().map(|&node| (node, axis))));
        }
    }
    found
}

/// How the nodes of a reference node move in a stage.
pub(super) struct Stage<'a, const D: usize> {
    pub(super) bodies: Bodies<'a, D>,
    pub(super) first: usize,
    pub(super) when: When,
    /// Where nodes are when the stage begins.
    pub(super) displacement: &'a [[f64; D]],
}

impl<const D: usize> Stage<'_, D> {
    /// The lever by which a reference node moves its nodes, where rotations are small and free, or turn it while it is free.
    fn lever(&self, (number, reference): (usize, &Reference<D>), values: &Values) -> Result<Option<Lever<D>>, Fault> {
        let Way::Follows(axes) = reference.way else { return Ok(None) };
        let of = |axis: usize| values.get(&(self.first + number, axis)).map(|(value, _)| value);
        let is_free = |&axis: &usize| of(axis).is_none();
        let translations = (0..D).filter(|&axis| axes[axis]);
        let is_turned = turns::<D>(axes).any(|axis| of(axis).is_none_or(|value| !value.is_zero()));
        let free: Vec<usize> = translations.chain(turns::<D>(axes)).filter(is_free).collect();
        if self.bodies.places.is_finite || free.is_empty() || !is_turned {
            return Ok(None);
        }
        let held = std::array::from_fn(|axis| of(axis).map(|value| value.at(self.when)));
        let lever = Lever::new(reference, (axes, free), held);
        lever.map(Some).map_err(|component| {
            let message = format!(
                "degree of freedom {} of node {}, of {}, is free, and no node feels it: hold it",
                component + 1,
                reference.label,
                reference.name()
            );
            Fault::new(reference.line, message)
        })
    }

    /// Adds supports of the nodes of a reference node, and what joins them; `turned` is its rotation when the stage begins, and then at its end.
    pub(super) fn add(
        &self,
        (number, reference): (usize, &Reference<D>),
        values: &Values,
        turned: &mut [f64; 3],
        (supports, rigid): (&mut Constraints<D>, &mut Rigid<D>),
    ) -> Result<Option<Lever<D>>, Fault> {
        let Way::Follows(axes) = reference.way else { return Ok(None) };
        if let Some(lever) = self.lever((number, reference), values)? {
            rigid.followers.extend_from_slice(&lever.followers);
            return Ok(Some(lever));
        }
        let value = |axis: usize| values.get(&(self.first + number, axis)).map(|(value, _)| value.at(self.when));
        let rotation: [f64; 3] = std::array::from_fn(|axis| value(axis + 3).unwrap_or(0.0));
        let translation: [f64; D] = std::array::from_fn(|axis| value(axis).unwrap_or(0.0));
        let motion = RigidMotion { translation, rotation };
        let is_finite = self.bodies.places.is_finite;
        let all: Vec<[f64; D]> =
            reference.arms.iter().map(|arm| if is_finite { motion.finite(*arm) } else { motion.small(*arm) }).collect();
        for axis in (0..D).filter(|&axis| axes[axis]) {
            match value(axis) {
                Some(_) => {
                    reference.nodes.iter().zip(&all).for_each(|(&node, u)| supports.prescribe([node], axis, u[axis]))
                }
                None => rigid.joined.push(reference.nodes.iter().map(|node| node * D + axis).collect()),
            }
        }
        if is_finite && rotation != *turned {
            let (node, arm) = (reference.nodes[0], reference.arms[0]);
            let turn = RigidMotion { translation: [0.0; D], rotation: *turned }.finite(arm);
            let translation = std::array::from_fn(|k| self.displacement[node][k] - turn[k]);
            let start = RigidMotion { translation, rotation: *turned };
            rigid.carried.push(Carried {
                nodes: reference.nodes.clone(),
                centre: reference.place,
                ends: [start, motion],
            });
        }
        *turned = rotation;
        Ok(None)
    }
}

/// What holds nodes, but for those that follow, whose share their reference nodes have.
pub(super) fn borne<const D: usize>(
    references: &[Reference<D>],
    results: Vec<ReferenceResult>,
    at: &Equilibrium<D>,
    load: [f64; 3],
) -> Borne {
    let mut reactions = vec![[0.0; 3]; at.model().node_count()];
    at.problem().supports.iter().for_each(|(node, axis, _)| reactions[node][axis] = at.balance().residual[node][axis]);
    for reference in references {
        let Way::Follows(axes) = reference.way else { continue };
        for &node in &reference.nodes {
            (0..D).filter(|&axis| axes[axis]).for_each(|axis| reactions[node][axis] = 0.0);
        }
    }
    for result in &results {
        match result.own {
            Some(node) => reactions[node] = result.force,
            None => reactions.push(result.force),
        }
    }
    Borne { reactions, references: results, load }
}

/// How a reference node has moved its nodes, and what is applied to it.
pub(super) struct Moved<'a, const D: usize> {
    pub(super) lever: Option<&'a Lever<D>>,
    pub(super) rotation: [f64; 3],
    pub(super) is_finite: bool,
    pub(super) applied: [f64; 6],
}

/// What holds a reference node, which bears what its nodes lack and what is applied to it.
pub(super) fn result<const D: usize>(
    (number, reference): (usize, &Reference<D>),
    at: &Equilibrium<D>,
    &Moved { lever, rotation, is_finite, applied }: &Moved<D>,
) -> Option<ReferenceResult> {
    let Way::Follows(axes) = reference.way else { return None };
    let (balance, displacement): (&Balance<D>, _) = (at.balance(), at.displacement());
    let motion = lever.map(|lever| lever.motion(displacement));
    let rotation = motion.map_or(rotation, |motion| [motion[3], motion[4], motion[5]]);
    let turn = |arm: [f64; D]| {
        let motion = RigidMotion { translation: [0.0; D], rotation };
        if is_finite { motion.finite(arm) } else { motion.small(arm) }
    };
    let mut lacking: Vec<[f64; 3]> = reference
        .nodes
        .iter()
        .map(|&node| std::array::from_fn(|k| if k < D && axes[k] { balance.residual[node][k] } else { 0.0 }))
        .collect();
    // What is applied to the reference node some of its nodes have: their arms are none of the load's.
    for (component, &value) in applied.iter().enumerate() {
        match lever {
            None if component < 3 => lacking[0][component] += value,
            None => {}
            Some(lever) => lever.load(component, value).for_each(|(node, axis, force)| {
                if let Ok(k) = reference.nodes.binary_search(&node) {
                    lacking[k][axis] += force;
                }
            }),
        }
    }
    let (mut force, mut moment) = ([0.0; 3], [0.0; 3]);
    for (&arm, f) in reference.arms.iter().zip(lacking) {
        let turned = turn(arm);
        let arm: [f64; 3] =
            std::array::from_fn(|k| arm.get(k).map_or(0.0, |a| a + if is_finite { turned[k] } else { 0.0 }));
        for k in 0..3 {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            force[k] += f[k];
            moment[k] += arm[i] * f[j] - arm[j] * f[i];
        }
    }
    (0..3).for_each(|k| (force[k], moment[k]) = (force[k] - applied[k], moment[k] - applied[k + 3]));
    let (node, turned) = (reference.nodes[0], turn(reference.arms[0]));
    let moved = |k: usize| if axes[k] { displacement[node].get(k).map_or(0.0, |u| u - turned[k]) } else { 0.0 };
    let displacement = motion.map_or(std::array::from_fn(moved), |motion| [motion[0], motion[1], motion[2]]);
    let Reference { label, own, .. } = *reference;
    Some(ReferenceResult { label, number, own, force, moment, displacement, rotation })
}
