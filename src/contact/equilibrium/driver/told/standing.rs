//! What holds bodies that the host's matrix does not, at an equilibrium.

use crate::contact::equilibrium::driver::asking::host::System;
use crate::contact::equilibrium::driver::asking::trouble::{Trouble, Unheld};
use crate::contact::equilibrium::driver::asking::unknowns::{combined, dot, largest, moved};
use crate::contact::equilibrium::driver::bodies::motions::pencil;
use crate::contact::equilibrium::driver::progress::search::Search;
use crate::contact::equilibrium::driver::progress::state::State;
use crate::contact::tangents::TangentPart;
use nalgebra::{DMatrix, DVector};

/// Part of the diagonal that keeps the matrix regular where nothing holds a body.
const SHIFT: f64 = 1e-11;

/// Stiffness of all nodes alone along a motion, by what holds it, above which it is free.
const FREE: f64 = 1e10;

/// How far bodies are moved to see what holds them, by their penetration: what slides sticks after less when it comes back.
const ASIDE: f64 = 1e-4;

/// Warns of motions that nothing holds, or that lead away.
pub(crate) async fn standing<const D: usize>(search: &mut Search<D>, state: &State<D>) -> Result<(), Trouble> {
    let count = search.motions.count();
    if count == 0 {
        return Ok(());
    }
    let (mut compliance, mut answers) = (DMatrix::zeros(count, count), Vec::with_capacity(count));
    for col in 0..count {
        let system = System { x: &state.x, part: TangentPart::Symmetric, shift: SHIFT };
        let load = search.motions.weighted(&search.motions.fields[col]);
        let Ok(found) = search.host.solve(system, load).await else { return Ok(()) };
        compliance.set_column(col, &search.motions.along(&search.motions.weighted(&found)));
        answers.push(found);
    }
    let symmetric = 0.5 * (&compliance + compliance.transpose());
    let alone = DMatrix::from_diagonal(&DVector::from_column_slice(&search.motions.diagonal));
    let (values, vectors) = pencil(&symmetric, &alone);
    for (k, value) in values.into_iter().enumerate() {
        let what = match value {
            value if value < 0.0 => "unstable",
            value if value > FREE => "free",
            _ => continue,
        };
        // What was solved is exact in its direction, less so in its size.
        let motion = combined(&answers, &vectors.column(k).into_owned());
        if search.has_friction && is_held_back(search, state, &motion).await? {
            continue;
        }
        let motion = search.host.unknowns.spread(&motion);
        if let Some(mut mover) = search.assembly.mover(&motion) {
            // Both ways are free, or lead away.
            let main = mover.direction[mover.direction.iamax()];
            mover.direction *= if main < 0.0 { -1.0 } else { 1.0 };
            search.warn(format!("{what}: {mover}"));
            if value > FREE {
                search.free.push(Unheld::from(&mover));
            }
        }
    }
    Ok(())
}

/// Whether friction holds bodies that are moved a little, either way: facets that slide one way stick the other way, of which the tangent knows
/// nothing. A plank that slides on two supports at once is held by that.
async fn is_held_back<const D: usize>(search: &Search<D>, state: &State<D>, motion: &[f64]) -> Result<bool, Trouble> {
    let (size, penetration) = (largest(motion), state.contact.penetration);
    if state.contact.friction.slip_area == 0.0 || size == 0.0 || penetration == 0.0 {
        return Ok(false);
    }
    let step: Vec<f64> = motion.iter().map(|entry| entry * (ASIDE * penetration / size)).collect();
    let alone = dot(&step, &search.motions.weighted(&step));
    let mut is_held = true;
    for way in [1.0, -1.0] {
        let aside = State::at(&search.host, moved(&state.x, way, &step), false).await;
        is_held = aside.is_ok_and(|aside| {
            let pushed = moved(&aside.residual, -1.0, &state.residual);
            way * dot(&search.host.unknowns.freed(pushed), &step) * FREE > alone
        });
        if !is_held {
            break;
        }
    }
    // The host is left at the equilibrium.
    search.host.forces(&state.x, false).await?;
    Ok(is_held)
}
