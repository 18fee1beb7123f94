//! Across the normal of most of its boundary an overlap is often thin: the layer in which it lies.
//!
//! The region of a pair is a box along the axes, fat where a face is tilted. The overlap lies no farther out than either body
//! reaches within that box.

use super::bounds::Bounds;
use super::main_normal::MainNormal;
use super::region::Region;
use super::sides::{Counterpart, Pair};
use crate::configuration::FacetSide;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::convex_piece::{Piece, clip_to_box, place};
use crate::geometry::primitives::facet::area_vector;

impl<const D: usize> Pair<'_, D> {
    /// The direction in which most of the boundary in the pair's region looks.
    pub(crate) fn main_normal(&self, region: &Region<D>) -> Option<MainNormal<D>> {
        *region.main_normal.get_or_init(|| {
            let mut areas = Vec::new();
            add_areas(&self.a, (&region.facets[0], 1.0), &region.aabb, &mut areas);
            if let Counterpart::Facets(b) = &self.counterpart {
                add_areas(b, (&region.facets[1], -1.0), &region.aabb, &mut areas);
            }
            MainNormal::of(&areas)
        })
    }

    /// What holds the overlap of the pair in its region: the box, and of two bodies the layer across the main normal.
    pub(crate) fn bounds<'r>(&self, region: &'r Region<D>) -> &'r Bounds<D> {
        region.bounds.get_or_init(|| {
            let aabb = &region.aabb;
            let axis = |i: usize| Vector::from_fn(|j, _| if i == j { 1.0 } else { 0.0 });
            let mut planes: Vec<(Vector<D>, f64)> =
                (0..D).flat_map(|i| [(axis(i), aabb.max[i]), (-axis(i), -aabb.min[i])]).collect();
            if let (Counterpart::Facets(b), Some(main)) = (&self.counterpart, self.main_normal(region)) {
                planes.extend(reach(&self.a, &region.facets[0], aabb, main.normal));
                planes.extend(reach(b, &region.facets[1], aabb, -main.normal));
            }
            Bounds(planes)
        })
    }
}

/// Adds the normals of facets, with the measure of the part of each in a box.
fn add_areas<const D: usize>(
    side: &FacetSide<D>,
    (facets, sign): (&[u32], f64),
    aabb: &Aabb<D>,
    areas: &mut Vec<Vector<D>>,
) {
    let mut piece = Piece::default();
    for &facet in facets {
        let corners = side.corners(facet as usize);
        if aabb.contains(&side.facet_box(facet as usize)) {
            areas.push(area_vector(&corners) * sign);
            continue;
        }
        clip_to_box(&corners, aabb, &mut piece);
        if piece.corners().len() >= D {
            areas.push(area_vector(&corners) * (sign * piece.moments().iter().sum::<f64>()));
        }
    }
}

/// How far a body reaches along a direction within a box, if that is not as far as the box.
///
/// Beyond its facets there the box holds none of its boundary, so that this part of the box is all inside or all outside,
/// and one point tells.
fn reach<const D: usize>(
    side: &FacetSide<D>,
    facets: &[u32],
    aabb: &Aabb<D>,
    normal: Vector<D>,
) -> Option<(Vector<D>, f64)> {
    let (mut level, mut piece) = (f64::NEG_INFINITY, Piece::default());
    for &facet in facets {
        let corners = side.corners(facet as usize);
        clip_to_box(&corners, aabb, &mut piece);
        level = piece.corners().iter().fold(level, |level, w| level.max(normal.dot(&place(&corners, w))));
    }
    level += aabb.rounding();
    let far = Vector::from_fn(|i, _| if normal[i] > 0.0 { aabb.max[i] } else { aabb.min[i] });
    let (farthest, middle) = (normal.dot(&far), normal.dot(&aabb.center()));
    if !level.is_finite() || level >= farthest {
        return None;
    }
    // Half way from there to the plane, or to the middle of the box.
    let part = 0.5 * (farthest - level.max(middle)) / (farthest - middle);
    let point = far + (aabb.center() - far) * part;
    (side.winding_number(&point) == 0).then_some((normal, level))
}

#[cfg(test)]
mod tests {
    use crate::geometry::Vector;
    use crate::overlap::pair::of_meshes::with_pair;
    use crate::overlap::pair::sides::Counterpart;
    use fmc_shapes::{Mesh, Splitmix, cuboid_surface, icosphere};

    /// Every point thrown into a box that is inside both bodies lies within the bounds, and so does the box of the part of
    /// any tetrahedron around it; returns the part of the box that the bounds hold, and the part of it that is overlap.
    fn held(a: &Mesh<3>, b: &Mesh<3>) -> [f64; 2] {
        with_pair(a, b, |pair| {
            let region = pair.region().expect("a region").expect("an overlap");
            let (bounds, aabb) = (pair.bounds(region), region.aabb);
            let Counterpart::Facets(other) = &pair.counterpart else { panic!("two bodies") };
            let mut random = Splitmix::new(7);
            let (mut in_bounds, mut in_overlap) = (0, 0);
            let count = 20_000;
            for _ in 0..count {
                let x = Vector::<3>::from_fn(|i, _| random.between(aabb.min[i], aabb.max[i]));
                let is_held = bounds.may_hold(std::iter::once(x));
                in_bounds += usize::from(is_held);
                if pair.a.winding_number(&x) > 0 && other.winding_number(&x) > 0 {
                    in_overlap += 1;
                    assert!(is_held, "{x:?}");
                    let size = 0.3 * aabb.extent().amax();
                    let mut corners = [x; 4].map(|x| x + Vector::from_fn(|_, _| random.between(-size, size)));
                    corners[3] = x * 4.0 - corners[0] - corners[1] - corners[2];
                    let part = bounds.box_of_part(&corners);
                    assert!(
                        part.inflated(1e-12).contains(&crate::geometry::primitives::aabb::Aabb { min: x, max: x }),
                        "{x:?}"
                    );
                }
            }
            [in_bounds, in_overlap].map(|hits| f64::from(hits as u32) / f64::from(count))
        })
    }

    /// Two blocks that meet by their faces, tilted: the box is fat, and the layer is the overlap but for the side walls.
    #[test]
    fn tilted_faces_meet_in_a_layer() {
        let lower = cuboid_surface([0.0, 0.0, -0.5], [1.0, 1.0, 0.0], [4, 4, 2]);
        let upper = cuboid_surface([0.1, 0.1, -0.01], [0.9, 0.8, 0.5], [3, 3, 2]);
        let tilted = |mesh: &Mesh<3>| mesh.clone().rotated([1.0, 2.0, 3.0], 0.7);
        let [in_bounds, in_overlap] = held(&tilted(&lower), &tilted(&upper));
        assert!(in_overlap > 0.0 && in_bounds < 0.05, "{in_bounds} {in_overlap}");
    }

    #[test]
    fn nothing_of_an_overlap_is_left_out() {
        let ball = icosphere(1.0, 3);
        let moved = |z: f64| ball.clone().rotated([1.0, 2.0, 3.0], 0.4).translated([0.3, 0.2, z]);
        for (other, most) in
            [(moved(1.9), 0.9), (moved(0.4), 1.0), (icosphere(0.4, 2).translated([0.1, 0.0, 0.9]), 1.0)]
        {
            let [in_bounds, in_overlap] = held(&ball, &other);
            assert!(in_overlap > 0.01 && in_overlap <= in_bounds && in_bounds <= most, "{in_bounds} {in_overlap}");
        }
        let cube = cuboid_surface([0.0; 3], [1.0; 3], [2; 3]);
        let corner = cube.clone().rotated([1.0, -1.0, 0.0], 0.955).translated([0.3, 0.2, 0.8]);
        let [in_bounds, in_overlap] = held(&cube, &corner);
        assert!(in_overlap > 0.0, "{in_bounds} {in_overlap}");
    }
}
