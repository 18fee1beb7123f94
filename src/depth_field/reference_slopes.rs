//! How the depth field changes as the reference coordinates move, transposed: from what is asked by the depths and the places of the
//! corners of its pieces to the same by the reference coordinates.
//!
//! A depth is a distance |x − y| from the nearest point y of the surface, which does not slip at first order: its derivative is the unit
//! vector from y to x, at the nodes of x and, with the other sign, at those of the facet. Where two facets are equally near it is that of one.

use super::crest::Crest;
use super::field::DepthField;
use super::incentre::all_corners;
use super::incentre_slopes::incentre_slopes;
use super::point_origin::PointOrigin;
use crate::geometry::boundary::symmetry::Symmetry;
use crate::geometry::primitives::nearest_on_facet::nearest;
use crate::geometry::{Surface, Vector, Weighting};

/// What is asked by the corners of the pieces of one cell, in the order of their numbers: first its nodes, then its points.
pub(crate) struct CellSlopes {
    pub(crate) cell: u32,
    /// By the depth of each.
    pub(crate) depths: Vec<f64>,
    /// By the weights of the cell's nodes in each.
    pub(crate) weights: Vec<[f64; 8]>,
}

impl CellSlopes {
    /// All of them times a factor.
    pub(crate) fn times(mut self, factor: f64) -> Self {
        self.depths.iter_mut().chain(self.weights.as_flattened_mut()).for_each(|slope| *slope *= factor);
        self
    }
}

/// A depth field that knows where it comes from.
pub(crate) struct ReferenceSlopes<const D: usize> {
    /// The field, divided more finely than that of the forces, with the same depth everywhere.
    pub(crate) field: DepthField<D>,
    /// Origins of the points of cells that have nodes on the surface; none of the others.
    origins: Vec<Vec<PointOrigin>>,
}

impl<const D: usize> ReferenceSlopes<D> {
    /// Of a surface of flat faces; `None` for one without cells.
    pub(crate) fn new(surface: &Surface<D>, symmetry: Option<&Symmetry<D>>, check: &dyn Fn()) -> Option<Self> {
        let mut origins = vec![Vec::new(); surface.cells.as_ref()?.len()];
        let mut tell = |cell: usize, of_cell: Vec<PointOrigin>| origins[cell] = of_cell;
        let field = DepthField::divided(surface, symmetry, (Weighting::Plain, None), check, (true, &mut tell))?;
        Some(Self { field, origins })
    }

    /// Number of nodes and points of a cell.
    pub(crate) fn corner_count(&self, surface: &Surface<D>, cell: u32) -> usize {
        let nodes = surface.cells.as_ref().map_or(0, |cells| cells.nodes(cell as usize).len());
        nodes + self.field.divisions.get(self.field.division_of[cell as usize]).0.len()
    }

    /// The derivative by the reference coordinates of all nodes, given those by the corners of pieces.
    pub(crate) fn by_reference(&self, surface: &Surface<D>, given: &[CellSlopes]) -> Vec<[f64; D]> {
        let mut sums = Sums { surface, by_place: vec![Vector::zeros(); surface.reference().len()] };
        let mut by_depth = vec![0.0; surface.reference().len()];
        for of_cell in given {
            self.add_cell(of_cell, &mut sums, &mut by_depth);
        }
        for (node, &slope) in by_depth.iter().enumerate() {
            if slope != 0.0 && self.field.nodes[node] > 0.0 {
                let x = sums.node(node as u32);
                let away = sums.add_facet(self.field.anchors[node], &x, slope);
                sums.by_place[node] += away;
            }
        }
        sums.by_place.into_iter().map(Into::into).collect()
    }

    fn add_cell(&self, given: &CellSlopes, sums: &mut Sums<D>, by_depth: &mut [f64]) {
        let Some(cells) = &sums.surface.cells else { return };
        let nodes = cells.nodes(given.cell as usize);
        for (&node, slope) in nodes.iter().zip(&given.depths) {
            by_depth[node as usize] += slope;
        }
        let (points, _) = self.field.divisions.get(self.field.division_of[given.cell as usize]);
        let weights_of = |corner: u8| match (corner as usize).checked_sub(nodes.len()) {
            Some(point) => points[point].weights,
            None => std::array::from_fn(|n| f64::from(u8::from(n == corner as usize))),
        };
        for (number, point) in points.iter().enumerate() {
            let (by_own_depth, by_weights) = (given.depths[nodes.len() + number], &given.weights[nodes.len() + number]);
            let origin = self.origins[given.cell as usize].get(number).copied().unwrap_or(PointOrigin::Nodes);
            match origin {
                PointOrigin::Surface => {}
                PointOrigin::Nodes => {
                    for (&node, weight) in nodes.iter().zip(&point.weights) {
                        by_depth[node as usize] += weight * by_own_depth;
                    }
                }
                PointOrigin::Distance { facet } => {
                    let away = sums.add_facet(facet, &sums.place(nodes, &point.weights), by_own_depth);
                    sums.add(nodes, &point.weights, &away);
                }
                PointOrigin::Centre { corners, facet } => {
                    let simplex = Simplex::new(nodes, corners.map(weights_of), sums);
                    let mut by_parts = simplex.by_corners(by_weights);
                    let away =
                        facet.map(|facet| sums.add_facet(facet, &sums.place(nodes, &point.weights), by_own_depth));
                    if let Some(away) = &away {
                        by_parts.iter_mut().zip(&simplex.places).for_each(|(sum, x)| *sum += away.dot(x));
                        sums.add(nodes, &point.weights, away);
                    }
                    let of_radius = if away.is_none() { by_own_depth } else { 0.0 };
                    simplex.add(&incentre_slopes(&simplex.places, all_corners(D), &by_parts, of_radius), sums);
                }
                PointOrigin::Crest { corners, facets, facet } => {
                    let simplex = Simplex::new(nodes, corners.map(weights_of), sums);
                    let away = sums.add_facet(facet, &sums.place(nodes, &point.weights), by_own_depth);
                    sums.add(nodes, &point.weights, &away);
                    let by_corners = simplex.by_corners(by_weights);
                    let by_parts: [f64; 4] = std::array::from_fn(|k| by_corners[k] + away.dot(&simplex.places[k]));
                    let part = Crest::part::<D>(facets);
                    for (faces, part) in [(facets, part), (all_corners(D) & !facets, 1.0 - part)] {
                        let by_parts = by_parts.map(|slope| slope * part);
                        simplex.add(&incentre_slopes(&simplex.places, faces, &by_parts, 0.0), sums);
                    }
                }
            }
        }
    }
}

/// A simplex of a cell.
struct Simplex<'a, const D: usize> {
    nodes: &'a [u32],
    /// Weights of the cell's nodes in each corner.
    weights: [[f64; 8]; 4],
    places: [Vector<D>; 4],
}

impl<'a, const D: usize> Simplex<'a, D> {
    fn new(nodes: &'a [u32], weights: [[f64; 8]; 4], sums: &Sums<D>) -> Self {
        Self { nodes, weights, places: weights.map(|of_corner| sums.place(nodes, &of_corner)) }
    }

    /// What is asked by the weights of the corners, given that by the weights of the cell's nodes.
    fn by_corners(&self, by_weights: &[f64; 8]) -> [f64; 4] {
        self.weights.map(|of_corner| by_weights.iter().zip(of_corner).map(|(s, w)| s * w).sum())
    }

    fn add(&self, slopes: &[Vector<D>; 4], sums: &mut Sums<D>) {
        for k in 0..=D {
            sums.add(self.nodes, &self.weights[k], &slopes[k]);
        }
    }
}

/// Sums at the reference coordinates of nodes.
struct Sums<'a, const D: usize> {
    surface: &'a Surface<D>,
    by_place: Vec<Vector<D>>,
}

impl<const D: usize> Sums<'_, D> {
    fn node(&self, node: u32) -> Vector<D> {
        self.surface.reference()[node as usize].into()
    }

    fn place(&self, nodes: &[u32], weights: &[f64; 8]) -> Vector<D> {
        nodes.iter().zip(weights).fold(Vector::zeros(), |x, (&node, w)| x + self.node(node) * *w)
    }

    fn add(&mut self, nodes: &[u32], weights: &[f64; 8], slope: &Vector<D>) {
        for (&node, weight) in nodes.iter().zip(weights) {
            self.by_place[node as usize] += slope * *weight;
        }
    }

    /// Takes the derivative by the distance of x from a facet to the facet's nodes, and returns what it is at x.
    fn add_facet(&mut self, facet: u32, x: &Vector<D>, by_distance: f64) -> Vector<D> {
        let surface = self.surface;
        let vertices = surface.facets[facet as usize];
        let corners = vertices.map(|v| {
            surface.nodes_of_vertex(v).fold(Vector::zeros(), |sum, (node, weight)| sum + self.node(node) * weight)
        });
        let weights = nearest(&corners, x);
        let from = *x - (0..D).fold(Vector::zeros(), |y, c| y + corners[c] * weights[c]);
        let distance = from.norm();
        if distance == 0.0 {
            return Vector::zeros();
        }
        let away = from * (by_distance / distance);
        for (vertex, weight) in vertices.into_iter().zip(weights) {
            for (node, part) in surface.nodes_of_vertex(vertex) {
                self.by_place[node as usize] -= away * (weight * part);
            }
        }
        away
    }
}
