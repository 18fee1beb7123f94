//! A contact of one dimension, as the C interface sees it.

use super::session::Counts;
use crate::capi::boundary::failure::Failure;
use crate::capi::structs::boundary_facet::fmc_boundary_facet;
use crate::capi::structs::contact_point::fmc_contact_point;
use crate::capi::structs::evaluation::Evaluation;
use crate::capi::structs::gap_constraint::KeptGaps;
use crate::capi::structs::in_parts::InParts;
use crate::capi::structs::kept_tangent::Kept;
use crate::capi::structs::mesh::Numbering;
use crate::capi::structs::multiplier::fmc_multiplier;
use crate::capi::structs::nodal_lists::NodalLists;
use crate::capi::structs::placement::Placement;
use crate::capi::structs::pose::fmc_pose;
use crate::capi::structs::shape::fmc_shape;
use crate::capi::structs::view::{check_node_count, fmc_coords, fmc_forces};
use crate::contact::equilibrium::StepLimit;
use crate::contact::{Augmentation, CondensedBodies, ContactStep, ContactStepOptions, PairOptions, Place, TangentPart};
use crate::overlap::Partner;
use crate::{
    Basis, Communicator, Contact, ContactForces, Error, Obstacle, Options, PartitionedContact, PointWeights, Pose,
    RankCounts, ShapeKind, Surface,
};

const IN_PARTS: &str = "the equilibrium of a mesh in parts";

/// A contact, and room for coordinates that do not lie in dense rows.
pub(crate) struct Resident<const D: usize> {
    held: Held<D>,
    scratch: Vec<[f64; D]>,
}

/// A contact of a whole mesh, or of the part of one that ranks have gathered.
enum Held<const D: usize> {
    Whole(Box<Contact<D>>),
    InParts(Box<PartitionedContact<D>>),
}

impl<const D: usize> Held<D> {
    fn contact(&self) -> &Contact<D> {
        match self {
            Held::Whole(contact) => contact,
            Held::InParts(parts) => parts.contact(),
        }
    }

    fn contact_mut(&mut self) -> &mut Contact<D> {
        match self {
            Held::Whole(contact) => contact,
            Held::InParts(parts) => parts.contact_mut(),
        }
    }
}

impl<const D: usize> Resident<D> {
    pub(crate) fn new(surface: Surface<D>, options: Options) -> Result<Self, Failure> {
        Ok(Self { held: Held::Whole(Box::new(Contact::new(surface, options)?)), scratch: Vec::new() })
    }

    /// Of a mesh in parts.
    pub(crate) fn of_parts(parts: PartitionedContact<D>) -> Self {
        Self { held: Held::InParts(Box::new(parts)), scratch: Vec::new() }
    }

    /// Nodes that stand for obstacles in tangents: their translations, then, where asked for, their rotations.
    fn obstacle_nodes(&self) -> usize {
        self.held.contact().obstacle_count() * if self.held.contact().obstacle_rotations() { 2 } else { 1 }
    }

    /// What `work` makes of the contact at the host's coordinates.
    ///
    /// # Safety
    /// The host guarantees the view.
    unsafe fn at<T>(
        &mut self,
        coords: &fmc_coords,
        index_base: i32,
        work: impl FnOnce(&mut Contact<D>, &[[f64; D]]) -> Result<T, Error>,
    ) -> Result<T, Failure> {
        check_node_count(coords.node_count, self.held.contact().surface().unknown_count())?;
        // SAFETY: passed on to the caller.
        let rows = unsafe { coords.rows("coords", &mut self.scratch) }?;
        work(self.held.contact_mut(), rows).map_err(Failure::counted_from(index_base))
    }

    /// Evaluates by `work`, and writes the forces, if wanted, on success.
    ///
    /// # Safety
    /// The host guarantees both views.
    unsafe fn evaluated<T>(
        &mut self,
        coords: &fmc_coords,
        forces: Option<&fmc_forces>,
        add: bool,
        index_base: i32,
        work: impl FnOnce(&mut Contact<D>, &[[f64; D]]) -> Result<(ContactForces<D>, T), Error>,
    ) -> Result<(Evaluation, T), Failure> {
        let node_count = self.held.contact().surface().unknown_count();
        check_node_count(coords.node_count, node_count)?;
        let output = forces.map(|forces| forces.output::<D>(node_count)).transpose()?;
        // SAFETY: passed on to the caller.
        let (found, more) = unsafe { self.at(coords, index_base, work) }?;
        let evaluation = Evaluation::from(&found);
        if let Some(output) = output {
            // SAFETY: the output was checked for as many rows; the caller guarantees that it may be written.
            unsafe { output.write(&found.forces, add) };
        }
        Ok((evaluation, more))
    }
}

impl<const D: usize> Resident<D> {
    pub(crate) fn counts(&self) -> Counts {
        let surface = self.held.contact().surface();
        Counts {
            nodes: surface.node_count(),
            unknowns: surface.unknown_count(),
            facets: surface.facet_count(),
            bodies: surface.body_count(),
        }
    }

    /// The mesh in parts, if it is.
    pub(crate) fn parts(&self) -> Option<&dyn InParts> {
        match &self.held {
            Held::Whole(_) => None,
            Held::InParts(parts) => Some(&**parts),
        }
    }

    pub(crate) fn parts_mut(&mut self) -> Option<&mut dyn InParts> {
        match &mut self.held {
            Held::Whole(_) => None,
            Held::InParts(parts) => Some(&mut **parts),
        }
    }

    /// The contact, for a search that knows its dimension.
    ///
    /// # Errors
    /// `FMC_ERROR_UNSUPPORTED` for a mesh in parts.
    pub(crate) fn contact_mut(&mut self) -> Result<&mut Contact<D>, Failure> {
        match &mut self.held {
            Held::Whole(contact) => Ok(contact),
            Held::InParts(_) => Err(Error::Unsupported { what: IN_PARTS }.into()),
        }
    }

    /// The boundary facets.
    pub(crate) fn boundary_facets(&self, index_base: i32) -> Vec<fmc_boundary_facet> {
        let facets = self.held.contact().boundary_facets();
        facets.iter().map(|facet| fmc_boundary_facet::new(facet, index_base)).collect()
    }

    /// The points of which hosts are told, as combinations of nodes.
    pub(crate) fn point_weights(&self) -> PointWeights {
        self.held.contact().point_weights()
    }

    /// Has the nodes moved by unknowns, counted from zero, or by themselves.
    pub(crate) fn set_basis(&mut self, basis: Option<&Basis>) -> Result<(), Failure> {
        Ok(self.held.contact_mut().set_basis(basis)?)
    }

    pub(crate) fn set_options(&mut self, options: Options) -> Result<(), Failure> {
        Ok(self.held.contact_mut().set_options(options)?)
    }

    /// That of the law, as options and [`Self::stiffen`] have left it.
    pub(crate) fn stiffness(&self) -> f64 {
        self.held.contact().options().law.stiffness()
    }

    pub(crate) fn set_pose(&mut self, obstacle: usize, pose: fmc_pose) -> Result<(), Failure> {
        Ok(self.held.contact_mut().set_pose(obstacle, pose.to_pose())?)
    }

    pub(crate) fn remove_obstacle(&mut self, obstacle: usize) -> Result<(), Failure> {
        Ok(self.held.contact_mut().remove_obstacle(obstacle)?)
    }

    /// Shape and pose of an obstacle.
    pub(crate) fn obstacle(&self, obstacle: usize) -> Result<(ShapeKind, fmc_pose), Failure> {
        let found = self.held.contact().obstacle(obstacle)?;
        Ok((found.shape.kind(), (&found.pose).into()))
    }

    /// Sets the options of a pair; `None`: those of the contact.
    pub(crate) fn set_pair_options(
        &mut self,
        partners: [Partner; 2],
        options: Option<PairOptions>,
    ) -> Result<(), Failure> {
        Ok(self.held.contact_mut().set_pair_options(partners, options)?)
    }

    /// Options that hold for a pair.
    pub(crate) fn pair_options(&self, partners: [Partner; 2]) -> Result<PairOptions, Failure> {
        let is_left_out = partners[0] == partners[1] && !self.held.contact().options().self_contact;
        let by_default = PairOptions { excluded: is_left_out, ..PairOptions::default() };
        Ok(self.held.contact().pair_options(partners)?.unwrap_or(by_default))
    }

    /// Adds an obstacle and returns its index.
    pub(crate) unsafe fn add_obstacle(
        &mut self,
        shape: &fmc_shape,
        pose: fmc_pose,
        index_base: i32,
    ) -> Result<usize, Failure> {
        // SAFETY: passed on to the caller.
        let shape = unsafe { shape.read_shape(index_base) }?;
        let pose: Pose<D> = pose.to_pose();
        self.held.contact_mut().add_obstacle(Obstacle { shape, pose }).map_err(Failure::counted_from(index_base))
    }

    /// Sets the coordinates without deformation.
    pub(crate) unsafe fn set_reference(&mut self, coords: &fmc_coords, index_base: i32) -> Result<(), Failure> {
        // SAFETY: passed on to the caller.
        unsafe { self.at(coords, index_base, |contact, rows| contact.set_reference(rows)) }
    }

    /// Names the nodes in planes of symmetry, as the host counts them.
    pub(crate) fn set_symmetry_nodes(&mut self, nodes: &[i64], index_base: i32) -> Result<(), Failure> {
        let node_count = match &self.held {
            Held::Whole(contact) => contact.surface().node_count(),
            Held::InParts(parts) => parts.own_node_count(),
        };
        let nodes = Numbering { index_base, node_count }.zero_based(nodes, 1, 0)?;
        let named = match &mut self.held {
            Held::Whole(contact) => contact.set_symmetry_nodes(&nodes),
            Held::InParts(parts) => parts.set_symmetry_nodes(&nodes),
        };
        named.map_err(Failure::counted_from(index_base))
    }

    /// Begins a step with friction.
    pub(crate) unsafe fn begin_step(&mut self, coords: &fmc_coords, index_base: i32) -> Result<(), Failure> {
        // SAFETY: passed on to the caller.
        unsafe { self.at(coords, index_base, |contact, rows| contact.begin_step(rows)) }
    }

    /// Accepts it.
    pub(crate) unsafe fn commit_step(&mut self, coords: &fmc_coords, index_base: i32) -> Result<(), Failure> {
        // SAFETY: passed on to the caller.
        unsafe { self.at(coords, index_base, |contact, rows| contact.commit_step(rows)) }
    }

    /// Freezes friction at these coordinates, or releases it.
    pub(crate) unsafe fn freeze_friction(
        &mut self,
        coords: Option<&fmc_coords>,
        index_base: i32,
    ) -> Result<(), Failure> {
        let Some(coords) = coords else {
            self.held.contact_mut().release_friction();
            return Ok(());
        };
        // SAFETY: passed on to the caller.
        unsafe { self.at(coords, index_base, |contact, rows| contact.freeze_friction(rows)) }
    }

    /// The elastic slip that was carried into the step, facet by facet.
    pub(crate) fn slip(&self) -> Result<&[f64], Failure> {
        Ok(self.held.contact().slip()?.as_flattened())
    }

    /// Sets it.
    pub(crate) fn set_slip(&mut self, slip: &[f64]) -> Result<(), Failure> {
        let (rows, _) = slip.as_chunks::<D>();
        Ok(self.held.contact_mut().set_slip(rows)?)
    }

    /// Shares the work with other ranks, or with none.
    pub(crate) fn set_communicator(&mut self, communicator: Option<Box<dyn Communicator>>) -> Result<(), Failure> {
        Ok(self.held.contact_mut().set_communicator(communicator)?)
    }

    /// What was shared.
    pub(crate) fn rank_counts(&self) -> RankCounts {
        self.held.contact().rank_counts()
    }

    /// Whether tangents have the rotations of the obstacles.
    pub(crate) fn set_obstacle_rotations(&mut self, on: bool) {
        self.held.contact_mut().set_obstacle_rotations(on);
    }

    /// Keeps the patches at these coordinates, or none; returns the number of directions.
    pub(crate) unsafe fn keep_patches(
        &mut self,
        coords: Option<&fmc_coords>,
        index_base: i32,
    ) -> Result<usize, Failure> {
        let Some(coords) = coords else {
            self.held.contact_mut().release_patches();
            return Ok(0);
        };
        // SAFETY: passed on to the caller.
        unsafe { self.at(coords, index_base, |contact, rows| contact.keep_patches(rows)) }
    }

    /// Second derivative of the energy.
    pub(crate) unsafe fn tangent(
        &mut self,
        coords: &fmc_coords,
        part: TangentPart,
        index_base: i32,
    ) -> Result<Kept, Failure> {
        // SAFETY: passed on to the caller.
        let tangent = unsafe { self.at(coords, index_base, |contact, rows| contact.tangent(rows, part)) }?;
        Ok(Kept::new(&tangent, coords.node_count, self.obstacle_nodes()))
    }

    /// Largest time step of central differences.
    pub(crate) unsafe fn stable_step(
        &mut self,
        coords: &fmc_coords,
        masses: &[f64],
        index_base: i32,
    ) -> Result<f64, Failure> {
        // SAFETY: passed on to the caller.
        unsafe { self.at(coords, index_base, |contact, rows| contact.stable_step(rows, masses)) }
    }

    /// How far a step may go.
    pub(crate) unsafe fn step_limit(
        &mut self,
        coords: &fmc_coords,
        step: &fmc_coords,
        index_base: i32,
    ) -> Result<StepLimit, Failure> {
        check_node_count(step.node_count, self.held.contact().surface().unknown_count())?;
        let mut scratch = Vec::new();
        // SAFETY: passed on to the caller.
        unsafe {
            let step = step.rows("step", &mut scratch)?;
            self.at(coords, index_base, |contact, rows| contact.step_limit(rows, step))
        }
    }

    /// Equilibrium with condensed bodies.
    pub(crate) unsafe fn contact_step(
        &mut self,
        coords: &fmc_coords,
        bodies: &CondensedBodies,
        options: &ContactStepOptions,
        placement: Option<Placement>,
        index_base: i32,
    ) -> Result<ContactStep, Failure> {
        let mut place = placement.map(|placement| {
            move |displacement: &[f64], coords: &mut [[f64; D]]| {
                // SAFETY: the host guarantees the function.
                unsafe { placement.call(displacement, coords.as_flattened_mut()) }
            }
        });
        let place: Option<Place<D>> = place.as_mut().map(|place| place as Place<D>);
        // SAFETY: passed on to the caller.
        unsafe { self.at(coords, index_base, |contact, rows| contact.contact_step(rows, bodies, options, place)) }
    }

    /// [`Self::evaluate`] and [`Self::tangent`] in one.
    pub(crate) unsafe fn evaluate_tangent(
        &mut self,
        coords: &fmc_coords,
        part: TangentPart,
        forces: Option<&fmc_forces>,
        add: bool,
        index_base: i32,
    ) -> Result<(Evaluation, Kept), Failure> {
        let [nodes, obstacles] = [self.held.contact().surface().unknown_count(), self.obstacle_nodes()];
        // SAFETY: passed on to the caller.
        unsafe {
            self.evaluated(coords, forces, add, index_base, |contact, rows| {
                let (found, tangent) = contact.evaluate_tangent(rows, part)?;
                Ok((found, Kept::new(&tangent, nodes, obstacles)))
            })
        }
    }

    /// The contact at the nodes.
    pub(crate) unsafe fn nodal_contact(&mut self, coords: &fmc_coords, index_base: i32) -> Result<NodalLists, Failure> {
        // SAFETY: passed on to the caller.
        Ok(unsafe { self.at(coords, index_base, |contact, rows| contact.nodal_contact(rows)) }?.into())
    }

    /// Bits of the coordinates, to tell whether they are the same.
    pub(crate) unsafe fn bits(&mut self, coords: &fmc_coords) -> Result<Vec<u64>, Failure> {
        check_node_count(coords.node_count, self.held.contact().surface().unknown_count())?;
        // SAFETY: passed on to the caller.
        let rows = unsafe { coords.rows("coords", &mut self.scratch) }?;
        Ok(rows.as_flattened().iter().map(|number: &f64| number.to_bits()).collect())
    }

    /// The contact points.
    pub(crate) unsafe fn contact_points(
        &mut self,
        coords: &fmc_coords,
        index_base: i32,
    ) -> Result<Vec<fmc_contact_point>, Failure> {
        // SAFETY: passed on to the caller.
        let points = unsafe { self.at(coords, index_base, |contact, rows| contact.contact_points(rows)) }?;
        Ok(points.iter().map(|point| fmc_contact_point::new(point, index_base)).collect())
    }

    /// Weighted gaps.
    pub(crate) unsafe fn gap_constraints(
        &mut self,
        coords: &fmc_coords,
        reach: f64,
        index_base: i32,
    ) -> Result<KeptGaps, Failure> {
        // SAFETY: passed on to the caller.
        let found = unsafe { self.at(coords, index_base, |contact, rows| contact.gap_constraints(rows, reach)) }?;
        Ok(KeptGaps::new(&found, index_base))
    }

    /// Moves surfaces out by their gaps.
    pub(crate) unsafe fn augment(
        &mut self,
        coords: &fmc_coords,
        reach: f64,
        enough: f64,
        index_base: i32,
    ) -> Result<Augmentation, Failure> {
        // SAFETY: passed on to the caller.
        unsafe { self.at(coords, index_base, |contact, rows| contact.augment(rows, reach, enough)) }
    }

    /// Multiplies the stiffness of the laws.
    pub(crate) fn stiffen(&mut self, factor: f64) -> Result<(), Failure> {
        Ok(self.held.contact_mut().stiffen(factor)?)
    }

    /// How far they are moved out.
    pub(crate) fn multipliers(&self, index_base: i32) -> Vec<fmc_multiplier> {
        let found = self.held.contact().multipliers();
        found.iter().map(|one| fmc_multiplier::new(one, index_base)).collect()
    }

    /// Sets it.
    pub(crate) fn set_multipliers(&mut self, multipliers: &[fmc_multiplier], index_base: i32) -> Result<(), Failure> {
        let taken = multipliers.iter().enumerate().map(|(place, one)| one.taken(place, index_base));
        let taken = taken.collect::<Result<Vec<_>, _>>()?;
        self.held.contact_mut().set_multipliers(&taken).map_err(Failure::counted_from(index_base))
    }

    /// Evaluates, and writes the forces, if wanted, on success.
    pub(crate) unsafe fn evaluate(
        &mut self,
        coords: &fmc_coords,
        forces: Option<&fmc_forces>,
        add: bool,
        index_base: i32,
    ) -> Result<Evaluation, Failure> {
        // SAFETY: passed on to the caller.
        let found = unsafe {
            self.evaluated(coords, forces, add, index_base, |contact, rows| Ok((contact.evaluate(rows)?, ())))
        }?;
        Ok(found.0)
    }
}
