//! Which boundary facets of a contact stand for faces of the model.

use fmc_contact::Contact;
use std::collections::{BTreeMap, BTreeSet};

/// The facets of every surface, given by faces of the model, each by its nodes. A curved face is several facets, whose points only nodes of
/// that face move. Faces that are no part of the boundary have none.
pub(super) fn facets_of<const D: usize>(contact: &Contact<D>, surfaces: &[Vec<Vec<u32>>]) -> Vec<Vec<usize>> {
    if surfaces.is_empty() {
        return Vec::new();
    }
    let weights = contact.point_weights();
    let movers = |points: &[u32]| -> BTreeSet<u32> {
        let rows = points.iter().flat_map(|&point| weights.row(point as usize));
        rows.filter(|(_, weight)| *weight != 0.0).map(|(node, _)| node).collect()
    };
    let facets: Vec<BTreeSet<u32>> = contact.boundary_facets().iter().map(|facet| movers(&facet.nodes)).collect();
    let mut at_node: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
    for (number, nodes) in facets.iter().enumerate() {
        nodes.iter().for_each(|node| at_node.entry(*node).or_default().push(number));
    }
    let of_face = |face: &Vec<u32>| {
        let nodes: BTreeSet<u32> = face.iter().copied().collect();
        let near: BTreeSet<usize> = face.iter().filter_map(|node| at_node.get(node)).flatten().copied().collect();
        near.into_iter().filter(|&facet| facets[facet].is_subset(&nodes)).collect::<Vec<usize>>()
    };
    surfaces.iter().map(|faces| faces.iter().flat_map(of_face).collect()).collect()
}
