//! The smallest change of a pair's forces that makes their sum and their moment vanish.
//!
//! Exact overlap does not change when both bodies move together, so ΣF = 0 and ΣM = 0; an estimate on fibers fixed in
//! space has neither. The correction minimises Σ |δ_a|² / |g_a| under Σ (g_a + δ_a) = 0 and Σ x_a × (g_a + δ_a) = 0: a
//! node gives in proportion to what it carries, δ_a = |g_a| (λ + μ × x_a), and λ, μ follow from 3 (2D) or 6 equations.

use crate::geometry::{Vector, Weighting, moment};
use crate::overlap::{Imbalance, Overlap, Pair, PoseGradient, Warning};
use nalgebra::{SMatrix, SVector};
use std::iter::Sum;

/// Rounds: the later ones remove what rounding left in the first.
const ROUNDS: usize = 3;

/// A node, or the obstacle, as the correction sees it.
struct Carrier<const D: usize> {
    arm: Vector<D>,
    size: f64,
    value: Vector<D>,
    of_b: bool,
}

/// Corrects the gradient of an overlap, and warns of an imbalance that was not to be expected.
pub(crate) fn balance<const D: usize>(overlap: &mut Overlap<D>, pair: &Pair<D>, expected: Imbalance) {
    let Overlap { nodes, of_b, gradient, pose_gradient, .. } = overlap;
    let warning = correct(nodes, of_b, gradient, pose_gradient, pair, expected);
    overlap.warnings.extend(warning);
}

/// Corrects the gradient of one pair, on its nodes and on the pose of an obstacle. `of_b` is the side of every node.
/// What is balanced but for rounding is left as it is. Warns of an imbalance that was not to be expected.
///
/// An obstacle takes part as one more node at the point where its resultant acts. A mode that no node resists (turning
/// about the line through all of them) is left as it is.
pub(crate) fn correct<const D: usize>(
    nodes: &[u32],
    of_b: &[bool],
    gradient: &mut [Vector<D>],
    pose_gradient: &mut Option<PoseGradient<D>>,
    pair: &Pair<D>,
    expected: Imbalance,
) -> Option<Warning> {
    let mut carriers: Vec<Carrier<D>> = (nodes.iter().zip(gradient.iter()).zip(of_b))
        .map(|((&node, &value), &of_b)| Carrier {
            arm: pair.coords[node as usize].into(),
            size: value.norm(),
            value,
            of_b,
        })
        .collect();
    let weight = sum_by_side(&carriers, |c| c.size);
    if weight <= 0.0 {
        return None;
    }
    let center = sum_by_side(&carriers, |c| c.arm * c.size) / weight;
    carriers.iter_mut().for_each(|c| c.arm -= center);
    let mut couple = [0.0; 3];
    if let Some(pose) = pose_gradient {
        let value = pose.position;
        let about_center = subtract(pose.rotation, moment(&center, &value));
        let arm = acting_point(&value, &about_center);
        couple = subtract(about_center, moment(&arm, &value));
        carriers.push(Carrier { arm, size: value.norm(), value, of_b: true });
    }
    // Arms in units of the largest, so that the system has one scale.
    let unit = carriers.iter().filter(|c| c.size > 0.0).map(|c| c.arm.norm()).fold(0.0, f64::max);
    if unit <= 0.0 {
        return None;
    }
    carriers.iter_mut().for_each(|c| c.arm /= unit);
    let weighting = pair.weighting;
    let imbalance = residual(&carriers, &couple.map(|c| c / unit), weighting).amax() / weight;
    let [a, b] = pair.partners;
    let unexpected = (imbalance > expected.doubtful).then_some(Warning::Unbalanced { a, b, imbalance });
    // Forces that are no numbers have none either; whoever sums them up refuses them.
    if imbalance.is_nan() || imbalance <= expected.rounding {
        return unexpected;
    }
    let system = sum_by_side(&carriers, |c| {
        let modes = modes(&c.arm, weighting);
        SMatrix::<f64, 6, 6>::from_fn(|p, q| c.size * modes[p].dot(&modes[q]))
    });
    let eigen = system.symmetric_eigen();
    // 1e-10 of the stiffest mode lies far below any patch of finite width.
    let cutoff = 1e-10 * eigen.eigenvalues.max();
    for _ in 0..ROUNDS {
        let residual = residual(&carriers, &couple.map(|c| c / unit), weighting);
        let mut multipliers = eigen.eigenvectors.transpose() * residual;
        for (m, value) in multipliers.iter_mut().zip(eigen.eigenvalues.iter()) {
            *m = if *value > cutoff { -*m / value } else { 0.0 };
        }
        let multipliers = eigen.eigenvectors * multipliers;
        for carrier in &mut carriers {
            for (mode, m) in modes(&carrier.arm, weighting).iter().zip(multipliers.iter()) {
                carrier.value += mode * (*m * carrier.size);
            }
        }
    }
    for (gradient, carrier) in gradient.iter_mut().zip(&carriers) {
        *gradient = carrier.value;
    }
    if let (Some(pose), Some(carrier)) = (pose_gradient, carriers.last()) {
        let change = carrier.value - pose.position;
        pose.position = carrier.value;
        if !weighting.is_plain() {
            return unexpected;
        }
        for (sum, m) in pose.rotation.iter_mut().zip(moment(&(carrier.arm * unit + center), &change)) {
            *sum += m;
        }
    }
    unexpected
}

/// ΣF and ΣM, along the modes; `couple` is what the obstacle carries beside its force.
fn residual<const D: usize>(carriers: &[Carrier<D>], couple: &[f64; 3], weighting: Weighting) -> SVector<f64, 6> {
    let mut residual = sum_by_side(carriers, |c| {
        let modes = modes(&c.arm, weighting);
        SVector::<f64, 6>::from_fn(|p, _| modes[p].dot(&c.value))
    });
    if !weighting.is_plain() {
        return residual;
    }
    for (mode, axis) in (D..6).zip(if D == 2 { 2..3 } else { 0..3 }) {
        residual[mode] += couple[axis];
    }
    residual
}

/// Sum over one side plus sum over the other: a swap of the sides swaps two numbers and changes no bit.
fn sum_by_side<T: Sum, const D: usize>(carriers: &[Carrier<D>], term: impl Fn(&Carrier<D>) -> T) -> T {
    let side = |of_b: bool| carriers.iter().filter(|c| c.of_b == of_b).map(&term).sum::<T>();
    [side(false), side(true)].into_iter().sum()
}

/// The D translations and the 1 or 3 rotations at a point, as vectors there; unused ones are zero. What has an axis of
/// symmetry moves along it alone.
fn modes<const D: usize>(x: &Vector<D>, weighting: Weighting) -> [Vector<D>; 6] {
    let mut modes = [Vector::zeros(); 6];
    if !weighting.is_plain() {
        modes[D - 1][D - 1] = 1.0;
        return modes;
    }
    for axis in 0..D {
        modes[axis][axis] = 1.0;
    }
    if D == 2 {
        modes[2][0] = -x[1];
        modes[2][1] = x[0];
    } else {
        for (k, (p, q)) in [(1, 2), (2, 0), (0, 1)].into_iter().enumerate() {
            modes[3 + k][q] = x[p];
            modes[3 + k][p] = -x[q];
        }
    }
    modes
}

/// The point nearest to the origin at which a force has the given moment, as far as it can have it.
fn acting_point<const D: usize>(force: &Vector<D>, about: &[f64; 3]) -> Vector<D> {
    let squared = force.norm_squared();
    if squared == 0.0 {
        return Vector::zeros();
    }
    // F × M / F²
    let f: [f64; 3] = std::array::from_fn(|i| if i < D { force[i] } else { 0.0 });
    let m = about;
    let cross = [f[1] * m[2] - f[2] * m[1], f[2] * m[0] - f[0] * m[2], f[0] * m[1] - f[1] * m[0]];
    Vector::from_fn(|i, _| cross[i] / squared)
}

fn subtract(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| a[i] - b[i])
}
