//! Nodes and elements of format 4.1, entity by entity.

use super::elements::ElementBlock;
use super::stream::Stream;
use crate::Mesh;
use crate::element_type::ElementType;
use anyhow::{Result, bail, ensure};
use std::collections::HashMap;

/// Physical groups by dimension and tag of the entity.
pub(super) type Groups = HashMap<(i64, i64), i64>;

/// The first physical group of every entity that has one; its sign, which tells an orientation, is dropped.
pub(super) fn entities(stream: &mut Stream) -> Result<Groups> {
    let mut groups = Groups::new();
    let mut counts = [0; 4];
    for count in &mut counts {
        *count = stream.count()?;
    }
    for (dimension, count) in counts.into_iter().enumerate() {
        for _ in 0..count {
            let tag = stream.int()?;
            for _ in 0..if dimension == 0 { 3 } else { 6 } {
                stream.double()?;
            }
            for position in 0..stream.count()? {
                let group = stream.int()?;
                if position == 0 {
                    groups.insert((dimension as i64, tag), group.abs());
                }
            }
            if dimension > 0 {
                for _ in 0..stream.count()? {
                    stream.int()?;
                }
            }
        }
    }
    Ok(groups)
}

pub(super) fn nodes(stream: &mut Stream, mesh: &mut Mesh) -> Result<()> {
    let block_count = stream.count()?;
    let (announced, _, _) = (stream.count()?, stream.size()?, stream.size()?);
    for _ in 0..block_count {
        let (dimension, _entity) = (stream.int()?, stream.int()?);
        let parameters = if stream.int()? == 0 { 0 } else { dimension };
        let count = stream.count()?;
        for _ in 0..count {
            mesh.node_tags.push(stream.size()?);
        }
        for _ in 0..count {
            mesh.points.push([stream.double()?, stream.double()?, stream.double()?]);
            for _ in 0..parameters {
                stream.double()?;
            }
        }
    }
    let found = mesh.points.len();
    ensure!(found == announced, "{announced} nodes are announced, but there are {found}");
    Ok(())
}

pub(super) fn element_blocks(stream: &mut Stream, groups: &Groups) -> Result<Vec<ElementBlock>> {
    let block_count = stream.count()?;
    let (announced, _, _) = (stream.count()?, stream.size()?, stream.size()?);
    let (mut blocks, mut found) = (Vec::new(), 0);
    for _ in 0..block_count {
        let place = stream.place();
        let (dimension, entity, number) = (stream.int()?, stream.int()?, stream.int()?);
        let Some(element_type) = ElementType::of_gmsh(number) else {
            bail!("{place}: element type {number} is not known");
        };
        let count = stream.count()?;
        let mut rows = Vec::new();
        for _ in 0..count * (1 + element_type.node_count) {
            rows.push(stream.size()?);
        }
        found += count;
        blocks.push(ElementBlock { element_type, group: groups.get(&(dimension, entity)).copied(), rows });
    }
    ensure!(found == announced, "{announced} elements are announced, but there are {found}");
    Ok(blocks)
}
