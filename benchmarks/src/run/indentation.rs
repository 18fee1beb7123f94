//! Figures of bodies pressed into one another, and of one that slides.

use super::Figure;
use super::profile::{Profile, Surface, between, drawn, place};
use super::way::LoadStep;
use crate::case::{Case, FigureKind, Material, MeshSource};
use anyhow::{Result, ensure};
use fmc_solid::statics::Equilibrium;
use std::f64::consts::PI;

/// Figures and pressures of an equilibrium.
pub(super) fn figures<const D: usize>(
    case: &Case,
    at: &Equilibrium<D>,
    steps: &[LoadStep],
    penetration: f64,
) -> Result<(Vec<Figure>, Option<Profile>)> {
    let part = case.figured();
    let view = View {
        case,
        at,
        part,
        surface: Surface::of(at, part),
        force: case.figures.copies as f64 * at.balance().contact.bodies[part].force[D - 1].abs(),
        modulus: modulus(&case.bodies[part].material),
    };
    ensure!(view.force > 0.0, "'{}' touches nothing", case.bodies[part].name);
    let (values, profile) = match case.figures.kind {
        FigureKind::Balls => view.balls(),
        FigureKind::Wedge => view.wedge(),
        FigureKind::Cone => view.cone(),
        FigureKind::Punch => view.punch(),
        _ => (ironing(at, steps), None),
    };
    let known = |name: &str| match name {
        "penetration_max" => Some((Some(penetration), "m")),
        _ => values.iter().find(|(known, ..)| *known == name).map(|&(_, value, unit)| (value, unit)),
    };
    let figure = |&name: &&'static str| {
        let (value, unit) = known(name).unwrap_or((None, ""));
        Figure { name, value, unit }
    };
    Ok((case.figures.kind.keys().iter().map(figure).collect(), profile))
}

/// E/(1 − ν²).
fn modulus(material: &Material) -> f64 {
    material.young / (1.0 - material.poisson.powi(2))
}

/// Name, value and unit of figures.
type Values = Vec<(&'static str, Option<f64>, &'static str)>;

struct View<'a, const D: usize> {
    case: &'a Case,
    at: &'a Equilibrium<D>,
    part: usize,
    surface: Surface<D>,
    /// Along the last axis, of the whole.
    force: f64,
    modulus: f64,
}

impl<const D: usize> View<'_, D> {
    /// The curve that the case gives.
    fn given(&self, x: f64) -> f64 {
        between(&self.case.figures.profile, x)
    }

    fn profile(&self, place: &'static str, to: f64, curves: Vec<(&'static str, Vec<(f64, f64)>)>) -> Option<Profile> {
        let mut curves = curves;
        if !self.case.figures.profile.is_empty() {
            let given = self.case.figures.profile.iter().map(|p| (p[0], p[1])).filter(|p| p.0 <= to);
            curves.push(("finer mesh", given.collect()));
        }
        let edge = (self.case.figures.kind == FigureKind::Punch).then_some(to);
        Some(Profile { place, points: self.surface.points(to), curves, edge })
    }

    /// Ball on its mirror image: p = p0 √(1 − r²/a²), p² over r² fitted where p > 0.3 of the largest.
    fn balls(&self) -> (Values, Option<Profile>) {
        let radius = match self.case.bodies[self.part].mesh {
            MeshSource::GradedHalfBall { radius, .. } | MeshSource::Ball { radius, .. } => radius,
            _ => f64::NAN,
        };
        // Against a plane: E* and R of the one ball. F = 4/3 E* a³/R, p0 = 3F/2πa².
        let hertz = (0.75 * self.force * radius / self.modulus).cbrt();
        let peak = 1.5 * self.force / (PI * hertz * hertz);
        let fit = fitted(&self.surface);
        let values = vec![
            ("force", Some(self.force), "N"),
            ("peak_pressure", fit.map(|(peak, _)| peak), "Pa"),
            ("contact_radius", fit.map(|(_, reach)| reach), "m"),
        ];
        let curve = drawn(0.0, 1.3 * hertz, |r| peak * (1.0 - (r / hertz).powi(2)).max(0.0).sqrt());
        (values, self.profile("distance from the axis, m", 1.3 * hertz, vec![("Hertz, of this force", curve)]))
    }

    /// Slope 45°. The closed form has a = P/E*, p = E*/π artanh √(1 − x²/a²).
    fn wedge(&self) -> (Values, Option<Profile>) {
        let a = self.force / self.modulus;
        let closed = |x: f64| if x < a { self.modulus / PI * (1.0 - (x / a).powi(2)).sqrt().atanh() } else { 0.0 };
        let current = |x: &[f64; D], node: usize| x[0] + self.at.displacement()[node][0];
        let reach = self.surface.touching().map(|node| current(&node.place, node.node)).fold(0.0, f64::max);
        let given = !self.case.figures.profile.is_empty();
        // The tip is singular: it is left out, as are its neighbours from the comparison with the closed form.
        let values = vec![
            ("force", Some(self.force), "N/m"),
            ("half_width", Some(self.surface.reach()), "m"),
            ("half_width_current", Some(reach), "m"),
            (
                "profile_error_true",
                self.surface.distance(0.003, 1.3 * a, false, |x| self.given(x)).filter(|_| given),
                "",
            ),
            ("profile_error_closed_form", self.surface.distance(0.08 * a, 1.3 * a, false, closed), ""),
        ];
        let curve = drawn(0.01 * a, 1.6 * a, closed);
        (values, self.profile("x, m", 1.6 * a, vec![("closed form", curve)]))
    }

    /// Slope 45°. The closed form of a half-space has a = 2d/π, p = E* d/(π a) arcosh(a/r); here d is that of the force.
    fn cone(&self) -> (Values, Option<Profile>) {
        let depth = (PI * self.force / (2.0 * self.modulus)).sqrt();
        let a = 2.0 * depth / PI;
        let closed = |r: f64| if r < a { self.modulus * depth / (PI * a) * (a / r).acosh() } else { 0.0 };
        let values = vec![
            ("force", Some(self.force), "N"),
            ("contact_radius", Some(self.surface.reach()), "m"),
            ("profile_error", self.surface.distance(0.1 * a, 1.3 * a, true, closed), ""),
            ("radial_spread", self.spread(), ""),
        ];
        let curve = drawn(0.02 * a, 1.6 * a, closed);
        (values, self.profile("distance from the axis, m", 1.6 * a, vec![("closed form, of this force", curve)]))
    }

    /// Root mean square of p − p̄(r) by that of p, p̄ being linear in r over every few neighbours in r; between 0.2 and 0.9 of
    /// the contact's radius.
    fn spread(&self) -> Option<f64> {
        let reach = self.surface.reach();
        let inside: Vec<(f64, f64)> =
            self.surface.points(0.9 * reach).into_iter().filter(|(r, _)| *r >= 0.2 * reach).collect();
        let (mut off, mut size) = (0.0, 0.0);
        for group in inside.chunks(8).filter(|group| group.len() > 3) {
            let line = line(group);
            off += group.iter().map(|(r, p)| (p - line.0 - line.1 * r).powi(2)).sum::<f64>();
            size += group.iter().map(|(_, p)| p * p).sum::<f64>();
        }
        (size > 0.0).then(|| (off / size).sqrt())
    }

    /// Pressures of the punch, which is half modelled: its middle is at x = 0, its edge at the largest x.
    fn punch(&self) -> (Values, Option<Profile>) {
        let edge = self.surface.nodes.iter().map(|node| place(&node.place)).fold(0.0, f64::max);
        let at = |from: f64, to: f64| {
            let inside =
                self.surface.nodes.iter().filter(|node| (from * edge..=to * edge).contains(&place(&node.place)));
            let (force, area) = inside.fold((0.0, 0.0), |sum, n| (sum.0 + n.area * n.pressure, sum.1 + n.area));
            (area > 0.0).then(|| force / area)
        };
        let given = !self.case.figures.profile.is_empty();
        let values = vec![
            ("force", Some(self.force), "N/m"),
            ("pressure_center", at(0.0, 0.1), "Pa"),
            ("pressure_edge", Some(self.surface.peak()), "Pa"),
            ("profile_error", self.surface.distance(0.0, 0.95 * edge, true, |x| self.given(x)).filter(|_| given), ""),
        ];
        (values, self.profile("x, m", edge, Vec::new()))
    }
}

/// Peak and reach of p² = p0² (1 − r²/a²), by least squares weighed by area, where p > 0.3 of the largest.
fn fitted<const D: usize>(surface: &Surface<D>) -> Option<(f64, f64)> {
    let least = 0.3 * surface.peak();
    let points: Vec<(f64, f64)> =
        surface.points(f64::INFINITY).into_iter().filter(|(_, p)| *p > least).map(|(r, p)| (r * r, p * p)).collect();
    let (square, slope) = line(&points);
    (points.len() > 2 && slope < 0.0).then(|| (square.sqrt(), (-square / slope).sqrt()))
}

/// Value at 0 and slope of the line of least squares.
fn line(points: &[(f64, f64)]) -> (f64, f64) {
    let count = points.len() as f64;
    let (x, y) = points.iter().fold((0.0, 0.0), |sum, p| (sum.0 + p.0 / count, sum.1 + p.1 / count));
    let across: f64 = points.iter().map(|p| (p.0 - x) * (p.1 - y)).sum();
    let slope = across / points.iter().map(|p| (p.0 - x).powi(2)).sum::<f64>().max(f64::MIN_POSITIVE);
    (y - slope * x, slope)
}

/// Part of the last stage over which forces are compared: slides of 2 to 5.5 of 7.5.
const SLIDE: [f64; 2] = [2.0 / 7.5, 5.5 / 7.5];

/// Forces of the last stage. The ripple is what a cubic in the slide leaves of F_y, by its mean.
fn ironing<const D: usize>(at: &Equilibrium<D>, steps: &[LoadStep]) -> Values {
    let last = steps.iter().map(|step| step.stage).max().unwrap_or(0);
    let sliding = || steps.iter().filter(|step| step.stage == last);
    let points: Vec<(f64, f64)> = sliding()
        .filter(|step| (SLIDE[0] - 1e-9..=SLIDE[1] + 1e-9).contains(&step.load))
        .map(|step| (step.load, step.force[D - 1].abs()))
        .collect();
    let count = points.len() as f64;
    let mean = points.iter().map(|p| p.1).sum::<f64>() / count;
    let rest = cubic_rest(&points);
    let rms = rest.as_ref().map(|rest| (rest.iter().map(|r| r * r).sum::<f64>() / count).sqrt() / mean);
    let swing = rest.map(|rest| {
        let (low, high) = rest.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), r| (l.min(*r), h.max(*r)));
        (high - low) / mean
    });
    let middle = sliding().min_by(|p, q| (p.load - 0.5).abs().total_cmp(&(q.load - 0.5).abs()));
    vec![
        ("force_y_mean", Some(mean), "N/m"),
        ("ripple_rms", rms, ""),
        ("ripple_peak_to_peak", swing, ""),
        ("force_x_mid", middle.map(|step| step.force[0]), "N/m"),
        ("steps_failed", Some(at.halvings as f64), ""),
    ]
}

/// What a cubic of least squares leaves; `None` for fewer than five points.
fn cubic_rest(points: &[(f64, f64)]) -> Option<Vec<f64>> {
    if points.len() < 5 {
        return None;
    }
    let matrix =
        nalgebra::DMatrix::from_fn(points.len(), 4, |row, power| (2.0 * points[row].0 - 1.0).powi(power as i32));
    let right = nalgebra::DVector::from_fn(points.len(), |row, _| points[row].1);
    let fit = matrix.clone().svd(true, true).solve(&right, 1e-12).ok()?;
    Some((right - matrix * fit).iter().copied().collect())
}
