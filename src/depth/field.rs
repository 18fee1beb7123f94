//! The depth field of all bodies.

use super::cell_parts::{Corner, Part, cell_face, parts, weights};
use super::distances::Distances;
use crate::geometry::cells::Cells;
use crate::geometry::components::Components;
use crate::geometry::facet::area_vector;
use crate::geometry::nearest_on_facet::nearest;
use crate::geometry::{CellType, Surface, Vector};

/// Depth below the surface of its body at every point of every cell.
///
/// It is linear between the nodes, at which it is the distance from the surface. This alone would vanish in cells all of
/// whose nodes lie on the surface, which line every edge of a mesh of tetrahedra; so a part of a cell that has a facet,
/// or that has all its corners on the surface, is divided about the centre of its inscribed ball. That has the same
/// distance from all faces, so that the field has slope 1 below every facet.
///
/// Faces in a plane of symmetry are no surface: the body goes on behind them.
pub(crate) struct DepthField<const D: usize> {
    /// Depth of every node, and the facet that is nearest to it.
    nodes: Vec<f64>,
    anchors: Vec<u32>,
    /// Bit f is set where face f of a cell is surface.
    surface_faces: Vec<u8>,
    /// For every cell its number among `boundary_cells`, if it has one.
    boundary_cell_of: Vec<u32>,
    boundary_cells: Vec<BoundaryCell>,
    /// One after the other for the parts of all boundary_cells that are divided.
    incentres: Vec<Incentre>,
    /// Whether a body's cells hang together by faces.
    connected: Vec<bool>,
    /// Whether it was said which faces are no surface.
    is_surface_told: bool,
}

/// What is known of a cell that has nodes on the surface.
struct BoundaryCell {
    /// Depth at the middle of the cell, and at the middles of its faces.
    middle: f64,
    faces: [f64; 6],
    /// Bit p is set where part p is divided; the first of its points among `incentres`.
    divided: u32,
    first: u32,
}

/// A point about which a part is divided.
#[derive(Clone, Copy)]
pub(super) struct Incentre {
    /// Weights of the part's corners.
    pub(super) weights: [f64; 4],
    pub(super) depth: f64,
}

const NO_BOUNDARY: u32 = u32::MAX;

impl<const D: usize> DepthField<D> {
    /// The field of a surface that has cells; `None` for one that has none. Faces all of whose nodes are marked lie in
    /// planes of symmetry.
    pub(crate) fn new(surface: &Surface<D>, in_symmetry_plane: Option<&[bool]>) -> Option<Self> {
        let cells = surface.cells.as_ref()?;
        let coords = surface.reference();
        let marks = in_symmetry_plane.unwrap_or_default();
        let is_marked = |node: u32| marks.get(node as usize).copied().unwrap_or(false);
        let is_surface = |cell: usize, face: usize| !cells.face_nodes(cell, face).into_iter().all(is_marked);
        let surface_faces: Vec<u8> = (0..cells.len())
            .map(|cell| {
                let boundary = (0..8).filter(|face| cells.boundary[cell] >> face & 1 == 1);
                boundary.filter(|&face| is_surface(cell, face)).fold(0, |mask, face| mask | 1 << face)
            })
            .collect();
        let facet_is_surface = |facet: usize| {
            let mut nodes = surface.facets[facet].iter().flat_map(|&v| surface.nodes_of_vertex(v));
            !nodes.all(|(node, _)| is_marked(node))
        };
        let distances = Distances::new(surface, coords, facet_is_surface);
        let (nodes, anchors) = node_depths(cells, coords, &surface_faces, &distances);
        let mut field = Self {
            nodes,
            anchors,
            surface_faces,
            boundary_cell_of: vec![NO_BOUNDARY; cells.len()],
            boundary_cells: Vec::new(),
            incentres: Vec::new(),
            connected: connected_bodies(cells, surface.body_count()),
            is_surface_told: in_symmetry_plane.is_some(),
        };
        for cell in 0..cells.len() {
            let is_boundary = cells.nodes(cell).iter().any(|&n| field.nodes[n as usize] == 0.0);
            if is_boundary {
                field.add_boundary_cell(cells, cell, coords, &distances);
            }
        }
        Some(field)
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

    fn add_boundary_cell(&mut self, cells: &Cells, cell: usize, coords: &[[f64; D]], distances: &Distances<D>) {
        let (body, cell_type) = (cells.body[cell] as usize, cells.cell_type(cell));
        let nodes = cells.nodes(cell);
        let place = |weights: &[f64; 8]| {
            let terms = nodes.iter().zip(weights).map(|(&n, &w)| Vector::<D>::from(coords[n as usize]) * w);
            terms.fold(Vector::zeros(), |x, term| x + term)
        };
        // No farther than a node on the surface.
        let on_surface = nodes.iter().find(|&&n| self.nodes[n as usize] == 0.0);
        let distance = |x: &Vector<D>| {
            let limit = on_surface.map_or(f64::INFINITY, |&n| (x - Vector::from(coords[n as usize])).norm());
            distances.of_point(body, x, limit).0
        };
        let at_face = |face: usize, local: &[usize]| {
            if self.is_surface(cell, face) {
                return 0.0;
            }
            let of_nodes = || local.iter().map(|&k| self.nodes[nodes[k] as usize]);
            // Both cells at the face must say the same: one that has no node on the surface takes the mean.
            if of_nodes().all(|depth| depth > 0.0) {
                return of_nodes().sum::<f64>() / local.len() as f64;
            }
            distance(&place(&weights(cells, cell, Corner::Face(face))))
        };
        let mut here = BoundaryCell { middle: 0.0, faces: [0.0; 6], divided: 0, first: self.incentres.len() as u32 };
        let has_middle = nodes.len() > D + 1;
        if has_middle {
            for (face, local) in cell_type.faces().iter().enumerate() {
                here.faces[face] = at_face(face, local);
            }
            here.middle = distance(&place(&weights(cells, cell, Corner::Middle)));
        }
        let mut incentres = Vec::new();
        for (number, part) in parts(cell_type).enumerate() {
            let has_facet =
                (0..=D).any(|k| cell_face(cell_type, D, &part, k).is_some_and(|f| self.is_surface(cell, f)));
            let is_flat = (0..=D).all(|k| self.corner_depth(cell_type, nodes, Some(&here), part.corners[k]) == 0.0);
            if !has_facet && !is_flat {
                continue;
            }
            let corners: [Vector<D>; 4] = std::array::from_fn(|k| {
                if k <= D { place(&weights(cells, cell, part.corners[k])) } else { Vector::zeros() }
            });
            let Some((weights, radius)) = incentre(&corners) else { continue };
            let middle = (0..=D).fold(Vector::zeros(), |x, k| x + corners[k] * weights[k]);
            let depth = if has_facet { radius } else { distance(&middle) };
            incentres.push(Incentre { weights, depth });
            here.divided |= 1 << number;
        }
        self.incentres.extend(incentres);
        self.boundary_cell_of[cell] = self.boundary_cells.len() as u32;
        self.boundary_cells.push(here);
    }

    /// Whether a face of a cell is surface.
    pub(super) fn is_surface(&self, cell: usize, face: usize) -> bool {
        self.surface_faces[cell] >> face & 1 == 1
    }

    /// Whether it was said which faces are no surface.
    pub(crate) fn is_surface_told(&self) -> bool {
        self.is_surface_told
    }

    /// Whether a body's cells hang together by faces.
    pub(crate) fn is_connected(&self, body: usize) -> bool {
        self.connected[body]
    }

    /// Depth at a corner of a part.
    fn corner_depth(&self, cell_type: CellType, nodes: &[u32], here: Option<&BoundaryCell>, corner: Corner) -> f64 {
        let mean = |local: &mut dyn ExactSizeIterator<Item = usize>| {
            let count = local.len();
            local.map(|k| self.nodes[nodes[k] as usize]).sum::<f64>() / count as f64
        };
        match (corner, here) {
            (Corner::Node(k), _) => self.nodes[nodes[k] as usize],
            (Corner::Face(face), Some(here)) => here.faces[face],
            (Corner::Middle, Some(here)) => here.middle,
            (Corner::Face(face), None) => mean(&mut cell_type.faces()[face].iter().copied()),
            (Corner::Middle, None) => mean(&mut (0..nodes.len())),
        }
    }

    /// Calls `visit(part, depths of its corners, point about which it is divided)` for every part of a cell.
    pub(super) fn for_each_part(
        &self,
        cells: &Cells,
        cell: usize,
        mut visit: impl FnMut(&Part, [f64; 4], Option<&Incentre>),
    ) {
        let (nodes, cell_type) = (cells.nodes(cell), cells.cell_type(cell));
        let here = (self.boundary_cell_of[cell] != NO_BOUNDARY)
            .then(|| &self.boundary_cells[self.boundary_cell_of[cell] as usize]);
        let mut incentres = here.map_or(&[][..], |here| &self.incentres[here.first as usize..]).iter();
        for (number, part) in parts(cell_type).enumerate() {
            let mut depths = [0.0; 4];
            (0..=D).for_each(|k| depths[k] = self.corner_depth(cell_type, nodes, here, part.corners[k]));
            let divided = here.is_some_and(|here| here.divided >> number & 1 == 1);
            visit(&part, depths, if divided { incentres.next() } else { None });
        }
    }
}

/// Depth of every node that a cell has, 0 on the surface of a body, and the nearest facet.
fn node_depths<const D: usize>(
    cells: &Cells,
    coords: &[[f64; D]],
    surface_faces: &[u8],
    distances: &Distances<D>,
) -> (Vec<f64>, Vec<u32>) {
    const UNSEEN: f64 = -1.0;
    let (mut depths, mut anchors) = (vec![UNSEEN; coords.len()], vec![0; coords.len()]);
    for cell in 0..cells.len() {
        for face in (0..8).filter(|face| surface_faces[cell] >> face & 1 == 1) {
            cells.face_nodes(cell, face).into_iter().for_each(|n| depths[n as usize] = 0.0);
        }
    }
    for cell in 0..cells.len() {
        let nodes = cells.nodes(cell);
        for &node in nodes {
            if depths[node as usize] != UNSEEN {
                continue;
            }
            // No farther than another node of the cell and the way there.
            let x = Vector::<D>::from(coords[node as usize]);
            let known = nodes.iter().map(|&n| (n as usize, depths[n as usize])).filter(|(_, depth)| *depth != UNSEEN);
            let limit =
                known.map(|(n, depth)| depth + (x - Vector::from(coords[n])).norm()).fold(f64::INFINITY, f64::min);
            let body = cells.body[cell] as usize;
            (depths[node as usize], anchors[node as usize]) = distances.of_point(body, &x, limit);
        }
    }
    (depths, anchors)
}

/// Weights of the centre of the ball inscribed in a simplex, and its radius; `None` where it is flat.
fn incentre<const D: usize>(corners: &[Vector<D>; 4]) -> Option<([f64; 4], f64)> {
    let area = |opposite: usize| {
        let face: [Vector<D>; D] = std::array::from_fn(|k| corners[k + usize::from(k >= opposite)]);
        area_vector(&face)
    };
    let mut weights = [0.0; 4];
    (0..=D).for_each(|k| weights[k] = area(k).norm());
    let sum: f64 = weights.iter().sum();
    // The height above a face times its measure is D times the volume.
    let volume = area(0).dot(&(corners[0] - corners[1])).abs() / D as f64;
    let radius = D as f64 * volume / sum;
    (radius > 0.0).then(|| (weights.map(|w| w / sum), radius))
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
