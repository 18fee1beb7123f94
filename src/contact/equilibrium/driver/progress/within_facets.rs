//! Pairs that touch within single facets, of which multipliers at nodes know nothing.

use super::state::State;
use crate::contact::equilibrium::driver::asking::assembly::Assembly;
use crate::contact::equilibrium::driver::asking::host::Host;
use crate::contact::history::sorted;
use crate::contact::results::PairForces;
use crate::overlap::{Partner, Warning};
use std::collections::BTreeSet;

/// Mean penetration by the bodies' own displacement of which something is said where no update follows: displacements or forces are wrong
/// by as much.
pub(crate) const TOLD: f64 = 1e-2;

/// Forces by those of before, or of a pair by all, that are none: what is left after a load is gone.
pub(crate) const UNLOADED: f64 = 1e-6;

/// How much penetration there may be without a word.
pub(crate) enum Most {
    /// As much as was asked for.
    Asked(f64),
    /// A part of the bodies' own displacement, as a mean by the forces.
    OfDisplacement(f64),
}

/// What is to be said of pairs that press and have no multiplier, as a corner in the middle of a facet: its nodes are apart on average, and
/// what penetrates between them is left to the stiffness. `scale`: all forces.
pub(crate) async fn within_facets<const D: usize>(
    (host, assembly): (&Host<D>, &Assembly<D>),
    (state, scale): (&State<D>, f64),
    most: Most,
) -> Vec<String> {
    let with_multipliers: BTreeSet<[Partner; 2]> =
        host.contact(|contact| contact.multipliers().iter().map(|one| sorted(one.partners)).collect()).await;
    // What is held together has an energy too, and does not penetrate.
    let mean = |pair: &PairForces| (2.0 * pair.energy / (pair.pressure * pair.contact_area)).min(pair.penetration);
    let (most, displacement) = match most {
        Most::Asked(most) => (most, None),
        Most::OfDisplacement(displacement) => (TOLD * displacement, Some(displacement)),
    };
    let is_left = |pair: &&PairForces| {
        let presses = pair.pressure * pair.contact_area > UNLOADED * scale;
        presses && pair.a != pair.b && !with_multipliers.contains(&sorted([pair.a, pair.b])) && mean(pair) > most
    };
    let are_faceted = |pair: &PairForces| {
        let is_of = |warning: &Warning| match warning {
            Warning::CurvedFaces { a, b, .. } => sorted([*a, *b]) == sorted([pair.a, pair.b]),
            _ => false,
        };
        state.contact.warnings.iter().any(is_of)
    };
    let said = |pair: &PairForces| {
        let part = displacement.map_or_else(String::new, |displacement| match mean(pair) / displacement {
            part if part > 1.0 => ", more than the bodies' own displacement".to_owned(),
            part => format!(", {:.0} % of the bodies' own displacement", 100.0 * part),
        });
        // Waves of straight facets touch, not the round faces for which these stand: no stiffness mends that.
        let remedy = match are_faceted(pair) {
            true => "smooth their round faces (set_surface_smoothing), or use second-order cells with curved edges",
            false => "refine both surfaces there, or give a larger stiffness",
        };
        format!(
            "{} and {} touch within single facets, where no multiplier acts: they penetrate by {:.1e} on average{part}; {remedy}",
            assembly.name(pair.a),
            assembly.name(pair.b),
            mean(pair),
        )
    };
    state.contact.pairs.iter().filter(is_left).map(said).collect()
}
