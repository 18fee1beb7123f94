//! The second derivative of what a facet has inside the cells of the other body.
//!
//! On a facet all shape functions are linear in its own coordinates. So ∫ of the products of these, a few numbers a part, give every
//! product; they are summed up over the pieces of one cell, times the gradient of the depth in each, and brought to the nodes once.

use crate::depth_field::{DepthPiece, MOST_NODES};
use crate::geometry::Weighting;
use crate::geometry::mesh::cells::Cells;
use crate::geometry::primitives::facet::area_slopes;
use crate::overlap::pair::body_facet::{BodyFacet, FACET_NODES};
use crate::overlap::pair::second_derivative::SecondDerivative;
use crate::overlap::sums::block_sum::{BlockSum, product};

/// How the blocks of a side are formed.
pub(super) struct FacetBlocks<'a> {
    pub(super) cells: &'a Cells,
    /// Part with which the depth counts.
    pub(super) weight: f64,
    pub(super) weighting: Weighting,
    pub(super) second: SecondDerivative,
}

/// What a facet has inside, in parts of its measure, times the gradient of the depth there: ∫ of the products of its coordinates, and of
/// these and the shape functions of the cells.
pub(super) struct FacetProducts<const D: usize> {
    own: [[[f64; D]; D]; D],
    /// Memory for more cells than the facet has.
    cells: Vec<InCell<D>>,
    count: usize,
    /// ∫ g N_a, and ∫ g N_a N_c without the weight, by which the weight counts that changes.
    moments: [f64; D],
    moved: [[f64; D]; D],
}

struct InCell<const D: usize> {
    cell: u32,
    /// ∫ of a facet's coordinate and a shape function, and of two shape functions, the first of which is no later.
    mixed: [[[f64; D]; MOST_NODES]; D],
    pairs: [[[f64; D]; MOST_NODES]; MOST_NODES],
}

impl<const D: usize> Default for FacetProducts<D> {
    fn default() -> Self {
        Self { own: [[[0.0; D]; D]; D], cells: Vec::new(), count: 0, moments: [0.0; D], moved: [[0.0; D]; D] }
    }
}

impl<const D: usize> FacetProducts<D> {
    /// Makes it that of a facet with nothing inside.
    fn reset(&mut self) {
        (self.own, self.count) = ([[[0.0; D]; D]; D], 0);
        (self.moments, self.moved) = ([0.0; D], [[0.0; D]; D]);
    }

    fn of_cell(&mut self, cell: u32) -> &mut InCell<D> {
        let known = self.cells[..self.count].iter().position(|of_cell| of_cell.cell == cell);
        let place = known.unwrap_or_else(|| {
            let empty =
                InCell { cell, mixed: [[[0.0; D]; MOST_NODES]; D], pairs: [[[0.0; D]; MOST_NODES]; MOST_NODES] };
            self.count += 1;
            if self.cells.len() < self.count {
                self.cells.push(empty);
            } else {
                self.cells[self.count - 1] = empty;
            }
            self.count - 1
        });
        &mut self.cells[place]
    }
}

impl FacetBlocks<'_> {
    /// Adds a part inside a piece, in whose coordinates the facet's corners are `barycentric`: ∫ of the products of the facet's
    /// coordinates, ∫ g N_a, and ∫ g N_a N_c without the weight.
    pub(super) fn gather<const D: usize>(
        &self,
        facet: &BodyFacet<D>,
        piece: &DepthPiece<D>,
        barycentric: &[[f64; 4]; D],
        (products, moments, moved): (&[[f64; D]; D], &[f64; D], &[[f64; D]; D]),
        sums: &mut FacetProducts<D>,
    ) {
        let mut slope: [f64; D] = std::array::from_fn(|i| piece.gradient[i]);
        if self.second == SecondDerivative::Semidefinite {
            if facet.normal.dot(&piece.gradient) <= 0.0 || piece.sign < 0.0 {
                return;
            }
            let steepness = piece.gradient.norm();
            slope = std::array::from_fn(|i| steepness * facet.normal[i]);
        }
        for a in 0..D {
            sums.moments[a] += moments[a];
            for b in 0..D {
                add_to(&mut sums.own[a][b], products[a][b], &slope);
                sums.moved[a][b] += moved[a][b];
            }
        }
        let shapes = barycentric.each_ref().map(|corner| piece.at_nodes(corner));
        let count = self.cells.nodes(piece.cell as usize).len();
        let InCell { mixed, pairs, .. } = sums.of_cell(piece.cell);
        let mut with_shape = [[0.0; MOST_NODES]; D];
        for a in 0..D {
            for n in 0..count {
                let m: f64 = (0..D).map(|b| products[a][b] * shapes[b][n]).sum();
                with_shape[a][n] = m;
                add_to(&mut mixed[a][n], m, &slope);
            }
        }
        for m in 0..count {
            for n in m..count {
                let pair: f64 = (0..D).map(|a| shapes[a][m] * with_shape[a][n]).sum();
                add_to(&mut pairs[m][n], pair, &slope);
            }
        }
    }

    /// Adds the second derivative of the integral over all that a facet has inside, which is empty then.
    pub(super) fn add<const D: usize>(
        &self,
        facet: &BodyFacet<D>,
        sums: &mut FacetProducts<D>,
        values: &mut Vec<[[f64; D]; D]>,
        hessian: &mut BlockSum<D>,
    ) {
        let (own, factor) = (facet.nodes.len(), self.weight * facet.measure);
        let n: [f64; D] = std::array::from_fn(|i| facet.normal[i]);
        // Σ over the facet's corners, with the weight of a node in each.
        let at_node = |node: usize, of_corners: &dyn Fn(usize) -> [f64; D]| {
            let mut sum = [0.0; D];
            (0..D).for_each(|a| add_to(&mut sum, facet.weights[a][node], &of_corners(a)));
            sum
        };
        let across = |slope: &[f64; D], factor: f64| outer(factor, &n, slope);
        values.clear();
        for row in 0..own {
            for col in 0..own {
                let slope = at_node(row, &|a| at_node(col, &|b| sums.own[a][b]));
                values.push(across(&slope, factor));
            }
        }
        if self.second == SecondDerivative::Full {
            self.add_slopes(facet, (&sums.moments, &sums.moved), values);
        }
        hessian.add_rectangle(&facet.nodes, &facet.nodes, values);
        for of_cell in &sums.cells[..sums.count] {
            let nodes = self.cells.nodes(of_cell.cell as usize);
            let mixed: [[[f64; D]; MOST_NODES]; FACET_NODES] = std::array::from_fn(|row| match row < own {
                true => std::array::from_fn(|col| at_node(row, &|a| of_cell.mixed[a][col])),
                false => [[0.0; D]; MOST_NODES],
            });
            values.clear();
            for of_row in &mixed[..own] {
                values.extend(of_row[..nodes.len()].iter().map(|slope| across(slope, -factor)));
            }
            hessian.add_rectangle(&facet.nodes, nodes, values);
            values.clear();
            for row in 0..nodes.len() {
                values.extend((0..own).map(|col| outer(-factor, &mixed[col][row], &n)));
            }
            hessian.add_rectangle(nodes, &facet.nodes, values);
            values.clear();
            for row in 0..nodes.len() {
                let pair = |col: usize| &of_cell.pairs[row.min(col)][row.max(col)];
                values.extend((0..nodes.len()).map(|col| outer(factor, pair(col), &n)));
            }
            hessian.add_rectangle(nodes, nodes, values);
        }
        sums.reset();
    }

    /// Adds what changes as the facet turns and grows, and as its weight does, to the blocks of its nodes.
    fn add_slopes<const D: usize>(
        &self,
        facet: &BodyFacet<D>,
        (moments, moved): (&[f64; D], &[[f64; D]; D]),
        values: &mut [[[f64; D]; D]],
    ) {
        let own = facet.nodes.len();
        let outwards =
            (!self.weighting.is_plain()).then(|| product(facet.measure, &facet.normal, &self.weighting.gradient()));
        let slopes = area_slopes(&facet.corners);
        for (a, &moment) in moments.iter().enumerate() {
            for (c, slope) in slopes.iter().enumerate() {
                for row in 0..own {
                    for col in 0..own {
                        let weight = self.weight * facet.weights[a][row] * facet.weights[c][col];
                        let value = &mut values[row * own + col];
                        for i in 0..D {
                            add_to(&mut value[i], weight * moment, &slope[i]);
                            if let Some(outwards) = &outwards {
                                add_to(&mut value[i], weight * moved[a][c], &outwards[i]);
                            }
                        }
                    }
                }
            }
        }
    }
}

fn add_to<const N: usize>(sums: &mut [f64; N], factor: f64, terms: &[f64; N]) {
    sums.iter_mut().zip(terms).for_each(|(sum, x)| *sum += factor * x);
}

/// factor · p qᵀ.
fn outer<const D: usize>(factor: f64, p: &[f64; D], q: &[f64; D]) -> [[f64; D]; D] {
    p.map(|p| q.map(|q| factor * p * q))
}
