//! Whether a body is nowhere inside out in a part of space, decided from its facets there.
//!
//! Where no two facets cross, the winding number on either side of a surface does not change along it. So one point tells
//! for all facets that hang together inside the region, and they bound every part of it.

use super::FacetSide;
use crate::geometry::Vector;
use crate::geometry::mesh::components::Components;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::convex_piece::{Piece, clip_to_box, place};
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::quadrature::mean;

/// Winding numbers are counted along the last axis. A facet that is seen more nearly edge-on from there does not tell on
/// which of its sides a point lies.
const STEEP: f64 = 1e-3;

impl<const D: usize> FacetSide<'_, D> {
    /// Whether its winding number is nowhere negative in `region`, which these facets of it meet: true only if so.
    pub(crate) fn is_upright_in(&self, facets: &[u32], region: &Aabb<D>) -> bool {
        self.is_upright || !self.may_cross_among(facets) && self.sheets_are_upright(facets, region)
    }

    fn sheets_are_upright(&self, facets: &[u32], region: &Aabb<D>) -> bool {
        let mut sheets = self.sheets(facets, region);
        // The flattest facet of every sheet, as seen along the axis: a point of it in the region.
        let mut flattest: Vec<Option<(f64, u32, Vector<D>)>> = vec![None; facets.len()];
        let mut piece = Piece::default();
        for (i, &facet) in facets.iter().enumerate() {
            let corners = self.corners(facet as usize);
            if clip_to_box(&corners, region, &mut piece).is_empty() {
                continue;
            }
            let area = area_vector(&corners);
            let flatness = area[D - 1].abs() / area.norm();
            let best = &mut flattest[sheets.find(i as u32).0 as usize];
            if !best.is_some_and(|(most, _, _)| most >= flatness) {
                *best = Some((flatness, facet, place(&corners, &mean(piece.corners()))));
            }
        }
        flattest.into_iter().flatten().all(|(flatness, facet, point)| {
            let below = self.winding_number_along(&point, D - 1, Some(facet));
            // Above the facet the line is inside once more, or once less.
            let above = if area_vector(&self.corners(facet as usize))[D - 1] > 0.0 { below - 1 } else { below + 1 };
            flatness > STEEP && below >= 0 && above >= 0
        })
    }

    /// Which facets hang together across edges in the region.
    fn sheets(&self, facets: &[u32], region: &Aabb<D>) -> Components {
        let mut sheets = Components::new(facets.len());
        // An edge by its vertices, the smaller first (2D: by its vertex), and the facet that has it.
        let mut edges: Vec<([u32; 2], u32)> = Vec::with_capacity(D * facets.len());
        for (i, &facet) in facets.iter().enumerate() {
            let of = &self.facets[facet as usize];
            for k in 0..D {
                let [p, q] = [of[k], of[(k + 1) % D]];
                let [p, q] = if D == 2 { [p, p] } else { [p.min(q), p.max(q)] };
                let is_inside = |v: u32| {
                    let x = self.points[v as usize];
                    region.contains(&Aabb { min: x, max: x })
                };
                if is_inside(p) || is_inside(q) {
                    edges.push(([p, q], i as u32));
                }
            }
        }
        edges.sort_unstable();
        for same in edges.chunk_by(|a, b| a.0 == b.0) {
            // Where more than two facets meet in an edge, each stands by itself.
            if let [(_, a), (_, b)] = same {
                sheets.join(*a, *b, false);
            }
        }
        sheets
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::configuration::FacetTree;
    use crate::geometry::{Bodies, Surface};
    use fmc_shapes::{Mesh, cuboid_surface, icosphere};

    /// Whether a mesh is found upright, by its facets in a box, and whether they may cross.
    fn upright_and_crossing(mesh: &Mesh<3>, facets: &[[u32; 3]], region: &Aabb<3>) -> [bool; 2] {
        let surface = Surface::from_facets(&mesh.coords, facets, Bodies::Ids(&vec![0; facets.len()]));
        // What encloses a negative volume is refused; its facets are the same.
        let flipped: Vec<[u32; 3]> = facets.iter().map(|[a, b, c]| [*a, *c, *b]).collect();
        let is_flipped = surface.is_err();
        let surface =
            surface.or_else(|_| Surface::from_facets(&mesh.coords, &flipped, Bodies::Ids(&vec![0; flipped.len()])));
        let surface = surface.expect("a closed surface");
        let facets: Vec<[u32; 3]> = match is_flipped {
            true => surface.facets.iter().map(|[a, b, c]| [*a, *c, *b]).collect(),
            false => surface.facets.clone(),
        };
        let points = surface.points(&mesh.coords);
        let tree = FacetTree::new(&facets, &surface.vertices[0], &points);
        let (aabb, is_upright) = (tree.aabb(), false);
        let side = FacetSide { facets: &facets, points: &points, tree: &tree, aabb, is_upright, rigid: None };
        let found = side.facets_in(region);
        assert!(!found.is_empty());
        [side.is_upright_in(&found, region), side.may_cross_itself()]
    }

    fn everywhere(mesh: &Mesh<3>) -> Aabb<3> {
        Aabb::of(&mesh.coords.iter().map(|x| Vector::from(*x)).collect::<Vec<_>>()).inflated(0.1)
    }

    fn cap() -> Aabb<3> {
        Aabb { min: Vector::<3>::new(-0.5, -0.5, 0.7), max: Vector::<3>::new(0.5, 0.6, 1.1) }
    }

    #[test]
    fn bodies_with_edges_and_corners_are_upright() {
        let block = cuboid_surface([0.0; 3], [1.0; 3], [5, 4, 6]).rotated([1.0, 2.0, 3.0], 0.4);
        assert_eq!(upright_and_crossing(&block, &block.facets(), &everywhere(&block)), [true, false]);
        let ball = icosphere(1.0, 3);
        assert_eq!(upright_and_crossing(&ball, &ball.facets(), &everywhere(&ball)), [true, false]);
        assert_eq!(upright_and_crossing(&ball, &ball.facets(), &cap()), [true, false]);
    }

    /// Facets of two faces that meet at an edge of a block along the axes have boxes that touch, and no plane of either between them.
    #[test]
    fn facets_about_the_edges_of_a_block_along_the_axes_do_not_cross() {
        for cells in [[1, 1, 1], [3, 2, 4], [5, 6, 7]] {
            let block = cuboid_surface([0.0; 3], [1.0, 0.8, 1.3], cells);
            assert_eq!(upright_and_crossing(&block, &block.facets(), &everywhere(&block)), [true, false], "{cells:?}");
        }
    }

    #[test]
    fn inside_out_is_not_upright() {
        let ball = icosphere(1.0, 3);
        let flipped: Vec<[u32; 3]> = ball.facets().iter().map(|[a, b, c]| [*a, *c, *b]).collect();
        assert_eq!(upright_and_crossing(&ball, &flipped, &everywhere(&ball)), [false, false]);
        assert_eq!(upright_and_crossing(&ball, &flipped, &cap()), [false, false]);
    }

    /// A ball whose top is pushed through its bottom: inside out there, upright above.
    #[test]
    fn a_fold_is_found_where_it_is() {
        let mut ball = icosphere(1.0, 3);
        for x in &mut ball.coords {
            if x[2] > 0.8 {
                x[2] -= 2.5;
            }
        }
        let facets = ball.facets();
        assert_eq!(upright_and_crossing(&ball, &facets, &everywhere(&ball)), [false, true]);
        let side = Aabb { min: Vector::<3>::new(0.7, -0.3, -0.3), max: Vector::<3>::new(1.1, 0.3, 0.3) };
        assert!(upright_and_crossing(&ball, &facets, &side)[0]);
        let below = Aabb { min: Vector::<3>::new(-0.3, -0.3, -1.9), max: Vector::<3>::new(0.3, 0.3, -1.3) };
        assert!(!upright_and_crossing(&ball, &facets, &below)[0]);
    }
}
