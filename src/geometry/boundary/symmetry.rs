//! Faces in planes of symmetry: they are no surface, since the body goes on behind them.

use super::boundary_facet::BoundaryFacet;
use super::submesh::hash_of;
use crate::Error;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::{Surface, Vector};

/// How far from a plane the points of a face in it may lie, in parts of its longest edge: coordinates from files have seven digits.
const IN_PLANE: f64 = 1e-3;

/// Planes that named nodes may lie in: those of a curved surface lie in as many as it has faces.
const MOST_PLANES: usize = 1000;

/// A plane, whichever way it looks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct SymmetryPlane<const D: usize> {
    point: Vector<D>,
    normal: Vector<D>,
}

/// Where a body goes on behind its faces: planes, and the nodes in them.
#[derive(Clone, Debug)]
pub(crate) struct Symmetry<const D: usize> {
    pub(crate) planes: Vec<SymmetryPlane<D>>,
    /// By node, or by point where there is a division.
    pub(crate) marks: Vec<bool>,
}

/// A face all of whose nodes were named: numbers of these, and its corners without deformation.
#[derive(Clone, Debug)]
pub(crate) struct NamedFace<const D: usize> {
    pub(crate) nodes: Vec<u64>,
    pub(crate) corners: [Vector<D>; D],
}

impl<const D: usize> SymmetryPlane<D> {
    /// Through a point, across a direction.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for a direction that is none.
    pub(crate) fn new(point: &[f64; D], normal: &[f64; D]) -> Result<Self, Error> {
        let normal = Vector::from(*normal);
        let length = normal.norm();
        match (normal / length, point.iter().all(|x| x.is_finite())) {
            (unit, true) if unit.iter().all(|x| x.is_finite()) => Ok(Self { point: (*point).into(), normal: unit }),
            _ => Err(Error::NotPositive { name: "normal of a plane of symmetry", value: length }),
        }
    }

    /// Whether points lie in it, apart from rounding.
    pub(crate) fn contains(&self, points: &[Vector<D>]) -> bool {
        let longest = points.iter().map(|x| (x - points[0]).norm()).fold(0.0, f64::max);
        points.iter().all(|x| self.height(x) <= IN_PLANE * longest)
    }

    pub(crate) fn height(&self, x: &Vector<D>) -> f64 {
        (x - self.point).dot(&self.normal).abs()
    }

    /// Point and normal.
    pub(crate) fn numbers(&self) -> [[f64; D]; 2] {
        [self.point.into(), self.normal.into()]
    }
}

/// Directions across the planes of symmetry in which a vertex lies, each at right angles to those before it.
#[derive(Default)]
pub(crate) struct AcrossPlanes<const D: usize>(Vec<Vector<D>>);

/// A normal with no more than this beside others is one of theirs: faces of one plane tilt as far as their corners are beside it, by rounding of the
/// coordinates in a file, or where a plane is held by springs.
const TILT: f64 = 0.02;

impl<const D: usize> AcrossPlanes<D> {
    /// Adds that of a face in such a plane, by its normal.
    pub(crate) fn add(&mut self, normal: &Vector<D>) {
        self.0.extend(self.taken_from(*normal).try_normalize(TILT));
    }

    pub(crate) fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// What of a vector runs along all of the planes.
    pub(crate) fn taken_from(&self, vector: Vector<D>) -> Vector<D> {
        self.0.iter().fold(vector, |rest, across| rest - across * rest.dot(across))
    }
}

impl<const D: usize> Symmetry<D> {
    /// Whether a face is no surface: all its nodes are marked, and lie in one plane.
    pub(crate) fn has(&self, nodes: &[u32], places: &[Vector<D>]) -> bool {
        let is_marked = |node: &u32| self.marks.get(*node as usize).copied().unwrap_or(false);
        nodes.iter().all(is_marked) && self.planes.iter().any(|plane| plane.contains(places))
    }

    /// Of planes and marks; 0 where nothing is named.
    pub(crate) fn hash(&self) -> u64 {
        if self.planes.is_empty() {
            return 0;
        }
        let marked = (0..self.marks.len()).filter(|&n| self.marks[n]).map(|n| [n as f64 + 1.0]);
        let planes = self.planes.iter().flat_map(SymmetryPlane::numbers).flatten().map(|x| [x]);
        hash_of(&marked.chain(planes).collect::<Vec<[f64; 1]>>())
    }
}

/// The planes in which named faces lie: the fewest that hold all named nodes, those with the most nodes first. A face of the contact
/// surface in a corner between planes has named nodes alone, but each of them lies in a plane that has more.
///
/// # Errors
/// [`Error::Unsupported`] where they lie in too many.
pub(crate) fn planes_of<const D: usize>(mut faces: Vec<NamedFace<D>>) -> Result<Vec<SymmetryPlane<D>>, Error> {
    let area = |face: &NamedFace<D>| area_vector(&face.corners).norm();
    // Large ones say best where their plane is.
    faces.retain(|face| area(face) > 0.0);
    faces.sort_by(|p, q| area(q).total_cmp(&area(p)).then_with(|| p.nodes.cmp(&q.nodes)));
    let mut planes: Vec<(SymmetryPlane<D>, Vec<u64>)> = Vec::new();
    for face in &faces {
        let known = planes.iter().position(|(plane, _)| plane.contains(&face.corners));
        let place = known.unwrap_or_else(|| {
            let normal = area_vector(&face.corners).normalize();
            planes.push((SymmetryPlane { point: face.corners[0], normal }, Vec::new()));
            planes.len() - 1
        });
        planes[place].1.extend(&face.nodes);
        if planes.len() > MOST_PLANES {
            let what = "nodes of a curved surface as nodes in planes of symmetry: name the planes";
            return Err(Error::Unsupported { what });
        }
    }
    for (_, nodes) in &mut planes {
        nodes.sort_unstable();
        nodes.dedup();
    }
    let mut found = Vec::new();
    while let Some(most) = planes.iter().map(|(_, nodes)| nodes.len()).max().filter(|most| *most > 0) {
        let next = planes.iter().position(|(_, nodes)| nodes.len() == most).unwrap_or(0);
        let (plane, held) = planes.swap_remove(next);
        // The order of the others is that of their faces.
        planes.iter_mut().for_each(|(_, nodes)| nodes.retain(|node| held.binary_search(node).is_err()));
        found.push(plane);
    }
    Ok(found)
}

/// Refuses planes of symmetry that leave a body without surface.
///
/// # Errors
/// [`Error::Unsupported`].
pub(crate) fn check_bodies(has_surface: &[bool]) -> Result<(), Error> {
    match has_surface.contains(&false) {
        true => Err(Error::Unsupported { what: "a body whose whole surface lies in planes of symmetry" }),
        false => Ok(()),
    }
}

impl<const D: usize> Surface<D> {
    /// Which bodies have a face that lies in no plane of symmetry. All of a surface without cells, whose planes are not looked at.
    pub(crate) fn bodies_with_surface(&self, symmetry: &Symmetry<D>) -> Vec<bool> {
        let mut has_surface = vec![self.cells.is_none(); self.body_count()];
        for facet in self.facets_of_nodes(symmetry.marks.len()) {
            has_surface[facet.body] |= !symmetry.has(&facet.nodes, &facet.corners);
        }
        has_surface
    }

    /// The facets all of whose nodes are marked, with the numbers of these.
    pub(crate) fn named_faces(&self, marks: &[bool], number: impl Fn(u32) -> u64) -> Vec<NamedFace<D>> {
        let named = self
            .facets_of_nodes(marks.len())
            .into_iter()
            .filter(|facet| !facet.nodes.is_empty() && facet.nodes.iter().all(|&node| marks[node as usize]));
        let numbered = |nodes: Vec<u32>| nodes.into_iter().map(&number).collect();
        named.map(|FacetOfNodes { nodes, corners, .. }| NamedFace { nodes: numbered(nodes), corners }).collect()
    }

    /// The facets of the surface without deformation, with those of their nodes that a host has; none of a surface without cells.
    fn facets_of_nodes(&self, node_count: usize) -> Vec<FacetOfNodes<D>> {
        if self.cells.is_none() {
            return Vec::new();
        }
        let points = self.points(self.reference());
        let facets = self.boundary_facets().into_iter().enumerate().filter(|(facet, _)| self.is_surface_facet(*facet));
        let found = facets.map(|(facet, BoundaryFacet { body, nodes, .. })| FacetOfNodes {
            body,
            // Numbers beyond are middles of faces.
            nodes: nodes.into_iter().filter(|&node| (node as usize) < node_count).collect(),
            corners: self.facets[facet].map(|vertex| points[vertex as usize]),
        });
        found.collect()
    }
}

struct FacetOfNodes<const D: usize> {
    body: usize,
    nodes: Vec<u32>,
    corners: [Vector<D>; D],
}
