//! The force against central differences of the energy of the same estimate.

use fmc_contact::Contact;

/// How a contact's forces are compared with its energies.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Differences<'a> {
    /// Steps, in the unit of the coordinates, the best of which counts: the estimate has a kink where a line passes from
    /// one facet to the next, which spoils a difference if it lies within the step.
    pub(crate) steps: &'a [f64],
    /// Of the largest force.
    pub(crate) tolerance: f64,
    /// Every so manyeth node that carries a force.
    pub(crate) loaded: usize,
    /// Every so manyeth node that carries none; 0 for none at all.
    pub(crate) others: usize,
}

impl Differences<'_> {
    /// Asserts that every force is minus the slope of the energy.
    pub(crate) fn check<const D: usize>(&self, contact: &Contact<D>, coords: &[[f64; D]]) {
        let at = contact.evaluate(coords).unwrap();
        let largest = at.forces.iter().flatten().fold(0.0, |m: f64, f| m.max(f.abs()));
        assert!(largest > 0.0, "nothing is met");
        let (loaded, others): (Vec<usize>, Vec<usize>) = (0..coords.len()).partition(|&n| at.forces[n] != [0.0; D]);
        let others = if self.others == 0 { &[] } else { others.as_slice() };
        for &node in loaded.iter().step_by(self.loaded).chain(others.iter().step_by(self.others.max(1))) {
            for axis in 0..D {
                let energy = |step: f64| {
                    let mut moved = coords.to_vec();
                    moved[node][axis] += step;
                    contact.evaluate(&moved).unwrap().energy
                };
                let slope = |h: f64| (energy(h) - energy(-h)) / (2.0 * h);
                let force = at.forces[node][axis];
                let slopes: Vec<f64> = self.steps.iter().map(|&h| slope(h)).collect();
                assert!(
                    slopes.iter().any(|slope| (force + slope).abs() < self.tolerance * largest),
                    "node {node}, axis {axis}: {force} against minus {slopes:?}, the largest being {largest}; {:?}",
                    contact.options()
                );
            }
        }
    }
}
