//! Overlaps at the start that loads do not explain: what a mesher left, or an interference that is meant.

use crate::contact::changes::poses::with_poses;
use crate::contact::equilibrium::driver::asking::assembly::Assembly;
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::progress::search::Search;
use crate::contact::equilibrium::driver::progress::state::State;
use crate::contact::equilibrium::driver::progress::stood::FormerState;
use crate::contact::evaluation::Contact;
use crate::contact::history::sorted;
use crate::contact::results::GapConstraints;
use crate::overlap::Partner;
use std::collections::BTreeMap;

/// Part of a facet above which an overlap is told.
pub(super) const TOLD: f64 = 1e-3;

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
    let count = search.host.contact(|contact| contact.partners.obstacles.count()).await;
    let deepest = match search.former.state.clone() {
        FormerState::Now => {
            deepest(&search.host.contact(move |contact| contact.gap_constraints(&coords, reach)).await?, |_| true)
        }
        // What was in equilibrium is what loads explain, and what obstacles and nodes were moved by since is meant.
        FormerState::Found(poses) => {
            let is_new = |partner: &Partner| match partner {
                Partner::Obstacle(obstacle) => poses.get(*obstacle).is_none_or(Option::is_none),
                Partner::Body(_) => false,
            };
            if (0..count).all(|obstacle| !is_new(&Partner::Obstacle(obstacle))) {
                return Ok(());
            }
            let gaps = search.host.contact(move |contact| contact.gap_constraints(&coords, reach)).await?;
            deepest(&gaps, |row| gaps.partners[row].iter().any(is_new))
        }
        FormerState::Begun(coords, poses) => {
            let gaps = move |contact: &mut Contact<D>| {
                with_poses(contact, &poses, |contact| contact.gap_constraints(&coords, reach))
            };
            deepest(&search.host.contact(gaps).await?, |_| true)
        }
    };
    let said = |names: [String; 2], depth: f64, part: f64| {
        let [a, b] = names;
        format!(
            "{a} and {b} overlap by {depth:.1e} at the start, {part:.0e} of a facet, more than the loads explain: they are pressed \
             apart. An adjustment removes overlaps without strain"
        )
    };
    let texts: Vec<String> =
        told(&search.assembly, &deepest).map(|(names, depth, part)| said(names, depth, part)).collect();
    texts.into_iter().for_each(|text| search.warn(text));
    Ok(())
}

/// Largest mean penetration of a node by pair, of rows that count.
pub(super) fn deepest<const D: usize>(
    gaps: &GapConstraints<D>,
    counts: impl Fn(usize) -> bool,
) -> BTreeMap<[Partner; 2], f64> {
    let mut deepest: BTreeMap<[Partner; 2], f64> = BTreeMap::new();
    for (row, (gap, area)) in gaps.gaps.iter().zip(&gaps.areas).enumerate() {
        if *area > 0.0 && counts(row) {
            let depth = deepest.entry(sorted(gaps.partners[row])).or_default();
            *depth = depth.max(-gap / area);
        }
    }
    deepest
}

/// Names of those that are to be told, with the penetration, and that by the smaller facet.
pub(super) fn told<const D: usize>(
    assembly: &Assembly<D>,
    deepest: &BTreeMap<[Partner; 2], f64>,
) -> impl Iterator<Item = ([String; 2], f64, f64)> {
    deepest.iter().filter_map(|(pair, &depth)| {
        let size = |partner: &Partner| match partner {
            Partner::Body(body) => assembly.facet_size.get(*body).copied(),
            Partner::Obstacle(_) => None,
        };
        let facet = pair.iter().filter_map(size).fold(f64::INFINITY, f64::min);
        (depth > TOLD * facet).then(|| (pair.map(|partner| assembly.name(partner)), depth, depth / facet))
    })
}
