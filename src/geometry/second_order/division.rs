//! A mesh with cells of second order, divided.

use super::basis::Basis;
use super::children::{Child, children};
use super::curved_cells::CurvedCells;
use super::entities::Entities;
use super::interpolation::Interpolation;
use super::point_rows::row;
use crate::Error;
use crate::geometry::mesh::cells::check_nodes;
use crate::geometry::{Bodies, CellBlock, CellType};
use std::collections::BTreeMap;

/// Straight cells in place of given ones. Points that are nodes, or stand for one in the middle of an edge, face or cell,
/// have its number; others follow after the nodes.
#[derive(Clone, Debug)]
pub(crate) struct Division {
    /// Points from the nodes of the mesh.
    pub(crate) interpolation: Interpolation,
    /// Points from the unknowns of a host that has a basis of its own.
    of_unknowns: Option<Interpolation>,
    /// Straight cells by type, in the order of the given blocks.
    pub(crate) blocks: Vec<(CellType, Vec<u32>)>,
    /// Where every straight cell comes from; empty where the cells are those given.
    pub(super) origins: Vec<Origin>,
    /// The given facet of every straight one, where a surface was given by facets.
    pub(super) facets: Vec<u32>,
    /// Corners of the given cells (or facets), one after the other, and where they begin.
    pub(super) corners: Vec<u32>,
    pub(super) starts: Vec<usize>,
    /// Cells of second order, block by block.
    pub(super) curved: Vec<CurvedCells>,
    /// Children of a cell, by its type.
    pub(super) types: Vec<(CellType, Vec<Child>)>,
    /// Nodes that are one, where some are.
    pub(super) welds: Vec<Vec<u32>>,
}

/// Where a straight cell comes from.
#[derive(Clone, Copy, Debug)]
pub(super) struct Origin {
    /// The given cell, counted over all blocks.
    pub(super) cell: u32,
    pub(super) cell_type: CellType,
    pub(super) place: Place,
}

/// Where in its cell a straight one lies.
#[derive(Clone, Copy, Debug)]
pub(super) enum Place {
    /// Its number among the children of the type.
    Child(u8),
    /// It has its first face on this one, and its last node in the middle.
    OnFace(u8),
}

/// What a node is in the cells that use it.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Role {
    Unused,
    Corner,
    /// In the middle of an edge, quadrilateral or cell: its corners, sorted, and the rest `u32::MAX`.
    Middle([u32; 8]),
}

/// Points while they are collected.
pub(super) struct Points {
    rows: Vec<Vec<(u32, f64)>>,
    roles: Vec<Role>,
    /// The cell that gave a node its role.
    given_by: Vec<u32>,
    /// Point in the middle of an edge, quadrilateral or cell, by its corners; with the cell that made it, and whether it is a node.
    middles: BTreeMap<[u32; 8], (u32, u32, bool)>,
    /// Whether what is collected are facets, whose own middle is no other's: two that have all corners in common may bulge to
    /// either side.
    is_of_facets: bool,
}

impl Division {
    /// Divides the cells of `blocks`; `None` where all are straight.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::Dimension`], [`Error::NodeOutOfRange`], [`Error::RepeatedNode`],
    /// [`Error::NonConforming`].
    pub(crate) fn of<const D: usize>(node_count: usize, blocks: &[CellBlock]) -> Result<Option<Self>, Error> {
        if blocks.iter().all(|block| block.cell_type.straight() == block.cell_type) {
            return Ok(None);
        }
        let mut points = Points::new(node_count, false);
        let mut all = Self::none(0);
        all.starts.push(0);
        let mut cell = 0;
        for (block, CellBlock { cell_type, conn }) in blocks.iter().enumerate() {
            if cell_type.dimension() != D {
                return Err(Error::Dimension { block, expected: D, found: cell_type.dimension() });
            }
            let size = cell_type.node_count();
            if conn.len() % size != 0 {
                return Err(Error::Length { array: "conn", expected: size, found: conn.len() });
            }
            let cells = conn.chunks_exact(size).zip(cell..);
            for (nodes, cell) in cells.clone() {
                check_nodes(cell, nodes, node_count)?;
                all.corners.extend_from_slice(&nodes[..cell_type.straight().node_count()]);
                all.starts.push(all.corners.len());
            }
            all.divide(*cell_type, cells.map(|(nodes, cell)| (cell as u32, nodes)), &mut points)?;
            all.curved.extend(CurvedCells::new(*cell_type, cell, conn));
            cell += conn.len() / size;
        }
        points.check_straight_cells(blocks)?;
        all.interpolation = points.interpolation(node_count, all.blocks.iter().flat_map(|(_, conn)| conn));
        Ok(Some(all))
    }

    /// Adds the children of cells of one type, those of one type in a block.
    fn divide<'a>(
        &mut self,
        cell_type: CellType,
        cells: impl Iterator<Item = (u32, &'a [u32])>,
        points: &mut Points,
    ) -> Result<(), Error> {
        let entities = Entities::of(cell_type);
        let of_type = match &entities {
            Some(entities) => children(cell_type, entities),
            None => vec![Child::whole(cell_type)],
        };
        let mut found: Vec<(CellType, Vec<u32>, Vec<Origin>)> = Vec::new();
        for (cell, nodes) in cells {
            let local = match &entities {
                Some(entities) => points.of_cell(cell, nodes, entities)?,
                None => {
                    points.all_corners(cell, nodes)?;
                    nodes.to_vec()
                }
            };
            for (number, child) in of_type.iter().enumerate() {
                let place = found.iter().position(|(of_type, ..)| *of_type == child.cell_type).unwrap_or_else(|| {
                    found.push((child.cell_type, Vec::new(), Vec::new()));
                    found.len() - 1
                });
                found[place].1.extend(child.nodes.iter().map(|&point| local[point]));
                found[place].2.push(Origin { cell, cell_type, place: Place::Child(number as u8) });
            }
        }
        for (of_type, conn, origins) in found {
            self.blocks.push((of_type, conn));
            self.origins.extend(origins);
        }
        self.types.push((cell_type, of_type));
        Ok(())
    }

    /// Every cell as it was given.
    pub(crate) fn none(node_count: usize) -> Self {
        Self {
            interpolation: Interpolation::identity(node_count),
            of_unknowns: None,
            blocks: Vec::new(),
            origins: Vec::new(),
            facets: Vec::new(),
            corners: Vec::new(),
            starts: Vec::new(),
            curved: Vec::new(),
            types: Vec::new(),
            welds: Vec::new(),
        }
    }

    /// Points from what the host hands over: its nodes, or its own unknowns.
    pub(crate) fn map(&self) -> &Interpolation {
        self.of_unknowns.as_ref().unwrap_or(&self.interpolation)
    }

    /// Whether a host's unknowns move the points.
    pub(crate) fn has_basis(&self) -> bool {
        self.of_unknowns.is_some()
    }

    /// Has the nodes moved by unknowns, or by themselves again.
    ///
    /// # Errors
    /// [`Error::Length`], [`Error::UnknownOutOfRange`], [`Error::Overflow`], [`Error::Unsupported`].
    pub(crate) fn set_basis(&mut self, basis: Option<&Basis>) -> Result<(), Error> {
        self.of_unknowns = basis.map(|basis| self.interpolation.of_unknowns(basis)).transpose()?;
        Ok(())
    }

    /// Type of that cell; `None` where it is the straight one.
    pub(crate) fn cell_type(&self, straight: usize) -> Option<CellType> {
        self.origins.get(straight).map(|origin| origin.cell_type)
    }

    /// Whether cells, or facets, are divided.
    pub(crate) fn is_divided(&self) -> bool {
        !self.origins.is_empty() || !self.facets.is_empty()
    }

    /// Body ids of the straight cells (or facets), given those of the cells.
    pub(crate) fn body_ids(&self, bodies: Bodies) -> Result<Option<Vec<i64>>, Error> {
        let Bodies::Ids(ids) = bodies else { return Ok(None) };
        let count = self.starts.len() - 1;
        if ids.len() != count {
            return Err(Error::Length { array: "body_ids", expected: count, found: ids.len() });
        }
        let straight = self.origins.len() + self.facets.len();
        Ok(Some((0..straight).map(|straight| ids[self.cell(straight)]).collect()))
    }

    /// The cell (or facet) as given to which a straight one belongs.
    pub(crate) fn cell(&self, straight: usize) -> usize {
        let cell = self.origins.get(straight).map(|origin| origin.cell);
        cell.or_else(|| self.facets.get(straight).copied()).map_or(straight, |given| given as usize)
    }

    /// Corners of the facet as given to which a straight one belongs.
    pub(crate) fn corners_of_facet(&self, straight: usize) -> &[u32] {
        let given = self.cell(straight);
        &self.corners[self.starts[given]..self.starts[given + 1]]
    }

    /// The face of that cell in which a face of the straight one lies, where it is part of its boundary.
    pub(crate) fn face(&self, straight: usize, face: usize) -> Option<usize> {
        let Some(&Origin { cell_type, place, .. }) = self.origins.get(straight) else { return Some(face) };
        let child = match place {
            Place::OnFace(whole) => return (face == 0).then_some(usize::from(whole)),
            Place::Child(child) => child,
        };
        let (_, children) = self.types.iter().find(|(of_type, _)| *of_type == cell_type)?;
        children[child as usize].faces[face]
    }

    /// Corners of a face of that cell, as the cell has them.
    pub(crate) fn corners_of_face(&self, straight: usize, face: usize) -> impl DoubleEndedIterator<Item = u32> {
        let corners = &self.corners[self.starts[self.cell(straight)]..];
        self.origins[straight].cell_type.faces()[face].iter().map(move |&local| corners[local])
    }

    /// Cells of second order, block by block.
    pub(crate) fn curved(&self) -> &[CurvedCells] {
        &self.curved
    }

    /// Takes which cells are mirrored from their straight parts.
    pub(crate) fn orient(&mut self, is_flipped: impl Fn(usize) -> bool) {
        for (straight, origin) in self.origins.iter().enumerate() {
            let cell = origin.cell as usize;
            if let Some(curved) = self.curved.iter_mut().find(|curved| curved.numbers().contains(&cell)) {
                let first = curved.numbers().start;
                curved.is_flipped[cell - first] = is_flipped(straight);
            }
        }
    }

    /// The error of an inverted straight part, as one of its whole cell where the map of that folds.
    pub(crate) fn folded<const D: usize>(&self, error: Error, points: &[[f64; D]]) -> Error {
        let error = self.in_host_numbers(error);
        let cell = match &error {
            Error::InvertedCell { cell } => *cell,
            Error::InvertedCells { cells, .. } if !cells.is_empty() => cells[0],
            _ => return error,
        };
        let curved = self.curved.iter().find(|curved| curved.numbers().contains(&cell));
        curved.and_then(|curved| curved.fold(cell - curved.numbers().start, points)).unwrap_or(error)
    }

    /// An error with cells as given.
    pub(crate) fn in_host_numbers(&self, mut error: Error) -> Error {
        match &mut error {
            Error::InvertedCell { cell } | Error::ZeroMeasure { cell } => *cell = self.cell(*cell),
            Error::InvertedCells { cells, bow_ties: 0 } => {
                cells.iter_mut().for_each(|cell| *cell = self.cell(*cell));
                cells.dedup();
                if let [cell] = cells[..] {
                    return Error::InvertedCell { cell };
                }
            }
            // Parts of a cell are no quadrilaterals of the host's.
            Error::InvertedCells { cells, .. } => return Error::InvertedCell { cell: self.cell(cells[0]) },
            Error::RepeatedCell { cells } => *cells = cells.map(|cell| self.cell(cell)),
            Error::NonManifold { facet, .. }
            | Error::InconsistentOrientation { facet, .. }
            | Error::OpenSurface { facet, .. } => *facet = self.cell(*facet),
            _ => {}
        }
        error
    }
}

impl Points {
    fn new(node_count: usize, is_of_facets: bool) -> Self {
        Self {
            rows: (0..node_count as u32).map(|node| vec![(node, 1.0)]).collect(),
            roles: vec![Role::Unused; node_count],
            given_by: vec![0; node_count],
            middles: BTreeMap::new(),
            is_of_facets,
        }
    }

    pub(super) fn of_facets(node_count: usize) -> Self {
        Self::new(node_count, true)
    }

    /// All of them, of which these are used.
    pub(super) fn interpolation<'a>(&self, node_count: usize, named: impl Iterator<Item = &'a u32>) -> Interpolation {
        let mut used = vec![false; self.rows.len()];
        named.for_each(|&point| used[point as usize] = true);
        Interpolation::new(node_count, &self.rows, |point| used[point])
    }

    /// Takes the nodes of a straight cell.
    pub(super) fn all_corners(&mut self, cell: u32, nodes: &[u32]) -> Result<(), Error> {
        nodes.iter().try_for_each(|&node| self.set_role(cell, node, Role::Corner))
    }

    /// Numbers of all points of a cell, which are added where they are new.
    pub(super) fn of_cell(&mut self, cell: u32, nodes: &[u32], entities: &Entities) -> Result<Vec<u32>, Error> {
        let mut local: Vec<u32> = nodes.to_vec();
        for &node in &nodes[..entities.corners] {
            self.set_role(cell, node, Role::Corner)?;
        }
        for point in entities.corners..entities.count() {
            let mut key = [u32::MAX; 8];
            for (k, corner) in entities.around(point).into_iter().enumerate() {
                key[k] = nodes[corner];
            }
            key.sort_unstable();
            let given = nodes.get(point).copied();
            if let Some(node) = given {
                self.set_role(cell, node, Role::Middle(key))?;
            }
            let next = given.unwrap_or(self.rows.len() as u32);
            let is_own = self.is_of_facets && entities.around(point).len() == entities.corners;
            if let Some(node) = given.filter(|_| is_own) {
                self.rows[node as usize] = row(entities, point, &local, given);
                continue;
            }
            let &mut (number, other, is_node) = self.middles.entry(key).or_insert((next, cell, given.is_some()));
            if is_node != given.is_some() || given.is_some_and(|node| node != number) {
                return Err(Error::NonConforming { cells: [other as usize, cell as usize] });
            }
            if number == next {
                let row = row(entities, point, &local, given);
                match given {
                    Some(node) => self.rows[node as usize] = row,
                    None => self.rows.push(row),
                }
            }
            if given.is_none() {
                local.push(number);
            }
        }
        Ok(local)
    }

    fn set_role(&mut self, cell: u32, node: u32, role: Role) -> Result<(), Error> {
        let known = &mut self.roles[node as usize];
        if *known == Role::Unused {
            *known = role;
            self.given_by[node as usize] = cell;
        }
        if *known == role {
            return Ok(());
        }
        Err(Error::NonConforming { cells: [self.given_by[node as usize] as usize, cell as usize] })
    }

    /// Refuses straight cells with an edge in whose middle a cell of second order has a node.
    fn check_straight_cells(&self, blocks: &[CellBlock]) -> Result<(), Error> {
        let mut first = 0;
        for CellBlock { cell_type, conn } in blocks {
            let size = cell_type.node_count();
            if *cell_type == cell_type.straight() {
                for (cell, nodes) in conn.chunks_exact(size).enumerate() {
                    for face in cell_type.faces() {
                        let ends = |k: usize| [nodes[face[k]], nodes[face[(k + 1) % face.len()]]];
                        self.check_straight(first + cell, (0..face.len()).map(ends))?;
                    }
                }
            }
            first += conn.len() / size;
        }
        Ok(())
    }

    /// Refuses a straight cell, or facet, with one of these edges if another has a node in its middle.
    pub(super) fn check_straight(&self, cell: usize, edges: impl Iterator<Item = [u32; 2]>) -> Result<(), Error> {
        for ends in edges {
            let mut key = [u32::MAX; 8];
            key[..2].copy_from_slice(&ends);
            key.sort_unstable();
            if let Some((_, other, _)) = self.middles.get(&key) {
                return Err(Error::NonConforming { cells: [*other as usize, cell] });
            }
        }
        Ok(())
    }
}
