//! A contact of one dimension, as the C interface sees it.
//!
//! `mesh` · `partners` · `steps` · `results` · `gradients` · `flux` · `wear`
//!
//! # Safety
//! Of all that is unsafe here the caller guarantees the views, shapes and functions that it passes on, as the host has guaranteed them: they
//! are what they say they are as long as the call lasts, and nothing else writes what is read.

mod cohesive;
mod flux;
mod friction_law;
mod governed;
mod gradients;
mod mesh;
mod partners;
mod results;
mod steps;
mod ties;
mod wear;

use super::session::Counts;
use crate::capi::boundary::failure::Failure;
use crate::capi::structs::evaluation::Evaluation;
use crate::capi::structs::in_parts::InParts;
use crate::capi::structs::view::{check_node_count, fmc_coords, fmc_forces};
use crate::{Contact, ContactForces, Error, Options, PartitionedContact, Surface};

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
        let evaluation = Evaluation::of(&found, index_base);
        if let Some(output) = output {
            // SAFETY: the output was checked for as many rows; the caller guarantees that it may be written.
            unsafe { output.write(&found.forces, add) };
        }
        Ok((evaluation, more))
    }

    pub(crate) fn counts(&self) -> Counts {
        let surface = self.held.contact().surface();
        Counts {
            nodes: surface.node_count(),
            unknowns: surface.unknown_count(),
            facets: surface.facet_count(),
            bodies: surface.body_count(),
        }
    }

    /// How many nodes are one with others before them.
    pub(crate) fn welded_node_count(&self) -> usize {
        self.held.contact().surface().welded_node_count()
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

    /// Bits of the coordinates, to tell whether they are the same.
    pub(crate) unsafe fn bits(&mut self, coords: &fmc_coords) -> Result<Vec<u64>, Failure> {
        check_node_count(coords.node_count, self.held.contact().surface().unknown_count())?;
        // SAFETY: passed on to the caller.
        let rows = unsafe { coords.rows("coords", &mut self.scratch) }?;
        Ok(rows.as_flattened().iter().map(|number: &f64| number.to_bits()).collect())
    }
}
