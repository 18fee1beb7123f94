//! Overlaps of surfaces that are held: no unknown can part them, and their force is a stiffness times an overlap.

use super::overlaps::{TOLD, deepest, told};
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::progress::search::Search;
use crate::contact::equilibrium::driver::progress::state::State;

/// A sentence for every pair that overlaps at the end where all nodes on both sides are held.
pub(crate) async fn held<const D: usize>(search: &Search<D>, end: &State<D>) -> Result<Vec<String>, Trouble> {
    let (assembly, unknowns) = (&search.assembly, &search.host.unknowns);
    let is_held = |node: usize| (node * D..(node + 1) * D).all(|place| unknowns.is_held(place));
    let is_held: Vec<bool> = (0..unknowns.base.len()).map(is_held).collect();
    let presses = |(force, is_held): (&[f64; D], &bool)| *is_held && force.iter().any(|force| *force != 0.0);
    if !end.contact.forces.iter().zip(&is_held).any(presses) {
        return Ok(Vec::new());
    }
    let (coords, reach) = (unknowns.coords(&end.x), TOLD * assembly.finest());
    let gaps = search.host.contact(move |contact| contact.gap_constraints(&coords, reach)).await?;
    let deepest = deepest(&gaps, |row| {
        let columns = &gaps.columns[gaps.row_starts[row]..gaps.row_starts[row + 1]];
        columns.iter().all(|&node| is_held[node as usize])
    });
    let said = |names: [String; 2], depth: f64, part: f64| {
        let [a, b] = names;
        format!(
            "{a} and {b} overlap by {depth:.1e}, {part:.0e} of a facet, where no node of either is free: the force there depends on the \
             stiffness of the contact. Leave nodes free, or move them apart"
        )
    };
    Ok(told(assembly, &deepest).map(|(names, depth, part)| said(names, depth, part)).collect())
}
