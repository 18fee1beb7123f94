//! Division of a cell that has nodes on the surface.

use super::cell_parts::{Part, mean, own_points, parts};
use super::crest::Crest;
use super::divide::{Between, divide};
use super::divisions::{CellPoint, CellSimplex, MOST_NODES};
use super::incentre::{all_corners, height, incentre, rounding_of_height};
use super::near_surface::NearSurface;
use super::point_origin::PointOrigin;
use crate::geometry::{CellType, Vector};

/// Corners of the triangles of a tetrahedron, by the corner opposite to each.
const TRIANGLES: [u8; 4] = [0b1110, 0b1101, 0b1011, 0b0111];

/// Corners of edges.
const EDGES: [u8; 6] = [0b0011, 0b0101, 0b0110, 0b1001, 0b1010, 0b1100];

/// Part of the height above a facet by which a depth may differ from it by rounding of what is computed.
const ROUNDING: f64 = 1e-10;

/// Roundings of the coordinates by which it may differ, on a facet that is as wide as it is long: depths and heights take some twenty.
const ROUNDINGS: f64 = 64.0;

/// Points and simplices of a cell.
pub(super) struct CellDivision<'a, const D: usize> {
    near: &'a NearSurface<'a, D>,
    cell: usize,
    cell_type: CellType,
    nodes: &'a [u32],
    pub(super) points: Vec<CellPoint>,
    /// Where each of them comes from.
    pub(super) origins: Vec<PointOrigin>,
    pub(super) simplices: Vec<CellSimplex>,
    /// Whether parts with facets are divided about their centres also where the depth is the height above each facet already.
    about_centres: bool,
}

impl<'a, const D: usize> CellDivision<'a, D> {
    pub(super) fn new(near: &'a NearSurface<'a, D>, cell: usize, about_centres: bool) -> Self {
        let (cell_type, nodes) = (near.cells.cell_type(cell), near.cells.nodes(cell));
        let (points, origins, simplices) = (Vec::new(), Vec::new(), Vec::new());
        let mut division = Self { near, cell, cell_type, nodes, points, origins, simplices, about_centres };
        for (number, weights) in own_points(cell_type).enumerate() {
            let (depth, origin) = division.depth_of_own_point(number, &weights);
            division.points.push(CellPoint { weights, depth });
            division.origins.push(origin);
        }
        parts(cell_type).for_each(|part| division.add_part(&part));
        division
    }

    /// Depth at the centroid of a face, or in the middle, which follows them.
    fn depth_of_own_point(&self, number: usize, weights: &[f64; MOST_NODES]) -> (Option<f64>, PointOrigin) {
        if let Some(face) = self.cell_type.faces().get(number) {
            if self.near.is_surface(self.cell, number) {
                return (Some(0.0), PointOrigin::Surface);
            }
            // Both cells at the face must say the same: one that has no node on the surface takes the mean.
            if face.iter().all(|&k| self.near.depth(self.nodes[k]) > 0.0) {
                return (None, PointOrigin::Nodes);
            }
        }
        let (depth, facet) = self.near.distance(self.cell, weights);
        (Some(depth), PointOrigin::Distance { facet })
    }

    /// Adds the simplices into which a part is divided.
    ///
    /// Inner edges and inner triangles that have all their nodes on the surface are divided about a point with its true
    /// depth, in all cells alike. So is a part that has all of them there and no facet. One with facets is divided about the centre of
    /// its inscribed ball, which is as high above all, if it has such points, or if its depth would not be the height above each.
    /// With points it always is, so that no depth hangs on two faces being as near but for rounding; and about its crest, which lies higher.
    fn add_part(&mut self, part: &Part) {
        let mut points = self.points_between_nodes(part);
        let facets = (0..=D).filter(|&k| self.is_facet(part, k)).fold(0u8, |all, k| all | 1 << k);
        let wants_centre = match facets {
            0 => part.corners[..=D].iter().all(|&corner| self.depth(corner) == 0.0),
            // The depth of a part that is not divided is linear, and that of the centre too.
            _ => self.about_centres || !points.is_empty() || !self.has_heights(part),
        };
        let centre = if wants_centre { self.centre(part, facets != 0) } else { None };
        if let Some(centre) = centre {
            let crest = if facets != 0 && !points.is_empty() { self.crest(part, facets, centre) } else { None };
            // Before edges, which it may lie above; as all simplices that have both agree, their order does not hang on numbers.
            let edges = points.iter().position(|point| point.corners.count_ones() == 2).unwrap_or(points.len());
            crest.into_iter().for_each(|crest| points.insert(edges, crest));
            points.insert(0, Between { corners: all_corners(D), number: centre, about: None });
        }
        let mut simplices = Vec::new();
        divide(part.corners, &points, &mut |corners, kept| simplices.push(Kept { corners, kept }));
        for simplex in simplices {
            let is_at_surface = (0..=D).any(|k| self.has_facet_below(part, &simplex, k));
            self.simplices.push(CellSimplex { corners: simplex.corners, is_at_surface });
        }
    }

    /// Points on inner triangles and edges of a part that have all their nodes on the surface, those on triangles first.
    fn points_between_nodes(&mut self, part: &Part) -> Vec<Between> {
        let node = |k: usize| self.nodes.get(part.corners[k] as usize).copied();
        let is_on_surface = |k: &usize| node(*k).is_some_and(|n| self.near.depth(n) == 0.0);
        let on_surface = (0..=D).filter(is_on_surface).fold(0u8, |all, k| all | 1 << k);
        let triangles = (0..if D == 3 { 4 } else { 0 }).filter(|&k| !self.is_facet(part, k)).map(|k| TRIANGLES[k]);
        let is_inner = |edge: &u8| match [edge.trailing_zeros(), edge.ilog2()].map(|k| node(k as usize)) {
            [Some(p), Some(q)] => !self.near.is_surface_edge(p, q),
            _ => false,
        };
        let edges = EDGES.into_iter().filter(is_inner);
        let found: Vec<u8> = triangles.chain(edges).filter(|corners| corners & !on_surface == 0).collect();
        let between = |corners: u8| {
            let nodes: Vec<usize> =
                (0..=D).filter(|k| corners >> k & 1 == 1).map(|k| part.corners[k] as usize).collect();
            let weights = mean(nodes.into_iter());
            let (depth, facet) = self.near.distance(self.cell, &weights);
            let point = CellPoint { weights, depth: Some(depth) };
            Between { corners, number: self.number_of(point, PointOrigin::Distance { facet }), about: None }
        };
        found.into_iter().map(between).collect()
    }

    /// The centre of the ball inscribed in a part, whose depth is the radius of the ball if that touches a facet.
    fn centre(&mut self, part: &Part, has_facet: bool) -> Option<u8> {
        let (of_corners, radius) = incentre(&self.places(&part.corners), all_corners(D))?;
        let weights = self.weights_in_cell(part, &of_corners);
        let (depth, facet) = match has_facet {
            true => (radius, None),
            false => {
                let (depth, facet) = self.near.distance(self.cell, &weights);
                (depth, Some(facet))
            }
        };
        let point = CellPoint { weights, depth: Some(depth) };
        Some(self.number_of(point, PointOrigin::Centre { corners: part.corners, facet }))
    }

    /// The crest of a part with facets, between the corners opposite to these and the centre, with its true depth.
    fn crest(&mut self, part: &Part, facets: u8, centre: u8) -> Option<Between> {
        let inner = all_corners(D) & !facets;
        let crest = Crest::new(&self.places(&part.corners), facets, inner)?;
        let weights = self.weights_in_cell(part, &crest.weights());
        let (depth, facet) = self.near.distance(self.cell, &weights);
        let point = CellPoint { weights, depth: Some(depth) };
        let number = self.number_of(point, PointOrigin::Crest { corners: part.corners, facets, facet });
        Some(Between { corners: facets, number, about: Some(centre) })
    }

    /// Weights of the cell's nodes in a point of a part.
    fn weights_in_cell(&self, part: &Part, of_corners: &[f64; 4]) -> [f64; MOST_NODES] {
        let mut weights = [0.0; MOST_NODES];
        for (&corner, weight) in part.corners[..=D].iter().zip(of_corners) {
            weights.iter_mut().zip(self.weights(corner)).for_each(|(sum, w)| *sum += weight * w);
        }
        weights
    }

    /// Whether the depth in a part, linear between its corners, is the height above each facet that it has for a face.
    fn has_heights(&self, part: &Part) -> bool {
        (0..=D).filter(|&k| self.is_facet(part, k)).all(|k| {
            let corners = self.places(&part.corners);
            let height = height(&corners, k);
            let rounding = ROUNDINGS * rounding_of_height(&corners, k);
            (self.depth(part.corners[k]) - height).abs() <= (ROUNDING * height).max(rounding)
        })
    }

    /// Whether the face of a simplex of a part that is opposite to a corner is a facet.
    fn has_facet_below(&self, part: &Part, simplex: &Kept, opposite: usize) -> bool {
        let is_whole = (0..=D).all(|k| k == opposite || simplex.kept >> k & 1 == 1);
        is_whole && self.is_facet(part, opposite)
    }

    /// Whether the face of a part that is opposite to a corner is surface.
    fn is_facet(&self, part: &Part, opposite: usize) -> bool {
        part.cell_face(self.cell_type, opposite).is_some_and(|face| self.near.is_surface(self.cell, face))
    }

    /// Number of a point, which is added if it is new.
    fn number_of(&mut self, point: CellPoint, origin: PointOrigin) -> u8 {
        let known = self.points.iter().position(|other| *other == point);
        let number = known.unwrap_or_else(|| {
            self.points.push(point);
            self.origins.push(origin);
            self.points.len() - 1
        });
        (self.nodes.len() + number) as u8
    }

    fn weights(&self, corner: u8) -> [f64; MOST_NODES] {
        match (corner as usize).checked_sub(self.nodes.len()) {
            Some(point) => self.points[point].weights,
            None => mean([corner as usize].into_iter()),
        }
    }

    fn depth(&self, corner: u8) -> f64 {
        let of_node = |k: usize| self.near.depth(self.nodes[k]);
        match (corner as usize).checked_sub(self.nodes.len()) {
            Some(point) => self.points[point].depth(of_node, self.nodes.len()),
            None => of_node(corner as usize),
        }
    }

    fn places(&self, corners: &[u8; 4]) -> [Vector<D>; 4] {
        let place = |k: usize| self.near.place(self.cell, &self.weights(corners[k]));
        std::array::from_fn(|k| if k <= D { place(k) } else { Vector::zeros() })
    }
}

/// A simplex of a part, and which of its corners are those of the part.
struct Kept {
    corners: [u8; 4],
    kept: u8,
}
