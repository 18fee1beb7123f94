//! Whether the means of one side hold what is tied as firmly as the jump itself would.

use super::place::Weights;
use crate::geometry::mesh::components::Components;
use crate::geometry::{Vector, cross_matrix};
use nalgebra::{Matrix3, Vector3};
use std::collections::BTreeMap;
use std::rc::Rc;

/// A point of a tie.
pub(super) struct TiedPoint<const D: usize> {
    pub(super) x: Vector<D>,
    pub(super) measure: f64,
    /// Hat functions of the side that holds.
    pub(super) hats: Weights,
    /// Points of the mesh that move the facet of the other side.
    pub(super) other: Rc<[u32]>,
}

/// Part of their energy by the jump itself that the means leave to the rotations of patches, at least: 1/3 for a patch that is one whole facet,
/// (s/h)² for one of size s in the midst of a facet of size h, which would turn as on a hinge. Patches are what hangs together on the other
/// side.
pub(super) fn firmness<const D: usize>(points: &[TiedPoint<D>]) -> f64 {
    let count = points.iter().flat_map(|point| point.other.iter()).copied().max().map_or(0, |last| last as usize + 1);
    let mut patches = Components::new(count);
    for point in points {
        for &node in &point.other[1..] {
            patches.join(point.other[0], node, false);
        }
    }
    let mut of_patch: BTreeMap<u32, Vec<&TiedPoint<D>>> = BTreeMap::new();
    for point in points {
        of_patch.entry(patches.find(point.other[0]).0).or_default().push(point);
    }
    of_patch.values().map(|points| of_rotations(points)).fold(1.0, f64::min)
}

fn of_rotations<const D: usize>(points: &[&TiedPoint<D>]) -> f64 {
    let all: f64 = points.iter().map(|point| point.measure).sum();
    let centre = points.iter().map(|point| point.x * (point.measure / all)).sum::<Vector<D>>();
    // What a rotation about each axis does to a point; in the plane there is the last alone.
    let turned = |x: &Vector<D>| {
        let cross = cross_matrix::<D>(&(x - centre).into());
        std::array::from_fn::<Vector3<f64>, 3, _>(|axis| match D {
            2 if axis == 2 => Vector3::new(-(x - centre)[1], (x - centre)[0], 0.0),
            2 => Vector3::zeros(),
            _ => Vector3::from_fn(|i, _| -cross[i][axis]),
        })
    };
    let mut whole = Matrix3::<f64>::zeros();
    let mut sums: BTreeMap<u32, (f64, [Vector3<f64>; 3])> = BTreeMap::new();
    for point in points {
        let fields = turned(&point.x);
        whole += Matrix3::from_fn(|i, j| point.measure * fields[i].dot(&fields[j]));
        for &(hat, value) in &point.hats {
            let (measure, means) = sums.entry(hat).or_insert((0.0, [Vector3::zeros(); 3]));
            *measure += value * point.measure;
            means.iter_mut().zip(&fields).for_each(|(mean, field)| *mean += field * (value * point.measure));
        }
    }
    let mut held = Matrix3::<f64>::zeros();
    for (measure, means) in sums.values().filter(|(measure, _)| *measure > 0.0) {
        held += Matrix3::from_fn(|i, j| means[i].dot(&means[j]) / measure);
    }
    if D == 2 {
        return if whole[(2, 2)] > 0.0 { held[(2, 2)] / whole[(2, 2)] } else { 1.0 };
    }
    let Some(factor) = whole.cholesky() else { return 1.0 };
    let Some(inverse) = factor.l().try_inverse() else { return 1.0 };
    (inverse * held * inverse.transpose()).symmetric_eigenvalues().min()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A patch [a, b] on an edge [0, 1] with its two hat functions, by 200 points.
    fn on_an_edge(a: f64, b: f64) -> f64 {
        let count = 200;
        let step = (b - a) / f64::from(count);
        let point = |n: i32| {
            let x = a + (f64::from(n) + 0.5) * step;
            TiedPoint {
                x: Vector::<2>::new(x, 3.0),
                measure: step,
                hats: vec![(0, 1.0 - x), (1, x)],
                other: Rc::from([0, 1]),
            }
        };
        firmness(&(0..count).map(point).collect::<Vec<_>>())
    }

    /// For the edge itself: ∫ψ x̂ = ±1/12, twice its square over 1/2 by ∫x̂² = 1/12. For a small one in the middle: s²/12 = ∫x̂²/s, so that it
    /// is (s²/12)² · 4 s / (s³/12) = s²/3. The midpoint rule is off by 1/200².
    #[test]
    fn a_whole_edge_holds_by_a_third_and_a_small_patch_by_its_square() {
        assert!((on_an_edge(0.0, 1.0) - 1.0 / 3.0).abs() < 1e-4);
        assert!((on_an_edge(0.45, 0.55) - 0.01 / 3.0).abs() < 1e-6);
    }
}
