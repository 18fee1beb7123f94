//! Contexts from cells and from facets.

use super::Host;
use super::array::{Array, checked};
use crate::guarded::Guarded;
use crate::interface::*;
use crate::mesh::Mesh;
use crate::program::Layout;
use std::ptr::{null, null_mut};

/// Nodes of a cell of a type.
pub(crate) fn cell_size(cell_type: i32) -> usize {
    const SIZES: [(i32, usize); 14] = [
        (5, 3),
        (9, 4),
        (10, 4),
        (12, 8),
        (13, 6),
        (14, 5),
        (22, 6),
        (23, 8),
        (24, 10),
        (25, 20),
        (26, 15),
        (27, 13),
        (28, 9),
        (29, 27),
    ];
    SIZES.iter().find(|(number, _)| *number == cell_type).map_or(4, |(_, size)| *size)
}

pub(crate) fn create(mesh: &Mesh, is_wide: bool, options: &fmc_options) -> Option<*mut fmc_context> {
    let coords = Array::new(&mesh.coords, mesh.dim, Layout::Rows);
    let mut context = null_mut();
    let base = i64::from(options.index_base);
    let conn: Vec<Vec<i64>> =
        mesh.blocks.iter().map(|(_, conn)| conn.iter().map(|node| node + base).collect()).collect();
    // SAFETY: arrays as long as they are said to be, alive during the call.
    let status = unsafe {
        if is_wide {
            let conn: Vec<Guarded<i64>> = conn.iter().map(|conn| Guarded::new(conn)).collect();
            let ids = mesh.ids.as_ref().map(|ids| Guarded::new(ids));
            let blocks: Vec<fmc_cell_block_i64> = (mesh.blocks.iter().zip(&conn))
                .map(|((cell_type, nodes), conn)| fmc_cell_block_i64 {
                    cell_type: *cell_type,
                    conn: conn.ptr(),
                    cell_count: nodes.len() / cell_size(*cell_type),
                })
                .collect();
            let ids = ids.as_ref().map_or(null(), |ids| ids.ptr().cast_const());
            let dim = mesh.dim as i32;
            fmc_context_new_from_cells_i64(dim, &coords.view, blocks.as_ptr(), blocks.len(), ids, options, &mut context)
        } else {
            let narrow = |values: &[i64]| Guarded::new(&values.iter().map(|&v| v as i32).collect::<Vec<_>>());
            let conn: Vec<Guarded<i32>> = conn.iter().map(|conn| narrow(conn)).collect();
            let ids = mesh.ids.as_ref().map(|ids| narrow(ids));
            let blocks: Vec<fmc_cell_block> = (mesh.blocks.iter().zip(&conn))
                .map(|((cell_type, nodes), conn)| fmc_cell_block {
                    cell_type: *cell_type,
                    conn: conn.ptr(),
                    cell_count: nodes.len() / cell_size(*cell_type),
                })
                .collect();
            let ids = ids.as_ref().map_or(null(), |ids| ids.ptr().cast_const());
            let dim = mesh.dim as i32;
            fmc_context_new_from_cells(dim, &coords.view, blocks.as_ptr(), blocks.len(), ids, options, &mut context)
        }
    };
    assert_eq!(checked(status) == OK, !context.is_null());
    (status == OK).then_some(context)
}

impl Host {
    /// The same from two blocks of facets of these types, known or not.
    pub(super) fn from_facet_blocks(&self, facets: &[u8], types: [u8; 2], is_wide: bool) {
        const TYPES: [(i32, usize); 8] = [(3, 2), (5, 3), (9, 4), (21, 3), (22, 6), (23, 8), (28, 9), (7, 5)];
        let n = self.mesh.node_count() as i64 + 1;
        let all: Vec<i64> = facets.iter().take(72).map(|f| i64::from(*f) % n).collect();
        let halves = all.split_at(all.len() / 2);
        let blocks = [(halves.0, types[0]), (halves.1, types[1])].map(|(nodes, of)| {
            let (number, width) = TYPES[usize::from(of) % TYPES.len()];
            (number, &nodes[..nodes.len() / width * width], nodes.len() / width)
        });
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let (dim, mut context) = (self.mesh.dim as i32, null_mut());
        let (o, to) = (&raw const self.options, &raw mut context);
        // SAFETY: arrays as long as they are said to be; the context is given back.
        unsafe {
            let status = checked(if is_wide {
                let conn = blocks.map(|(_, nodes, _)| Guarded::new(nodes));
                let block = |k: usize| fmc_facet_block_i64 {
                    facet_type: blocks[k].0,
                    conn: conn[k].ptr(),
                    facet_count: blocks[k].2,
                };
                fmc_context_new_from_facet_blocks_i64(
                    dim,
                    &coords.view,
                    [block(0), block(1)].as_ptr(),
                    2,
                    null(),
                    o,
                    to,
                )
            } else {
                let conn =
                    blocks.map(|(_, nodes, _)| Guarded::new(&nodes.iter().map(|&f| f as i32).collect::<Vec<_>>()));
                let block = |k: usize| fmc_facet_block {
                    facet_type: blocks[k].0,
                    conn: conn[k].ptr(),
                    facet_count: blocks[k].2,
                };
                fmc_context_new_from_facet_blocks(dim, &coords.view, [block(0), block(1)].as_ptr(), 2, null(), o, to)
            });
            assert_eq!(status == OK, !context.is_null());
            assert_eq!(fmc_context_free(to), OK);
        }
    }

    /// A context of its own, from facets of any kind on the nodes that are there.
    pub(super) fn from_facets(&self, facets: &[u8], is_wide: bool) {
        let n = self.mesh.node_count() as i64 + 1;
        let facets: Vec<i64> = facets.iter().take(24).map(|f| i64::from(*f) % n).collect();
        let count = facets.len() / self.mesh.dim;
        let facets = &facets[..count * self.mesh.dim];
        let coords = Array::new(&self.mesh.coords, self.mesh.dim, Layout::Rows);
        let (dim, mut context) = (self.mesh.dim as i32, null_mut());
        // SAFETY: arrays as long as they are said to be; the context is given back.
        unsafe {
            let status = checked(if is_wide {
                let facets = Guarded::new(facets);
                let ids = null();
                fmc_context_new_from_facets_i64(
                    dim,
                    &coords.view,
                    facets.ptr(),
                    count,
                    ids,
                    &raw const self.options,
                    &raw mut context,
                )
            } else {
                let facets = Guarded::new(&facets.iter().map(|&f| f as i32).collect::<Vec<_>>());
                let ids = null();
                fmc_context_new_from_facets(
                    dim,
                    &coords.view,
                    facets.ptr(),
                    count,
                    ids,
                    &raw const self.options,
                    &raw mut context,
                )
            });
            assert_eq!(status == OK, !context.is_null());
            assert_eq!(fmc_context_free(&raw mut context), OK);
        }
    }
}
