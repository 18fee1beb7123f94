//! What a name in `*BOUNDARY` or `*CLOAD` stands for: nodes of bodies, and reference nodes.

use super::Bodies;
use super::references::{Reference, Way};
use crate::Fault;
use crate::read::{Deck, Kind};

/// A point that can be held or loaded.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Point {
    /// A node of the model.
    Node(usize),
    /// A reference node, by its number.
    Reference(usize),
    /// The node whose displacements are the rotations of a reference node.
    Rotating(usize),
}

/// Points of a set or label, ascending.
pub(super) fn points<const D: usize>(
    deck: &Deck,
    bodies: Bodies<D>,
    references: &[Reference<D>],
    (set, line): (&str, usize),
) -> Result<Vec<Point>, Fault> {
    let point = |node: usize| {
        let is = |of: &dyn Fn(&Reference<D>) -> bool| references.iter().position(of);
        if let Some(number) = is(&|reference| reference.node == node) {
            return Ok(Point::Reference(number));
        }
        if let Some(number) = is(&|reference| reference.rotating == Some(node)) {
            return Ok(Point::Rotating(number));
        }
        let label = deck.mesh.node_tags[node];
        let of_none = || Fault::new(line, format!("node {label} of '{set}' belongs to no element"));
        bodies.places.node_of[node].map(Point::Node).ok_or_else(of_none)
    };
    let found: Result<Vec<Point>, Fault> =
        deck.names.find(Kind::Node, None, set, line)?.into_iter().map(point).collect();
    let mut found = found?;
    found.sort_unstable();
    Ok(found)
}

/// A degree of freedom that can be held or loaded: a node of the model and an axis; of reference nodes, which are numbered behind them, axes from 3 are rotations.
pub(super) type Freedom = (usize, usize);

/// What is asked of a degree of freedom.
pub(super) struct Asked {
    pub(super) line: usize,
    /// Whether a motion is prescribed, and not a load.
    pub(super) is_motion: bool,
    /// Whether it is by a name as `ENCASTRE`.
    pub(super) is_named: bool,
    pub(super) value: f64,
}

/// The degree of freedom along an axis; none where the point has none and nothing is asked of it but to be held.
pub(super) fn freedom<const D: usize>(
    (deck, bodies): (&Deck, Bodies<D>),
    references: &[Reference<D>],
    (point, axis): (Point, usize),
    asked: &Asked,
) -> Result<Option<Freedom>, Fault> {
    let count = bodies.model.node_count();
    let refused = |message: String| Err(Fault::new(asked.line, message));
    let is_at_rest = asked.is_motion && asked.value == 0.0;
    let number = axis + 1;
    let (reference, axis) = match point {
        Point::Node(node) => {
            let label = deck.mesh.node_tags[bodies.places.nodes[node]];
            let leads = |reference: &&Reference<D>| match reference.way {
                Way::Follows(axes) => axis < 3 && axes[axis] && reference.nodes.binary_search(&node).is_ok(),
                Way::Shares(_) | Way::Loose(_) | Way::Local(_) => false,
            };
            let leader = references.iter().find(leads).filter(|_| asked.is_motion);
            return match (axis, leader) {
                // Solids do not turn: what holds a turn holds nothing there.
                (3.., _) if is_at_rest => Ok(None),
                (3.., _) => refused(format!(
                    "degree of freedom {number} is not known, only 1, 2 and 3: node {label} belongs to a solid and does not turn"
                )),
                // Planes have no third axis; to hold it is no error.
                _ if axis >= D && is_at_rest => Ok(None),
                _ if axis >= D => refused("there is no third degree of freedom in 2D".to_owned()),
                (_, Some(leader)) => refused(format!(
                    "node {label} follows the reference node {} of {}: hold or move that node",
                    leader.label,
                    leader.name()
                )),
                _ => Ok(Some((node, axis))),
            };
        }
        Point::Rotating(_) if axis >= 3 => {
            return refused(format!("a ROT NODE has the degrees of freedom 1 to 3, not {number}"));
        }
        Point::Rotating(reference) => (reference, axis + 3),
        Point::Reference(reference) => (reference, axis),
    };
    let Reference { label, way, .. } = &references[reference];
    let name = references[reference].name();
    let is_of_plane = axis < D || axis == 5;
    match way {
        _ if D == 2 && !is_of_plane && is_at_rest => Ok(None),
        _ if D == 2 && !is_of_plane => {
            refused(format!("there is no degree of freedom {number} in 2D, only 1, 2 and 6"))
        }
        Way::Local(_) if axis >= 3 => match is_at_rest {
            true => Ok(None),
            false => refused(format!(
                "degree of freedom {number} is not known, only 1, 2 and 3: node {label} belongs to a solid and does not turn"
            )),
        },
        Way::Local(axes) => {
            // Along an axis of the space that axis itself is held: planes of symmetry are found by these.
            let along = |k: &usize| axes[axis][*k] == 1.0 || is_at_rest && axes[axis][*k] == -1.0;
            let place = (0..D).find(along).map(|k| (references[reference].nodes[0], k));
            Ok(Some(place.unwrap_or((count + reference, axis))))
        }
        Way::Loose(_) if axis >= 3 && asked.is_named => Ok(None),
        Way::Loose(axes) if axis >= 3 || !axes[axis] => match is_at_rest && axis < 3 {
            true => Ok(None),
            false => refused(format!(
                "no *EQUATION has degree of freedom {number} of node {label}, which belongs to no element"
            )),
        },
        Way::Shares(_) if asked.is_motion => refused(format!(
            "node {label}, of {name}, takes forces and moments, and no motion is prescribed for it: take *KINEMATIC"
        )),
        Way::Shares(forces) if forces[axis].is_none() => {
            refused(format!("degree of freedom {number} of node {label} is not one of {name}"))
        }
        Way::Follows(axes) if axis < 3 && !axes[axis] && is_at_rest => Ok(None),
        Way::Follows(axes) if axis < 3 && !axes[axis] => {
            refused(format!("no node follows node {label} along degree of freedom {number}, by {name}"))
        }
        _ => Ok(Some((count + reference, axis))),
    }
}
