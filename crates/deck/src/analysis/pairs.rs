//! Which bodies touch, rub or are tied.

use super::Bodies;
use super::surfaces::{face_number, surface};
use super::ties::facet_size;
use crate::Fault;
use crate::read::{Deck, Kind, PairRow, SurfaceRow};
use fmc_contact::EnergyLaw;
use fmc_contact::contact::PairOptions;
use std::collections::{BTreeMap, BTreeSet};

/// Options by pair of bodies, with the line that names it; 0 for those that are left out.
pub(crate) type Pairs = BTreeMap<[usize; 2], (PairOptions, usize)>;

/// Pressure by penetration, if the file gives it; multipliers then leave the penetration as it is, so that it holds for all pairs.
pub(super) fn stiffness(deck: &Deck) -> Result<Option<f64>, Fault> {
    let of = |row: &PairRow| deck.interactions.get(&row.interaction).and_then(|interaction| interaction.stiffness);
    let Some(row) = deck.pairs.iter().find(|row| of(row).is_some()) else { return Ok(None) };
    let slope = of(row);
    let is_mixed = deck.pairs.iter().any(|row| of(row) != slope) || !deck.ties.is_empty();
    match is_mixed {
        true => Err(Fault::new(row.line, "LINEAR is known for all contact pairs with one slope, and not beside *TIE")),
        false => Ok(of(row)),
    }
}

/// Lengths up to which gaps are closed and overlaps removed before the first step, if the file asks for it. CalculiX and Abaqus move all
/// nodes that overlap, and those that are nearer than `ADJUST`.
pub(super) fn adjustment<const D: usize>(deck: &Deck, bodies: Bodies<D>) -> Result<Option<[f64; 2]>, Fault> {
    let Some(row) = deck.pairs.iter().find(|row| row.adjust.is_some()) else { return Ok(None) };
    let close = row.adjust.unwrap_or(0.0);
    if let Some(other) = deck.pairs.iter().find(|other| other.adjust != row.adjust) {
        return Err(Fault::new(other.line, "ADJUST of *CONTACT PAIR is known for all contact pairs with one length"));
    }
    if !deck.ties.is_empty() {
        return Err(Fault::new(row.line, "ADJUST of *CONTACT PAIR is not known beside *TIE"));
    }
    let all = 0..bodies.model.parts().len();
    let facet = all.map(|body| facet_size(bodies, body)).fold(f64::INFINITY, f64::min);
    Ok(Some([close, close.max(facet)]))
}

/// The pairs that a file names, and that all others are left out.
pub(super) fn pairs<const D: usize>(deck: &Deck, bodies: Bodies<D>) -> Result<Pairs, Fault> {
    let mut named = Pairs::new();
    let mut put = |pair: [usize; 2], options: PairOptions, line: usize| {
        let before = named.insert(pair, (options, line));
        match before.filter(|(before, _)| *before != options) {
            Some((_, first)) => {
                let [a, b] = pair.map(|body| bodies.model.parts()[body].name.clone());
                Err(Fault::new(line, format!("{a} and {b} are a pair of another kind already, by line {first}")))
            }
            None => Ok(()),
        }
    };
    for row in &deck.pairs {
        let interaction = deck
            .interactions
            .get(&row.interaction)
            .ok_or_else(|| Fault::new(row.line, format!("there is no *SURFACE INTERACTION '{}'", row.interaction)))?;
        if interaction.is_tied {
            for pair in between(deck, bodies, row.line, &row.surfaces, false)? {
                put(pair, PairOptions::tied(0.0), row.line)?;
            }
            continue;
        }
        let options = PairOptions {
            law: interaction.stiffness.map(EnergyLaw::depth),
            friction_coefficient: interaction.friction.filter(|coefficient| *coefficient > 0.0),
            ..PairOptions::default()
        };
        let is_self = row.surfaces[0].eq_ignore_ascii_case(&row.surfaces[1]);
        for pair in between(deck, bodies, row.line, &row.surfaces, is_self)? {
            put(pair, options, row.line)?;
        }
    }
    for row in &deck.ties {
        for pair in between(deck, bodies, row.line, &row.surfaces, false)? {
            put(pair, PairOptions::tied(row.reach), row.line)?;
        }
    }
    let count = bodies.model.parts().len();
    let all = (0..count).flat_map(|a| (a + 1..count).map(move |b| [a, b]));
    let mut pairs: Pairs = all.map(|pair| (pair, (PairOptions::excluded(), 0))).collect();
    pairs.extend(named);
    Ok(pairs)
}

/// Pairs of a body of one surface and one of the other.
fn between<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    line: usize,
    surfaces: &[String; 2],
    is_self: bool,
) -> Result<Vec<[usize; 2]>, Fault> {
    let [a, b] = [bodies_of(deck, bodies, line, &surfaces[0])?, bodies_of(deck, bodies, line, &surfaces[1])?];
    let all = a.iter().flat_map(|&p| b.iter().map(move |&q| [p.min(q), p.max(q)]));
    let pairs: BTreeSet<[usize; 2]> = all.filter(|pair| pair[0] != pair[1] || is_self).collect();
    match pairs.is_empty() {
        true => Err(Fault::new(line, format!("{} and {} are surfaces of one body", surfaces[0], surfaces[1]))),
        false => Ok(pairs.into_iter().collect()),
    }
}

/// Bodies on which a surface lies.
fn bodies_of<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    line: usize,
    name: &str,
) -> Result<BTreeSet<usize>, Fault> {
    let mut found = BTreeSet::new();
    let (instance, is_of_nodes, rows) = surface(deck, line, name)?;
    for row in rows {
        if is_of_nodes {
            for node in deck.names.find(Kind::Node, instance, &row.set, row.line)? {
                let node = bodies.places.node_of[node].ok_or_else(|| {
                    Fault::new(row.line, format!("node {} belongs to no element", deck.mesh.node_tags[node]))
                })?;
                found.extend((0..bodies.model.parts().len()).find(|&body| bodies.model.nodes_of(body).contains(&node)));
            }
        } else {
            let cells = deck.names.find(Kind::Cell, instance, &row.set, row.line)?;
            check_faces(deck, row, &cells)?;
            found.extend(cells.into_iter().map(|cell| bodies.places.body_of[cell]));
        }
    }
    Ok(found)
}

/// Surfaces of elements have only faces that these have, also where nothing uses them.
pub(super) fn check_surfaces(deck: &Deck) -> Result<(), Fault> {
    for (scope, row) in deck.surfaces.rows() {
        for instance in deck.names.instances_of(scope) {
            // Sets that are not there matter where the surface is used.
            if let Ok(cells) = deck.names.find(Kind::Cell, instance, &row.set, row.line) {
                check_faces(deck, row, &cells)?;
            }
        }
    }
    Ok(())
}

/// Cells have the face that a row names, if it names one. Cells of one type are alike.
fn check_faces(deck: &Deck, row: &SurfaceRow, cells: &[usize]) -> Result<(), Fault> {
    let mut known: Vec<&str> = Vec::new();
    for &cell in cells.iter().filter(|_| !row.face.is_empty()) {
        let kind = deck.elements[cell].kind.as_str();
        if !known.contains(&kind) {
            face_number(deck, cell, row)?;
            known.push(kind);
        }
    }
    Ok(())
}
