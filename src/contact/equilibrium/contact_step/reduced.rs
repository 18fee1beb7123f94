//! Systems of the contact that are solved on what it touches alone.
//!
//! Contact acts on some of the degrees of freedom on the list, and on fewer and fewer as bodies give way. So the bodies are
//! factorised once in the order in which their nodes will be free of it: a system with the contact costs what those cost from the
//! first that feels it.

use super::iterate::Iterate;
use super::touching::Touching;
use crate::sparse::{Entries, Schur};
use nalgebra::{DMatrix, DVector};

/// Times that the order may be found anew in a step.
const MOST_ORDERS: usize = 6;

/// Part of a right side that a solution may miss: more, and the matrix was singular.
const MISSED: f64 = 1e-6;

/// Bodies, factorised.
pub(super) struct Reduced {
    /// Place on the list of every row.
    order: Vec<usize>,
    rows: Vec<usize>,
    schur: Schur,
    /// Stiffness of a contact that holds the bodies, where they do not stand by themselves.
    ground: Option<DMatrix<f64>>,
    orders: usize,
}

impl Reduced {
    /// `None` where even with the contact's stiffness at `at` the bodies are not positive definite.
    pub(super) fn new(
        bodies: &DMatrix<f64>,
        contact: &dyn Touching,
        at: &Iterate,
        tangent: &DMatrix<f64>,
    ) -> Option<Self> {
        let order = by_depth(contact, at, tangent);
        let alone = Self::ordered(bodies, order.clone(), None);
        alone.or_else(|| Self::ordered(bodies, order, Some(tangent.clone())))
    }

    fn ordered(bodies: &DMatrix<f64>, order: Vec<usize>, ground: Option<DMatrix<f64>>) -> Option<Self> {
        let stood_on = |row: usize, column: usize| ground.as_ref().map_or(0.0, |ground| ground[(row, column)]);
        let entry = |row: usize, column: usize| {
            let (row, column) = (order[row], order[column]);
            bodies[(row, column)] + stood_on(row, column)
        };
        let schur = Schur::of(order.len(), entry)?;
        let mut rows = vec![0; order.len()];
        order.iter().enumerate().for_each(|(row, &place)| rows[place] = row);
        Some(Self { order, rows, schur, ground, orders: 1 })
    }

    /// Solution with the contact's stiffness; `None` where the matrix is not positive definite.
    pub(super) fn solve(
        &mut self,
        bodies: &DMatrix<f64>,
        contact: &dyn Touching,
        at: &Iterate,
        tangent: &DMatrix<f64>,
        right: &DVector<f64>,
    ) -> Option<DVector<f64>> {
        let change = match &self.ground {
            Some(ground) => self.entries(&(tangent - ground)),
            None => self.entries(tangent),
        };
        let size = self.order.len();
        let mut touched = vec![false; size];
        change.iter().for_each(|&(row, column, _)| (touched[row], touched[column]) = (true, true));
        let count = touched.iter().filter(|is| **is).count();
        let last = size - touched.iter().position(|is| *is).unwrap_or(size);
        if self.ground.is_none() && last > 2 * count.max(size / 8) && self.orders < MOST_ORDERS {
            let orders = self.orders + 1;
            *self = Self::ordered(bodies, by_depth(contact, at, tangent), None)?;
            self.orders = orders;
            return self.solve(bodies, contact, at, tangent, right);
        }
        let of_rows: Vec<f64> = self.order.iter().map(|&place| right[place]).collect();
        let solved = self.schur.solve_changed(&change, &of_rows)?;
        let found = DVector::from_fn(size, |place, _| solved[self.rows[place]]);
        let missed = bodies * &found + tangent * &found - right;
        (missed.norm() <= MISSED * right.norm()).then_some(found)
    }

    /// Entries of the lower triangle by rows.
    fn entries(&self, matrix: &DMatrix<f64>) -> Entries {
        let mut entries = Vec::new();
        for (column, values) in matrix.column_iter().enumerate() {
            for (row, &value) in values.iter().enumerate().skip(column) {
                // Both of a pair that mirror each other: they differ by rounding.
                let value = 0.5 * (value + matrix[(column, row)]);
                if value != 0.0 {
                    entries.push((self.rows[row], self.rows[column], value));
                }
            }
        }
        entries
    }
}

/// Places, those of the nodes that are nearest to being free of contact first: by their force over the contact's stiffness.
fn by_depth(contact: &dyn Touching, at: &Iterate, tangent: &DMatrix<f64>) -> Vec<usize> {
    let count = tangent.nrows();
    let mut nodes: std::collections::BTreeMap<usize, (f64, f64)> = std::collections::BTreeMap::new();
    for place in 0..count {
        let node = nodes.entry(contact.node(place)).or_default();
        node.0 += at.touch.forces[place].powi(2);
        node.1 = node.1.max(tangent[(place, place)]);
    }
    // What has no stiffness is free.
    let depth = |place: usize| match nodes[&contact.node(place)] {
        (_, 0.0) => -1.0,
        (square, stiffness) => square.sqrt() / stiffness,
    };
    let depths: Vec<f64> = (0..count).map(depth).collect();
    let mut order: Vec<usize> = (0..count).collect();
    order.sort_by(|a, b| depths[*a].total_cmp(&depths[*b]));
    order
}
