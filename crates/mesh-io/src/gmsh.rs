//! Gmsh meshes, MSH formats 4.1 and 2.0 to 2.2, text and binary.
//!
//! The formats are described in the Gmsh reference manual, "MSH file format". `mshio`, the parser on crates.io, has had no
//! release since 2020 and leaves out the names of physical groups, so the few sections of interest are read here:
//! `$PhysicalNames`, `$Entities` (for the physical groups, which format 2 has beside each element), `$Nodes`, `$Elements`.

use super::Mesh;
use super::excerpt::shortened;
use anyhow::{Context, Result, bail, ensure};
use elements::{ElementBlock, cells};
use std::collections::BTreeMap;
use stream::{Encoding, Stream};
use version_4::Groups;

mod elements;
mod stream;
mod version_2;
mod version_4;

/// How nodes and elements are laid out.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Layout {
    /// A list of each: formats 2.0, 2.1 and 2.2.
    Listed,
    /// Entity by entity: format 4.1.
    ByEntity,
}

pub(super) fn parse(bytes: &[u8]) -> Result<Mesh> {
    let mut stream = Stream::new(bytes);
    let mut mesh = Mesh::default();
    let mut names = BTreeMap::new();
    let mut groups = Groups::new();
    let mut elements: Option<Vec<ElementBlock>> = None;
    let mut layout = None;
    while let Some(line) = stream.line() {
        let Some(name) = line.strip_prefix('$') else {
            bail!("expected the start of a section, found '{}'", shortened(&line));
        };
        ensure!(layout.is_some() || matches!(name, "MeshFormat" | "Comments"), "${name} stands before $MeshFormat");
        let listed = layout == Some(Layout::Listed);
        let in_section = || format!("section ${name}");
        match name {
            "MeshFormat" => layout = Some(format(&mut stream)?),
            "PhysicalNames" => names = physical_names(&mut stream).with_context(in_section)?,
            "Entities" if !listed => groups = version_4::entities(&mut stream).with_context(in_section)?,
            "Nodes" if listed => version_2::nodes(&mut stream, &mut mesh).with_context(in_section)?,
            "Nodes" => version_4::nodes(&mut stream, &mut mesh).with_context(in_section)?,
            "Elements" if listed => elements = Some(version_2::element_blocks(&mut stream).with_context(in_section)?),
            "Elements" => elements = Some(version_4::element_blocks(&mut stream, &groups).with_context(in_section)?),
            _ => {
                stream.skip_section(name)?;
                continue;
            }
        }
        stream.end_section(name)?;
    }
    ensure!(layout.is_some(), "it has no $MeshFormat section: it is not a Gmsh mesh");
    ensure!(!mesh.points.is_empty(), "it has no nodes");
    let Some(elements) = elements else { bail!("it has no $Elements section") };
    cells(&mut mesh, &elements)?;
    let dimension = mesh.blocks.first().map_or(0, |block| block.cell_type.dimension() as i64);
    mesh.group_names =
        names.into_iter().filter(|((d, _), _)| *d == dimension).map(|((_, group), name)| (group, name)).collect();
    Ok(mesh)
}

fn format(stream: &mut Stream) -> Result<Layout> {
    let line = stream.line().unwrap_or_default();
    let words: Vec<&str> = line.split_whitespace().collect();
    let [version, file_type, data_size] = words[..] else {
        bail!("$MeshFormat has '{}' where version, file type and data size should stand", shortened(&line));
    };
    let layout = match version {
        "2" | "2.0" | "2.1" | "2.2" => Layout::Listed,
        "4.1" => Layout::ByEntity,
        _ => bail!(
            "its format is version {version}; save it as version 4.1 (gmsh in.msh -save -format msh41 -o out.msh)"
        ),
    };
    ensure!(data_size == "8", "its data size is {data_size}; only 8 is supported");
    match file_type {
        "0" => {}
        "1" => {
            stream.encoding = match stream.take::<4>()? {
                [1, 0, 0, 0] => Encoding::LittleEndian,
                [0, 0, 0, 1] => Encoding::BigEndian,
                _ => bail!("there is no 1 after $MeshFormat to give the byte order"),
            };
        }
        _ => bail!("its file type is '{file_type}'; 0 (text) and 1 (binary) are known"),
    }
    Ok(layout)
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
