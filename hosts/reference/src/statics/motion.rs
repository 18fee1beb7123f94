//! Rigid motions that supports leave to a body.

use super::equilibrium::Equilibrium;
use super::error::StaticsError;
use fmc_contact::contact::TangentPart;
use nalgebra::DMatrix;

/// A rigid motion of one body that its supports allow, infinitesimal.
#[derive(Clone, Debug)]
pub(super) struct Motion<const D: usize> {
    /// Index of the body.
    pub(super) part: usize,
    /// First node of the body.
    first: usize,
    /// Displacement of its nodes; the largest is about 1.
    field: Vec<[f64; D]>,
    /// As in "translation along x".
    pub(super) name: String,
}

/// Part of the largest eigenvalue below which a motion is not resisted.
const NOTHING: f64 = 1e-10;

/// Part of what its lines resist to which a motion is resisted in truth, if it is: rounding with exact overlap, some per mille
/// of noise with lines.
const CANCELLED: f64 = 1e-2;

impl<const D: usize> Motion<D> {
    /// Work of nodal forces.
    pub(super) fn work(&self, forces: &[[f64; D]]) -> f64 {
        let forces = &forces[self.first..self.first + self.field.len()];
        forces.iter().flatten().zip(self.field.iter().flatten()).map(|(f, m)| f * m).sum()
    }

    /// Adds `amount` of the motion.
    pub(super) fn add_to(&self, displacement: &mut [[f64; D]], amount: f64) {
        for (u, m) in displacement[self.first..].iter_mut().zip(&self.field) {
            (0..D).for_each(|i| u[i] += amount * m[i]);
        }
    }
}

impl<const D: usize> Equilibrium<D> {
    /// Motions that supports leave to the bodies at a displacement.
    pub(super) fn free_motions(&self, displacement: &[[f64; D]]) -> Vec<Motion<D>> {
        let coords = self.placed(displacement);
        (0..self.problem.model.parts().len()).flat_map(|part| self.free_motions_of(part, &coords)).collect()
    }

    fn free_motions_of(&self, part: usize, coords: &[[f64; D]]) -> Vec<Motion<D>> {
        let nodes = self.problem.model.nodes_of(part);
        let coords = &coords[nodes.clone()];
        let count = coords.len() as f64;
        let centre: [f64; D] = std::array::from_fn(|i| coords.iter().map(|x| x[i]).sum::<f64>() / count);
        let reach = |x: &[f64; D]| (0..D).map(|i| (x[i] - centre[i]).abs()).fold(0.0, f64::max);
        let radius = coords.iter().map(reach).fold(f64::MIN_POSITIVE, f64::max);
        let rotations: &[(usize, usize, &str)] =
            if D == 2 { &[(0, 1, "z")] } else { &[(1, 2, "x"), (2, 0, "y"), (0, 1, "z")] };
        let names: Vec<String> = (0..D)
            .map(|i| format!("translation along {}", ["x", "y", "z"][i]))
            .chain(rotations.iter().map(|(.., axis)| format!("rotation about {axis}")))
            .collect();
        let at = |motion: usize, x: &[f64; D], axis: usize| match motion.checked_sub(D) {
            None => f64::from(motion == axis),
            Some(rotation) => {
                let (i, j, _) = rotations[rotation];
                let turn = |axis: usize| (x[axis] - centre[axis]) / radius;
                if axis == i {
                    -turn(j)
                } else if axis == j {
                    turn(i)
                } else {
                    0.0
                }
            }
        };
        // What supports see of the motions: its null space is free.
        let mut seen = DMatrix::<f64>::zeros(names.len(), names.len());
        for (node, axis, _) in self.problem.supports.iter().filter(|(node, ..)| nodes.contains(node)) {
            let row: Vec<f64> = (0..names.len()).map(|m| at(m, &coords[node - nodes.start], axis)).collect();
            (0..names.len()).for_each(|p| (0..names.len()).for_each(|q| seen[(p, q)] += row[p] * row[q]));
        }
        let eigen = seen.symmetric_eigen();
        let largest = eigen.eigenvalues.iter().copied().fold(0.0, f64::max);
        let free = (0..names.len()).filter(|&k| eigen.eigenvalues[k] <= NOTHING * largest);
        free.map(|k| {
            let mix = eigen.eigenvectors.column(k);
            let most = (0..names.len()).max_by(|p, q| mix[*p].abs().total_cmp(&mix[*q].abs())).unwrap_or(0);
            let field = coords
                .iter()
                .map(|x| std::array::from_fn(|axis| (0..names.len()).map(|m| mix[m] * at(m, x, axis)).sum()));
            Motion { part, first: nodes.start, field: field.collect(), name: names[most].clone() }
        })
        .collect()
    }

    /// The free motion that contact resists least, if it resists one not at all: as an error that names it.
    ///
    /// A disc that slides on a plane pulls its flanks through the lines: what stretches here shrinks there, and only the
    /// whole second derivative of the energy knows that nothing is gained. What it leaves of the semidefinite part is
    /// compared with that.
    pub(super) fn unsupported(&self, displacement: &[[f64; D]]) -> Result<Option<StaticsError>, StaticsError> {
        let motions = self.free_motions(displacement);
        if motions.is_empty() {
            return Ok(None);
        }
        let semidefinite = self.resistance(&motions, displacement, TangentPart::Semidefinite)?;
        let eigen = self.resistance(&motions, displacement, TangentPart::Symmetric)?.symmetric_eigen();
        let largest = eigen.eigenvalues.iter().copied().fold(0.0, |most: f64, value| most.max(value.abs()));
        let loose = (0..motions.len()).find(|&k| {
            let (value, mix) = (eigen.eigenvalues[k].abs(), eigen.eigenvectors.column(k));
            value <= NOTHING * largest || value <= CANCELLED * (&semidefinite * mix).dot(&mix)
        });
        let Some(loose) = loose else { return Ok(None) };
        let mix = eigen.eigenvectors.column(loose);
        let most = (0..motions.len()).max_by(|p, q| mix[*p].abs().total_cmp(&mix[*q].abs())).unwrap_or(0);
        let body = self.problem.model.parts()[motions[most].part].name.clone();
        Ok(Some(StaticsError::Unsupported { body, motion: motions[most].name.clone() }))
    }

    /// Whether contact drives a body on, the more the farther it goes: one that lies inside another does so where a side
    /// comes nearer.
    pub(super) fn is_driven_on(&self, displacement: &[[f64; D]]) -> Result<bool, StaticsError> {
        let motions = self.free_motions(displacement);
        if motions.is_empty() {
            return Ok(false);
        }
        let eigenvalues = self.resistance(&motions, displacement, TangentPart::Symmetric)?.symmetric_eigenvalues();
        let largest = eigenvalues.iter().fold(0.0, |most: f64, value| most.max(value.abs()));
        Ok(eigenvalues.iter().any(|value| *value < -CANCELLED * largest))
    }

    /// Second derivative of the contact energy by motions.
    fn resistance(
        &self,
        motions: &[Motion<D>],
        displacement: &[[f64; D]],
        part: TangentPart,
    ) -> Result<DMatrix<f64>, StaticsError> {
        let tangent = self.contact.tangent(&self.placed(displacement), part)?;
        let mut resistance = DMatrix::zeros(motions.len(), motions.len());
        for (q, motion) in motions.iter().enumerate() {
            let mut field = vec![[0.0; D]; displacement.len()];
            motion.add_to(&mut field, 1.0);
            let force = tangent.product(&field);
            motions.iter().enumerate().for_each(|(p, other)| resistance[(p, q)] = other.work(&force));
        }
        Ok(resistance)
    }
}
