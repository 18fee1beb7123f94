//! How facets bore when the step began.

use crate::contact::friction::{FacetBearings, SlipFacets};
use crate::contact::partners::{BearingRule, BearingRules};
use crate::overlap::Partner;

/// What was measured, and by which rules: of a pair that bears by others now nothing is known.
#[derive(Clone)]
pub(crate) struct Bearings {
    of_facets: FacetBearings,
    rules: BearingRules,
    /// Obstacles with numbers from here on came later, and bore nothing.
    obstacle_count: usize,
}

impl Bearings {
    pub(crate) fn new<const D: usize>(pairs: &[SlipFacets<D>], rules: BearingRules, obstacle_count: usize) -> Self {
        let mut of_facets = FacetBearings::new();
        pairs.iter().for_each(|pair| pair.add_bearings(&mut of_facets));
        Self { of_facets, rules, obstacle_count }
    }

    /// Those of the facets that bore, if the pair bears by the same rule `now`.
    pub(crate) fn of(&self, pair: &[Partner; 2], now: Option<BearingRule>) -> Option<&FacetBearings> {
        let came_later = matches!(pair[1], Partner::Obstacle(obstacle) if obstacle >= self.obstacle_count);
        (came_later || self.rules.of(pair) == now).then_some(&self.of_facets)
    }

    /// The same of other cells of the mesh; `facet` is the new number of a facet, if it is still there.
    pub(crate) fn of_cells(self, facet: impl Fn(usize) -> Option<usize>) -> Self {
        let of = |((partners, of_b, old), bearing)| facet(old).map(|new| ((partners, of_b, new), bearing));
        Self { of_facets: self.of_facets.into_iter().filter_map(of).collect(), ..self }
    }
}
