//! What a facet of a body has inside an obstacle.

use crate::geometry::primitives::convex_piece::place;
use crate::geometry::primitives::facet::area_slopes;
use crate::geometry::{Vector, Weighting};
use crate::overlap::depth::facet_sums::FacetSums;
use crate::overlap::depth::integral::DepthRequest;
use crate::overlap::depth::points::{DepthPlace, DepthPoint, no_deeper};
use crate::overlap::pair::body_facet::BodyFacet;
use crate::overlap::pair::second_derivative::SecondDerivative;
use crate::overlap::sums::block_sum::product;
use std::ops::AddAssign;

/// Integrals over the part of a facet inside an obstacle, the whole facet having measure 1.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FacetMoments<const D: usize> {
    /// Of the depth times the shape function of each corner.
    depth: [f64; D],
    /// Of the depth's gradient times products of two shape functions.
    slopes: [[Vector<D>; D]; D],
    /// Of the size of the gradient times these products, where the facet moves down if it moves outwards.
    steep: [[f64; D]; D],
    /// Of the shape function of each corner.
    area: [f64; D],
    /// Of the depth times products of two shape functions, not weighted, where there is a weight.
    moved: [[f64; D]; D],
    deepest: f64,
    /// Pieces of which it is the sum.
    pub(crate) piece_count: usize,
}

impl<const D: usize> Default for FacetMoments<D> {
    fn default() -> Self {
        Self {
            depth: [0.0; D],
            slopes: [[Vector::zeros(); D]; D],
            steep: [[0.0; D]; D],
            area: [0.0; D],
            moved: [[0.0; D]; D],
            deepest: 0.0,
            piece_count: 0,
        }
    }
}

impl<const D: usize> FacetMoments<D> {
    /// Adds a point of a quadrature on a facet: its barycentric coordinates, its part of the measure, the depth there, and,
    /// where second derivatives are asked for, the gradient of the depth.
    pub(crate) fn add_point(
        &mut self,
        (facet, weighting): (&BodyFacet<D>, Weighting),
        w: &[f64; D],
        bare: f64,
        depth: f64,
        gradient: Option<&Vector<D>>,
    ) {
        let part = bare * weighting.at(&place(&facet.corners, w));
        self.area.iter_mut().zip(w).for_each(|(sum, w)| *sum += part * w);
        self.deepest = self.deepest.max(depth);
        for (sum, w) in self.depth.iter_mut().zip(w) {
            *sum += part * depth * w;
        }
        let Some(gradient) = gradient else { return };
        let steep = if facet.normal.dot(gradient) > 0.0 { gradient.norm() } else { 0.0 };
        for a in 0..D {
            for c in 0..D {
                let factor = part * w[a] * w[c];
                self.slopes[a][c] += gradient * factor;
                self.steep[a][c] += factor * steep;
                if !weighting.is_plain() {
                    self.moved[a][c] += bare * depth * w[a] * w[c];
                }
            }
        }
    }

    /// Tells of a depth that was found somewhere on the facet.
    pub(crate) fn reach(&mut self, depth: f64) {
        self.deepest = self.deepest.max(depth);
    }

    /// ∫ of the depth times every shape function.
    pub(crate) fn depths(&self) -> &[f64; D] {
        &self.depth
    }

    /// A facet as a point; `None` where there is no pressure.
    fn point(&self, facet: &BodyFacet<D>) -> Option<DepthPoint<D>> {
        let (area, total): (f64, f64) = (self.area.iter().sum(), self.depth());
        let place = |weights: [f64; D]| DepthPlace { weights, other: None };
        let middle = place(self.area.map(|part| part / area)).or(place([1.0 / D as f64; D]), 0.0);
        (area > 0.0 && total > 0.0).then(|| DepthPoint {
            of_b: false,
            facet: facet.number,
            pressed: place(self.depth.map(|depth| depth / total)).or(middle, 0.0),
            middle,
            gradients: [Vector::zeros(); 8],
            depth: no_deeper(total / area, self.deepest),
            area: area * facet.measure,
            slope: self.slopes.as_flattened().iter().fold(Vector::zeros(), |sum, slope| sum + slope) * facet.measure,
        })
    }

    /// ∫ of the depth.
    pub(crate) fn depth(&self) -> f64 {
        self.depth.iter().sum()
    }
}

impl<const D: usize> AddAssign for FacetMoments<D> {
    fn add_assign(&mut self, other: Self) {
        for a in 0..D {
            self.depth[a] += other.depth[a];
            for c in 0..D {
                self.slopes[a][c] += other.slopes[a][c];
                self.steep[a][c] += other.steep[a][c];
                self.moved[a][c] += other.moved[a][c];
            }
        }
        self.area.iter_mut().zip(other.area).for_each(|(sum, part)| *sum += part);
        self.deepest = self.deepest.max(other.deepest);
        self.piece_count += other.piece_count;
    }
}

impl<const D: usize> FacetSums<D> {
    /// Adds a facet.
    pub(crate) fn add(
        &mut self,
        facet: &BodyFacet<D>,
        moments: &FacetMoments<D>,
        request: &DepthRequest,
        weighting: Weighting,
    ) {
        if moments.piece_count == 0 {
            return;
        }
        self.area += moments.area.iter().sum::<f64>() * facet.measure;
        self.depth += moments.depth() * facet.measure;
        self.deepest = self.deepest.max(moments.deepest);
        self.piece_count += moments.piece_count;
        self.add_to_nodes(facet, &moments.area, &moments.depth, (false, 1.0));
        if request.points {
            self.points.extend(moments.point(facet));
        }
        if request.second != SecondDerivative::No {
            self.add_blocks(facet, moments, request, weighting);
        }
    }

    /// The depth at a point of a facet changes by ∇g·(w − t), w being its displacement and t that of the obstacle; its
    /// area vector changes with its own corners. Its weight changes as it moves; the obstacle feels this too, and what of the
    /// sum over the overlap comes or goes.
    fn add_blocks(
        &mut self,
        facet: &BodyFacet<D>,
        moments: &FacetMoments<D>,
        request: &DepthRequest,
        weighting: Weighting,
    ) {
        let &DepthRequest { second, obstacle_node, .. } = request;
        let own = facet.nodes.len();
        let count = own + 1;
        let mut nodes = facet.nodes.clone();
        nodes.push(obstacle_node);
        let mut values = vec![[[0.0; D]; D]; count * count];
        let mut add = |row: usize, col: usize, factor: f64, block: &[[f64; D]; D]| {
            for (sums, block) in values[row * count + col].iter_mut().zip(block) {
                sums.iter_mut().zip(block).for_each(|(sum, x)| *sum += factor * x);
            }
        };
        let area_slopes = area_slopes(&facet.corners);
        let outwards = weighting.gradient();
        let has_weight = !weighting.is_plain() && second == SecondDerivative::Full;
        for a in 0..D {
            for c in 0..D {
                let of_depth = match second {
                    SecondDerivative::Full => product(facet.measure, &facet.normal, &moments.slopes[a][c]),
                    _ => product(facet.measure * moments.steep[a][c], &facet.normal, &facet.normal),
                };
                for row in 0..own {
                    for col in 0..own {
                        let factor = facet.weights[a][row] * facet.weights[c][col];
                        if factor == 0.0 {
                            continue;
                        }
                        add(row, col, factor, &of_depth);
                        add(row, own, -factor, &of_depth);
                        add(own, col, -factor, &of_depth);
                        add(own, own, factor, &of_depth);
                        if second == SecondDerivative::Full {
                            add(row, col, factor * moments.depth[a], &area_slopes[c]);
                            add(own, col, -factor * moments.depth[a], &area_slopes[c]);
                        }
                        if has_weight {
                            let of_facet = product(facet.measure * moments.moved[a][c], &facet.normal, &outwards);
                            let of_sum = product(facet.measure * moments.moved[a][c], &outwards, &facet.normal);
                            add(row, col, factor, &of_facet);
                            add(own, col, -factor, &of_facet);
                            add(own, col, factor, &of_sum);
                            add(own, own, -factor, &of_sum);
                        }
                    }
                }
            }
        }
        self.hessian.add_square(&nodes, &values);
    }
}
