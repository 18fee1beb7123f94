//! Laws of the test.

use fmc_contact::contact::{InterfaceLaw, LawFailure, LawPoints, LawResponse};

/// What a law says at one point.
pub(crate) struct One {
    pub(crate) traction: Vec<f64>,
    /// By rows.
    pub(crate) tangent: Vec<f64>,
    pub(crate) energies: [f64; 2],
}

/// A law point by point: of the jump, and of the history, which it changes.
pub(crate) struct PointByPoint<F> {
    pub(crate) count: usize,
    pub(crate) law: F,
}

impl<F> InterfaceLaw for PointByPoint<F>
where
    F: Fn(&[f64], &mut [f64]) -> One + Send + Sync,
{
    fn history_count(&self) -> usize {
        self.count
    }

    fn respond(&self, points: &LawPoints<'_>, response: &mut LawResponse<'_>) -> Result<(), LawFailure> {
        let (dim, count) = (points.dim, self.count);
        for (point, jump) in points.jumps.chunks(dim).enumerate() {
            let One { traction, tangent, energies } = (self.law)(jump, &mut response.history[point * count..][..count]);
            response.tractions[point * dim..][..dim].copy_from_slice(&traction);
            response.tangents[point * dim * dim..][..dim * dim].copy_from_slice(&tangent);
            [response.stored[point], response.dissipated[point]] = energies;
        }
        Ok(())
    }
}

/// Strengths, energies by opening and sliding, and the exponent of Benzeggagh and Kenane, as `tests/cohesive` has them.
const STRENGTH: [f64; 2] = [2.0, 3.0];
pub(crate) const ENERGY: [f64; 2] = [0.1, 0.4];
const EXPONENT: i32 = 2;

/// The bilinear law of docs/interfaces.md, written down here once more; the history is the damage and what was dissipated.
pub(crate) fn bilinear(jump: &[f64], history: &mut [f64]) -> One {
    let m = 100.0;
    let normal = m * STRENGTH[0] * STRENGTH[0] / (2.0 * ENERGY[0]);
    let shear = normal * (ENERGY[0] / ENERGY[1]) * (STRENGTH[1] / STRENGTH[0]).powi(2);
    let dim = jump.len();
    let open: f64 = jump[0].max(0.0);
    let slid2: f64 = jump[1..].iter().map(|x| x * x).sum();
    let (y_t, before) = (0.5 * shear * slid2, history[0]);
    let y = 0.5 * normal * open * open + y_t;
    let mut growth = vec![0.0; dim];
    if y > 0.0 && before < 1.0 {
        let b = y_t / y;
        let g = ENERGY[0] + (ENERGY[1] - ENERGY[0]) * b.powi(EXPONENT);
        let q = (y / (g / m)).sqrt();
        let wanted = if q <= 1.0 {
            0.0
        } else if q >= m {
            1.0
        } else {
            m * (q - 1.0) / (q * (m - 1.0))
        };
        if wanted > before {
            history[0] = wanted;
            // Without the triangle of what is stored, under the curve from where the damage began to grow.
            let reached = m / (m - before * (m - 1.0));
            let spent = |q: f64| if q >= m { m } else { m * (q - 1.0) / (m - 1.0) };
            history[1] += g / m * (spent(q) - spent(reached));
            let slope = if q >= m { 0.0 } else { m / ((m - 1.0) * q * q) };
            // dq/q = dY/(2Y) − dG/(2G), dB = (dY_t − B dY)/Y.
            for (axis, growth) in growth.iter_mut().enumerate() {
                let (dy_n, dy_t) = if axis == 0 { (normal * open, 0.0) } else { (0.0, shear * jump[axis]) };
                let db = (dy_t - b * (dy_n + dy_t)) / y;
                let dg = (ENERGY[1] - ENERGY[0]) * f64::from(EXPONENT) * b.powi(EXPONENT - 1) * db;
                *growth = slope * q * ((dy_n + dy_t) / (2.0 * y) - dg / (2.0 * g));
            }
        }
    }
    let left = 1.0 - history[0];
    let full: Vec<f64> = (0..dim).map(|axis| if axis == 0 { normal * open } else { shear * jump[axis] }).collect();
    let pressed = jump[0].min(0.0);
    let mut traction: Vec<f64> = full.iter().map(|t| left * t).collect();
    traction[0] += normal * pressed;
    let mut tangent = vec![0.0; dim * dim];
    for i in 0..dim {
        let own = if i > 0 {
            left * shear
        } else if jump[0] > 0.0 {
            left * normal
        } else {
            normal
        };
        tangent[i * dim + i] = own;
        (0..dim).for_each(|j| tangent[i * dim + j] -= full[i] * growth[j]);
    }
    One { traction, tangent, energies: [left * y + 0.5 * normal * pressed * pressed, history[1]] }
}

/// One without a potential, which couples all directions, with a history that slows it down.
pub(crate) fn unsymmetric(jump: &[f64], history: &mut [f64]) -> One {
    let dim = jump.len();
    let coupling = |i: usize, j: usize| if i == j { 40.0 } else { 7.0 + 3.0 * i as f64 - 5.0 * j as f64 };
    let (speed, past) = (1.0 + history[1], history[0]);
    let traction = (0..dim).map(|i| {
        let linear: f64 = (0..dim).map(|j| coupling(i, j) * jump[j]).sum();
        linear * speed + 900.0 * jump[i].powi(3) + 30.0 * (i + 1) as f64 * jump[0] * jump[dim - 1] - past
    });
    let traction: Vec<f64> = traction.collect();
    let mut tangent = vec![0.0; dim * dim];
    for (i, row) in tangent.chunks_mut(dim).enumerate() {
        (0..dim).for_each(|j| row[j] = coupling(i, j) * speed);
        row[i] += 2700.0 * jump[i] * jump[i];
        row[0] += 30.0 * (i + 1) as f64 * jump[dim - 1];
        row[dim - 1] += 30.0 * (i + 1) as f64 * jump[0];
    }
    history[0] += 0.1 * jump[0];
    history[1] += jump[1].abs();
    One { traction, tangent, energies: [0.0; 2] }
}
