//! Whether facets that were given directly close their bodies.

use crate::Error;

/// One end (2D) or one edge (3D) of a facet, as the facet passes it.
struct SilhouettePoint {
    body: i64,
    /// The node twice (2D), or the nodes of the edge, ascending.
    nodes: [u32; 2],
    forward: bool,
    facet: usize,
}

/// Checks that every edge (3D) or node (2D) of each body belongs to two facets that pass it in opposite directions.
pub(crate) fn check_closed<const D: usize>(facets: &[&[u32]], bodies: &[i64]) -> Result<(), Error> {
    let mut silhouettes: Vec<SilhouettePoint> = Vec::with_capacity(D * facets.len());
    for (facet, nodes) in facets.iter().enumerate() {
        for k in 0..nodes.len() {
            let (p, q) = (nodes[k], nodes[(k + 1) % nodes.len()]);
            let (nodes, forward) = if D == 2 { ([p, p], k == 0) } else { ([p.min(q), p.max(q)], p < q) };
            silhouettes.push(SilhouettePoint { body: bodies[facet], nodes, forward, facet });
        }
    }
    silhouettes.sort_unstable_by_key(|r| (r.body, r.nodes, r.facet));
    // The lowest facet in trouble is named, so that the message does not depend on the order of nodes.
    let trouble = |same: &[SilhouettePoint]| {
        let nodes = same[0].nodes.map(|n| n as usize);
        match same {
            [r] => Some((r.facet, Error::OpenSurface { facet: r.facet, nodes })),
            [r, s] if r.forward == s.forward => {
                Some((s.facet, Error::InconsistentOrientation { facet: s.facet, nodes }))
            }
            [_, _] => None,
            [_, _, third, ..] => Some((third.facet, Error::NonManifold { facet: third.facet, nodes })),
            [] => None,
        }
    };
    let same_rim = |r: &SilhouettePoint, s: &SilhouettePoint| r.body == s.body && r.nodes == s.nodes;
    match silhouettes.chunk_by(same_rim).filter_map(trouble).min_by_key(|(facet, _)| *facet) {
        Some((_, error)) => Err(error),
        None => Ok(()),
    }
}
