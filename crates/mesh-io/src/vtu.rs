//! VTK unstructured grids in XML, `.vtu`.
//!
//! Read here and not by `vtkio`, which (0.7.0-rc2) refuses appended raw data, what ParaView writes unless asked
//! otherwise, and ends the program on a file that is cut short.

use super::Mesh;
use super::element_type::ElementType;
use super::vtu_array::{Encoding, offset};
use anyhow::{Context, Result, bail, ensure};
use roxmltree::{Document, Node};

/// Cell arrays that tell the group of a cell, the first that is there: as this command, meshio and Gmsh name them.
const GROUP_ARRAYS: [&str; 4] = ["body", "gmsh:physical", "medit:ref", "CellEntityIds"];

pub(super) fn parse(bytes: &[u8]) -> Result<Mesh> {
    let (xml, appended) = split_appended(bytes)?;
    let document = Document::parse(&xml).context("it is not well-formed XML")?;
    let (encoding, piece) = opened(&document, appended, bytes.len())?;
    let Topology { points, conn, ends, types } = Topology::read(&encoding, piece)?;
    let node_tags = (0..points.len() as u64).collect();
    let mut mesh = Mesh { points, node_tags, ..Mesh::default() };
    let groups = piece
        .children()
        .find(|n| n.has_tag_name("CellData"))
        .and_then(|data| GROUP_ARRAYS.iter().find_map(|name| array(data, name)).map(|found| encoding.integers(found)));
    cells(&mut mesh, &conn, &ends, &types, &groups.transpose()?)?;
    Ok(mesh)
}

/// Points and cells as the file holds them.
struct Topology {
    points: Vec<[f64; 3]>,
    conn: Vec<i64>,
    ends: Vec<i64>,
    types: Vec<i64>,
}

impl Topology {
    fn read(encoding: &Encoding, piece: Node) -> Result<Self> {
        let point_count = size(&piece, "NumberOfPoints").context("the number of points cannot be read")?;
        let cell_count = size(&piece, "NumberOfCells").context("the number of cells cannot be read")?;
        encoding.check_size(point_count, 3 * size_of::<f64>()).context("its points")?;
        encoding.check_size(cell_count, size_of::<i64>()).context("its cells")?;
        let points = child(piece, "Points")?.children().find(|n| n.has_tag_name("DataArray"));
        let points = encoding.floats(points.context("it has no array of points")?)?;
        ensure!(
            Some(points.len()) == point_count.checked_mul(3),
            "{point_count} points have {} coordinates",
            points.len()
        );
        let cells = child(piece, "Cells")?;
        let named = |name: &str| -> Result<Vec<i64>> {
            encoding.integers(array(cells, name).with_context(|| format!("it has no array '{name}' of cells"))?)
        };
        let (conn, ends, types) = (named("connectivity")?, named("offsets")?, named("types")?);
        ensure!(ends.len() == cell_count, "{cell_count} cells have {} offsets", ends.len());
        ensure!(types.len() == cell_count, "{cell_count} cells have {} types", types.len());
        Ok(Self { points: points.chunks_exact(3).map(|x| [x[0], x[1], x[2]]).collect(), conn, ends, types })
    }
}

/// The points of every cell of one VTK type, with its number in a cell array.
pub(super) fn cells_of_type(bytes: &[u8], wanted: i64, name: &str) -> Result<Vec<(i64, Vec<[f64; 3]>)>> {
    let (xml, appended) = split_appended(bytes)?;
    let document = Document::parse(&xml).context("it is not well-formed XML")?;
    let (encoding, piece) = opened(&document, appended, bytes.len())?;
    let Topology { points, conn, ends, types } = Topology::read(&encoding, piece)?;
    let numbers = array(child(piece, "CellData")?, name).with_context(|| format!("it has no array '{name}'"))?;
    let numbers = encoding.integers(numbers)?;
    ensure!(numbers.len() == types.len(), "array '{name}' has {} numbers for {} cells", numbers.len(), types.len());
    let mut found = Vec::new();
    let mut start = 0;
    for (cell, (&end, &number)) in ends.iter().zip(&numbers).enumerate() {
        let end = usize::try_from(end).unwrap_or(usize::MAX);
        let nodes = conn.get(start..end).with_context(|| format!("cell {cell} has no nodes in 'connectivity'"))?;
        start = end;
        if types[cell] == wanted {
            let at = |&node: &i64| usize::try_from(node).ok().and_then(|node| points.get(node).copied());
            let places: Option<Vec<[f64; 3]>> = nodes.iter().map(at).collect();
            found.push((number, places.with_context(|| format!("cell {cell} names a point that is not there"))?));
        }
    }
    Ok(found)
}

/// How arrays are encoded, and the one piece of the grid.
fn opened<'a>(
    document: &'a Document,
    appended: Option<Appended<'a>>,
    file_size: usize,
) -> Result<(Encoding<'a>, Node<'a, 'a>)> {
    let root = document.root_element();
    ensure!(root.has_tag_name("VTKFile"), "it is not a VTK file");
    let kind = root.attribute("type").unwrap_or_default();
    ensure!(kind == "UnstructuredGrid", "it holds '{kind}'; save it as an unstructured grid (.vtu)");
    let mut offsets: Vec<usize> = document.descendants().filter_map(offset).collect();
    offsets.sort_unstable();
    let encoding = Encoding {
        little_endian: root.attribute("byte_order") != Some("BigEndian"),
        header_size: if root.attribute("header_type") == Some("UInt64") { 8 } else { 4 },
        compressor: root.attribute("compressor").filter(|name| !name.is_empty()),
        appended,
        offsets,
        file_size,
    };
    let grid = child(root, "UnstructuredGrid")?;
    let mut pieces = grid.children().filter(|n| n.has_tag_name("Piece") && size(n, "NumberOfCells") != Some(0));
    let piece = pieces.next().context("it has no cells")?;
    ensure!(pieces.next().is_none(), "it has several pieces, which would be torn apart; merge them into one");
    Ok((encoding, piece))
}

/// A number in the text of an element.
fn size(node: &Node, name: &str) -> Option<usize> {
    node.attribute(name).and_then(|text| text.trim().parse().ok())
}

/// The numbers of a point or cell array, tuple after tuple.
pub(super) fn floats(bytes: &[u8], name: &str) -> Result<Vec<f64>> {
    let (xml, appended) = split_appended(bytes)?;
    let document = Document::parse(&xml).context("it is not well-formed XML")?;
    let (encoding, piece) = opened(&document, appended, bytes.len())?;
    let data = ["PointData", "CellData"].into_iter().filter_map(|kind| child(piece, kind).ok());
    let found = data.into_iter().find_map(|data| array(data, name));
    encoding.floats(found.with_context(|| format!("it has no array '{name}'"))?)
}

/// Takes over the cells of highest dimension.
fn cells(mesh: &mut Mesh, conn: &[i64], ends: &[i64], types: &[i64], groups: &Option<Vec<i64>>) -> Result<()> {
    let mut rows = Vec::new();
    let mut start = 0;
    for (cell, (&end, &number)) in ends.iter().zip(types).enumerate() {
        let end = usize::try_from(end).unwrap_or(usize::MAX);
        let Some(nodes) = conn.get(start..end) else { bail!("cell {cell} has no nodes in 'connectivity'") };
        start = end;
        let Some(element_type) = ElementType::of_vtk(number) else {
            bail!("cell {cell} has the unknown type {number}")
        };
        rows.push((element_type, nodes));
    }
    let highest = rows.iter().map(|(element_type, _)| element_type.dimension).fold(2, usize::max);
    for (cell, (element_type, nodes)) in rows.into_iter().enumerate() {
        if element_type.dimension != highest {
            continue;
        }
        let Some(cell_type) = element_type.cell_type else { bail!("{}", element_type.refusal()) };
        ensure!(
            nodes.len() == element_type.node_count,
            "cell {cell} ({}) has {} nodes",
            element_type.name,
            nodes.len()
        );
        let mut indices = Vec::with_capacity(27);
        for &node in nodes {
            match usize::try_from(node) {
                Ok(index) if index < mesh.points.len() => indices.push(index as u32),
                _ => bail!("cell {cell} names node {node}, but there are {} nodes", mesh.points.len()),
            }
        }
        mesh.push(cell_type, indices, cell as u64, groups.as_ref().and_then(|groups| groups.get(cell).copied()));
    }
    Ok(())
}

/// Appended data: what follows the underscore, and whether it is base64.
type Appended<'a> = (&'a [u8], bool);

/// The XML without its appended data, which in raw form is no XML, and that data.
fn split_appended(bytes: &[u8]) -> Result<(String, Option<Appended<'_>>)> {
    let find = |text: &[u8], from: usize| bytes[from..].windows(text.len()).position(|w| w == text).map(|at| from + at);
    let utf8 = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).context("it is not text in UTF-8");
    let Some(start) = find(b"<AppendedData", 0) else { return Ok((utf8(bytes)?, None)) };
    let tag_end = find(b">", start).context("AppendedData is cut short")?;
    let data = find(b"_", tag_end).context("AppendedData has no underscore before its data")? + 1;
    let is_base64 = match String::from_utf8_lossy(&bytes[start..tag_end]).split(['"', '\'']).nth(1) {
        Some("raw") => false,
        Some("base64") => true,
        _ => bail!("the encoding of AppendedData is neither raw nor base64"),
    };
    // Raw data has no mark at its end, but each array begins with its length; in base64 the next tag ends it.
    let end = if is_base64 { find(b"<", data).unwrap_or(bytes.len()) } else { bytes.len() };
    Ok((utf8(&bytes[..start])? + "</VTKFile>", Some((&bytes[data..end], is_base64))))
}

fn child<'a, 'input>(parent: Node<'a, 'input>, name: &str) -> Result<Node<'a, 'input>> {
    parent.children().find(|n| n.has_tag_name(name)).with_context(|| format!("it has no element {name}"))
}

fn array<'a, 'input>(parent: Node<'a, 'input>, name: &str) -> Option<Node<'a, 'input>> {
    parent.children().find(|n| n.has_tag_name("DataArray") && n.attribute("Name") == Some(name))
}
