//! `*AMPLITUDE`: a factor over time.

use super::words::{numbers, one_of, only};
use crate::Fault;
use fmc_mesh_io::inp::{Keyword, Lines};

/// A factor that is linear between points in time, and constant outside of them.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Amplitude {
    /// Time and factor, ascending.
    points: Vec<[f64; 2]>,
    /// Time since the first step began, and not since this one did.
    pub(crate) is_total: bool,
}

impl Amplitude {
    /// Reads it.
    pub(super) fn read(keyword: &Keyword, lines: &mut Lines) -> Result<Self, Fault> {
        only(keyword, &["NAME", "TIME", "DEFINITION", "VALUE"])?;
        one_of(keyword, "TIME", &["STEP TIME", "TOTAL TIME", "TOTALTIME"])?;
        one_of(keyword, "DEFINITION", &["TABULAR"])?;
        one_of(keyword, "VALUE", &["RELATIVE"])?;
        let mut all = Vec::new();
        while let Some((line, text)) = lines.data() {
            for (place, value) in (1..).zip(numbers(line, text)?) {
                all.push(
                    value.ok_or_else(|| Fault::new(line, format!("a time or a factor is missing in field {place}")))?,
                );
            }
        }
        let (points, rest) = all.as_chunks::<2>();
        if points.is_empty() || !rest.is_empty() {
            return Err(Fault::new(keyword.line, "*AMPLITUDE needs pairs of a time and a factor"));
        }
        if !points.is_sorted_by(|a, b| a[0] < b[0]) {
            return Err(Fault::new(keyword.line, "the times of *AMPLITUDE do not ascend"));
        }
        let is_total = keyword.value("TIME").is_some_and(|time| time.to_uppercase().starts_with("TOTAL"));
        Ok(Self { points: points.to_vec(), is_total })
    }

    /// The factor at a time.
    pub(crate) fn at(&self, time: f64) -> f64 {
        let after = self.points.partition_point(|point| point[0] <= time);
        match (after.checked_sub(1).map(|k| self.points[k]), self.points.get(after)) {
            (Some([t, a]), Some([u, b])) => a + (b - a) * (time - t) / (u - t),
            (Some([_, a]), None) => a,
            (None, _) => self.points[0][1],
        }
    }

    /// The time between two at which it is farther from 0 than at the later one, if there is any, and its factor there.
    pub(crate) fn peak(&self, from: f64, to: f64) -> Option<[f64; 2]> {
        let inside = self.points.iter().filter(|point| point[0] > from && point[0] < to);
        let peak = inside.copied().max_by(|a, b| a[1].abs().total_cmp(&b[1].abs()))?;
        // Rounding of the factor at the end is no peak.
        (peak[1].abs() > self.at(to).abs() * (1.0 + 1e-9)).then_some(peak)
    }

    /// Times at which it bends.
    pub(crate) fn times(&self) -> impl Iterator<Item = f64> + '_ {
        self.points.iter().map(|point| point[0])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn factors_are_linear_between_points_and_constant_outside() {
        let text = "*AMPLITUDE, NAME=A\n0.5, 0., 1., 2., 2., -1.\n";
        let mut lines = Lines::new(text);
        let keyword = lines.keyword().unwrap();
        let amplitude = Amplitude::read(&keyword, &mut lines).unwrap();
        let found: Vec<f64> = [0.0, 0.5, 0.75, 1.0, 1.5, 2.0, 9.0].map(|t| amplitude.at(t)).to_vec();
        assert_eq!(found, [0.0, 0.0, 1.0, 2.0, 0.5, -1.0, -1.0]);
    }
}
