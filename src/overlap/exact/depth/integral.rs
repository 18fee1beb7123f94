//! The depth of a pair, summed over its overlap.

use super::bodies::DeepBodies;
use super::obstacles::of_obstacle;
use crate::Error;
use crate::overlap::depth_integral::{DepthIntegral, SecondDerivative};
use crate::overlap::pair::partner::Partner;
use crate::overlap::pair::region::common_region;
use crate::overlap::pair::sides::{Counterpart, Pair};

/// J of a pair, or `None` where the sides are apart; the translation of the pair's obstacle has the number
/// `obstacle_node`.
///
/// # Errors
/// [`Error::Unsupported`] for bodies that are given by facets only, against one another.
pub(crate) fn depth_integral<const D: usize>(
    pair: &Pair<D>,
    second: SecondDerivative,
    obstacle_node: u32,
) -> Result<Option<DepthIntegral<D>>, Error> {
    if let (Partner::Obstacle(_), Some(pose)) = (pair.partners[1], pair.pose) {
        return of_obstacle(pair, pose, second, obstacle_node);
    }
    let what = "the law depth between bodies given by facets: depth is that of cells";
    let (Some(field), Some(cells)) = (pair.depth, &pair.surface.cells) else {
        return Err(Error::Unsupported { what });
    };
    let bodies = DeepBodies { pair, cells, field, second };
    Ok(match &pair.counterpart {
        Counterpart::Facets(b) => common_region(&pair.a, b).and_then(|region| bodies.two(b, &region)),
        _ => bodies.one(),
    })
}
