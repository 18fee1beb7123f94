//! Meshes from files: nodes, and the cells of highest dimension with the numbers that the file gives them.
//!
//! Gmsh (4.1 and 2.2), VTU and Abaqus' `.inp` are told apart by their content, not by their name. Cells of lower dimension (boundary
//! lines, points) are left out. Numbers of nodes and cells in messages are those of the file: tags in Gmsh, labels in Abaqus, indices
//! from 0 in VTU. Indices that a mesh holds are valid; coordinates may be anything, also NaN.

use anyhow::{Context, Result, bail, ensure};
use fmc_contact::CellType;
use std::collections::BTreeMap;
use std::ops::Range;
use std::path::Path;

mod element_type;
mod excerpt;
mod fibers;
mod folder_lock;
mod gmsh;
pub mod inp;
mod vtu;
mod vtu_array;
mod vtu_write;
mod whole_file;

pub use fibers::{fiber_grid, read_fibers};
pub use folder_lock::FolderLock;
pub use vtu_write::{VtkCell, VtuWriter, in_space};
pub use whole_file::write_whole;

/// Cells of one type, in the order of the file.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Type of all cells of the block.
    pub cell_type: CellType,
    /// Node indices, `[cell_count, node_count]`, in the order of [`CellType`] whatever that of the file is.
    pub conn: Vec<u32>,
    /// Number of each cell in the file.
    pub tags: Vec<u64>,
    /// Group of each cell: its physical group (Gmsh), the entry of a cell array (VTU), its instance (Abaqus) or, without parts, the
    /// element set of its section, else the first that has it.
    pub groups: Vec<Option<i64>>,
}

/// What the cells fill.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Triangles and quadrilaterals at constant z: a 2D mesh.
    Flat,
    /// Triangles and quadrilaterals in space: the surface of bodies.
    Surface,
    /// Tetrahedra, hexahedra, wedges and pyramids.
    Solid,
}

/// A part of a file that is there once or several times, each a body: its numbers are unique within it only.
#[derive(Clone, Debug, PartialEq)]
pub struct Instance {
    /// Its name in the file.
    pub name: String,
    /// Its nodes among those of the mesh.
    pub nodes: Range<usize>,
    /// Where it stands.
    pub motion: inp::Motion,
}

/// A mesh as it stands in a file.
#[derive(Clone, Debug, Default)]
pub struct Mesh {
    /// File it was read from, as the user named it.
    pub file: String,
    /// Node coordinates; z is what the file says, also where the mesh is flat.
    pub points: Vec<[f64; 3]>,
    /// Number of each node in the file.
    pub node_tags: Vec<u64>,
    /// Cells of the highest dimension, neighbours in the file of one type together.
    pub blocks: Vec<Block>,
    /// Names of the groups that have one.
    pub group_names: BTreeMap<i64, String>,
    /// Instances of parts (Abaqus), in whose order the groups of their cells count from 1; empty where there are no parts.
    pub instances: Vec<Instance>,
}

/// z counts as constant if it varies by less than this part of the extent: meshes turned into the plane carry rounding.
const FLATNESS: f64 = 1e-9;

impl Mesh {
    /// Reads a Gmsh (4.1 or 2.2), VTU or Abaqus file.
    ///
    /// # Errors
    /// A file that cannot be read, is of another format, is damaged or has no cells.
    pub fn read(path: &Path) -> Result<Self> {
        let file = path.display().to_string();
        let bytes = std::fs::read(path).with_context(|| format!("{file} cannot be read"))?;
        // Editors of Windows mark UTF-8 by three bytes.
        let start = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(&bytes).trim_ascii_start();
        let mut mesh = if start.starts_with(b"$") {
            gmsh::parse(&bytes).with_context(|| file.clone())?
        } else if start.starts_with(b"<") {
            vtu::parse(&bytes).with_context(|| file.clone())?
        } else if start.starts_with(b"*") {
            inp::parse(&bytes, Some(path)).with_context(|| file.clone())?
        } else {
            bail!(
                "{file} is neither a Gmsh mesh (.msh, format 4.1 or 2.2), nor a VTK unstructured grid (.vtu), nor an Abaqus input \
                 file (.inp)"
            );
        };
        ensure!(
            !mesh.blocks.is_empty(),
            "{file} has no triangles, quadrilaterals, tetrahedra, hexahedra, wedges or pyramids"
        );
        mesh.file = file;
        Ok(mesh)
    }

    /// The mesh of an Abaqus input file that has been read, without its rigid elements.
    ///
    /// # Errors
    /// If it is damaged or has no cells; messages name lines of the text.
    pub fn of_input(input: &inp::Expanded) -> Result<Self> {
        let mesh = inp::of_text(&input.text, true)?;
        ensure!(
            !mesh.blocks.is_empty(),
            "line 1: there are no elements that fill an area or a volume; is this an input file of Abaqus or CalculiX?"
        );
        Ok(mesh)
    }

    /// Adds a cell after those already there.
    pub fn push(&mut self, cell_type: CellType, nodes: impl IntoIterator<Item = u32>, tag: u64, group: Option<i64>) {
        if self.blocks.last().is_none_or(|block| block.cell_type != cell_type) {
            self.blocks.push(Block { cell_type, conn: Vec::new(), tags: Vec::new(), groups: Vec::new() });
        }
        let block = self.blocks.last_mut().expect("a block was just pushed");
        block.conn.extend(nodes);
        block.tags.push(tag);
        block.groups.push(group);
    }

    /// Number of cells.
    pub fn cell_count(&self) -> usize {
        self.blocks.iter().map(|block| block.tags.len()).sum()
    }

    /// Cells as type, nodes, number in the file and group, block after block.
    pub fn cells(&self) -> impl Iterator<Item = (CellType, &[u32], u64, Option<i64>)> {
        self.blocks.iter().flat_map(|block| {
            let nodes = block.conn.chunks_exact(block.cell_type.node_count());
            nodes
                .zip(&block.tags)
                .zip(&block.groups)
                .map(|((nodes, &tag), &group)| (block.cell_type, nodes, tag, group))
        })
    }

    /// One of them by its number, counted over all blocks.
    pub fn cell(&self, number: usize) -> Option<(CellType, &[u32], u64, Option<i64>)> {
        let mut first = 0;
        let block = self.blocks.iter().find(|block| {
            first += block.tags.len();
            number < first
        })?;
        let (place, count) = (number + block.tags.len() - first, block.cell_type.node_count());
        let nodes = &block.conn[place * count..(place + 1) * count];
        Some((block.cell_type, nodes, block.tags[place], block.groups[place]))
    }

    /// What the cells fill. NaN coordinates are left to the checks that name them.
    pub fn kind(&self) -> Kind {
        if self.blocks.iter().any(|block| block.cell_type.dimension() == 3) {
            return Kind::Solid;
        }
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for &node in self.blocks.iter().flat_map(|block| &block.conn) {
            for axis in 0..3 {
                low[axis] = low[axis].min(self.points[node as usize][axis]);
                high[axis] = high[axis].max(self.points[node as usize][axis]);
            }
        }
        let extent = (high[0] - low[0]).max(high[1] - low[1]);
        if high[2] - low[2] > FLATNESS * extent { Kind::Surface } else { Kind::Flat }
    }
}

/// The numbers of a point or cell array of a VTU file, tuple after tuple.
///
/// # Errors
/// If the file cannot be read or has no such array.
pub fn read_floats(path: &Path, name: &str) -> Result<Vec<f64>> {
    let bytes = std::fs::read(path).with_context(|| format!("{} cannot be read", path.display()))?;
    vtu::floats(&bytes, name).with_context(|| path.display().to_string())
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::path::PathBuf;

    /// Files written by Gmsh, by meshio and by VTK from the mesh that Gmsh wrote.
    const PLANE: [&str; 11] = [
        "plane_text.msh",
        "plane_binary.msh",
        "plane_meshio_22_text.msh",
        "plane_meshio_22_binary.msh",
        "plane_meshio_ascii.vtu",
        "plane_meshio_binary.vtu",
        "plane_meshio_zlib.vtu",
        "plane_vtk_appended_base64_zlib.vtu",
        "plane_vtk_appended_raw.vtu",
        "plane_vtk_appended_raw_lz4.vtu",
        "plane_vtk_binary_big_endian.vtu",
    ];

    fn data(name: &str) -> PathBuf {
        Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name)
    }

    fn parse(bytes: &[u8]) -> Result<Mesh> {
        match bytes.first() {
            Some(b'$') => gmsh::parse(bytes),
            Some(b'*') => inp::parse(bytes, None),
            _ => vtu::parse(bytes),
        }
    }

    #[test]
    fn every_encoding_reads_the_same_mesh() {
        let reference = Mesh::read(&data(PLANE[0])).unwrap();
        assert_eq!(reference.kind(), Kind::Flat);
        assert_eq!(reference.group_names.get(&3).map(String::as_str), Some("steel wheel"));
        let cells = |mesh: &Mesh| -> Vec<_> {
            mesh.cells().map(|(kind, nodes, _, group)| (kind, nodes.to_vec(), group)).collect()
        };
        for name in PLANE {
            let mesh = Mesh::read(&data(name)).unwrap();
            assert_eq!(cells(&mesh), cells(&reference), "{name}");
            for (x, y) in mesh.points.iter().zip(&reference.points) {
                // meshio writes text with 12 digits.
                assert!((0..3).all(|axis| (x[axis] - y[axis]).abs() < 1e-12), "{name}: {x:?} {y:?}");
            }
        }
        let text = Mesh::read(&data("solid_text.msh")).unwrap();
        assert_eq!(text.kind(), Kind::Solid);
        for name in ["solid_binary.msh", "solid_meshio_22_text.msh", "solid_meshio_22_binary.msh"] {
            let mesh = Mesh::read(&data(name)).unwrap();
            assert_eq!((cells(&mesh), &mesh.group_names), (cells(&text), &text.group_names), "{name}");
        }
        assert_eq!(Mesh::read(&data("shell_text.msh")).unwrap().kind(), Kind::Surface);
    }

    #[test]
    fn files_cut_short_are_errors() {
        for name in PLANE {
            let bytes = std::fs::read(data(name)).unwrap();
            let whole = parse(&bytes).unwrap().cell_count();
            for length in 10..bytes.len() {
                // Only what stands behind the last cell may be missing.
                if let Ok(mesh) = parse(&bytes[..length]) {
                    assert_eq!(mesh.cell_count(), whole, "{name} at {length}");
                    assert!(bytes.len() - length < 40, "{name} at {length}");
                }
            }
        }
    }

    /// A file that is small, and whose arrays are not: a line of zeros, compressed.
    #[test]
    fn files_that_inflate_are_refused_before_they_do() {
        use base64::Engine;
        use std::io::Write;
        let zeros = vec![0u8; 1 << 15];
        let piece = {
            let mut encoder = flate2::write::ZlibEncoder::new(Vec::new(), flate2::Compression::best());
            encoder.write_all(&zeros).unwrap();
            encoder.finish().unwrap()
        };
        let array = |pieces: u32, size: u32| {
            let words = [pieces, size, 0].into_iter().chain((0..pieces).map(|_| piece.len() as u32));
            let counts: Vec<u8> = words.flat_map(u32::to_le_bytes).collect();
            let encode = |bytes: &[u8]| base64::prelude::BASE64_STANDARD.encode(bytes);
            encode(&counts) + &encode(&piece.repeat(pieces as usize))
        };
        let file = |points: usize, data: &str| {
            format!(
                "<VTKFile type=\"UnstructuredGrid\" compressor=\"vtkZLibDataCompressor\"><UnstructuredGrid>\
                 <Piece NumberOfPoints=\"{points}\" NumberOfCells=\"1\"><Points><DataArray type=\"Float64\" \
                 NumberOfComponents=\"3\" format=\"binary\">{data}</DataArray></Points></Piece></UnstructuredGrid></VTKFile>"
            )
        };
        let said = |text: String| format!("{:#}", parse(text.as_bytes()).unwrap_err());
        // As many points as the zeros make, 700 times the file; as many as nobody can count; pieces that claim more than they hold.
        let honest = said(file(2000 * zeros.len() / 24, &array(2000, zeros.len() as u32)));
        assert!(honest.contains("100 times") && honest.contains("damaged"), "{honest}");
        assert!(said(file(usize::MAX, "AAAA")).contains("100 times"));
        let claimed = said(file(8, &array(1000, u32::MAX)));
        assert!(claimed.contains("100 times"), "{claimed}");
        // What is small in any case is read: here the points are there, and no cells.
        let small = said(file(zeros.len() / 24 * 10, &array(1, zeros.len() as u32)));
        assert!(!small.contains("100 times"), "{small}");
    }

    #[test]
    fn damaged_files_do_not_panic() {
        let mut random = fmc_shapes::Splitmix::new(1);
        for name in PLANE.into_iter().chain(["plane_meshio.inp", "instances.inp"]) {
            let bytes = std::fs::read(data(name)).unwrap();
            for _ in 0..2000 {
                let mut damaged = bytes.clone();
                for _ in 0..3 {
                    let at = random.bits() as usize % damaged.len();
                    damaged[at] = random.bits() as u8;
                }
                if let Ok(mesh) = parse(&damaged) {
                    let node_count = mesh.points.len();
                    assert!(mesh.cells().all(|(_, nodes, _, _)| nodes.iter().all(|&n| (n as usize) < node_count)));
                }
            }
        }
    }
}
