//! Faces of analytical surfaces.

use super::{Faces, front_face, group, tag_nodes};
use crate::Fault;
use crate::profile::{Sweep, Swept, path, swept};
use crate::read::analytical::{Analytical, Shape};
use crate::read::deck::Deck;
use crate::read::elements::ElementRow;
use crate::read::names::Kind;
use crate::read::note::Note;
use crate::read::rigid::Members;
use std::collections::{BTreeMap, BTreeSet};

/// The set of elements of an analytical surface, which no file can name.
fn set_of(name: &str) -> String {
    format!("FACES OF {}", name.to_uppercase())
}

/// Adds the faces of all analytical surfaces.
pub(super) fn add_analytical(
    deck: &mut Deck,
    faces: &mut Faces,
    (first, dimension): (usize, usize),
) -> Result<(), Fault> {
    let mut is_used: BTreeSet<usize> = BTreeSet::new();
    let mut next =
        deck.mesh.cells().map(|(_, _, label, _)| label).chain(faces.labels.iter().copied()).max().unwrap_or(0);
    for number in 0..deck.rigid.len() {
        let (line, scope) = (deck.rigid[number].line, deck.rigid[number].scope.clone());
        for place in 0..deck.rigid[number].members.len() {
            let Members::Analytical(name) = deck.rigid[number].members[place].clone() else { continue };
            let mut known: BTreeMap<usize, Vec<(u64, usize)>> = BTreeMap::new();
            for of_body in deck.names.instances_of(&scope) {
                let (instance, rest) = match of_body {
                    None => deck.names.split(&name),
                    some => (some, name.as_str()),
                };
                let scopes = deck.names.scopes_of(instance);
                let found = scopes.into_iter().find_map(|scope| Some((deck.surfaces.get(scope.clone(), rest)?, scope)));
                let Some((surface, of_surface)) = found else {
                    return Err(Fault::new(line, format!("there is no surface '{name}'")));
                };
                let Some(analytical) = surface.analytical.clone() else {
                    return Err(Fault::new(
                        line,
                        format!("'{name}' is no analytical surface: its elements take ELSET"),
                    ));
                };
                let rest = rest.to_owned();
                let labels = match known.get(&analytical.line) {
                    Some(labels) => labels.clone(),
                    None if !is_used.insert(analytical.line) => {
                        return Err(Fault::new(line, format!("'{name}' is of another *RIGID BODY already")));
                    }
                    None => {
                        let count = fronts(deck, &analytical, instance, dimension)?.1.len() as u64;
                        let labels: Vec<(u64, usize)> =
                            (1..=count).map(|k| (next.saturating_add(k), analytical.line)).collect();
                        next = next.saturating_add(count);
                        deck.names.put(Kind::Cell, &of_surface, &set_of(&rest), analytical.line, &labels);
                        known.insert(analytical.line, labels.clone());
                        labels
                    }
                };
                let (points, fronts, off) = fronts(deck, &analytical, instance, dimension)?;
                deck.mesh.points.extend(points);
                tag_nodes(deck);
                let of_instance = instance.map(|number| number as i64 + 1);
                let of_name = of_instance.unwrap_or_else(|| group(deck, &rest));
                let row = ElementRow {
                    line: analytical.line,
                    keyword: analytical.line,
                    kind: "ANALYTICAL SURFACE".to_owned(),
                };
                tell_shape(deck, &analytical, &name, (fronts.len(), off));
                for (front, (label, _)) in fronts.into_iter().zip(labels) {
                    deck.names.add_cell(instance, label, first + faces.fronts.len(), &front.corners);
                    faces.push(front, row.clone(), (label, Some(of_name)), Some(true));
                }
            }
            let before = name.len() - deck.names.split(&name).1.len();
            deck.rigid[number].members[place] =
                Members::Elements(format!("{}{}", &name[..before], set_of(&name[before..])));
        }
    }
    for (line, name) in deck.surfaces.place_analytical(front_face(dimension), &set_of) {
        if !is_used.contains(&line) {
            let message = format!("no *RIGID BODY has this surface: it needs ANALYTICAL SURFACE={name} and a REF NODE");
            return Err(Fault::new(line, message));
        }
    }
    Ok(())
}

/// Degrees of an arc in one face, at most.
const OF_PLANE: f64 = 5.0;
const OF_SPACE: f64 = 10.0;

/// Nodes and faces of an analytical surface of an instance, and how far these lie beside it.
fn fronts(deck: &Deck, surface: &Analytical, instance: Option<usize>, dimension: usize) -> Result<Swept, Fault> {
    let Analytical { line, shape, profile, frame, .. } = surface;
    if (*shape == Shape::Segments) != (dimension == 2) {
        let known = if dimension == 2 { "SEGMENTS" } else { "CYLINDER and REVOLUTION" };
        return Err(Fault::new(*line, format!("this is no analytical surface in {dimension}D: known are {known}")));
    }
    let motion = instance.map(|number| deck.mesh.instances[number].motion.clone()).unwrap_or_default();
    let used = deck.mesh.cells().flat_map(|(_, nodes, ..)| nodes.iter().map(|&node| deck.mesh.points[node as usize]));
    let used: Vec<[f64; 3]> = used.collect();
    let height = used.first().map_or(0.0, |x| x[2]);
    // All bodies, and as much again to either side: the surface has no end there.
    let place = |local: [f64; 3]| -> [f64; 3] {
        motion.place(std::array::from_fn(|k| {
            frame.origin[k] + (0..3).map(|axis| local[axis] * frame.axes[axis][k]).sum::<f64>()
        }))
    };
    let [origin, along] = [place([0.0; 3]), place([0.0, 0.0, 1.0])];
    let ends = used.iter().map(|x| (0..3).map(|k| (x[k] - origin[k]) * (along[k] - origin[k])).sum::<f64>());
    let [low, high] = ends.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], s| [low.min(s), high.max(s)]);
    let sweep = match shape {
        Shape::Segments => Sweep::Plane,
        Shape::Cylinder => Sweep::Along([2.0 * low - high, 2.0 * high - low]),
        Shape::Revolution => Sweep::Around((360.0 / OF_SPACE) as usize),
    };
    let path = path(profile, if dimension == 2 { OF_PLANE } else { OF_SPACE })?;
    let (mut points, fronts, off) =
        swept(&path, frame, sweep, deck.mesh.points.len()).map_err(|message| Fault::new(*line, message))?;
    points.iter_mut().for_each(|x| *x = motion.place(*x));
    if dimension == 2 {
        points.iter_mut().for_each(|x| x[2] = height);
        let below = points.iter().find(|x| deck.is_axisymmetric() && x[0] < 0.0);
        if let Some(x) = below {
            return Err(Fault::new(*line, format!("a radius of {} is below 0", x[0])));
        }
    }
    Ok((points, fronts, off))
}

/// Says by what faces an analytical surface is, and around which axis where the file does not tell.
fn tell_shape(deck: &mut Deck, surface: &Analytical, name: &str, (count, off): (usize, f64)) {
    let beside = if off > 0.0 { format!(", at most {off:.1e} beside its arcs") } else { String::new() };
    deck.notes.push(Note::new(surface.line, format!("{name} is taken as {count} faces of second order{beside}")));
    if surface.shape == Shape::Revolution && surface.has_own_axes {
        deck.notes.push(Note::new(
            surface.line,
            format!("{name} turns about the second axis of its part, as it names no axis"),
        ));
    }
}
