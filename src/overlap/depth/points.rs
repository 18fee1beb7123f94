//! Where the forces of the law `depth` act.

use crate::geometry::Vector;
use crate::ranks::{Packed, packed};

/// A facet's part inside a cell of the other side, or inside an obstacle, as a point.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DepthPoint<const D: usize> {
    pub(crate) of_b: bool,
    /// Index within its side.
    pub(crate) facet: u32,
    /// Centre of its pressure, and of its area.
    pub(crate) pressed: DepthPlace<D>,
    pub(crate) middle: DepthPlace<D>,
    /// Gradients of the weights of the other body's cell at the latter; zero in an obstacle.
    pub(crate) gradients: [Vector<D>; 8],
    /// Mean depth of the part below the other surface.
    pub(crate) depth: f64,
    /// Area for which the force of the point stands.
    pub(crate) area: f64,
    /// ∫ of the depth's gradient over that area; zero against an obstacle where no second derivative is asked for.
    pub(crate) slope: Vector<D>,
}

packed!(DepthPoint<D> { of_b, facet, pressed, middle, gradients, depth, area, slope });

/// Points in the order in which they were found, in the lists of those who found them: each is large, and there are many.
#[derive(Clone, Debug, Default)]
pub(crate) struct PointLists<const D: usize>(Vec<Vec<DepthPoint<D>>>);

impl<const D: usize> Packed for PointLists<D> {
    fn pack(&self, bytes: &mut Vec<u8>) {
        self.0.pack(bytes);
    }

    fn unpack(bytes: &mut &[u8]) -> Option<Self> {
        Vec::unpack(bytes).map(Self)
    }

    fn blank() -> Self {
        Self::default()
    }
}

impl<const D: usize> PointLists<D> {
    pub(crate) fn extend(&mut self, points: impl IntoIterator<Item = DepthPoint<D>>) {
        if self.0.is_empty() {
            self.0.push(Vec::new());
        }
        if let Some(list) = self.0.last_mut() {
            list.extend(points);
        }
    }

    /// Adds those of another after these.
    pub(crate) fn append(&mut self, mut other: Self) {
        self.0.append(&mut other.0);
    }

    /// What `of_point` makes of every point; a list is let go once it is through.
    pub(crate) fn map<T>(self, of_point: impl Fn(&DepthPoint<D>) -> T) -> Vec<T> {
        let mut found = Vec::with_capacity(self.0.iter().map(Vec::len).sum());
        self.0.into_iter().for_each(|list| found.extend(list.iter().map(&of_point)));
        found
    }
}

/// A place on a facet.
#[derive(Clone, Copy, Debug)]
pub(crate) struct DepthPlace<const D: usize> {
    /// Barycentric coordinates.
    pub(crate) weights: [f64; D],
    /// The same place in the other body; `None` in an obstacle.
    pub(crate) other: Option<PlaceInCell>,
}

packed!(DepthPlace<D> { weights, other });

/// How far beyond 0 and 1 the weights of a mean place may be by rounding: beyond it the sums are rounding themselves.
const ROUNDING: f64 = 1e-9;

impl<const D: usize> DepthPlace<D> {
    /// This place, where it is one: on the facet, and in the cell or no farther `beyond` it. Another otherwise.
    pub(crate) fn or(self, another: Self, beyond: f64) -> Self {
        let on_facet = self.weights.iter().all(|weight| (-ROUNDING..=1.0 + ROUNDING).contains(weight));
        let in_cell = self.other.as_ref().map_or(&[][..], |place| &place.weights);
        let beyond = beyond + ROUNDING;
        let is_place = on_facet && in_cell.iter().all(|weight| (-beyond..=1.0 + beyond).contains(weight));
        if is_place { self } else { another }
    }
}

/// How far weights are beyond 0 and 1.
pub(crate) fn beyond(weights: &[f64]) -> f64 {
    weights.iter().fold(0.0, |most, weight| f64::max(most, (weight - 0.5).abs() - 0.5))
}

/// A mean depth, or the largest where the mean is more by more than rounding: then it is a quotient of what is rounding itself.
pub(crate) fn no_deeper(mean: f64, deepest: f64) -> f64 {
    if mean <= deepest * (1.0 + ROUNDING) { mean } else { deepest }
}

/// Weights without what rounding leaves below 0 and above 1; their sum stays 1.
pub(crate) fn without_rounding(weights: &mut [f64]) {
    if weights.iter().all(|weight| (0.0..=1.0).contains(weight)) {
        return;
    }
    weights.iter_mut().for_each(|weight| *weight = weight.clamp(0.0, 1.0));
    let sum: f64 = weights.iter().sum();
    weights.iter_mut().for_each(|weight| *weight /= sum);
}

/// A place in a cell.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PlaceInCell {
    pub(crate) cell: u32,
    /// Weights of the cell's nodes, in their order.
    pub(crate) weights: [f64; 8],
}

packed!(PlaceInCell { cell, weights });
