//! Element types of Abaqus by their names.
//!
//! Source: Abaqus Analysis User's Guide, "Element Library", the node order and face numbers of each family. Up to 20 nodes the order is
//! ours: corners, edges around the bottom, around the top, between both. `C3D27` has its centre first after these, then the faces in
//! the order of their numbers.

use crate::excerpt::shortened;
use anyhow::{Result, bail};
use fmc_contact::CellType;

/// Elements that have cells.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cell {
    pub(super) cell_type: CellType,
    /// Faces of bodies that are nothing else: beside solids they would be left out without a word.
    pub(super) is_shell: bool,
}

/// What a name stands for.
pub(super) enum Element {
    Cell(Cell),
    /// Points and lines, which touch nothing.
    Slender,
}

/// The beginning of a name, up to its count of nodes.
const STEMS: [(&str, CellType, bool); 36] = [
    ("CPS3", CellType::Tri3, false),
    ("CPE3", CellType::Tri3, false),
    ("CPEG3", CellType::Tri3, false),
    ("CAX3", CellType::Tri3, false),
    ("CPS4", CellType::Quad4, false),
    ("CPE4", CellType::Quad4, false),
    ("CPEG4", CellType::Quad4, false),
    ("CAX4", CellType::Quad4, false),
    ("CPS6", CellType::Tri6, false),
    ("CPE6", CellType::Tri6, false),
    ("CPEG6", CellType::Tri6, false),
    ("CAX6", CellType::Tri6, false),
    ("CPS8", CellType::Quad8, false),
    ("CPE8", CellType::Quad8, false),
    ("CPEG8", CellType::Quad8, false),
    ("CAX8", CellType::Quad8, false),
    ("C3D4", CellType::Tet4, false),
    ("C3D5", CellType::Pyramid5, false),
    ("C3D6", CellType::Wedge6, false),
    ("C3D8", CellType::Hex8, false),
    ("C3D10", CellType::Tet10, false),
    ("C3D15", CellType::Wedge15, false),
    ("C3D20", CellType::Hex20, false),
    ("C3D27", CellType::Hex27, false),
    ("S3", CellType::Tri3, true),
    ("STRI3", CellType::Tri3, true),
    ("R3D3", CellType::Tri3, true),
    ("M3D3", CellType::Tri3, true),
    ("SFM3D3", CellType::Tri3, true),
    ("S4", CellType::Quad4, true),
    ("R3D4", CellType::Quad4, true),
    ("M3D4", CellType::Quad4, true),
    ("SFM3D4", CellType::Quad4, true),
    ("STRI65", CellType::Tri6, true),
    ("S8", CellType::Quad8, true),
    ("S9", CellType::Quad9, true),
];

/// Letters behind the count that change the element and not its nodes: reduced integration, incompatible modes, hybrid, modified,
/// improved stress, temperature, pore pressure, and the numbers of freedoms of shells.
const VARIANTS: &str = "RIHMSTPW5";

const SLENDER: [&str; 14] =
    ["T2D", "T3D", "B21", "B22", "B23", "B31", "B32", "B33", "PIPE", "MASS", "ROTARYI", "SPRING", "DASHPOT", "CONN"];

impl Element {
    /// The element of this name; `line` is where it stands.
    pub(super) fn of_name(line: usize, name: &str) -> Result<Self> {
        let name = name.to_uppercase();
        let rest = |stem: &str| name.strip_prefix(stem).filter(|rest| !rest.starts_with(|c: char| c.is_ascii_digit()));
        let is_variant = |rest: &str| rest.chars().all(|c| VARIANTS.contains(c));
        if let Some(&(_, cell_type, is_shell)) = STEMS.iter().find(|row| rest(row.0).is_some_and(is_variant)) {
            return Ok(Self::Cell(Cell { cell_type, is_shell }));
        }
        if SLENDER.iter().any(|stem| name.starts_with(stem)) {
            return Ok(Self::Slender);
        }
        if ["R2D", "RAX"].iter().any(|stem| name.starts_with(stem)) {
            bail!(
                "line {line}: elements of type {} are rigid lines, which are not supported: a tool needs an inside, of solid elements",
                shortened(&name)
            );
        }
        let known: Vec<&str> = STEMS.iter().map(|row| row.0).collect();
        bail!(
            "line {line}: elements of type {} are not supported, only {}, and their variants",
            shortened(&name),
            known.join(", ")
        );
    }
}

/// The cell that an element of this name is; none for points, lines and unknown names.
pub fn cell_type_of_element(name: &str) -> Option<CellType> {
    match Element::of_name(0, name) {
        Ok(Element::Cell(cell)) => Some(cell.cell_type),
        _ => None,
    }
}

/// Corners of a rigid element of this name, a line or a face; none for all others.
pub fn rigid_corners(name: &str) -> Option<usize> {
    match name.to_uppercase().as_str() {
        "R2D2" | "RAX2" => Some(2),
        "R3D3" => Some(3),
        "R3D4" => Some(4),
        _ => None,
    }
}

impl Cell {
    /// The place in the file of our node `number`.
    pub(super) fn place(&self, number: usize) -> usize {
        /// Our faces: x−, x+, y−, y+, below, above, then the centre.
        const FACES_OF_HEX27: [usize; 7] = [26, 24, 23, 25, 21, 22, 20];
        if self.cell_type == CellType::Hex27 && number >= 20 { FACES_OF_HEX27[number - 20] } else { number }
    }
}
