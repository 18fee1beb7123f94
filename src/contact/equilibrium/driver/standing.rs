//! What holds bodies that the host's matrix does not, at an equilibrium.

use super::host::System;
use super::motions::{combined, pencil};
use super::search::Search;
use super::state::State;
use super::trouble::Trouble;
use crate::contact::tangents::TangentPart;
use nalgebra::{DMatrix, DVector};

/// Part of the diagonal that keeps the matrix regular where nothing holds a body.
const SHIFT: f64 = 1e-11;

/// Compliance of a motion, by that of all nodes alone, above which it is free.
const FREE: f64 = 1e10;

/// Warns of motions that nothing holds, or that lead away.
pub(super) async fn standing<const D: usize>(search: &mut Search<D>, state: &State<D>) -> Result<(), Trouble> {
    let count = search.motions.count();
    if count == 0 {
        return Ok(());
    }
    let (mut compliance, mut moved) = (DMatrix::zeros(count, count), Vec::with_capacity(count));
    for col in 0..count {
        let system = System { x: &state.x, part: TangentPart::Symmetric, shift: SHIFT };
        let Ok(found) = search.host.solve(system, search.motions.fields[col].clone()).await else { return Ok(()) };
        compliance.set_column(col, &search.motions.along(&found));
        moved.push(found);
    }
    let symmetric = 0.5 * (&compliance + compliance.transpose());
    let inverse = search.motions.diagonal.iter().map(|stiffness| 1.0 / stiffness);
    let inverse = DMatrix::from_diagonal(&DVector::from_iterator(count, inverse));
    let (values, vectors) = pencil(&symmetric, &inverse);
    for (k, value) in values.into_iter().enumerate() {
        let what = match value {
            value if value < 0.0 => "unstable",
            value if value > FREE => "free",
            _ => continue,
        };
        // What was solved is exact in its direction, less so in its size.
        let motion = search.host.unknowns.spread(&combined(&moved, &vectors.column(k).into_owned()));
        if let Some(mover) = search.assembly.mover(&motion) {
            search.warn(format!("{what}: {mover}"));
        }
    }
    Ok(())
}
