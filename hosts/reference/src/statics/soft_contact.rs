//! Contact that is soft first: rough equilibria on growing stiffness.

use super::equilibrium::{Equilibrium, size};
use super::error::StaticsError;
use super::newton::{State, Watch};
use crate::fem::Part;
use fmc_contact::{EnergyLaw, EnergyProfile, PenetrationLaw};

/// Factor from one rough contact to the next: ten times as much takes half as many iterations more.
const STRIDE: f64 = 100.0;

/// Least and largest factor for the depth law. Its sunk walls are pressed sideways by k δ²/2 each, which a cell of size h
/// bears up to about E h.
const STRIDES_OF_DEPTH: [f64; 2] = [2.0, 10.0];

/// Stiffness of a soft contact by E / size of a body: on Hertz' half-disc, 10 to 100 take the fewest iterations.
const SOFT: f64 = 50.0;

impl<const D: usize> Equilibrium<D> {
    /// Equilibrium at a load from a displacement that is far from it, with a law whose pressure is k times the
    /// penetration; others are led straight there.
    ///
    /// A body that comes to rest on a few points of hard contact would creep out of their reach: every step is as long as
    /// the next gap is wide; cells that hard contact drives out at once are turned inside out. On a soft contact both
    /// settle.
    pub(super) fn led_from(&mut self, start: Vec<[f64; D]>, load: f64, watch: Watch) -> Result<State<D>, StaticsError> {
        let soft = self.soft_stiffness(&start);
        let Some(k) = self.penalty().filter(|k| *k > soft) else {
            let start = self.approach(start, load)?;
            return self.newton(start, load, watch);
        };
        if self.is_supported(&start)? {
            // The contact step leads the depth law out of most deep overlaps by itself, in fewer iterations.
            let is_deep = self.is_too_deep(&start);
            if !is_deep || self.is_depth() {
                match self.newton(start.clone(), load, watch) {
                    Err(error) if is_deep && error.may_yield_to_halving() => {}
                    ended => return ended,
                }
            }
        }
        let settings = self.settings;
        self.settings.tolerance = settings.full_below.max(settings.tolerance);
        self.settings.penetration = 0.0;
        let settled = self.settle(start, load, soft, k, watch);
        self.settings = settings;
        self.set_penalty(k)?;
        self.newton(settled?, load, watch)
    }

    /// Rough equilibria on contacts of growing stiffness.
    fn settle(
        &mut self,
        start: Vec<[f64; D]>,
        load: f64,
        soft: f64,
        hard: f64,
        watch: Watch,
    ) -> Result<Vec<[f64; D]>, StaticsError> {
        self.set_penalty(soft)?;
        let mut u = self.approach(start, load)?;
        let stages = ((hard / soft).ln() / STRIDE.ln()).ceil().max(1.0);
        let stride = (hard / soft).powf(1.0 / stages);
        let mut k = soft;
        // Rounding leaves the last of equal strides a little short of the end.
        while k < (1.0 - 1e-9) * hard {
            self.set_penalty(k)?;
            let balance;
            (u, balance) = self.newton(u, load, watch)?;
            let [least, largest] = STRIDES_OF_DEPTH.map(|stride| stride * k);
            k = match self.bearable(balance.contact.penetration) {
                Some(bearable) => bearable.clamp(least, largest),
                None => stride * k,
            };
        }
        Ok(u)
    }

    /// Whether the penetration calls for a pressure beyond Young's modulus, which nothing could bear; with the depth law, also
    /// whether it would push sunk walls aside.
    pub(super) fn is_too_deep(&mut self, u: &[[f64; D]]) -> bool {
        let Some(k) = self.penalty() else { return false };
        self.contact.release_patches();
        let young = self.least_young();
        self.touch(u, &self.placed(u)).is_ok_and(|contact| {
            k * contact.penetration > young || self.bearable(contact.penetration).is_some_and(|bearable| k > bearable)
        })
    }

    /// Stiffness of the depth law at which walls sunk by a depth are not pushed aside, k δ² = E h; `None` for other laws.
    fn bearable(&self, depth: f64) -> Option<f64> {
        self.is_depth().then(|| self.least_young() * self.least_facet() / (depth * depth))
    }

    /// A contact stiffness that is [`SOFT`] times that of the softest and smallest body, E / size; with the depth law, less
    /// if the start is so deep that walls would be pushed aside.
    fn soft_stiffness(&self, start: &[[f64; D]]) -> f64 {
        let stiffness = |part: &Part<D>| part.material.young / size(&part.mesh.coords);
        let soft = SOFT * self.problem.model.parts().iter().map(stiffness).fold(f64::INFINITY, f64::min);
        if !self.is_depth() {
            return soft;
        }
        let found = self.touch(start, &self.placed(start)).ok();
        found.and_then(|contact| self.bearable(contact.penetration)).map_or(soft, |bearable| soft.min(bearable))
    }

    /// k of a law whose pressure is k times the penetration.
    fn penalty(&self) -> Option<f64> {
        match self.problem.contact.law {
            EnergyLaw::Fiber(PenetrationLaw { stiffness: k, profile: EnergyProfile::Quadratic })
            | EnergyLaw::Depth { stiffness: k } => Some(k),
            _ => None,
        }
    }

    /// Another k of such a law.
    fn set_penalty(&mut self, k: f64) -> Result<(), StaticsError> {
        self.set_law(if self.is_depth() { EnergyLaw::depth(k) } else { EnergyLaw::fiber(k) })
    }

    pub(super) fn is_depth(&self) -> bool {
        matches!(self.problem.contact.law, EnergyLaw::Depth { .. })
    }

    /// Young's modulus of the softest body.
    fn least_young(&self) -> f64 {
        self.problem.model.parts().iter().map(|part| part.material.young).fold(f64::INFINITY, f64::min)
    }

    /// Shortest edge of a facet: where meshes are graded, those in contact are the smallest.
    fn least_facet(&self) -> f64 {
        let coords = self.problem.model.coords();
        let length = |p: u32, q: u32| {
            let squares = (0..D).map(|i| (coords[p as usize][i] - coords[q as usize][i]).powi(2));
            squares.sum::<f64>().sqrt()
        };
        let faces = self.contact.surface().faces();
        let edges = faces
            .into_iter()
            .flat_map(|(_, face)| (1..face.len()).map(move |k| (face[k - 1], face[k])).collect::<Vec<_>>());
        edges.map(|(p, q)| length(p, q)).fold(f64::INFINITY, f64::min)
    }
}
