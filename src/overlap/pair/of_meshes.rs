//! Pairs of two meshes, for unit tests.

use super::partner::Partner;
use super::sides::{Counterpart, Pair};
use crate::configuration::{FacetSide, FacetTree};
use crate::geometry::{Bodies, Surface, Weighting};
use crate::ranks::Sharing;
use fmc_shapes::Mesh;
use std::sync::OnceLock;

/// Calls `work` with the pair of two bodies that are bounded by the surfaces of meshes.
pub(crate) fn with_pair<T>(a: &Mesh<3>, b: &Mesh<3>, work: impl FnOnce(&Pair<3>) -> T) -> T {
    let surfaces = [a, b].map(|mesh| {
        let facets = mesh.facets();
        Surface::from_facets(&mesh.coords, &facets, Bodies::Ids(&vec![0; facets.len()])).expect("a closed surface")
    });
    let points = [surfaces[0].points(&a.coords), surfaces[1].points(&b.coords)];
    let trees: [FacetTree<3>; 2] =
        std::array::from_fn(|k| FacetTree::new(&surfaces[k].facets, &surfaces[k].vertices[0], &points[k]));
    let [a_side, b_side]: [FacetSide<3>; 2] = std::array::from_fn(|k| FacetSide {
        facets: &surfaces[k].facets,
        points: &points[k],
        tree: &trees[k],
        aabb: trees[k].aabb(),
        is_upright: true,
        rigid: None,
    });
    work(&Pair {
        partners: [Partner::Body(0), Partner::Body(1)],
        a: a_side,
        counterpart: Counterpart::Facets(b_side),
        pose: None,
        surface: &surfaces[0],
        coords: &a.coords,
        depth: None,
        clearance: 0.0,
        tied: None,
        weighting: Weighting::Plain,
        sharing: Sharing::Alone(None),
        region: OnceLock::new(),
    })
}
