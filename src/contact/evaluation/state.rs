//! What a contact keeps from one evaluation to the next: nothing that any result depends on.

use crate::Error;
use crate::configuration::Configuration;
use crate::contact::interface::Contact;
use crate::contact::laws::{FoundPatches, PairLaw};
use crate::contact::partners::Placed;
use crate::contact::work::Workers;
use crate::depth_field::DepthField;
use crate::geometry::aabb::Aabb;
use crate::overlap::Partner;

/// The bodies and the obstacles where they were evaluated last.
pub(crate) struct State<const D: usize> {
    pub(crate) configuration: Configuration<D>,
    /// Obstacles that are bounded by facets.
    pub(crate) placed: Vec<Option<Placed<D>>>,
    pub(crate) found: FoundPatches<D>,
}

impl<const D: usize> Contact<D> {
    /// Calls `work` with the bodies at `coords`.
    ///
    /// The first call takes what was kept; concurrent calls find nothing kept and start afresh, with the same result.
    pub(crate) fn with_state<T>(
        &self,
        coords: &[[f64; D]],
        work: impl FnOnce(&State<D>) -> Result<T, Error>,
    ) -> Result<T, Error> {
        let lock = || self.state.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
        let kept = lock().take();
        let mut state = kept.unwrap_or_else(|| {
            let (configuration, placed) = (Configuration::new(), Vec::new());
            Box::new(State { configuration, placed, found: FoundPatches::default() })
        });
        let brought = self
            .bring(&mut state, coords)
            .and_then(|()| self.check_radii(&state.configuration))
            .and_then(|()| self.check_gathered(&state.configuration, coords));
        let result = match &self.ranks {
            None => brought.and_then(|()| work(&state)),
            Some(ranks) => {
                let begun = ranks.agree(brought, self.given(coords, std::any::type_name::<T>()));
                begun.and_then(|()| ranks.agree(work(&state), 0))
            }
        };
        *lock() = Some(state);
        result
    }

    /// How deep the cells of bodies lie below their surfaces, where the law asks for it and there are cells; friction asks
    /// with a law that has no points of its own.
    pub(crate) fn depth_field(&self, law: &dyn PairLaw<D>, partners: &[Partner; 2]) -> Option<&DepthField<D>> {
        if !law.needs_depth() && (law.is_local() || !self.friction_of(partners).is_active()) {
            return None;
        }
        let new = || DepthField::new(&self.surface, self.in_symmetry_plane.as_deref(), self.options.weighting());
        self.depth.get_or_init(new).as_ref()
    }

    /// The threads that share the work, if there are some.
    pub(crate) fn pool(&self) -> Option<&rayon::ThreadPool> {
        self.workers.as_ref().and_then(Workers::pool)
    }

    fn bring(&self, state: &mut State<D>, coords: &[[f64; D]]) -> Result<(), Error> {
        let update = |state: &mut State<D>| {
            state.configuration.update(&self.surface, coords, self.options.check_cells, self.pool().is_some())
        };
        let moved = match self.pool() {
            Some(pool) => pool.install(|| update(state)),
            None => update(state),
        }?;
        if moved {
            state.found = FoundPatches::default();
        }
        let prefers_facets = self.estimator.prefers_facets();
        state.placed.resize_with(self.obstacles.len(), || None);
        for (rigid, placed) in self.obstacles.iter().zip(&mut state.placed) {
            match rigid {
                Some(rigid) => rigid.place(prefers_facets, placed),
                None => *placed = None,
            }
        }
        Ok(())
    }

    /// Checks, with axisymmetry, that no body reaches beyond the axis by more than rounding.
    fn check_radii(&self, configuration: &Configuration<D>) -> Result<(), Error> {
        let boxes = || (0..self.surface.body_count()).map(|body| configuration.body_box(body));
        if self.options.weighting().is_plain() || boxes().all(|aabb| aabb.min[0] >= 0.0) {
            return Ok(());
        }
        let rounding = boxes().fold(Aabb::empty(), |all, aabb| all.union(&aabb)).rounding();
        let radius = |node: usize| configuration.coords()[node][0];
        let mut nodes = self.surface.nodes.iter().map(|&node| node as usize);
        match nodes.find(|&node| radius(node) < -rounding) {
            Some(node) => Err(Error::NegativeRadius { node, radius: radius(node) }),
            None => Ok(()),
        }
    }

    /// Forgets what was found at the last coordinates, after a change of the options or of an obstacle.
    pub(crate) fn forget_found(&mut self) {
        if let Some(state) = self.state.get_mut().unwrap_or_else(|poisoned| poisoned.into_inner()) {
            state.found = FoundPatches::default();
        }
    }
}
