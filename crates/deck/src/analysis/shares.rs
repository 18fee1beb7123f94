//! Loads of a reference node as forces on nodes.
//!
//! Source: Abaqus Analysis User's Guide, "Coupling constraints", distributing coupling: with weights w that add up to 1, arms r from their centre x̄, and
//! the moment M̄ of the load about x̄
//!
//! ```text
//! f_i = w_i (F + (T⁻¹ M̄) × r_i)        T = Σ w_i (r_i·r_i 1 − r_i r_iᵀ)
//! ```
//!
//! which have the resultant F and the moment M̄.

/// Part of the trace of T, cubed, below which its determinant is 0.
const SINGULAR: f64 = 1e-12;

/// By degree of freedom of the reference node, the forces on nodes for the value 1: `arms` are those from the reference node, and moments are known
/// about some axes. None if the nodes take no moment about an axis.
pub(super) fn shares<const D: usize>(
    arms: &[[f64; D]],
    weights: &[f64],
    moments: [bool; 3],
) -> Option<[Option<Vec<[f64; D]>>; 6]> {
    let total: f64 = weights.iter().sum();
    let weights: Vec<f64> = weights.iter().map(|weight| weight / total).collect();
    let arms: Vec<[f64; 3]> =
        arms.iter().map(|arm| std::array::from_fn(|k| arm.get(k).copied().unwrap_or(0.0))).collect();
    let centre: [f64; 3] = std::array::from_fn(|k| arms.iter().zip(&weights).map(|(arm, w)| w * arm[k]).sum());
    let arms: Vec<[f64; 3]> = arms.iter().map(|arm| std::array::from_fn(|k| arm[k] - centre[k])).collect();
    let inverse = inverse_inertia::<D>(&arms, &weights)?;
    let unit = |axis: usize| -> [f64; 3] { std::array::from_fn(|k| f64::from(u8::from(k == axis % 3))) };
    let forces = |axis: usize| {
        let (force, moment) = if axis < 3 { (unit(axis), [0.0; 3]) } else { ([0.0; 3], unit(axis)) };
        // The reference node lies at −centre from the centre.
        let lever = cross(centre, force);
        let moment: [f64; 3] = std::array::from_fn(|k| moment[k] - lever[k]);
        let spin: [f64; 3] = std::array::from_fn(|k| (0..3).map(|l| inverse[k][l] * moment[l]).sum());
        let on = |(arm, weight): (&[f64; 3], &f64)| {
            let turned = cross(spin, *arm);
            std::array::from_fn(|k| weight * (force[k] + turned[k]))
        };
        arms.iter().zip(&weights).map(on).collect::<Vec<[f64; D]>>()
    };
    let is_known = |axis: usize| match axis {
        0..3 => axis < D,
        _ => moments[axis - 3] && (D == 3 || axis == 5),
    };
    Some(std::array::from_fn(|axis| is_known(axis).then(|| forces(axis))))
}

/// T⁻¹; in the plane of its third component alone.
fn inverse_inertia<const D: usize>(arms: &[[f64; 3]], weights: &[f64]) -> Option<[[f64; 3]; 3]> {
    let mut t = [[0.0; 3]; 3];
    for (arm, weight) in arms.iter().zip(weights) {
        let square: f64 = arm.iter().map(|x| x * x).sum();
        for i in 0..3 {
            (0..3).for_each(|j| t[i][j] += weight * (if i == j { square } else { 0.0 } - arm[i] * arm[j]));
        }
    }
    let scale = t[0][0] + t[1][1] + t[2][2];
    let mut inverse = [[0.0; 3]; 3];
    if D == 2 {
        inverse[2][2] = 1.0 / t[2][2];
        return (t[2][2] > 0.0).then_some(inverse);
    }
    let minor = |i: usize, j: usize| {
        let ([a, b], [c, d]) = ([(i + 1) % 3, (i + 2) % 3], [(j + 1) % 3, (j + 2) % 3]);
        t[a][c] * t[b][d] - t[a][d] * t[b][c]
    };
    let determinant: f64 = (0..3).map(|j| t[0][j] * minor(0, j)).sum();
    (0..3).for_each(|i| (0..3).for_each(|j| inverse[j][i] = minor(i, j) / determinant));
    (determinant > SINGULAR * scale.powi(3)).then_some(inverse)
}

pub(super) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3])
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Nodal forces of a load have its resultant, and its moment about the reference node: the definition of static equivalence. Rounding.
    #[test]
    fn forces_are_statically_equivalent() {
        let mut random = fmc_shapes::Splitmix::new(3);
        let arms: Vec<[f64; 3]> = (0..7).map(|_| std::array::from_fn(|_| random.between(-1.0, 3.0))).collect();
        let weights: Vec<f64> = (0..7).map(|_| random.between(0.5, 2.0)).collect();
        let all = shares(&arms, &weights, [true; 3]).unwrap();
        for (axis, forces) in all.iter().enumerate() {
            let forces = forces.as_ref().unwrap();
            for k in 0..3 {
                let force: f64 = forces.iter().map(|f| f[k]).sum();
                let moment: f64 = forces.iter().zip(&arms).map(|(f, arm)| cross(*arm, *f)[k]).sum();
                let unit = |k: usize| f64::from(u8::from(axis == k));
                assert!((force - unit(k)).abs() < 1e-14 && (moment - unit(k + 3)).abs() < 1e-13, "{axis} {k}");
            }
        }
        let plane = shares(&[[1.0, 0.0], [3.0, 0.0]], &[1.0, 3.0], [true; 3]).unwrap();
        assert!(plane[2].is_none() && plane[3].is_none());
        // A pair of forces at a distance of 2.
        assert_eq!(plane[5].as_ref().unwrap(), &[[0.0, -0.5], [0.0, 0.5]]);
        assert!(shares(&[[0.0, 0.0, 1.0], [0.0, 0.0, 2.0], [0.0, 0.0, 4.0]], &[1.0; 3], [true; 3]).is_none());
    }
}
