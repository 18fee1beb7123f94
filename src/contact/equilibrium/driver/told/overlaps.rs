//! Overlaps at the start that loads do not explain: what a mesher left, or an interference that is meant.

use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::progress::search::Search;
use crate::contact::equilibrium::driver::progress::state::State;
use crate::contact::history::sorted;
use crate::overlap::Partner;
use std::collections::BTreeMap;

/// Part of a facet above which an overlap is told.
const TOLD: f64 = 1e-3;

/// Forces of the bodies by those of the contact below which they do not explain the overlap. Some load may be there all the same.
const UNLOADED: f64 = 0.5;

/// Warns of them, pair by pair.
pub(crate) async fn overlaps<const D: usize>(search: &mut Search<D>, start: &State<D>) -> Result<(), Trouble> {
    let unknowns = &search.host.unknowns;
    let [inside, pressed] = [&start.inside, &start.forces].map(|forces| unknowns.free_norm(forces));
    if inside >= UNLOADED * pressed {
        return Ok(());
    }
    let (coords, reach) = (unknowns.coords(&start.x), TOLD * search.assembly.finest());
    let gaps = search.host.contact(move |contact| contact.gap_constraints(&coords, reach)).await?;
    let mut deepest: BTreeMap<[Partner; 2], f64> = BTreeMap::new();
    for (partners, (gap, area)) in gaps.partners.iter().zip(gaps.gaps.iter().zip(&gaps.areas)) {
        if *area > 0.0 {
            let depth = deepest.entry(sorted(*partners)).or_default();
            *depth = depth.max(-gap / area);
        }
    }
    for (pair, depth) in deepest {
        let assembly = &search.assembly;
        let size = |partner: &Partner| match partner {
            Partner::Body(body) => assembly.facet_size.get(*body).copied(),
            Partner::Obstacle(_) => None,
        };
        let facet = pair.iter().filter_map(size).fold(f64::INFINITY, f64::min);
        if depth > TOLD * facet {
            let text = format!(
                "{} and {} overlap by {depth:.1e} at the start, {:.0e} of a facet, more than the loads explain: they are pressed \
                 apart. An adjustment removes overlaps without strain",
                assembly.name(pair[0]),
                assembly.name(pair[1]),
                depth / facet
            );
            search.warn(text);
        }
    }
    Ok(())
}
