//! The depth field of all bodies.

use super::cell_division::CellDivision;
use super::cell_parts::{own_points, parts};
use super::curves::Curves;
use super::distances::Distances;
use super::divisions::{CellPoint, CellSimplex, Divisions};
use super::near_surface::NearSurface;
use super::node_depths::{CELLS_BETWEEN, node_depths};
use super::point_origin::PointOrigin;
use crate::geometry::boundary::symmetry::Symmetry;
use crate::geometry::mesh::cells::Cells;
use crate::geometry::mesh::components::Components;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::nearest_on_facet::nearest;
use crate::geometry::{CellType, Surface, Vector, Weighting};

/// Depth below the surface of its body at every point of every cell.
///
/// It is linear between the nodes, at which it is the distance from the surface. This alone would vanish on edges, faces
/// and cells all of whose nodes lie on the surface, which line every edge of a mesh of tetrahedra; so those of them that
/// lie below the surface have points of their own, and the field has slope 1 below every facet.
///
/// Faces in a plane of symmetry are no surface: the body goes on behind them.
pub(crate) struct DepthField<const D: usize> {
    /// Depth of every node, and the facet that is nearest to it.
    pub(super) nodes: Vec<f64>,
    pub(super) anchors: Vec<u32>,
    /// How cells are divided, by number: one for each type of cell, then one for every cell that has nodes on the surface.
    pub(super) divisions: Divisions,
    pub(super) division_of: Vec<u32>,
    /// Whether a body's cells hang together by faces.
    connected: Vec<bool>,
    /// Whether it was said which faces are no surface.
    is_surface_told: bool,
    /// How far the round surface that a facet stands for lies beside it, by facet.
    sags: Vec<f64>,
    /// Faces that are known to be curved, if there are some.
    curves: Option<Curves<D>>,
    /// Whether straight faces stand for a smooth surface.
    is_smoothed: bool,
}

/// In the order of their numbers.
const TYPES: [CellType; 6] =
    [CellType::Tri3, CellType::Quad4, CellType::Tet4, CellType::Hex8, CellType::Wedge6, CellType::Pyramid5];

impl<const D: usize> DepthField<D> {
    /// The field of a surface that has cells; `None` for one that has none. Faces in planes of symmetry are no surface, nor is what
    /// lies on an axis. With a feature angle, in radians, straight faces that meet at a smaller one stand for a smooth surface. `check` is called now and then, and may unwind.
    pub(crate) fn new(
        surface: &Surface<D>,
        symmetry: Option<&Symmetry<D>>,
        weighting: Weighting,
        feature_angle: Option<f64>,
        check: &dyn Fn(),
    ) -> Option<Self> {
        Self::divided(surface, symmetry, (weighting, feature_angle), check, (false, &mut |_, _| ()))
    }

    /// The same; also divided `about_centres` where that changes no depth here, but does as soon as the reference moves. Tells of
    /// every cell that has nodes on the surface where its points come from.
    pub(super) fn divided(
        surface: &Surface<D>,
        symmetry: Option<&Symmetry<D>>,
        (weighting, feature_angle): (Weighting, Option<f64>),
        check: &dyn Fn(),
        (about_centres, tell): (bool, &mut dyn FnMut(usize, Vec<PointOrigin>)),
    ) -> Option<Self> {
        let cells = surface.cells.as_ref()?;
        let coords = surface.reference();
        let rounding = match weighting {
            Weighting::Plain => 0.0,
            Weighting::Axisymmetric => match &surface.submesh {
                Some(submesh) => submesh.reference_box.rounding(),
                None => Aabb::of(&surface.points(coords)).rounding(),
            },
        };
        let goes_on = |nodes: &[u32]| {
            let places: Vec<Vector<D>> = nodes.iter().map(|&node| coords[node as usize].into()).collect();
            weighting.is_axis(&places, rounding) || symmetry.is_some_and(|symmetry| symmetry.has(nodes, &places))
        };
        let is_cut =
            |cell: usize, face: usize| surface.submesh.as_ref().is_some_and(|submesh| submesh.is_cut_face(cell, face));
        let is_surface = |cell: usize, face: usize| !is_cut(cell, face) && !goes_on(&cells.face_nodes(cell, face));
        let surface_faces: Vec<u8> = (0..cells.len())
            .map(|cell| {
                let boundary = (0..8).filter(|face| cells.boundary[cell] >> face & 1 == 1);
                boundary.filter(|&face| is_surface(cell, face)).fold(0, |mask, face| mask | 1 << face)
            })
            .collect();
        let facet_is_surface = |facet: usize| {
            let is_surface = surface.is_surface_facet(facet);
            let nodes = surface.facets[facet].iter().flat_map(|&v| surface.nodes_of_vertex(v));
            is_surface && !goes_on(&nodes.map(|(node, _)| node).collect::<Vec<_>>())
        };
        let distances = Distances::new(surface, coords, facet_is_surface);
        let (nodes, anchors) = node_depths(cells, coords, &surface_faces, &distances, check);
        let mut divisions = Divisions::default();
        TYPES.into_iter().for_each(|cell_type| add_ordinary(&mut divisions, cell_type));
        let near = NearSurface::new(cells, coords, &nodes, &surface_faces, &distances);
        let division_of = (0..cells.len()).map(|cell| {
            if cell.is_multiple_of(CELLS_BETWEEN) {
                check();
            }
            if cells.nodes(cell).iter().all(|&n| nodes[n as usize] > 0.0) {
                return TYPES.iter().position(|t| *t == cells.cell_type(cell)).unwrap_or(0) as u32;
            }
            let of_cell = CellDivision::new(&near, cell, about_centres);
            let number = divisions.add(&of_cell.points, &of_cell.simplices);
            tell(cell, of_cell.origins);
            number
        });
        let division_of: Vec<u32> = division_of.collect();
        let connected = connected_bodies(cells, surface.body_count());
        let is_surface_told = symmetry.is_some();
        let sags = surface.sags(facet_is_surface);
        let curves = Curves::new(surface, cells, (&divisions, &division_of), (facet_is_surface, feature_angle));
        let is_smoothed = feature_angle.is_some();
        Some(Self { nodes, anchors, divisions, division_of, connected, is_surface_told, sags, curves, is_smoothed })
    }

    /// The point of the surface that is nearest to a node below it without deformation, as nodes and their weights; `None`
    /// for a node on the surface.
    pub(crate) fn anchor<'a>(
        &self,
        surface: &'a Surface<D>,
        node: u32,
    ) -> Option<impl Iterator<Item = (u32, f64)> + use<'a, D>> {
        if self.nodes[node as usize] <= 0.0 {
            return None;
        }
        let (vertices, reference) = (surface.facets[self.anchors[node as usize] as usize], surface.reference());
        let place = |n: u32| Vector::<D>::from(reference[n as usize]);
        let corners = vertices
            .map(|v| surface.nodes_of_vertex(v).fold(Vector::zeros(), |x, (node, weight)| x + place(node) * weight));
        let weights = nearest(&corners, &place(node));
        let of_corner = vertices.into_iter().zip(weights);
        Some(
            of_corner.flat_map(|(v, weight)| surface.nodes_of_vertex(v).map(move |(node, part)| (node, weight * part))),
        )
    }

    /// The facet that is nearest to a node below the surface without deformation.
    pub(crate) fn nearest_facet(&self, node: u32) -> Option<usize> {
        (self.nodes[node as usize] > 0.0).then(|| self.anchors[node as usize] as usize)
    }

    /// Whether it was said which faces are no surface.
    pub(crate) fn is_surface_told(&self) -> bool {
        self.is_surface_told
    }

    /// Whether straight faces that meet at less than some angle stand for a smooth surface.
    pub(crate) fn is_smoothed(&self) -> bool {
        self.is_smoothed
    }

    /// How far the round surface that a facet stands for lies beside it, by facet of all bodies.
    pub(crate) fn sags(&self) -> &[f64] {
        &self.sags
    }

    /// Faces that are known to be curved; `None` where all are flat.
    pub(crate) fn curves(&self) -> Option<&Curves<D>> {
        self.curves.as_ref()
    }

    /// Whether a body's cells hang together by faces.
    pub(crate) fn is_connected(&self, body: usize) -> bool {
        self.connected[body]
    }
}

/// Adds the division of cells of a type that have no nodes on the surface.
fn add_ordinary(divisions: &mut Divisions, cell_type: CellType) {
    let points: Vec<CellPoint> = own_points(cell_type).map(|weights| CellPoint { weights, depth: None }).collect();
    let whole = |corners: [u8; 4]| CellSimplex { corners, is_at_surface: false };
    let simplices: Vec<CellSimplex> = parts(cell_type).map(|part| whole(part.corners)).collect();
    divisions.add(&points, &simplices);
}

/// Whether the cells of each body hang together by faces.
fn connected_bodies(cells: &Cells, bodies: usize) -> Vec<bool> {
    let mut groups = Components::new(cells.len());
    for cell in 0..cells.len() {
        cells.neighbours(cell).for_each(|&next| {
            groups.join(cell as u32, next, false);
        });
    }
    let mut group_of = vec![None; bodies];
    let mut connected = vec![true; bodies];
    for (cell, &body) in cells.body.iter().enumerate() {
        let group = groups.find(cell as u32).0;
        connected[body as usize] &= *group_of[body as usize].get_or_insert(group) == group;
    }
    connected
}
