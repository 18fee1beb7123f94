//! Nodes of one body that lie within a tolerance of one another, taken as one node for contact alone.
//!
//! Meshes come with nodes given twice by place: parts that were meshed apart, or cells each with nodes of its own. Their faces within are
//! then taken for surface ([`super::coinciding`]). Welded, the surface is that of the merged mesh, whose node lies in the mean of those that
//! are one, X = P x with weights 1/n; forces come to these by Pᵀ, in equal parts, and their sum and moment stay.
//!
//! Which nodes are one does not depend on any order: those that a chain of distances within the tolerance joins, by the first of them.

use super::cells::Cells;
use super::components::Components;
use crate::Error;
use crate::geometry::primitives::aabb::Aabb;
use crate::geometry::primitives::tree::Tree;
use crate::geometry::second_order::Division;
use crate::geometry::{Bodies, CellBlock, Surface, Vector};

/// Nodes that are one, ascending, in the order of their first.
pub(crate) type Welds = Vec<Vec<u32>>;

impl<const D: usize> Surface<D> {
    /// [`Surface::from_cells`] of a mesh in which nodes of one body that lie within `tolerance` of one another, a length, are taken as
    /// one; 0: none. Where bodies are found by their connection, nodes of any cells are, and parts that are welded are one body.
    ///
    /// All nodes of the mesh stay: a node that others are one with lies in their mean, and each has an equal part of its force. Points of
    /// contact, facets and warnings name the first of them.
    ///
    /// # Errors
    /// Those of [`Surface::from_cells`]; [`Error::NotPositive`] for a tolerance that is negative or not finite; [`Error::Collapsed`] for
    /// one that two nodes of a cell are within, and for one by which a chain of other nodes joins them.
    pub fn from_cells_welded(
        coords: &[[f64; D]],
        blocks: &[CellBlock],
        bodies: Bodies,
        tolerance: f64,
    ) -> Result<Self, Error> {
        Error::check_not_negative("weld", tolerance)?;
        // What is no mesh is refused there.
        if tolerance == 0.0 || !is_sound(coords, blocks, bodies) {
            return Self::from_cells(coords, blocks, bodies);
        }
        let (first_of, welds) = welds_of(coords, blocks, bodies, tolerance)?;
        if welds.is_empty() {
            return Self::from_cells(coords, blocks, bodies);
        }
        let merged: Vec<Vec<u32>> =
            blocks.iter().map(|block| block.conn.iter().map(|&node| first_of[node as usize]).collect()).collect();
        let as_given = blocks.iter().zip(&merged);
        let merged: Vec<_> = as_given.map(|(block, conn)| CellBlock { cell_type: block.cell_type, conn }).collect();
        let means = Division::none(coords.len()).welded(welds.clone(), |_| false);
        let mut surface = Self::from_cells(&means.interpolation.points(coords)?, &merged, bodies)?;
        let division = surface.division.take().unwrap_or_else(|| Division::none(coords.len()));
        let used = surface.cells.as_ref().map_or_else(Vec::new, |cells| used_points(cells, &division));
        surface.division = Some(division.welded(welds, |point| used.get(point).is_some_and(|is_used| *is_used)));
        Ok(surface)
    }

    /// How many nodes are one with another before them: as many as merging would leave out.
    pub fn welded_node_count(&self) -> usize {
        self.welds().iter().map(|nodes| nodes.len() - 1).sum()
    }

    /// Marks all nodes that are one with a marked one.
    pub(crate) fn mark_welded(&self, marks: &mut [bool]) {
        for nodes in self.welds() {
            let is_marked = nodes.iter().any(|&node| marks[node as usize]);
            nodes.iter().for_each(|&node| marks[node as usize] = is_marked);
        }
    }

    fn welds(&self) -> &[Vec<u32>] {
        self.division.as_ref().map_or(&[], |division| division.welds())
    }
}

/// Whether lengths and numbers are such that nodes can be compared.
fn is_sound<const D: usize>(coords: &[[f64; D]], blocks: &[CellBlock], bodies: Bodies) -> bool {
    let fits = |block: &CellBlock| {
        block.cell_type.dimension() == D
            && block.conn.len().is_multiple_of(block.cell_type.node_count())
            && block.conn.iter().all(|&node| coords.get(node as usize).is_some_and(|x| x.iter().all(|x| x.is_finite())))
    };
    let count = blocks.iter().map(|block| block.conn.len() / block.cell_type.node_count()).sum::<usize>();
    blocks.iter().all(fits)
        && match bodies {
            Bodies::Connected => true,
            Bodies::Ids(ids) => ids.len() == count,
        }
}

fn cells_of<'a>(blocks: &'a [CellBlock]) -> impl Iterator<Item = &'a [u32]> {
    blocks.iter().flat_map(|block| block.conn.chunks_exact(block.cell_type.node_count()))
}

/// The first of those with which a node is one, by node; and all that are one with others.
fn welds_of<const D: usize>(
    coords: &[[f64; D]],
    blocks: &[CellBlock],
    bodies: Bodies,
    tolerance: f64,
) -> Result<(Vec<u32>, Welds), Error> {
    let at = |node: u32| Vector::<D>::from(coords[node as usize]);
    check_cells(blocks, tolerance, |one, other| (at(one) - at(other)).norm())?;
    let mut sets = Components::new(coords.len());
    let id = |cell: usize| if let Bodies::Ids(ids) = bodies { ids[cell] } else { 0 };
    let mut nodes: Vec<(i64, u32)> = cells_of(blocks)
        .enumerate()
        .flat_map(|(cell, nodes)| nodes.iter().map(move |&node| (id(cell), node)))
        .collect();
    nodes.sort_unstable();
    nodes.dedup();
    for of_body in nodes.chunk_by(|one, other| one.0 == other.0) {
        // Half of the tolerance around each, and as much as rounding takes.
        let near = |&(_, node): &(i64, u32)| Aabb::of(&[at(node)]).inflated(0.5 * tolerance * (1.0 + 1e-9));
        let boxes: Vec<Aabb<D>> = of_body.iter().map(near).collect();
        let tree = Tree::new(&boxes);
        tree.visit_pairs(&tree, [&boxes, &boxes], |i, j| {
            let [one, other] = [i, j].map(|k| of_body[k as usize].1);
            if i < j && (at(one) - at(other)).norm() <= tolerance {
                sets.join(one, other, false);
            }
        });
    }
    let first_of: Vec<u32> = (0..coords.len() as u32).map(|node| sets.find(node).0).collect();
    for (cell, nodes) in cells_of(blocks).enumerate() {
        for (k, &one) in nodes.iter().enumerate() {
            let is_joined = |other: &&u32| **other != one && first_of[**other as usize] == first_of[one as usize];
            if let Some(&other) = nodes[..k].iter().find(is_joined) {
                return Err(Error::Collapsed { cell, length: (at(one) - at(other)).norm(), tolerance });
            }
        }
    }
    let mut members: Vec<(u32, u32)> = (0..).zip(&first_of).map(|(node, &first)| (first, node)).collect();
    members.sort_unstable();
    let groups = members.chunk_by(|one, other| one.0 == other.0).filter(|group| group.len() > 1);
    let welds = groups.map(|group| group.iter().map(|(_, node)| *node).collect()).collect();
    Ok((first_of, welds))
}

/// Refuses a tolerance that two nodes of a cell are within, and names the cell where they are nearest.
fn check_cells(blocks: &[CellBlock], tolerance: f64, distance: impl Fn(u32, u32) -> f64) -> Result<(), Error> {
    let mut least = (f64::INFINITY, 0);
    for (cell, nodes) in cells_of(blocks).enumerate() {
        for (k, &one) in nodes.iter().enumerate() {
            for &other in nodes[..k].iter().filter(|&&other| other != one) {
                let length = distance(one, other);
                if length < least.0 {
                    least = (length, cell);
                }
            }
        }
    }
    let (length, cell) = least;
    if length <= tolerance { Err(Error::Collapsed { cell, length, tolerance }) } else { Ok(()) }
}

/// Points that cells have.
fn used_points(cells: &Cells, division: &Division) -> Vec<bool> {
    let mut used = vec![false; division.interpolation.point_count()];
    (0..cells.len()).flat_map(|cell| cells.nodes(cell)).for_each(|&point| used[point as usize] = true);
    used
}
