//! Which bodies touch, rub or are tied.

use super::Bodies;
use super::facets::has_curved_faces;
use super::looks::check_looks;
use super::outside::Named;
use super::spread::{Faces, faces};
use super::surfaces::{face_number, surface};
use super::tied_parts::{Part, named_faces, parts_of};
use super::ties::facet_size;
use crate::Fault;
use crate::read::{Deck, Kind, Note, PairRow, SurfaceRow, TieRow};
use fmc_contact::EnergyLaw;
use fmc_contact::contact::{Interface, PairOptions};
use std::collections::{BTreeMap, BTreeSet};

/// Who touches and who is tied.
#[derive(Default)]
pub(crate) struct Pairs {
    /// Options by pair of bodies, also of those that are left out.
    pub(crate) options: BTreeMap<[usize; 2], PairOptions>,
    /// The line that ties a pair.
    pub(crate) tied_by: BTreeMap<[usize; 2], usize>,
    /// Faces that are tied, by their nodes: what options number from 1.
    pub(crate) surfaces: Vec<Vec<Vec<u32>>>,
    /// What contact pairs name, of pairs of bodies that touch by these alone.
    pub(crate) named: Named,
    /// What is taken in another sense than the file may mean.
    pub(crate) notes: Vec<Note>,
}

/// What ties two bodies.
struct Tie {
    reach: f64,
    line: usize,
    parts: [Part; 2],
}

/// The largest pressure by penetration that the file gives, if it gives any; multipliers then leave the penetration as it is, so that all pairs
/// that press need one. A penetration that is `wanted`, above 0, is another rule for the same.
pub(super) fn stiffness(deck: &Deck, wanted: f64) -> Result<Option<f64>, Fault> {
    let of = |row: &PairRow| deck.interactions.get(&row.interaction).and_then(|interaction| interaction.stiffness);
    let Some(row) = deck.pairs.iter().find(|row| of(row).is_some()) else { return Ok(None) };
    if wanted > 0.0 {
        return Err(Fault::new(
            row.line,
            "LINEAR defines the pressure by penetration, so that no penetration tolerance can be set",
        ));
    }
    let is_tied = |row: &PairRow| deck.interactions.get(&row.interaction).is_some_and(|of| of.is_tied);
    match deck.pairs.iter().find(|row| of(row).is_none() && !is_tied(row)) {
        Some(other) => Err(Fault::new(
            other.line,
            format!(
                "LINEAR is supported for all contact pairs or for none, and line {} has it: give this pair a slope",
                row.line
            ),
        )),
        None => Ok(deck.pairs.iter().filter_map(of).reduce(f64::max)),
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
        return Err(Fault::new(row.line, "ADJUST of *CONTACT PAIR is not supported together with *TIE"));
    }
    let all = 0..bodies.model.parts().len();
    let facet = all.map(|body| facet_size(bodies, body)).fold(f64::INFINITY, f64::min);
    Ok(Some([close, close.max(facet)]))
}

/// The pairs that a file names, and that all others are left out.
pub(super) fn pairs<const D: usize>(deck: &Deck, bodies: Bodies<D>) -> Result<Pairs, Fault> {
    let mut pairs = Pairs::default();
    let mut touching: BTreeMap<[usize; 2], (PairOptions, usize)> = BTreeMap::new();
    let mut ties: Vec<TieRow> = Vec::new();
    let all = faces(bodies);
    for row in &deck.pairs {
        let interaction = deck
            .interactions
            .get(&row.interaction)
            .ok_or_else(|| Fault::new(row.line, format!("there is no *SURFACE INTERACTION '{}'", row.interaction)))?;
        if interaction.is_tied {
            ties.push(TieRow { line: row.line, surfaces: row.surfaces.clone(), reach: 0.0 });
            continue;
        }
        let options = PairOptions {
            law: interaction.stiffness.map(EnergyLaw::depth),
            friction_coefficient: interaction.friction.filter(|coefficient| *coefficient > 0.0),
            ..PairOptions::default()
        };
        let is_self = row.surfaces[0].eq_ignore_ascii_case(&row.surfaces[1]);
        let is_all = row.surfaces[0].is_empty();
        let count = bodies.model.parts().len();
        let chosen = match is_all {
            // Rigid surfaces do not press one another.
            true => {
                let every = (0..count).flat_map(|a| (a..count).map(move |b| [a, b]));
                every.filter(|pair| !pair.iter().all(|&body| bodies.places.is_layer[body])).collect()
            }
            false => between(deck, bodies, row.line, &row.surfaces, is_self)?,
        };
        let mut part = Part::new();
        for name in row.surfaces.iter().filter(|_| !is_all) {
            part.extend(named_faces(deck, bodies, &all, (row.line, name))?);
        }
        for pair in chosen {
            let (_, known) = pairs.named.entry(pair).or_insert((row.line, Part::new()));
            known.extend(part.iter().cloned());
            let before = touching.insert(pair, (options, row.line));
            if let Some((_, first)) = before.filter(|(before, _)| *before != options) {
                let [a, b] = names(bodies, pair);
                let message = format!("{a} and {b} are a pair of another kind already, by line {first}");
                return Err(Fault::new(row.line, message));
            }
        }
    }
    // General contact is of all faces.
    if deck.pairs.iter().any(|row| row.surfaces[0].is_empty()) {
        pairs.named.clear();
    }
    ties.extend(deck.ties.iter().cloned());
    let ties = tied(deck, bodies, &all, &ties, &mut pairs.notes)?;
    let count = bodies.model.parts().len();
    let every = (0..count).flat_map(|a| (a + 1..count).map(move |b| [a, b]));
    pairs.options = every.map(|pair| (pair, PairOptions::excluded())).collect();
    pairs.options.extend(touching.iter().map(|(pair, (options, _))| (*pair, *options)));
    let is_linear = touching.values().any(|(options, _)| options.law.is_some());
    for (pair, tie) in ties {
        let both = tie.parts.map(|part| {
            pairs.surfaces.push(part.iter().map(|key| all[key].nodes.clone()).collect());
            pairs.surfaces.len()
        });
        let own = touching.get(&pair).map_or_else(PairOptions::excluded, |(options, _)| *options);
        if !own.excluded && pair.iter().any(|&body| has_curved_faces(bodies, body)) {
            let [a, b] = names(bodies, pair);
            let message =
                format!("{a} and {b} are tied and a contact pair, and have curved faces: known is one of both");
            return Err(Fault::new(tie.line, message));
        }
        let interface = Interface::Tied { reach: tie.reach };
        if let (Some(_), [a, b]) = (own.law, names(bodies, pair)) {
            let message = format!("{a} and {b} are tied and a contact pair with LINEAR: take HARD");
            return Err(Fault::new(tie.line, message));
        }
        let law = is_linear.then(|| EnergyLaw::depth(tie_stiffness(bodies, pair)));
        pairs.options.insert(pair, PairOptions { interface, law, ..own }.between(both));
        pairs.tied_by.insert(pair, tie.line);
    }
    Ok(pairs)
}

/// Traction of a tie by its opening, where LINEAR leaves no multipliers that close it: by so much more than a facet's own that the bodies feel
/// no joint, and by so little that their equations keep ten digits.
fn tie_stiffness<const D: usize>(bodies: Bodies<D>, pair: [usize; 2]) -> f64 {
    const BY_FACET: f64 = 1e6;
    let of = |body: usize| bodies.model.parts()[body].material.young / facet_size(bodies, body);
    BY_FACET * pair.map(of).into_iter().fold(0.0, f64::max)
}

/// What rows tie, by pair of bodies: ties of the same two bodies are one.
fn tied<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    all: &Faces,
    rows: &[TieRow],
    notes: &mut Vec<Note>,
) -> Result<BTreeMap<[usize; 2], Tie>, Fault> {
    let mut found: BTreeMap<[usize; 2], Tie> = BTreeMap::new();
    for TieRow { line, surfaces: [slave, master], reach } in rows {
        let mut parts = |name: &str| parts_of(deck, bodies, all, (*line, name), notes);
        let [slaves, masters] = [parts(slave)?, parts(master)?];
        if let Some(body) = slaves.keys().find(|body| masters.contains_key(body)) {
            let name = &bodies.model.parts()[*body].name;
            let message = format!("{slave} and {master} are surfaces of one body, {name}, which is not tied to itself");
            return Err(Fault::new(*line, message));
        }
        for (pair, parts) in near(bodies, [&slaves, &masters], *reach) {
            let tie =
                found.entry(pair).or_insert_with(|| Tie { reach: *reach, line: *line, parts: Default::default() });
            if tie.reach != *reach {
                let [a, b] = names(bodies, pair);
                let first = tie.line;
                let message = format!("{a} and {b} are tied by line {first} too, and with another POSITION TOLERANCE");
                return Err(Fault::new(*line, message));
            }
            tie.parts.iter_mut().zip(parts).for_each(|(all, part)| all.extend(part.iter().cloned()));
        }
    }
    Ok(found)
}

/// Pairs of bodies of a tie, with the part of either: without those that are clearly farther apart than the reach, unless all are.
fn near<'a, const D: usize>(
    bodies: Bodies<D>,
    [slaves, masters]: [&'a BTreeMap<usize, Part>; 2],
    reach: f64,
) -> Vec<([usize; 2], [&'a Part; 2])> {
    let mut all: Vec<([usize; 2], [&Part; 2])> = Vec::new();
    for (&p, slave) in slaves {
        let of = |(&q, master)| if p < q { ([p, q], [slave, master]) } else { ([q, p], [master, slave]) };
        all.extend(masters.iter().map(of));
    }
    let is_near = |(pair, parts): &([usize; 2], [&Part; 2])| {
        // By default the reach is a tenth of this.
        let size = pair.iter().map(|&body| facet_size(bodies, body)).fold(0.0, f64::max);
        let within = if reach > 0.0 { 2.0 * reach } else { size };
        let [a, b] = parts.map(|part| {
            let nodes = part.iter().flatten().map(|&node| bodies.model.coords()[node as usize]);
            nodes.fold([[f64::INFINITY; D], [f64::NEG_INFINITY; D]], |[low, high], x| {
                [std::array::from_fn(|k| low[k].min(x[k])), std::array::from_fn(|k| high[k].max(x[k]))]
            })
        });
        (0..D).all(|k| a[0][k] - b[1][k] <= within && b[0][k] - a[1][k] <= within)
    };
    if all.iter().any(is_near) {
        all.retain(is_near);
    }
    all
}

fn names<const D: usize>(bodies: Bodies<D>, pair: [usize; 2]) -> [String; 2] {
    pair.map(|body| bodies.model.parts()[body].name.clone())
}

/// Pairs of a body of one surface and one of the other.
fn between<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    line: usize,
    surfaces: &[String; 2],
    is_self: bool,
) -> Result<Vec<[usize; 2]>, Fault> {
    let both = [bodies_of(deck, bodies, line, &surfaces[0])?, bodies_of(deck, bodies, line, &surfaces[1])?];
    check_looks(deck, bodies, (line, surfaces), &both)?;
    let [a, b] = both;
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
