//! Displacements of nodes and the unknowns of the search.

use super::equilibrium::Equilibrium;

impl<const D: usize> Equilibrium<D> {
    /// Displacements of nodes by unknowns: those that are joined keep the distance at which the stage began.
    pub(super) fn by_unknowns(&self, x: &[f64]) -> Vec<[f64; D]> {
        let mut all: Vec<[f64; D]> = by_nodes(x);
        let equations = &self.matrices.equations;
        if equations.has_joined() {
            let of = |freedom: usize| x[equations.leader(freedom)] + self.apart(freedom);
            all.as_flattened_mut().iter_mut().enumerate().for_each(|(freedom, u)| *u = of(freedom));
            equations.by_followed(x).into_iter().for_each(|(freedom, by)| all[freedom / D][freedom % D] += by);
        }
        all
    }

    /// The unknowns at displacements of nodes: those of degrees of freedom that follow are how far they are apart.
    pub(super) fn unknowns_at(&self, displacement: &[[f64; D]]) -> Vec<f64> {
        let mut x = displacement.as_flattened().to_vec();
        let followed = self.matrices.equations.by_followed(&x);
        followed.into_iter().for_each(|(freedom, by)| x[freedom] -= by);
        x
    }

    /// How far a degree of freedom was from the one that stands for it when the stage began.
    pub(super) fn apart(&self, freedom: usize) -> f64 {
        let (leader, at) = (self.matrices.equations.leader(freedom), self.from.0.as_flattened());
        if leader == freedom { 0.0 } else { at[freedom] - at[leader] }
    }
}

/// A vector of all degrees of freedom, by nodes.
fn by_nodes<const D: usize>(vector: &[f64]) -> Vec<[f64; D]> {
    vector.as_chunks::<D>().0.to_vec()
}
