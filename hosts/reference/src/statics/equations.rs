//! Which degrees of freedom have equations.

use super::rigid::Follower;
use std::collections::BTreeMap;

/// The equations of the degrees of freedom that are free, in their order. Those that are joined have one, which the first of them stands for: it
/// leads the others, and vectors of all degrees of freedom have nothing at these. Those that follow several have none: as an unknown each is the
/// constant by which it is apart from what it follows, which is prescribed.
pub(super) struct Equations {
    /// Equation of every degree of freedom, where it has one.
    of_freedom: Vec<Option<u32>>,
    /// Degree of freedom of every equation.
    freedoms: Vec<usize>,
    /// By degree of freedom, the one that leads it; empty where none is joined.
    leaders: Vec<usize>,
    /// Whether it leads others; empty where none is joined.
    leads: Vec<bool>,
    /// By degree of freedom, those that it follows, each with its weight.
    followed: BTreeMap<usize, Vec<(usize, f64)>>,
}

impl Equations {
    /// Of `count` degrees of freedom, some of which are held, others joined, and others that follow.
    pub(super) fn new(
        count: usize,
        held: impl Iterator<Item = usize>,
        joined: &[Vec<usize>],
        followers: &[Follower],
    ) -> Self {
        let is_none = joined.is_empty() && followers.is_empty();
        let mut leaders: Vec<usize> = if is_none { Vec::new() } else { (0..count).collect() };
        let mut leads = vec![false; leaders.len()];
        for list in joined.iter().filter(|list| list.len() > 1) {
            list.iter().for_each(|&freedom| leaders[freedom] = list[0]);
            leads[list[0]] = true;
        }
        let mut followed = BTreeMap::new();
        for follower in followers {
            let mut weights = BTreeMap::new();
            follower.of.iter().for_each(|&(freedom, weight)| *weights.entry(leaders[freedom]).or_insert(0.0) += weight);
            weights.keys().for_each(|&freedom| leads[freedom] = true);
            followed.insert(follower.freedom, weights.into_iter().collect());
        }
        let mut is_free = vec![true; count];
        followers.iter().for_each(|follower| is_free[follower.freedom] = false);
        held.for_each(|freedom| is_free[freedom] = false);
        let stands = |freedom: usize| leaders.get(freedom).is_none_or(|leader| *leader == freedom);
        let freedoms: Vec<usize> = (0..count).filter(|&freedom| is_free[freedom] && stands(freedom)).collect();
        let mut of_freedom = vec![None; count];
        freedoms.iter().enumerate().for_each(|(equation, &freedom)| of_freedom[freedom] = Some(equation as u32));
        (0..leaders.len()).for_each(|freedom| of_freedom[freedom] = of_freedom[leaders[freedom]]);
        Self { of_freedom, freedoms, leaders, leads, followed }
    }

    /// Whether any degrees of freedom are joined or follow others.
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

    /// What a degree of freedom follows, each with its weight.
    pub(super) fn followed(&self) -> &BTreeMap<usize, Vec<(usize, f64)>> {
        &self.followed
    }

    /// Unknowns that move a degree of freedom, with their weights.
    pub(super) fn terms(&self, freedom: usize) -> impl Iterator<Item = (usize, f64)> + Clone + '_ {
        let own = std::iter::once((self.leader(freedom), 1.0));
        own.chain(self.followed.get(&freedom).into_iter().flatten().copied())
    }

    /// What degrees of freedom that follow are moved by what they follow.
    pub(super) fn by_followed(&self, vector: &[f64]) -> Vec<(usize, f64)> {
        let sum = |weights: &Vec<(usize, f64)>| weights.iter().map(|&(freedom, weight)| weight * vector[freedom]).sum();
        self.followed.iter().map(|(&freedom, weights)| (freedom, sum(weights))).collect()
    }

    /// Forces, each at the degree of freedom that stands for its own.
    pub(super) fn led(&self, mut forces: Vec<f64>) -> Vec<f64> {
        for (freedom, &leader) in self.leaders.iter().enumerate().filter(|(freedom, leader)| freedom != *leader) {
            forces[leader] += std::mem::take(&mut forces[freedom]);
        }
        for (&freedom, weights) in &self.followed {
            let force = forces[freedom];
            weights.iter().for_each(|&(followed, weight)| forces[followed] += weight * force);
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

    /// Entries of a matrix by degrees of freedom, by unknowns.
    pub(super) fn by_unknowns(
        &self,
        entries: impl Iterator<Item = (usize, usize, f64)>,
    ) -> impl Iterator<Item = (usize, usize, f64)> {
        entries.flat_map(move |(row, column, value)| {
            self.terms(row).flat_map(move |(i, a)| self.terms(column).map(move |(j, b)| (i, j, a * b * value)))
        })
    }

    /// Entries of a matrix by unknowns, on the equations.
    pub(super) fn entries(
        &self,
        entries: impl Iterator<Item = (usize, usize, f64)>,
    ) -> impl Iterator<Item = (usize, usize, f64)> {
        entries.filter_map(|(row, column, value)| Some((self.of(row)?, self.of(column)?, value)))
    }
}
