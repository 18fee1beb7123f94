//! Rigid shapes in the plane as polygons.

use fmc_contact::{Obstacle, Shape};
use std::f64::consts::{PI, TAU};

/// Corners on a full circle: round to the eye.
const CIRCLE: usize = 96;

/// Polygons that cover an obstacle, a half-space as far as `reach`; none for a shape without corners, as a signed distance function is.
pub(crate) fn outline(obstacle: &Obstacle<2>, reach: f64) -> Vec<Vec<[f64; 2]>> {
    let arc = |radius: f64, center: f64, from: f64, to: f64| {
        let angle = move |k: usize| from + (to - from) * k as f64 / CIRCLE as f64;
        (0..=CIRCLE).map(move |k| [radius * angle(k).cos(), center + radius * angle(k).sin()])
    };
    let polygons: Vec<Vec<[f64; 2]>> = match &obstacle.shape {
        Shape::HalfSpace => vec![vec![[-reach, 0.0], [-reach, -reach], [reach, -reach], [reach, 0.0]]],
        Shape::Ball { radius } => vec![arc(*radius, 0.0, 0.0, TAU).collect()],
        Shape::Cuboid { half_extents: [a, b] } => vec![vec![[-a, -b], [*a, -b], [*a, *b], [-a, *b]]],
        Shape::Cylinder { radius: r, half_height: h } => vec![vec![[-r, -h], [*r, -h], [*r, *h], [-r, *h]]],
        Shape::Cone { radius: r, half_height: h } => vec![vec![[-r, -h], [*r, -h], [0.0, *h]]],
        Shape::Capsule { radius, half_height: h } => {
            vec![arc(*radius, *h, 0.0, PI).chain(arc(*radius, -h, PI, TAU)).collect()]
        }
        Shape::Polytope { points, facets } => loops(points, facets),
        _ => Vec::new(),
    };
    let pose = &obstacle.pose;
    let place = |x: [f64; 2]| {
        [0, 1].map(|i| pose.position[i] + pose.scale * (pose.rotation[i][0] * x[0] + pose.rotation[i][1] * x[1]))
    };
    polygons.into_iter().map(|corners| corners.into_iter().map(place).collect()).collect()
}

/// Edges joined end to end.
fn loops(points: &[[f64; 2]], edges: &[[u32; 2]]) -> Vec<Vec<[f64; 2]>> {
    let mut left = edges.to_vec();
    let mut found = Vec::new();
    while let Some([start, mut end]) = left.pop() {
        let mut corners = vec![points[start as usize]];
        while let Some(next) = left.iter().position(|edge| edge[0] == end) {
            corners.push(points[end as usize]);
            end = left.swap_remove(next)[1];
        }
        found.push(corners);
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;
    use fmc_contact::Pose;

    /// Area by the shoelace formula.
    fn area(corners: &[[f64; 2]]) -> f64 {
        let next = corners.iter().cycle().skip(1);
        corners.iter().zip(next).map(|(a, b)| 0.5 * (a[0] * b[1] - a[1] * b[0])).sum::<f64>().abs()
    }

    #[test]
    fn outlines_have_the_area_of_the_shape() {
        let triangle =
            Shape::Polytope { points: vec![[0.0, 0.0], [2.0, 0.0], [0.0, 1.0]], facets: vec![[1, 2], [0, 1], [2, 0]] };
        let shapes = [
            (Shape::Cuboid { half_extents: [1.0, 2.0] }, 8.0),
            (Shape::Cone { radius: 1.0, half_height: 1.0 }, 2.0),
            (Shape::Ball { radius: 1.0 }, PI),
            (Shape::Capsule { radius: 1.0, half_height: 1.0 }, PI + 4.0),
            (triangle, 1.0),
        ];
        for (shape, expected) in shapes {
            let found = outline(&Obstacle { shape, pose: Pose::at([3.0, 1.0]).turned(0.3) }, 1.0);
            // A polygon of 96 corners has 0.07 % less area than its circle.
            assert!((area(&found[0]) / expected - 1.0).abs() < 1e-3, "{expected}");
        }
    }
}
