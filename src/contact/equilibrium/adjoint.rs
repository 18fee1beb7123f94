//! Derivatives of a number that hangs on an equilibrium, by what the equilibrium hangs on.
//!
//! With R = internal less external forces, contact forces F with the tangent T = −∂F/∂x, R(x, p) = F(x, p), a number J(x, F, p), K = ∂R/∂x
//! and a = ∂J/∂F
//!
//! ```text
//! (K + T)ᵀ λ = ∂J/∂x − Tᵀ a                                    at free unknowns, λ = 0 at the others
//! dJ/dp = ∂J/∂p − λ · ∂R/∂p + (λ + a) · ∂F/∂p
//! ```
//!
//! (Lions, Optimal control of systems governed by partial differential equations, 1971.) K and its solver are the host's. The right side
//! here is ∂J/∂x − Tᵀ (a + λ): that of the system without λ, and with it what Kᵀ λ is at free unknowns.

use super::driver::Unknowns;
use crate::Error;
use crate::contact::derivatives::{GradientRequest, Gradients};
use crate::contact::evaluation::Contact;

/// A number J of an equilibrium, by its derivatives.
#[derive(Clone, Copy, Debug)]
pub struct Goal<'a, const D: usize> {
    /// ∂J/∂x by unknown, also of those that are not free.
    pub by_x: &'a [f64],
    /// ∂J/∂F by node; `None` for zeros.
    pub by_forces: Option<&'a [[f64; D]]>,
}

/// What [`Contact::adjoint`] gives.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Adjoint<const D: usize> {
    /// ∂J/∂x − Tᵀ (a + λ) by unknown. Less Kᵀ λ it is the derivative by the value of an unknown that is not free, and zero at free ones.
    pub right: Vec<f64>,
    /// (λ + a) · ∂F/∂p for what the contact hangs on: total derivatives once λ is that of the system.
    pub gradients: Gradients<D>,
}

impl<const D: usize> Contact<D> {
    /// The adjoint of the equilibrium at `x`, where multipliers and friction have no part. Without `balance` it has the right side of the
    /// system (K + T)ᵀ λ = right for the free unknowns; T is the full tangent here. With its solution λ for `balance` it has the derivatives by
    /// what `request` names. Your part of dJ/dp is −λ · ∂R/∂p; a load has the derivative λ.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::UnknownOutOfRange`], [`Error::NonFiniteCoordinate`], [`Error::NonFiniteStiffness`]; as [`Self::vjp`].
    /// [`Error::Unsupported`] with multipliers, by which surfaces follow what changes, with friction, of which a tangent is no derivative, and
    /// by the slip between steps.
    #[inline(never)]
    pub fn adjoint(
        &self,
        unknowns: &Unknowns<D>,
        x: &[f64],
        goal: &Goal<D>,
        balance: Option<&[f64]>,
        request: &GradientRequest,
    ) -> Result<Adjoint<D>, Error> {
        let refused = |what| Err(Error::Unsupported { what });
        if !self.history.multipliers.is_empty() {
            return refused("the adjoint of an equilibrium with multipliers, which a penetration tolerance needs");
        }
        if self.partners.has_friction(self.method.options()) {
            return refused("the adjoint of an equilibrium with friction");
        }
        if request.slip {
            return refused("the adjoint of an equilibrium by the slip between steps");
        }
        unknowns.check(self.surface().unknown_count())?;
        let given = [("x", Some(x)), ("by_x", Some(goal.by_x)), ("balance", balance)];
        for (array, list) in given.into_iter().filter_map(|(array, list)| Some((array, list?))) {
            finite(array, list, unknowns.count)?;
        }
        if let Some(forces) = goal.by_forces {
            if forces.len() != unknowns.base.len() {
                return Err(Error::Length { array: "by_forces", expected: unknowns.base.len(), found: forces.len() });
            }
            finite("by_forces", forces.as_flattened(), forces.len() * D)?;
        }
        let mut on_nodes = match balance {
            Some(balance) => unknowns.spread(&unknowns.freed(balance.to_vec())),
            None => vec![[0.0; D]; unknowns.base.len()],
        };
        for (sum, force) in on_nodes.iter_mut().zip(goal.by_forces.unwrap_or(&[])) {
            (0..D).for_each(|axis| sum[axis] += force[axis]);
        }
        let all = GradientRequest { coords: true, ..*request };
        let mut gradients = self.vjp(&unknowns.coords(x), 0.0, Some(&on_nodes), &all)?;
        let mut right = unknowns.gather(&gradients.coords);
        right.iter_mut().zip(goal.by_x).for_each(|(sum, by_x)| *sum += by_x);
        if !request.coords {
            gradients.coords = Vec::new();
        }
        Ok(Adjoint { right, gradients })
    }
}

fn finite(array: &'static str, list: &[f64], expected: usize) -> Result<(), Error> {
    if list.len() != expected {
        return Err(Error::Length { array, expected, found: list.len() });
    }
    match list.iter().position(|x| !x.is_finite()) {
        Some(entry) => Err(Error::NonFiniteStiffness { array, entry }),
        None => Ok(()),
    }
}
