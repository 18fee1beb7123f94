//! Where obstacles stood and bodies lay before what a search is asked about.

use crate::contact::equilibrium::driver::asking::unknowns::Unknowns;
use crate::contact::evaluation::{Contact, Stood};
use crate::contact::partners::Poses;
use std::sync::Arc;

/// What is known of it.
#[derive(Clone, Default)]
pub(crate) struct Former<const D: usize> {
    /// Of every obstacle that stands elsewhere now.
    pub(crate) moved: Vec<Stood<D>>,
    pub(crate) state: FormerState<D>,
}

/// The state that overlaps were in.
#[derive(Clone, Default)]
pub(crate) enum FormerState<const D: usize> {
    /// That where the search begins.
    #[default]
    Now,
    /// An equilibrium that a search has found, but for what is prescribed, with obstacles here.
    Found(Poses<D>),
    /// Where a step began, with obstacles here.
    Begun(Arc<Vec<[f64; D]>>, Poses<D>),
}

impl<const D: usize> Former<D> {
    /// Before a search from `x`, which has not yet begun a step itself.
    pub(crate) fn of(contact: &Contact<D>, unknowns: &Unknowns<D>, x: &[f64]) -> Self {
        let (coords, now) = (unknowns.coords(x), contact.partners.obstacles.poses());
        let step = contact.history.step.as_ref();
        let begins_here = step.is_some_and(|step| *step.coords.given() == coords);
        let last = contact.history.last.as_ref();
        let is_same =
            |found: &[f64]| found.len() == x.len() && (0..x.len()).all(|k| !unknowns.free[k] || found[k] == x[k]);
        let last_here = last.filter(|last| is_same(&last.x));
        let of_step = step.map(|step| &step.poses);
        // A step that begins where the search does is the last word; else the last equilibrium knows of what no step was told.
        let known = match last_here {
            _ if begins_here => of_step,
            Some(last) => Some(&last.poses),
            None => of_step.or(last.map(|last| &last.poses)),
        };
        let moved = contact.partners.obstacles.iter().enumerate().filter_map(|(obstacle, rigid)| {
            let rigid = rigid?;
            let of_step = known.and_then(|poses| poses.get(obstacle).copied().flatten());
            let pose = of_step.unwrap_or(rigid.added);
            (pose != rigid.obstacle.pose).then_some(Stood { obstacle, pose, is_of_step: of_step.is_some() })
        });
        let state = match (last_here, step) {
            (Some(last), _) => FormerState::Found(last.poses.clone()),
            (None, Some(step)) => {
                let stood = |(obstacle, now)| step.poses.get(obstacle).copied().flatten().or(now);
                FormerState::Begun(step.coords.given(), now.into_iter().enumerate().map(stood).collect())
            }
            (None, None) => FormerState::Now,
        };
        Self { moved: moved.collect(), state }
    }
}
