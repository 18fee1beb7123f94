//! How much of a piece lies inside another, and where.

use super::cell_integrals::Products;
use crate::depth_field::DepthPiece;
use crate::geometry::Vector;
use crate::overlap::depth::simplex_parts::measure;
use crate::ranks::Packed;

/// Moments of a part of a simplex, in the simplex' barycentric coordinates.
pub(crate) trait Moments: Copy + Default + Send + Sync + Packed {
    /// Adds those of a simplex of this dimension, given the coordinates of its corners; in its own units, so that a measure may be
    /// negative.
    fn add_simplex(&mut self, dimension: usize, measure: f64, x: &[[f64; 4]; 4]);

    /// Those of the cone, which has this dimension, between corner `apex` of the simplex and what lies in the face opposite to it, of
    /// which these are the moments in units of that face.
    fn cone(&self, apex: usize, dimension: usize) -> Self;

    /// Those of coordinate `order[k]` from those of number k, times a factor.
    fn in_order(&self, order: &[usize; 4], factor: f64) -> Self;

    /// The same of other coordinates, given at the corners of the simplex.
    fn carried(&self, of_corners: &[[f64; 4]; 4]) -> Self;

    fn is_zero(&self) -> bool;

    fn add(&mut self, other: &Self);

    fn times(&self, factor: f64) -> Self;
}

/// ∫ of every coordinate.
impl Moments for [f64; 4] {
    fn add_simplex(&mut self, dimension: usize, measure: f64, x: &[[f64; 4]; 4]) {
        let norm = measure / (dimension + 1) as f64;
        for (i, sum) in self.iter_mut().enumerate() {
            *sum += norm * x[..=dimension].iter().map(|corner| corner[i]).sum::<f64>();
        }
    }

    fn cone(&self, apex: usize, dimension: usize) -> Self {
        let norm = 1.0 / (dimension + 1) as f64;
        let mut moments = self.map(|m| norm * dimension as f64 * m);
        moments[apex] += norm * self.iter().sum::<f64>();
        moments
    }

    fn in_order(&self, order: &[usize; 4], factor: f64) -> Self {
        let mut sums = [0.0; 4];
        order.iter().zip(self).for_each(|(&k, m)| sums[k] = m * factor);
        sums
    }

    fn carried(&self, of_corners: &[[f64; 4]; 4]) -> Self {
        let mut sums = [0.0; 4];
        for (corner, m) in of_corners.iter().zip(self) {
            sums.iter_mut().zip(corner).for_each(|(sum, value)| *sum += value * m);
        }
        sums
    }

    fn is_zero(&self) -> bool {
        self.iter().all(|m| *m == 0.0)
    }

    fn add(&mut self, other: &Self) {
        self.iter_mut().zip(other).for_each(|(sum, m)| *sum += m);
    }

    fn times(&self, factor: f64) -> Self {
        self.map(|m| m * factor)
    }
}

impl Moments for Products {
    fn add_simplex(&mut self, dimension: usize, measure: f64, x: &[[f64; 4]; 4]) {
        let norm = measure / ((dimension + 1) * (dimension + 2)) as f64;
        let corners = &x[..=dimension];
        let sums: [f64; 4] = std::array::from_fn(|i| corners.iter().map(|corner| corner[i]).sum());
        for (i, row) in self.iter_mut().enumerate() {
            for (j, product) in row.iter_mut().enumerate() {
                let same: f64 = corners.iter().map(|corner| corner[i] * corner[j]).sum();
                *product += norm * (same + sums[i] * sums[j]);
            }
        }
    }

    /// ∫ d t^(d−1) λ λᵀ dt with λ = (1 − t) of the apex + t of the face.
    fn cone(&self, apex: usize, dimension: usize) -> Self {
        let d = dimension as f64;
        let norm = 1.0 / ((d + 1.0) * (d + 2.0));
        let mut products = self.map(|row| row.map(|m| d / (d + 2.0) * m));
        let first = self.map(|row| row.iter().sum::<f64>());
        for (k, m) in first.iter().enumerate() {
            products[apex][k] += d * norm * m;
            products[k][apex] += d * norm * m;
        }
        products[apex][apex] += 2.0 * norm * first.iter().sum::<f64>();
        products
    }

    fn in_order(&self, order: &[usize; 4], factor: f64) -> Self {
        let mut products = [[0.0; 4]; 4];
        for (&i, row) in order.iter().zip(self) {
            order.iter().zip(row).for_each(|(&j, m)| products[i][j] = m * factor);
        }
        products
    }

    fn carried(&self, of_corners: &[[f64; 4]; 4]) -> Self {
        let half = self.map(|row| row.carried(of_corners));
        let columns: Self = std::array::from_fn(|i| std::array::from_fn(|c| half[c][i]));
        columns.map(|row| row.carried(of_corners))
    }

    fn is_zero(&self) -> bool {
        self.iter().all(Moments::is_zero)
    }

    fn add(&mut self, other: &Self) {
        self.iter_mut().zip(other).for_each(|(sum, m)| sum.add(m));
    }

    fn times(&self, factor: f64) -> Self {
        self.map(|row| row.times(factor))
    }
}

/// Moments of the common part of two pieces, in the barycentric coordinates of each, the parts of inverted cells counted
/// negative; `None` where they have no part in common.
///
/// Of a piece whose depth is negative somewhere those of the part where it is positive.
pub(crate) fn common_moments<M: Moments, const D: usize>(p: &DepthPiece<D>, q: &DepthPiece<D>) -> Option<[M; 2]> {
    if p.is_cut() || q.is_cut() {
        return common_moments_below(p, q);
    }
    let (of_p, by_q) = coordinates(p, q)?;
    let (of_q, by_p) = coordinates(q, p)?;
    let some = |moments: M| (!moments.is_zero()).then_some(moments);
    // The one of which fewer faces cut the other cuts.
    if by_q <= by_p {
        let in_q: M = inside::<M, D>(of_p, p.sign * q.sign * q.measure, None);
        Some([some(in_q)?.carried(&of_q), in_q])
    } else {
        let in_p: M = inside::<M, D>(of_q, p.sign * q.sign * p.measure, None);
        Some([in_p, some(in_p)?.carried(&of_p)])
    }
}

/// The same where the depth of either piece is positive, each by itself.
fn common_moments_below<M: Moments, const D: usize>(p: &DepthPiece<D>, q: &DepthPiece<D>) -> Option<[M; 2]> {
    let (of_p, by_q) = coordinates(p, q)?;
    let (of_q, by_p) = coordinates(q, p)?;
    let by_q_first = by_q <= by_p;
    let sign = p.sign * q.sign;
    // Depth of one piece at the corners of the other.
    let at = |corners: &[[f64; 4]; 4], depths: &[f64; 4]| {
        corners.map(|corner| (0..=D).map(|k| corner[k] * depths[k]).sum::<f64>())
    };
    let [in_p, in_q] = if by_q_first {
        let in_p: M = inside::<M, D>(of_p, sign * q.measure, Some(at(&of_q, &p.depths)));
        [in_p.carried(&of_q), inside::<M, D>(of_p, sign * q.measure, Some(q.depths))]
    } else {
        let in_q: M = inside::<M, D>(of_q, sign * p.measure, Some(at(&of_p, &q.depths)));
        [inside::<M, D>(of_q, sign * p.measure, Some(p.depths)), in_q.carried(&of_p)]
    };
    (!in_p.is_zero() || !in_q.is_zero()).then_some([in_p, in_q])
}

/// Barycentric coordinates in `q` of the corners of `p`, and the number of faces of `q` that cut `p`; `None` where one has all
/// of it outside, as most faces of pieces have that are only near each other.
fn coordinates<const D: usize>(p: &DepthPiece<D>, q: &DepthPiece<D>) -> Option<([[f64; 4]; 4], usize)> {
    let (mut all, mut count) = ([[0.0; 4]; 4], 0);
    let from: [Vector<D>; 4] =
        std::array::from_fn(|c| if c <= D { p.corners[c] - q.corners[0] } else { Vector::zeros() });
    // The first follows from the others.
    for k in (1..=D).chain([0]) {
        let (mut least, mut largest) = (f64::INFINITY, f64::NEG_INFINITY);
        for c in 0..=D {
            let value = match k {
                0 => (1..=D).fold(1.0, |rest, k| rest - all[c][k]),
                _ => q.slopes[k].dot(&from[c]),
            };
            all[c][k] = value;
            least = if value < least { value } else { least };
            largest = if value > largest { value } else { largest };
        }
        if largest <= 0.0 {
            return None;
        }
        count += usize::from(least < 0.0);
    }
    Some((all, count))
}

/// Moments of the part of a simplex where all coordinates are positive; the simplex whose coordinates they are has this
/// measure. With `positive` only where that linear function is, given at the corners of that simplex.
///
/// Faces that leave the fewest corners come first: what they cut falls into the fewest parts.
fn inside<M: Moments, const D: usize>(corners: [[f64; 4]; 4], measure: f64, positive: Option<[f64; 4]>) -> M {
    let left = |k: usize| corners[..=D].iter().filter(|corner| corner[k] > 0.0).count();
    let mut order = [0, 1, 2, 3];
    order[..=D].sort_by_key(|&k| left(k));
    let mut in_order = M::default();
    let positive = positive.map(|at| order.map(|k| at[k]));
    add_inside::<M, D>(corners.map(|corner| order.map(|k| corner[k])), 0, positive.as_ref(), &mut in_order);
    in_order.in_order(&order, measure)
}

/// Adds the moments of the part of a simplex, given by the coordinates of its corners, where those from number `level` on
/// are positive, and that linear function, if there is one; in units of the measure of the simplex whose coordinates they
/// are.
fn add_inside<M: Moments, const D: usize>(
    mut x: [[f64; 4]; 4],
    level: usize,
    positive: Option<&[f64; 4]>,
    sums: &mut M,
) {
    let last = if positive.is_some() { D + 1 } else { D };
    for k in level..=last {
        let value = |x: &[f64; 4]| match positive {
            Some(at) if k > D => (0..=D).map(|i| x[i] * at[i]).sum(),
            _ => x[k],
        };
        // Those inside come first.
        let mut inside = 0;
        for c in 0..=D {
            if value(&x[c]) > 0.0 {
                x.swap(c, inside);
                inside += 1;
            }
        }
        if inside == D + 1 {
            continue;
        }
        let cut = |p: usize, q: usize| {
            let (of_p, of_q) = (value(&x[p]), value(&x[q]));
            let part = of_p / (of_p - of_q);
            let mut at: [f64; 4] = std::array::from_fn(|i| x[p][i] + part * (x[q][i] - x[p][i]));
            if k <= D {
                at[k] = 0.0;
            }
            at
        };
        let none = [0.0; 4];
        let mut add = |simplex: [[f64; 4]; 4]| add_inside::<M, D>(simplex, k + 1, positive, sums);
        match (D, inside) {
            (_, 0) => {}
            (2, 1) => add([x[0], cut(0, 1), cut(0, 2), none]),
            (2, _) => {
                let (b, c) = (cut(0, 2), cut(1, 2));
                add([x[0], x[1], b, none]);
                add([x[1], b, c, none]);
            }
            (_, 1) => add([x[0], cut(0, 1), cut(0, 2), cut(0, 3)]),
            (_, 2) => {
                // A wedge with the triangles 0 a b and 1 c d.
                let (a, b, c, d) = (cut(0, 2), cut(0, 3), cut(1, 2), cut(1, 3));
                add([x[0], a, b, x[1]]);
                add([a, b, x[1], d]);
                add([a, x[1], c, d]);
            }
            _ => {
                let (a, b, c) = (cut(0, 3), cut(1, 3), cut(2, 3));
                add([x[0], x[1], x[2], a]);
                add([x[1], x[2], a, b]);
                add([x[2], a, b, c]);
            }
        }
        return;
    }
    sums.add_simplex(D, measure(D, &x), &x);
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A simplex cut by every combination of faces of another: the coordinates sum to the part's measure, and shares of
    /// a simplex that is divided add up to the whole.
    #[test]
    fn parts_add_up() {
        // The unit tetrahedron in its own coordinates, moved so that it is cut by several faces.
        let at = |x: f64, y: f64, z: f64| [1.0 - x - y - z, x, y, z];
        let corners = [[-0.2, 0.1, 0.2], [0.7, -0.3, 0.1], [0.2, 0.8, -0.1], [0.3, 0.2, 0.9]];
        let whole = corners.map(|[x, y, z]| at(x, y, z));
        let mut sums = [0.0; 4];
        add_inside::<[f64; 4], 3>(whole, 0, None, &mut sums);
        let middle: [f64; 4] = std::array::from_fn(|i| whole.iter().map(|x| x[i]).sum::<f64>() / 4.0);
        let mut of_parts = [0.0; 4];
        for k in 0..4 {
            let mut part = whole;
            part[k] = middle;
            add_inside::<[f64; 4], 3>(part, 0, None, &mut of_parts);
        }
        for i in 0..4 {
            assert!((sums[i] - of_parts[i]).abs() < 1e-15 && sums[i] > 0.0, "{sums:?} {of_parts:?}");
        }
        // By a lattice of points in the box around it: 1e-3 of the volume.
        let count: i32 = 120;
        let mut by_points = 0.0;
        let inverse = nalgebra::Matrix4::from_fn(|i, j| if i < 3 { corners[j][i] } else { 1.0 }).try_inverse().unwrap();
        for n in 0..count * count * count {
            let x = |k: i32| (f64::from(n / count.pow(k as u32) % count) + 0.5) / f64::from(count);
            let (x, y, z) = (x(0), x(1), x(2));
            let inside = (inverse * nalgebra::Vector4::new(x, y, z, 1.0)).iter().all(|w| *w > 0.0);
            by_points += f64::from(u8::from(inside && x + y + z < 1.0)) / f64::from(count).powi(3);
        }
        let volume = sums.iter().sum::<f64>() / 6.0;
        assert!((volume / by_points - 1.0).abs() < 1e-2, "{volume} {by_points}");
    }
}
