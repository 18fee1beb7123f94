//! Nodes along a profile: corners, and one in the middle of each edge.

use super::piece::{Piece, Profile, Wrong, between, length, turn};

/// Nodes along a profile.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Path {
    pub(crate) corners: Vec<[f64; 2]>,
    /// From each corner to the next.
    pub(crate) middles: Vec<[f64; 2]>,
    /// How far edges lie beside the profile, at most.
    pub(crate) off: f64,
}

/// Edges of a parabola, which they follow exactly.
const OF_PARABOLA: usize = 8;

/// Part of a radius by which both ends of an arc may differ: files have few digits.
const ROUNDED: f64 = 1e-3;

/// Distance of an edge of second order from its arc, for half of its angle.
pub(super) fn beside(radius: f64, half_angle: f64) -> f64 {
    radius * (1.0 - half_angle.cos()).powi(2) / 8.0
}

/// Divides a profile: an edge takes at most so many degrees of an arc. With half of this angle a, an edge through three nodes lies R (1 − cos a)²/8 beside an arc
/// of radius R: for 5 degrees 1.1e-7 R, for 10 1.8e-6 R.
///
/// # Errors
/// A piece without length, and an arc that is none.
pub(crate) fn path(profile: &Profile, most_angle: f64) -> Result<Path, Wrong> {
    let mut path = Path { corners: vec![profile.start], ..Path::default() };
    let mut at = profile.start;
    for &(line, piece) in &profile.pieces {
        let wrong = |message: &str| Err(Wrong { line, message: message.to_owned() });
        if length(between(at, piece.end())) == 0.0 {
            return wrong("this segment ends where it begins");
        }
        let (count, place): (usize, Box<dyn Fn(f64) -> [f64; 2]>) = match piece {
            Piece::Line(end) => (1, Box::new(move |s| std::array::from_fn(|k| (1.0 - s) * at[k] + s * end[k]))),
            Piece::Parabola { middle, end } => {
                let weights = |s: f64| [(1.0 - s) * (1.0 - 2.0 * s), 4.0 * s * (1.0 - s), s * (2.0 * s - 1.0)];
                let of = move |s: f64| {
                    let [a, b, c] = weights(s);
                    std::array::from_fn(|k| a * at[k] + b * middle[k] + c * end[k])
                };
                (OF_PARABOLA, Box::new(of))
            }
            Piece::Arc { end, centre } => {
                let [p, q] = [between(centre, at), between(centre, end)];
                let [first, last] = [length(p), length(q)];
                if (first - last).abs() > ROUNDED * first.max(last) {
                    let message = format!("the ends of this arc are {first} and {last} from its centre");
                    return Err(Wrong { line, message });
                }
                let angle = turn(p, q);
                if angle.abs() > std::f64::consts::PI - ROUNDED {
                    return wrong("an arc must be less than half of a turn: divide it");
                }
                let count = (angle.abs().to_degrees() / most_angle - 1e-9).ceil().max(1.0) as usize;
                let start = p[1].atan2(p[0]);
                path.off = path.off.max(beside(first, 0.5 * angle / count as f64));
                let of = move |s: f64| {
                    let (radius, angle) = (first + s * (last - first), start + s * angle);
                    [centre[0] + radius * angle.cos(), centre[1] + radius * angle.sin()]
                };
                (count, Box::new(of))
            }
        };
        let step = 1.0 / count as f64;
        for k in 0..count {
            path.middles.push(place((k as f64 + 0.5) * step));
            path.corners.push(if k + 1 == count { piece.end() } else { place((k as f64 + 1.0) * step) });
        }
        at = piece.end();
    }
    Ok(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All points of edges through the nodes of a quarter of a circle are as near to it as is said.
    #[test]
    fn edges_are_as_near_to_an_arc_as_is_said() {
        let arc = Piece::Arc { end: [0.0, 3.0], centre: [0.0; 2] };
        let path = path(&Profile { start: [3.0, 0.0], pieces: vec![(1, arc)] }, 5.0).unwrap();
        assert_eq!((path.corners.len(), path.middles.len()), (19, 18));
        let mut most: f64 = 0.0;
        for (k, middle) in path.middles.iter().enumerate() {
            for s in (0..=100).map(|s| s as f64 / 100.0) {
                let weights = [(1.0 - s) * (1.0 - 2.0 * s), 4.0 * s * (1.0 - s), s * (2.0 * s - 1.0)];
                let nodes = [path.corners[k], *middle, path.corners[k + 1]];
                let x: [f64; 2] = std::array::from_fn(|i| weights.iter().zip(nodes).map(|(w, node)| w * node[i]).sum());
                most = most.max((length(x) - 3.0).abs());
            }
        }
        // Samples miss the farthest point by a part of 1e-4 of it.
        assert!((most / path.off - 1.0).abs() < 1e-3 && path.off < 1.2e-7 * 3.0, "{most:e} {:e}", path.off);
    }

    #[test]
    fn arcs_that_are_none_are_refused() {
        for (end, centre, expected) in [
            ([0.0, 2.0], [0.0, 0.0], "the ends of this arc are 1 and 2 from its centre"),
            ([-1.0, 0.0], [0.0, 0.0], "less than half of a turn"),
            ([1.0, 0.0], [0.0, 0.0], "ends where it begins"),
        ] {
            let pieces = vec![(7, Piece::Arc { end, centre })];
            let wrong = path(&Profile { start: [1.0, 0.0], pieces }, 5.0).unwrap_err();
            assert!(wrong.line == 7 && wrong.message.contains(expected), "{wrong:?}");
        }
    }
}
