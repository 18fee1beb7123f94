//! How much of a piece lies inside another, and where.

use crate::depth::DepthPiece;

/// ∫ over the common part of two pieces of the barycentric coordinates of each, the parts of inverted cells counted
/// negative; `None` where they have no part in common.
pub(super) fn common_moments<const D: usize>(p: &DepthPiece<D>, q: &DepthPiece<D>) -> Option<[[f64; 4]; 2]> {
    let corners: [[f64; 4]; 4] = std::array::from_fn(|c| if c <= D { q.barycentric(&p.corners[c]) } else { [0.0; 4] });
    if (0..=D).any(|k| (0..=D).all(|c| corners[c][k] <= 0.0)) {
        return None;
    }
    let others: [[f64; 4]; 4] = std::array::from_fn(|c| if c <= D { p.barycentric(&q.corners[c]) } else { [0.0; 4] });
    if (0..=D).any(|k| (0..=D).all(|c| others[c][k] <= 0.0)) {
        return None;
    }
    let mut in_q = [0.0; 4];
    add_inside::<D>(corners, 0, &mut in_q);
    let whole = p.sign * q.sign * q.measure;
    in_q.iter_mut().for_each(|m| *m *= whole);
    // What is linear is known inside p from its values at the corners of q.
    let mut in_p = [0.0; 4];
    for (other, m) in others.iter().zip(&in_q) {
        in_p.iter_mut().zip(other).for_each(|(sum, value)| *sum += value * m);
    }
    (in_q.iter().any(|m| *m != 0.0)).then_some([in_p, in_q])
}

/// Adds ∫ of the coordinates over the part of a simplex, given by the coordinates of its corners, where those from
/// number `level` on are positive; in units of the measure of the simplex whose coordinates they are.
fn add_inside<const D: usize>(mut x: [[f64; 4]; 4], level: usize, sums: &mut [f64; 4]) {
    for k in level..=D {
        // Those inside come first.
        let mut inside = 0;
        for c in 0..=D {
            if x[c][k] > 0.0 {
                x.swap(c, inside);
                inside += 1;
            }
        }
        if inside == D + 1 {
            continue;
        }
        let cut = |p: usize, q: usize| {
            let part = x[p][k] / (x[p][k] - x[q][k]);
            let mut at: [f64; 4] = std::array::from_fn(|i| x[p][i] + part * (x[q][i] - x[p][i]));
            at[k] = 0.0;
            at
        };
        let none = [0.0; 4];
        let mut add = |simplex: [[f64; 4]; 4]| add_inside::<D>(simplex, k + 1, sums);
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
    let edge = |c: usize, i: usize| x[c][i] - x[0][i];
    let measure = match D {
        2 => edge(1, 1) * edge(2, 2) - edge(1, 2) * edge(2, 1),
        _ => {
            edge(1, 1) * (edge(2, 2) * edge(3, 3) - edge(2, 3) * edge(3, 2))
                + edge(1, 2) * (edge(2, 3) * edge(3, 1) - edge(2, 1) * edge(3, 3))
                + edge(1, 3) * (edge(2, 1) * edge(3, 2) - edge(2, 2) * edge(3, 1))
        }
    }
    .abs();
    for (i, sum) in sums.iter_mut().enumerate() {
        *sum += measure * (0..=D).map(|c| x[c][i]).sum::<f64>() / (D + 1) as f64;
    }
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
        add_inside::<3>(whole, 0, &mut sums);
        let middle: [f64; 4] = std::array::from_fn(|i| whole.iter().map(|x| x[i]).sum::<f64>() / 4.0);
        let mut of_parts = [0.0; 4];
        for k in 0..4 {
            let mut part = whole;
            part[k] = middle;
            add_inside::<3>(part, 0, &mut of_parts);
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
