//! Tractions of frozen friction as unknowns of their own, from one step of an iteration to the next.
//!
//! What slides has no stiffness along its way, and the least one by which no step goes too far, traction by slip, leads to where it sticks by
//! ever smaller steps: where two facets rub a body along opposite ways, by the difference of their limits each. The primal–dual method
//! (Chan, Golub, Mulet, SIAM J. Sci. Comput. 20, 1999) has both as its ends. The equation |s| m = s of the traction m, a part of the
//! limit, is linearised in m and s, and m, not s / |s|, is what the stiffness has: (I − m sᵀ / |s|) / |s|. Where a step asks for less than
//! the limit of a facet, it has the stiffness that leads to where the facet sticks.

use super::carriers::SliderName;
use super::slip_facets::{SlipFacet, SlipFacets};
use crate::geometry::Vector;
use std::collections::BTreeMap;

/// Of all facets, at the last step.
#[derive(Clone, Default)]
pub(crate) struct Duals<const D: usize> {
    of: BTreeMap<SliderName, Dual<D>>,
}

#[derive(Clone)]
struct Dual<const D: usize> {
    /// Traction by limit, at most 1.
    part: Vector<D>,
    trial: Vector<D>,
    slides: bool,
}

impl<const D: usize> Dual<D> {
    /// Where a step has led to this slip.
    fn after(&self, trial: &Vector<D>, value: Vector<D>) -> Vector<D> {
        if !self.slides {
            return value;
        }
        let (size, along) = (self.trial.norm(), self.trial.normalize());
        let part = (trial - self.part * along.dot(&(trial - self.trial))) / size;
        part / part.norm().max(1.0)
    }
}

impl<const D: usize> Duals<D> {
    /// Takes facets to where a step has led; notes the parts in them, if they are to be used.
    pub(crate) fn take(&mut self, pairs: &mut [SlipFacets<D>], are_used: bool) {
        let before = std::mem::take(&mut self.of);
        for SlipFacets { partners, facets, .. } in pairs {
            for facet in facets {
                let name = (*partners, facet.of_b, facet.facet);
                let SlipFacet { slider, trial, .. } = &*facet;
                let traction = slider.traction(trial);
                if slider.limit > 0.0 && slider.limit.is_finite() {
                    let value = traction.value / slider.limit;
                    let part = before.get(&name).map_or(Vector::zeros(), |dual| dual.after(trial, value));
                    self.of.insert(name, Dual { part, trial: *trial, slides: traction.slides });
                    facet.dual = if are_used { part } else { Vector::zeros() };
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::friction::Stick;
    use crate::contact::friction::return_mapping::Slider;

    /// Steps until a body between two places, to which sliders drag it with almost the same limit, sticks at the one with the higher limit.
    fn steps(are_used: bool) -> usize {
        let places = [(0.0, 1.0), (1.0, 0.999)];
        let (mut x, mut before): (f64, [Option<Dual<2>>; 2]) = (0.4, [None, None]);
        for step in 0..5000 {
            if x.abs() < 1e-5 {
                return step;
            }
            let (mut force, mut stiffness) = (0.0, 0.0);
            for ((place, limit), before) in places.into_iter().zip(&mut before) {
                let slider = Slider { stick: Stick::Spring(1e6), limit, ellipse: None };
                let trial = Vector::<2>::new(x - place, 0.0);
                let traction = slider.traction(&trial);
                let part = before.as_ref().map_or(Vector::zeros(), |dual| dual.after(&trial, traction.value / limit));
                *before = Some(Dual { part, trial, slides: traction.slides });
                let part = if are_used { part } else { Vector::zeros() };
                (force, stiffness) = (force + traction.value[0], stiffness + traction.secant(&trial, &part)[(0, 0)]);
            }
            // Along a step the energy falls, and no further.
            let next = x - force / stiffness;
            x = if next < 0.0 && x > 0.0 { 0.5 * x.min(1e-5) } else { next };
        }
        5000
    }

    #[test]
    fn bodies_do_not_creep_to_where_they_stick() {
        let (with, without) = (steps(true), steps(false));
        assert!(with <= 4 && without > 1000, "{with} {without}");
    }

    #[test]
    fn no_part_is_beyond_the_limit() {
        let dual =
            Dual { part: Vector::<3>::new(0.6, 0.0, -0.8), trial: Vector::<3>::new(1.0, 2.0, 2.0), slides: true };
        for trial in [[9.0, 0.0, 0.0], [-1.0, -2.0, -2.0], [0.1, 0.0, 0.0]].map(Vector::<3>::from) {
            assert!(dual.after(&trial, trial).norm() <= 1.0 + 1e-15);
        }
    }
}
