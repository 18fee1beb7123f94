//! A tangent that waits to be fetched.

use super::failure::Failure;
use super::status::fmc_status::FMC_ERROR_LENGTH;
use crate::contact::Tangent;

/// A tangent with its dimension hidden: degree of freedom `node * dim + axis`, obstacles after the nodes.
#[derive(Default)]
pub(super) struct Kept {
    pub(super) entries: Vec<(i32, i32, f64)>,
    pub(super) rank_one: Vec<(f64, Vec<(usize, f64)>)>,
    pub(super) dof_count: usize,
}

impl Kept {
    /// Flattens a tangent of a mesh with so many nodes and obstacles.
    pub(super) fn new<const D: usize>(tangent: &Tangent<D>, node_count: usize) -> Result<Self, Failure> {
        let dof_count = node_count * D;
        if i32::try_from(dof_count).is_err() {
            let text = format!("{dof_count} degrees of freedom cannot be numbered in 32 bits");
            return Err(Failure::new(FMC_ERROR_LENGTH, text));
        }
        let entries = tangent.triplets().map(|(row, col, value)| (row as i32, col as i32, value)).collect();
        let rank_one = tangent.rank_one.iter().map(|part| {
            let entries = part.nodes.iter().zip(&part.vector);
            let flat = entries.flat_map(|(&node, g)| (0..D).map(move |axis| (node as usize * D + axis, g[axis])));
            (part.factor, flat.collect())
        });
        Ok(Self { entries, rank_one: rank_one.collect(), dof_count })
    }

    /// `y = K x`.
    pub(super) fn product(&self, x: &[f64]) -> Vec<f64> {
        let mut y = vec![0.0; x.len()];
        for &(row, col, value) in &self.entries {
            if (row as usize) < x.len() && (col as usize) < x.len() {
                y[row as usize] += value * x[col as usize];
            }
        }
        for (factor, vector) in &self.rank_one {
            let inside = || vector.iter().filter(|(dof, _)| *dof < x.len());
            let along: f64 = inside().map(|(dof, g)| g * x[*dof]).sum::<f64>() * factor;
            inside().for_each(|(dof, g)| y[*dof] += along * g);
        }
        y
    }
}
