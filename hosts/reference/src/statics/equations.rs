//! Which degrees of freedom have equations.

/// The equations of the degrees of freedom that are free, in their order. Those that are joined have one, which the first of them stands for: it
/// leads the others, and vectors of all degrees of freedom have nothing at these.
pub(super) struct Equations {
    /// Equation of every degree of freedom, where it has one.
    of_freedom: Vec<Option<u32>>,
    /// Degree of freedom of every equation.
    freedoms: Vec<usize>,
    /// By degree of freedom, the one that leads it; empty where none is joined.
    leaders: Vec<usize>,
    /// Whether it leads others; empty where none is joined.
    leads: Vec<bool>,
}

impl Equations {
    /// Of `count` degrees of freedom, some of which are held, and others joined.
    pub(super) fn new(count: usize, held: impl Iterator<Item = usize>, joined: &[Vec<usize>]) -> Self {
        let mut leaders: Vec<usize> = if joined.is_empty() { Vec::new() } else { (0..count).collect() };
        let mut leads = vec![false; leaders.len()];
        for list in joined.iter().filter(|list| list.len() > 1) {
            list.iter().for_each(|&freedom| leaders[freedom] = list[0]);
            leads[list[0]] = true;
        }
        let mut is_free = vec![true; count];
        held.for_each(|freedom| is_free[freedom] = false);
        let stands = |freedom: usize| leaders.get(freedom).is_none_or(|leader| *leader == freedom);
        let freedoms: Vec<usize> = (0..count).filter(|&freedom| is_free[freedom] && stands(freedom)).collect();
        let mut of_freedom = vec![None; count];
        freedoms.iter().enumerate().for_each(|(equation, &freedom)| of_freedom[freedom] = Some(equation as u32));
        (0..leaders.len()).for_each(|freedom| of_freedom[freedom] = of_freedom[leaders[freedom]]);
        Self { of_freedom, freedoms, leaders, leads }
    }

    /// Whether any degrees of freedom are joined.
    pub(super) fn has_joined(&self) -> bool {
        !self.leaders.is_empty()
    }

    /// The degree of freedom that stands for one.
    pub(super) fn leader(&self, freedom: usize) -> usize {
        self.leaders.get(freedom).copied().unwrap_or(freedom)
    }

    /// Whether a degree of freedom stands for others, too.
    pub(super) fn leads(&self, freedom: usize) -> bool {
        self.leads.get(freedom).is_some_and(|leads| *leads)
    }

    /// Forces, each at the degree of freedom that stands for its own.
    pub(super) fn led(&self, mut forces: Vec<f64>) -> Vec<f64> {
        for (freedom, &leader) in self.leaders.iter().enumerate().filter(|(freedom, leader)| freedom != *leader) {
            forces[leader] += std::mem::take(&mut forces[freedom]);
        }
        forces
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

    /// Whether a degree of freedom stands for an equation, for all of them.
    pub(super) fn free(&self) -> Vec<bool> {
        (0..self.of_freedom.len()).map(|f| self.of_freedom[f].is_some() && self.leader(f) == f).collect()
    }

    /// Entries of a vector that have equations.
    pub(super) fn gathered(&self, vector: &[f64]) -> Vec<f64> {
        self.freedoms.iter().map(|&freedom| vector[freedom]).collect()
    }

    /// A vector of all degrees of freedom that is zero where none stands for an equation.
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
