//! Line contact against Hertz.

use super::{Figure, Profile, profile};
use crate::case::{Case, MeshSource};
use anyhow::{Result, bail, ensure};
use fmc_solid::statics::{Equilibrium, nodal_pressures};
use std::collections::BTreeMap;
use std::f64::consts::PI;

/// Pressure over the contact of a half-disc with a rigid plane, beside Hertz' p = p0 √(1 − x²/a²).
#[derive(Clone, Debug, PartialEq)]
pub struct HertzLine {
    /// Force per thickness that the contact carries.
    pub force: f64,
    /// a = √(4 F R / π E*) of that force.
    pub half_width: f64,
    /// p0 = 2 F / π a.
    pub peak_pressure: f64,
    /// Place across the contact and nodal pressure, ascending, as far as 1.3 a.
    pub profile: Vec<(f64, f64)>,
    /// Nodes of all bodies.
    pub nodes: usize,
}

/// Pressures above this part of the peak make the fit: at the rim a facet is partly in contact.
const FITTED: f64 = 0.3;

/// Within this many half widths the rim, where facets are partly in contact, is left out.
const INNER: f64 = 0.9;

/// The profile reaches to this many half widths.
const REACH: f64 = 1.3;

impl HertzLine {
    /// Contact of the body that the figures are about: a graded half-disc, linear elastic, on something rigid.
    ///
    /// # Errors
    /// If it is something else, or touches nothing.
    pub fn new<const D: usize>(case: &Case, at: &Equilibrium<D>) -> Result<Self> {
        let part = case.figured();
        let body = &case.bodies[part];
        let MeshSource::GradedHalfDisc { radius, .. } = body.mesh else { bail!("'{}' is no half-disc", body.name) };
        let modulus = body.material.young / (1.0 - body.material.poisson.powi(2));
        let force = at.balance().contact.bodies[part].force.iter().map(|f| f * f).sum::<f64>().sqrt();
        ensure!(force > 0.0, "'{}' touches nothing", body.name);
        let half_width = (4.0 * force * radius / (PI * modulus)).sqrt();
        let forces = &at.balance().contact.forces;
        let pressures: BTreeMap<usize, f64> =
            nodal_pressures(at.model(), part, forces).iter().map(|at| (at.node, at.pressure)).collect();
        let tip = body.position.as_ref().map_or([0.0; 2], |p| [p[0], p[1]]);
        let near = |x: &[f64; D]| (x[0] - tip[0]).abs() <= REACH * half_width && x[1] - tip[1] < 0.5 * radius;
        let mut nodes: Vec<u32> = at.model().faces_where(part, near).into_iter().flat_map(|face| face.nodes).collect();
        nodes.sort_unstable();
        nodes.dedup();
        let place = |node: u32| at.model().coords()[node as usize][0] - tip[0];
        let mut profile: Vec<(f64, f64)> =
            nodes.iter().map(|&n| (place(n), pressures.get(&(n as usize)).copied().unwrap_or(0.0))).collect();
        profile.sort_by(|p, q| p.0.total_cmp(&q.0));
        Ok(Self {
            force,
            half_width,
            peak_pressure: 2.0 * force / (PI * half_width),
            profile,
            nodes: at.model().node_count(),
        })
    }

    /// Hertz' pressure.
    pub fn closed_form(&self, x: f64) -> f64 {
        self.peak_pressure * (1.0 - (x / self.half_width).powi(2)).max(0.0).sqrt()
    }

    /// The pressures beside the closed form.
    pub(super) fn drawn(&self) -> Profile {
        let reach = self.profile.iter().map(|(x, _)| x.abs()).fold(0.0, f64::max);
        let curve = profile::drawn(-reach, reach, |x| self.closed_form(x));
        let (points, curves) = (self.profile.clone(), vec![("Hertz", curve)]);
        Profile { place: "place across the contact, m", points, curves, edge: None }
    }

    /// p0² and −p0²/a² by least squares of p² over x².
    fn fit(&self) -> Option<(f64, f64)> {
        let points: Vec<(f64, f64)> = (self.profile.iter())
            .filter(|(_, p)| *p > FITTED * self.peak_pressure)
            .map(|(x, p)| (x * x, p * p))
            .collect();
        let count = points.len() as f64;
        let (x, p) = points.iter().fold((0.0, 0.0), |sum, point| (sum.0 + point.0 / count, sum.1 + point.1 / count));
        let (across, along) = points.iter().fold((0.0, 0.0), |sum, point| {
            (sum.0 + (point.0 - x) * (point.1 - p), sum.1 + (point.0 - x) * (point.0 - x))
        });
        let slope = across / along;
        (slope < 0.0).then_some((p - slope * x, slope))
    }

    /// Distance of the profile as far as so many half widths from the closed form in L2, by the closed form's norm; trapezoidal rule
    /// over the nodes.
    fn profile_error(&self, reach: f64) -> f64 {
        let squares = |x: f64, p: f64| ((p - self.closed_form(x)).powi(2), self.closed_form(x).powi(2));
        let inside: Vec<(f64, f64)> =
            self.profile.iter().copied().filter(|(x, _)| x.abs() <= reach * self.half_width).collect();
        let sums = inside.windows(2).fold((0.0, 0.0), |sum, ends| {
            let [p, q] = [ends[0], ends[1]].map(|(x, p)| squares(x, p));
            let width = 0.5 * (ends[1].0 - ends[0].0);
            (sum.0 + width * (p.0 + q.0), sum.1 + width * (p.1 + q.1))
        });
        (sums.0 / sums.1).sqrt()
    }

    /// The figures.
    pub(super) fn figures(&self, penetration: f64) -> Vec<Figure> {
        let fit = self.fit();
        vec![
            Figure { name: "force", value: Some(self.force), unit: "N/m" },
            Figure { name: "half_width", value: fit.map(|(square, slope)| (-square / slope).sqrt()), unit: "m" },
            Figure { name: "peak_pressure", value: fit.map(|(square, _)| square.sqrt()), unit: "Pa" },
            Figure { name: "profile_error", value: Some(self.profile_error(REACH)), unit: "" },
            Figure { name: "profile_error_inner", value: Some(self.profile_error(INNER)), unit: "" },
            Figure { name: "penetration_max", value: Some(penetration), unit: "m" },
            Figure { name: "nodes", value: Some(self.nodes as f64), unit: "" },
        ]
    }
}
