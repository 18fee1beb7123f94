//! What flows between a body and an obstacle.

use super::conductance::Conductance;
use super::shares::Shares;
use crate::Error;
use crate::contact::laws::{Asked, Measured};
use crate::interfaces::shape_at;
use crate::overlap::{Block, Partner, gap_points};

/// The derivative of the flux out of the nodes by the field, the obstacle being a node after those of the mesh. Pressure is that of the law at
/// the depth of the point below the obstacle's surface.
///
/// # Errors
/// Those of the law; [`Error::SignedDistance`].
pub(crate) fn of_obstacle<const D: usize>(
    measured: &Measured<D>,
    conductance: &Conductance,
) -> Result<Vec<Block<1>>, Error> {
    let (pair, law) = (measured.pair, measured.law);
    let Partner::Body(body) = pair.partners[0] else { return Ok(Vec::new()) };
    let first = pair.surface.ranges[body].start;
    let of_pair = match law.pressure(0.0) {
        Some(_) => 0.0,
        None => {
            let asked = Asked { energy: true, ..Asked::default() };
            law.measure(measured, &asked)?.and_then(|answer| answer.energy).map_or(0.0, |energy| energy.pressure)
        }
    };
    let rounding = pair.a.aabb.rounding();
    let far = [(measured.obstacle_node(), 1.0)];
    let (mut shares, mut last) = (Shares::default(), None);
    for point in gap_points(pair, conductance.reach().max(rounding))? {
        if last.is_some_and(|last| last != point.facet) {
            shares.end_part();
        }
        last = Some(point.facet);
        let h = match point.gap <= rounding {
            true => conductance.pressed(law.pressure(-point.gap).unwrap_or(of_pair)),
            false => conductance.apart(point.gap),
        };
        if h > 0.0 {
            let near = shape_at(pair.surface, first + point.facet as usize, &point.weights);
            shares.add(h * point.measure, &near, &far);
        }
    }
    Ok(shares.into_sum().into_blocks())
}
