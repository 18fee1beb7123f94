//! Bodies given by a function.

/// A body given by its signed distance: negative inside, positive outside, in a frame of its own.
///
/// `phi` must be 1-Lipschitz, |φ(x) − φ(y)| ≤ |x − y|, as every true signed distance and every minimum or maximum of
/// such distances is: lines are marched in steps of |φ|, and a function that grows faster is stepped over. A function
/// that grows more slowly costs evaluations, not accuracy.
///
/// `gradient` need not have unit length; it is used where φ = 0 only, for the outward normal. For the tangent of the law
/// `depth` it must be the gradient of φ inside as well. That law looks where |φ| leaves room only, and refuses a function
/// that it sees to grow faster.
pub trait SignedDistance<const D: usize>: Send + Sync {
    /// Writes φ and ∇φ at the points `x`. All slices have the same length. It is called from one thread at a time, the
    /// one that called the module. An error names the first point that failed.
    fn evaluate(&self, x: &[[f64; D]], phi: &mut [f64], gradient: &mut [[f64; D]]) -> Result<(), usize>;
}

impl<const D: usize, F> SignedDistance<D> for F
where
    F: Fn(&[f64; D]) -> (f64, [f64; D]) + Send + Sync,
{
    fn evaluate(&self, x: &[[f64; D]], phi: &mut [f64], gradient: &mut [[f64; D]]) -> Result<(), usize> {
        for (i, x) in x.iter().enumerate() {
            (phi[i], gradient[i]) = self(x);
        }
        Ok(())
    }
}

impl<const D: usize> std::fmt::Debug for dyn SignedDistance<D> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str("a function")
    }
}
