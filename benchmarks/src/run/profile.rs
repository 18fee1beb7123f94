//! Pressure over the contact surface.

use crate::chart::{Axis, Mark, Panel, Series, Sign};
use fmc_solid::statics::{Equilibrium, NodalPressure, nodal_tractions};
use std::fmt::Write;

/// Pressures at the nodes, and curves to be seen beside them.
#[derive(Clone, Debug, PartialEq)]
pub struct Profile {
    /// What the place is, with its unit.
    pub place: &'static str,
    /// Place and pressure of every node, by place.
    pub points: Vec<(f64, f64)>,
    /// Name and points of every curve.
    pub curves: Vec<(&'static str, Vec<(f64, f64)>)>,
    /// Place of an edge at which the pressure has no bound: what is beside it is shown on its own, too.
    pub edge: Option<f64>,
}

/// Part of the way to an edge up to which pressures are shown without its peak.
const BESIDE_EDGE: f64 = 0.95;

/// Points of a curve in a picture.
const FINENESS: usize = 400;

/// Nodes with less than this part of the largest pressure are not in contact: rounding.
const TOUCHING: f64 = 1e-6;

/// A surface in contact, flat or nearly so: every node with its pressure along the last axis, those without contact too.
/// The place is x (2D) or the distance from the last axis (3D), undeformed.
pub(super) struct Surface<const D: usize> {
    pub(super) nodes: Vec<NodalPressure<D>>,
}

impl<const D: usize> Surface<D> {
    pub(super) fn of(at: &Equilibrium<D>, part: usize) -> Self {
        let mut nodes = nodal_tractions(at.model(), part, &at.balance().contact.forces, D - 1);
        nodes.sort_by(|p, q| place(&p.place).total_cmp(&place(&q.place)));
        Self { nodes }
    }

    pub(super) fn peak(&self) -> f64 {
        self.nodes.iter().map(|node| node.pressure).fold(0.0, f64::max)
    }

    /// Nodes in contact.
    pub(super) fn touching(&self) -> impl Iterator<Item = &NodalPressure<D>> {
        let least = TOUCHING * self.peak();
        self.nodes.iter().filter(move |node| node.pressure > least)
    }

    /// Place of the outermost node in contact.
    pub(super) fn reach(&self) -> f64 {
        self.touching().map(|node| place(&node.place)).fold(0.0, f64::max)
    }

    /// Place and pressure as far as a place.
    pub(super) fn points(&self, to: f64) -> Vec<(f64, f64)> {
        let near = self.nodes.iter().map(|node| (place(&node.place), node.pressure));
        near.filter(|(x, _)| *x <= to).collect()
    }

    /// Distance from a curve between two places, by the curve's norm: root mean square, the nodes weighed by their area or
    /// all alike.
    pub(super) fn distance(&self, from: f64, to: f64, by_area: bool, curve: impl Fn(f64) -> f64) -> Option<f64> {
        let inside = self.nodes.iter().filter(|node| (from..=to).contains(&place(&node.place)));
        let (off, size) = inside.fold((0.0, 0.0), |sum, node| {
            let (p, q) = (node.pressure, curve(place(&node.place)));
            let weight = if by_area { node.area } else { 1.0 };
            (sum.0 + weight * (p - q).powi(2), sum.1 + weight * q * q)
        });
        (size > 0.0).then(|| (off / size).sqrt())
    }
}

/// x in 2D, the distance from the z axis in 3D.
pub(super) fn place<const D: usize>(x: &[f64; D]) -> f64 {
    if D == 2 { x[0] } else { x[0].hypot(x[1]) }
}

/// Linear between given points; the last one beyond the end.
pub(super) fn between(points: &[[f64; 2]], x: f64) -> f64 {
    let next = points.partition_point(|point| point[0] < x);
    match (next.checked_sub(1).and_then(|k| points.get(k)), points.get(next)) {
        (Some(p), Some(q)) => p[1] + (q[1] - p[1]) * (x - p[0]) / (q[0] - p[0]),
        (Some(p), None) | (None, Some(p)) => p[1],
        (None, None) => 0.0,
    }
}

/// Points of a function from one place to another.
pub(super) fn drawn(from: f64, to: f64, curve: impl Fn(f64) -> f64) -> Vec<(f64, f64)> {
    let at = |k: usize| from + (to - from) * k as f64 / FINENESS as f64;
    (0..=FINENESS).map(|k| (at(k), curve(at(k)))).filter(|(_, p)| p.is_finite()).collect()
}

impl Profile {
    /// As CSV: the nodes, then the curves.
    pub(super) fn table(&self) -> String {
        let mut text = "what,place,pressure\n".to_owned();
        let nodes = std::iter::once(&("nodal pressure", self.points.clone())).cloned().collect::<Vec<_>>();
        for (name, points) in nodes.iter().chain(&self.curves) {
            for (x, p) in points {
                writeln!(text, "{name},{x:?},{p:?}").expect("writing into a string");
            }
        }
        text
    }

    /// As pictures: all of it; where there is an edge, first what is beside it.
    pub(super) fn panels(&self) -> Vec<Panel> {
        let beside = self.edge.map(|edge| BESIDE_EDGE * edge);
        beside.into_iter().chain([f64::INFINITY]).map(|to| self.panel(to)).collect()
    }

    fn panel(&self, to: f64) -> Panel {
        const COLORS: [(u8, u8, u8); 3] = [(30, 30, 30), (0, 114, 178), (0, 158, 115)];
        // Numbers on the axes stay short.
        let largest = |of: fn(&(f64, f64)) -> f64| self.points.iter().map(of).fold(0.0, f64::max);
        let (pressure, unit) = match largest(|point| point.1) {
            p if p >= 1e8 => (1e-9, "GPa"),
            p if p >= 1e5 => (1e-6, "MPa"),
            _ => (1.0, "Pa"),
        };
        let is_small = largest(|point| point.0) < 0.02;
        let (length, place) = match self.place.strip_suffix(", m") {
            Some(place) if is_small => (1e3, format!("{place}, mm")),
            _ => (1.0, self.place.to_owned()),
        };
        let shown = |points: &[(f64, f64)]| {
            let near = points.iter().filter(|(x, _)| *x <= to);
            near.map(|(x, p)| (length * x, pressure * p)).collect::<Vec<_>>()
        };
        let nodes = Series {
            mark: Mark::Points,
            sign: Sign::Circle,
            ..Series::line("nodal pressure", (213, 94, 0), shown(&self.points))
        };
        let curves =
            self.curves.iter().zip(COLORS).map(|((name, points), color)| Series::line(*name, color, shown(points)));
        Panel {
            x: Axis::linear(place),
            y: Axis::linear(format!("contact pressure, {unit}")),
            series: std::iter::once(nodes).chain(curves).collect(),
        }
    }
}
