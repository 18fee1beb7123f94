//! A profile as files have it.

/// A part of a profile; it begins where the last ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Piece {
    /// Straight to a point.
    Line([f64; 2]),
    /// On a circle to a point, about a centre, by less than half of a turn.
    Arc { end: [f64; 2], centre: [f64; 2] },
    /// Through a point to another, by the parabola that has the first at the middle of its parameter.
    Parabola { middle: [f64; 2], end: [f64; 2] },
}

impl Piece {
    pub(super) fn end(&self) -> [f64; 2] {
        match *self {
            Self::Line(end) | Self::Arc { end, .. } | Self::Parabola { end, .. } => end,
        }
    }
}

/// Pieces with their lines; the outside is to the left.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Profile {
    pub(crate) start: [f64; 2],
    pub(crate) pieces: Vec<(usize, Piece)>,
}

/// What is wrong with a piece: its line, and a sentence.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Wrong {
    pub(crate) line: usize,
    pub(crate) message: String,
}

pub(super) fn between(p: [f64; 2], q: [f64; 2]) -> [f64; 2] {
    [q[0] - p[0], q[1] - p[1]]
}

pub(super) fn length(v: [f64; 2]) -> f64 {
    v[0].hypot(v[1])
}

/// The angle from a direction to another, to the left.
pub(super) fn turn(u: [f64; 2], v: [f64; 2]) -> f64 {
    (u[0] * v[1] - u[1] * v[0]).atan2(u[0] * v[0] + u[1] * v[1])
}
