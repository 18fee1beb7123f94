//! What the derivatives are.

use crate::Error;
use crate::contact::friction::FacetSlip;
use crate::contact::results::OntoNodes;
use crate::geometry::second_order::Division;
use crate::overlap::Partner;

/// Derivatives of a number that hangs on energy and forces: see [`Contact::vjp`](crate::Contact::vjp). Lists that were not asked for
/// are empty.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct Gradients<const D: usize> {
    /// By the coordinates, `[node_count, D]`.
    pub coords: Vec<[f64; D]>,
    /// By the coordinates without deformation, `[node_count, D]`, the current ones held.
    pub reference: Vec<[f64; D]>,
    /// By what each pair that touches has, in the order of the pairs.
    pub pairs: Vec<PairGradient>,
    /// By the position of every obstacle.
    pub positions: Vec<[f64; D]>,
    /// By a rotation vector of every obstacle about its position, in space; in 2D only the last entry differs from zero.
    pub rotations: Vec<[f64; 3]>,
    /// By the elastic slip carried into the step: of every facet that friction acts on, and each of those that it faces, in the order of
    /// [`Contact::slip`](crate::Contact::slip).
    pub slip: Vec<FacetSlip<D>>,
}

/// Derivatives by what one pair has; what was not asked for is 0.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct PairGradient {
    /// The sides.
    pub partners: [Partner; 2],
    /// By the stiffness k of the pair's law.
    pub stiffness: f64,
    /// By its gap offset.
    pub gap_offset: f64,
    /// By its coefficient of friction.
    pub friction: f64,
}

impl PairGradient {
    /// Of a pair, all 0: rates to be set, for [`Directions::pairs`](crate::contact::Directions::pairs).
    pub const fn new(partners: [Partner; 2]) -> Self {
        Self { partners, stiffness: 0.0, gap_offset: 0.0, friction: 0.0 }
    }
}

impl<const D: usize> Gradients<D> {
    /// These, if all are finite.
    pub(crate) fn checked(self) -> Result<Self, Error> {
        let by_place = self.coords.iter().chain(&self.reference).chain(&self.positions).flatten();
        let by_place = by_place.chain(self.slip.iter().flat_map(|one| &one.slip));
        let by_pair = self.pairs.iter().flat_map(|pair| [pair.stiffness, pair.gap_offset, pair.friction]);
        let all = by_place.chain(self.rotations.iter().flatten()).copied().chain(by_pair);
        match all.into_iter().find(|x| !x.is_finite()) {
            Some(value) => Err(Error::Overflow { quantity: "derivative", value }),
            None => Ok(self),
        }
    }
}

impl<const D: usize> OntoNodes for Gradients<D> {
    fn onto_nodes(mut self, division: &Division) -> Self {
        for list in [&mut self.coords, &mut self.reference] {
            if !list.is_empty() {
                *list = division.map().onto_nodes(list);
            }
        }
        self
    }
}
