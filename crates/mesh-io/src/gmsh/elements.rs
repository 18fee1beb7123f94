//! Elements of either format as cells.

use crate::Mesh;
use crate::element_type::ElementType;
use anyhow::{Result, bail, ensure};
use std::collections::HashMap;

/// Elements of one type and one group.
pub(super) struct ElementBlock {
    pub(super) element_type: ElementType,
    pub(super) group: Option<i64>,
    /// Tag and node tags of each, `[element_count, 1 + node_count]`.
    pub(super) rows: Vec<u64>,
}

/// Takes over the elements of highest dimension.
pub(super) fn cells(mesh: &mut Mesh, elements: &[ElementBlock]) -> Result<()> {
    let mut index = HashMap::new();
    for (node, &tag) in mesh.node_tags.iter().enumerate() {
        ensure!(index.insert(tag, node as u32).is_none(), "node {tag} is there twice");
    }
    let filled = || elements.iter().filter(|block| !block.rows.is_empty());
    let highest = filled().map(|block| block.element_type.dimension).fold(2, usize::max);
    for block in filled().filter(|block| block.element_type.dimension == highest) {
        let Some(cell_type) = block.element_type.cell_type else { bail!("{}", block.element_type.refusal()) };
        for row in block.rows.chunks_exact(1 + block.element_type.node_count) {
            let mut nodes = Vec::with_capacity(27);
            for number in 0..block.element_type.node_count {
                let tag = &row[1 + block.element_type.place(number)];
                match index.get(tag) {
                    Some(&node) => nodes.push(node),
                    None => bail!("cell {} names node {tag}, which does not exist", row[0]),
                }
            }
            mesh.push(cell_type, nodes, row[0], block.group);
        }
    }
    Ok(())
}
