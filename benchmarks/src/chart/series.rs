//! Points under one name, and how they are drawn.

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mark {
    /// Connected.
    Line,
    /// Connected by a broken line.
    Dashes,
    /// Each point by its sign.
    Points,
    /// Connected, and each point by its sign.
    LineAndPoints,
}

/// Sign of a point: where series coincide, different ones can still be told apart.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Sign {
    /// ○
    Circle,
    /// ×
    Cross,
    /// □, a little larger.
    Square,
}

/// Some points under one name.
pub struct Series {
    /// Name in the legend.
    pub name: String,
    /// Red, green and blue.
    pub color: (u8, u8, u8),
    /// How it is drawn.
    pub mark: Mark,
    /// Sign of its points.
    pub sign: Sign,
    /// Points.
    pub points: Vec<(f64, f64)>,
}

impl Mark {
    /// Whether each point has its sign.
    pub fn has_points(self) -> bool {
        matches!(self, Mark::Points | Mark::LineAndPoints)
    }
}

impl Series {
    /// A curve.
    pub fn line(name: impl Into<String>, color: (u8, u8, u8), points: Vec<(f64, f64)>) -> Self {
        Self { name: name.into(), color, mark: Mark::Line, sign: Sign::Circle, points }
    }
}
