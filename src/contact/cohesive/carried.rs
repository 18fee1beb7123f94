//! What points of an interface have been through, brought to points that were found anew.

use crate::geometry::Vector;
use crate::interfaces::{Cohesion, PointState};
use std::collections::BTreeMap;

/// For every point of the second interface the nearest of the first among those that hang on one of its nodes, both as they lie on the first
/// body at these points of the mesh.
pub(crate) fn nearest<const D: usize>(
    [before, now]: [&Cohesion<D>; 2],
    points: &[[f64; D]],
) -> impl Iterator<Item = Option<usize>> {
    let mut of_node: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
    for (number, point) in before.points.iter().enumerate() {
        before.own_nodes(point).for_each(|node| of_node.entry(node).or_default().push(number));
    }
    let lies: Vec<Vector<D>> = before.points.iter().map(|point| before.position(point, points)).collect();
    now.points.iter().map(move |point| {
        let at = now.position(point, points);
        let near = now.own_nodes(point).filter_map(|node| of_node.get(&node)).flatten();
        let away = |number: &usize| (lies[*number] - at).norm_squared();
        near.copied().min_by(|a, b| away(a).total_cmp(&away(b)).then(a.cmp(b)))
    })
}

/// Every point of the second interface has been through what the nearest of the first has; its elastic slip stays; one that has no such
/// neighbour is whole. Where both have the same points all is kept as it was.
pub(super) fn carried<const D: usize>(
    [before, now]: [&Cohesion<D>; 2],
    points: &[[f64; D]],
    past: &[PointState],
) -> Vec<PointState> {
    let one = |(point, nearest): (_, Option<usize>)| {
        let state = nearest.and_then(|number| Some((number, *past.get(number)?)));
        state.map_or_else(PointState::default, |(number, mut state)| {
            state.history.slip = now.slip_of((before, &before.points[number]), point, points, state.history.slip);
            state
        })
    };
    now.points.iter().zip(nearest([before, now], points)).map(one).collect()
}
