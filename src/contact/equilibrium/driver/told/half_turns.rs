//! Obstacles that turn by half a turn in a step with friction: nothing tells which way round they went.

use crate::contact::equilibrium::driver::progress::search::Search;
use crate::contact::friction::MOST_TURN;
use crate::geometry::Motion;

/// A sentence for each.
pub(crate) async fn half_turns<const D: usize>(search: &Search<D>) -> Vec<String> {
    if !search.has_friction {
        return Vec::new();
    }
    let turned = search.host.contact(|contact| {
        let began = contact.history.step.iter().flat_map(|step| step.poses.iter().enumerate());
        let turned = began.filter_map(|(obstacle, from)| {
            let now = contact.partners.obstacles.get(obstacle)?.obstacle.pose;
            let angle = Motion::new((*from)?, now).angle;
            (angle > MOST_TURN).then_some((obstacle, angle.to_degrees()))
        });
        turned.collect::<Vec<_>>()
    });
    let said = |(obstacle, degrees): (usize, f64)| {
        format!(
            "obstacle {obstacle} was turned by {degrees:.0} degrees in this step: nothing tells half a turn from one the other way round, so \
             friction may point the wrong way. Turn it by less in a step"
        )
    };
    turned.await.into_iter().map(said).collect()
}
