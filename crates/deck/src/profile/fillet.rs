//! Corners of a profile, rounded by a radius.

use super::piece::{Piece, Profile, Wrong, between, length, turn};

/// Angle in radians up to which pieces go on smoothly: files have seven digits.
const SMOOTH: f64 = 1e-3;

impl Profile {
    /// The same with an arc of this radius at every corner between two lines.
    ///
    /// # Errors
    /// A corner at an arc or a parabola, and lines that are too short.
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
            let [before, after] = [leaving(at, piece), entering(corner, next)];
            let angle = turn(before, after);
            if angle.abs() <= SMOOTH {
                pieces.push((line, piece));
                at = corner;
                continue;
            }
            let (Piece::Line(_), Piece::Line(_)) = (piece, next) else {
                return wrong(
                    "FILLET RADIUS is known for corners between two lines: write this one as CIRCL itself".to_owned(),
                );
            };
            let cut = radius * (0.5 * angle).tan().abs();
            let room = length(between(at, corner)).min(length(between(corner, end)));
            if cut >= room {
                return wrong(format!(
                    "FILLET RADIUS={radius} takes {cut:.4e} of both lines at this corner, and one has {room:.4e}"
                ));
            }
            let [u, v] = [before, after].map(|d| [d[0] / length(d), d[1] / length(d)]);
            let begin = [corner[0] - cut * u[0], corner[1] - cut * u[1]];
            let side = radius * angle.signum();
            let centre = [begin[0] - side * u[1], begin[1] + side * u[0]];
            let end = [corner[0] + cut * v[0], corner[1] + cut * v[1]];
            pieces.extend([(line, Piece::Line(begin)), (line, Piece::Arc { end, centre })]);
            at = end;
        }
        Ok(Self { start: self.start, pieces })
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

fn entering(at: [f64; 2], piece: Piece) -> [f64; 2] {
    ends(at, piece)[0]
}

fn leaving(at: [f64; 2], piece: Piece) -> [f64; 2] {
    ends(at, piece)[1]
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
        assert!(corner.rounded(2.5).unwrap_err().message.contains("takes 2.5000e0 of both lines"));
    }
}
