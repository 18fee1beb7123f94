//! Derivatives for hosts that optimise, identify or learn.

use crate::Error;
use crate::contact::changes::friction_steps::carried_of;
use crate::contact::derivatives::{Along, Directions, GradientRequest, Gradients, SlipSeeds, Slopes};
use crate::contact::evaluation::{Contact, kernels};
use crate::contact::friction::FacetSlip;

impl<const D: usize> Contact<D> {
    /// The derivatives of `energy` · w + `adjoint` · F, by what `request` names: w is the contact energy and F are the nodal forces at
    /// `coords`, friction included, which is no part of w. An `adjoint` of `None` is zero, else it has the shape of `coords`.
    ///
    /// All are exact, and partial: each with all else held. With friction the slip at the start of the step is held; it has a
    /// derivative of its own. Where a
    /// depth has a kink, at equal distance from two faces, it is the derivative on one side.
    ///
    /// # Errors
    /// As [`Self::tangent`]; [`Error::Length`] and [`Error::NonFiniteStiffness`] for the adjoint; [`Error::Unsupported`] for a
    /// derivative that is not known. By coordinates and poses: with the law `fiber` unless patches are kept; of sampled energies unless
    /// weights are consistent and `momentum_correction` is off; of forces that are sampled, between curved faces in 3D, and frictional
    /// unless friction is frozen. By the reference: with axisymmetry, friction, curved faces, hanging nodes, ranks, and of forces with
    /// a gap offset between bodies. By gap offset: of frictional forces; by stiffness: of these with cohesion or a shear limit, or
    /// frozen. By slip: with static friction, or frozen. By gap offsets: of pairs other than bodies with half-spaces. By the
    /// coefficient of friction: where it is 0, and with static friction, cohesion or a shear limit, or another coefficient across a
    /// direction. By rotations: with the law `fiber`, and with axisymmetry.
    #[inline(never)]
    pub fn vjp(
        &self,
        coords: &[[f64; D]],
        energy: f64,
        adjoint: Option<&[[f64; D]]>,
        request: &GradientRequest,
    ) -> Result<Gradients<D>, Error> {
        self.vjp_of_step(coords, energy, adjoint, &[], request)
    }

    /// The same with a term more: `slip` · s, where s is the elastic slip that [`Self::commit_step`] at these coordinates would carry on, and
    /// `slip` has rows as [`Self::slip`] has them; a facet that is not in contact carries nothing. With the derivative by the slip at the
    /// start of a step it goes back from step to step.
    ///
    /// # Errors
    /// As [`Self::vjp`]; [`Error::NoStep`], [`Error::NoSuchRow`] and [`Error::NonFiniteSlip`] for `slip`. [`Error::Unsupported`] for its
    /// derivative by coordinates, poses and gap offsets.
    #[inline(never)]
    pub fn vjp_of_step(
        &self,
        coords: &[[f64; D]],
        energy: f64,
        adjoint: Option<&[[f64; D]]>,
        slip: &[FacetSlip<D>],
        request: &GradientRequest,
    ) -> Result<Gradients<D>, Error> {
        if let Some(adjoint) = adjoint
            && adjoint.len() != self.mesh.surface.unknown_count()
        {
            let expected = self.mesh.surface.unknown_count();
            return Err(Error::Length { array: "adjoint", expected, found: adjoint.len() });
        }
        if !energy.is_finite() {
            return Err(Error::NonFiniteStiffness { array: "energy", entry: 0 });
        }
        let seeds = self.by_slider(slip)?;
        let adjoint = adjoint.map_or(&[][..], |adjoint| adjoint.as_flattened());
        kernels::gradients(self, coords, energy, adjoint, &seeds, request)
    }

    /// Rates of energy and nodal forces at `coords` along rates of what they depend on, the transpose of [`Self::vjp`]: friction is no part
    /// of the energy, and with it the slip at the start of the step moves only as `along` says.
    ///
    /// # Errors
    /// As [`Self::vjp`] with an adjoint, for what moves; [`Error::Length`] and [`Error::NonFiniteStiffness`] for rates;
    /// [`Error::NoSuchRow`] for pairs, and as [`Self::vjp_of_step`] for the slip.
    #[inline(never)]
    pub fn jvp(&self, coords: &[[f64; D]], along: &Directions<D>) -> Result<Slopes<D>, Error> {
        let slip = self.by_slider(along.slip)?;
        let surface = &self.mesh.surface;
        let counts = (surface.unknown_count(), surface.ranges.len(), self.partners.obstacles.count());
        kernels::slopes(self, coords, &Along::new(along, &slip, counts)?)
    }

    fn by_slider(&self, slip: &[FacetSlip<D>]) -> Result<SlipSeeds, Error> {
        let padded = |slip: &[f64; D]| std::array::from_fn(|axis| slip.get(axis).copied().unwrap_or(0.0));
        Ok(match slip {
            [] => SlipSeeds::new(),
            _ => carried_of(self, slip)?.into_iter().map(|(name, one)| (name, padded(&one.slip.into()))).collect(),
        })
    }
}
