//! Surfaces of meshes whose cells are divided, and of those whose nodes a host's own unknowns move.

use crate::Error;
use crate::geometry::mesh::cells::Cells;
use crate::geometry::second_order::{Basis, CurvedCells, Division, MapCheck};
use crate::geometry::{Bodies, CellBlock, Surface};
use std::borrow::Cow;
use std::collections::BTreeSet;

impl<const D: usize> Surface<D> {
    /// The same where nodes hang: they are moved by those in whose middle they do, and cells in space with a face that meets
    /// smaller faces are divided about their own middle, so that they fit these wherever the nodes go.
    pub(in crate::geometry) fn refined(self, coords: &[[f64; D]], blocks: &[CellBlock]) -> Result<Self, Error> {
        let Some(cells) = self.cells.as_ref().filter(|cells| cells.is_refined()) else { return Ok(self) };
        let mut division = Division::of_refined(coords.len(), blocks, cells);
        let points = division.interpolation.points(coords)?;
        let straight = std::mem::take(&mut division.blocks);
        let blocks: Vec<_> =
            straight.iter().map(|(cell_type, conn)| CellBlock { cell_type: *cell_type, conn }).collect();
        let ids = cells.body.iter().map(|&body| self.body_ids()[body as usize]).collect::<Vec<_>>();
        let ids = division.body_ids(Bodies::Ids(&ids))?.unwrap_or_default();
        let surface = Self::of_straight_cells(&points, &blocks, Bodies::Ids(&ids));
        let mut surface = surface.map_err(|error| division.in_host_numbers(error))?;
        surface.division = Some(division);
        Ok(surface)
    }

    /// Coordinates of all nodes of the straight mesh that is measured: those of the host's, or of the points at which
    /// its cells are divided.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::NonFiniteCoordinate`], where there are cells of second order.
    pub(crate) fn mesh_points<'a>(&self, coords: &'a [[f64; D]]) -> Result<Cow<'a, [[f64; D]]>, Error> {
        match &self.division {
            Some(division) => division.map().points(coords).map(Cow::Owned),
            None => Ok(Cow::Borrowed(coords)),
        }
    }

    /// Checks that no map of a cell of second order folds.
    ///
    /// # Errors
    /// [`Error::FoldedCell`].
    pub(in crate::geometry) fn check_curved(&self, points: &[[f64; D]]) -> Result<(), Error> {
        self.curved().iter().try_for_each(|curved| curved.check(0..curved.len(), points, MapCheck::Given).map(|_| ()))
    }

    /// Cells of second order, block by block.
    pub(crate) fn curved(&self) -> &[CurvedCells] {
        self.division.as_ref().map_or(&[], |division| division.curved())
    }

    /// How cells of second order are divided; `None` where there are none.
    pub(crate) fn division(&self) -> Option<&Division> {
        self.division.as_ref()
    }

    /// An error that names cells as given.
    pub(crate) fn in_host_numbers(&self, error: Error) -> Error {
        self.division.as_ref().map_or(error.clone(), |division| division.in_host_numbers(error))
    }

    /// Has the nodes of the mesh moved by a host's own unknowns, or by themselves again.
    pub(crate) fn set_basis(&mut self, basis: Option<&Basis>) -> Result<(), Error> {
        match (&mut self.division, basis) {
            (Some(division), _) => division.set_basis(basis),
            (None, None) => Ok(()),
            (None, Some(_)) => {
                let mut division = Division::none(self.node_count);
                division.set_basis(basis)?;
                self.division = Some(division);
                Ok(())
            }
        }
    }

    /// The length that coordinates must have: the number of nodes, or of the unknowns of a basis
    /// ([`Contact::set_basis`](crate::Contact::set_basis)).
    pub fn unknown_count(&self) -> usize {
        self.division.as_ref().map_or(self.node_count, |division| division.map().node_count())
    }

    /// The same of faces of second order, each once.
    pub(in crate::geometry) fn whole_faces(&self, division: &Division, cells: &Cells) -> Vec<(usize, Vec<u32>)> {
        let (mut faces, mut seen) = (Vec::new(), BTreeSet::new());
        for (body, range) in self.ranges.iter().enumerate() {
            for facet in range.clone() {
                let cell = self.facet_cell[facet] as usize;
                let Some(face) = division.face(cell, self.facet_source[facet] as usize) else { continue };
                if seen.insert((division.cell(cell), face)) {
                    let corners = division.corners_of_face(cell, face);
                    let is_flipped = cells.is_flipped(cell);
                    faces.push((body, if is_flipped { corners.rev().collect() } else { corners.collect() }));
                }
            }
        }
        faces
    }

    /// The same of facets that were given.
    pub(in crate::geometry) fn whole_facets(&self, division: &Division) -> Vec<(usize, Vec<u32>)> {
        let (mut faces, mut seen) = (Vec::new(), BTreeSet::new());
        for (body, range) in self.ranges.iter().enumerate() {
            for straight in range.clone().map(|facet| self.facet_source[facet] as usize) {
                if seen.insert(division.cell(straight)) {
                    faces.push((body, division.corners_of_facet(straight).to_vec()));
                }
            }
        }
        faces
    }
}
