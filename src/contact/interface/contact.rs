//! What hosts call: each function hands on to the part of the contact that it concerns.

use crate::Error;
use crate::contact::changes;
use crate::contact::evaluation::{Contact, assemble, kernels};
use crate::contact::method::Options;
use crate::contact::partners::PairOptions;
use crate::contact::results::{ContactForces, GapConstraints, NodalContact, PointOfContact};
use crate::contact::tangents::{Tangent, TangentPart};
use crate::geometry::boundary::symmetry::SymmetryPlane;
use crate::geometry::{Basis, BoundaryFacet, PointWeights, Surface};
use crate::overlap::{FiberTrace, Overlap, Partner};
use crate::ranks::{Asked, Communicator, RankCounts};

impl<const D: usize> Contact<D> {
    /// Contact between the bodies of `surface`.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for an option out of its range; [`Error::Threads`]; [`Error::Unsupported`] for options
    /// that exclude one another, and for the law `depth` between bodies that are given by facets.
    #[inline(never)]
    pub fn new(surface: Surface<D>, options: Options) -> Result<Self, Error> {
        assemble(surface, options)
    }

    /// The surface.
    pub fn surface(&self) -> &Surface<D> {
        &self.mesh.surface
    }

    /// The boundary facets, in the order in which [`Self::slip`] has them.
    pub fn boundary_facets(&self) -> Vec<BoundaryFacet> {
        self.mesh.surface.boundary_facets()
    }

    /// The points of which [`Self::boundary_facets`], [`Self::contact_points`] and [`Self::gap_constraints`] tell, as
    /// combinations of nodes: more than the nodes where there are cells of second order, else the nodes themselves. With a
    /// basis ([`Self::set_basis`]) they are combinations of its unknowns.
    pub fn point_weights(&self) -> PointWeights {
        self.mesh.surface.point_weights()
    }

    /// Sets the coordinates of all nodes without deformation, from which the law `depth` has its depths; those from which
    /// the surface was made are the default.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for a surface without cells, [`Error::Length`], [`Error::NonFiniteCoordinate`],
    /// [`Error::InvertedCell`], [`Error::ZeroMeasure`]; the old ones then stay.
    #[inline(never)]
    pub fn set_reference(&mut self, coords: &[[f64; D]]) -> Result<(), Error> {
        changes::options::set_reference(self, coords)
    }

    /// Has the nodes of the mesh moved by a host's own unknowns, `None`: by themselves again. Coordinates are then those of the
    /// unknowns, and so are forces, tangents, masses, and the columns of gap constraints; the mesh and its coordinates without
    /// deformation stay, and so do the nodes of nodal fields and those in planes of symmetry. What was begun, kept or frozen
    /// stays too.
    ///
    /// # Errors
    /// [`Error::Length`] for arrays of other lengths than the rows say, [`Error::UnknownOutOfRange`], [`Error::Overflow`] for a
    /// weight that is not finite, [`Error::Unsupported`] for rows that do not begin at 0 or descend; nothing changes then.
    #[inline(never)]
    pub fn set_basis(&mut self, basis: Option<&Basis>) -> Result<(), Error> {
        self.mesh.set_basis(basis)
    }

    /// Says where planes of symmetry are, each by a point in it and a normal: for the law `depth` a face without deformation in one of
    /// them is no surface, since the body goes on behind it, and its depth does not vanish there. The host holds the nodes of such
    /// faces in their plane. Replaces what was said before, by planes or by nodes. With none, all of the surface is surface, and flush
    /// faces are not warned of.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for a normal without length; [`Error::Unsupported`] for a body that would have no surface left. What was
    /// said before then stays.
    #[inline(never)]
    pub fn set_symmetry_planes(&mut self, planes: &[[[f64; D]; 2]]) -> Result<(), Error> {
        let planes = planes.iter().map(|[point, normal]| SymmetryPlane::new(point, normal));
        self.mesh.set_symmetry_planes(&planes.collect::<Result<Vec<_>, _>>()?)
    }

    /// Names the nodes that lie in planes of symmetry, as [`Self::set_symmetry_planes`] does by planes: those in which the faces lie all of
    /// whose nodes are named, the fewest that hold all these nodes. A face of the contact surface in a corner between two planes is
    /// none. Of a face of second order those in the middles of its edges, and its own, are named too.
    ///
    /// # Errors
    /// [`Error::NodeOutOfRange`], naming the index in `nodes` as its cell; [`Error::Unsupported`] for a body that would
    /// have no surface left, or for nodes of a curved surface. What was named before then stays.
    #[inline(never)]
    pub fn set_symmetry_nodes(&mut self, nodes: &[u32]) -> Result<(), Error> {
        self.mesh.set_symmetry_nodes(nodes)
    }

    /// The options in force.
    pub fn options(&self) -> &Options {
        self.method.options()
    }

    /// Replaces the options, not those that pairs have of their own ([`Self::set_pair_options`]). Kept patches stay kept with another law, and are released with another estimator.
    /// Frozen friction is released with other friction, that of bodies with themselves without self-contact, and both with or without
    /// axisymmetry.
    ///
    /// # Errors
    /// As [`Self::new`]; [`Error::OfPair`] where the estimator does not support the law of a pair. The old options then
    /// stay in force.
    #[inline(never)]
    pub fn set_options(&mut self, options: Options) -> Result<(), Error> {
        changes::options::set(self, options)
    }

    /// The options of a pair, in either order; `None` where it follows those of the contact.
    ///
    /// # Errors
    /// [`Error::BodyOutOfRange`], [`Error::ObstacleOutOfRange`], [`Error::ObstacleRemoved`]; [`Error::Unsupported`] for two obstacles.
    #[inline(never)]
    pub fn pair_options(&self, partners: [Partner; 2]) -> Result<Option<PairOptions>, Error> {
        let pair = self.partners.checked_pair(partners, self.mesh.surface.body_count())?;
        let options = self.partners.table.options(&pair);
        Ok(if pair == partners { options } else { options.map(PairOptions::swapped) })
    }

    /// Sets the options of a pair, body with body or body with obstacle, in either order; `None`: it follows the options
    /// of the contact again, as every pair does at first.
    ///
    /// For a body with itself they decide in place of `Options::self_contact` whether it is evaluated against itself:
    /// `excluded` switches that off for this body, and anything else on.
    ///
    /// Frozen friction is released with other friction; of a pair that is left out or rubs no more that of the pair alone. Surfaces that
    /// multipliers have moved out against a partner that is left out are moved back.
    ///
    /// Kept patches stay kept, and patches of a pair that gets a local law later are found at every evaluation, until
    /// [`Self::keep_patches`] is called again.
    ///
    /// # Errors
    /// [`Error::BodyOutOfRange`], [`Error::ObstacleOutOfRange`], [`Error::ObstacleRemoved`]; [`Error::Unsupported`] for two obstacles, which do not
    /// act on one another; [`Error::OfPair`] for a value out of its range, a law that the estimator does not
    /// support, or a gap offset between bodies that is positive or has another law than `depth`. The old options then stay.
    #[inline(never)]
    pub fn set_pair_options(&mut self, partners: [Partner; 2], options: Option<PairOptions>) -> Result<(), Error> {
        changes::options::set_pair(self, partners, options, (None, None))
    }

    /// Contact forces at `coords`, `[node_count, D]`.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::NonFiniteCoordinate`], [`Error::InvertedCell`], [`Error::ZeroMeasure`],
    /// [`Error::TooManyFibers`], [`Error::TooManyPieces`], [`Error::Unsupported`], [`Error::SignedDistance`],
    /// [`Error::UnfinishedLines`], [`Error::Overflow`]; with friction [`Error::NoStep`].
    #[inline(never)]
    pub fn evaluate(&self, coords: &[[f64; D]]) -> Result<ContactForces<D>, Error> {
        kernels::evaluate(self, coords)
    }

    /// The same of the true surfaces where multipliers have moved them out ([`Self::augment`]): no forces of the contact then, but its
    /// penetration.
    ///
    /// # Errors
    /// As [`Self::evaluate`].
    #[inline(never)]
    pub fn evaluate_true(&self, coords: &[[f64; D]]) -> Result<ContactForces<D>, Error> {
        kernels::evaluate_true(self, coords)
    }

    /// Second derivative of the contact energy at `coords`.
    ///
    /// For the fiber law on kept patches and for the volume law with the exact estimator or consistent weights it is
    /// the derivative of the forces, with `momentum_correction` off; the momentum correction, which is small, is not
    /// differentiated. With balance weights it is that of consistent ones. The exact volume law has no finite tangent
    /// where facets coincide.
    ///
    /// # Errors
    /// As [`Self::evaluate`]; [`Error::Unsupported`] for isotropic fibers, and for the exact volume law with a body
    /// against itself.
    #[inline(never)]
    pub fn tangent(&self, coords: &[[f64; D]], part: TangentPart) -> Result<Tangent<D>, Error> {
        kernels::tangent(self, coords, part)
    }

    /// Forces and tangent at `coords` in one call: the bits of [`Self::evaluate`] and [`Self::tangent`], in little more
    /// than the time of the tangent alone, since bodies are measured once.
    ///
    /// # Errors
    /// As [`Self::tangent`].
    #[inline(never)]
    pub fn evaluate_tangent(
        &self,
        coords: &[[f64; D]],
        part: TangentPart,
    ) -> Result<(ContactForces<D>, Tangent<D>), Error> {
        kernels::evaluate_tangent(self, coords, part)
    }

    /// Largest time step of central differences (leapfrog) for the contact alone, 2/√λ, where λ is a bound of the
    /// largest eigenvalue of M⁻¹K: K is the full tangent at `coords` ([`Self::tangent`]), M are `masses`, one lumped
    /// mass per node. The step lies up to 3 % below its limit, and 6 % where other eigenvalues are negative and a hundred
    /// times as large. Obstacles are held; so is a node of infinite mass. Infinite where nothing touches.
    ///
    /// A host whose own limit is Δt_host is stable with the step 1/Δt² = 1/Δt_host² + 1/Δt_contact², since the largest
    /// eigenvalue of a sum of symmetric matrices is at most the sum of the largest. The limit is that of the motion
    /// linearised at `coords`: contact that begins within a step is not in it, nor is a force that jumps (law `volume`
    /// with exponent below 2).
    ///
    /// # Errors
    /// As [`Self::tangent`]; [`Error::Length`] for masses of another number than the nodes,
    /// [`Error::NotPositiveMass`] for a node that feels contact.
    #[inline(never)]
    pub fn stable_step(&self, coords: &[[f64; D]], masses: &[f64]) -> Result<f64, Error> {
        kernels::stable_step(self, coords, masses)
    }

    /// Overlaps of all overlapping pairs at `coords`, with their gradients, ordered by pair. With the fiber law they
    /// are measured along its lines.
    ///
    /// # Errors
    /// As [`Self::evaluate`].
    #[inline(never)]
    pub fn overlaps(&self, coords: &[[f64; D]]) -> Result<Vec<Overlap<D>>, Error> {
        kernels::overlaps(self, coords)
    }

    /// Pressure, gap, area and normal at every node at `coords`, and friction with the current pressure.
    ///
    /// # Errors
    /// As [`Self::evaluate`].
    #[inline(never)]
    pub fn nodal_contact(&self, coords: &[[f64; D]]) -> Result<NodalContact<D>, Error> {
        kernels::nodal_contact(self, coords)
    }

    /// The contact points at `coords`, in the order of the pairs: where the laws `fiber` and `depth` press, with pressure,
    /// area and both sides of each, and what friction does there with the current pressure. Empty with the law `volume`,
    /// which has one pressure for a whole pair, unless friction acts.
    ///
    /// # Errors
    /// As [`Self::evaluate`].
    #[inline(never)]
    pub fn contact_points(&self, coords: &[[f64; D]]) -> Result<Vec<PointOfContact<D>>, Error> {
        kernels::contact_points(self, coords)
    }

    /// Weighted gaps of the nodes over partners nearer than `reach`, apart or overlapping, with their derivatives: what an
    /// augmented Lagrangian, an interior point method or a preconditioner asks for. They depend on no law and no
    /// estimator; a body has no gaps over itself.
    ///
    /// By quadrature of degree 5 on every facet. The derivative is that of the sum where the nearest point of the partner
    /// is one.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for a reach that is not; else as [`Self::evaluate`].
    #[inline(never)]
    pub fn gap_constraints(&self, coords: &[[f64; D]], reach: f64) -> Result<GapConstraints<D>, Error> {
        kernels::gap_constraints(self, coords, reach)
    }

    /// Lines to look at: with the law `fiber` those from which its forces come; with the law `volume` the fibers that
    /// cross an overlap, none for `exact`.
    ///
    /// # Errors
    /// As [`Self::evaluate`].
    #[inline(never)]
    pub fn trace(&self, coords: &[[f64; D]]) -> Result<Vec<FiberTrace<D>>, Error> {
        kernels::trace(self, coords)
    }

    /// Shares the work of evaluations with other ranks, `None`: no more. From then on every rank makes the same calls with the
    /// same coordinates, options, obstacles and history, and gets the whole result, with the bits of one rank alone. Threads
    /// may differ. Pairs with a signed distance function are measured on every rank.
    ///
    /// Where an evaluation fails on one rank it fails on all. Where ranks were given different things, all are told.
    ///
    /// # Errors
    /// [`Error::BadRank`]; what was set before then stays.
    #[inline(never)]
    pub fn set_communicator(&mut self, communicator: Option<Box<dyn Communicator>>) -> Result<(), Error> {
        self.mesh.surface.refuse_submesh("another communicator for a mesh that is given in parts")?;
        self.work.set_communicator(communicator)
    }

    /// Takes a function that is asked some twenty times a second, on the thread that calls, whether what is computed is to end; `None`: no
    /// more. Where it says so the call gives [`Error::Interrupted`], and the contact is as it was before. It is asked while pairs are
    /// measured, lines laid and depths found, not within factorisations, and not where ranks share the work.
    pub fn set_interrupt(&mut self, asked: Option<Asked>) {
        self.work.set_interrupt(asked);
    }

    /// What was shared since the communicator was set; zeros without one.
    pub fn rank_counts(&self) -> RankCounts {
        self.work.rank_counts()
    }
}
