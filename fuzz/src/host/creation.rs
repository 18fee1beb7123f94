//! Contexts from cells and from facets.

use super::Host;
use super::array::{Array, checked};
use super::numbers::Numbers;
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
    let conn: Vec<Numbers> = conn.iter().map(|conn| Numbers::new(conn, is_wide)).collect();
    let ids = mesh.ids.as_ref().map(|ids| Numbers::new(ids, is_wide));
    let blocks: Vec<fmc_cell_block> = (mesh.blocks.iter().zip(&conn))
        .map(|((cell_type, nodes), conn)| fmc_cell_block {
            cell_type: *cell_type,
            index_size: Numbers::size(is_wide),
            conn: conn.ptr(),
            cell_count: nodes.len() / cell_size(*cell_type),
        })
        .collect();
    let ids = ids.as_ref().map_or(null(), |ids| ids.ptr().cast_const());
    let dim = mesh.dim as i32;
    // SAFETY: arrays as long as they are said to be, alive during the call.
    let status = unsafe {
        fmc_context_new_from_cells(dim, &coords.view, blocks.as_ptr(), blocks.len(), ids, options, &mut context)
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
            let conn = blocks.map(|(_, nodes, _)| Numbers::new(nodes, is_wide));
            let block = |k: usize| fmc_facet_block {
                facet_type: blocks[k].0,
                index_size: Numbers::size(is_wide),
                conn: conn[k].ptr(),
                facet_count: blocks[k].2,
            };
            let both = [block(0), block(1)];
            let status = checked(fmc_context_new_from_facets(dim, &coords.view, both.as_ptr(), 2, null(), o, to));
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
            let facets = Numbers::new(facets, is_wide);
            let facet_type = if dim == 2 { FMC_FACET_LINE2 } else { FMC_FACET_TRI3 };
            let index_size = Numbers::size(is_wide);
            let block = fmc_facet_block { facet_type, index_size, conn: facets.ptr(), facet_count: count };
            let (options, to) = (&raw const self.options, &raw mut context);
            let status = checked(fmc_context_new_from_facets(dim, &coords.view, &block, 1, null(), options, to));
            assert_eq!(status == OK, !context.is_null());
            assert_eq!(fmc_context_free(&raw mut context), OK);
        }
    }
}
