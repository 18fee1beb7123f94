//! Nodes and elements of formats 2.0 to 2.2: one list of each, elements with their groups as tags.

use super::elements::ElementBlock;
use super::stream::{Encoding, Stream};
use crate::Mesh;
use crate::element_type::ElementType;
use anyhow::{Result, bail, ensure};
use std::collections::HashMap;

pub(super) fn nodes(stream: &mut Stream, mesh: &mut Mesh) -> Result<()> {
    for _ in 0..stream.count_line()? {
        mesh.node_tags.push(stream.whole()?);
        mesh.points.push([stream.double()?, stream.double()?, stream.double()?]);
    }
    Ok(())
}

pub(super) fn element_blocks(stream: &mut Stream) -> Result<Vec<ElementBlock>> {
    let announced = stream.count_line()?;
    let (mut found, mut blocks) = (0, Vec::new());
    let mut known = Known::default();
    // In binary several elements share a header; as text each has its own, its number in front.
    while found < announced {
        let tag = if stream.encoding == Encoding::Text { Some(stream.whole()?) } else { None };
        let number = stream.int()?;
        let Some(element_type) = ElementType::of_gmsh(number) else {
            bail!("{}: element type {number} is not known", stream.place());
        };
        let count = if tag.is_some() { 1 } else { stream.whole()? };
        let left = (announced - found) as u64;
        ensure!(count >= 1 && count <= left, "{}: {count} elements where {left} are left", stream.place());
        let tag_count = stream.whole()?;
        for _ in 0..count {
            let mut row = vec![tag.map_or_else(|| stream.whole(), Ok)?];
            let mut group = None;
            for position in 0..tag_count {
                // A 0 stands for no group; a sign tells an orientation.
                let number = stream.int()?;
                if position == 0 && number != 0 {
                    group = Some(number.abs());
                }
            }
            for _ in 0..element_type.node_count {
                row.push(stream.whole()?);
            }
            if known.is_new(number, &row[1..], group) {
                push(&mut blocks, element_type, group, row);
            }
        }
        found += count as usize;
    }
    Ok(blocks)
}

/// Elements found so far by type and nodes, with their groups: Gmsh writes an element once for each of its groups.
#[derive(Default)]
struct Known(HashMap<(i64, Vec<u64>), Option<i64>>);

impl Known {
    /// Whether an element is more than an earlier one in another group: the first one counts, as in format 4.1. What is there twice in
    /// one group stays, for the library to name.
    fn is_new(&mut self, number: i64, nodes: &[u64], group: Option<i64>) -> bool {
        let earlier = *self.0.entry((number, nodes.to_vec())).or_insert(group);
        earlier == group
    }
}

fn push(blocks: &mut Vec<ElementBlock>, element_type: ElementType, group: Option<i64>, row: Vec<u64>) {
    match blocks.last_mut() {
        Some(last) if last.element_type.name == element_type.name && last.group == group => last.rows.extend(row),
        _ => blocks.push(ElementBlock { element_type, group, rows: row }),
    }
}
