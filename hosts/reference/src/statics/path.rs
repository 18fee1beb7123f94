//! Load steps.

use super::balance::Balance;
use super::equilibrium::Equilibrium;
use super::error::StaticsError;
use super::iteration::{Iteration, Tangent};
use super::newton::{State, Watch};

/// How the load is brought on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Path {
    /// Load steps that are tried first, of equal size.
    pub steps: usize,
    /// Times that a step which fails is halved.
    pub most_halvings: u32,
}

impl Default for Path {
    fn default() -> Self {
        Self { steps: 1, most_halvings: 8 }
    }
}

/// A step that needs no more iterations than these lets the next one be twice as long, up to the first ones' length.
const EASY: usize = 12;

impl<const D: usize> Equilibrium<D> {
    /// Goes to the full load: prescribed displacements and forces grow together. A step that fails is halved; what
    /// follows grows again. `watch` is called after every iteration and may stop the solver.
    ///
    /// # Errors
    /// Those of [`StaticsError`]; the last equilibrium is kept.
    pub fn follow(&mut self, path: Path, watch: Watch) -> Result<(), StaticsError> {
        self.follow_telling(path, watch, &mut |_| ())
    }

    /// The same; `reached` is called after every equilibrium on the way.
    ///
    /// # Errors
    /// Those of [`StaticsError`]; the last equilibrium is kept.
    pub fn follow_telling(
        &mut self,
        path: Path,
        watch: Watch,
        reached: &mut dyn FnMut(&Self),
    ) -> Result<(), StaticsError> {
        let longest = 1.0 / path.steps.max(1) as f64;
        let mut step = longest;
        while self.load < 1.0 {
            let load = if self.load + step > 1.0 - 1e-9 { 1.0 } else { self.load + step };
            let (before, multipliers) = (self.iterations, self.contact.multipliers());
            match self.advance(load, watch) {
                Ok((u, balance)) => {
                    self.accept(u, balance, load);
                    if load == 1.0 {
                        self.turn_patches(watch)?;
                    }
                    self.commit_step()?;
                    reached(self);
                    if self.iterations - before <= EASY {
                        step = longest.min(2.0 * step);
                    }
                }
                Err(error)
                    if error.may_yield_to_halving() && step > longest * 0.5f64.powi(path.most_halvings as i32) =>
                {
                    step *= 0.5;
                    self.halvings += 1;
                    self.contact.set_multipliers(&multipliers)?;
                }
                Err(error) => return Err(error),
            }
        }
        self.too_soft(&self.balance).map_or(Ok(()), Err)
    }

    /// Equilibrium at a load, from the last one.
    fn advance(&mut self, load: f64, watch: Watch) -> Result<State<D>, StaticsError> {
        let start = self.predicted(load, watch)?;
        self.led_from(start, load, watch)
    }

    /// As far beyond the last equilibrium as it is beyond the one before; right where the contact grows steadily.
    fn ahead(&self, load: f64) -> Option<Vec<[f64; D]>> {
        let (before, at) = self.before.as_ref()?;
        let part = (load - self.load) / (self.load - at);
        let mut ahead: Vec<[f64; D]> = (self.displacement.iter().zip(before))
            .map(|(u, v)| std::array::from_fn(|i| u[i] + part * (u[i] - v[i])))
            .collect();
        self.prescribe(&mut ahead, load);
        Some(ahead)
    }

    /// Bodies in balance that nothing touches, carried along by supports that move each of them as a whole.
    fn carried(&self, u: &[[f64; D]], moved: &[[f64; D]], balance: &Balance<D>) -> Option<Vec<[f64; D]>> {
        if balance.contact.facet_count > 0 || balance.relative() > self.settings.tolerance {
            return None;
        }
        let mut carried = u.to_vec();
        for part in 0..self.problem.model.parts().len() {
            let nodes = self.problem.model.nodes_of(part);
            let mut by = [None; D];
            for (node, axis, _) in self.problem.supports.iter().filter(|(node, ..)| nodes.contains(node)) {
                let change = moved[node][axis] - u[node][axis];
                if *by[axis].get_or_insert(change) != change {
                    return None;
                }
            }
            carried[nodes].iter_mut().for_each(|u| (0..D).for_each(|i| u[i] += by[i].unwrap_or(0.0)));
        }
        Some(carried)
    }

    /// The last equilibrium with what is prescribed moved on, and the bodies following as their tangent says: else the
    /// cells at the supports alone would take all of the change.
    fn predicted(&mut self, load: f64, watch: Watch) -> Result<Vec<[f64; D]>, StaticsError> {
        let u = self.displacement.clone();
        let mut moved = u.clone();
        self.prescribe(&mut moved, load);
        if moved == u {
            return Ok(u);
        }
        if let Some(ahead) = self.ahead(load)
            && !self.is_too_deep(&ahead)
        {
            return Ok(ahead);
        }
        self.keep_patches(&u)?;
        let balance = self.evaluate(&u, load)?;
        if let Some(carried) = self.carried(&u, &moved, &balance) {
            return Ok(carried);
        }
        // Forces that the change of the supports calls up, to first order.
        let change: Vec<f64> = moved.iter().flatten().zip(u.iter().flatten()).map(|(moved, u)| moved - u).collect();
        let pull = self.problem.model.tangent(&u).product(&change);
        let residual = self.on_equations(&balance.residual);
        let pull: Vec<[f64; D]> = pull.chunks_exact(D).map(|p| std::array::from_fn(|i| p[i])).collect();
        let right: Vec<f64> = residual.iter().zip(self.on_equations(&pull)).map(|(r, p)| -r - p).collect();
        let Some(step) = self.semidefinite_step(&u, &right)? else { return Ok(moved) };
        self.iterations += 1;
        let step = self.on_nodes(&step);
        let longest = step.iter().flatten().fold(0.0, |most: f64, d| most.max(d.abs()));
        if longest.is_nan() || longest >= 1e3 * self.size() {
            return Ok(moved);
        }
        let told = Iteration {
            load,
            iteration: 0,
            residual: balance.relative(),
            energy: balance.energy(),
            facets: balance.contact.facet_count,
            penetration: balance.contact.penetration,
            tangent: Some(Tangent::Semidefinite),
            length: 1.0,
            contact_iterations: 0,
        };
        self.tell(&told, watch)?;
        moved.iter_mut().zip(step).for_each(|(u, d)| (0..D).for_each(|i| u[i] += d[i]));
        Ok(moved)
    }
}

impl StaticsError {
    /// Whether a smaller load step may help.
    pub(super) fn may_yield_to_halving(&self) -> bool {
        matches!(
            self,
            Self::NotConverged { .. } | Self::LineSearch { .. } | Self::Unstable { .. } | Self::Inverted { .. }
        ) || matches!(
            self,
            Self::Contact(fmc_contact::Error::InvertedCell { .. } | fmc_contact::Error::FoldedCell { .. })
        )
    }
}
