//! A context of a mesh that ranks hold in parts.

use super::communicator::{HostRanks, fmc_communicator};
use crate::capi::boundary::dimension::checked_dimension;
use crate::capi::boundary::entry::entry;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::given_struct::check_struct;
use crate::capi::boundary::index::IndexSize;
use crate::capi::boundary::pointer::{Output, reference, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_INDEX_SIZE;
use crate::capi::calls::mesh::creation::create;
use crate::capi::context::resident::Resident;
use crate::capi::context::session::Session;
use crate::capi::context::state::fmc_context;
use crate::capi::structs::mesh::{blocks_of, fmc_cell_block};
use crate::capi::structs::options::fmc_options;
use crate::capi::structs::view::fmc_coords;
use crate::{CellBlock, CellType, MeshPart, Options, PartitionedContact};
use std::ffi::c_void;
use std::ptr::null;

/// The cells of one rank, with their nodes. Every cell of the mesh is given by one rank, and only by that one; nodes between
/// ranks are given by all that have a cell there. A rank may have none. Initialise it with `fmc_mesh_part_init`, then set all fields.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct fmc_mesh_part {
    /// Set by `fmc_mesh_part_init`, so that the library recognises an uninitialised struct.
    pub struct_size: usize,
    /// Coordinates of the rank's own nodes without deformation.
    pub coords: fmc_coords,
    /// Bytes of a number in the lists here and in the blocks, 4 or 8, and in all lists of the context; the same on all ranks.
    pub index_size: i32,
    /// Zero. Room for switches of later versions.
    pub reserved_flags: i32,
    /// Number of each in the whole mesh, counted from the option `index_base`, the same on all ranks that have it. Results are
    /// identical to one rank whose mesh has its nodes in the order of these numbers, which may have gaps.
    pub node_numbers: *const c_void,
    /// Cells, of own nodes counted from the option `index_base`.
    pub blocks: *const fmc_cell_block,
    /// Number of blocks.
    pub block_count: usize,
    /// Number of each cell in the whole mesh, over all blocks, counted from the option `index_base`. Results are identical to a mesh with
    /// its cells in the order of these numbers.
    pub cell_numbers: *const c_void,
    /// Body of each cell, as all ranks name it.
    pub body_ids: *const c_void,
    /// Largest `reach` of `fmc_context_gap_constraints`; 0 if it is not called.
    pub reach: f64,
    /// Zero. Room for later versions.
    pub reserved: [u64; 4],
}

impl Default for fmc_mesh_part {
    fn default() -> Self {
        Self {
            struct_size: size_of::<Self>(),
            coords: fmc_coords { data: null(), node_count: 0, node_stride: 0, axis_stride: 0 },
            index_size: 0,
            reserved_flags: 0,
            node_numbers: null(),
            blocks: null(),
            block_count: 0,
            cell_numbers: null(),
            body_ids: null(),
            reach: 0.0,
            reserved: [0; 4],
        }
    }
}

/// Sets a part to one without nodes and cells.
///
/// Errors: `FMC_ERROR_NULL_POINTER`. Threads: any, on different structs.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_mesh_part_init(part: *mut fmc_mesh_part) -> fmc_status {
    entry(|| {
        let output = Output::required("part", part)?;
        // SAFETY: the host passes a struct that may be written.
        unsafe { output.write(fmc_mesh_part::default()) };
        Ok(())
    })
}

/// Makes a context of a mesh of which this rank has a part; all ranks call it together. Then every rank has its own cells and all
/// cells that may be in contact. `fmc_context_set_coords` takes the coordinates of the own nodes. After it all ranks call the
/// other functions of the context together, as with a whole mesh, with the nodes that `fmc_context_gathered_nodes` names, and
/// share the work. Results are bit-for-bit identical to one rank with the whole mesh, for any number of ranks.
///
/// Nodes in planes of symmetry are given as own nodes; call `fmc_context_set_coords` again after it. A body that may touch itself, and
/// one that by the law `FMC_LAW_DEPTH` or with friction meets an obstacle with facets, is gathered whole. Hanging nodes, another
/// reference, a basis, and another communicator are refused. It begins at the coordinates of the part.
///
/// Errors: as `fmc_context_new_from_cells` and `fmc_context_set_communicator`, naming own nodes and cells; `FMC_ERROR_ON_OTHER_RANK`
/// if it failed on another rank. Threads: any, also at once.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmc_context_new_from_part(
    dim: i32,
    communicator: *const fmc_communicator,
    part: *const fmc_mesh_part,
    options: *const fmc_options,
    context: *mut *mut fmc_context,
) -> fmc_status {
    // SAFETY: the host passes what the parameters say.
    unsafe {
        create(options, context, |options| {
            let ranks = HostRanks::new(reference("communicator", communicator)?)?;
            match checked_dimension(dim) {
                Ok(2) => session::<2>(ranks, part, options),
                Ok(_) => session::<3>(ranks, part, options),
                Err(failure) => {
                    PartitionedContact::<2>::refuse(Box::new(ranks));
                    Err(failure)
                }
            }
        })
    }
}

/// A part as the host gave it, counted from zero.
struct Given<'a, const D: usize> {
    coords: &'a [[f64; D]],
    conn: Vec<(CellType, Vec<u32>)>,
    node_numbers: Vec<u64>,
    cell_numbers: Vec<u64>,
    body_ids: Vec<i64>,
    size: IndexSize,
    reach: f64,
    options: Options,
}

/// # Safety
/// The host guarantees the part and what it points to.
unsafe fn read<'a, const D: usize>(
    part: *const fmc_mesh_part,
    options: &fmc_options,
    scratch: &'a mut Vec<[f64; D]>,
) -> Result<Given<'a, D>, Failure> {
    options.refuse_weld("a mesh in parts")?;
    // SAFETY: passed on to the caller.
    let part = unsafe { reference("part", part) }?;
    check_struct::<fmc_mesh_part>(
        "fmc_mesh_part",
        part.struct_size,
        part.reserved.into_iter().chain([part.reserved_flags as u64]),
    )?;
    let size = IndexSize::new("the part", part.index_size)?;
    // SAFETY: as above.
    unsafe {
        let coords = part.coords.rows::<D>("coords", scratch)?;
        let blocks = slice("blocks", part.blocks, part.block_count, 1)?;
        if let Some(other) = blocks.iter().position(|block| block.index_size != part.index_size) {
            let text = format!("cell block {other} has another index_size than the part, {}", part.index_size);
            return Err(Failure::new(FMC_ERROR_INDEX_SIZE, text));
        }
        let conn = blocks_of::<D>(coords.len(), blocks, size, options.index_base)?;
        let count = conn.iter().map(|(cell_type, conn)| conn.len() / cell_type.node_count()).sum();
        let of_whole = |name, list, count| {
            // What is negative is refused by the core, as what is too large.
            let zero_based = |number: &i64| number.wrapping_sub(options.index_base.into()) as u64;
            Ok::<_, Failure>(size.list(name, list, count, 1)?.iter().map(zero_based).collect())
        };
        Ok(Given {
            coords,
            conn,
            node_numbers: of_whole("node_numbers", part.node_numbers, coords.len())?,
            cell_numbers: of_whole("cell_numbers", part.cell_numbers, count)?,
            body_ids: size.list("body_ids", part.body_ids, count, 1)?.into_owned(),
            size,
            reach: part.reach,
            options: options.to_options()?,
        })
    }
}

/// # Safety
/// The host guarantees the part and what it points to.
unsafe fn session<const D: usize>(
    ranks: HostRanks,
    part: *const fmc_mesh_part,
    options: &fmc_options,
) -> Result<(Session, IndexSize), Failure>
where
    Session: From<Resident<D>>,
{
    let mut scratch = Vec::new();
    // SAFETY: passed on to the caller.
    let given = match unsafe { read::<D>(part, options, &mut scratch) } {
        Ok(given) => given,
        Err(failure) => {
            PartitionedContact::<D>::refuse(Box::new(ranks));
            return Err(failure);
        }
    };
    let blocks: Vec<_> = given.conn.iter().map(|(cell_type, conn)| CellBlock { cell_type: *cell_type, conn }).collect();
    let part = MeshPart {
        coords: given.coords,
        node_numbers: &given.node_numbers,
        blocks: &blocks,
        cell_numbers: &given.cell_numbers,
        body_ids: &given.body_ids,
    };
    let parts = PartitionedContact::new(Box::new(ranks), &part, given.options, given.reach);
    let parts = parts.map_err(Failure::counted_from(options.index_base))?;
    Ok((Resident::of_parts(parts).into(), given.size))
}
