//! All of one kind that a contact has.

use super::found::{At, Found, Wanted};
use crate::Error;
use crate::contact::laws::Answer;
use crate::contact::mesh::Mesh;
use crate::geometry::Weighting;
use crate::interfaces::{Between, HeldFacets};
use std::collections::BTreeMap;

/// Two bodies and the number of what was added between them; 0 for that of the options of their pair.
pub(crate) type Key = ([usize; 2], usize);

/// By bodies and number, ascending.
pub(crate) struct HeldList<T: Found<D>, const D: usize> {
    pub(crate) held: BTreeMap<Key, Held<T, T::Kept>>,
    /// How many were ever added beside the options of pairs.
    pub(crate) added: usize,
}

#[derive(Clone)]
pub(crate) struct Held<T, K> {
    pub(crate) between: Between,
    /// At first as the mesh is without deformation; an error is that of every evaluation.
    pub(crate) found: Result<T, Error>,
    pub(crate) kept: K,
}

/// What was found, at some points of the mesh, and its number where it was added.
pub(crate) type One<'a, T, const D: usize> = (&'a T, <T as Found<D>>::There<'a>, usize);

impl<T, K> Held<T, K> {
    pub(crate) fn get(&self) -> Result<(&T, &K), Error> {
        self.found.as_ref().map(|found| (found, &self.kept)).map_err(Error::clone)
    }
}

impl<T: Found<D>, const D: usize> Default for HeldList<T, D> {
    fn default() -> Self {
        Self { held: BTreeMap::new(), added: 0 }
    }
}

impl<T: Found<D> + Clone, const D: usize> Clone for HeldList<T, D>
where
    T::Kept: Clone,
{
    fn clone(&self) -> Self {
        Self { held: self.held.clone(), added: self.added }
    }
}

impl<T: Found<D>, const D: usize> HeldList<T, D> {
    pub(crate) fn is_empty(&self) -> bool {
        self.held.is_empty()
    }

    /// Holds two bodies as the options of their pair say, unless what is kept of them is `alike`; returns whether anything has changed.
    ///
    /// # Errors
    /// Of the finder; all then stays as it is.
    pub(crate) fn set(
        &mut self,
        between: Between,
        (kept, alike): (T::Kept, impl Fn(&T::Kept) -> bool),
        on: (&Mesh<D>, Weighting),
    ) -> Result<bool, Error> {
        let key = (between.bodies, 0);
        let before = self.held.get(&key).filter(|held| held.between == between && held.found.is_ok());
        if before.is_some_and(|held| alike(&held.kept)) {
            return Ok(false);
        }
        self.hold(key, between, kept, on)?;
        Ok(true)
    }

    pub(crate) fn hold(
        &mut self,
        key: Key,
        between: Between,
        kept: T::Kept,
        on: (&Mesh<D>, Weighting),
    ) -> Result<(), Error> {
        let found = Ok(T::find(on, &between)?);
        self.held.insert(key, Held { between, found, kept });
        Ok(())
    }

    /// Releases them; returns whether they were held.
    pub(crate) fn release(&mut self, bodies: [usize; 2]) -> bool {
        self.held.remove(&(bodies, 0)).is_some()
    }

    /// All of them; an error of one that is no longer there, since the mesh without deformation has changed.
    pub(crate) fn all(&self) -> impl Iterator<Item = Result<(&T, &T::Kept), Error>> {
        self.held.values().map(Held::get)
    }

    /// That of two bodies by the options of their pair.
    pub(crate) fn of(&self, bodies: [usize; 2]) -> Option<Result<&T, Error>> {
        self.held.get(&(bodies, 0)).map(|held| held.found.as_ref().map_err(Error::clone))
    }

    /// Facets that are held of pairs of which parts alone are to be, by their options.
    pub(crate) fn facets(&self) -> impl Iterator<Item = ([usize; 2], &HeldFacets)> {
        let in_part = self.held.iter().filter(|((_, added), held)| *added == 0 && held.between.facets.is_some());
        in_part.filter_map(|(_, held)| held.found.as_ref().ok().map(|found| (held.between.bodies, found.facets())))
    }

    /// All of them at points of the mesh, with the number of each that was added.
    pub(crate) fn there(&self, at: At<D>) -> Result<Vec<One<'_, T, D>>, Error> {
        let all = self.held.iter().map(|((_, added), held)| held.get().map(|(found, kept)| (found, kept, *added)));
        all.map(|one| one.and_then(|(found, kept, added)| Ok((found, found.there(kept, at)?, added)))).collect()
    }

    /// By pair.
    pub(crate) fn answers(&self, at: At<D>, wanted: Wanted) -> Result<Vec<Answer<D>>, Error> {
        Ok(self.there(at)?.into_iter().map(|(found, there, _)| found.answer(&there, wanted)).collect())
    }
}
