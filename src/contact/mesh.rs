//! The mesh of a contact: its surface, and how deep its cells lie below it.

mod offsets;
mod surfaces;

pub(crate) use offsets::Offsets;

use surfaces::{Surfaces, TiedPairs};

use crate::Error;
use crate::contact::partners::MeshHashes;
use crate::depth_field::{DepthField, ReferenceSlopes};
use crate::geometry::boundary::submesh::hash_of;
use crate::geometry::boundary::symmetry::{Symmetry, SymmetryPlane, check_bodies, planes_of};
use crate::geometry::{Basis, CoincidingFaces, Surface, Weighting};
use crate::interfaces::{Between, HeldFacets};
use crate::overlap::TiedFacets;
use std::borrow::Cow;
use std::collections::BTreeMap;
use std::sync::OnceLock;

/// The bodies, without obstacles, and what is known of them without deformation.
pub(crate) struct Mesh<const D: usize> {
    pub(crate) surface: Surface<D>,
    /// Where the surface lies beside its nodes.
    offsets: Offsets<D>,
    /// Planes of symmetry, as they were told, and the faces in them; `None` where nothing was said.
    told: Option<Told<D>>,
    symmetry: Option<Symmetry<D>>,
    /// At less than which angle, in radians, straight faces stand for a smooth surface.
    feature_angle: Option<f64>,
    /// Depth of the cells, found when it is asked for first.
    depth: OnceLock<Option<DepthField<D>>>,
    /// How they change with the reference, found when that is asked for first.
    slopes: OnceLock<Option<ReferenceSlopes<D>>>,
    /// Faces of one body that coincide, found when they are asked for first.
    coinciding: OnceLock<Vec<CoincidingFaces>>,
    hashes: MeshHashes,
    surfaces: Surfaces,
    tied: TiedPairs,
}

impl<const D: usize> Mesh<D> {
    pub(crate) fn new(surface: Surface<D>) -> Self {
        let offsets = Offsets::none();
        let hashes = MeshHashes { depths: [hash_of(surface.reference()), 0, 0], offsets: offsets.hash() };
        let (depth, slopes, coinciding) = (OnceLock::new(), OnceLock::new(), OnceLock::new());
        let (surfaces, tied, told) = (Surfaces::default(), TiedPairs::default(), None);
        let (symmetry, feature_angle) = (None, None);
        Self { surface, offsets, told, symmetry, feature_angle, depth, slopes, coinciding, hashes, surfaces, tied }
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
    /// It is found at the first call; `check` may end that.
    pub(crate) fn depth_field(&self, weighting: Weighting, check: &dyn Fn()) -> Option<&DepthField<D>> {
        let new = || DepthField::new(&self.surface, self.symmetry.as_ref(), weighting, self.feature_angle, check);
        self.depth.get_or_init(new).as_ref()
    }

    /// Names a part of the surface; returns its number.
    pub(crate) fn add_surface(&mut self, facets: &[usize]) -> Result<usize, Error> {
        self.surface.refuse_submesh("a named surface of a mesh in parts")?;
        self.surfaces.add(facets, self.surface.facet_count())
    }

    /// What of two bodies something is to hold together: parts of their surfaces, or all of them.
    pub(crate) fn between(
        &self,
        bodies: [usize; 2],
        surfaces: Option<[usize; 2]>,
        reach: f64,
    ) -> Result<Between, Error> {
        let of_bodies = |numbers| self.surfaces.of_bodies(&self.surface, bodies, numbers);
        Ok(Between { bodies, facets: surfaces.map(of_bodies).transpose()?, reach, period: [0.0; 3] })
    }

    /// The bodies of two named parts of the surface, each of one.
    pub(crate) fn bodies_of_surfaces(&self, numbers: [usize; 2]) -> Result<[usize; 2], Error> {
        self.surfaces.bodies(&self.surface, numbers)
    }

    /// Has facets of these pairs be in no contact, and no others.
    pub(crate) fn set_tied(&mut self, pairs: BTreeMap<[usize; 2], HeldFacets>) {
        self.tied = TiedPairs::new(pairs);
    }

    /// Facets of a pair that are in no contact since they are tied.
    pub(crate) fn tied(&self, field: &DepthField<D>, bodies: [usize; 2]) -> Option<TiedFacets<'_>> {
        self.tied.of(&self.surface, field, bodies)
    }

    /// How the depths of flat faces change with the reference, where there are cells. It is found at the first call; `check` may end that.
    pub(crate) fn reference_slopes(&self, check: &dyn Fn()) -> Option<&ReferenceSlopes<D>> {
        let new = || ReferenceSlopes::new(&self.surface, self.symmetry.as_ref(), check);
        self.slopes.get_or_init(new).as_ref()
    }

    /// Faces of one body that lie on one another without deformation.
    pub(crate) fn coinciding_faces(&self) -> &[CoincidingFaces] {
        self.coinciding.get_or_init(|| self.surface.coinciding_faces())
    }

    /// Of what decides how facets bear.
    pub(crate) fn hashes(&self) -> MeshHashes {
        self.hashes
    }

    /// Has straight faces that meet at less than this angle, in degrees, stand for a smooth surface; 0: none.
    pub(crate) fn set_surface_smoothing(&mut self, feature_angle: f64) -> Result<(), Error> {
        if !(0.0..90.0).contains(&feature_angle) {
            return Err(Error::NotPositive { name: "feature_angle", value: feature_angle });
        }
        let angle = (feature_angle > 0.0).then(|| feature_angle.to_radians());
        if angle.is_some() {
            self.surface.refuse_submesh("a smoothed surface of a mesh in parts")?;
            if self.surface.cells.is_none() {
                return Err(Error::Unsupported { what: "a smoothed surface without cells" });
            }
        }
        if angle != self.feature_angle {
            self.feature_angle = angle;
            self.hashes.depths[2] = feature_angle.to_bits();
            self.forget_depth();
        }
        Ok(())
    }

    /// Whether faces may be measured as curved ones.
    pub(crate) fn may_be_curved(&self) -> bool {
        self.feature_angle.is_some() || !self.surface.curved().is_empty()
    }

    /// Whether straight faces are to stand for a smooth surface.
    pub(crate) fn is_smoothed(&self) -> bool {
        self.feature_angle.is_some()
    }

    /// Has depths found again, for another weighting.
    pub(crate) fn forget_depth(&mut self) {
        self.depth = OnceLock::new();
        self.slopes = OnceLock::new();
        self.tied.forget_layers();
    }

    pub(crate) fn set_reference(&mut self, coords: &[[f64; D]]) -> Result<(), Error> {
        self.surface.refuse_submesh("reference coordinates of a single part of a mesh")?;
        let before = self.surface.set_reference(coords)?;
        if let Err(error) = self.find_symmetry() {
            self.surface.restore_reference(before);
            return Err(error);
        }
        self.hashes.depths[0] = hash_of(self.surface.reference());
        self.forget_depth();
        self.coinciding = OnceLock::new();
        Ok(())
    }

    pub(crate) fn set_basis(&mut self, basis: Option<&Basis>) -> Result<(), Error> {
        self.surface.refuse_submesh("unknowns that move a part of a mesh")?;
        self.surface.set_basis(basis)
    }

    pub(crate) fn set_symmetry_nodes(&mut self, nodes: &[u32]) -> Result<(), Error> {
        self.surface.refuse_submesh("planes of symmetry of a single part of a mesh")?;
        let node_count = self.surface.node_count();
        let mut marked = vec![false; node_count];
        for (cell, &node) in nodes.iter().enumerate() {
            let mark = marked.get_mut(node as usize);
            *mark.ok_or(Error::NodeOutOfRange { cell, node: node.into(), node_count })? = true;
        }
        self.surface.mark_welded(&mut marked);
        self.tell(Told::Nodes(marked))
    }

    pub(crate) fn set_symmetry_planes(&mut self, planes: &[SymmetryPlane<D>]) -> Result<(), Error> {
        self.surface.refuse_submesh("planes of symmetry of a single part of a mesh")?;
        self.tell(Told::Planes(planes.to_vec()))
    }

    /// Replaces what was told; after an error it stays.
    fn tell(&mut self, told: Told<D>) -> Result<(), Error> {
        let before = self.told.replace(told);
        let found = self.find_symmetry();
        if found.is_err() {
            self.told = before;
        }
        found
    }

    /// Finds the faces in planes of symmetry, where the mesh is without deformation.
    fn find_symmetry(&mut self) -> Result<(), Error> {
        let node_count = self.surface.node_count();
        let symmetry = match &self.told {
            None => return Ok(()),
            Some(Told::Planes(planes)) => Symmetry { planes: planes.clone(), marks: vec![true; node_count] },
            Some(Told::Nodes(marks)) => {
                let planes = planes_of(self.surface.named_faces(marks, u64::from))?;
                Symmetry { planes, marks: marks.clone() }
            }
        };
        check_bodies(&self.surface.bodies_with_surface(&symmetry))?;
        self.tell_symmetry(symmetry.hash());
        self.mark_symmetry(symmetry);
        Ok(())
    }

    /// Says by a hash where planes of symmetry are.
    pub(crate) fn tell_symmetry(&mut self, hash: u64) {
        self.hashes.depths[1] = hash;
    }

    /// The same by point.
    fn mark_symmetry(&mut self, mut symmetry: Symmetry<D>) {
        if let Some(division) = self.surface.division() {
            let map = &division.interpolation;
            let of_point = |point| map.row(point).all(|(node, _)| symmetry.marks[node as usize]);
            symmetry.marks = (0..map.point_count()).map(of_point).collect();
        }
        self.symmetry = Some(symmetry);
        self.forget_depth();
    }

    /// Takes other cells of the same mesh, with its planes of symmetry and marks of the nodes in them.
    pub(crate) fn take_cells(&mut self, surface: Surface<D>, symmetry: Option<Symmetry<D>>) {
        // How facets bore before is known of those that are still there.
        *self = Self { hashes: self.hashes, feature_angle: self.feature_angle, ..Self::new(surface) };
        if let Some(symmetry) = symmetry {
            self.mark_symmetry(symmetry);
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

/// How planes of symmetry were told.
enum Told<const D: usize> {
    /// By the nodes in them.
    Nodes(Vec<bool>),
    Planes(Vec<SymmetryPlane<D>>),
}
