//! The depth of the sides of a pair below each other's surfaces.

use super::bodies::of_bodies;
use super::curves::of_curved_bodies;
use super::integral::{DepthIntegral, DepthRequest};
use super::obstacles::of_obstacle;
use crate::Error;
use crate::overlap::pair::partner::Partner;
use crate::overlap::pair::sides::Pair;

/// J of a pair, or `None` where the sides are apart.
///
/// # Errors
/// [`Error::Unsupported`] for bodies that are given by facets only, against one another; those of a signed distance.
pub(crate) fn depth_integral<const D: usize>(
    pair: &Pair<D>,
    request: &DepthRequest,
) -> Result<Option<DepthIntegral<D>>, Error> {
    match (pair.partners[1], pair.pose) {
        (Partner::Obstacle(_), Some(pose)) => of_obstacle(pair, pose, request),
        _ => match of_curved_bodies(pair, request)? {
            Some(found) => Ok(found),
            None => of_bodies(pair, request),
        },
    }
}
