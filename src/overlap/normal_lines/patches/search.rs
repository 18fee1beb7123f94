//! The search for the patches of contact: which facets touch together, and along which direction their lines run.
//!
//! An estimator samples the overlap. Facets that face one another across a sample belong together, and so do facets
//! that share a vertex and look much the same way: a patch, whose direction is the mean normal, or several where it
//! wraps around. Two faces that meet at a corner are two patches; the flanks of a wedge in a flat surface are one, by
//! the surface. Patches of equal direction are one. Every other facet belongs to the patch that is nearest along the
//! surface.
//!
//! Of the patches of one overlap, those that are small, or deep beside another, are not contact but the way out
//! sideways: the ends of two blocks that overlap by a strip.

use super::clusters::{Cluster, Touching, number};
use super::directions::nearest;
use super::labels::ALIKE;
use super::partition::Patches;
use super::sample::ContactSample;
use crate::Error;
use crate::geometry::Vector;
use crate::overlap::pair::sides::{Counterpart, Pair};

/// Facets at the ends of a sample face one another if their normals are within 60° of opposite.
const FACING: f64 = -0.5;

/// For which facets the patches of a pair are wanted.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Reach {
    /// Those in the region of contact: for one evaluation. Directions are rounded, so that they do not follow every
    /// change of the coordinates.
    Region,
    /// All: for evaluations at other coordinates too.
    Everywhere,
}

/// The patches of a pair from samples of its contact, or `None` without samples.
pub(crate) fn find<const D: usize>(
    pair: &Pair<D>,
    samples: &[ContactSample<D>],
    reach: Reach,
) -> Result<Option<Patches<D>>, Error> {
    if samples.is_empty() {
        return Ok(None);
    }
    let touching = Touching::new(pair, samples);
    let facing: Vec<bool> = touching.ends.iter().map(|[p, q]| p.outward.dot(&q.outward) < FACING).collect();
    // Where nothing faces anything, as deep inside one another, every sample counts.
    let some_face = facing.iter().any(|facing| *facing);
    let all: Vec<usize> = (0..samples.len()).collect();
    let counted: Vec<usize> = all.iter().copied().filter(|&s| facing[s] || !some_face).collect();
    let mut groups = touching.components(pair, &counted, ALIKE);
    let mut overlaps = touching.components(pair, &all, -2.0);
    let mut clusters: Vec<Cluster<D>> = Vec::new();
    let mut cluster_of_root = vec![u32::MAX; touching.facets.len()];
    for &sample in &counted {
        let Some(facet) = touching.ends[sample].iter().find_map(|end| end.facet) else { continue };
        let place = &mut cluster_of_root[groups.find(facet).0 as usize];
        if *place == u32::MAX {
            *place = clusters.len() as u32;
            clusters.push(Cluster::new(overlaps.find(facet).0));
        }
        let [p, q] = &touching.ends[sample];
        let ContactSample { measures, length, .. } = &samples[sample];
        clusters[*place as usize].add([(p.normal, measures[0]), (q.normal, measures[1])], sample, *length);
    }
    let mut patches = Patches::default();
    let labels_of_clusters = number(&clusters, pair.is_own(), reach == Reach::Region, &mut patches.directions);
    let left_out = clusters.iter().zip(&labels_of_clusters).filter(|(_, labels)| labels.is_empty());
    patches.left_out = left_out.filter_map(|(cluster, _)| cluster.left_out(pair, samples)).collect();
    if patches.directions.len() < 2 {
        // Samples on rigid shapes alone belong to no cluster.
        let direction = patches.directions.first().copied().unwrap_or(touching.ends[0][0].normal);
        let left_out = patches.left_out;
        return Ok((direction.norm() > 0.0).then(|| Patches { left_out, ..Patches::single(direction) }));
    }
    let region = if reach == Reach::Region { pair.region()? } else { None };
    for of_b in [false, true] {
        if of_b && !matches!(pair.counterpart, Counterpart::Facets(_)) {
            continue;
        }
        let side = pair.side(of_b);
        let facets: Vec<u32> = match &region {
            Some(region) => region.facets[usize::from(of_b)].clone(),
            None => pair.surface_facets(of_b).collect(),
        };
        let seeds: Vec<Option<u32>> = facets
            .iter()
            .map(|&facet| {
                let touched = touching.facets.binary_search(&(of_b, facet)).ok()?;
                let cluster = cluster_of_root[groups.find(touched as u32).0 as usize];
                let labels = labels_of_clusters.get(cluster as usize).filter(|labels| !labels.is_empty())?;
                let axes: Vec<Vector<D>> = labels.iter().map(|&label| patches.directions[label as usize]).collect();
                Some(labels[nearest(&axes, &touching.normals[touched])])
            })
            .collect();
        patches.label(of_b, side, facets, &seeds);
    }
    Ok(Some(patches))
}
