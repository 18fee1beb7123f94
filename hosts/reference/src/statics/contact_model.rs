//! Bodies that are linear and contact that is as it is, as an energy on the equations that are kept.

use super::balance::Balance;
use super::equilibrium::Equilibrium;
use super::iteration::Tangent;
use fmc_contact::ContactForces;
use fmc_contact::contact::equilibrium::descent::Descent;
use fmc_contact::sparse::Condensed;

/// Least energy over steps d, with r the residual of the bodies and K their stiffness at u:
/// r·d + ½ d·K d + contact energy(u + d).
///
/// With b = −r condensed to b̂ on the kept equations, and the others in the part s of their way to balance,
///
/// ```text
/// energy = ½ d·S d − b̂·d − (s − ½ s²) |L⁻¹ b|² + contact      d, S on the kept equations; |…| over the others
/// ```
pub(super) struct Model<'a, const D: usize> {
    pub(super) u: &'a [[f64; D]],
    pub(super) condensed: Condensed,
    /// b̂ − b on the kept equations.
    pub(super) change: Vec<f64>,
    /// |L⁻¹ b|² and |b|² of the others.
    pub(super) inner: [f64; 2],
    pub(super) scale: f64,
    /// Magnitude of the energies, for rounding.
    pub(super) magnitude: f64,
}

/// A step and its place in the model.
pub(super) struct At {
    pub(super) kept: Vec<f64>,
    /// s.
    pub(super) part: f64,
    /// S d.
    pub(super) pull: Vec<f64>,
    pub(super) energy: f64,
    /// Derivative of the energy by d.
    pub(super) gradient: Vec<f64>,
    /// Of the residual on all equations.
    pub(super) norm: f64,
    pub(super) step: Vec<f64>,
}

/// Where to go from there: d, and S d.
pub(super) struct Direction {
    pub(super) kept: Vec<f64>,
    pub(super) pull: Vec<f64>,
    pub(super) tangent: Tangent,
}

impl At {
    /// As far as the rules of a descent go.
    pub(super) fn descent<const D: usize>(&self, model: &Model<D>) -> Descent {
        Descent { energy: self.energy, norm: self.norm, rounding: 0.0, flat: Descent::flatness(model.magnitude) }
    }
}

impl<const D: usize> Model<'_, D> {
    /// Derivative of the energy along a direction from `from`, at `at`.
    pub(super) fn slope(&self, from: &At, direction: &Direction, at: &At) -> f64 {
        dot(&at.gradient, &direction.kept) - (1.0 - from.part) * (1.0 - at.part) * self.inner[0]
    }
}

impl<const D: usize> Equilibrium<D> {
    /// The model at u; `None` if there are no factors of the bodies.
    pub(super) fn contact_model<'a>(&self, u: &'a [[f64; D]], balance: &Balance<D>) -> Option<Model<'a, D>> {
        let touch = self.on_equations(&balance.contact.forces);
        let right: Vec<f64> = self.on_equations(&balance.residual).iter().zip(&touch).map(|(r, f)| -r - f).collect();
        let condensed = self.bulk.condense(&right)?;
        let own = self.kept.of(&right);
        let change = condensed.kept.iter().zip(&own).map(|(condensed, own)| condensed - own).collect();
        let others = right.iter().enumerate().filter(|(equation, _)| self.kept.place(*equation).is_none());
        let inner = [dot(&condensed.inner, &condensed.inner), others.map(|(_, b)| b * b).sum()];
        Some(Model { u, condensed, change, inner, scale: balance.scale, magnitude: balance.magnitude() })
    }

    /// Place of a step: of the kept equations, the part of the others' way, and the step on all; and S times the first.
    pub(super) fn at(
        &self,
        model: &Model<D>,
        (kept, part, step): (Vec<f64>, f64, Vec<f64>),
        pull: Vec<f64>,
        touch: &ContactForces<D>,
    ) -> At {
        let Model { condensed, change, inner, .. } = model;
        let forces = self.on_equations(&touch.forces);
        let outside = forces.iter().enumerate().filter(|(equation, _)| self.kept.place(*equation).is_none());
        let outside: f64 = outside.map(|(_, f)| f * f).sum();
        let forces = self.kept.of(&forces);
        let gradient: Vec<f64> = (0..kept.len()).map(|k| pull[k] - condensed.kept[k] - forces[k]).collect();
        let residual: f64 = gradient.iter().zip(change).map(|(g, c)| (g + (1.0 - part) * c).powi(2)).sum();
        let norm = (residual + (1.0 - part).powi(2) * inner[1] + outside).sqrt();
        let bodies = 0.5 * dot(&pull, &kept) - dot(&condensed.kept, &kept) - (part - 0.5 * part * part) * inner[0];
        let energy = bodies + touch.energy + touch.friction.stored + touch.friction.dissipated;
        At { kept, part, pull, energy, gradient, norm, step }
    }
}

fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}
