//! The mesh of a contact: its surface, and how deep its cells lie below it.

mod offsets;

pub(crate) use offsets::Offsets;

use crate::Error;
use crate::contact::partners::MeshHashes;
use crate::depth_field::DepthField;
use crate::geometry::submesh::hash_of;
use crate::geometry::{Basis, Surface, Weighting};
use std::borrow::Cow;
use std::sync::OnceLock;

/// The bodies, without obstacles, and what is known of them without deformation.
pub(crate) struct Mesh<const D: usize> {
    pub(crate) surface: Surface<D>,
    /// Where the surface lies beside its nodes.
    offsets: Offsets<D>,
    /// Whether a node lies in a plane of symmetry; `None` where that was not said.
    in_symmetry_plane: Option<Vec<bool>>,
    /// Depth of the cells, found when it is asked for first.
    depth: OnceLock<Option<DepthField<D>>>,
    hashes: MeshHashes,
}

impl<const D: usize> Mesh<D> {
    pub(crate) fn new(surface: Surface<D>) -> Self {
        let offsets = Offsets::none();
        let hashes = MeshHashes { depths: [hash_of(surface.reference()), 0], offsets: offsets.hash() };
        Self { surface, offsets, in_symmetry_plane: None, depth: OnceLock::new(), hashes }
    }

    /// The points of the straight mesh that is measured: those of the nodes at `coords`, with what the surface lies beside them.
    pub(crate) fn points<'a>(&self, coords: &'a [[f64; D]]) -> Result<Cow<'a, [[f64; D]]>, Error> {
        Ok(self.placed(self.surface.mesh_points(coords)?))
    }

    /// Points of the straight mesh with what the surface lies beside them.
    pub(crate) fn placed<'a>(&self, mut points: Cow<'a, [[f64; D]]>) -> Cow<'a, [[f64; D]]> {
        if !self.offsets.is_empty() {
            self.offsets.add_to(points.to_mut());
        }
        points
    }

    /// Where the surface lies beside its nodes.
    pub(crate) fn offsets(&self) -> &Offsets<D> {
        &self.offsets
    }

    /// Has the surface lie elsewhere; returns where it lay.
    pub(crate) fn replace_offsets(&mut self, offsets: Offsets<D>) -> Offsets<D> {
        self.hashes.offsets = offsets.hash();
        std::mem::replace(&mut self.offsets, offsets)
    }

    /// How deep the cells of bodies lie below their surfaces, where there are cells.
    pub(crate) fn depth_field(&self, weighting: Weighting) -> Option<&DepthField<D>> {
        let new = || DepthField::new(&self.surface, self.in_symmetry_plane.as_deref(), weighting);
        self.depth.get_or_init(new).as_ref()
    }

    /// Of what decides how facets bear.
    pub(crate) fn hashes(&self) -> MeshHashes {
        self.hashes
    }

    /// Has depths found again, for another weighting.
    pub(crate) fn forget_depth(&mut self) {
        self.depth = OnceLock::new();
    }

    pub(crate) fn set_reference(&mut self, coords: &[[f64; D]]) -> Result<(), Error> {
        self.surface.refuse_submesh("reference coordinates of a part of a mesh by itself")?;
        self.surface.set_reference(coords)?;
        self.hashes.depths[0] = hash_of(self.surface.reference());
        self.forget_depth();
        Ok(())
    }

    pub(crate) fn set_basis(&mut self, basis: Option<&Basis>) -> Result<(), Error> {
        self.surface.refuse_submesh("unknowns that move a part of a mesh")?;
        self.surface.set_basis(basis)
    }

    pub(crate) fn set_symmetry_nodes(&mut self, nodes: &[u32]) -> Result<(), Error> {
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
        self.tell_symmetry(hash_of_marks(&marked));
        self.mark_symmetry(marked);
        Ok(())
    }

    /// Says by a hash which nodes are marked.
    pub(crate) fn tell_symmetry(&mut self, marks: u64) {
        self.hashes.depths[1] = marks;
    }

    /// The same by node.
    fn mark_symmetry(&mut self, mut marked: Vec<bool>) {
        if let Some(division) = self.surface.division() {
            let map = &division.interpolation;
            let of_point = |point| map.row(point).all(|(node, _)| marked[node as usize]);
            marked = (0..map.point_count()).map(of_point).collect();
        }
        self.in_symmetry_plane = Some(marked);
        self.forget_depth();
    }

    /// Takes other cells of the same mesh, with marks of the nodes in planes of symmetry.
    pub(crate) fn take_cells(&mut self, surface: Surface<D>, in_symmetry_plane: Option<Vec<bool>>) {
        // How facets bore before is known of those that are still there.
        *self = Self { hashes: self.hashes, ..Self::new(surface) };
        if let Some(marked) = in_symmetry_plane {
            self.mark_symmetry(marked);
        }
    }

    /// Number of the coordinates to which a mesh in parts was brought last.
    pub(crate) fn epoch(&self) -> u64 {
        self.surface.submesh.as_ref().map_or(0, |submesh| submesh.epoch)
    }

    /// Refuses coordinates to which a mesh in parts was not brought: those of other cells would not be known later.
    pub(crate) fn check_brought(&self, coords: &[[f64; D]]) -> Result<(), Error> {
        match &self.surface.submesh {
            Some(submesh) if submesh.brought != hash_of(coords) => {
                let what = "friction and patches at coordinates to which the parts of the mesh were not brought";
                Err(Error::Unsupported { what })
            }
            _ => Ok(()),
        }
    }

    /// Refuses gaps to what lies farther than was gathered.
    pub(crate) fn check_reach(&self, reach: f64) -> Result<(), Error> {
        match &self.surface.submesh {
            Some(submesh) if reach > submesh.reach => {
                Err(Error::Unsupported { what: "gaps that reach farther than the parts of the mesh were gathered for" })
            }
            _ => Ok(()),
        }
    }
}

/// Hash of marks of nodes; of none 0.
pub(crate) fn hash_of_marks(marked: &[bool]) -> u64 {
    let places: Vec<[f64; 1]> = (0..marked.len()).filter(|&n| marked[n]).map(|n| [n as f64 + 1.0]).collect();
    hash_of(&places)
}
