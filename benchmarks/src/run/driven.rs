//! Figures of a body that its supports drive along a line, and may drive back.

use super::Figure;
use super::way::LoadStep;
use crate::case::Case;
use crate::chart::{Axis, Mark, Panel, Series};
use anyhow::{Context, Result};
use fmc_solid::statics::Equilibrium;

/// The displacement that is prescribed at the ends of the stages, and the force that it works against.
pub(super) struct Drive {
    axis: usize,
    /// Along the axis, positive in the direction of the first stage; one more than stages, from 0.
    ends: Vec<f64>,
    /// +1 or −1: that direction.
    sign: f64,
}

impl Drive {
    /// By the support of the figures' body that moves farthest in the first stage.
    ///
    /// # Errors
    /// If none moves.
    pub(super) fn of(case: &Case) -> Result<Self> {
        let (support, component, value) = case.driver().context("no support moves the body in the first stage")?;
        let sign = value.signum();
        let stages = case.load_steps.as_ref().map_or(0, |steps| steps.then.len());
        let later = (0..stages).map(|stage| support.then.get(stage).map_or(value, |values| values[component]));
        let ends = [0.0, value].into_iter().chain(later).map(|end| sign * end).collect();
        Ok(Self { axis: support.components[component].index(), ends, sign })
    }

    /// Displacement and resistance of contact to it, from the start; both positive in the first stage.
    fn curve(&self, steps: &[LoadStep]) -> Vec<(f64, f64)> {
        let at = |step: &LoadStep| {
            let [from, to] = [0, 1].map(|end| self.ends[step.stage + end]);
            (from + step.load * (to - from), -self.sign * step.force[self.axis])
        };
        std::iter::once((0.0, 0.0)).chain(steps.iter().map(at)).collect()
    }

    /// | key | |
    /// | --- | --- |
    /// | `force_peak`, `force_least` | largest and least resistance to the motion of the first stage; negative where contact pulls |
    /// | `work_peak` | largest work of the driven support, by the trapezoidal rule over the load steps |
    /// | `work_error` | work at the end beyond the energy stored in bodies and contact, by `work_peak`: energy that snapping loses, and the error of the rule |
    /// | `loop_error` | work at the end of a path that leads back to its start, by `work_peak` |
    /// | `steps_failed` | load steps that were halved |
    /// | `penetration_max` | largest over the load steps |
    pub(super) fn figures<const D: usize>(&self, case: &Case, at: &Equilibrium<D>, steps: &[LoadStep]) -> Vec<Figure> {
        let curve = self.curve(steps);
        let forces = || curve.iter().map(|point| point.1);
        let work = work(&curve);
        let (end, peak) = (work.last().copied().unwrap_or(0.0), work.iter().copied().fold(0.0, f64::max));
        let stored = case.figures.copies as f64 * at.balance().energy();
        let is_closed = self.ends.last() == Some(&0.0);
        let (force, energy) = if D == 2 { ("N/m", "J/m") } else { ("N", "J") };
        let figure = |&name: &&'static str| {
            let (value, unit) = match name {
                "force_peak" => (forces().reduce(f64::max), force),
                "force_least" => (forces().reduce(f64::min), force),
                "work_peak" => (Some(peak), energy),
                "work_error" => (Some((end - stored).abs() / peak), ""),
                "loop_error" => (is_closed.then_some(end.abs() / peak), ""),
                "steps_failed" => (Some(at.halvings as f64), ""),
                _ => (Some(steps.iter().map(|step| step.penetration).fold(0.0, f64::max)), "m"),
            };
            Figure { name, value, unit }
        };
        case.figures.kind.keys().iter().map(figure).collect()
    }

    /// Force over displacement, a curve for each stage.
    pub(super) fn panel<const D: usize>(&self, steps: &[LoadStep]) -> Panel {
        const COLORS: [(u8, u8, u8); 2] = [(0, 114, 178), (213, 94, 0)];
        let curve = self.curve(steps);
        let series = (0..self.ends.len() - 1).map(|stage| {
            let begin = steps.iter().position(|step| step.stage == stage).unwrap_or(steps.len());
            let count = steps.iter().filter(|step| step.stage == stage).count();
            let points = curve[begin..=(begin + count)].to_vec();
            let name = if self.ends[stage + 1] > self.ends[stage] { "forward" } else { "back" };
            // The way back lies on the way forward, if nothing is lost: points over a line show both.
            let mark = if stage == 0 { Mark::Line } else { Mark::Points };
            Series { mark, ..Series::line(name, COLORS[stage % 2], points) }
        });
        Panel {
            x: Axis::linear("displacement of the support, m".to_owned()),
            y: Axis::linear(format!("force against it, {}", if D == 2 { "N/m" } else { "N" })),
            series: series.collect(),
        }
    }
}

/// ∫ F du up to every point of a curve, by the trapezoidal rule.
fn work(curve: &[(f64, f64)]) -> Vec<f64> {
    let mut sum = 0.0;
    let mut add = |pair: &[(f64, f64)]| {
        sum += 0.5 * (pair[0].1 + pair[1].1) * (pair[1].0 - pair[0].0);
        sum
    };
    curve.windows(2).map(&mut add).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::case::Document;

    fn step(stage: usize, load: f64, force: f64) -> LoadStep {
        let force = vec![force, 7.0];
        LoadStep {
            stage,
            load,
            iterations: 0,
            force,
            contact_area: 0.0,
            penetration: 0.0,
            dissipated: 0.0,
            stick: [0.0; 2],
        }
    }

    /// A spring of stiffness 3 that is pressed by 2 and let go again, to half the way at half the load.
    #[test]
    fn a_spring_gives_its_work_back() {
        let drive = Drive { axis: 0, ends: vec![0.0, 2.0, 0.0], sign: 1.0 };
        let steps = [step(0, 0.5, -3.0), step(0, 1.0, -6.0), step(1, 0.25, -4.5), step(1, 1.0, 0.0)];
        assert_eq!(drive.curve(&steps), [(0.0, 0.0), (1.0, 3.0), (2.0, 6.0), (1.5, 4.5), (0.0, 0.0)]);
        assert_eq!(work(&drive.curve(&steps)), [1.5, 6.0, 3.375, 0.0]);
        let panel = drive.panel::<2>(&steps);
        assert_eq!(panel.series.iter().map(|series| series.points.len()).collect::<Vec<_>>(), [3, 3]);
        // Driven down, a force upwards resists.
        let down = Drive { sign: -1.0, ..drive };
        assert_eq!(down.curve(&[step(0, 1.0, 6.0)])[1], (2.0, 6.0));
    }

    #[test]
    fn the_farthest_support_drives() {
        let mut document = Document::open("ironing").unwrap();
        let drive = |document: &Document| Drive::of(&document.case().unwrap());
        let found = drive(&document).unwrap();
        assert_eq!((found.axis, found.sign, &found.ends[..]), (1, -1.0, &[0.0, 1.3, 1.3][..]));
        document.override_with("test", "supports.1.values=[0.0, 0.0]").unwrap();
        assert!(drive(&document).is_err());
    }
}
