//! Corners of a profile, rounded by a radius.

use super::piece::{Piece, Profile, Wrong, between, length, turn};

/// Angle in radians up to which pieces go on smoothly: files have seven digits.
const SMOOTH: f64 = 1e-3;

/// Where the centres of arcs may be that touch a piece on one side, and where they touch it.
#[derive(Clone, Copy)]
enum Guide {
    /// A point of the piece, its direction, and the way from it to these centres.
    Line { point: [f64; 2], along: [f64; 2], across: [f64; 2] },
    /// Centre and radius of the piece, and the radius on which these centres are.
    Circle { centre: [f64; 2], radius: f64, on: f64 },
}

impl Profile {
    /// The same with an arc of this radius at every corner between lines and arcs.
    ///
    /// # Errors
    /// A corner at a parabola, and pieces that are too short.
    pub(crate) fn rounded(&self, radius: f64) -> Result<Self, Wrong> {
        let mut pieces: Vec<(usize, Piece)> = Vec::new();
        let mut at = self.start;
        for (number, &(line, piece)) in self.pieces.iter().enumerate() {
            let wrong = |message: String| Err(Wrong { line, message });
            let Some(&(_, next)) = self.pieces.get(number + 1) else {
                pieces.push((line, piece));
                break;
            };
            let (corner, end) = (piece.end(), next.end());
            let angle = turn(ends(at, piece)[1], ends(corner, next)[0]);
            if angle.abs() <= SMOOTH {
                pieces.push((line, piece));
                at = corner;
                continue;
            }
            let guides = [guide(at, piece, angle.signum() * radius), guide(corner, next, angle.signum() * radius)];
            let [Some(before), Some(after)] = guides else {
                return wrong("FILLET RADIUS is known for corners between lines and arcs, not at PARBL".to_owned());
            };
            let short = || format!("FILLET RADIUS={radius} is too large for the segments at this corner");
            let Some(centre) = centre(before, after, corner) else { return wrong(short()) };
            let [first, last] = [before, after].map(|guide| guide.touched(centre));
            if !is_on(at, piece, first) || !is_on(corner, next, last) || length(between(last, end)) == 0.0 {
                return wrong(short());
            }
            let shortened = match piece {
                Piece::Arc { centre, .. } => Piece::Arc { end: first, centre },
                _ => Piece::Line(first),
            };
            pieces.extend([(line, shortened), (line, Piece::Arc { end: last, centre })]);
            at = last;
        }
        Ok(Self { start: self.start, pieces })
    }
}

/// The guide of arcs to the left of a piece from a point, for a radius below 0 to the right; none of a parabola.
fn guide(at: [f64; 2], piece: Piece, radius: f64) -> Option<Guide> {
    match piece {
        Piece::Line(end) => {
            let way = between(at, end);
            let along = way.map(|x| x / length(way));
            Some(Guide::Line { point: at, along, across: [-radius * along[1], radius * along[0]] })
        }
        Piece::Arc { end, centre } => {
            let [p, q] = [between(centre, at), between(centre, end)];
            let on = length(q) - turn(p, q).signum() * radius;
            Some(Guide::Circle { centre, radius: length(q), on }).filter(|_| on > 0.0)
        }
        Piece::Parabola { .. } => None,
    }
}

impl Guide {
    /// Where an arc about a centre touches the piece.
    fn touched(&self, x: [f64; 2]) -> [f64; 2] {
        match *self {
            Self::Line { across, .. } => [x[0] - across[0], x[1] - across[1]],
            Self::Circle { centre, radius, .. } => {
                let way = between(centre, x);
                std::array::from_fn(|k| centre[k] + radius * way[k] / length(way))
            }
        }
    }
}

/// The place on two guides that is nearest to a corner.
fn centre(a: Guide, b: Guide, corner: [f64; 2]) -> Option<[f64; 2]> {
    let found: Vec<[f64; 2]> = match (a, b) {
        (Guide::Line { point, along, across }, Guide::Line { point: other, along: way, across: aside }) => {
            // The corner is on both: from it both guides are as far.
            let from = [other[0] + aside[0] - point[0] - across[0], other[1] + aside[1] - point[1] - across[1]];
            let sine = along[0] * way[1] - along[1] * way[0];
            let s = (from[0] * way[1] - from[1] * way[0]) / sine;
            vec![[point[0] + across[0] + s * along[0], point[1] + across[1] + s * along[1]]]
        }
        (Guide::Line { point, along, across }, Guide::Circle { centre, on, .. })
        | (Guide::Circle { centre, on, .. }, Guide::Line { point, along, across }) => {
            let start = [point[0] + across[0], point[1] + across[1]];
            let from = between(centre, start);
            let middle = -(from[0] * along[0] + from[1] * along[1]);
            let square = on * on - length(from).powi(2) + middle * middle;
            let half = Some(square.sqrt()).filter(|half| half.is_finite())?;
            [middle - half, middle + half].map(|s| [start[0] + s * along[0], start[1] + s * along[1]]).to_vec()
        }
        (Guide::Circle { centre, on, .. }, Guide::Circle { centre: other, on: far, .. }) => {
            let way = between(centre, other);
            let distance = length(way);
            let along = (distance * distance + on * on - far * far) / (2.0 * distance);
            let aside = Some((on * on - along * along).sqrt()).filter(|aside| aside.is_finite())?;
            let unit = way.map(|x| x / distance);
            let at = |aside: f64| {
                [centre[0] + along * unit[0] - aside * unit[1], centre[1] + along * unit[1] + aside * unit[0]]
            };
            vec![at(aside), at(-aside)]
        }
    };
    let distance = |x: &[f64; 2]| length(between(corner, *x));
    let nearest = found.into_iter().min_by(|p, q| distance(p).total_cmp(&distance(q)));
    nearest.filter(|x| x.iter().all(|x| x.is_finite()))
}

/// Whether a place on the line or circle of a piece from a point is within the piece.
fn is_on(at: [f64; 2], piece: Piece, x: [f64; 2]) -> bool {
    match piece {
        Piece::Arc { end, centre } => {
            let [p, q, x] = [at, end, x].map(|place| between(centre, place));
            let (whole, part) = (turn(p, q), turn(p, x));
            part * whole > 0.0 && part.abs() < whole.abs()
        }
        _ => {
            let (whole, part) = (between(at, piece.end()), between(at, x));
            let along = whole[0] * part[0] + whole[1] * part[1];
            along > 0.0 && along < length(whole).powi(2)
        }
    }
}

/// Directions in which a piece from a point begins and ends.
fn ends(at: [f64; 2], piece: Piece) -> [[f64; 2]; 2] {
    match piece {
        Piece::Line(end) => [between(at, end); 2],
        Piece::Arc { end, centre } => {
            let [p, q] = [between(centre, at), between(centre, end)];
            let side = turn(p, q).signum();
            [p, q].map(|r| [-side * r[1], side * r[0]])
        }
        Piece::Parabola { middle, end } => {
            let tangent = |s: f64| {
                let of = |k: usize| (4.0 * s - 3.0) * at[k] + (4.0 - 8.0 * s) * middle[k] + (4.0 * s - 1.0) * end[k];
                [of(0), of(1)]
            };
            [tangent(0.0), tangent(1.0)]
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A right angle: the arc begins and ends at its radius from the corner, about the point that is as far from both lines.
    #[test]
    fn a_right_angle_is_rounded() {
        let corner =
            Profile { start: [0.0, 2.0], pieces: vec![(1, Piece::Line([0.0; 2])), (2, Piece::Line([3.0, 0.0]))] };
        let found = corner.rounded(0.5).unwrap();
        let Piece::Arc { end, centre } = found.pieces[1].1 else { panic!("{found:?}") };
        let off = |p: [f64; 2], q: [f64; 2]| length(between(p, q));
        assert!(off(end, [0.5, 0.0]) < 1e-15 && off(centre, [0.5, 0.5]) < 1e-15, "{found:?}");
        assert!(off(found.pieces[0].1.end(), [0.0, 0.5]) < 1e-15 && found.pieces[2] == corner.pieces[1]);
        assert!(corner.rounded(2.5).unwrap_err().message.contains("is too large for the segments at this corner"));
    }

    /// At corners with arcs, to both sides: the arc of a fillet has its radius, meets both pieces where they are, and goes on as they do.
    #[test]
    fn corners_at_arcs_are_rounded() {
        let arc = |end: [f64; 2], centre: [f64; 2]| Piece::Arc { end, centre };
        for pieces in [
            vec![Piece::Line([2.0, 0.0]), arc([4.0, 2.0], [4.0, 0.0])],
            vec![Piece::Line([2.0, 0.0]), arc([4.0, -2.0], [4.0, 0.0])],
            vec![Piece::Line([2.0, 0.0]), arc([3.0, 1.0], [2.0, 1.0])],
            vec![arc([2.0, 0.0], [1.0, -0.5]), arc([4.0, 0.0], [3.0, -0.5])],
            vec![arc([2.0, 0.0], [1.0, -0.5]), Piece::Line([2.0, 3.0])],
        ] {
            let profile = Profile { start: [0.0, 0.0], pieces: pieces.into_iter().map(|piece| (1, piece)).collect() };
            let found = profile.rounded(0.1).unwrap_or_else(|wrong| panic!("{wrong:?} {profile:?}"));
            let (mut at, mut last, mut count) = (profile.start, None, 0);
            for &(_, piece) in &found.pieces {
                let [enters, leaves] = ends(at, piece);
                if let Some(before) = last {
                    assert!(turn(before, enters).abs() < 1e-6, "{found:?}");
                }
                if let Piece::Arc { end, centre } = piece {
                    let [p, q] = [length(between(centre, at)), length(between(centre, end))];
                    assert!((p - q).abs() < 1e-12, "{found:?}");
                    count += usize::from((p - 0.1).abs() < 1e-12);
                }
                (at, last) = (piece.end(), Some(leaves));
            }
            // The third goes on smoothly by itself.
            assert_eq!(count, found.pieces.len() - profile.pieces.len(), "{found:?}");
        }
    }
}
