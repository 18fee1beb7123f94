//! A place of a facet, as a combination of the points of the mesh.

use crate::geometry::{Surface, Vector};

/// Below this a weight is rounding.
const ROUNDING: f64 = 1e-14;

/// Points that move a place, with their weights.
pub(crate) type Weights = Vec<(u32, f64)>;

/// The weights of a place of a facet, given by barycentric coordinates: those of the shape functions of its cell where that is curved,
/// else those of the straight facet.
pub(super) fn weights<const D: usize>(surface: &Surface<D>, facet: usize, at: &[f64; D]) -> Weights {
    on_curve(surface, facet, at).unwrap_or_else(|| of_vertices(surface, facet, at))
}

/// Those of the straight facet. They need not sum up to 1.
pub(super) fn of_vertices<const D: usize>(surface: &Surface<D>, facet: usize, at: &[f64; D]) -> Weights {
    let mut found = Weights::new();
    for (&vertex, weight) in surface.facets[facet].iter().zip(at) {
        for (node, share) in surface.nodes_of_vertex(vertex) {
            match found.iter_mut().find(|(known, _)| *known == node) {
                Some((_, sum)) => *sum += weight * share,
                None => found.push((node, weight * share)),
            }
        }
    }
    found
}

fn on_curve<const D: usize>(surface: &Surface<D>, facet: usize, at: &[f64; D]) -> Option<Weights> {
    let cell = *surface.facet_cell.get(facet)? as usize;
    let on_curve = surface.division()?.on_curve(cell, surface.reference())?;
    let nodes = surface.cells.as_ref()?.nodes(cell);
    let mut place = [0.0; 3];
    for (&vertex, weight) in surface.facets[facet].iter().zip(at) {
        for (node, share) in surface.nodes_of_vertex(vertex) {
            let number = nodes.iter().position(|&other| other == node)?;
            place.iter_mut().zip(on_curve.mean(&[number])).for_each(|(sum, x)| *sum += weight * share * x);
        }
    }
    Some(on_curve.weights(place).filter(|(_, weight)| weight.abs() > ROUNDING).collect())
}

/// Where it is.
pub(super) fn position<const D: usize>(weights: &Weights, points: &[[f64; D]]) -> Vector<D> {
    weights.iter().fold(Vector::zeros(), |x, &(point, weight)| x + Vector::from(points[point as usize]) * weight)
}

/// Where a point of a facet is, on curved cells on the curve.
pub(super) fn place_of<const D: usize>(
    surface: &Surface<D>,
    facet: usize,
    point: u32,
    points: &[[f64; D]],
) -> Vector<D> {
    let is_here = |vertex: &u32| surface.nodes_of_vertex(*vertex).eq([(point, 1.0)]);
    let corner = surface.facets[facet].iter().position(is_here);
    let at = corner.map(|corner| std::array::from_fn(|k| if k == corner { 1.0 } else { 0.0 }));
    at.map_or_else(|| Vector::from(points[point as usize]), |at| position(&weights(surface, facet, &at), points))
}
