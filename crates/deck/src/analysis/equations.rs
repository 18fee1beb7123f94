//! `*EQUATION`: which degrees of freedom follow which others.
//!
//! Of each equation the first degree of freedom goes that is free and does not follow already, and is put into all others:
//! equations may so name what others eliminate. Nodes without elements have no stiffness: theirs go first.

use super::Bodies;
use super::points::Freedom;
use super::references::{Reference, Way};
use crate::Fault;
use crate::read::{Deck, EquationRow, Kind, Term};
use std::collections::{BTreeMap, BTreeSet};

/// Part of the terms of a sum that is rounding.
const ROUNDED: f64 = 1e-12;

/// Part of the terms by which values that are held may miss an equation: files have seven digits.
const MISSED: f64 = 1e-6;

/// Σ a u = 0.
pub(super) struct Equation {
    line: usize,
    terms: Vec<(Freedom, f64)>,
    /// Whether any of its terms may go: then the largest does.
    is_of_axes: bool,
}

/// The equations of the components of nodes along axes of their own; `first` is the number of nodes of the model.
pub(super) fn of_axes<const D: usize>(references: &[Reference<D>], first: usize) -> Vec<Equation> {
    let mut found = Vec::new();
    for (number, reference) in references.iter().enumerate() {
        let Way::Local(axes) = &reference.way else { continue };
        for (i, axis) in axes.iter().enumerate() {
            let of_node = axis.iter().enumerate().map(|(k, factor)| ((reference.nodes[0], k), *factor));
            let mut terms: Vec<(Freedom, f64)> = of_node.filter(|(_, factor)| *factor != 0.0).collect();
            terms.push(((first + number, i), -1.0));
            found.push(Equation { line: reference.line, terms, is_of_axes: true });
        }
    }
    found
}

/// Degrees of freedom that follow, by what they follow: free ones, and such that are held.
pub(super) type Eliminated = BTreeMap<Freedom, BTreeMap<Freedom, f64>>;

/// Nodes of a term, in the order in which sets are taken.
fn nodes(deck: &Deck, instance: Option<usize>, term: &Term) -> Result<Vec<usize>, Fault> {
    deck.names.find_in_order(Kind::Node, instance, &term.set, term.line)
}

/// Adds the nodes of no element that equations name, each as a point of its own.
pub(super) fn add_loose<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    references: &mut Vec<Reference<D>>,
) -> Result<(), Fault> {
    for row in &deck.equations {
        for instance in deck.names.instances_of(&row.scope) {
            for term in &row.terms {
                for node in
                    nodes(deck, instance, term)?.into_iter().filter(|&node| bodies.places.node_of[node].is_none())
                {
                    let known = references.iter_mut().find(|reference| reference.node == node);
                    match known.map(|reference| &mut reference.way) {
                        Some(Way::Loose(axes)) => axes[term.axis] = true,
                        Some(_) => {}
                        None => references.push(Reference::loose(deck, node, row.line, term.axis)),
                    }
                }
            }
        }
    }
    Ok(())
}

/// All equations of a file.
pub(super) fn equations<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    references: &[Reference<D>],
) -> Result<Vec<Equation>, Fault> {
    let mut found = Vec::new();
    for row in &deck.equations {
        for instance in deck.names.instances_of(&row.scope) {
            of_row(deck, bodies, references, (row, instance), &mut found)?;
        }
    }
    Ok(found)
}

fn of_row<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    references: &[Reference<D>],
    (row, instance): (&EquationRow, Option<usize>),
    found: &mut Vec<Equation>,
) -> Result<(), Fault> {
    let sets = row.terms.iter().map(|term| nodes(deck, instance, term)).collect::<Result<Vec<_>, Fault>>()?;
    let count = sets[0].len();
    if let Some((term, set)) = row.terms.iter().zip(&sets).find(|(_, set)| set.len() != count && set.len() != 1) {
        let (first, name) = (&row.terms[0].set, &term.set);
        let message =
            format!("'{name}' has {} nodes, and '{first}', the first of the equation, has {count}", set.len());
        return Err(Fault::new(term.line, message));
    }
    for k in 0..count {
        let mut equation = Equation { line: row.line, terms: Vec::new(), is_of_axes: false };
        for (term, set) in row.terms.iter().zip(&sets) {
            let node = set[if set.len() == 1 { 0 } else { k }];
            let freedom = freedom(deck, bodies, references, (node, term))?;
            match equation.terms.iter_mut().find(|(known, _)| *known == freedom) {
                Some((_, factor)) => *factor += term.factor,
                None => equation.terms.push((freedom, term.factor)),
            }
        }
        if equation.terms[0].1 == 0.0 {
            return Err(Fault::new(row.terms[0].line, "the first factor of an equation is 0"));
        }
        found.push(equation);
    }
    Ok(())
}

fn freedom<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    references: &[Reference<D>],
    (node, term): (usize, &Term),
) -> Result<Freedom, Fault> {
    let label = deck.mesh.node_tags[node];
    if term.axis >= D {
        return Err(Fault::new(term.line, "there is no third degree of freedom in 2D"));
    }
    let number = references.iter().position(|reference| reference.node == node || reference.rotating == Some(node));
    match (number.map(|number| (number, &references[number])), bodies.places.node_of[node]) {
        (Some((number, Reference { way: Way::Loose(_) | Way::Local(_), .. })), _) => {
            Ok((bodies.model.node_count() + number, term.axis))
        }
        (Some((_, reference)), _) => {
            let message = format!("node {label} is a reference node of {}, and of no *EQUATION", reference.name());
            Err(Fault::new(term.line, message))
        }
        (None, Some(own)) => Ok((own, term.axis)),
        (None, None) => Err(Fault::new(term.line, format!("node {label} belongs to no element"))),
    }
}

/// What is known of degrees of freedom in a stage.
pub(super) struct Known<'a> {
    /// Nodes of the model.
    pub(super) first: usize,
    /// Values at its end of what is held.
    pub(super) held: &'a dyn Fn(Freedom) -> Option<f64>,
    /// Whether reference nodes that are free move it.
    pub(super) is_led: &'a dyn Fn(Freedom) -> bool,
    /// How messages call a node.
    pub(super) label: &'a dyn Fn(usize) -> u64,
}

/// What follows in a stage.
pub(super) fn eliminated(equations: &[Equation], known: &Known) -> Result<Eliminated, Fault> {
    let mut all = Eliminated::new();
    // Which of them follow a degree of freedom.
    let mut users: BTreeMap<Freedom, BTreeSet<Freedom>> = BTreeMap::new();
    for equation in equations {
        if let Some((freedom, _)) = equation.terms.iter().find(|(freedom, _)| (known.is_led)(*freedom)) {
            let message = format!(
                "node {} of this equation follows a reference node that is free along an axis",
                (known.label)(freedom.0)
            );
            return Err(Fault::new(equation.line, message));
        }
        let mut row: Vec<(Freedom, [f64; 2])> = Vec::new();
        for &(freedom, factor) in &equation.terms {
            let one = BTreeMap::from([(freedom, 1.0)]);
            for (&freedom, weight) in all.get(&freedom).unwrap_or(&one) {
                let term = factor * weight;
                match row.iter_mut().find(|(known, _)| *known == freedom) {
                    Some((_, [sum, size])) => (*sum, *size) = (*sum + term, *size + term.abs()),
                    None => row.push((freedom, [term, term.abs()])),
                }
            }
        }
        row.retain(|(_, [sum, size])| sum.abs() > ROUNDED * size);
        let is_free = |(freedom, _): &&(Freedom, [f64; 2])| (known.held)(*freedom).is_none();
        let loose = row.iter().filter(|(freedom, _)| freedom.0 >= known.first).find(is_free);
        let size = |(_, [sum, _]): &&(Freedom, [f64; 2])| sum.abs();
        let of_model = || match equation.is_of_axes {
            true => row.iter().filter(is_free).max_by(|p, q| size(p).total_cmp(&size(q))),
            false => row.iter().find(is_free),
        };
        let Some(&(pivot, [factor, _])) = loose.or_else(of_model) else {
            check_held(equation, &row, known)?;
            continue;
        };
        let of: BTreeMap<Freedom, f64> = row
            .iter()
            .filter(|(freedom, _)| *freedom != pivot)
            .map(|&(freedom, [sum, _])| (freedom, -sum / factor))
            .collect();
        for user in users.remove(&pivot).unwrap_or_default() {
            let Some(sums) = all.get_mut(&user) else { continue };
            let weight = sums.remove(&pivot).unwrap_or(0.0);
            for (&freedom, part) in &of {
                *sums.entry(freedom).or_insert(0.0) += weight * part;
                users.entry(freedom).or_default().insert(user);
            }
        }
        for freedom in of.keys() {
            users.entry(*freedom).or_default().insert(pivot);
        }
        all.insert(pivot, of);
    }
    let undetermined = |freedom: &&Freedom| freedom.0 >= known.first && (known.held)(**freedom).is_none();
    if let Some(&(place, axis)) = all.values().flat_map(BTreeMap::keys).find(undetermined) {
        let named =
            equations.iter().find(|equation| equation.terms.iter().any(|(freedom, _)| *freedom == (place, axis)));
        let message = format!(
            "node {} belongs to no element, and the equations leave its degree of freedom {} free: hold it",
            (known.label)(place),
            axis + 1
        );
        return Err(Fault::new(named.map_or(1, |equation| equation.line), message));
    }
    Ok(all)
}

/// An equation of what is held holds, or is refused.
fn check_held(equation: &Equation, row: &[(Freedom, [f64; 2])], known: &Known) -> Result<(), Fault> {
    let (mut sum, mut size) = (0.0, 0.0);
    for &(freedom, [factor, _]) in row {
        let term = factor * (known.held)(freedom).unwrap_or(0.0);
        (sum, size) = (sum + term, size + f64::abs(term));
    }
    if sum.abs() <= MISSED * size {
        return Ok(());
    }
    let named: Vec<String> =
        row.iter().map(|((place, axis), _)| format!("{} of node {}", axis + 1, (known.label)(*place))).collect();
    let message = format!(
        "this equation cannot hold: its remaining degrees of freedom {} are fixed, and violate it by {sum:.6e}",
        named.join(", ")
    );
    Err(Fault::new(equation.line, message))
}
