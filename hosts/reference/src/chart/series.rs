//! Points under one name, and how they are drawn.

use plotters::prelude::*;

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

    /// Stroke of the line or of the sign.
    pub(super) fn style(&self, scale: f64) -> ShapeStyle {
        let (r, g, b) = self.color;
        RGBColor(r, g, b).stroke_width((2.0 * scale) as u32)
    }

    /// The sign of a point.
    pub(super) fn sign<'a, DB: DrawingBackend + 'a>(
        &self,
        at: (i32, i32),
        scale: f64,
    ) -> DynElement<'a, DB, (i32, i32)> {
        let (style, size) = (self.style(scale), (4.5 * scale) as i32);
        match self.sign {
            Sign::Circle => Circle::new(at, size, style).into_dyn(),
            Sign::Cross => Cross::new(at, size, style).into_dyn(),
            Sign::Square => {
                let corners = [(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)];
                PathElement::new(corners.map(|(x, y)| (at.0 + x * size * 3 / 2, at.1 + y * size * 3 / 2)), style)
                    .into_dyn()
            }
        }
    }
}
