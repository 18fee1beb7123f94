//! A scene in parts, and what is told of it in the numbers of the whole.

use crate::scene::Scene;
use fmc_contact::contact::TangentPart;
use fmc_contact::{CellBlock, Contact, MeshPart};

/// The cells of one rank.
pub(crate) struct Part<const D: usize> {
    pub(crate) coords: Vec<[f64; D]>,
    pub(crate) node_numbers: Vec<u64>,
    blocks: Vec<(fmc_contact::CellType, Vec<u32>)>,
    pub(crate) cell_numbers: Vec<u64>,
    body_ids: Vec<i64>,
}

impl<const D: usize> Part<D> {
    /// Cells of a scene for which `is_own` holds, given their number and their middle.
    pub(crate) fn of(scene: &Scene<D>, is_own: impl Fn(usize, [f64; D]) -> bool) -> Self {
        let mut part =
            Self { coords: vec![], node_numbers: vec![], blocks: vec![], cell_numbers: vec![], body_ids: vec![] };
        let mut cell = 0;
        let mut new = std::collections::BTreeMap::new();
        for (cell_type, conn) in &scene.blocks {
            let mut own = Vec::new();
            for nodes in conn.chunks(cell_type.node_count()) {
                let sum = nodes.iter().fold([0.0; D], |sum, &node| {
                    std::array::from_fn(|i| sum[i] + scene.coords[node as usize][i] / nodes.len() as f64)
                });
                if is_own(cell, sum) {
                    own.extend_from_slice(nodes);
                    part.cell_numbers.push(cell as u64);
                    part.body_ids.push(scene.ids[cell]);
                }
                cell += 1;
            }
            part.blocks.push((*cell_type, own));
        }
        // Counted backwards, so that no order is that of the whole by chance.
        let mut used: Vec<u32> = part.blocks.iter().flat_map(|(_, conn)| conn).copied().collect();
        used.sort_unstable();
        used.dedup();
        used.reverse();
        for (number, &node) in used.iter().enumerate() {
            new.insert(node, number as u32);
            part.coords.push(scene.coords[node as usize]);
            part.node_numbers.push(u64::from(node));
        }
        part.blocks.iter_mut().for_each(|(_, conn)| conn.iter_mut().for_each(|node| *node = new[node]));
        part
    }

    pub(crate) fn blocks(&self) -> Vec<CellBlock<'_>> {
        self.blocks.iter().map(|(cell_type, conn)| CellBlock { cell_type: *cell_type, conn }).collect()
    }

    pub(crate) fn given<'a>(&'a self, blocks: &'a [CellBlock<'a>]) -> MeshPart<'a, D> {
        let Self { coords, node_numbers, cell_numbers, body_ids, .. } = self;
        MeshPart { coords, node_numbers, blocks, cell_numbers, body_ids }
    }

    /// Own coordinates of the whole mesh's.
    pub(crate) fn here(&self, all: &[[f64; D]]) -> Vec<[f64; D]> {
        self.node_numbers.iter().map(|&node| all[node as usize]).collect()
    }
}

/// All that can be asked, told to the last bit in the numbers of a mesh of `count` nodes.
pub(crate) fn told<const D: usize>(
    contact: &Contact<D>,
    coords: &[[f64; D]],
    numbers: &[u64],
    count: usize,
) -> Vec<String> {
    let node = |node: usize| match numbers.get(node) {
        Some(number) => *number as usize,
        None => node - numbers.len() + count,
    };
    let spread = |values: &[[f64; D]]| {
        let found = values.iter().enumerate().filter(|(_, value)| **value != [0.0; D]);
        let mut found: Vec<_> = found.map(|(n, value)| (node(n), *value)).collect();
        found.sort_by_key(|(n, _)| *n);
        found
    };
    let mut told = Vec::new();
    told.push(match contact.evaluate(coords) {
        Ok(mut found) => {
            let forces = spread(&found.forces);
            found.forces.clear();
            format!("{forces:?} {found:?}")
        }
        Err(error) => format!("{error:?}"),
    });
    for part in [TangentPart::Symmetric, TangentPart::Semidefinite] {
        told.push(match contact.tangent(coords, part) {
            Ok(found) => {
                let of = |row: usize| node(row / D) * D + row % D;
                let mut entries: Vec<_> = found.triplets().map(|(i, j, x)| (of(i), of(j), x.to_bits())).collect();
                entries.sort_unstable();
                format!("{entries:?}")
            }
            Err(error) => format!("{error:?}"),
        });
    }
    told.push(match contact.overlaps(coords) {
        Ok(mut found) => {
            let every = found.iter_mut().flat_map(|overlap| &mut overlap.nodes);
            every.for_each(|n| *n = node(*n as usize) as u32);
            format!("{found:?}")
        }
        Err(error) => format!("{error:?}"),
    });
    told.push(match contact.nodal_contact(coords) {
        Ok(found) => {
            let of_node = |n: usize| {
                (
                    node(n),
                    found.pressure[n],
                    found.gap[n],
                    found.area[n],
                    found.normal[n],
                    found.friction[n],
                    found.sliding[n],
                )
            };
            let mut touched: Vec<_> = (0..found.area.len()).filter(|&n| found.area[n] > 0.0).map(of_node).collect();
            touched.sort_by_key(|of_node| of_node.0);
            format!("{touched:?}")
        }
        Err(error) => format!("{error:?}"),
    });
    told.push(match contact.contact_points(coords) {
        Ok(mut found) => {
            for side in found.iter_mut().flat_map(|point| &mut point.sides) {
                side.cell = None;
                side.nodes.iter_mut().take(side.node_count).for_each(|n| *n = node(*n as usize) as u32);
            }
            format!("{found:?}")
        }
        Err(error) => format!("{error:?}"),
    });
    told.push(match contact.gap_constraints(coords, 0.02) {
        Ok(mut found) => {
            found.nodes.iter_mut().chain(&mut found.columns).for_each(|n| *n = node(*n as usize) as u32);
            format!("{found:?}")
        }
        Err(error) => format!("{error:?}"),
    });
    told
}

/// The same of the whole mesh.
pub(crate) fn of_whole<const D: usize>(contact: &Contact<D>, coords: &[[f64; D]]) -> Vec<String> {
    let numbers: Vec<u64> = (0..coords.len() as u64).collect();
    told(contact, coords, &numbers, coords.len())
}

/// Whether two answers are the same; says where they are not.
pub(crate) fn compare(found: &[String], whole: &[String], what: &str) {
    for (number, (found, whole)) in found.iter().zip(whole).enumerate() {
        let at = found.bytes().zip(whole.bytes()).position(|(a, b)| a != b).unwrap_or(found.len().min(whole.len()));
        let near = |text: &str| text.get(at.saturating_sub(60)..(at + 80).min(text.len())).map(String::from);
        assert!(found == whole, "answer {number}, {what}:\n{:?}\nfor\n{:?}", near(found), near(whole));
    }
}
