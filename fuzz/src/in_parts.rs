//! A mesh in one part beside the same mesh whole.

use crate::guarded::Guarded;
use crate::host::{Array, Numbers, cell_size, checked, create, echo, to_itself, unless};
use crate::interface::*;
use crate::mesh::Mesh;
use crate::program::{Hole, Layout};
use std::ptr::null_mut;

/// Makes both from the same arrays, evaluates both where they are, and holds the bits of one against those of the other.
pub(crate) fn beside_the_whole(mesh: &Mesh, options: &fmc_options, reach: f64, hole: Hole) {
    let count = mesh.blocks.iter().map(|(cell_type, conn)| conn.len() / cell_size(*cell_type)).sum();
    let mut mesh = mesh.clone();
    let ids = mesh.ids.get_or_insert_with(|| vec![0; count]).clone();
    let whole = create(&mesh, false, options);
    let part = of_part(&mesh, &ids, options, reach, hole);
    // SAFETY: contexts of this function, and arrays as long as they are said to be.
    unsafe {
        if let (Some(mut whole), Some(mut part)) = (whole, part) {
            let (is_wide, base) = (hole % 3 == 1, i64::from(options.index_base));
            compare(&mesh, whole, part, is_wide, base);
            carry(&mesh, part, reach, hole, base);
            assert_eq!((fmc_context_free(&raw mut whole), fmc_context_free(&raw mut part)), (OK, OK));
            return;
        }
        for mut context in [whole, part].into_iter().flatten() {
            assert_eq!(fmc_context_free(&raw mut context), OK);
        }
    }
}

fn of_part(mesh: &Mesh, ids: &[i64], options: &fmc_options, reach: f64, hole: Hole) -> Option<*mut fmc_context> {
    let coords = Array::new(&mesh.coords, mesh.dim, Layout::Rows);
    let (base, is_wide) = (i64::from(options.index_base), hole % 3 == 1);
    let based = |values: &[i64]| Numbers::new(&values.iter().map(|value| value + base).collect::<Vec<_>>(), is_wide);
    let conn: Vec<Numbers> = mesh.blocks.iter().map(|(_, conn)| based(conn)).collect();
    let blocks: Vec<fmc_cell_block> = (mesh.blocks.iter().zip(&conn))
        .map(|((cell_type, nodes), conn)| fmc_cell_block {
            cell_type: *cell_type,
            index_size: Numbers::size(is_wide),
            conn: conn.ptr(),
            cell_count: nodes.len() / cell_size(*cell_type),
        })
        .collect();
    let numbers = |count: usize| based(&(0..count as i64).collect::<Vec<_>>());
    let (nodes, cells, ids) = (numbers(mesh.node_count()), numbers(ids.len()), Numbers::new(ids, is_wide));
    let mut context = null_mut();
    // SAFETY: structs of this interface; arrays as long as they are said to be, alive during the call.
    unsafe {
        let mut ranks = std::mem::MaybeUninit::<fmc_communicator>::zeroed().assume_init();
        assert_eq!(checked(fmc_communicator_init(&raw mut ranks)), OK);
        ranks.all_gather = Some(echo);
        ranks.user = std::ptr::without_provenance_mut(256);
        ranks.all_to_all = (hole % 2 == 0).then_some(to_itself);
        let mut part = fmc_mesh_part::default();
        assert_eq!(checked(fmc_mesh_part_init(&raw mut part)), OK);
        (part.coords, part.index_size, part.reach) = (coords.view, Numbers::size(is_wide), reach);
        part.node_numbers = unless(hole, 1, nodes.ptr());
        (part.blocks, part.block_count) = (blocks.as_ptr(), blocks.len());
        part.cell_numbers = unless(hole, 2, cells.ptr());
        part.body_ids = unless(hole, 3, ids.ptr());
        let part = unless(hole, 0, (&raw const part).cast_mut());
        let status = checked(fmc_context_new_from_part(mesh.dim as i32, &ranks, part, options, &mut context));
        assert_eq!(status == OK, !context.is_null());
        (status == OK).then_some(context)
    }
}

/// # Safety
/// Contexts that live.
unsafe fn compare(mesh: &Mesh, whole: *mut fmc_context, part: *mut fmc_context, is_wide: bool, base: i64) {
    let coords = Array::new(&mesh.coords, mesh.dim, Layout::Rows);
    let of_whole = Array::new(&vec![0.0; mesh.coords.len()], mesh.dim, Layout::Rows);
    // SAFETY: as above; arrays as long as they are said to be.
    unsafe {
        let mut expected = std::mem::zeroed::<fmc_result>();
        let status = checked(fmc_context_evaluate(whole, &coords.view, &of_whole.out(), 0, &mut expected));
        let brought = checked(fmc_context_set_coords(part, &coords.view, null_mut()));
        let mut counts = fmc_gathered_counts::default();
        assert_eq!(checked(fmc_context_gathered_counts(part, &mut counts)), OK);
        assert!(checked(fmc_context_gathered_counts(whole, &mut counts)) != OK, "a whole mesh has no parts");
        if brought != OK {
            // Nodes that hang are refused in parts alone.
            assert!(status != OK || brought == FMC_ERROR_UNSUPPORTED, "whole {status}, brought {brought}");
            return;
        }
        let count = counts.node_count as usize;
        let (numbers, own) = (Numbers::new(&vec![-7; count], is_wide), Numbers::new(&vec![-7; count], is_wide));
        let none = null_mut();
        let x = Guarded::new(&vec![0.0; count * mesh.dim]);
        assert_eq!(checked(fmc_context_gathered_nodes(part, numbers.ptr(), own.ptr(), x.ptr(), count, none)), OK);
        let cells = Numbers::new(&vec![-7; counts.cell_count as usize], is_wide);
        assert_eq!(checked(fmc_context_gathered_cells(part, cells.ptr(), counts.cell_count as usize, none)), OK);
        assert!(
            count == 0
                || checked(fmc_context_gathered_nodes(part, numbers.ptr(), null_mut(), null_mut(), count - 1, none))
                    != OK
        );
        let (x, forces) = (x.values(), Array::new(&vec![0.0; count * mesh.dim], mesh.dim, Layout::Rows));
        let gathered = Array::new(&x, mesh.dim, Layout::Rows);
        let mut found = std::mem::zeroed::<fmc_result>();
        let in_parts = checked(fmc_context_evaluate(part, &gathered.view, &forces.out(), 0, &mut found));
        assert_eq!(in_parts, status, "in parts and whole");
        if status != OK {
            return;
        }
        let bits = |x: f64| x.to_bits();
        assert_eq!([found.volume, found.energy].map(bits), [expected.volume, expected.energy].map(bits), "totals");
        let (of_parts, mut of_whole) = (forces.rows(), of_whole.rows());
        for (place, &number) in numbers.values().iter().enumerate() {
            let number = number - base;
            for axis in 0..mesh.dim {
                let whole = std::mem::take(&mut of_whole[number as usize * mesh.dim + axis]);
                assert_eq!(of_parts[place * mesh.dim + axis].to_bits(), whole.to_bits(), "node {number}, axis {axis}");
            }
        }
        assert!(of_whole.iter().all(|force| *force == 0.0), "a force on a node that was not gathered");
    }
}

/// Elastic slip is what was set, or what it was.
///
/// # Safety
/// A context that lives.
unsafe fn carry(mesh: &Mesh, part: *mut fmc_context, slip: f64, hole: Hole, base: i64) {
    let mut coords = Array::new(&mesh.coords, mesh.dim, Layout::Rows);
    let given = [0, 1].map(|face| {
        let cell = i64::from(hole % 4) + base;
        let (partner_kind, is_second, partner) =
            (i32::from(hole / 4 % 3), i32::from(hole / 16 % 2), usize::from(hole / 32));
        fmc_carried_slip { cell, face, part: 0, partner_kind, is_second, partner, slip: [slip, 0.5, 0.0], slid: 0.25 }
    });
    let given = Guarded::new(&given);
    // SAFETY: as above; arrays as long as they are said to be.
    unsafe {
        let mut counts = fmc_gathered_counts::default();
        assert_eq!(checked(fmc_context_gathered_counts(part, &mut counts)), OK);
        let count = counts.node_count as usize;
        let x = Guarded::new(&vec![0.0; count * mesh.dim]);
        if checked(fmc_context_gathered_nodes(part, null_mut(), null_mut(), x.ptr(), count, null_mut())) == OK {
            coords = Array::new(&x.values(), mesh.dim, Layout::Rows);
        }
        let has_step = checked(fmc_context_begin_step(part, &coords.view)) == OK;
        let read = || {
            let mut length = 77usize;
            let status = checked(fmc_context_carried_slip(part, null_mut(), 0, &raw mut length));
            assert!(if status == OK { length <= 2 } else { length == 77 }, "status {status}, {length} facets");
            assert!(has_step || status != OK, "slip without a step");
            let none = fmc_carried_slip {
                cell: -1,
                face: -1,
                part: -1,
                partner_kind: 0,
                is_second: 0,
                partner: 0,
                slip: [0.0; 3],
                slid: 0.0,
            };
            let found = Guarded::new(&vec![none; if status == OK { length } else { 0 }]);
            if status == OK && length > 0 {
                assert!(checked(fmc_context_carried_slip(part, found.ptr(), length - 1, &raw mut length)) != OK);
                assert_eq!(checked(fmc_context_carried_slip(part, found.ptr(), length, &raw mut length)), OK);
            }
            found.values()
        };
        let before = read();
        let status = checked(fmc_context_set_carried_slip(part, unless(hole, 0, given.ptr()).cast_const(), 2));
        let after = read();
        if status == OK {
            assert!(
                after
                    .iter()
                    .all(|one| one.slip.iter().all(|x| x.is_finite()) && one.cell == i64::from(hole % 4) + base)
            );
        } else {
            assert_eq!(before, after);
        }
    }
}
