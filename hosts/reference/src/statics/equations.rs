//! Which degrees of freedom have equations.

/// The equations of the degrees of freedom that are free, in their order.
pub(super) struct Equations {
    /// Equation of every degree of freedom, where it has one.
    of_freedom: Vec<Option<u32>>,
    /// Degree of freedom of every equation.
    freedoms: Vec<usize>,
}

impl Equations {
    /// Of `count` degrees of freedom, some of which are held.
    pub(super) fn new(count: usize, held: impl Iterator<Item = usize>) -> Self {
        let mut is_free = vec![true; count];
        held.for_each(|freedom| is_free[freedom] = false);
        let freedoms: Vec<usize> = (0..count).filter(|freedom| is_free[*freedom]).collect();
        let mut of_freedom = vec![None; count];
        freedoms.iter().enumerate().for_each(|(equation, &freedom)| of_freedom[freedom] = Some(equation as u32));
        Self { of_freedom, freedoms }
    }

    /// How many there are.
    pub(super) fn count(&self) -> usize {
        self.freedoms.len()
    }

    /// Equation of a degree of freedom, where it has one.
    pub(super) fn of(&self, freedom: usize) -> Option<usize> {
        self.of_freedom.get(freedom).copied().flatten().map(|equation| equation as usize)
    }

    /// Degree of freedom of an equation.
    pub(super) fn freedom(&self, equation: usize) -> usize {
        self.freedoms[equation]
    }

    /// Degrees of freedom without an equation.
    pub(super) fn held(&self) -> Vec<usize> {
        (0..self.of_freedom.len()).filter(|freedom| self.of_freedom[*freedom].is_none()).collect()
    }

    /// Whether a degree of freedom has an equation, for all of them.
    pub(super) fn free(&self) -> Vec<bool> {
        self.of_freedom.iter().map(Option::is_some).collect()
    }

    /// Entries of a vector that have equations.
    pub(super) fn gathered(&self, vector: &[f64]) -> Vec<f64> {
        self.freedoms.iter().map(|&freedom| vector[freedom]).collect()
    }

    /// A vector of all degrees of freedom that is zero where there is no equation.
    pub(super) fn spread(&self, values: &[f64]) -> Vec<f64> {
        let mut vector = vec![0.0; self.of_freedom.len()];
        self.freedoms.iter().zip(values).for_each(|(&freedom, value)| vector[freedom] = *value);
        vector
    }

    /// Entries of a matrix by degrees of freedom, on the equations.
    pub(super) fn entries(
        &self,
        entries: impl Iterator<Item = (usize, usize, f64)>,
    ) -> impl Iterator<Item = (usize, usize, f64)> {
        entries.filter_map(|(row, column, value)| Some((self.of(row)?, self.of(column)?, value)))
    }
}
