//! Writes VTU files: inline base64, which every version of ParaView reads and which is XML.

use crate::whole_file::write_whole;
use anyhow::Result;
use base64::Engine;
use base64::prelude::BASE64_STANDARD;
use fmc_contact::CellType;
use std::fmt::Write;
use std::path::Path;

/// Cell of a file to be written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum VtkCell {
    /// A point.
    Vertex,
    /// A line between two points.
    Line,
    /// A cell of a mesh.
    Mesh(CellType),
}

impl VtkCell {
    /// Number of the type in VTK.
    fn number(self) -> u8 {
        match self {
            VtkCell::Vertex => 1,
            VtkCell::Line => 3,
            VtkCell::Mesh(cell_type) => cell_type.vtk_number() as u8,
        }
    }
}

/// A grid under construction.
#[derive(Default)]
pub struct VtuWriter {
    points: Vec<[f64; 3]>,
    conn: Vec<u8>,
    conn_count: u64,
    offsets: Vec<u8>,
    types: Vec<u8>,
    point_data: String,
    cell_data: String,
}

impl VtuWriter {
    /// Adds a point and returns its index.
    pub fn point(&mut self, x: [f64; 3]) -> u64 {
        self.points.push(x);
        self.points.len() as u64 - 1
    }

    /// Adds a cell by its points.
    pub fn cell(&mut self, cell: VtkCell, points: impl IntoIterator<Item = u64>) {
        for point in points {
            self.conn.extend(point.to_le_bytes());
            self.conn_count += 1;
        }
        self.offsets.extend(self.conn_count.to_le_bytes());
        self.types.push(cell.number());
    }

    /// Number of cells so far.
    pub fn cell_count(&self) -> usize {
        self.types.len()
    }

    /// A vector for every point.
    pub fn point_vectors(&mut self, name: &str, vectors: &[[f64; 3]]) {
        data_array(&mut self.point_data, "Float64", name, 3, &float_bytes(vectors));
    }

    /// Numbers of all points, `N` each.
    pub fn point_floats<const N: usize>(&mut self, name: &str, values: &[[f64; N]]) {
        data_array(&mut self.point_data, "Float64", name, N, &float_bytes(values));
    }

    /// `N` numbers for every cell; six are read as a symmetric tensor xx, yy, zz, xy, yz, xz.
    pub fn cell_floats<const N: usize>(&mut self, name: &str, values: &[[f64; N]]) {
        data_array(&mut self.cell_data, "Float64", name, N, &float_bytes(values));
    }

    /// A whole number for every cell.
    pub fn cell_integers(&mut self, name: &str, values: &[i64]) {
        let bytes: Vec<u8> = values.iter().flat_map(|value| value.to_le_bytes()).collect();
        data_array(&mut self.cell_data, "Int64", name, 1, &bytes);
    }

    /// Writes the file.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self, path: &Path) -> Result<()> {
        let mut points = String::new();
        data_array(&mut points, "Float64", "Points", 3, &float_bytes(&self.points));
        let mut cells = String::new();
        data_array(&mut cells, "Int64", "connectivity", 1, &self.conn);
        data_array(&mut cells, "Int64", "offsets", 1, &self.offsets);
        data_array(&mut cells, "UInt8", "types", 1, &self.types);
        let text = format!(
            "<?xml version=\"1.0\"?>\n\
             <VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n\
             <UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n\
             <PointData>\n{}</PointData>\n<CellData>\n{}</CellData>\n\
             <Points>\n{points}</Points>\n<Cells>\n{cells}</Cells>\n\
             </Piece>\n</UnstructuredGrid>\n</VTKFile>\n",
            self.points.len(),
            self.types.len(),
            self.point_data,
            self.cell_data,
        );
        write_whole(path, text)
    }
}

/// A point in space; in 2D at z = 0.
pub fn in_space<const D: usize>(x: &[f64; D]) -> [f64; 3] {
    std::array::from_fn(|axis| x.get(axis).copied().unwrap_or(0.0))
}

fn float_bytes<const N: usize>(vectors: &[[f64; N]]) -> Vec<u8> {
    vectors.iter().flatten().flat_map(|value| value.to_le_bytes()).collect()
}

/// One array: the number of its bytes and then those, in base64 as one.
fn data_array(xml: &mut String, kind: &str, name: &str, components: usize, bytes: &[u8]) {
    let mut block = (bytes.len() as u64).to_le_bytes().to_vec();
    block.extend(bytes);
    let encoded = BASE64_STANDARD.encode(block);
    writeln!(
        xml,
        "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"binary\">{encoded}</DataArray>"
    )
    .expect("writing into a string");
}
