//! How well a contact conducts.

use crate::Error;

/// Conductance h of a contact: flux by area and jump of the field, for heat W/(m² K). Tables are linear between their entries.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Conductance {
    /// Pressures, ascending, from 0 on, and h there: where surfaces touch. Before the first and beyond the last entry h stays as it is there;
    /// one entry is a constant. Without entries nothing flows where surfaces touch.
    pub by_pressure: Vec<[f64; 2]>,
    /// Gaps, ascending, from 0 on, and h there: where surfaces are apart. Before the first h stays as it is there, beyond the last, which is the
    /// reach, nothing flows. Without entries nothing flows across gaps.
    pub by_gap: Vec<[f64; 2]>,
}

impl Conductance {
    /// The same wherever surfaces touch, and none across gaps.
    pub fn constant(h: f64) -> Self {
        Self { by_pressure: vec![[0.0, h]], by_gap: Vec::new() }
    }

    /// # Errors
    /// [`Error::BadEntry`] for an entry that is negative or not finite, or a place that does not ascend.
    pub(crate) fn check(&self) -> Result<(), Error> {
        check_table(&self.by_pressure, ["pressures", "by_pressure"])?;
        check_table(&self.by_gap, ["gaps", "by_gap"])
    }

    /// Where surfaces touch with this pressure.
    pub(crate) fn pressed(&self, pressure: f64) -> f64 {
        interpolated(&self.by_pressure, pressure)
    }

    /// Where they are so far apart.
    pub(crate) fn apart(&self, gap: f64) -> f64 {
        if gap > self.reach() { 0.0 } else { interpolated(&self.by_gap, gap) }
    }

    /// The largest gap across which anything flows.
    pub(crate) fn reach(&self) -> f64 {
        self.by_gap.last().map_or(0.0, |[gap, _]| *gap)
    }
}

fn check_table(table: &[[f64; 2]], names: [&'static str; 2]) -> Result<(), Error> {
    let mut before = None;
    for (entry, row) in table.iter().enumerate() {
        for (array, value) in names.into_iter().zip(*row) {
            if !(value.is_finite() && value >= 0.0) {
                return Err(Error::BadEntry { array, entry, value });
            }
        }
        if before.is_some_and(|before| row[0] <= before) {
            return Err(Error::BadEntry { array: names[0], entry, value: row[0] });
        }
        before = Some(row[0]);
    }
    Ok(())
}

/// Of a table, 0 without entries.
fn interpolated(table: &[[f64; 2]], at: f64) -> f64 {
    let next = table.partition_point(|[place, _]| *place <= at);
    match (next.checked_sub(1).and_then(|last| table.get(last)), table.get(next)) {
        (Some([x, h]), Some([y, g])) => h + (g - h) * ((at - x) / (y - x)),
        (Some([_, h]), None) | (None, Some([_, h])) => *h,
        (None, None) => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn is_linear_between_entries_and_constant_beyond() {
        let h =
            Conductance { by_pressure: vec![[1.0, 2.0], [3.0, 6.0], [4.0, 0.0]], by_gap: vec![[0.0, 4.0], [0.5, 1.0]] };
        h.check().expect("tables");
        for (pressure, expected) in [(0.0, 2.0), (1.0, 2.0), (2.0, 4.0), (3.0, 6.0), (3.5, 3.0), (9.0, 0.0)] {
            assert_eq!(h.pressed(pressure), expected, "{pressure}");
        }
        for (gap, expected) in [(0.0, 4.0), (0.25, 2.5), (0.5, 1.0), (0.500_001, 0.0)] {
            assert_eq!(h.apart(gap), expected, "{gap}");
        }
        assert_eq!((Conductance::default().pressed(1.0), Conductance::default().apart(0.0)), (0.0, 0.0));
        assert_eq!((Conductance::constant(3.0).pressed(7.0), Conductance::constant(3.0).apart(0.0)), (3.0, 0.0));
    }
}
