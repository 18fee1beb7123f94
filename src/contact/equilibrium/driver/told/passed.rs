//! Obstacles that were moved through a body before the search, which knows where they stand and not how they came there.

use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::progress::search::Search;
use crate::contact::evaluation::{self, Passed};
use crate::overlap::Partner;

/// Warns of them, with how far they were moved.
pub(crate) async fn passed<const D: usize>(search: &mut Search<D>, x: &[f64]) -> Result<(), Trouble> {
    let moved = search.former.moved.clone();
    if moved.is_empty() {
        return Ok(());
    }
    let coords = search.host.unknowns.coords(x);
    for found in search.host.contact(move |contact| evaluation::passed(contact, &coords, &moved)).await? {
        let Passed { obstacle, body, length, angle, is_of_step } = found;
        let [tool, body] = [Partner::Obstacle(obstacle), Partner::Body(body)].map(|one| search.assembly.name(one));
        let since = if is_of_step { "in this step" } else { "since it was added" };
        let turned = match angle.to_degrees().round() {
            0.0 => String::new(),
            degrees => format!(" and turned by {degrees} degrees"),
        };
        search.warn(format!(
            "{tool} was moved by {length:.1e}{turned} {since}, straight through {body}: it acts on the other side now, or not at all. A \
             search sees where an obstacle stands, not its way: divide the motion into shorter steps, with a search after each"
        ));
    }
    Ok(())
}
