//! The equations that are kept for the contact.

use fmc_contact::sparse::Entries;

/// Part of the largest entry of the contact's stiffness below which another one is rounding.
const ROUNDING: f64 = 1e-14;

/// Where every equation is among those that are kept.
#[derive(Default)]
pub(super) struct Kept {
    /// Equations, in their order.
    equations: Vec<usize>,
    /// Place of every equation in it; `u32::MAX` for those that are not kept.
    places: Vec<u32>,
}

impl Kept {
    pub(super) fn new(equations: Vec<usize>, count: usize) -> Self {
        let mut places = vec![u32::MAX; count];
        equations.iter().enumerate().for_each(|(place, &equation)| places[equation] = place as u32);
        Self { equations, places }
    }

    pub(super) fn equations(&self) -> &[usize] {
        &self.equations
    }

    /// Place of an equation.
    pub(super) fn place(&self, equation: usize) -> Option<usize> {
        self.places.get(equation).copied().filter(|place| *place != u32::MAX).map(|place| place as usize)
    }

    /// Entries by the places of their equations, without those that are rounding; `None` if one of the others is not kept.
    pub(super) fn placed(&self, entries: &Entries) -> Option<Entries> {
        let least = rounding(entries);
        let entries = entries.iter().filter(|(.., value)| value.abs() > least);
        entries.map(|&(row, column, value)| Some((self.place(row)?, self.place(column)?, value))).collect()
    }

    /// Components of a vector on the equations.
    pub(super) fn of(&self, values: &[f64]) -> Vec<f64> {
        self.equations.iter().map(|&equation| values[equation]).collect()
    }
}

/// Largest of some entries' values that counts for none.
pub(super) fn rounding(entries: &Entries) -> f64 {
    ROUNDING * entries.iter().fold(0.0, |most: f64, (.., value)| most.max(value.abs()))
}
