//! The depth of a pair, summed over its overlap.

use super::bodies::DeepBodies;
use super::obstacles::of_obstacle;
use crate::Error;
use crate::overlap::depth_integral::{DepthIntegral, DepthRequest};
use crate::overlap::pair::partner::Partner;
use crate::overlap::pair::region::common_region;
use crate::overlap::pair::sides::{Counterpart, Pair};

/// J of a pair, or `None` where the sides are apart.
///
/// # Errors
/// [`Error::Unsupported`] for bodies that are given by facets only, against one another.
pub(crate) fn depth_integral<const D: usize>(
    pair: &Pair<D>,
    request: &DepthRequest,
) -> Result<Option<DepthIntegral<D>>, Error> {
    if let (Partner::Obstacle(_), Some(pose)) = (pair.partners[1], pair.pose) {
        return of_obstacle(pair, pose, request);
    }
    let what = "the law depth, or friction with the law volume, between bodies given by facets: give cells";
    let (Some(field), Some(cells)) = (pair.depth, &pair.surface.cells) else {
        return Err(Error::Unsupported { what });
    };
    let bodies = DeepBodies { pair, cells, field, request };
    Ok(match &pair.counterpart {
        Counterpart::Facets(b) => common_region(&pair.a, b).and_then(|region| bodies.two(b, &region)),
        _ => bodies.one(),
    })
}
