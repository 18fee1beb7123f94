//! The interfaces of a contact that follow a law of the host.

use crate::Error;
use crate::contact::cohesive::nearest;
use crate::contact::held::{At, Finder, Found, HeldList, LawHistory};
use crate::contact::laws::PairEnergy;
use crate::contact::mesh::Mesh;
use crate::contact::tangents::TangentPart;
use crate::geometry::Weighting;
use crate::interfaces::{Governed, GovernedAt, HeldFacets, InterfaceLaw, Softened};
use crate::overlap::Block;
use std::borrow::Cow;
use std::mem::replace;
use std::sync::Arc;

/// By pair of bodies, ascending.
pub(crate) type GovernedInterfaces<const D: usize> = HeldList<Governed<D>, D>;

/// A law of the host, and how many numbers every point has by it.
#[derive(Clone)]
pub(crate) struct OwnLaw {
    law: Arc<dyn InterfaceLaw>,
    count: usize,
}

impl OwnLaw {
    pub(crate) fn new(law: Arc<dyn InterfaceLaw>) -> Self {
        let count = law.history_count();
        Self { law, count }
    }

    pub(crate) fn is(&self, other: &Self) -> bool {
        Arc::ptr_eq(&self.law, &other.law)
    }

    /// What points begin with.
    fn zeros<const D: usize>(&self, held: &Governed<D>) -> Vec<f64> {
        vec![0.0; self.count * held.points.points.len()]
    }
}

impl<const D: usize> Found<D> for Governed<D> {
    const FINDER: Finder<Self, D> = Self::new;
    /// Its law, and the last that was found, where there is none now: what its points have been through waits for the next.
    type Kept = (OwnLaw, Option<Self>);
    type There<'a> = GovernedAt<'a, D>;

    fn facets(&self) -> &HeldFacets {
        &self.points.facets
    }

    fn there(&self, (own, _): &Self::Kept, at: At<D>) -> Result<GovernedAt<'_, D>, Error> {
        let known = at.past.of_laws.get(&self.points.bodies);
        let history = known.map_or_else(|| Cow::Owned(own.zeros(self)), Cow::Borrowed);
        self.at(at.points, &*own.law, (&history, at.past.time_step, at.past.law_fields))
    }

    /// What was put into the interface, as its law tells.
    fn pair_energy(&self, at: &GovernedAt<'_, D>) -> PairEnergy<D> {
        let held = &self.points;
        PairEnergy::of_interface(
            held.bodies,
            (at.energies().iter().sum(), at.gradient()),
            (&held.nodes, &held.of_b),
            (held.area, at.pulled() / held.area),
            held.left_out.iter().map(|left_out| left_out.warning(held.bodies, held.area)).collect(),
        )
    }

    fn blocks(at: &GovernedAt<'_, D>, part: TangentPart) -> Vec<Block<D>> {
        at.curvature(match part {
            TangentPart::Full => Softened::All,
            TangentPart::Symmetric => Softened::Symmetric,
            TangentPart::Semidefinite => Softened::Secant,
        })
    }
}

impl<const D: usize> GovernedInterfaces<D> {
    /// The law of two bodies, if they have one.
    pub(crate) fn law(&self, bodies: [usize; 2]) -> Option<OwnLaw> {
        self.held.get(&(bodies, 0)).map(|held| held.kept.0.clone())
    }

    /// Finds them anew, on another mesh without deformation. Every point has the history of the nearest that there was.
    pub(crate) fn find_again(&mut self, mesh: &Mesh<D>, weighting: Weighting, histories: &mut LawHistory) {
        let points = mesh.placed(mesh.surface.reference().into());
        for ((bodies, _), held) in &mut self.held {
            let count = held.kept.0.count;
            let before = replace(&mut held.found, Governed::find((mesh, weighting), &held.between));
            let before = before.ok().or_else(|| held.kept.1.take());
            match (&held.found, before) {
                (Ok(now), Some(before)) => {
                    if let Some(past) = histories.get_mut(bodies) {
                        let near = nearest([&before.points, &now.points], &points);
                        let of_point = |number: usize| past[number * count..][..count].to_vec();
                        *past = near.flat_map(|near| near.map_or_else(|| vec![0.0; count], of_point)).collect();
                    }
                }
                (_, before) => held.kept.1 = before,
            }
        }
    }

    /// Histories after a step that ends at these points of the mesh.
    pub(crate) fn gone_on(&self, at: At<D>) -> Result<LawHistory, Error> {
        let one = |(held, at, _): (&Governed<D>, GovernedAt<'_, D>, usize)| (held.points.bodies, at.answer.history);
        Ok(self.there(at)?.into_iter().map(one).collect())
    }

    /// The same as one list, by pair and point.
    pub(crate) fn list(&self, histories: &LawHistory) -> Result<Vec<f64>, Error> {
        let mut list = Vec::new();
        for found in self.all() {
            let (held, (own, _)) = found?;
            match histories.get(&held.points.bodies) {
                Some(known) => list.extend(known),
                None => list.extend(own.zeros(held)),
            }
        }
        Ok(list)
    }

    /// Of such a list.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::BadEntry`].
    pub(crate) fn of_list(&self, list: &[f64]) -> Result<LawHistory, Error> {
        if let Some(entry) = list.iter().position(|x| !x.is_finite()) {
            return Err(Error::BadEntry { array: "history", entry, value: list[entry] });
        }
        let (mut rest, mut histories) = (list, LawHistory::new());
        let mut expected = 0;
        for found in self.all() {
            let (held, (law, _)) = found?;
            let count = held.points.points.len() * law.count;
            let (own, others) = rest.split_at(count.min(rest.len()));
            histories.insert(held.points.bodies, own.to_vec());
            (rest, expected) = (others, expected + count);
        }
        match list.len() == expected {
            true => Ok(histories),
            false => Err(Error::Length { array: "history", expected, found: list.len() }),
        }
    }
}
