//! From coordinates to overlaps.

use crate::Error;
use crate::contact::evaluation::kernels::{estimator, pair_law};
use crate::contact::evaluation::{State, Turns, kernels};
use crate::contact::friction::{FrozenFriction, Step};
use crate::contact::laws::PairLaw;
use crate::contact::method::Options;
use crate::contact::multipliers::Multipliers;
use crate::contact::partners::{PairTable, Rigid};
use crate::contact::results::{ContactForces, GapConstraints, NodalContact, PointOfContact};
use crate::contact::tangents::{Tangent, TangentPart};
use crate::contact::work::Workers;
use crate::depth_field::DepthField;
use crate::geometry::{Basis, BoundaryFacet, PointWeights, Surface};
use crate::overlap::{FiberTrace, Overlap, PairEstimator, Partner, Patches};
use crate::ranks::Ranks;
use std::sync::{Mutex, OnceLock};

/// Contact between the bodies of one mesh, and with rigid obstacles.
///
/// It holds topology, obstacles and options, and keeps search trees and what was found at the last coordinates for the
/// next evaluation. No result depends on what is kept: two evaluations at the same coordinates give the same bits, and
/// [`contact_force`](crate::contact_force) gives the same bits as a `Contact` that is kept.
pub struct Contact<const D: usize> {
    pub(in crate::contact) surface: Surface<D>,
    /// By index; `None` where one was removed.
    pub(in crate::contact) obstacles: Vec<Option<Rigid<D>>>,
    pub(in crate::contact) options: Options,
    /// Whether tangents have the rotations of the obstacles.
    pub(in crate::contact) obstacle_rotations: bool,
    pub(in crate::contact) workers: Option<Workers>,
    /// Those that share the work with this one.
    pub(in crate::contact) ranks: Option<Ranks>,
    pub(in crate::contact) estimator: PairEstimator<D>,
    /// Of the pairs that have none of their own.
    pub(in crate::contact) law: Box<dyn PairLaw<D>>,
    pub(in crate::contact) pair_table: PairTable<D>,
    /// Patches of the fiber law that are kept, by pair.
    pub(in crate::contact) kept: Vec<([Partner; 2], Patches<D>)>,
    /// When patches were kept and friction was frozen, for meshes that are given in parts.
    pub(in crate::contact) turns: Turns<D>,
    /// Where the step began, once one has begun.
    pub(in crate::contact) step: Option<Step<D>>,
    /// Facets and pressures at which friction is frozen.
    pub(in crate::contact) frozen: Option<FrozenFriction<D>>,
    /// How far surfaces are moved out so that they press without penetration.
    pub(in crate::contact) multipliers: Multipliers<D>,
    pub(in crate::contact) state: Mutex<Option<Box<State<D>>>>,
    /// Whether a node lies in a plane of symmetry; `None` where that was not said.
    pub(in crate::contact) in_symmetry_plane: Option<Vec<bool>>,
    /// Depth of the cells, found when it is asked for first.
    pub(in crate::contact) depth: OnceLock<Option<DepthField<D>>>,
}

impl<const D: usize> Contact<D> {
    /// Contact between the bodies of `surface`.
    ///
    /// # Errors
    /// [`Error::NotPositive`] for an option out of its range; [`Error::Threads`]; [`Error::Unsupported`] for options
    /// that exclude one another, and for the law `depth` between bodies that are given by facets.
    pub fn new(surface: Surface<D>, options: Options) -> Result<Self, Error> {
        options.check()?;
        check_axisymmetry::<D>(&options)?;
        check_depth(&surface, &options)?;
        Ok(Self {
            surface,
            obstacles: Vec::new(),
            options,
            obstacle_rotations: false,
            workers: Workers::new(options.threads)?,
            ranks: None,
            estimator: estimator(&options)?,
            law: pair_law(&options.law)?,
            pair_table: PairTable::new(),
            kept: Vec::new(),
            turns: Turns::default(),
            step: None,
            frozen: None,
            multipliers: Multipliers::default(),
            state: Mutex::new(None),
            in_symmetry_plane: None,
            depth: OnceLock::new(),
        })
    }

    /// Sets the coordinates of all nodes without deformation, from which the law `depth` has its depths; those from which
    /// the surface was made are the default.
    ///
    /// # Errors
    /// [`Error::Unsupported`] for a surface without cells, [`Error::Length`], [`Error::NonFiniteCoordinate`],
    /// [`Error::InvertedCell`], [`Error::ZeroMeasure`]; the old ones then stay.
    pub fn set_reference(&mut self, coords: &[[f64; D]]) -> Result<(), Error> {
        self.surface.refuse_submesh("reference coordinates of a part of a mesh by itself")?;
        self.surface.set_reference(coords)?;
        self.depth = OnceLock::new();
        Ok(())
    }

    /// Has the nodes of the mesh moved by a host's own unknowns, `None`: by themselves again. Coordinates are then those of the
    /// unknowns, and so are forces, tangents, masses, and the columns of gap constraints; the mesh and its coordinates without
    /// deformation stay, and so do the nodes of nodal fields and those in planes of symmetry. What was begun, kept or frozen
    /// stays too.
    ///
    /// # Errors
    /// [`Error::Length`] for arrays of other lengths than the rows say, [`Error::UnknownOutOfRange`], [`Error::Overflow`] for a
    /// weight that is not finite, [`Error::Unsupported`] for rows that do not begin at 0 or descend; nothing changes then.
    pub fn set_basis(&mut self, basis: Option<&Basis>) -> Result<(), Error> {
        self.surface.refuse_submesh("unknowns that move a part of a mesh")?;
        self.surface.set_basis(basis)
    }

    /// Names the nodes that lie in planes of symmetry: for the law `depth` a face all of whose nodes are named is no
    /// surface, since the body goes on behind it, and its depth does not vanish there. Of a face of second order those in
    /// the middles of its edges, and its own, are named too. The host holds such nodes in
    /// their plane. Replaces what was named before. With none, all of the surface is surface, and flush faces are not warned
    /// of.
    ///
    /// # Errors
    /// [`Error::NodeOutOfRange`], naming the index in `nodes` as its cell; [`Error::Unsupported`] for a body that would
    /// have no surface left. What was named before then stays.
    pub fn set_symmetry_nodes(&mut self, nodes: &[u32]) -> Result<(), Error> {
        self.surface.refuse_submesh("planes of symmetry of a part of a mesh by itself")?;
        let node_count = self.surface.node_count();
        let mut marked = vec![false; node_count];
        for (cell, &node) in nodes.iter().enumerate() {
            let mark = marked.get_mut(node as usize);
            *mark.ok_or(Error::NodeOutOfRange { cell, node: node.into(), node_count })? = true;
        }
        let mut has_surface = vec![false; self.surface.body_count()];
        for (body, nodes) in self.surface.faces() {
            has_surface[body] |= !nodes.iter().all(|&n| marked[n as usize]);
        }
        if has_surface.contains(&false) {
            return Err(Error::Unsupported { what: "a body whose whole surface lies in planes of symmetry" });
        }
        self.mark_symmetry(marked);
        Ok(())
    }

    /// The same by node.
    pub(crate) fn mark_symmetry(&mut self, mut marked: Vec<bool>) {
        if let Some(division) = self.surface.division() {
            let map = &division.interpolation;
            let of_point = |point| map.row(point).all(|(node, _)| marked[node as usize]);
            marked = (0..map.point_count()).map(of_point).collect();
        }
        self.in_symmetry_plane = Some(marked);
        self.depth = OnceLock::new();
    }

    /// Replaces the options, not those that pairs have of their own ([`Self::set_pair_options`]). Kept patches stay kept with another law, and are released with another estimator.
    ///
    /// # Errors
    /// As [`Self::new`]; [`Error::OfPair`] where the estimator does not support the law of a pair. The old options then
    /// stay in force.
    pub fn set_options(&mut self, options: Options) -> Result<(), Error> {
        options.check()?;
        check_axisymmetry::<D>(&options)?;
        check_depth(&self.surface, &options)?;
        self.pair_table.check(&options)?;
        self.check_beside_multipliers(&options.law, options.friction.is_active() || options.self_contact)?;
        if options.threads != self.options.threads {
            self.workers = Workers::new(options.threads)?;
        }
        if options.estimator != self.options.estimator {
            self.release_patches();
            self.estimator = estimator(&options)?;
        }
        self.law = pair_law(&options.law)?;
        if options.axisymmetric != self.options.axisymmetric {
            self.release_patches();
            self.depth = OnceLock::new();
        }
        let old = std::mem::replace(&mut self.options, options);
        let bears_as = |options: &Options| {
            let Options { law, estimator, axisymmetric, friction, .. } = *options;
            (std::mem::discriminant(&law), estimator, axisymmetric, friction.is_active(), friction.cohesion > 0.0)
        };
        if bears_as(&old) != bears_as(&options) {
            self.forget_bearings();
        }
        self.forget_found();
        Ok(())
    }

    /// The options in force.
    pub fn options(&self) -> &Options {
        &self.options
    }

    /// The surface.
    pub fn surface(&self) -> &Surface<D> {
        &self.surface
    }

    /// The boundary facets, in the order in which [`Self::slip`] has them.
    pub fn boundary_facets(&self) -> Vec<BoundaryFacet> {
        self.surface.boundary_facets()
    }

    /// The points of which [`Self::boundary_facets`], [`Self::contact_points`] and [`Self::gap_constraints`] tell, as
    /// combinations of nodes: more than the nodes where there are cells of second order, else the nodes themselves. With a
    /// basis ([`Self::set_basis`]) they are combinations of its unknowns.
    pub fn point_weights(&self) -> PointWeights {
        self.surface.point_weights()
    }

    /// Contact forces at `coords`, `[node_count, D]`.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::NonFiniteCoordinate`], [`Error::InvertedCell`], [`Error::ZeroMeasure`],
    /// [`Error::TooManyFibers`], [`Error::TooManyPieces`], [`Error::Unsupported`], [`Error::SignedDistance`],
    /// [`Error::UnfinishedLines`], [`Error::Overflow`]; with friction [`Error::NoStep`].
    pub fn evaluate(&self, coords: &[[f64; D]]) -> Result<ContactForces<D>, Error> {
        kernels::evaluate(self, coords)
    }

    /// The same of the true surfaces where multipliers have moved them out ([`Self::augment`]): no forces of the contact then, but its
    /// penetration.
    ///
    /// # Errors
    /// As [`Self::evaluate`].
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
    pub fn tangent(&self, coords: &[[f64; D]], part: TangentPart) -> Result<Tangent<D>, Error> {
        kernels::tangent(self, coords, part)
    }

    /// Forces and tangent at `coords` in one call: the bits of [`Self::evaluate`] and [`Self::tangent`], in little more
    /// than the time of the tangent alone, since bodies are measured once.
    ///
    /// # Errors
    /// As [`Self::tangent`].
    pub fn evaluate_with_tangent(
        &self,
        coords: &[[f64; D]],
        part: TangentPart,
    ) -> Result<(ContactForces<D>, Tangent<D>), Error> {
        kernels::evaluate_with_tangent(self, coords, part)
    }

    /// Overlaps of all overlapping pairs at `coords`, with their gradients, ordered by pair. With the fiber law they
    /// are measured along its lines.
    ///
    /// # Errors
    /// As [`Self::evaluate`].
    pub fn overlaps(&self, coords: &[[f64; D]]) -> Result<Vec<Overlap<D>>, Error> {
        kernels::overlaps(self, coords)
    }

    /// Pressure, gap, area and normal at every node at `coords`, and friction with the current pressure.
    ///
    /// # Errors
    /// As [`Self::evaluate`].
    pub fn nodal_contact(&self, coords: &[[f64; D]]) -> Result<NodalContact<D>, Error> {
        kernels::nodal_contact(self, coords)
    }

    /// The contact points at `coords`, in the order of the pairs: where the laws `fiber` and `depth` press, with pressure,
    /// area and both sides of each, and what friction does there with the current pressure. Empty with the law `volume`,
    /// which has one pressure for a whole pair, unless friction acts.
    ///
    /// # Errors
    /// As [`Self::evaluate`].
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
    pub fn gap_constraints(&self, coords: &[[f64; D]], reach: f64) -> Result<GapConstraints<D>, Error> {
        if !(reach.is_finite() && reach > 0.0) {
            return Err(Error::NotPositive { name: "reach", value: reach });
        }
        kernels::gap_constraints(self, coords, reach)
    }

    /// Lines to look at: with the law `fiber` those from which its forces come; with the law `volume` the fibers that
    /// cross an overlap, none for `exact`.
    ///
    /// # Errors
    /// As [`Self::evaluate`].
    pub fn trace(&self, coords: &[[f64; D]]) -> Result<Vec<FiberTrace<D>>, Error> {
        kernels::trace(self, coords)
    }
}

/// Axisymmetry is that of coordinates (r, z).
fn check_axisymmetry<const D: usize>(options: &Options) -> Result<(), Error> {
    match D {
        3 if options.axisymmetric => Err(Error::Unsupported { what: "axisymmetry in 3D: its coordinates are (r, z)" }),
        _ => Ok(()),
    }
}

/// Refuses at once what no evaluation could measure: depth is that of cells.
fn check_depth<const D: usize>(surface: &Surface<D>, options: &Options) -> Result<(), Error> {
    let between_bodies = surface.body_count() > 1 || options.self_contact;
    if options.law.needs_depth() && between_bodies && surface.cells.is_none() {
        let what = "the law depth between bodies given by facets, since depth is that of cells: give cells, or set the \
                    law fiber or volume";
        return Err(Error::Unsupported { what });
    }
    let is_rubbed = options.friction.is_active() && !options.law.needs_depth() && !options.law.is_fiber();
    if is_rubbed && between_bodies && surface.cells.is_none() {
        let what = "friction with the law volume between bodies given by facets: give cells, or set the law fiber";
        return Err(Error::Unsupported { what });
    }
    Ok(())
}
