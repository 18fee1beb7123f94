//! How far a layer reaches behind its faces.

use super::front::{Front, cross, dot};
use std::collections::BTreeMap;

/// Why there is no layer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Unfilled {
    /// Faces at this node have no mean normal.
    Folded(usize),
    /// This face has no area, or is bent so much that nothing fits behind it.
    Flat(usize),
}

/// Thickness by the size of a surface, where nothing is in the way.
const BY_SIZE: f64 = 0.25;

/// Part of the radius of the largest ball that touches the surface at a node from behind and contains no other node: up to all of it, layers of different
/// faces do not meet.
const BY_BALL: f64 = 0.5;

/// Least volume at a corner of a cell, by that of a straight one.
const UPRIGHT: f64 = 0.05;

/// Times that the thickness at the corners of a cell is halved.
const MOST_HALVINGS: usize = 40;

/// Of each node, the way to its place at the back of the layer. Nodes at an end of the surface along an axis stay there, so that layers end in planes of
/// symmetry, and those of a ring on its axis stay on it.
pub(crate) fn to_back(
    points: &[[f64; 3]],
    fronts: &[Front],
    is_ring: bool,
) -> Result<BTreeMap<usize, [f64; 3]>, Unfilled> {
    let mut normals = normals(points, fronts);
    let mut thickness: BTreeMap<usize, f64> = BTreeMap::new();
    for nodes in surfaces(fronts) {
        let ends = [f64::min as fn(f64, f64) -> f64, f64::max]
            .map(|of| nodes.iter().map(|&node| points[node]).reduce(|a, b| std::array::from_fn(|k| of(a[k], b[k]))));
        let [low, high] = ends.map(|end| end.unwrap_or_default());
        let size = (0..3).map(|k| (high[k] - low[k]).powi(2)).sum::<f64>().sqrt();
        for &node in &nodes {
            let (x, normal) = (points[node], normals.entry(node).or_default());
            for k in 0..3 {
                let is_end = (x[k] - low[k]).min(high[k] - x[k]) <= 1e-9 * size;
                let is_on_axis = is_ring && k == 0 && x[0] <= 1e-9 * size;
                if is_on_axis || is_end && normal[k].abs() < 0.5 {
                    normal[k] = 0.0;
                }
            }
            let length = dot(*normal, *normal).sqrt();
            if length.is_nan() || length <= 1e-6 {
                return Err(Unfilled::Folded(node));
            }
            *normal = normal.map(|n| n / length);
            let normal = *normal;
            let ball = nodes.iter().map(|&other| {
                let way: [f64; 3] = std::array::from_fn(|k| points[other][k] - x[k]);
                let behind = -dot(normal, way);
                if behind > 0.0 { 0.5 * dot(way, way) / behind } else { f64::INFINITY }
            });
            // The other side of a ring is as far as its axis, twice.
            let across = if is_ring && normal[0] > 0.0 { x[0] / normal[0] } else { f64::INFINITY };
            let free = ball.fold(if across > 0.0 { across } else { f64::INFINITY }, f64::min);
            thickness.insert(node, (BY_BALL * free).min(BY_SIZE * size));
        }
    }
    for _ in 0..MOST_HALVINGS {
        let bent: Vec<&Front> =
            fronts.iter().filter(|front| !is_upright(points, front, &normals, &thickness)).collect();
        if bent.is_empty() {
            let way = |(&node, &t): (&usize, &f64)| (node, normals[&node].map(|n| -t * n));
            return Ok(thickness.iter().map(way).collect());
        }
        let mut corners: Vec<usize> = bent.iter().flat_map(|front| front.corners.iter().copied()).collect();
        corners.sort_unstable();
        corners.dedup();
        corners.into_iter().for_each(|node| *thickness.entry(node).or_default() *= 0.5);
    }
    let bent = fronts.iter().position(|front| !is_upright(points, front, &normals, &thickness));
    Err(Unfilled::Flat(bent.unwrap_or_default()))
}

/// The sum of the unit normals of the faces at each node, by their angles there; of length 1.
fn normals(points: &[[f64; 3]], fronts: &[Front]) -> BTreeMap<usize, [f64; 3]> {
    let mut normals: BTreeMap<usize, [f64; 3]> = BTreeMap::new();
    for (node, u, v) in fronts.iter().flat_map(|front| front.angles(|node| points[node])) {
        let normal = cross(u, v);
        let (sine, sum) = (dot(normal, normal).sqrt(), normals.entry(node).or_default());
        let angle = sine.atan2(dot(u, v));
        if sine > 0.0 {
            (0..3).for_each(|k| sum[k] += angle * normal[k] / sine);
        }
    }
    for normal in normals.values_mut() {
        let length = dot(*normal, *normal).sqrt();
        if length > 0.0 {
            *normal = normal.map(|n| n / length);
        }
    }
    normals
}

/// Nodes of surfaces that hang together.
fn surfaces(fronts: &[Front]) -> Vec<Vec<usize>> {
    let mut number: BTreeMap<usize, usize> = BTreeMap::new();
    let mut surfaces: Vec<Vec<usize>> = Vec::new();
    for front in fronts {
        let of = front.corners.iter().find_map(|node| number.get(node).copied()).unwrap_or(surfaces.len());
        if of == surfaces.len() {
            surfaces.push(Vec::new());
        }
        for &node in &front.corners {
            match number.insert(node, of) {
                None => surfaces[of].push(node),
                Some(other) if other != of => {
                    let joined = std::mem::take(&mut surfaces[other]);
                    number.extend(joined.iter().map(|node| (*node, of)));
                    surfaces[of].extend(joined);
                }
                Some(_) => {}
            }
        }
    }
    surfaces.retain(|nodes| !nodes.is_empty());
    surfaces
}

/// Whether the cell behind a face has a volume at each of its corners that is not small.
fn is_upright(
    points: &[[f64; 3]],
    front: &Front,
    normals: &BTreeMap<usize, [f64; 3]>,
    thickness: &BTreeMap<usize, f64>,
) -> bool {
    let away = |node: usize| normals[&node].map(|n| thickness[&node] * n);
    let at_back = |node: usize| {
        let away = away(node);
        std::array::from_fn(|k| points[node][k] - away[k])
    };
    let back = front.angles(at_back);
    front.angles(|node| points[node]).into_iter().zip(back).all(|((node, u, v), (_, p, q))| {
        let (away, straight) = (away(node), cross(u, v));
        let least = UPRIGHT * dot(straight, straight).sqrt() * thickness[&node];
        least > 0.0 && dot(straight, away) > least && dot(cross(p, q), away) > least
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn strip(points: &[[f64; 2]]) -> (Vec<[f64; 3]>, Vec<Front>) {
        let fronts = (1..points.len()).map(|k| Front { corners: vec![k - 1, k], middles: Vec::new() });
        (points.iter().map(|x| [x[0], x[1], 0.0]).collect(), fronts.collect())
    }

    /// A straight line: a quarter of its length, straight to its back, which is to the right of it.
    #[test]
    fn a_flat_surface_has_an_even_layer() {
        let (points, fronts) = strip(&[[0.0, 0.0], [1.0, 0.0], [4.0, 0.0]]);
        let back = to_back(&points, &fronts, false).unwrap();
        assert!(back.values().all(|way| *way == [0.0, -1.0, 0.0]), "{back:?}");
    }

    /// Half of a circle, seen from outside: half of its radius, towards the middle; its ends keep their height, since they are its lowest.
    #[test]
    fn a_round_surface_has_a_layer_within_its_radius() {
        let at = |k: usize| {
            let angle = std::f64::consts::PI * (1.0 - k as f64 / 16.0);
            [2.0 * angle.cos(), 2.0 * angle.sin()]
        };
        let (points, fronts) = strip(&(0..17).map(at).collect::<Vec<_>>());
        for (node, way) in to_back(&points, &fronts, false).unwrap() {
            let length = dot(way, way).sqrt();
            assert!((length - 1.0).abs() < 0.02, "{node}: {way:?}");
            assert!(way[0] * points[node][0] <= 1e-12 && way[1] <= 1e-12, "{node}: {way:?}");
            assert!(!matches!(node, 0 | 16) || way[1] == 0.0, "{node}: {way:?}");
        }
    }

    /// Both faces of a rib of width 0.2 keep less than half of it.
    #[test]
    fn a_rib_keeps_its_middle() {
        let rib = [[-1.0, 0.0], [-0.1, 0.0], [-0.1, 0.5], [-0.1, 1.0], [0.1, 1.0], [0.1, 0.5], [0.1, 0.0], [1.0, 0.0]];
        let (points, fronts) = strip(&rib);
        let back = to_back(&points, &fronts, false).unwrap();
        assert!(back[&2][0] > 0.0 && back[&2][0] < 0.1 && back[&5][0] < 0.0, "{back:?}");
    }

    #[test]
    fn faces_without_area_have_no_layer() {
        let (points, fronts) = strip(&[[0.0, 0.0], [1.0, 0.0], [1.0, 0.0]]);
        assert!(matches!(to_back(&points, &fronts, false), Err(Unfilled::Flat(1) | Unfilled::Folded(2))));
    }
}
