//! Surfaces of facets of several types, also of second order.

use super::creation::create;
use crate::capi::boundary::dimension::checked_dimension;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::{reference, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_UNKNOWN_CELL_TYPE;
use crate::capi::context::resident::Resident;
use crate::capi::context::session::Session;
use crate::capi::context::state::fmc_context;
use crate::capi::structs::mesh::{Block, Numbering, bodies, ids};
use crate::capi::structs::options::fmc_options;
use crate::capi::structs::view::fmc_coords;
use crate::{Error, FacetBlock, FacetType, Surface};

/// Type of a facet of a surface. The numbers are those of VTK, and so is the node order. An edge has the body on its left; the
/// corners of a triangle or quadrilateral run counter-clockwise seen from outside.
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
    /// Node numbers, (facet_count, nodes per facet), counted from the option `index_base`.
    pub conn: *const i32,
    /// Number of facets; if 0, `conn` may be NULL.
    pub facet_count: usize,
}

/// `fmc_facet_block` with 64-bit node numbers.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct fmc_facet_block_i64 {
    /// A value of `fmc_facet_type`.
    pub facet_type: i32,
    /// Node numbers, (facet_count, nodes per facet), counted from the option `index_base`.
    pub conn: *const i64,
    /// Number of facets; if 0, `conn` may be NULL.
    pub facet_count: usize,
}

impl Block for fmc_facet_block {
    type Id = i32;
    fn parts(&self) -> (i32, *const i32, usize) {
        (self.facet_type, self.conn, self.facet_count)
    }
}

impl Block for fmc_facet_block_i64 {
    type Id = i64;
    fn parts(&self) -> (i32, *const i64, usize) {
        (self.facet_type, self.conn, self.facet_count)
    }
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
unsafe fn surface<B: Block, const D: usize>(
    coords: &[[f64; D]],
    blocks: &[B],
    body_ids: *const B::Id,
    index_base: i32,
) -> Result<Surface<D>, Failure> {
    let numbering = Numbering { index_base, node_count: coords.len() };
    let mut conn = Vec::with_capacity(blocks.len());
    let mut count = 0_usize;
    for (index, block) in blocks.iter().enumerate() {
        let (number, pointer, facet_count) = block.parts();
        let facet_type = facet_type(index, number)?;
        let width = facet_type.node_count();
        // SAFETY: the caller guarantees the block's array.
        let given = unsafe { slice("conn", pointer, facet_count, width) }?;
        if facet_type.dimension() != D {
            return Err(Error::Dimension { block: index, expected: D, found: facet_type.dimension() }.into());
        }
        conn.push((facet_type, numbering.zero_based(given, width, count)?));
        count += facet_count;
    }
    let blocks: Vec<_> = conn.iter().map(|(facet_type, conn)| FacetBlock { facet_type: *facet_type, conn }).collect();
    // SAFETY: the caller guarantees one id per facet.
    let ids = unsafe { ids(body_ids, count) }?;
    Surface::from_facet_blocks(coords, &blocks, bodies(&ids)).map_err(Failure::counted_from(index_base))
}

/// The session of such a surface.
///
/// # Safety
/// The host guarantees the coordinates, the blocks and what they point to, and one body id per facet if any.
unsafe fn session<B: Block, const D: usize>(
    coords: &fmc_coords,
    blocks: &[B],
    body_ids: *const B::Id,
    options: &fmc_options,
) -> Result<Box<dyn Session>, Failure> {
    let (checked, mut scratch) = (options.to_options()?, Vec::new());
    // SAFETY: passed on to the caller.
    let surface = unsafe {
        let rows = coords.rows::<D>("coords", &mut scratch)?;
        surface(rows, blocks, body_ids, options.index_base)?
    };
    Ok(Box::new(Resident::new(surface, checked)?))
}

/// Makes a context from a surface whose facets are of any type of `fmc_facet_type`, also of second order and mixed, in one
/// block for each type: the boundary facets of closed bodies.
///
/// Facets of second order are measured as the faces of cells of second order are, and give the same forces. In space
/// a straight edge and one with a node in its middle do not fit. `body_ids`, one for every facet counted over the blocks, may be
/// NULL: bodies are the connected components by nodes. Otherwise as `fmc_context_new_from_facets`; also
/// `FMC_ERROR_UNKNOWN_CELL_TYPE`, `FMC_ERROR_NON_CONFORMING`, and `FMC_ERROR_INVERTED_CELL` for a facet a part of which faces away
/// from the whole: a node in the middle of an edge nearer than an eighth of the edge to an end of it, along the edge.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_new_from_facet_blocks(
    dim: i32,
    coords: *const fmc_coords,
    blocks: *const fmc_facet_block,
    block_count: usize,
    body_ids: *const i32,
    options: *const fmc_options,
    context: *mut *mut fmc_context,
) -> fmc_status {
    // SAFETY: the host passes what the parameters say.
    unsafe { new_from_facet_blocks(dim, coords, blocks, block_count, body_ids, options, context) }
}

/// `fmc_context_new_from_facet_blocks` with 64-bit node numbers and body ids.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_new_from_facet_blocks_i64(
    dim: i32,
    coords: *const fmc_coords,
    blocks: *const fmc_facet_block_i64,
    block_count: usize,
    body_ids: *const i64,
    options: *const fmc_options,
    context: *mut *mut fmc_context,
) -> fmc_status {
    // SAFETY: the host passes what the parameters say.
    unsafe { new_from_facet_blocks(dim, coords, blocks, block_count, body_ids, options, context) }
}

/// # Safety
/// As `fmc_context_new_from_facet_blocks`.
unsafe fn new_from_facet_blocks<B: Block>(
    dim: i32,
    coords: *const fmc_coords,
    blocks: *const B,
    block_count: usize,
    body_ids: *const B::Id,
    options: *const fmc_options,
    context: *mut *mut fmc_context,
) -> fmc_status {
    // SAFETY: passed on to the caller.
    unsafe {
        create(options, context, |options| {
            let dim = checked_dimension(dim)?;
            let (coords, blocks) = (reference("coords", coords)?, slice("blocks", blocks, block_count, 1)?);
            match dim {
                2 => session::<B, 2>(coords, blocks, body_ids, options),
                _ => session::<B, 3>(coords, blocks, body_ids, options),
            }
        })
    }
}
