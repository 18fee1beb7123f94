//! The pairs that may overlap, as the estimators take them.

use super::Contact;
use crate::Error;
use crate::geometry::Pose;
use crate::overlap::{
    Estimator, ExactPair, FacetSide, FiberOptions, FiberPair, ImplicitSide, Opponent, Pair, Partner, Views,
};
use crate::sampling::{Family, FiberPattern};

/// Facets of an obstacle and where their corners are.
type PlacedFacets<'a, const D: usize> = (&'a [[u32; D]], Views<D>);

/// A pair that may overlap, as fibers see it and, where that is asked for, as it is clipped.
pub(super) struct Candidate<'a, const D: usize> {
    pub(super) fibers: FiberPair<'a, D>,
    pub(super) exact: Option<ExactPair<'a, D>>,
}

impl<const D: usize> Contact<D> {
    /// Runs through all pairs whose boxes meet, in the order of their indices, on the threads of the options.
    pub(super) fn for_each_pair<T: Send>(
        &self,
        coords: &[[f64; D]],
        work: impl Fn(&Candidate<D>) -> Result<Option<T>, Error> + Sync,
    ) -> Result<Vec<T>, Error> {
        match &self.pool {
            Some(pool) => pool.install(|| self.surface.check(coords, self.options.check_cells, true)),
            None => self.surface.check(coords, self.options.check_cells, false),
        }?;
        let (exact, options) = match self.options.estimator {
            Estimator::Fibers(options) => (false, options),
            Estimator::Exact => (true, FiberOptions::default()),
        };
        let with_lines = self.options.law.is_fiber() || (!exact && options.pattern == FiberPattern::Lines);
        let families = if with_lines { Family::all(options.seed) } else { Vec::new() };
        let views = Views::new(self.surface.points(coords), &families);
        let placed: Vec<Option<PlacedFacets<D>>> = (self.obstacles.iter())
            .map(|rigid| rigid.placed_facets(exact).map(|(facets, points)| (facets, Views::new(points, &families))))
            .collect();
        let body = |body: usize| {
            let facets = &self.surface.facets[self.surface.ranges[body].clone()];
            FacetSide::new(facets, self.surface.vertices[body].iter().copied(), &views)
        };
        let bodies: Vec<FacetSide<D>> = (0..self.surface.body_count()).map(body).collect();

        let parallel = self.pool.is_some();
        let measure = |partners: [Partner; 2], a: FacetSide<D>, opponent: Opponent<D>, pose: Option<&Pose<D>>| {
            let pair = Pair { partners, a, opponent, pose, surface: &self.surface, parallel };
            let candidate = Candidate {
                fibers: FiberPair { pair: &pair, families: &families, options: &options },
                exact: exact.then_some(ExactPair { pair: &pair, coords }),
            };
            match &self.pool {
                // A signed distance function belongs to the host and is called on the calling thread.
                Some(pool) if !opponent.is_marched() => pool.install(|| work(&candidate)),
                _ => work(&candidate),
            }
        };
        let mut results = Vec::new();
        for (i, &a) in bodies.iter().enumerate() {
            if self.options.self_contact {
                results.extend(measure([Partner::Body(i); 2], a, Opponent::Itself, None)?);
            }
            for (j, b) in bodies.iter().enumerate().skip(i + 1) {
                if a.aabb.meets(&b.aabb) {
                    results.extend(measure([Partner::Body(i), Partner::Body(j)], a, Opponent::Facets(*b), None)?);
                }
            }
            for (obstacle, (rigid, placed)) in self.obstacles.iter().zip(&placed).enumerate() {
                let pose = &rigid.obstacle.pose;
                let opponent = match placed {
                    Some((facets, views)) => {
                        Opponent::Facets(FacetSide::new(facets, 0..views.points.len() as u32, views))
                    }
                    None => Opponent::Implicit(ImplicitSide { obstacle, shape: rigid.implicit(), pose }),
                };
                results.extend(measure([Partner::Body(i), Partner::Obstacle(obstacle)], a, opponent, Some(pose))?);
            }
        }
        Ok(results)
    }
}
