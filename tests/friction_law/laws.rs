//! Laws that the tests ask.

use fmc_contact::contact::{FrictionFacets, FrictionLaw, FrictionResponse, LawFailure};

/// A facet as a law sees it.
pub(crate) struct Facet<'a> {
    pub(crate) pressure: f64,
    pub(crate) slip: &'a [f64],
    pub(crate) trial: &'a [f64],
    pub(crate) stiffness: f64,
    pub(crate) time_step: f64,
    pub(crate) history: &'a [f64],
    pub(crate) fields: &'a [f64],
}

impl Facet<'_> {
    pub(crate) fn speed(&self) -> f64 {
        norm(self.slip) / self.time_step
    }
}

pub(crate) fn norm(x: &[f64]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}

/// Limit, its derivatives by the pressure and by the size of the slip, and the history after the step.
pub(crate) type Answer = (f64, f64, f64, Vec<f64>);

/// A law facet by facet that depends on the size of the slip, with so many numbers of history.
pub(crate) struct One<F>(pub(crate) usize, pub(crate) F);

impl<F: Fn(&Facet) -> Answer + Send + Sync> FrictionLaw for One<F> {
    fn history_count(&self) -> usize {
        self.0
    }

    fn respond(&self, facets: &FrictionFacets<'_>, response: &mut FrictionResponse<'_>) -> Result<(), LawFailure> {
        let (n, h, m) = (facets.dim - 1, self.0, 2 * facets.field_count);
        for at in 0..facets.count {
            let facet = Facet {
                pressure: facets.pressures[at],
                slip: &facets.slips[at * n..][..n],
                trial: &facets.trials[at * n..][..n],
                stiffness: facets.stiffness,
                time_step: facets.time_step,
                history: &facets.history[at * h..][..h],
                fields: &facets.fields[at * m..][..m],
            };
            let (limit, by_pressure, by_size, history) = (self.1)(&facet);
            (response.limits[at], response.by_pressure[at]) = (limit, by_pressure);
            let size = norm(facet.slip);
            for axis in 0..n {
                response.by_slip[at * n + axis] = if size > 0.0 { by_size * facet.slip[axis] / size } else { 0.0 };
            }
            response.history[at * h..][..h].copy_from_slice(&history);
        }
        Ok(())
    }
}

pub(crate) fn coulomb(coefficient: f64) -> impl FrictionLaw {
    One(0, move |facet: &Facet| (coefficient * facet.pressure, coefficient, 0.0, Vec::new()))
}

/// τ = min(μ p, most).
pub(crate) fn capped(coefficient: f64, most: f64) -> impl FrictionLaw {
    One(0, move |facet: &Facet| match coefficient * facet.pressure {
        limit if limit < most => (limit, coefficient, 0.0, Vec::new()),
        _ => (most, 0.0, 0.0, Vec::new()),
    })
}

/// Stribeck's curve: μ(v) = a + b exp(−v/v₀) + c v.
pub(crate) fn stribeck([a, b, c, v0]: [f64; 4]) -> impl FrictionLaw {
    One(0, move |facet: &Facet| {
        let v = facet.speed();
        let (coefficient, slope) = (a + b * (-v / v0).exp() + c * v, c - b / v0 * (-v / v0).exp());
        (coefficient * facet.pressure, coefficient, slope * facet.pressure / facet.time_step, Vec::new())
    })
}

/// A coefficient that falls from a to b with the way slid d, as exp(−d/l); the history has d before the step.
pub(crate) fn weakening([a, b, l]: [f64; 3]) -> impl FrictionLaw {
    One(1, move |facet: &Facet| {
        let coefficient = b + (a - b) * (-facet.history[0] / l).exp();
        let limit = coefficient * facet.pressure;
        let slid = (norm(facet.trial) - limit / facet.stiffness).max(0.0);
        (limit, coefficient, 0.0, vec![facet.history[0] + slid])
    })
}
