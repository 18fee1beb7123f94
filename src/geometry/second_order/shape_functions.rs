//! Shape functions of cells of second order, by their terms: any set of functions with one value per node has them.

use super::entities::Entities;
use crate::geometry::CellType;
use nalgebra::DMatrix;

/// Where the corners of a cell stand in the coordinates of its shape functions.
fn corners(straight: CellType) -> Vec<[f64; 3]> {
    let square = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
    let triangle = [square[0], square[1], square[3]];
    let above = |x: [f64; 3]| [x[0], x[1], 1.0];
    match straight {
        CellType::Tri3 => triangle.to_vec(),
        CellType::Quad4 => square.to_vec(),
        CellType::Tet4 => [&triangle[..], &[[0., 0., 1.]]].concat(),
        CellType::Wedge6 => triangle.into_iter().chain(triangle.map(above)).collect(),
        CellType::Pyramid5 => vec![[-1., -1., 0.], [1., -1., 0.], [1., 1., 0.], [-1., 1., 0.], [0., 0., 1.]],
        _ => square.into_iter().chain(square.map(above)).collect(),
    }
}

/// Where the nodes stand.
pub(super) fn places(cell_type: CellType, entities: &Entities) -> Vec<[f64; 3]> {
    (0..cell_type.node_count()).map(point_places(cell_type, entities)).collect()
}

/// Where the points of the division stand: each in the middle of the corners around it.
pub(super) fn point_places(cell_type: CellType, entities: &Entities) -> impl Fn(usize) -> [f64; 3] {
    let corners = corners(cell_type.straight());
    let entities = *entities;
    move |point: usize| {
        let around = entities.around(point);
        let sum = |axis: usize| around.iter().map(|&corner| corners[corner][axis]).sum::<f64>();
        std::array::from_fn(|axis| sum(axis) / around.len() as f64)
    }
}

/// A term xᵃ yᵇ zᶜ / (1 − z)ᵈ, by its exponents; d only in pyramids.
type Term = [i32; 4];

fn terms(cell_type: CellType) -> Vec<Term> {
    let powers = || (0..3).flat_map(|c| (0..3).flat_map(move |b| (0..3).map(move |a| [a, b, c, 0])));
    let is_term = |[a, b, c, _]: &Term| {
        let squares = [a, b, c].into_iter().filter(|&&power| power == 2).count();
        match cell_type {
            CellType::Tri6 => *c == 0 && a + b <= 2,
            CellType::Quad8 => *c == 0 && squares < 2,
            CellType::Quad9 => *c == 0,
            CellType::Tet10 | CellType::Pyramid13 => a + b + c <= 2,
            CellType::Hex20 => squares < 2,
            CellType::Wedge15 => a + b + c / 2 <= 2,
            _ => true,
        }
    };
    let rational: &[Term] = match cell_type {
        CellType::Pyramid13 => &[[1, 1, 1, 1], [2, 1, 0, 1], [1, 2, 0, 1]],
        _ => &[],
    };
    powers().filter(is_term).chain(rational.iter().copied()).collect()
}

/// Value of a term, and its derivatives; at the apex of a pyramid the value's limit.
fn of_term(&[a, b, c, d]: &Term, [x, y, z]: [f64; 3]) -> (f64, [f64; 3]) {
    let below = 1.0 - z;
    if d > 0 && below == 0.0 {
        return (0.0, [f64::NAN; 3]);
    }
    let power = |x: f64, n: i32| (x.powi(n), if n == 0 { 0.0 } else { f64::from(n) * x.powi(n - 1) });
    let ((px, dx), (py, dy), (pz, dz)) = (power(x, a), power(y, b), power(z, c));
    let (q, dq) = (below.powi(-d), if d == 0 { 0.0 } else { f64::from(d) * below.powi(-d - 1) });
    (px * py * pz * q, [dx * py * pz * q, px * dy * pz * q, px * py * (dz * q + pz * dq)])
}

/// The shape functions of all nodes, and their derivatives.
#[derive(Clone, Debug)]
pub(super) struct ShapeFunctions {
    terms: Vec<Term>,
    /// Shape functions by terms, (terms, nodes).
    of_terms: DMatrix<f64>,
}

impl ShapeFunctions {
    pub(super) fn of(cell_type: CellType, entities: &Entities) -> Option<Self> {
        let (terms, places) = (terms(cell_type), places(cell_type, entities));
        let values = DMatrix::from_fn(places.len(), terms.len(), |node, term| of_term(&terms[term], places[node]).0);
        // Terms that do not fit the nodes would have no inverse: that there is one is tested.
        let of_terms = if values.is_square() { values.try_inverse() } else { None }?;
        Some(Self { terms, of_terms })
    }

    /// The functions of all nodes at a place, (1, nodes).
    pub(super) fn values(&self, place: [f64; 3]) -> DMatrix<f64> {
        let of_terms = DMatrix::from_fn(1, self.terms.len(), |_, term| of_term(&self.terms[term], place).0);
        of_terms * &self.of_terms
    }

    /// Derivatives of the functions of all nodes at a place, (3, nodes).
    pub(super) fn gradients(&self, place: [f64; 3]) -> DMatrix<f64> {
        let of_terms = DMatrix::from_fn(3, self.terms.len(), |axis, term| of_term(&self.terms[term], place).1[axis]);
        of_terms * &self.of_terms
    }
}
