//! Connected parts of a mesh.

use fmc_contact::CellType;
use std::collections::HashMap;

/// Number of the connected part of every cell: cells that share a face belong together. Parts are numbered by their
/// first cell, as the module numbers them; but the module returns the components of boundary faces only, and a picture
/// of the bodies needs those of all cells.
pub(super) fn components<'a>(cells: impl Iterator<Item = (CellType, &'a [u32])>) -> Vec<i64> {
    let mut parents: Vec<usize> = Vec::new();
    let mut owners: HashMap<[u32; 4], usize> = HashMap::new();
    for (cell, (cell_type, nodes)) in cells.enumerate() {
        parents.push(cell);
        for face in cell_type.faces() {
            let mut key = [u32::MAX; 4];
            for (entry, &local) in key.iter_mut().zip(*face) {
                *entry = nodes[local];
            }
            key.sort_unstable();
            let owner = *owners.entry(key).or_insert(cell);
            // The smaller number becomes the root, so that roots are first cells.
            let (p, q) = (root(&mut parents, owner), root(&mut parents, cell));
            parents[p.max(q)] = p.min(q);
        }
    }
    let mut numbers = HashMap::new();
    (0..parents.len())
        .map(|cell| {
            let next = numbers.len() as i64;
            *numbers.entry(root(&mut parents, cell)).or_insert(next)
        })
        .collect()
}

fn root(parents: &mut [usize], mut cell: usize) -> usize {
    while parents[cell] != cell {
        parents[cell] = parents[parents[cell]];
        cell = parents[cell];
    }
    cell
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_are_joined_by_faces_and_numbered_by_first_cell() {
        // 0 and 2 share an edge; 1 touches 0 in a node only.
        let cells = [[0, 1, 2], [2, 5, 6], [1, 3, 2]];
        let found = components(cells.iter().map(|nodes| (CellType::Tri3, nodes.as_slice())));
        assert_eq!(found, [0, 1, 0]);
    }
}
