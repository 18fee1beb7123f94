//! Some cells of a larger mesh: those near the contact, with what has to be known of the rest.
//!
//! Their boundary is closed, by the faces behind which the mesh goes on. So winding numbers about points where no cell is
//! missing are those of the whole mesh, and as the faces that close it lie outside of there, nothing that is measured there
//! depends on them.

use super::facet_sags::MostCurved;
use crate::Error;
use crate::geometry::Surface;
use crate::geometry::primitives::aabb::Aabb;
use std::collections::BTreeSet;
use std::hash::Hasher;

/// What a surface of some cells knows of the whole mesh.
#[derive(Clone, Debug)]
pub(crate) struct Submesh<const D: usize> {
    /// By facet: whether the mesh goes on behind it.
    is_cut: Vec<bool>,
    /// The same by straight cell, bit f for its face f.
    cut_faces: Vec<u8>,
    /// Boxes of the whole bodies where they are now.
    pub(crate) body_boxes: Vec<Aabb<D>>,
    /// By body: boxes in which none of its cells is missing.
    pub(crate) complete_in: Vec<Vec<Aabb<D>>>,
    /// Counts how often it was brought to coordinates.
    pub(crate) epoch: u64,
    /// Hash of the coordinates to which it was.
    pub(crate) brought: u64,
    /// How far around the overlap of boxes nothing is missing.
    pub(crate) reach: f64,
    /// Nodes on the surfaces of the whole bodies.
    pub(crate) surface_node_counts: Vec<usize>,
    /// Box of all surfaces without deformation.
    pub(crate) reference_box: Aabb<D>,
    /// How curved the faces of the whole bodies are, at most.
    pub(crate) most_curved: Vec<MostCurved>,
}

impl<const D: usize> Submesh<D> {
    /// Whether the mesh goes on behind a facet.
    pub(crate) fn is_cut(&self, facet: usize) -> bool {
        self.is_cut[facet]
    }

    /// Whether it goes on behind a face of a straight cell, though there is none here.
    pub(crate) fn is_cut_face(&self, cell: usize, face: usize) -> bool {
        self.cut_faces[cell] >> face & 1 == 1
    }
}

const HANGING: Error = Error::Unsupported { what: "hanging nodes in a mesh in parts" };

/// What is known of the whole bodies.
pub(crate) struct Whole<const D: usize> {
    pub(crate) surface_node_counts: Vec<usize>,
    pub(crate) reference_box: Aabb<D>,
    pub(crate) most_curved: Vec<MostCurved>,
}

/// A face of a cell as given that has no cell of its body behind it.
pub(crate) struct LoneFace {
    pub(crate) cell: usize,
    /// Its number among those of the cell, as VTK counts them.
    pub(crate) face: usize,
    /// Nodes at its corners.
    pub(crate) corners: Vec<u32>,
}

/// Hash of coordinates, bit by bit.
pub(crate) fn hash_of<const D: usize>(coords: &[[f64; D]]) -> u64 {
    let mut hasher = rustc_hash::FxHasher::default();
    coords.as_flattened().iter().for_each(|x| hasher.write_u64(x.to_bits()));
    hasher.finish()
}

impl<const D: usize> Surface<D> {
    /// Faces of the cells as given that have no cell behind them.
    ///
    /// # Errors
    /// [`Error::Unsupported`] where nodes hang.
    pub(crate) fn lone_faces(&self) -> Result<Vec<LoneFace>, Error> {
        let (mut faces, mut seen) = (Vec::new(), BTreeSet::new());
        for (facet, source) in self.boundary_facets().iter().enumerate() {
            let (Some(cell), Some(face), Some(cells)) = (source.cell, source.local_face, &self.cells) else {
                return Err(HANGING);
            };
            if !seen.insert((cell, face)) {
                continue;
            }
            let (straight, source) = (self.facet_cell[facet] as usize, self.facet_source[facet] as usize);
            let corners = match &self.division {
                Some(division) if division.curved().is_empty() => return Err(HANGING),
                Some(division) => {
                    let whole = division.face(straight, source).ok_or(HANGING)?;
                    division.corners_of_face(straight, whole).collect()
                }
                None => cells.face_nodes(straight, source),
            };
            faces.push(LoneFace { cell, face, corners });
        }
        Ok(faces)
    }

    /// Makes it that of some cells of a larger mesh: bit f of `surface_faces` of a cell as given says that its face f, as VTK
    /// counts them, is surface there.
    ///
    /// # Errors
    /// [`Error::Unsupported`] where nodes hang, and where a face that is said to be surface has a cell behind it.
    pub(crate) fn make_submesh(&mut self, surface_faces: &[u8], whole: &Whole<D>) -> Result<(), Error> {
        let cells = self.cells.as_ref().ok_or(Error::Empty)?;
        if self.division.as_ref().is_some_and(|division| division.curved().is_empty()) {
            return Err(HANGING);
        }
        let (mut is_cut, mut cut_faces) = (Vec::with_capacity(self.facets.len()), vec![0u8; cells.len()]);
        let mut found = vec![0u8; surface_faces.len()];
        for (facet, source) in self.boundary_facets().iter().enumerate() {
            let (Some(cell), Some(face)) = (source.cell, source.local_face) else {
                return Err(HANGING);
            };
            let is_surface = surface_faces[cell] >> face & 1 == 1;
            is_cut.push(!is_surface);
            found[cell] |= u8::from(is_surface) << face;
            if !is_surface {
                cut_faces[self.facet_cell[facet] as usize] |= 1 << self.facet_source[facet];
            }
        }
        if found != surface_faces {
            return Err(Error::Unsupported {
                what: "cells that meet in a face that one part of the mesh does not have",
            });
        }
        let Whole { surface_node_counts, reference_box, most_curved } = whole;
        self.submesh = Some(Box::new(Submesh {
            is_cut,
            cut_faces,
            body_boxes: Vec::new(),
            complete_in: Vec::new(),
            epoch: 0,
            brought: 0,
            reach: 0.0,
            surface_node_counts: surface_node_counts.clone(),
            reference_box: *reference_box,
            most_curved: most_curved.clone(),
        }));
        Ok(())
    }

    /// Whether a facet is surface of the mesh, and not the end of a part of it.
    pub(crate) fn is_surface_facet(&self, facet: usize) -> bool {
        self.submesh.as_ref().is_none_or(|submesh| !submesh.is_cut(facet))
    }

    /// Refuses what is asked of a part of a mesh by itself.
    pub(crate) fn refuse_submesh(&self, what: &'static str) -> Result<(), Error> {
        if self.submesh.is_some() { Err(Error::Unsupported { what }) } else { Ok(()) }
    }
}
