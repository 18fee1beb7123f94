//! How facets bore when the step began.

use crate::contact::friction::{FacetBearings, SlipFacets};
use crate::contact::partners::{BearingRule, BearingRules};
use crate::overlap::Partner;
use std::collections::BTreeMap;

/// What was measured, and by which rules: of a pair that bears by others now nothing is known.
#[derive(Clone)]
pub(crate) struct Bearings {
    of_facets: FacetBearings,
    /// Stiffness k by which the pairs pressed, and the factor by which the contact had been made stiffer.
    stiffness: BTreeMap<[Partner; 2], f64>,
    stiffened: f64,
    rules: BearingRules,
    /// Obstacles with numbers from here on came later, and bore nothing.
    obstacle_count: usize,
}

impl Bearings {
    pub(crate) fn new<const D: usize>(
        pairs: &[SlipFacets<D>],
        (stiffness_of, stiffened): (impl Fn(&[Partner; 2]) -> f64, f64),
        rules: BearingRules,
        obstacle_count: usize,
    ) -> Self {
        let mut of_facets = FacetBearings::new();
        pairs.iter().for_each(|pair| pair.add_bearings(&mut of_facets));
        let stiffness = pairs.iter().map(|pair| (pair.partners, stiffness_of(&pair.partners))).collect();
        Self { of_facets, stiffness, stiffened, rules, obstacle_count }
    }

    /// How many times as stiff a pair is as when the step began, if its stiffness is `now`, and how many times of that by
    /// [`stiffen`](crate::Contact::stiffen).
    pub(crate) fn stiffer(&self, pair: &[Partner; 2], now: f64, stiffened: f64) -> [f64; 2] {
        let then = self.stiffness.get(pair).filter(|then| **then > 0.0 && now > 0.0);
        then.map_or([1.0; 2], |then| [now / then, stiffened / self.stiffened])
    }

    /// Those of the facets that bore, if the pair bears by the same rule `now`.
    pub(crate) fn of(&self, pair: &[Partner; 2], now: Option<BearingRule>) -> Option<&FacetBearings> {
        let came_later = matches!(pair[1], Partner::Obstacle(obstacle) if obstacle >= self.obstacle_count);
        (came_later || self.rules.of(pair) == now).then_some(&self.of_facets)
    }

    /// Whether nothing bore.
    pub(crate) fn are_none(&self) -> bool {
        self.of_facets.is_empty()
    }

    /// Whether any facet of a pair bore.
    pub(crate) fn has(&self, pair: &[Partner; 2]) -> bool {
        self.of_facets.range((*pair, false, 0)..=(*pair, true, usize::MAX)).next().is_some()
    }

    /// The same of other cells of the mesh; `facet` is the new number of a facet, if it is still there.
    pub(crate) fn of_cells(self, facet: impl Fn(usize) -> Option<usize>) -> Self {
        let of = |((partners, of_b, old), bearing)| facet(old).map(|new| ((partners, of_b, new), bearing));
        Self { of_facets: self.of_facets.into_iter().filter_map(of).collect(), ..self }
    }
}
