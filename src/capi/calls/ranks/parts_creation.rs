//! A context of a mesh that ranks hold in parts.

use super::communicator::{HostRanks, fmc_communicator};
use crate::capi::boundary::dimension::checked_dimension;
use crate::capi::boundary::failure::Failure;
use crate::capi::boundary::pointer::{reference, slice};
use crate::capi::boundary::status::fmc_status;
use crate::capi::boundary::status::fmc_status::FMC_ERROR_STRUCT_SIZE;
use crate::capi::calls::mesh::creation::create;
use crate::capi::context::resident::Resident;
use crate::capi::context::session::Session;
use crate::capi::context::state::fmc_context;
use crate::capi::structs::mesh::{blocks_of, fmc_cell_block};
use crate::capi::structs::options::fmc_options;
use crate::capi::structs::view::fmc_coords;
use crate::{CellBlock, CellType, MeshPart, Options, PartitionedContact};

/// The cells of one rank, with their nodes. Every cell of the mesh is given by one rank, and only by that one; nodes between
/// ranks are given by all that have a cell there. A rank may have none.
#[repr(C)]
#[derive(Clone, Copy)]
pub struct fmc_mesh_part {
    /// sizeof(fmc_mesh_part), set by the host.
    pub struct_size: usize,
    /// Coordinates of the rank's own nodes without deformation.
    pub coords: fmc_coords,
    /// Number of each in the whole mesh, the same on all ranks that have it; not negative. Results are those of one rank alone whose
    /// mesh has its nodes in the order of these numbers; they need not be without gaps.
    pub node_numbers: *const i64,
    /// Cells, of own nodes counted from the option `index_base`.
    pub blocks: *const fmc_cell_block,
    pub block_count: usize,
    /// Number of each cell in the whole mesh, over all blocks. Results are those of a mesh with its cells in the order of these.
    pub cell_numbers: *const i64,
    /// Body of each cell, as all ranks name it.
    pub body_ids: *const i32,
    /// How far `fmc_context_gap_constraints` may reach; 0 where it is not asked for.
    pub reach: f64,
}

/// Makes a context of a mesh of which this rank has a part; all ranks call it together. Then every rank has, beside its own cells,
/// only those that may be in contact: `fmc_context_set_coords` takes the coordinates of the own nodes, and after it the other
/// functions of the context are used as with a whole mesh, with the nodes that `fmc_context_gathered_nodes` names, by all ranks
/// together, which share the work. Results have the bits of one rank with the whole mesh, for any number of ranks.
///
/// Nodes that are named to lie in planes of symmetry are own nodes; `fmc_context_set_coords` is called again after it. A body that may
/// touch itself, and one that by the law `FMC_LAW_DEPTH` or with friction meets an obstacle with facets, is gathered whole.
/// Refused are nodes that hang, another reference, a basis, and another communicator. It begins at the coordinates of the part.
///
/// Errors: as `fmc_context_new_from_cells` and `fmc_context_set_communicator`, naming own nodes and cells; `FMC_ERROR_ON_OTHER_RANK`
/// where it failed on another rank. Threads: any, also at once.
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

/// A part as the host gave it, with nodes counted from zero.
struct Given<'a, const D: usize> {
    coords: &'a [[f64; D]],
    conn: Vec<(CellType, Vec<u32>)>,
    node_numbers: &'a [i64],
    cell_numbers: &'a [i64],
    body_ids: &'a [i32],
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
    // SAFETY: passed on to the caller.
    let part = unsafe { reference("part", part) }?;
    if part.struct_size != size_of::<fmc_mesh_part>() {
        return Err(Failure::new(FMC_ERROR_STRUCT_SIZE, "'struct_size' of the part is not that of the struct"));
    }
    // SAFETY: as above.
    unsafe {
        let coords = part.coords.rows::<D>("coords", scratch)?;
        let blocks = slice("blocks", part.blocks, part.block_count, 1)?;
        let conn = blocks_of::<_, D>(coords.len(), blocks, options.index_base)?;
        let count = conn.iter().map(|(cell_type, conn)| conn.len() / cell_type.node_count()).sum();
        Ok(Given {
            coords,
            conn,
            node_numbers: slice("node_numbers", part.node_numbers, coords.len(), 1)?,
            cell_numbers: slice("cell_numbers", part.cell_numbers, count, 1)?,
            body_ids: slice("body_ids", part.body_ids, count, 1)?,
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
) -> Result<Box<dyn Session>, Failure> {
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
    let unsigned = |numbers: &[i64]| numbers.iter().map(|number| *number as u64).collect::<Vec<_>>();
    let part = MeshPart {
        coords: given.coords,
        node_numbers: &unsigned(given.node_numbers),
        blocks: &blocks,
        cell_numbers: &unsigned(given.cell_numbers),
        body_ids: &given.body_ids.iter().map(|id| i64::from(*id)).collect::<Vec<_>>(),
    };
    let parts = PartitionedContact::new(Box::new(ranks), &part, given.options, given.reach);
    Ok(Box::new(Resident::of_parts(parts.map_err(Failure::counted_from(options.index_base))?)))
}
