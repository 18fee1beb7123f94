//! Winding numbers of a body about the facets of another that keep clear of its boundary.
//!
//! Such a facet is all inside or all outside, and so are its neighbours that keep clear as well: the count is the same
//! at the corner that they share. One point decides for all connected facets; and where they reach out of the
//! region in which the two bodies can overlap, they are outside.

use super::near_facets::Facets;
use crate::configuration::FacetSide;
use crate::geometry::Vector;
use crate::geometry::aabb::Aabb;
use crate::geometry::components::Components;

/// What is known of facets that hang together.
#[derive(Clone, Copy)]
enum Cover {
    Unseen,
    Outside,
    /// Number of the point that decides.
    Asked(usize),
}

/// Winding number of `other` about each of some facets of `side`, 0 for those that do not keep clear of its boundary.
///
/// `region` is where the two sides can overlap, a little enlarged.
pub(crate) fn windings<const D: usize>(
    side: &FacetSide<D>,
    facets: &Facets<D>,
    other: &FacetSide<D>,
    region: &Aabb<D>,
) -> Vec<i32> {
    let clear = || (0..facets.numbers.len()).filter(|&f| !facets.is_near[f]);
    let vertices = |f: usize| side.facets[facets.numbers[f] as usize];
    let all = || clear().flat_map(vertices);
    let (Some(first), Some(last)) = (all().min(), all().max()) else { return vec![0; facets.numbers.len()] };
    let mut groups = Components::new((last - first + 1) as usize);
    for f in clear() {
        let vertices = vertices(f);
        vertices[1..].iter().for_each(|v| {
            groups.join(vertices[0] - first, v - first, false);
        });
    }
    let mut cover = vec![Cover::Unseen; (last - first + 1) as usize];
    for f in clear() {
        if facets.corners[f].iter().any(|x| !region.contains(&Aabb { min: *x, max: *x })) {
            cover[groups.find(vertices(f)[0] - first).0 as usize] = Cover::Outside;
        }
    }
    let mut points: Vec<Vector<D>> = Vec::new();
    let group: Vec<Cover> = (0..facets.numbers.len())
        .map(|f| {
            if facets.is_near[f] {
                return Cover::Outside;
            }
            let cover = &mut cover[groups.find(vertices(f)[0] - first).0 as usize];
            if matches!(cover, Cover::Unseen) {
                *cover = Cover::Asked(points.len());
                points.push(facets.corners[f][0]);
            }
            *cover
        })
        .collect();
    let counts: Vec<i32> = points.iter().map(|x| other.winding_number(x)).collect();
    group.iter().map(|cover| if let Cover::Asked(point) = cover { counts[*point] } else { 0 }).collect()
}
