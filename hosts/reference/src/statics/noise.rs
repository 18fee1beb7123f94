//! What rounding alone makes of bodies that are free of stress.

use crate::fem::{Model, Part};

/// Forces and energies that are rounding alone.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Noise {
    /// Norm of nodal forces.
    pub(super) force: f64,
    /// Of the strain energy.
    pub(super) energy: f64,
}

impl Noise {
    /// Noise of bodies of size L.
    ///
    /// A displacement that came about by motions of size L is known to ε L, which strains a cell of size h by ε L / h; the stress
    /// E ε L / h on a face of the cell is a force E ε L h^(D−2), and √N of them a norm. Against forces E u h^(D−2) of a body
    /// that u deforms this is ε √N L / u, far below any tolerance; it matters where nothing is deformed. The energy per
    /// volume is a difference of terms as large as Young's modulus.
    pub(super) fn of<const D: usize>(model: &Model<D>, size: f64) -> Self {
        let measured = model.parts().iter().enumerate().map(|(number, part)| (part, model.volume(number)));
        let of = |(part, measure): (&Part<D>, f64)| {
            let cell = measure / part.mesh.cell_count() as f64;
            (part.material.young * cell.powf((D as f64 - 2.0) / D as f64), part.material.young * measure)
        };
        let (stiffest, energy) =
            measured.map(of).fold((0.0, 0.0), |sum: (f64, f64), of| (sum.0.max(of.0), sum.1 + of.1));
        let force = f64::EPSILON * (model.node_count() as f64).sqrt() * stiffest * size;
        Self { force, energy: f64::EPSILON * energy }
    }
}
