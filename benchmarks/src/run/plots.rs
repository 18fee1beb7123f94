//! Energies and contact forces over time, as in the paper's figures.

use crate::chart::{self, Axis, Mark, Panel, Series};
use anyhow::Result;
use fmc_solid::dynamics::Sample;
use std::path::Path;

/// Colours that colour-blind readers tell apart too (Okabe and Ito), the total in black.
const COLORS: [(u8, u8, u8); 5] = [(0, 114, 178), (213, 94, 0), (0, 158, 115), (204, 121, 167), (86, 180, 233)];
const TOTAL: (u8, u8, u8) = (30, 30, 30);

/// Points of one curve: more than there are pixels show nothing more, and make the SVG large.
const MOST_POINTS: usize = 2000;

/// Writes `energies` and `forces` into a folder, as PNG and SVG.
///
/// Forces are the components along the axis `direction`. `names` are those of bodies and obstacles. `closed_form` is the
/// force on the first body over time, where it is known.
pub(super) fn draw<const D: usize>(
    folder: &Path,
    title: &str,
    names: &[String],
    direction: usize,
    samples: &[Sample<D>],
    closed_form: Option<Vec<(f64, f64)>>,
) -> Result<()> {
    let shown = thinned(samples);
    let end = samples.last().map_or(0.0, |sample| sample.time);
    let time = Scale::of(end, "s");
    let per_thickness = if D == 2 { "/m" } else { "" };

    let largest = |of: &dyn Fn(&Sample<D>) -> f64| samples.iter().map(|sample| of(sample).abs()).fold(0.0, f64::max);
    let energy = Scale::of(largest(&|sample| sample.total).max(largest(&|sample| sample.kinetic)), "J");
    let curve = |name: &str, color, of: &dyn Fn(&Sample<D>) -> f64, unit: &Scale| {
        let points = shown.iter().map(|sample| (sample.time * time.factor, of(sample) * unit.factor)).collect();
        Series::line(name, color, points)
    };
    let mut series = vec![
        curve("kinetic", COLORS[0], &|sample| sample.kinetic, &energy),
        curve("strain", COLORS[1], &|sample| sample.strain, &energy),
        curve("contact", COLORS[2], &|sample| sample.contact, &energy),
    ];
    if samples.iter().any(|sample| sample.external != 0.0) {
        series.push(curve("external", COLORS[3], &|sample| sample.external, &energy));
    }
    if samples.iter().any(|sample| sample.dissipated != 0.0) {
        series.push(curve("dissipated", COLORS[4], &|sample| sample.dissipated, &energy));
    }
    series.push(curve("total", TOTAL, &|sample| sample.total + sample.dissipated, &energy));
    let (x, y) = (time.axis("time", ""), energy.axis("energy", per_thickness));
    chart::draw(folder, "energies", &format!("{title}: energies"), &[Panel { x, y, series }])?;

    let force =
        |index: usize| move |sample: &Sample<D>| forces(sample).nth(index).map_or(0.0, |force| force[direction]);
    let unit = (0..names.len()).map(|index| largest(&force(index))).fold(0.0, f64::max);
    let unit = Scale::of(unit, "N");
    let series = names.iter().enumerate().map(|(index, name)| {
        let label = format!("on {name}");
        curve(&label, COLORS[index % COLORS.len()], &force(index), &unit)
    });
    let mut series: Vec<Series> = series.collect();
    if let Some(points) = closed_form {
        let points = points.into_iter().map(|(t, force)| (t * time.factor, force * unit.factor)).collect();
        series.push(Series { mark: Mark::Dashes, ..Series::line("closed form", TOTAL, points) });
    }
    let component = ["x", "y", "z"][direction];
    let (x, y) = (time.axis("time", ""), unit.axis(&format!("contact force {component}"), per_thickness));
    chart::draw(folder, "forces", &format!("{title}: contact forces"), &[Panel { x, y, series }])
}

/// Resultants on bodies, then on obstacles.
fn forces<const D: usize>(sample: &Sample<D>) -> impl Iterator<Item = &[f64; D]> {
    sample.bodies.iter().chain(&sample.obstacles)
}

/// At most `MOST_POINTS` samples, the last one among them.
fn thinned<const D: usize>(samples: &[Sample<D>]) -> Vec<&Sample<D>> {
    let stride = samples.len().div_ceil(MOST_POINTS).max(1);
    let mut shown: Vec<&Sample<D>> = samples.iter().step_by(stride).collect();
    if let Some(last) = samples.last().filter(|last| shown.last().is_some_and(|shown| shown.step != last.step)) {
        shown.push(last);
    }
    shown
}

/// A unit with a prefix that makes the largest number easy to read.
struct Scale {
    factor: f64,
    unit: String,
}

impl Scale {
    fn of(largest: f64, unit: &str) -> Self {
        let prefixes = [(1e-9, "G"), (1e-6, "M"), (1e-3, "k"), (1.0, ""), (1e3, "m"), (1e6, "µ")];
        let found = prefixes.into_iter().find(|(factor, _)| largest * factor >= 0.1);
        let (factor, prefix) = found.filter(|_| largest > 0.0).unwrap_or((1.0, ""));
        Self { factor, unit: format!("{prefix}{unit}") }
    }

    fn axis(&self, quantity: &str, per: &str) -> Axis {
        Axis::linear(format!("{quantity}, {}{per}", self.unit))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_easy_to_read() {
        let read = |largest: f64, unit| Scale::of(largest, unit).unit;
        assert_eq!([read(7e-3, "s"), read(0.9, "s"), read(10_713.0, "J"), read(50.0, "J")], ["ms", "s", "kJ", "J"]);
        assert_eq!([read(0.0, "N"), read(3.7e5, "N")], ["N", "MN"]);
    }
}
