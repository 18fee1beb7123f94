//! Surfaces of facets of several types, also of second order.

use super::creation::create;
use crate::capi::boundary::dimension::checked_dimension;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::index::IndexSize;
use crate::capi::boundary::pointer::{reference, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_UNKNOWN_CELL_TYPE;
use crate::capi::context::resident::Resident;
use crate::capi::context::session::Session;
use crate::capi::context::state::fmc_context;
use crate::capi::structs::mesh::{Numbering, bodies, ids};
use crate::capi::structs::options::fmc_options;
use crate::capi::structs::view::fmc_coords;
use crate::{Error, FacetBlock, FacetType, Surface};
use std::ffi::c_void;

/// Type of a facet of a surface. Numbers and node order are as in VTK. An edge has the body on its left; the corners of a
/// triangle or quadrilateral run counter-clockwise seen from outside.
#[repr(C)]
pub enum fmc_facet_type {
    /// Edge, 2D, 2 nodes.
    FMC_FACET_LINE2 = 3,
    /// Triangle, 3D, 3 nodes.
    FMC_FACET_TRI3 = 5,
    /// Quadrilateral, 3D, 4 nodes: four triangles about its middle, as a face of `FMC_HEX8`.
    FMC_FACET_QUAD4 = 9,
    /// Edge of second order, 2D, 3 nodes: its ends, then its middle.
    FMC_FACET_LINE3 = 21,
    /// Triangle of second order, 3D, 6 nodes: the corners, then the middles of the edges 01, 12, 20.
    FMC_FACET_TRI6 = 22,
    /// Quadrilateral of second order, 3D, 8 nodes: the corners, then the middles of 01, 12, 23, 30. A face of `FMC_HEX20`.
    FMC_FACET_QUAD8 = 23,
    /// `FMC_FACET_QUAD8` with a ninth node in its middle. A face of `FMC_HEX27`.
    FMC_FACET_QUAD9 = 28,
}

/// Facets of one type; a mixed surface has a block for each.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct fmc_facet_block {
    /// A value of `fmc_facet_type`.
    pub facet_type: i32,
    /// Bytes of a node number, 4 or 8, as in `fmc_cell_block`.
    pub index_size: i32,
    /// Node numbers, (facet_count, nodes per facet), counted from the option `index_base`.
    pub conn: *const c_void,
    /// Number of facets; if 0, `conn` may be NULL.
    pub facet_count: usize,
}

fn facet_type(block: usize, number: i32) -> Result<FacetType, Failure> {
    [
        (fmc_facet_type::FMC_FACET_LINE2, FacetType::Line2),
        (fmc_facet_type::FMC_FACET_TRI3, FacetType::Tri3),
        (fmc_facet_type::FMC_FACET_QUAD4, FacetType::Quad4),
        (fmc_facet_type::FMC_FACET_LINE3, FacetType::Line3),
        (fmc_facet_type::FMC_FACET_TRI6, FacetType::Tri6),
        (fmc_facet_type::FMC_FACET_QUAD8, FacetType::Quad8),
        (fmc_facet_type::FMC_FACET_QUAD9, FacetType::Quad9),
    ]
    .into_iter()
    .find_map(|(name, facet_type)| (name as i32 == number).then_some(facet_type))
    .ok_or_else(|| {
        let text = format!("facet block {block} has the unknown facet type {number}");
        Failure::new(FMC_ERROR_UNKNOWN_CELL_TYPE, text)
    })
}

/// Surface given by the facets of `blocks`.
///
/// # Safety
/// The host guarantees the array of every block, and one body id per facet if there are any.
unsafe fn surface<const D: usize>(
    coords: &[[f64; D]],
    blocks: &[fmc_facet_block],
    size: IndexSize,
    body_ids: *const c_void,
    index_base: i32,
) -> Result<Surface<D>, Failure> {
    let numbering = Numbering { index_base, node_count: coords.len() };
    let mut conn = Vec::with_capacity(blocks.len());
    let mut count = 0_usize;
    for (index, block) in blocks.iter().enumerate() {
        let facet_type = facet_type(index, block.facet_type)?;
        let width = facet_type.node_count();
        // SAFETY: the caller guarantees the block's array.
        let given = unsafe { size.list("conn", block.conn, block.facet_count, width) }?;
        if facet_type.dimension() != D {
            return Err(Error::Dimension { block: index, expected: D, found: facet_type.dimension() }.into());
        }
        conn.push((facet_type, numbering.zero_based(&given, width, count)?));
        count += block.facet_count;
    }
    let blocks: Vec<_> = conn.iter().map(|(facet_type, conn)| FacetBlock { facet_type: *facet_type, conn }).collect();
    // SAFETY: the caller guarantees one id per facet.
    let ids = unsafe { ids(body_ids, size, count) }?;
    Surface::from_facet_blocks(coords, &blocks, bodies(&ids)).map_err(Failure::counted_from(index_base))
}

/// The session of such a surface, and the width of its numbers.
///
/// # Safety
/// The host guarantees the coordinates, the blocks and what they point to, and one body id per facet if any.
unsafe fn session<const D: usize>(
    coords: &fmc_coords,
    blocks: &[fmc_facet_block],
    body_ids: *const c_void,
    options: &fmc_options,
) -> Result<(Session, IndexSize), Failure>
where
    Session: From<Resident<D>>,
{
    options.refuse_weld("bodies given by facets")?;
    let (checked, mut scratch) = (options.to_options()?, Vec::new());
    let size = IndexSize::of_all("facet block", blocks.iter().map(|block| block.index_size))?;
    // SAFETY: passed on to the caller.
    let surface = unsafe {
        let rows = coords.rows::<D>("coords", &mut scratch)?;
        surface(rows, blocks, size, body_ids, options.index_base)?
    };
    Ok((Resident::new(surface, checked)?.into(), size))
}

/// Makes a context from a surface: the boundary facets of closed bodies, of any types of `fmc_facet_type`, in one block for each type.
///
/// An edge has its body on the left, other facets run counter-clockwise seen from outside. Facets of second order are measured like
/// faces of cells of second order, and give the same forces. In 3D an edge with a mid-side node does not conform to a straight edge.
/// `body_ids`, one for every facet counted over the blocks, of the same width as node numbers, may be NULL: bodies are the connected
/// components by nodes. Otherwise as `fmc_context_new_from_cells`; also `FMC_ERROR_OPEN_SURFACE`,
/// `FMC_ERROR_INCONSISTENT_ORIENTATION`, `FMC_ERROR_INVERTED_SURFACE`, `FMC_ERROR_NON_CONFORMING`, and `FMC_ERROR_INVERTED_CELL` for a
/// facet of which a part faces the other way. A mid-side node too near to a corner causes this: nearer than an eighth of the edge,
/// along the edge.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_new_from_facets(
    dim: i32,
    coords: *const fmc_coords,
    blocks: *const fmc_facet_block,
    block_count: usize,
    body_ids: *const c_void,
    options: *const fmc_options,
    context: *mut *mut fmc_context,
) -> fmc_status {
    // SAFETY: the host passes what the parameters say.
    unsafe {
        create(options, context, |options| {
            let dim = checked_dimension(dim)?;
            let (coords, blocks) = (reference("coords", coords)?, slice("blocks", blocks, block_count, 1)?);
            match dim {
                2 => session::<2>(coords, blocks, body_ids, options),
                _ => session::<3>(coords, blocks, body_ids, options),
            }
        })
    }
}
