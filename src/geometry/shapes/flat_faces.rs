//! The flat faces of a closed surface.

use super::plane_tree::PlaneTree;
use super::ridges::Ridges;
use crate::geometry::Vector;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::primitives::inside::winding_number;
use crate::geometry::primitives::tree::Tree;
use std::cell::Cell;

/// Corners that lie above a face by this part of the surface's extent lie in it: rounding of coordinates is far below, and
/// what the exact integrals shall know is not far above.
pub(crate) const FLAT: f64 = 1e-11;

/// Faces of a rigid surface, each of one or several facets. They are found once, whatever its pose.
pub(crate) struct FlatFaces {
    /// A facet of every face, which gives its plane.
    pub(crate) facets: Vec<u32>,
    /// The face to which a facet belongs.
    pub(crate) face_of: Vec<u32>,
    /// The faces at the edges of each.
    pub(crate) neighbours: Vec<Vec<u32>>,
    /// What is known of them if the surface is convex.
    pub(crate) convex: Option<ConvexFaces>,
}

/// The faces of a convex solid.
pub(crate) struct ConvexFaces {
    /// Corners of each.
    pub(crate) corners: Vec<Vec<u32>>,
    /// Greatest distance of the solid's corners from the plane of each.
    pub(crate) widths: Vec<f64>,
    /// Over their planes.
    pub(crate) planes: PlaneTree,
    /// What lies between them.
    pub(crate) ridges: Ridges,
}

impl FlatFaces {
    /// The faces of the surface of these facets.
    pub(super) fn new<const D: usize>(facets: &[[u32; D]], points: &[Vector<D>]) -> Self {
        let at_edges = at_edges(facets);
        let tolerance = tolerance(points);
        let corners = |facet: usize| facets[facet].map(|corner| points[corner as usize]);
        let mut face_of = vec![u32::MAX; facets.len()];
        let mut of_faces: Vec<u32> = Vec::new();
        // Those without a measure join others, which are found first.
        let has_measure = |facet: &usize| area_vector(&corners(*facet)).norm_squared() > 0.0;
        let slivers = (0..facets.len()).filter(|facet| !has_measure(facet));
        for facet in (0..facets.len()).filter(has_measure).chain(slivers) {
            if face_of[facet] != u32::MAX {
                continue;
            }
            let (number, at) = (of_faces.len() as u32, corners(facet));
            of_faces.push(facet as u32);
            face_of[facet] = number;
            let Some(normal) = area_vector(&at).try_normalize(0.0) else { continue };
            let mut stack = vec![facet];
            while let Some(of_face) = stack.pop() {
                for &next in &at_edges[of_face] {
                    let others = corners(next as usize);
                    let lies_in = others.iter().all(|x| normal.dot(&(x - at[0])).abs() <= tolerance);
                    if face_of[next as usize] == u32::MAX && lies_in && area_vector(&others).dot(&normal) >= 0.0 {
                        face_of[next as usize] = number;
                        stack.push(next as usize);
                    }
                }
            }
        }
        let mut neighbours = vec![Vec::new(); of_faces.len()];
        for (&face, at_edges) in face_of.iter().zip(&at_edges) {
            let others = at_edges.iter().map(|&next| face_of[next as usize]).filter(|&other| other != face);
            neighbours[face as usize].extend(others);
        }
        for of_face in &mut neighbours {
            of_face.sort_unstable();
            of_face.dedup();
        }
        let convex = convex(facets, points, (&of_faces, &face_of));
        Self { facets: of_faces, face_of, neighbours, convex }
    }
}

/// What is known of faces if they are those of a convex solid.
fn convex<const D: usize>(
    facets: &[[u32; D]],
    points: &[Vector<D>],
    (of_faces, face_of): (&[u32], &[u32]),
) -> Option<ConvexFaces> {
    let tolerance = tolerance(points);
    let boxes: Vec<Aabb<D>> = points.iter().map(|x| Aabb { min: *x, max: *x }).collect();
    let tree = Tree::new(&boxes);
    let (mut normals, mut widths) = (Vec::with_capacity(of_faces.len()), Vec::with_capacity(of_faces.len()));
    for &facet in of_faces {
        let corners = facets[facet as usize].map(|corner| points[corner as usize]);
        let normal = area_vector(&corners).try_normalize(0.0)?;
        let beyond = |direction: Vector<D>| farthest(&tree, points, &direction) - direction.dot(&corners[0]);
        if beyond(normal) > tolerance {
            return None;
        }
        widths.push(beyond(-normal));
        normals.push(normal);
    }
    // All faces bound the hull of the corners: inside it is covered as often everywhere.
    let middle = points.iter().fold(Vector::zeros(), |sum, x| sum + x) / points.len() as f64;
    if winding_number(facets, points, &middle) != 1 {
        return None;
    }
    let mut corners: Vec<Vec<u32>> = vec![Vec::new(); of_faces.len()];
    facets.iter().zip(face_of).for_each(|(facet, &face)| corners[face as usize].extend(facet));
    for of_face in &mut corners {
        of_face.sort_unstable();
        of_face.dedup();
    }
    let ridges = Ridges::new(facets, points, face_of);
    Some(ConvexFaces { corners, widths, planes: PlaneTree::new(&normals), ridges })
}

fn tolerance<const D: usize>(points: &[Vector<D>]) -> f64 {
    let aabb = Aabb::of(points);
    FLAT * aabb.extent().amax() + aabb.rounding()
}

/// How far the points of a tree reach along a direction.
fn farthest<const D: usize>(tree: &Tree<D>, points: &[Vector<D>], direction: &Vector<D>) -> f64 {
    let reached = Cell::new(f64::NEG_INFINITY);
    let along =
        |aabb: &Aabb<D>| -> f64 { (0..D).map(|i| (direction[i] * aabb.min[i]).max(direction[i] * aabb.max[i])).sum() };
    tree.visit(
        |aabb| along(aabb) > reached.get(),
        |point| reached.set(reached.get().max(direction.dot(&points[point as usize]))),
    );
    reached.get()
}

/// The facets that have an edge (2D: an end) in common with each.
fn at_edges<const D: usize>(facets: &[[u32; D]]) -> Vec<Vec<u32>> {
    let mut edges: Vec<([u32; 2], u32)> = Vec::with_capacity(D * facets.len());
    for (facet, corners) in facets.iter().enumerate() {
        for k in 0..D {
            let (p, q) = (corners[(k + 1) % D], corners[(k + D - 1) % D]);
            edges.push(([p.min(q), p.max(q)], facet as u32));
        }
    }
    edges.sort_unstable();
    let mut found = vec![Vec::new(); facets.len()];
    for group in edges.chunk_by(|p, q| p.0 == q.0) {
        for (_, facet) in group {
            found[*facet as usize].extend(group.iter().map(|(_, other)| *other).filter(|other| other != facet));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use fmc_shapes::{Mesh, cuboid_surface, icosphere};

    fn faces(mesh: &Mesh<3>) -> FlatFaces {
        let points: Vec<Vector<3>> = mesh.coords.iter().map(|x| Vector::from(*x)).collect();
        FlatFaces::new(&mesh.facets(), &points)
    }

    #[test]
    fn facets_in_one_plane_are_one_face() {
        let of_box = faces(&cuboid_surface([0.0; 3], [1.0, 2.0, 3.0], [3, 4, 5]));
        assert_eq!((of_box.facets.len(), of_box.neighbours.iter().map(Vec::len).sum::<usize>()), (6, 24));
        let convex = of_box.convex.expect("a box is convex");
        let mut widths = convex.widths.clone();
        widths.sort_by(f64::total_cmp);
        assert_eq!(widths, [1.0, 1.0, 2.0, 2.0, 3.0, 3.0]);
        assert_eq!(convex.corners.iter().map(Vec::len).sum::<usize>(), 2 * (4 * 5 + 5 * 6 + 4 * 6));
    }

    #[test]
    fn a_dent_is_not_convex() {
        let mut ball = icosphere(1.0, 2);
        assert!(faces(&ball).convex.is_some_and(|convex| convex.widths.len() == 320));
        ball.coords[17].iter_mut().for_each(|x| *x *= 0.9);
        let dented = faces(&ball);
        assert!(dented.convex.is_none() && dented.facets.len() == 320);
    }
}
