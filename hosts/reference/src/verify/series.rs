//! Points under one name, and how they are drawn.

use super::Method;
use plotters::prelude::*;

/// How a series is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Mark {
    Line,
    Dashes,
    Points,
    LineAndPoints,
}

/// Some points under one name.
pub(crate) struct Series {
    pub(crate) name: &'static str,
    pub(crate) color: (u8, u8, u8),
    pub(crate) mark: Mark,
    pub(crate) points: Vec<(f64, f64)>,
}

impl Mark {
    /// Whether each point has its sign.
    pub(crate) fn has_points(self) -> bool {
        matches!(self, Mark::Points | Mark::LineAndPoints)
    }
}

impl Series {
    /// In the method's colour, which tells them apart for colour-blind readers too (Okabe and Ito).
    pub(crate) fn of(method: Method, mark: Mark, points: Vec<(f64, f64)>) -> Self {
        let color = match method {
            Method::Isotropic => (213, 94, 0),
            Method::Lines => (0, 114, 178),
            Method::Exact => (0, 158, 115),
        };
        Self { name: method.name(), color, mark, points }
    }

    /// Stroke of the line or of the sign.
    pub(crate) fn style(&self, scale: f64) -> ShapeStyle {
        let (r, g, b) = self.color;
        RGBColor(r, g, b).stroke_width((2.0 * scale) as u32)
    }

    /// The sign of a point: each method has its own, so that those that coincide can be told apart.
    pub(crate) fn sign<'a, DB: DrawingBackend + 'a>(
        &self,
        at: (i32, i32),
        scale: f64,
    ) -> DynElement<'a, DB, (i32, i32)> {
        let (style, size) = (self.style(scale), (4.5 * scale) as i32);
        match self.name {
            "isotropic" => Cross::new(at, size, style).into_dyn(),
            "exact" => {
                let corners = [(-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1)];
                PathElement::new(corners.map(|(x, y)| (at.0 + x * size * 3 / 2, at.1 + y * size * 3 / 2)), style)
                    .into_dyn()
            }
            _ => Circle::new(at, size, style).into_dyn(),
        }
    }
}
