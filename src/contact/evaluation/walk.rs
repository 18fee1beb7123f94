//! The pairs that may overlap.

use super::state::State;
use crate::Error;
use crate::contact::interface::Contact;
use crate::contact::laws::{Measured, PairLaw};
use crate::contact::partners::Rigid;
use crate::geometry::Shape;
use crate::overlap::{Counterpart, ImplicitSide, Pair, Partner};
use crate::ranks::Sharing;
use rayon::prelude::*;
use std::sync::OnceLock;

impl<const D: usize> Contact<D> {
    /// Calls `work` for all pairs whose boxes meet, on the threads of the options, and returns its results in the order
    /// of the pairs.
    pub(crate) fn for_each_pair<T: Send>(
        &self,
        coords: &[[f64; D]],
        work: impl Fn(&Measured<D>) -> Result<Option<T>, Error> + Sync,
    ) -> Result<Vec<T>, Error> {
        self.for_each_pair_within(coords, 0.0, work)
    }

    /// The same for all pairs whose boxes are no farther apart than `reach` along every axis.
    pub(crate) fn for_each_pair_within<T: Send>(
        &self,
        coords: &[[f64; D]],
        reach: f64,
        work: impl Fn(&Measured<D>) -> Result<Option<T>, Error> + Sync,
    ) -> Result<Vec<T>, Error> {
        self.with_state(coords, |state| {
            let pairs = self.pairs(state, reach);
            let work = |partners: &[Partner; 2]| self.with_pair(state, *partners, &work);
            // Ranks meet in every pair, one pair after the other.
            let Some(pool) = self.pool().filter(|_| self.ranks.is_none()) else {
                return pairs.iter().filter_map(|partners| work(partners).transpose()).collect();
            };
            // A signed distance function belongs to the host and is called on the calling thread.
            let mut found: Vec<Option<Result<Option<T>, Error>>> = pool.install(|| {
                pairs.par_iter().map(|partners| (!self.is_marched(partners)).then(|| work(partners))).collect()
            });
            for (partners, found) in pairs.iter().zip(&mut found).filter(|(_, found)| found.is_none()) {
                *found = Some(work(partners));
            }
            found.into_iter().flatten().filter_map(Result::transpose).collect()
        })
    }

    fn is_marched(&self, partners: &[Partner; 2]) -> bool {
        let parallel = self.pair_table.parallel(partners);
        match partners[1] {
            Partner::Obstacle(_) if parallel.is_some() => {
                parallel.is_some_and(|parallel| matches!(parallel.shape, Shape::SignedDistance(_)))
            }
            Partner::Obstacle(o) => {
                let is_marched = |rigid: &Rigid<D>| matches!(rigid.implicit(), Shape::SignedDistance(_));
                self.obstacles[o].as_ref().is_some_and(is_marched)
            }
            Partner::Body(_) => false,
        }
    }

    /// Partners that are not left out and whose boxes meet, or nearly do, ascending: for every body itself (if asked for),
    /// later bodies, obstacles.
    fn pairs(&self, state: &State<D>, reach: f64) -> Vec<[Partner; 2]> {
        let mut pairs = Vec::new();
        let meeting = state.configuration.meeting_bodies(reach);
        let mut next = meeting.iter().peekable();
        for i in 0..self.surface.body_count() {
            let itself = [Partner::Body(i); 2];
            if self.pair_table.has(&itself, self.options.self_contact) {
                pairs.push(itself);
            }
            while let Some((_, j)) = next.next_if(|(first, _)| *first == i) {
                let pair = [Partner::Body(i), Partner::Body(*j)];
                if self.pair_table.has(&pair, true) {
                    pairs.push(pair);
                }
            }
            let aabb = state.configuration.body_box(i).inflated(reach);
            for (o, (rigid, placed)) in self.obstacles.iter().zip(&state.placed).enumerate() {
                let pair = [Partner::Body(i), Partner::Obstacle(o)];
                let Some(rigid) = rigid else { continue };
                let out = self.pair_table.gap_offset(&pair).max(0.0);
                if self.pair_table.has(&pair, true) && rigid.may_meet(placed.as_ref(), &aabb.inflated(out)) {
                    pairs.push(pair);
                }
            }
        }
        pairs
    }

    /// The law that a pair follows.
    pub(crate) fn law_of(&self, partners: &[Partner; 2]) -> &dyn PairLaw<D> {
        self.pair_table.law(partners).unwrap_or(&*self.law)
    }

    /// The laws that pairs may follow.
    pub(crate) fn laws(&self) -> impl Iterator<Item = &dyn PairLaw<D>> {
        std::iter::once(&*self.law).chain(self.pair_table.laws())
    }

    fn with_pair<T>(
        &self,
        state: &State<D>,
        partners: [Partner; 2],
        work: impl Fn(&Measured<D>) -> Result<Option<T>, Error>,
    ) -> Result<Option<T>, Error> {
        let State { configuration, placed, found } = state;
        let Partner::Body(first) = partners[0] else { return Ok(None) };
        let a = configuration.body(&self.surface, first);
        let rigid = match partners[1] {
            Partner::Obstacle(o) => self.obstacles[o].as_ref(),
            Partner::Body(_) => None,
        };
        let pose = rigid.map(|rigid| &rigid.obstacle.pose);
        let parallel = self.pair_table.parallel(&partners).zip(pose);
        let parallel = parallel.map(|(parallel, pose)| (&parallel.shape, parallel.pose(pose)));
        let counterpart = match (partners[1], rigid) {
            (Partner::Body(second), _) if second == first => {
                if !a.may_cross_itself() && self.surface.is_one_sheet(first) {
                    return Ok(None);
                }
                Counterpart::Itself
            }
            (Partner::Body(second), _) => Counterpart::Facets(configuration.body(&self.surface, second)),
            (Partner::Obstacle(obstacle), Some(rigid)) => match (&parallel, &placed[obstacle]) {
                (Some((shape, pose)), _) => Counterpart::Implicit(ImplicitSide { obstacle, shape, pose }),
                (None, Some(placed)) => Counterpart::Facets(rigid.side(placed)),
                (None, None) => {
                    let (shape, pose) = (rigid.implicit(), &rigid.obstacle.pose);
                    Counterpart::Implicit(ImplicitSide { obstacle, shape, pose })
                }
            },
            (Partner::Obstacle(_), None) => return Ok(None),
        };
        let (surface, coords) = (&self.surface, configuration.coords());
        let law = self.law_of(&partners);
        let depth = self.depth_field(law, &partners);
        let weighting = self.options.weighting();
        let clearance = if parallel.is_some() { 0.0 } else { -self.pair_table.gap_offset(&partners) };
        let sharing = match &self.ranks {
            // A function of the host is called on the thread that evaluates, on every rank at all points.
            _ if counterpart.is_marched() => Sharing::Alone,
            Some(ranks) => Sharing::Ranks { ranks, pool: self.pool() },
            // Outside the pool there is none to share the work with.
            None if self.pool().is_some() => Sharing::Threads,
            None => Sharing::Alone,
        };
        let region = OnceLock::new();
        let pair =
            Pair { partners, a, counterpart, pose, surface, coords, depth, clearance, weighting, sharing, region };
        // They were kept in the order of the pairs.
        let kept = self.kept.binary_search_by_key(&partners, |(kept, _)| *kept).ok().map(|place| &self.kept[place].1);
        work(&Measured { pair: &pair, law, estimator: &self.estimator, kept, found })
    }
}
