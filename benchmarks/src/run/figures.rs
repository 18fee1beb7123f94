//! Figures taken from a history.

use crate::case::{Case, FigureKind};
use anyhow::{Context, Result};
use fmc_solid::dynamics::Sample;
use fmc_solid::fem::Part;
use serde::Serialize;

/// A number that a case is judged by.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Figure {
    /// Its key.
    pub name: &'static str,
    /// Its value; `None` where there is none, as for the end of a contact that never was.
    pub value: Option<f64>,
    /// Its unit.
    pub unit: &'static str,
}

/// How the body that the figures are about moves, and what they need to know of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion<const D: usize> {
    /// Index of the body.
    pub body: usize,
    /// Its velocity at the start; of a body at rest 1 down, the direction in which most fall.
    pub velocity: [f64; D],
    /// Area of its bounding box across the direction in which it moves fastest (2D: width).
    pub cross_section: f64,
    /// ρ c |v| with c = √(E/ρ): the pressure at the end of a thin bar that is stopped.
    pub stopping_pressure: f64,
}

/// Time cut off at both ends of the contact before its pressure is taken, s: the front is spread over some cells.
const CUT: f64 = 0.03;

impl<const D: usize> Motion<D> {
    /// Motion of the body that the case names.
    ///
    /// # Errors
    /// If its velocity has not as many numbers as the case has dimensions.
    pub fn new(case: &Case, parts: &[Part<D>]) -> Result<Self> {
        let body = case.figured();
        let velocity = case.bodies[body].initial_velocity.as_deref().filter(|_| case.bodies[body].moves());
        let down = std::array::from_fn(|axis| if axis + 1 == D { -1.0 } else { 0.0 });
        let velocity: [f64; D] = velocity.map_or(Ok(down), |v| v.try_into()).context("its velocity has D numbers")?;
        let fastest = (0..D).max_by(|a, b| velocity[*a].abs().total_cmp(&velocity[*b].abs())).unwrap_or(0);
        let mut cross_section = 1.0;
        for axis in (0..D).filter(|axis| *axis != fastest) {
            let along = parts[body].mesh.coords.iter().map(|x| x[axis]);
            let (low, high) = along.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)));
            cross_section *= high - low;
        }
        let material = &case.bodies[body].material;
        let stopping_pressure = (material.young * material.density).sqrt() * norm(&velocity);
        Ok(Self { body, velocity, cross_section, stopping_pressure })
    }

    /// The figures of a kind, from the samples of all steps.
    ///
    /// | key | |
    /// | --- | --- |
    /// | `contact_start`, `contact_end` | first time with a contact force on the body, last time with more than 1 % of its
    /// largest (what follows are single touches); on a wall, with half of ρ c v |
    /// | `impulse` | ∫ force dt against the initial velocity; the trapezoidal rule is what the leapfrog scheme sums |
    /// | `rebound`, `exit_velocity` | velocity of its centre of mass at the end, against the initial one |
    /// | `sideways` | magnitude of the rest of that velocity |
    /// | `force_peak` | largest force against the initial velocity; with `forces` its largest magnitude |
    /// | `force_end`, `penetration_max` | magnitude of the force at the end, largest penetration |
    /// | `balance_max` | largest magnitude of ΣF over bodies and obstacles, by the largest force on the body |
    /// | `energy_drift`, `energy_error_max` | largest change of the total energy from the start, by the initial energy |
    /// | `way` | ∫ v dt of its centre of mass along the initial velocity |
    /// | `dissipated`, `dissipated_least` | energy taken out at the end, and in the step in which it was least, by the initial kinetic energy |
    /// | `pressure_mean` | mean of force / cross section, 30 ms cut at both ends of the contact |
    /// | `pressure_rms` | root mean square of its distance from ρ c v, by ρ c v, over the same time |
    pub fn figures(&self, kind: FigureKind, samples: &[Sample<D>]) -> Vec<Figure> {
        // The front of a wave is spread over some cells: where it is halfway up, it has arrived.
        let least = match kind {
            FigureKind::Wall => 0.5 * self.stopping_pressure * self.cross_section,
            _ => 0.0,
        };
        let of_any = kind == FigureKind::Forces;
        let figure =
            |&name: &&'static str| if of_any { self.size(name, samples) } else { self.figure(name, least, samples) };
        kind.keys().iter().map(figure).collect()
    }

    /// What any motion has.
    fn size(&self, name: &'static str, samples: &[Sample<D>]) -> Figure {
        let size = |sample: &Sample<D>| norm(&sample.bodies[self.body]);
        let unit = if D == 2 { "N/m" } else { "N" };
        let (value, unit) = match name {
            "force_peak" => (samples.iter().map(size).reduce(f64::max), unit),
            "force_end" => (samples.last().map(size), unit),
            _ => (samples.iter().map(|sample| sample.penetration).reduce(f64::max), "m"),
        };
        Figure { name, value, unit }
    }

    /// `least` is the force above which there is contact.
    fn figure(&self, name: &'static str, least: f64, samples: &[Sample<D>]) -> Figure {
        let size = |sample: &Sample<D>| norm(&sample.bodies[self.body]);
        let largest = samples.iter().map(size).fold(0.0, f64::max);
        let lasting = least.max(0.01 * largest);
        let first = samples.iter().find(|sample| size(sample) > least).map(|sample| sample.time);
        let last = samples.iter().rfind(|sample| size(sample) > lasting).map(|sample| sample.time);
        let end = samples.last().map(|sample| sample.velocities[self.body]);
        let force = |sample: &Sample<D>| self.against(&sample.bodies[self.body]);
        let pressures = || {
            let (from, to) = (first? + CUT, last? - CUT);
            let inside = samples.iter().filter(|sample| sample.time >= from && sample.time <= to);
            let pressures: Vec<f64> = inside.map(|sample| force(sample) / self.cross_section).collect();
            (!pressures.is_empty()).then_some(pressures)
        };
        let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
        let (value, unit) = match name {
            "contact_start" => (first, "s"),
            "way" => {
                let speed = |sample: &Sample<D>| -self.against(&sample.velocities[self.body]);
                let trapezoids =
                    samples.windows(2).map(|w| 0.5 * (speed(&w[0]) + speed(&w[1])) * (w[1].time - w[0].time));
                (Some(trapezoids.sum()), "m")
            }
            "dissipated" | "dissipated_least" => {
                let initial = samples.first().map_or(f64::NAN, |sample| sample.kinetic);
                let of_steps = samples.windows(2).map(|w| w[1].dissipated - w[0].dissipated);
                let value = match name {
                    "dissipated" => samples.last().map(|sample| sample.dissipated),
                    _ => of_steps.reduce(f64::min),
                };
                (value.map(|value| value / initial), "")
            }
            "contact_end" => (last, "s"),
            "impulse" => {
                let trapezoids =
                    samples.windows(2).map(|w| 0.5 * (force(&w[0]) + force(&w[1])) * (w[1].time - w[0].time));
                (Some(trapezoids.sum()), if D == 2 { "N s/m" } else { "N s" })
            }
            "rebound" | "exit_velocity" => (end.map(|velocity| self.against(&velocity)), "m/s"),
            "sideways" => (end.map(|velocity| self.across(&velocity)), "m/s"),
            "force_peak" => (samples.iter().map(force).reduce(f64::max), if D == 2 { "N/m" } else { "N" }),
            "balance_max" => {
                let worst = samples.iter().map(|sample| sample.balance).fold(0.0, f64::max);
                (Some(if worst == 0.0 { 0.0 } else { worst / largest }), "")
            }
            "energy_drift" | "energy_error_max" => {
                let energy = |sample: &Sample<D>| sample.total + sample.dissipated;
                let start = samples.first().map_or(0.0, energy);
                (samples.iter().map(|sample| (energy(sample) / start - 1.0).abs()).reduce(f64::max), "")
            }
            "pressure_mean" => (pressures().map(|pressures| mean(&pressures)), "Pa"),
            _ => {
                let off = |pressure: f64| (pressure / self.stopping_pressure - 1.0).powi(2);
                (pressures().map(|p| mean(&p.into_iter().map(off).collect::<Vec<_>>()).sqrt()), "")
            }
        };
        Figure { name, value, unit }
    }

    /// Force on the body over time where the case knows it in closed form: on a wall, ρ c v while they touch.
    pub(super) fn closed_form(&self, case: &Case) -> Option<Vec<(f64, f64)>> {
        let expected = |figure: &str| Some(case.expected.iter().find(|e| e.figure == figure)?.value);
        let (from, to) = (expected("contact_start")?, expected("contact_end")?);
        let fastest = self.velocity.iter().copied().max_by(|a, b| a.abs().total_cmp(&b.abs()))?;
        let force = -fastest.signum() * self.stopping_pressure * self.cross_section;
        let pulse = vec![(0.0, 0.0), (from, 0.0), (from, force), (to, force), (to, 0.0), (case.time.end, 0.0)];
        (case.figures.kind == FigureKind::Wall).then_some(pulse)
    }

    /// Component against the initial velocity.
    pub(super) fn against(&self, vector: &[f64; D]) -> f64 {
        -dot(vector, &self.velocity) / norm(&self.velocity)
    }

    /// Magnitude across the initial velocity.
    fn across(&self, vector: &[f64; D]) -> f64 {
        let along = dot(vector, &self.velocity) / dot(&self.velocity, &self.velocity);
        norm::<D>(&std::array::from_fn(|axis| vector[axis] - along * self.velocity[axis]))
    }
}

fn dot<const D: usize>(a: &[f64; D], b: &[f64; D]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn norm<const D: usize>(a: &[f64; D]) -> f64 {
    dot(a, a).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A body of mass 2 and width 0.5 that is stopped and thrown back by a constant force of 30 between t = 1 and t = 2.
    fn samples() -> Vec<Sample<2>> {
        (0..=300)
            .map(|step| {
                let time = f64::from(step) * 0.01;
                let force = if (100..=200).contains(&step) { 30.0 } else { 0.0 };
                let lost = ((time - 1.0).clamp(0.0, 1.0)) * 15.0;
                Sample {
                    step: step as u64,
                    time,
                    kinetic: 0.0,
                    strain: 0.0,
                    contact: 0.0,
                    external: 0.0,
                    total: 100.0 + if step == 150 { -3.0 } else { 0.0 },
                    dissipated: 0.0,
                    bodies: vec![[0.0, force]],
                    obstacles: vec![[0.0, -force + if step == 120 { 0.3 } else { 0.0 }]],
                    balance: if step == 120 { 0.3 } else { 0.0 },
                    velocities: vec![[0.25, lost - 5.0]],
                    overlap: 0.0,
                    penetration: 0.0,
                    contact_area: 0.0,
                    fibers: 0,
                    crossings: 0,
                    warnings: Vec::new(),
                    contact_seconds: 0.0,
                    seconds: 0.0,
                }
            })
            .collect()
    }

    #[test]
    fn figures_of_a_known_motion() {
        let motion = Motion { body: 0, velocity: [0.0, -5.0], cross_section: 0.5, stopping_pressure: 50.0 };
        let expected = [
            (FigureKind::Impact, "impulse", 30.3), // half a step more at both ends
            (FigureKind::Impact, "contact_start", 1.0),
            (FigureKind::Impact, "contact_end", 2.0),
            (FigureKind::Impact, "rebound", 10.0),
            (FigureKind::Impact, "sideways", 0.25),
            (FigureKind::Impact, "energy_drift", 0.03),
            (FigureKind::Impact, "force_peak", 30.0),
            (FigureKind::Impact, "balance_max", 0.01),
            (FigureKind::Forces, "force_peak", 30.0),
            (FigureKind::Forces, "force_end", 0.0),
            (FigureKind::Wall, "pressure_mean", 60.0),
            (FigureKind::Wall, "pressure_rms", 0.2),
            (FigureKind::Wall, "exit_velocity", 10.0),
            (FigureKind::Wall, "energy_error_max", 0.03),
        ];
        for (kind, name, value) in expected {
            let figures = motion.figures(kind, &samples());
            let found = figures.iter().find(|figure| figure.name == name).and_then(|figure| figure.value);
            assert!(found.is_some_and(|found| (found - value).abs() < 1e-12 * value.max(1.0)), "{name}: {found:?}");
        }
        // Before anything touches there is no contact to speak of.
        let figures = motion.figures(FigureKind::Wall, &samples()[..50]);
        assert!(figures.iter().filter(|figure| figure.value.is_none()).count() == 4);
    }
}
