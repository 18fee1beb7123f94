//! A mesh in contact, with its dimension hidden.

use crate::capi::boundary::failure::Failure;
use crate::capi::structs::boundary_facet::fmc_boundary_facet;
use crate::capi::structs::contact_point::fmc_contact_point;
use crate::capi::structs::evaluation::Evaluation;
use crate::capi::structs::gap_constraint::KeptGaps;
use crate::capi::structs::in_parts::InParts;
use crate::capi::structs::kept_tangent::Kept;
use crate::capi::structs::multiplier::fmc_multiplier;
use crate::capi::structs::nodal_lists::NodalLists;
use crate::capi::structs::placement::Placement;
use crate::capi::structs::pose::fmc_pose;
use crate::capi::structs::shape::fmc_shape;
use crate::capi::structs::view::{fmc_coords, fmc_forces};
use crate::contact::equilibrium::StepLimit;
use crate::contact::{Augmentation, CondensedBodies, ContactStep, ContactStepOptions, PairOptions, TangentPart};
use crate::overlap::Partner;
use crate::{Basis, Communicator, Options, PointWeights, RankCounts, ShapeKind};
use std::any::Any;

/// Number of nodes, facets and bodies.
pub(crate) struct Counts {
    pub(crate) nodes: usize,
    /// Rows of coordinates: nodes, or unknowns of a basis.
    pub(crate) unknowns: usize,
    pub(crate) facets: usize,
    pub(crate) bodies: usize,
}

/// [`Contact`](crate::Contact) in either dimension. `Send` and `Sync`, since the header allows a context to be used by one thread after
/// another.
pub(crate) trait Session: Send + Sync {
    fn counts(&self) -> Counts;

    /// The mesh in parts, if it is.
    fn parts(&self) -> Option<&dyn InParts>;
    fn parts_mut(&mut self) -> Option<&mut dyn InParts>;

    /// The contact, for a search that knows its dimension.
    ///
    /// # Errors
    /// `FMC_ERROR_UNSUPPORTED` for a mesh in parts.
    fn contact_mut(&mut self) -> Result<&mut dyn Any, Failure>;

    /// The boundary facets.
    fn boundary_facets(&self, index_base: i32) -> Vec<fmc_boundary_facet>;

    /// The points of which hosts are told, as combinations of nodes.
    fn point_weights(&self) -> PointWeights;

    /// Has the nodes moved by unknowns, counted from zero, or by themselves.
    fn set_basis(&mut self, basis: Option<&Basis>) -> Result<(), Failure>;

    fn set_options(&mut self, options: Options) -> Result<(), Failure>;

    /// That of the law, as options and [`Self::stiffen`] have left it.
    fn stiffness(&self) -> f64;
    fn set_pose(&mut self, obstacle: usize, pose: fmc_pose) -> Result<(), Failure>;
    fn remove_obstacle(&mut self, obstacle: usize) -> Result<(), Failure>;

    /// Shape and pose of an obstacle.
    fn obstacle(&self, obstacle: usize) -> Result<(ShapeKind, fmc_pose), Failure>;

    /// Sets the options of a pair; `None`: those of the contact.
    fn set_pair_options(&mut self, partners: [Partner; 2], options: Option<PairOptions>) -> Result<(), Failure>;

    /// Options that hold for a pair.
    fn pair_options(&self, partners: [Partner; 2]) -> Result<PairOptions, Failure>;

    /// Adds an obstacle and returns its index.
    ///
    /// # Safety
    /// The host guarantees the arrays of the shape.
    unsafe fn add_obstacle(&mut self, shape: &fmc_shape, pose: fmc_pose, index_base: i32) -> Result<usize, Failure>;

    /// Sets the coordinates without deformation.
    ///
    /// # Safety
    /// The host guarantees the view.
    unsafe fn set_reference(&mut self, coords: &fmc_coords, index_base: i32) -> Result<(), Failure>;

    /// Names the nodes in planes of symmetry, as the host counts them.
    fn set_symmetry_nodes(&mut self, nodes: &[i64], index_base: i32) -> Result<(), Failure>;

    /// Begins a step with friction.
    ///
    /// # Safety
    /// The host guarantees the view.
    unsafe fn begin_step(&mut self, coords: &fmc_coords, index_base: i32) -> Result<(), Failure>;

    /// Accepts it.
    ///
    /// # Safety
    /// The host guarantees the view.
    unsafe fn commit_step(&mut self, coords: &fmc_coords, index_base: i32) -> Result<(), Failure>;

    /// Freezes friction at these coordinates, or releases it.
    ///
    /// # Safety
    /// The host guarantees the view.
    unsafe fn freeze_friction(&mut self, coords: Option<&fmc_coords>, index_base: i32) -> Result<(), Failure>;

    /// The elastic slip that was carried into the step, facet by facet.
    fn slip(&self) -> Result<&[f64], Failure>;

    /// Sets it.
    fn set_slip(&mut self, slip: &[f64]) -> Result<(), Failure>;

    /// Shares the work with other ranks, or with none.
    fn set_communicator(&mut self, communicator: Option<Box<dyn Communicator>>) -> Result<(), Failure>;

    /// What was shared.
    fn rank_counts(&self) -> RankCounts;

    /// Whether tangents have the rotations of the obstacles.
    fn set_obstacle_rotations(&mut self, on: bool);

    /// Keeps the patches at these coordinates, or none; returns the number of directions.
    ///
    /// # Safety
    /// The host guarantees the view.
    unsafe fn keep_patches(&mut self, coords: Option<&fmc_coords>, index_base: i32) -> Result<usize, Failure>;

    /// Second derivative of the energy.
    ///
    /// # Safety
    /// The host guarantees the view.
    unsafe fn tangent(&mut self, coords: &fmc_coords, part: TangentPart, index_base: i32) -> Result<Kept, Failure>;

    /// The contact at the nodes.
    ///
    /// # Safety
    /// The host guarantees the view.
    unsafe fn nodal_contact(&mut self, coords: &fmc_coords, index_base: i32) -> Result<NodalLists, Failure>;

    /// Bits of the coordinates, to tell whether they are the same.
    ///
    /// # Safety
    /// The host guarantees the view.
    unsafe fn bits(&mut self, coords: &fmc_coords) -> Result<Vec<u64>, Failure>;

    /// The contact points.
    ///
    /// # Safety
    /// The host guarantees the view.
    unsafe fn contact_points(
        &mut self,
        coords: &fmc_coords,
        index_base: i32,
    ) -> Result<Vec<fmc_contact_point>, Failure>;

    /// Weighted gaps.
    ///
    /// # Safety
    /// The host guarantees the view.
    unsafe fn gap_constraints(&mut self, coords: &fmc_coords, reach: f64, index_base: i32)
    -> Result<KeptGaps, Failure>;

    /// Moves surfaces out by their gaps.
    ///
    /// # Safety
    /// The host guarantees the view.
    unsafe fn augment(
        &mut self,
        coords: &fmc_coords,
        reach: f64,
        enough: f64,
        index_base: i32,
    ) -> Result<Augmentation, Failure>;

    /// Multiplies the stiffness of the laws.
    fn stiffen(&mut self, factor: f64) -> Result<(), Failure>;

    /// How far they are moved out.
    fn multipliers(&self, index_base: i32) -> Vec<fmc_multiplier>;

    /// Sets it.
    fn set_multipliers(&mut self, multipliers: &[fmc_multiplier], index_base: i32) -> Result<(), Failure>;

    /// Largest time step of central differences.
    ///
    /// # Safety
    /// The host guarantees the view.
    unsafe fn stable_step(&mut self, coords: &fmc_coords, masses: &[f64], index_base: i32) -> Result<f64, Failure>;

    /// How far a step may go.
    ///
    /// # Safety
    /// The host guarantees both views.
    unsafe fn step_limit(
        &mut self,
        coords: &fmc_coords,
        step: &fmc_coords,
        index_base: i32,
    ) -> Result<StepLimit, Failure>;

    /// Equilibrium with condensed bodies.
    ///
    /// # Safety
    /// The host guarantees the view and the function.
    unsafe fn contact_step(
        &mut self,
        coords: &fmc_coords,
        bodies: &CondensedBodies,
        options: &ContactStepOptions,
        placement: Option<Placement>,
        index_base: i32,
    ) -> Result<ContactStep, Failure>;

    /// [`Self::evaluate`] and [`Self::tangent`] in one.
    ///
    /// # Safety
    /// The host guarantees both views.
    unsafe fn evaluate_tangent(
        &mut self,
        coords: &fmc_coords,
        part: TangentPart,
        forces: Option<&fmc_forces>,
        add: bool,
        index_base: i32,
    ) -> Result<(Evaluation, Kept), Failure>;

    /// Evaluates, and writes the forces, if wanted, on success.
    ///
    /// # Safety
    /// The host guarantees both views.
    unsafe fn evaluate(
        &mut self,
        coords: &fmc_coords,
        forces: Option<&fmc_forces>,
        add: bool,
        index_base: i32,
    ) -> Result<Evaluation, Failure>;
}
