//! The mesh of a context.

use super::{Held, Resident};
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::slice;
use crate::capi::structs::boundary_facet::fmc_boundary_facet;
use crate::capi::structs::mesh::Numbering;
use crate::capi::structs::view::fmc_coords;
use crate::{Basis, Error, PointWeights};

impl<const D: usize> Resident<D> {
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

    /// Sets the coordinates without deformation.
    pub(crate) unsafe fn set_reference(&mut self, coords: &fmc_coords, index_base: i32) -> Result<(), Failure> {
        // SAFETY: passed on to the caller.
        unsafe { self.at(coords, index_base, |contact, rows| contact.set_reference(rows)) }
    }

    /// Says where planes of symmetry are.
    ///
    /// # Safety
    /// The host guarantees that the arrays have `count` rows.
    pub(crate) unsafe fn set_symmetry_planes(
        &mut self,
        points: *const f64,
        normals: *const f64,
        count: usize,
    ) -> Result<(), Failure> {
        // SAFETY: passed on to the caller.
        let [points, normals] = unsafe { [slice("points", points, count, D)?, slice("normals", normals, count, D)?] };
        let rows = points.as_chunks::<D>().0.iter().zip(normals.as_chunks::<D>().0);
        let planes: Vec<[[f64; D]; 2]> = rows.map(|(point, normal)| [*point, *normal]).collect();
        Ok(match &mut self.held {
            Held::Whole(contact) => contact.set_symmetry_planes(&planes),
            Held::InParts(parts) => parts.set_symmetry_planes(&planes),
        }?)
    }

    /// Has straight faces stand for smooth surfaces.
    pub(crate) fn set_surface_smoothing(&mut self, feature_angle: f64) -> Result<(), Failure> {
        Ok(self.held.contact_mut().set_surface_smoothing(feature_angle)?)
    }

    /// Names a part of the surface by its facets.
    pub(crate) fn add_surface(&mut self, facets: &[usize]) -> Result<usize, Failure> {
        match &mut self.held {
            Held::Whole(contact) => Ok(contact.add_surface(facets)?),
            Held::InParts(_) => Err(Error::Unsupported { what: "a named surface of a mesh in parts" }.into()),
        }
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
}
