//! What is found between two surfaces, and holds them.

use super::past::Past;
use crate::Error;
use crate::contact::laws::{Answer, PairEnergy};
use crate::contact::mesh::Mesh;
use crate::contact::tangents::{Tangent, TangentPart};
use crate::geometry::{Surface, Weighting};
use crate::interfaces::{Between, HeldFacets};
use crate::overlap::{Block, Partner};

/// Looks for something at points of the straight mesh; an error where the surfaces face one another nowhere.
pub(crate) type Finder<T, const D: usize> = fn(&Surface<D>, &[[f64; D]], Weighting, &Between) -> Result<T, Error>;

/// Points of the mesh, and what is asked of the contact there.
#[derive(Clone, Copy)]
pub(crate) struct At<'a, const D: usize> {
    pub(crate) points: &'a [[f64; D]],
    /// Of ties and of what does not separate.
    pub(crate) stiffness: &'a dyn Fn([Partner; 2]) -> f64,
    pub(crate) past: Past<'a, D>,
}

/// Energy and tangent, as far as they are wanted.
pub(crate) type Wanted = (bool, Option<TangentPart>);

/// One kind of it.
pub(crate) trait Found<const D: usize>: Sized {
    const FINDER: Finder<Self, D>;
    /// What is kept beside what was found: multipliers, or options.
    type Kept;
    /// It at some points of the mesh.
    type There<'a>
    where
        Self: 'a;

    fn facets(&self) -> &HeldFacets;

    fn there(&self, kept: &Self::Kept, at: At<D>) -> Result<Self::There<'_>, Error>;

    fn pair_energy(&self, there: &Self::There<'_>) -> PairEnergy<D>;

    fn blocks(there: &Self::There<'_>, part: TangentPart) -> Vec<Block<D>>;

    fn answer(&self, there: &Self::There<'_>, (energy, part): Wanted) -> Answer<D> {
        let tangent = part.map(|part| Tangent { blocks: Self::blocks(there, part), rank_one: Vec::new() });
        let energy = energy.then(|| self.pair_energy(there));
        Answer { energy, tangent, nodal_sums: None, points: Vec::new() }
    }

    /// Looks for it where nothing is deformed.
    fn find((mesh, weighting): (&Mesh<D>, Weighting), between: &Between) -> Result<Self, Error> {
        Self::FINDER(&mesh.surface, &mesh.placed(mesh.surface.reference().into()), weighting, between)
    }
}
