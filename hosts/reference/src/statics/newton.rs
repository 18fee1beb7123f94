//! Newton's method.

use super::balance::Balance;
use super::equilibrium::Equilibrium;
use super::error::StaticsError;
use super::iteration::{Iteration, Tangent};
use super::newton_settings::NewtonSettings;
use super::penetration::Updates;
use fmc_contact::contact::equilibrium::descent::TangentChoice;
use fmc_contact::{EnergyLaw, EnergyProfile, PenetrationLaw};
use std::ops::ControlFlow;

/// What a solver is watched by; it may break off.
pub(super) type Watch<'a> = &'a mut dyn FnMut(&Iteration) -> ControlFlow<()>;

/// A displacement and its balance.
pub(super) type State<const D: usize> = (Vec<[f64; D]>, Balance<D>);

impl<const D: usize> Equilibrium<D> {
    /// Equilibrium from a displacement; nothing is accepted, and no step committed.
    pub(super) fn newton(&mut self, start: Vec<[f64; D]>, load: f64, watch: Watch) -> Result<State<D>, StaticsError> {
        if self.has_friction() { self.with_friction(start, load, watch) } else { self.least_energy(start, load, watch) }
    }

    /// Newton's method for forces that are those of one energy.
    pub(super) fn least_energy(
        &mut self,
        start: Vec<[f64; D]>,
        load: f64,
        watch: Watch,
    ) -> Result<State<D>, StaticsError> {
        let NewtonSettings { tolerance, most_iterations, full_below, .. } = self.settings;
        self.keep_patches(&start)?;
        let (mut u, mut balance) = (start.clone(), self.evaluate(&start, load)?);
        let mut kept = Extent::of(&balance);
        let has_patches = self.problem.contact.law.is_fiber();
        let (mut choice, mut turned, mut updates) = (TangentChoice::default(), false, Updates::default());
        for iteration in 0..=most_iterations {
            let mut residual = balance.relative();
            // The lines run along the contact normal of the start. Once the solution is near, they turn into that of
            // now.
            if has_patches && residual <= full_below && !turned && tolerance < full_below {
                self.keep_patches(&u)?;
                balance = self.evaluate(&u, load)?;
                (kept, residual, turned) = (Extent::of(&balance), balance.relative(), true);
            }
            // Far from the solution the patches may follow the contact, which has just begun or has spread.
            if has_patches && residual > full_below && kept.is_outgrown_by(&balance) {
                self.keep_patches(&u)?;
                balance = self.evaluate(&u, load)?;
                kept = Extent::of(&balance);
            }
            if self.moves_out(&u, residual, &mut updates, load)? {
                balance = self.evaluate(&u, load)?;
                residual = balance.relative();
            }
            let mut told = Iteration::at(&balance, load, iteration);
            if residual <= tolerance {
                return self.tell(&told, watch).map(|()| (u, balance));
            }
            if iteration == most_iterations {
                break;
            }
            let (direction, tangent) = match self.contact_step(&u, &balance)? {
                Some(step) => {
                    self.iterations += 1;
                    told.contact_iterations = step.iterations;
                    (step.direction, Tangent::Contact)
                }
                None => self.direction(&u, &balance, load, choice.wish(residual, full_below, 1.0).into())?,
            };
            let (next, reached, length) = match self.line_search(&u, &balance, &direction, load) {
                Err(StaticsError::LineSearch { .. }) if residual <= 1e3 * tolerance => return Ok((u, balance)),
                searched => searched?,
            };
            (told.tangent, told.length) = (Some(tangent), length);
            self.tell(&told, watch)?;
            choice.made(tangent.part(), &balance.descent(), Some(&reached.descent()));
            (u, balance) = (next, reached);
        }
        Err(self.not_converged(&balance, load, most_iterations))
    }

    /// Reports to `watch`.
    pub(super) fn tell(&self, iteration: &Iteration, watch: Watch) -> Result<(), StaticsError> {
        if watch(iteration).is_break() { Err(StaticsError::Interrupted) } else { Ok(()) }
    }

    /// The likeliest reason.
    fn not_converged(&self, balance: &Balance<D>, load: f64, iterations: usize) -> StaticsError {
        let residual = balance.relative();
        self.too_soft(balance).unwrap_or(StaticsError::NotConverged { load, iterations, residual })
    }

    /// With the linear law, whether bodies pass through one another: the pressure is then that of the law far from
    /// zero.
    pub(super) fn too_soft(&self, balance: &Balance<D>) -> Option<StaticsError> {
        let penetration = balance.contact.penetration;
        match self.problem.contact.law {
            // k L/√(L² + ε²) is k to 0.5 % at L = 10 ε: what resists more is elastic, or nothing.
            EnergyLaw::Fiber(PenetrationLaw { stiffness: k, profile: EnergyProfile::Linear { smoothing_length } })
                if penetration > 10.0 * smoothing_length =>
            {
                Some(StaticsError::PeakPressureAboveStiffness { stiffness: k, penetration, smoothing_length })
            }
            _ => None,
        }
    }

    /// Step towards a balance, and the matrix that gave it: the one wished for, or the semidefinite one.
    pub(super) fn direction(
        &mut self,
        u: &[[f64; D]],
        balance: &Balance<D>,
        load: f64,
        wish: Tangent,
    ) -> Result<(Vec<[f64; D]>, Tangent), StaticsError> {
        let right: Vec<f64> = self.on_equations(&balance.residual).iter().map(|r| -r).collect();
        for tangent in [wish, Tangent::Semidefinite] {
            if self.factorise(u, tangent)?
                && let Some(step) = self.system.solve(&right)
            {
                self.iterations += 1;
                let direction = self.on_nodes(&step);
                let longest = direction.iter().flatten().fold(0.0, |most: f64, d| most.max(d.abs()));
                // A singular matrix may slip through the factorisation; its solutions do not.
                if longest.is_finite() && longest < 1e3 * self.size() && balance.slope(&direction) < 0.0 {
                    return Ok((direction, tangent));
                }
            }
        }
        Err(self.unsupported(u)?.unwrap_or(StaticsError::Unstable { load }))
    }

    /// Components of a nodal vector that have equations.
    pub(super) fn on_equations(&self, vector: &[[f64; D]]) -> Vec<f64> {
        let mut values = vec![0.0; self.equation_count];
        for (&equation, value) in self.equations.iter().zip(vector.iter().flatten()) {
            if equation != u32::MAX {
                values[equation as usize] = *value;
            }
        }
        values
    }

    /// A nodal vector that is zero on what is held.
    pub(super) fn on_nodes(&self, values: &[f64]) -> Vec<[f64; D]> {
        let at = |freedom: usize| match self.equations[freedom] {
            u32::MAX => 0.0,
            equation => values[equation as usize],
        };
        (0..self.equations.len() / D).map(|node| std::array::from_fn(|axis| at(node * D + axis))).collect()
    }
}

/// Pairs in contact and the area of their contact.
struct Extent {
    pairs: Vec<[fmc_contact::overlap::Partner; 2]>,
    area: f64,
}

impl Extent {
    fn of<const D: usize>(balance: &Balance<D>) -> Self {
        let contact = &balance.contact;
        Self { pairs: contact.pairs.iter().map(|pair| [pair.a, pair.b]).collect(), area: contact.contact_area }
    }

    /// Whether there is a new pair, or the area has changed by more than half.
    fn is_outgrown_by<const D: usize>(&self, balance: &Balance<D>) -> bool {
        let now = Self::of(balance);
        now.pairs.iter().any(|pair| !self.pairs.contains(pair))
            || !(0.5 * self.area..=2.0 * self.area).contains(&now.area)
    }
}
