//! Element types that are solved, and their faces.

use crate::Fault;
use fmc_contact::CellType;
use fmc_mesh_io::inp::{cell_type_of_element, rigid_corners};

/// Where an element stands, and its type as the file has it.
#[derive(Clone, Debug)]
pub(crate) struct ElementRow {
    pub(crate) line: usize,
    /// The line of its keyword.
    pub(crate) keyword: usize,
    pub(crate) kind: String,
}

impl ElementRow {
    /// Its type without the letters of a variant, and these letters.
    pub(crate) fn stem(&self) -> (&str, &str) {
        stem(&self.kind)
    }

    /// Whether it is the front of a layer: a rigid element, or a face of an analytical surface.
    pub(crate) fn is_rigid(&self) -> bool {
        rigid_corners(&self.kind).is_some() || self.kind == "ANALYTICAL SURFACE"
    }

    /// Whether it has incompatible modes, as far as its type says.
    pub(crate) fn has_modes(&self) -> bool {
        matches!(self.stem(), ("C3D8" | "CPE4" | "CPS4", letters) if letters.contains('I'))
    }
}

fn stem(kind: &str) -> (&str, &str) {
    kind.split_at(kind.trim_end_matches(|c: char| c.is_ascii_alphabetic()).len())
}

/// Types that are solved, up to their variants.
const SOLVED: [&str; 19] = [
    "CPE3", "CPE4", "CPE6", "CPE8", "CPS3", "CPS4", "CPS6", "CPS8", "CAX3", "CAX4", "CAX6", "CAX8", "C3D4", "C3D6",
    "C3D8", "C3D10", "C3D15", "C3D20", "C3D27",
];

/// The cell of an element type.
pub(super) fn solved(line: usize, name: &str) -> Result<CellType, Fault> {
    let upper = name.to_uppercase();
    let (stem, _) = stem(&upper);
    let refused = |why: String| Err(Fault::new(line, format!("elements of type {name} are not solved: {why}")));
    match (SOLVED.contains(&stem), cell_type_of_element(&upper)) {
        (true, Some(cell_type)) if !upper.ends_with(['T', 'P']) => Ok(cell_type),
        (true, _) => refused("temperatures and pore pressures are not known".to_owned()),
        _ if upper.starts_with("M3D") => refused("membranes are not known".to_owned()),
        _ => refused(format!("known are {}, with their variants R, I, H, M", SOLVED.join(", "))),
    }
}

/// Whether elements of a type are sections of bodies of revolution.
pub(super) fn is_ring(name: &str) -> bool {
    name.to_uppercase().starts_with("CAX")
}

/// Corners of the faces of a cell, in the order of `S1`, `S2`, …
pub(crate) fn face_corners(cell_type: CellType) -> &'static [&'static [usize]] {
    const TRIANGLE: [&[usize]; 3] = [&[0, 1], &[1, 2], &[2, 0]];
    const QUADRILATERAL: [&[usize]; 4] = [&[0, 1], &[1, 2], &[2, 3], &[3, 0]];
    const TETRAHEDRON: [&[usize]; 4] = [&[0, 1, 2], &[0, 3, 1], &[1, 3, 2], &[2, 3, 0]];
    const HEXAHEDRON: [&[usize]; 6] =
        [&[0, 1, 2, 3], &[4, 7, 6, 5], &[0, 4, 5, 1], &[1, 5, 6, 2], &[2, 6, 7, 3], &[3, 7, 4, 0]];
    const WEDGE: [&[usize]; 5] = [&[0, 1, 2], &[3, 5, 4], &[0, 3, 4, 1], &[1, 4, 5, 2], &[2, 5, 3, 0]];
    match cell_type.straight() {
        CellType::Tri3 => &TRIANGLE,
        CellType::Quad4 => &QUADRILATERAL,
        CellType::Tet4 => &TETRAHEDRON,
        CellType::Hex8 => &HEXAHEDRON,
        CellType::Wedge6 => &WEDGE,
        _ => &[],
    }
}
