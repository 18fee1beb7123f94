//! What ties have tied.

use super::Bodies;
use super::facets::{area, corner_count};
use fmc_contact::contact::Interface;
use fmc_solid::fem::{Face, Model};
use fmc_solid::statics::{Equilibrium, StaticsError};

/// A tie, as it was found where nothing is deformed.
#[derive(Clone, Debug, PartialEq)]
pub struct TieResult {
    /// Names of both bodies.
    pub names: [String; 2],
    /// How far apart faces may be that are tied.
    pub reach: f64,
    /// What is tied, in area (2D: length).
    pub area: f64,
    /// Largest gap that is kept.
    pub gap: f64,
    /// Nodes of the side that holds.
    pub nodes: usize,
    /// Facets of that side whose corners are all tied.
    pub facets: usize,
}

/// Mean size of the facets of a body: the root of their area, in 2D their length.
pub(super) fn facet_size<const D: usize>(bodies: Bodies<D>, body: usize) -> f64 {
    let faces = bodies.model.faces_where(body, |_| true);
    let size = |face: &Face| area(bodies.model.coords(), &face.nodes).powf(1.0 / (D as f64 - 1.0));
    faces.iter().map(size).sum::<f64>() / faces.len().max(1) as f64
}

/// What is tied.
pub(super) fn results<const D: usize>(at: &Equilibrium<D>) -> Result<Vec<TieResult>, StaticsError> {
    let mut found = Vec::new();
    for (bodies, options) in &at.problem().pairs {
        if !matches!(options.interface, Interface::Tied { .. }) {
            continue;
        }
        let Some((summary, nodes)) = at.tie(*bodies)? else { continue };
        let facets = bodies.map(|body| facets(at.model(), body, &nodes)).into_iter().sum();
        let names = bodies.map(|body| at.model().parts()[body].name.clone());
        let (area, gap, reach) = (summary.area, summary.largest_gap, summary.reach);
        found.push(TieResult { names, reach, area, gap, nodes: nodes.len(), facets });
    }
    Ok(found)
}

/// Facets of a body whose corners are all among some nodes.
fn facets<const D: usize>(model: &Model<D>, body: usize, nodes: &[u32]) -> usize {
    let is_tied = |face: &[u32]| face[..corner_count::<D>(face.len())].iter().all(|node| nodes.contains(node));
    model.faces_where(body, |_| true).iter().filter(|face| is_tied(&face.nodes)).count()
}
