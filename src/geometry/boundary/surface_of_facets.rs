//! Surfaces that are given by their facets.

use super::closed::check_closed;
use super::surface::check_finite;
use crate::Error;
use crate::geometry::mesh::cells::check_nodes;
use crate::geometry::mesh::components::{connected_labels, enclosed_volume, sorted_ids};
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::facet::area_vector;
use crate::geometry::second_order::Division;
use crate::geometry::{Bodies, FacetBlock, Surface, Vector};

impl<const D: usize> Surface<D> {
    /// Surface given directly: edges with the body on their left (2D), triangles counter-clockwise seen from outside
    /// (3D), closed. With [`Bodies::Connected`], a cavity (a component with negative volume) belongs to the smallest
    /// body around it.
    ///
    /// # Errors
    /// [`Error::Empty`], [`Error::Length`], [`Error::NodeOutOfRange`], [`Error::RepeatedNode`],
    /// [`Error::NonFiniteCoordinate`], [`Error::ZeroMeasure`], [`Error::OpenSurface`], [`Error::NonManifold`],
    /// [`Error::InconsistentOrientation`], [`Error::InvertedSurface`].
    #[inline(never)]
    pub fn from_facets(coords: &[[f64; D]], facets: &[[u32; D]], bodies: Bodies) -> Result<Self, Error> {
        let facets: Vec<&[u32]> = facets.iter().map(|facet| &facet[..]).collect();
        Self::of_straight_facets(coords, &facets, bodies)
    }

    /// The same of facets of any type, also of second order, mixed: the surface is that which cells of second order would
    /// have, with the same forces and tangents. `bodies` has one id per facet, counted over all blocks. A quadrilateral is four
    /// triangles about its middle, as the face of a `Hex8` is.
    ///
    /// # Errors
    /// Those of [`Surface::from_facets`]; also [`Error::Dimension`], [`Error::NonConforming`] (an edge that has a node in its
    /// middle in one of two facets) and [`Error::InvertedCell`] (a facet of second order part of which faces away from the
    /// whole: a node nearer than an eighth of its edge to an end of it, along the edge, does that).
    #[inline(never)]
    pub fn from_facet_blocks(coords: &[[f64; D]], blocks: &[FacetBlock], bodies: Bodies) -> Result<Self, Error> {
        let (division, parts) = Division::of_facets::<D>(coords.len(), blocks)?;
        let parts: Vec<&[u32]> = parts.iter().map(Vec::as_slice).collect();
        let Some(division) = division else { return Self::of_straight_facets(coords, &parts, bodies) };
        let points = division.interpolation.points(coords)?;
        let ids = division.body_ids(bodies)?;
        let bodies = ids.as_deref().map_or(Bodies::Connected, Bodies::Ids);
        let surface = Self::of_straight_facets(&points, &parts, bodies);
        let mut surface = surface.map_err(|error| division.in_host_numbers(error))?;
        check_unfolded(&points, &parts, &division)?;
        surface.division = Some(division);
        Ok(surface)
    }

    /// Surface of facets of D nodes, and in space of quadrilaterals.
    fn of_straight_facets(coords: &[[f64; D]], facets: &[&[u32]], bodies: Bodies) -> Result<Self, Error> {
        if facets.is_empty() {
            return Err(Error::Empty);
        }
        for (facet, nodes) in facets.iter().enumerate() {
            check_nodes(facet, nodes, coords.len())?;
        }
        check_finite(coords, facets.iter().copied().flatten().copied())?;
        let split = Simplices::of(coords, facets);
        split.check_measure()?;
        let labels: Vec<i64> = match bodies {
            Bodies::Connected => {
                let of_simplices = connected_labels(&split.points, &split.nodes);
                split.firsts().map(|first| of_simplices[first]).collect()
            }
            Bodies::Ids(ids) if ids.len() == facets.len() => ids.to_vec(),
            Bodies::Ids(ids) => {
                return Err(Error::Length { array: "body_ids", expected: facets.len(), found: ids.len() });
            }
        };
        check_closed::<D>(facets, &labels)?;
        let body_ids = sorted_ids(&labels);
        let mut order: Vec<usize> = (0..facets.len()).collect();
        order.sort_by_key(|&f| labels[f]);
        let mut surface = Self::empty(coords.len(), body_ids, facets.iter().copied().flatten().copied());
        for facet in order {
            let body = surface.body_ids.partition_point(|&id| id < labels[facet]) as u32;
            surface.push_face(body, [0, facet as u32], facets[facet]);
        }
        surface.facet_cell.clear();
        surface.collect_vertices();
        let points = surface.points(coords);
        for (body, range) in surface.ranges.iter().enumerate() {
            if enclosed_volume(&surface.facets[range.clone()], &points) < 0.0 {
                return Err(Error::InvertedSurface { body: surface.body_ids[body] });
            }
        }
        Ok(surface)
    }
}

/// Facets as simplices, quadrilaterals about their middle.
struct Simplices<const D: usize> {
    /// Coordinates of nodes, then of the middles.
    points: Vec<[f64; D]>,
    nodes: Vec<[u32; D]>,
    /// Facet of every simplex, ascending.
    facets: Vec<usize>,
}

impl<const D: usize> Simplices<D> {
    fn of(coords: &[[f64; D]], facets: &[&[u32]]) -> Self {
        let mut all = Self { points: coords.to_vec(), nodes: Vec::new(), facets: Vec::new() };
        for (number, &facet) in facets.iter().enumerate() {
            if let Ok(simplex) = <[u32; D]>::try_from(facet) {
                all.nodes.push(simplex);
                all.facets.push(number);
                continue;
            }
            let x = facet.iter().map(|&node| Vector::from(coords[node as usize]));
            let middle = all.points.len() as u32;
            all.points.push((x.sum::<Vector<D>>() / facet.len() as f64).into());
            for (k, &node) in facet.iter().enumerate() {
                let corners = [node, facet[(k + 1) % facet.len()], middle];
                all.nodes.push(std::array::from_fn(|c| corners[c]));
                all.facets.push(number);
            }
        }
        all
    }

    /// The first simplex of every facet.
    fn firsts(&self) -> impl Iterator<Item = usize> {
        (0..self.facets.len()).filter(|&k| k == 0 || self.facets[k - 1] != self.facets[k])
    }

    fn check_measure(&self) -> Result<(), Error> {
        for (nodes, &facet) in self.nodes.iter().zip(&self.facets) {
            let x: [Vector<D>; D] = nodes.map(|n| self.points[n as usize].into());
            let size = Aabb::of(&x).extent().amax();
            if area_vector(&x).norm() <= 1e-14 * size.powi(D as i32 - 1) {
                return Err(Error::ZeroMeasure { cell: facet });
            }
        }
        Ok(())
    }
}

/// Refuses facets of second order with a part that faces away from the whole.
fn check_unfolded<const D: usize>(points: &[[f64; D]], parts: &[&[u32]], division: &Division) -> Result<(), Error> {
    let split = Simplices::of(points, parts);
    let given = |k: usize| division.cell(split.facets[k]);
    let areas: Vec<Vector<D>> =
        split.nodes.iter().map(|nodes| area_vector(&nodes.map(|n| Vector::from(split.points[n as usize])))).collect();
    // The parts of a facet stand one behind the other.
    let mut start = 0;
    while start < areas.len() {
        let end = (start..areas.len()).find(|&k| given(k) != given(start)).unwrap_or(areas.len());
        let whole: Vector<D> = areas[start..end].iter().sum();
        if areas[start..end].iter().any(|part| part.dot(&whole) <= 0.0) {
            return Err(Error::InvertedCell { cell: given(start) });
        }
        start = end;
    }
    Ok(())
}
