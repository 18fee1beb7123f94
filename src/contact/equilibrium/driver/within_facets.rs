//! Pairs that touch within single facets, of which multipliers at nodes know nothing.

use super::assembly::Assembly;
use super::host::Host;
use super::state::State;
use crate::contact::history::sorted;
use crate::contact::results::PairForces;
use crate::overlap::Partner;
use std::collections::BTreeSet;

/// Mean penetration by the bodies' own displacement of which something is said.
const TOLD: f64 = 1e-2;

/// What is to be said of pairs that press and have no multiplier, as a corner in the middle of a facet: its nodes are apart on average, and
/// what penetrates between them is left to the stiffness. `displacement` is the bodies' own, as a mean by the forces.
pub(super) async fn within_facets<const D: usize>(
    (host, assembly): (&Host<D>, &Assembly<D>),
    state: &State<D>,
    displacement: f64,
) -> Vec<String> {
    let with_multipliers: BTreeSet<[Partner; 2]> =
        host.contact(|contact| contact.multipliers().iter().map(|one| sorted(one.partners)).collect()).await;
    let mean = |pair: &PairForces| 2.0 * pair.energy / (pair.pressure * pair.contact_area);
    let is_left = |pair: &&PairForces| {
        pair.a != pair.b && !with_multipliers.contains(&sorted([pair.a, pair.b])) && mean(pair) > TOLD * displacement
    };
    let said = |pair: &PairForces| {
        format!(
            "{} and {} touch within single facets, where no multiplier acts: they penetrate by {:.1e} on average, {:.0} % of the bodies' \
             own displacement; refine both surfaces there, or give a larger stiffness",
            assembly.name(pair.a),
            assembly.name(pair.b),
            mean(pair),
            100.0 * mean(pair) / displacement
        )
    };
    state.contact.pairs.iter().filter(is_left).map(said).collect()
}
