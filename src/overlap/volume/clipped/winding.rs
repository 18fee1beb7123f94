//! Winding numbers of a body about the facets of another that keep clear of its boundary.
//!
//! Such a facet is all inside or all outside, and so are its neighbours that keep clear as well: the count is the same
//! at the corner that they share. One facet decides for all connected facets; and where they reach out of the
//! region in which the two bodies can overlap, they are outside.

use super::near_facets::Facets;
use crate::configuration::FacetSide;
use crate::geometry::Vector;
use crate::geometry::mesh::components::Components;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::facet::area_vector;

/// What is known of facets that hang together.
#[derive(Clone, Copy)]
enum Cover {
    Unseen,
    Outside,
    /// Number of the facet that decides.
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
    let mut deciding: Vec<usize> = Vec::new();
    let group: Vec<Cover> = (0..facets.numbers.len())
        .map(|f| {
            if facets.is_near[f] {
                return Cover::Outside;
            }
            let cover = &mut cover[groups.find(vertices(f)[0] - first).0 as usize];
            if matches!(cover, Cover::Unseen) {
                *cover = Cover::Asked(deciding.len());
                deciding.push(f);
            }
            *cover
        })
        .collect();
    let counts: Vec<i32> = deciding.iter().map(|&f| winding_about(other, &facets.corners[f])).collect();
    group.iter().map(|cover| if let Cover::Asked(number) = cover { counts[*number] } else { 0 }).collect()
}

/// Winding number of `side` about a facet that its boundary does not cross.
///
/// Counted across the facet, from points within it that no grid has at its nodes: a line from an edge would run along
/// faces that may be as near as rounding. All of them must say that the facet is inside, since one may be met by a
/// corner of the body that touches the facet there.
pub(crate) fn winding_about<const D: usize>(side: &FacetSide<D>, corners: &[Vector<D>; D]) -> i32 {
    let axis = area_vector(corners).iamax();
    let mut least = i32::MAX;
    for first in 0..D {
        let point = (0..D).fold(Vector::zeros(), |x, k| x + corners[(first + k) % D] * PARTS[D - 2][k]);
        least = least.min(side.winding_number_along(&point, axis, None));
        if least <= 0 {
            break;
        }
    }
    least
}

/// Parts of the corners in a point of a facet, in 2D and in 3D.
const PARTS: [[f64; 3]; 2] = [[0.413_7, 0.586_3, 0.0], [0.213_7, 0.339_1, 0.447_2]];
