//! A mesh that is refined in part, with cells beside smaller ones divided to fit them.

use super::division::{Division, Origin, Place};
use super::interpolation::Interpolation;
use crate::geometry::mesh::cells::Cells;
use crate::geometry::{CellBlock, CellType};
use std::collections::BTreeMap;

impl Division {
    /// Cells in space one of whose faces meets smaller ones, as pyramids and tetrahedra about their middle, one for every
    /// face and for every smaller one; all others as they are. Nodes that hang are brought to the middle of others.
    pub(crate) fn of_refined(node_count: usize, blocks: &[CellBlock], cells: &Cells) -> Self {
        let mut parts: BTreeMap<(u32, u8), &[Vec<u32>]> = BTreeMap::new();
        cells.refined().iter().for_each(|found| {
            parts.insert((found.cell, found.face), &found.parts);
        });
        let is_divided = |cell: usize| parts.range((cell as u32, 0)..=(cell as u32, u8::MAX)).next().is_some();
        let mut rows: Vec<Vec<(u32, f64)>> = (0..node_count as u32).map(|node| vec![(node, 1.0)]).collect();
        let mut all = Self::none(node_count);
        all.starts.push(0);
        let mut first = 0;
        for CellBlock { cell_type, conn } in blocks {
            let mut found: [(CellType, Vec<u32>, Vec<Origin>); 3] =
                [*cell_type, CellType::Pyramid5, CellType::Tet4].map(|of_type| (of_type, Vec::new(), Vec::new()));
            for (nodes, cell) in conn.chunks_exact(cell_type.node_count()).zip(first..) {
                all.corners.extend_from_slice(nodes);
                all.starts.push(all.corners.len());
                let origin = |place| Origin { cell: cell as u32, cell_type: *cell_type, place };
                if !is_divided(cell) {
                    found[0].1.extend_from_slice(nodes);
                    found[0].2.push(origin(Place::Child(0)));
                    continue;
                }
                let middle = rows.len() as u32;
                rows.push(nodes.iter().map(|&node| (node, 1.0 / nodes.len() as f64)).collect());
                for (face, local) in cell_type.faces().iter().enumerate() {
                    let whole: Vec<u32> = local.iter().map(|&k| nodes[k]).collect();
                    let from_inside = vec![whole.into_iter().rev().collect()];
                    for base in parts.get(&(cell as u32, face as u8)).copied().unwrap_or(&from_inside) {
                        let into = if base.len() == 4 { 1 } else { 2 };
                        found[into].1.extend(base.iter().chain([&middle]));
                        found[into].2.push(origin(Place::OnFace(face as u8)));
                    }
                }
            }
            for (of_type, conn, origins) in found.into_iter().filter(|(_, conn, _)| !conn.is_empty()) {
                all.blocks.push((of_type, conn));
                all.origins.extend(origins);
            }
            all.types.push((*cell_type, vec![super::children::Child::whole(*cell_type)]));
            first += conn.len() / cell_type.node_count();
        }
        let mut used = vec![false; rows.len()];
        all.blocks.iter().flat_map(|(_, conn)| conn).for_each(|&point| used[point as usize] = true);
        let plain = Interpolation::new(node_count, &rows, |point| used[point]);
        all.interpolation = plain.with_hanging(cells.hanging(), |point| used[point]);
        all
    }
}
