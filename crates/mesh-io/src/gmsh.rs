//! Gmsh meshes, MSH format 4.1, text and binary.
//!
//! The format is described in the Gmsh reference manual, "MSH file format". `mshio`, the parser on crates.io, has had no
//! release since 2020 and leaves out the names of physical groups, so the few sections of interest are read here:
//! `$PhysicalNames`, `$Entities` (for the physical groups), `$Nodes`, `$Elements`.

use super::Mesh;
use super::element_type::ElementType;
use super::gmsh_stream::{Encoding, Stream, shortened};
use anyhow::{Context, Result, bail, ensure};
use std::collections::{BTreeMap, HashMap};

/// Elements of one entity.
struct ElementBlock {
    element_type: ElementType,
    group: Option<i64>,
    /// Tag and node tags of each, `[element_count, 1 + node_count]`.
    rows: Vec<u64>,
}

/// Physical groups by dimension and tag of the entity.
type Groups = HashMap<(i64, i64), i64>;

pub(super) fn parse(bytes: &[u8]) -> Result<Mesh> {
    let mut stream = Stream::new(bytes);
    let mut mesh = Mesh::default();
    let mut names = BTreeMap::new();
    let mut groups = Groups::new();
    let mut elements: Option<Vec<ElementBlock>> = None;
    let mut known_format = false;
    while let Some(line) = stream.line() {
        let Some(name) = line.strip_prefix('$') else {
            bail!("expected the start of a section, found '{}'", shortened(&line));
        };
        ensure!(known_format || matches!(name, "MeshFormat" | "Comments"), "${name} stands before $MeshFormat");
        let in_section = || format!("section ${name}");
        match name {
            "MeshFormat" => {
                format(&mut stream)?;
                known_format = true;
            }
            "PhysicalNames" => names = physical_names(&mut stream).with_context(in_section)?,
            "Entities" => groups = entities(&mut stream).with_context(in_section)?,
            "Nodes" => nodes(&mut stream, &mut mesh).with_context(in_section)?,
            "Elements" => elements = Some(element_blocks(&mut stream, &groups).with_context(in_section)?),
            _ => {
                stream.skip_section(name)?;
                continue;
            }
        }
        stream.end_section(name)?;
    }
    ensure!(known_format, "it has no $MeshFormat section: it is not a Gmsh mesh");
    ensure!(!mesh.points.is_empty(), "it has no nodes");
    let Some(elements) = elements else { bail!("it has no $Elements section") };
    cells(&mut mesh, &elements)?;
    let dimension = mesh.blocks.first().map_or(0, |block| block.cell_type.dimension() as i64);
    mesh.group_names =
        names.into_iter().filter(|((d, _), _)| *d == dimension).map(|((_, group), name)| (group, name)).collect();
    Ok(mesh)
}

fn format(stream: &mut Stream) -> Result<()> {
    let line = stream.line().unwrap_or_default();
    let words: Vec<&str> = line.split_whitespace().collect();
    let [version, file_type, data_size] = words[..] else {
        bail!("$MeshFormat has '{}' where version, file type and data size should stand", shortened(&line));
    };
    ensure!(
        version == "4.1",
        "its format is version {version}; save it as version 4.1 (gmsh in.msh -save -format msh41 -o out.msh)"
    );
    ensure!(data_size == "8", "its data size is {data_size}; only 8 is supported");
    match file_type {
        "0" => {}
        "1" => {
            stream.encoding = match stream.take::<4>()? {
                [1, 0, 0, 0] => Encoding::LittleEndian,
                [0, 0, 0, 1] => Encoding::BigEndian,
                _ => bail!("the byte order is not told by a 1 after $MeshFormat"),
            };
        }
        _ => bail!("its file type is '{file_type}'; 0 (text) and 1 (binary) are known"),
    }
    Ok(())
}

/// Names by dimension and group. This section is text in binary files too.
fn physical_names(stream: &mut Stream) -> Result<BTreeMap<(i64, i64), String>> {
    let mut names = BTreeMap::new();
    let count: usize = stream.line().unwrap_or_default().parse().context("the number of names cannot be read")?;
    for _ in 0..count {
        let line = stream.line().context("the file ends too early")?;
        let mut words = line.splitn(3, ' ');
        let mut number = || words.next().and_then(|word| word.parse().ok());
        let (Some(dimension), Some(group)) = (number(), number()) else {
            bail!("'{}' is not dimension, number and name of a group", shortened(&line));
        };
        names.insert((dimension, group), words.next().unwrap_or_default().trim().trim_matches('"').to_owned());
    }
    Ok(names)
}

/// The first physical group of every entity that has one; its sign, which tells an orientation, is dropped.
fn entities(stream: &mut Stream) -> Result<Groups> {
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

fn nodes(stream: &mut Stream, mesh: &mut Mesh) -> Result<()> {
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

fn element_blocks(stream: &mut Stream, groups: &Groups) -> Result<Vec<ElementBlock>> {
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

/// Takes over the elements of highest dimension.
fn cells(mesh: &mut Mesh, elements: &[ElementBlock]) -> Result<()> {
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
