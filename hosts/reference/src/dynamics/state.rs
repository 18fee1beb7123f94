//! Where a simulation stands.

/// Motion of all nodes at one time; arrays are `[node_count, D]`.
#[derive(Clone, Debug, PartialEq)]
pub struct State<const D: usize> {
    /// Steps made since the start.
    pub step: u64,
    /// Displacement from the reference coordinates.
    pub displacement: Vec<[f64; D]>,
    /// Velocity at the same time as the displacement (after the second kick).
    pub velocity: Vec<[f64; D]>,
    /// Acceleration at that displacement; zero where a support holds.
    pub acceleration: Vec<[f64; D]>,
    /// Energy that damping and friction have taken out so far.
    pub dissipated: f64,
}

impl<const D: usize> State<D> {
    /// v += a τ.
    pub(super) fn kick(&mut self, acceleration: &[[f64; D]], duration: f64) {
        for (v, a) in self.velocity.iter_mut().zip(acceleration) {
            for axis in 0..D {
                v[axis] += duration * a[axis];
            }
        }
    }

    /// u += v τ.
    pub(super) fn drift(&mut self, duration: f64) {
        for (u, v) in self.displacement.iter_mut().zip(&self.velocity) {
            for axis in 0..D {
                u[axis] += duration * v[axis];
            }
        }
    }

    /// v *= `factor`; what that takes out of the kinetic energy is added to `dissipated`.
    pub(super) fn decay(&mut self, factor: f64, mass: &[f64]) {
        let before = self.kinetic(mass);
        self.velocity.iter_mut().flatten().for_each(|v| *v *= factor);
        self.dissipated += before * (1.0 - factor * factor);
    }

    /// Σ ½ m v².
    pub(super) fn kinetic(&self, mass: &[f64]) -> f64 {
        let squared = |v: &[f64; D]| v.iter().map(|x| x * x).sum::<f64>();
        0.5 * mass.iter().zip(&self.velocity).map(|(m, v)| m * squared(v)).sum::<f64>()
    }

    /// First node with a displacement or velocity that is not finite.
    pub(super) fn non_finite_node(&self) -> Option<usize> {
        let finite = |x: &[f64; D]| x.iter().all(|x| x.is_finite());
        (0..self.displacement.len()).find(|&n| !finite(&self.displacement[n]) || !finite(&self.velocity[n]))
    }
}
