//! Errors of the module in the numbers of the files.

use super::assembly::Assembly;
use fmc_contact::{Error, Warning};

/// The sentence for an error about the assembled mesh, with its files and the numbers that they give nodes and cells.
/// `names` are those of the bodies, as far as known.
pub(super) fn explain<const D: usize>(error: &Error, assembly: &Assembly<D>, names: &[String]) -> anyhow::Error {
    // Facets of a surface that was given directly are pieces of cells; all other numbers are those of cells.
    let cell = |number: usize| assembly.cell_origin(assembly.cell_of_error(number));
    let node = |number: usize| assembly.node_origin(number).1;
    let between = |nodes: &[usize; 2]| match nodes.map(node) {
        [a, b] if a == b => format!("node {a}"),
        [a, b] => format!("the edge of nodes {a} and {b}"),
    };
    let sentence = match error {
        Error::NonFiniteCoordinate { node: n, axis } => {
            let file = assembly.node_origin(*n).0;
            format!("{file}: coordinate {} of node {} is not finite", ["x", "y", "z"][*axis], node(*n))
        }
        Error::RepeatedNode { cell: c, node: n } => {
            format!(
                "{}: cell {} names node {} twice, and is no smaller cell: repair it in the mesh generator",
                cell(*c).0,
                cell(*c).1,
                node(*n)
            )
        }
        Error::InvertedCell { cell: c } => {
            format!(
                "{}: cell {} is inverted, as a whole or at a corner: turn the order of its nodes, or move those that are folded over",
                cell(*c).0,
                cell(*c).1
            )
        }
        Error::InvertedCells { cells, bow_ties } => {
            let (place, first) = cell(cells.first().copied().unwrap_or_default());
            let what = match bow_ties {
                0 => "turn the order of their nodes, or move those that are folded over".to_owned(),
                _ => format!(
                    "edges cross in {bow_ties} of them (a bow tie): let their nodes go around the quadrilateral"
                ),
            };
            match cells.len() {
                1 => format!("{place}: cell {first} is inverted: {what}"),
                count => format!("{place}: {count} cells are inverted, the first is {first}: {what}"),
            }
        }
        Error::ZeroMeasure { cell: c } => {
            format!(
                "{}: cell {} has no {}: merge its nodes, or mesh without flat cells",
                cell(*c).0,
                cell(*c).1,
                if D == 2 { "area" } else { "area or volume" }
            )
        }
        Error::OpenSurface { facet, nodes } => format!(
            "{}: its triangles are neither flat (a 2D mesh has one z for all nodes) nor a closed surface: cell {} has \
             no neighbour at {}; close the surface there, or mesh the volume",
            cell(*facet).0,
            cell(*facet).1,
            between(nodes)
        ),
        Error::NonManifold { facet, nodes } => {
            format!(
                "{}: cell {} is the third to meet at {}: divide the bodies by --bodies physical, or by a file each",
                cell(*facet).0,
                cell(*facet).1,
                between(nodes)
            )
        }
        Error::RepeatedCell { cells } => {
            let [(place, a), (_, b)] = cells.map(cell);
            format!("{place}: cells {a} and {b} have the same nodes: one of them is a duplicate, remove it")
        }
        Error::InconsistentOrientation { facet, nodes } => format!(
            "{}: cell {} and its neighbour at {} have opposite orientations: reverse the order of nodes of one of \
             them",
            cell(*facet).0,
            cell(*facet).1,
            between(nodes)
        ),
        Error::NonConforming { cells } => {
            let [(file, a), (other, b)] = cells.map(cell);
            let there = if other == file { String::new() } else { format!(" of {other}") };
            format!(
                "{file}: cell {a} and cell {b}{there} do not conform: an edge has a node in its middle in only one of \
                 them, or they have different nodes there"
            )
        }
        Error::InvertedSurface { body } => {
            let name = usize::try_from(*body).ok().and_then(|body| names.get(body));
            let name = name.unwrap_or(&assembly.meshes[0].file);
            format!("{name}: its facets point inwards; reverse their orientation")
        }
        other => other.to_string(),
    };
    anyhow::Error::msg(sentence)
}

/// Warnings whose nodes have the numbers that the files give them.
pub(super) fn in_numbers_of_files<const D: usize>(warnings: &mut [Warning], assembly: &Assembly<D>) {
    for warning in warnings {
        if let Warning::CoincidingFaces { nodes, .. } = warning {
            nodes.iter_mut().for_each(|node| *node = assembly.node_origin(*node).1 as usize);
        }
    }
}
