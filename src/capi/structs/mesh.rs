//! Cells and facets of the host, as the crate wants them: zero-based, checked, copied.

use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::index::IndexSize;
use crate::capi::boundary::status::fmc_status::{FMC_ERROR_UNKNOWN_CELL_TYPE, FMC_ERROR_UNSUPPORTED};
use crate::capi::structs::options::fmc_options;
use crate::{Bodies, CellBlock, CellType, Error, Surface};
use std::ffi::c_void;

/// Type of a cell. Numbers and node order are as in VTK, except for `FMC_WEDGE6`. Cells of the mirrored order are accepted
/// too: the outward side follows from the volume of the body.
#[repr(C)]
pub enum fmc_cell_type {
    /// Triangle, 2D, 3 nodes.
    FMC_TRI3 = 5,
    /// Quadrilateral, 2D, 4 nodes in order around it.
    FMC_QUAD4 = 9,
    /// Tetrahedron, 3D, 4 nodes.
    FMC_TET4 = 10,
    /// Hexahedron, 3D, 8 nodes: four around the bottom, then the four above them.
    FMC_HEX8 = 12,
    /// Wedge, 3D, 6 nodes: three around the bottom, then the three above them, (x1 - x0) x (x2 - x0) . (x3 - x0) > 0: the
    /// order of Gmsh, meshio and Abaqus. In VTK's definition the triangles run the other way round; the mirrored order.
    FMC_WEDGE6 = 13,
    /// Pyramid, 3D, 5 nodes: four around the base, then the apex.
    FMC_PYRAMID5 = 14,
    /// Triangle of second order, 2D, 6 nodes: the corners, then the middles of the edges 01, 12, 20.
    FMC_TRI6 = 22,
    /// Quadrilateral of second order, 2D, 8 nodes: the corners, then the middles of the edges 01, 12, 23, 30.
    FMC_QUAD8 = 23,
    /// Tetrahedron of second order, 3D, 10 nodes: the corners, then the middles of 01, 12, 20, 03, 13, 23. (Gmsh has the last two
    /// the other way round.)
    FMC_TET10 = 24,
    /// Hexahedron of second order, 3D, 20 nodes: the corners, then the middles of 01, 12, 23, 30, 45, 56, 67, 74, 04, 15, 26, 37.
    FMC_HEX20 = 25,
    /// Wedge of second order, 3D, 15 nodes: the corners as in `FMC_WEDGE6`, then the middles of 01, 12, 20, 34, 45, 53, 03, 14,
    /// 25.
    FMC_WEDGE15 = 26,
    /// Pyramid of second order, 3D, 13 nodes: the corners, then the middles of 01, 12, 23, 30, 04, 14, 24, 34.
    FMC_PYRAMID13 = 27,
    /// `FMC_QUAD8` with a ninth node in the middle of the cell.
    FMC_QUAD9 = 28,
    /// `FMC_HEX20` with nodes in the middles of the faces 0473, 1265, 0154, 3762, 0321, 4567 and of the cell: 27.
    FMC_HEX27 = 29,
}

/// Cells of one type; a mixed mesh has a block for each.
///
/// A cell may name nodes repeatedly, for example a hexahedron with an edge or a face collapsed to a point. It then is the
/// wedge, pyramid, tetrahedron or triangle that its faces form, also of second order. Cells and faces count as given.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct fmc_cell_block {
    /// A value of `fmc_cell_type`.
    pub cell_type: i32,
    /// Bytes of a node number, 4 or 8, the same in all blocks. All lists of nodes, cells, bodies' ids and degrees of freedom that go
    /// into the context or come out of it have this width.
    pub index_size: i32,
    /// Node numbers, (cell_count, nodes per cell), counted from the option `index_base`.
    pub conn: *const c_void,
    /// Number of cells; if 0, `conn` may be NULL.
    pub cell_count: usize,
}

fn cell_type(block: usize, number: i32) -> Result<CellType, Failure> {
    [
        (fmc_cell_type::FMC_TRI3, CellType::Tri3),
        (fmc_cell_type::FMC_QUAD4, CellType::Quad4),
        (fmc_cell_type::FMC_TET4, CellType::Tet4),
        (fmc_cell_type::FMC_HEX8, CellType::Hex8),
        (fmc_cell_type::FMC_WEDGE6, CellType::Wedge6),
        (fmc_cell_type::FMC_PYRAMID5, CellType::Pyramid5),
        (fmc_cell_type::FMC_TRI6, CellType::Tri6),
        (fmc_cell_type::FMC_QUAD8, CellType::Quad8),
        (fmc_cell_type::FMC_QUAD9, CellType::Quad9),
        (fmc_cell_type::FMC_TET10, CellType::Tet10),
        (fmc_cell_type::FMC_HEX20, CellType::Hex20),
        (fmc_cell_type::FMC_HEX27, CellType::Hex27),
        (fmc_cell_type::FMC_WEDGE15, CellType::Wedge15),
        (fmc_cell_type::FMC_PYRAMID13, CellType::Pyramid13),
    ]
    .into_iter()
    .find_map(|(name, cell_type)| (name as i32 == number).then_some(cell_type))
    .ok_or_else(|| {
        let text = format!("cell block {block} has the unknown cell type {number}");
        Failure::new(FMC_ERROR_UNKNOWN_CELL_TYPE, text)
    })
}

/// Node numbers of the host, counted from `index_base`, as numbers counted from zero.
pub(crate) struct Numbering {
    pub(crate) index_base: i32,
    pub(crate) node_count: usize,
}

impl Numbering {
    /// `ids` as rows of `width`; `first_row` is the number of the first in messages.
    pub(crate) fn zero_based<Id: Copy + Into<i64>>(
        &self,
        ids: &[Id],
        width: usize,
        first_row: usize,
    ) -> Result<Vec<u32>, Failure> {
        let convert = |(index, id): (usize, &Id)| {
            let node: i64 = (*id).into();
            let zero_based = node.checked_sub(self.index_base.into()).and_then(|node| usize::try_from(node).ok());
            match zero_based.filter(|node| *node < self.node_count) {
                Some(node) => u32::try_from(node)
                    .map_err(|_| Failure::new(FMC_ERROR_UNSUPPORTED, format!("node {node} is beyond 32 bits"))),
                None => {
                    let cell = first_row + index / width;
                    let error = Error::NodeOutOfRange { cell, node, node_count: self.node_count };
                    Err(Failure::counted_from(self.index_base)(error))
                }
            }
        };
        let mut list = Error::room("node numbers", ids.len())?;
        for numbered in ids.iter().enumerate().map(convert) {
            list.push(numbered?);
        }
        Ok(list)
    }
}

/// Body ids, one per cell or facet; `None` for NULL: connected components.
///
/// # Safety
/// The host guarantees `count` ids at `body_ids` if it is not NULL.
pub(crate) unsafe fn ids(body_ids: *const c_void, size: IndexSize, count: usize) -> Result<Option<Vec<i64>>, Failure> {
    if body_ids.is_null() {
        return Ok(None);
    }
    // SAFETY: passed on to the caller.
    Ok(Some(unsafe { size.list("body_ids", body_ids, count, 1) }?.into_owned()))
}

pub(crate) fn bodies(ids: &Option<Vec<i64>>) -> Bodies<'_> {
    ids.as_deref().map_or(Bodies::Connected, Bodies::Ids)
}

/// Boundary of the cells of `blocks`.
///
/// # Safety
/// The host guarantees the arrays of every block, and one body id per cell if there are any.
pub(crate) unsafe fn surface_of_cells<const D: usize>(
    coords: &[[f64; D]],
    blocks: &[fmc_cell_block],
    size: IndexSize,
    body_ids: *const c_void,
    options: &fmc_options,
) -> Result<Surface<D>, Failure> {
    let index_base = options.index_base;
    // SAFETY: passed on to the caller.
    let conn = unsafe { blocks_of::<D>(coords.len(), blocks, size, index_base) }?;
    let count = conn.iter().map(|(cell_type, conn)| conn.len() / cell_type.node_count()).sum();
    let blocks: Vec<_> = conn.iter().map(|(cell_type, conn)| CellBlock { cell_type: *cell_type, conn }).collect();
    // SAFETY: the caller guarantees one id per cell.
    let ids = unsafe { ids(body_ids, size, count) }?;
    Surface::from_cells_welded(coords, &blocks, bodies(&ids), options.weld).map_err(Failure::counted_from(index_base))
}

/// The width of the numbers of all blocks.
pub(crate) fn index_size(blocks: &[fmc_cell_block]) -> Result<IndexSize, Failure> {
    IndexSize::of_all("cell block", blocks.iter().map(|block| block.index_size))
}

/// Type and nodes of every block of cells, counted from zero.
///
/// # Safety
/// The host guarantees the arrays of every block.
pub(crate) unsafe fn blocks_of<const D: usize>(
    node_count: usize,
    blocks: &[fmc_cell_block],
    size: IndexSize,
    index_base: i32,
) -> Result<Vec<(CellType, Vec<u32>)>, Failure> {
    let numbering = Numbering { index_base, node_count };
    let mut conn = Vec::with_capacity(blocks.len());
    let mut count = 0_usize;
    for (index, block) in blocks.iter().enumerate() {
        let cell_type = cell_type(index, block.cell_type)?;
        let width = cell_type.node_count();
        // SAFETY: the caller guarantees the block's array.
        let given = unsafe { size.list("conn", block.conn, block.cell_count, width) }?;
        if cell_type.dimension() != D {
            return Err(Error::Dimension { block: index, expected: D, found: cell_type.dimension() }.into());
        }
        conn.push((cell_type, numbering.zero_based(&given, width, count)?));
        count += block.cell_count;
    }
    Ok(conn)
}

/// Node numbers, D per facet.
pub(crate) fn rows<const D: usize>(nodes: &[u32]) -> Vec<[u32; D]> {
    nodes.chunks_exact(D).map(|facet| std::array::from_fn(|corner| facet[corner])).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_out_of_range_are_reported_as_given() {
        let text = |index_base, ids: &[i64]| {
            let numbering = Numbering { index_base, node_count: 4 };
            numbering.zero_based(ids, 2, 10).map_err(|failure| failure.text)
        };
        assert_eq!(text(0, &[0, 3]), Ok(vec![0, 3]));
        assert_eq!(text(1, &[1, 4]), Ok(vec![0, 3]));
        let names = |cell, node| Err(format!("cell or facet {cell} names node {node}, but there are 4 nodes"));
        assert_eq!(text(0, &[0, 1, 2, 4]), names(11, "4"));
        assert_eq!(text(0, &[-1, 1]), names(10, "-1"));
        assert_eq!(text(0, &[i64::MIN, 1]), names(10, "-9223372036854775808"));
        let names = |cell, node| names(cell, node).map_err(|text| format!("{text}, counted from 1"));
        assert_eq!(text(1, &[1, 0]), names(11, "0"));
        assert_eq!(text(1, &[i64::MIN, 0]), names(11, "-9223372036854775808"));
    }
}
