//! Coulomb friction on the broken part of a cohesive interface.
//!
//! The part d of a point is broken. It sticks by the stiffness k of sliding and slides at μ p, by its own elastic slip e (Alfano, Sacco 2006):
//!
//! ```text
//! b = x_A(ξ) − x_B(η) − Σ c_j (X_j − X_0)       X: corners of the facet of B, c: what has slid
//! e = b − (b·n) n,  |e| ≤ μ p/k                 else e = (μ p/k) e/|e|, and c takes the rest
//! t = d k e,   E = d k |e|²/2
//! ```
//!
//! The point of B that rubs is x_B(η) + Σ c_j (X_j − X_0), where the point of A lies on the plane of the facet: forces are the derivative of E
//! at the slip and the damage of now, so they balance, and no rigid motion has any.

use super::frame::{Frame, Matrix};
use crate::geometry::Vector;

/// What resists sliding where an interface is broken.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct BrokenFriction {
    pub(crate) coefficient: f64,
    /// The largest traction.
    pub(crate) shear_limit: f64,
}

/// Friction at a point.
#[derive(Clone, Copy)]
pub(super) struct Rub<const D: usize> {
    /// Elastic slip, and what it would be without sliding.
    pub(super) elastic: Vector<D>,
    trial: Vector<D>,
    /// What has slid before and since, by edges.
    before: [f64; 2],
    pub(super) slip: [f64; 2],
    /// The largest elastic slip, and how it changes with the opening.
    limit: f64,
    limit_slope: f64,
    slides: bool,
}

/// What moves a point by its nodes: shares in the jump and in the corners of the facet, the turning of the normal, d(a·n), and the growth of
/// the damage where it grows.
pub(super) struct ByNode<'a, const D: usize> {
    pub(super) jump: &'a [f64],
    pub(super) corners: &'a [[f64; D]],
    pub(super) slopes: &'a [Matrix<D>],
    pub(super) along: &'a [Vector<D>],
    pub(super) damage: &'a [Vector<D>],
}

/// The edges of a facet that leave its first corner, and what brings a vector of its plane to multiples of them.
#[derive(Clone, Copy)]
pub(super) struct Edges<const D: usize> {
    /// The first D − 1.
    edges: [Vector<D>; 2],
    inverse: [Vector<D>; 2],
}

impl<const D: usize> Edges<D> {
    /// `None` where the facet has no area.
    pub(super) fn new(corners: &[Vector<D>; D]) -> Option<Self> {
        let mut edges = [Vector::zeros(); 2];
        (1..D).for_each(|corner| edges[corner - 1] = corners[corner] - corners[0]);
        let [u, v] = edges;
        let (uu, uv, vv) = (u.norm_squared(), u.dot(&v), v.norm_squared());
        let inverse = if D == 2 {
            (uu > 0.0).then(|| [u / uu, Vector::zeros()])
        } else {
            let all = uu * vv - uv * uv;
            (all > 0.0).then(|| [(u * vv - v * uv) / all, (v * uu - u * uv) / all])
        };
        inverse.map(|inverse| Self { edges, inverse })
    }

    pub(super) fn vector(&self, slip: &[f64; 2]) -> Vector<D> {
        self.edges[0] * slip[0] + self.edges[1] * slip[1]
    }

    pub(super) fn multiples(&self, vector: &Vector<D>) -> [f64; 2] {
        self.inverse.map(|one| one.dot(vector))
    }
}

impl<const D: usize> Rub<D> {
    /// At a sliding, after what has slid before; `pressed` are the largest elastic slip and how it changes with the opening.
    pub(super) fn new(edges: &Edges<D>, sliding: &Vector<D>, before: [f64; 2], pressed: (f64, f64)) -> Self {
        let trial = sliding - edges.vector(&before);
        let (size, (limit, limit_slope)) = (trial.norm(), pressed);
        let mut rub = Self { elastic: trial, trial, before, slip: before, limit, limit_slope, slides: size > limit };
        if rub.slides {
            rub.elastic = trial * (limit / size);
            let slid = edges.multiples(&(trial - rub.elastic));
            rub.slip = [0, 1].map(|k| before[k] + slid[k]);
        }
        rub
    }

    /// How far it has slid since the step began.
    pub(super) fn slid(&self) -> f64 {
        if self.slides { self.trial.norm() - self.limit } else { 0.0 }
    }

    /// Second derivative of the energy of the broken part, by nodes: `stiffness` is k, and `part` the damage. `apart` is a·n.
    pub(super) fn curvature(
        &self,
        by: &ByNode<D>,
        (frame, edges): (&Frame<D>, &Edges<D>),
        apart: f64,
        [part, stiffness]: [f64; 2],
    ) -> Vec<Matrix<D>> {
        let (count, full, normal) = (by.jump.len(), part * stiffness, &frame.normal);
        let bend =
            |slope: &Matrix<D>, e: &Vector<D>| Vector::<D>::from_fn(|j, _| (0..D).map(|i| e[i] * slope[i][j]).sum());
        let [first, now] = [&self.before, &self.slip].map(|slip| self.shares(by, slip));
        let since = self.shares_of_edges(by, &[0, 1].map(|k| self.slip[k] - self.before[k]));
        let turned: Vec<Vector<D>> = by.slopes.iter().map(|slope| bend(slope, &self.elastic)).collect();
        let force: Vec<Vector<D>> = (0..count).map(|k| self.elastic * now[k] - turned[k] * apart).collect();
        let second: Vec<Matrix<D>> = (0..D * D).map(|k| frame.second(&self.elastic, [k / D, k % D])).collect();
        let size = self.trial.norm();
        let mut values = vec![[[0.0; D]; D]; count * count];
        for c in 0..count {
            for j in 0..D {
                let turn = Vector::<D>::from_fn(|i, _| by.slopes[c][i][j]);
                // b·dn is a·dn less what has slid by dn: both are in the plane.
                let tilted = normal[j] * first[c] + self.trial.dot(&turn);
                let trial = unit::<D>(j) * first[c] - normal * tilted - turn * apart;
                let (mut elastic, mut slid) = (trial, [0.0; 2]);
                if self.slides {
                    let way = self.trial / size;
                    elastic = way * (self.limit_slope * by.along[c][j])
                        + (trial - way * way.dot(&trial)) * (self.limit / size);
                    slid = edges.multiples(&(trial - elastic - unit::<D>(j) * since[c]));
                }
                for r in 0..count {
                    let lever: f64 = (1..D).map(|k| (by.corners[r][k] - by.corners[r][0]) * slid[k - 1]).sum();
                    let mut change = elastic * now[r]
                        - self.elastic * lever
                        - turned[r] * by.along[c][j]
                        - bend(&by.slopes[r], &elastic) * apart;
                    for (k, second) in second.iter().enumerate() {
                        let share = apart * by.corners[r][k / D] * by.corners[c][k % D];
                        (0..D).for_each(|i| change[i] -= share * second[i][j]);
                    }
                    change *= full;
                    if let Some(damage) = by.damage.get(c) {
                        change += force[r] * (stiffness * damage[j]);
                    }
                    (0..D).for_each(|i| values[r * count + c][i][j] += change[i]);
                }
            }
        }
        values
    }

    /// The same without what turns, grows and presses: never negative.
    pub(super) fn secant(&self, by: &ByNode<D>, normal: &Vector<D>, [part, stiffness]: [f64; 2]) -> Vec<Matrix<D>> {
        let (count, size) = (by.jump.len(), self.trial.norm());
        let plane = |i: usize, j: usize| f64::from(i == j) - normal[i] * normal[j];
        let (left, way) = match self.slides {
            true => (self.limit / size, self.trial / size),
            false => (1.0, Vector::zeros()),
        };
        let entry = |i: usize, j: usize| part * stiffness * left * (plane(i, j) - way[i] * way[j]);
        let one = |k: usize| {
            let shares = by.jump[k / count] * by.jump[k % count];
            std::array::from_fn(|i| std::array::from_fn(|j| shares * entry(i, j)))
        };
        (0..count * count).map(one).collect()
    }

    /// Shares of the nodes in b.
    fn shares(&self, by: &ByNode<D>, slip: &[f64; 2]) -> Vec<f64> {
        self.shares_of_edges(by, slip).iter().zip(by.jump).map(|(edge, jump)| jump - edge).collect()
    }

    fn shares_of_edges(&self, by: &ByNode<D>, slip: &[f64; 2]) -> Vec<f64> {
        by.corners.iter().map(|corner| (1..D).map(|k| slip[k - 1] * (corner[k] - corner[0])).sum()).collect()
    }
}

fn unit<const D: usize>(axis: usize) -> Vector<D> {
    Vector::from_fn(|i, _| f64::from(i == axis))
}
