//! Cells of second order as straight cells that enclose the same volume.
//!
//! # The method
//! Every cell is divided at the middle of its edges, into four triangles or quadrilaterals, eight tetrahedra, hexahedra or
//! wedges. The points of the division are fixed linear combinations of the cell's nodes, X = P x, and everything is measured
//! on the straight cells: the energy of the contact is w(P x), its forces are Pᵀ times those at the points, its tangent is
//! Pᵀ K P. Both are exact derivatives of one energy, for every law and estimator, with friction and self-contact.
//!
//! A point in the middle of an edge does not lie on the edge, but κ = 4/3 as far from the chord as the node there: Archimedes
//! found that a parabola encloses with its chord 4/3 of the triangle with the same base and vertex ("Quadrature of the
//! Parabola", proposition 17). So the division has the volume of the curved cell:
//! in 2D exactly, wherever the nodes are, and with it the derivative; in 3D to first order in the curvature of the faces, where
//! the edges are straight and divided in their middle within the face. Uniform pressure on such a face goes to
//! the nodes as the shape functions have it: 1/6, 2/3, 1/6 on an edge, 0 and 1/3 on a triangle, −1/12 and 1/3 on a
//! quadrilateral of eight nodes; in 2D linear pressure too. The straight surface crosses the true one: it is off by −1/9 to +1/3 of
//! the rise of the edge over its chord, h²/8R.
//!
//! In terms of shape functions: x = Σ Lₐ xₐ + Σ Bₑ (xₑ − mean of the ends) + …, linear ones and bubbles; a bubble counts κ
//! times for every direction in which it is quadratic. On a lattice of n parts the factor would be n²/(n² − 1), since the trapezoidal rule
//! integrates a parabola with the factor 1 − 1/n².

mod basis;
mod children;
mod curved_cells;
mod division;
mod entities;
mod facets;
mod interpolation;
mod on_curve;
mod point_rows;
mod refined;
mod shape_functions;
mod welded;

use super::CellType;

pub use basis::Basis;
pub(crate) use curved_cells::{CurvedCells, MapCheck};
pub(crate) use division::Division;
pub(crate) use interpolation::Interpolation;
pub(crate) use on_curve::OnCurve;

/// Ends of every edge of a cell of second order, in the order of the nodes in their middle.
pub(super) fn middle_edges(cell_type: CellType) -> &'static [[usize; 2]] {
    entities::Entities::of(cell_type).map_or(&[], |entities| entities.edges)
}
