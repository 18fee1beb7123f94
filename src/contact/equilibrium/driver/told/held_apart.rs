//! Supports that contradict a tie.

use crate::contact::equilibrium::driver::progress::search::Search;
use crate::contact::ties::HeldApart;

/// What is said where supports hold both sides of a tie, and not as it does.
pub(crate) async fn held_apart<const D: usize>(search: &Search<D>) -> Option<String> {
    let HeldApart { bodies, point, jump } = search.updates.held_apart()?;
    let place = search.host.contact(move |contact| contact.surface().reference()[point as usize]).await;
    let place = place.map(|x| format!("{x:.6}").trim_end_matches('0').trim_end_matches('.').to_owned());
    let [a, b] = bodies.map(|body| search.assembly.id(body));
    let who = match a == b {
        true => format!("body {a}, which is tied to itself,"),
        false => format!("bodies {a} and {b}, which are tied or do not separate,"),
    };
    Some(format!(
        "supports hold {who} apart by {jump:.1e} at ({}), without deformation, which no update of the multipliers closes: prescribe the same motion \
         on both sides, free one of them, or let cells match there",
        place.join(", ")
    ))
}
