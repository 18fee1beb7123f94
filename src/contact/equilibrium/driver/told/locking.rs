//! Interfaces that break, and hold cells that do not match at more points than these can follow.

use crate::contact::equilibrium::driver::progress::search::Search;
use crate::interfaces::CohesiveLaw;
use crate::overlap::Partner;

/// Stiffness of an interface by that of contact of the same bodies from which on its tractions are not to be trusted.
const LOCKS: f64 = 2.0;

/// What is said of cohesive interfaces that are so stiff, where the stiffness of the bodies is known.
pub(crate) async fn locking<const D: usize>(search: &Search<D>) -> Vec<String> {
    let assembly = &search.assembly;
    let found = search.host.contact(|contact| {
        let known = contact.layer_stiffness().is_some();
        let all = contact.cohesions.all().flatten().filter(|(cohesion, _)| known && !cohesion.is_matching);
        let parts = all.map(|(cohesion, (options, _))| {
            let pair = cohesion.bodies.map(Partner::Body);
            (pair, CohesiveLaw::new(options).largest_stiffness() / contact.stiffness_of_pair(pair))
        });
        parts.filter(|(_, part)| part.is_finite() && *part > LOCKS).collect::<Vec<_>>()
    });
    let said = |([a, b], part): ([Partner; 2], f64)| {
        format!(
            "the cohesive interface of {} and {} is {part:.0} times as stiff as their contact, and their cells do not match: it holds them \
             too stiffly, and tractions and damage are wrong from point to point; let cells match, refine, or give it a lower stiffness",
            assembly.name(a),
            assembly.name(b)
        )
    };
    found.await.into_iter().map(said).collect()
}
