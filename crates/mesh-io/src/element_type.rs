//! Element types of Gmsh and VTK.

use fmc_contact::CellType;

/// An element type of a file format.
#[derive(Clone, Copy, Debug)]
pub(super) struct ElementType {
    pub(super) name: &'static str,
    pub(super) dimension: usize,
    pub(super) node_count: usize,
    /// The cell that it is, if it is one. VTK defines its wedges as the mirror image of Gmsh's; files are in either order, and
    /// both are taken.
    pub(super) cell_type: Option<CellType>,
    /// Where the nodes of the cell stand in a row of the file, in our order; empty where the orders agree.
    order: &'static [usize],
}

/// Cells by their numbers in Gmsh.
const CELLS: [(CellType, i64); 14] = [
    (CellType::Tri3, 2),
    (CellType::Quad4, 3),
    (CellType::Tet4, 4),
    (CellType::Hex8, 5),
    (CellType::Wedge6, 6),
    (CellType::Pyramid5, 7),
    (CellType::Tri6, 9),
    (CellType::Quad9, 10),
    (CellType::Tet10, 11),
    (CellType::Hex27, 12),
    (CellType::Quad8, 16),
    (CellType::Hex20, 17),
    (CellType::Wedge15, 18),
    (CellType::Pyramid13, 19),
];

/// Gmsh's places of our nodes, where they differ: Gmsh numbers edges by their lower, then their upper corner (of a tetrahedron
/// the last two are exchanged), and has its own order of a hexahedron's faces.
const fn gmsh_order(cell_type: CellType) -> &'static [usize] {
    match cell_type {
        CellType::Tet10 => &[0, 1, 2, 3, 4, 5, 6, 7, 9, 8],
        CellType::Hex20 => &[0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 13, 9, 16, 18, 19, 17, 10, 12, 14, 15],
        CellType::Hex27 => {
            &[0, 1, 2, 3, 4, 5, 6, 7, 8, 11, 13, 9, 16, 18, 19, 17, 10, 12, 14, 15, 22, 23, 21, 24, 20, 25, 26]
        }
        CellType::Wedge15 => &[0, 1, 2, 3, 4, 5, 6, 9, 7, 12, 14, 13, 8, 10, 11],
        CellType::Pyramid13 => &[0, 1, 2, 3, 4, 5, 8, 10, 6, 7, 9, 11, 12],
        _ => &[],
    }
}

impl ElementType {
    /// Element type by its number in the MSH format.
    pub(super) fn of_gmsh(number: i64) -> Option<Self> {
        GMSH.iter().find(|row| row.0 == number).map(|&(_, name, dimension, node_count)| {
            let cell_type = CELLS.iter().find(|row| row.1 == number).map(|row| row.0);
            Self { name, dimension, node_count, cell_type, order: cell_type.map_or(&[], gmsh_order) }
        })
    }

    /// Element type by its number in VTK; types of variable size have a node count of 0.
    pub(super) fn of_vtk(number: i64) -> Option<Self> {
        VTK.iter().find(|row| row.0 == number).map(|&(_, name, dimension, node_count)| {
            let cell_type = i32::try_from(number).ok().and_then(CellType::of_vtk_number);
            Self { name, dimension, node_count, cell_type, order: &[] }
        })
    }

    /// The entry of a row of the file that is our node `number`.
    pub(super) fn place(&self, number: usize) -> usize {
        self.order.get(number).copied().unwrap_or(number)
    }

    /// Why these cells cannot be used.
    pub(super) fn refusal(&self) -> String {
        let Self { name, .. } = self;
        let named = |first_order: bool| {
            let of_order = CellType::all().filter(|cell_type| (cell_type.straight() == *cell_type) == first_order);
            of_order.map(|cell_type| format!("{cell_type:?}")).collect::<Vec<_>>().join(", ")
        };
        format!("{name} cells are not supported, only {}, and of second order {}", named(true), named(false))
    }
}

/// Number, name, dimension and nodes (Gmsh reference manual, "MSH file format").
const GMSH: &[(i64, &str, usize, usize)] = &[
    (1, "Line2", 1, 2),
    (2, "Tri3", 2, 3),
    (3, "Quad4", 2, 4),
    (4, "Tet4", 3, 4),
    (5, "Hex8", 3, 8),
    (6, "Wedge6", 3, 6),
    (7, "Pyramid5", 3, 5),
    (8, "Line3", 1, 3),
    (9, "Tri6", 2, 6),
    (10, "Quad9", 2, 9),
    (11, "Tet10", 3, 10),
    (12, "Hex27", 3, 27),
    (13, "Wedge18", 3, 18),
    (14, "Pyramid14", 3, 14),
    (15, "Point", 0, 1),
    (16, "Quad8", 2, 8),
    (17, "Hex20", 3, 20),
    (18, "Wedge15", 3, 15),
    (19, "Pyramid13", 3, 13),
    (20, "Tri9", 2, 9),
    (21, "Tri10", 2, 10),
    (22, "Tri12", 2, 12),
    (23, "Tri15", 2, 15),
    (24, "Tri15 (incomplete)", 2, 15),
    (25, "Tri21", 2, 21),
    (26, "Line4", 1, 4),
    (27, "Line5", 1, 5),
    (28, "Line6", 1, 6),
    (29, "Tet20", 3, 20),
    (30, "Tet35", 3, 35),
    (31, "Tet56", 3, 56),
    (36, "Quad16", 2, 16),
    (37, "Quad25", 2, 25),
    (38, "Quad36", 2, 36),
    (39, "Quad12", 2, 12),
    (40, "Quad16 (incomplete)", 2, 16),
    (41, "Quad20", 2, 20),
    (92, "Hex64", 3, 64),
    (93, "Hex125", 3, 125),
];

/// Number, name, dimension and nodes (`vtkCellType.h`).
const VTK: &[(i64, &str, usize, usize)] = &[
    (1, "Point", 0, 1),
    (2, "PolyVertex", 0, 0),
    (3, "Line2", 1, 2),
    (4, "PolyLine", 1, 0),
    (5, "Tri3", 2, 3),
    (6, "TriangleStrip", 2, 0),
    (7, "Polygon", 2, 0),
    (8, "Pixel", 2, 4),
    (9, "Quad4", 2, 4),
    (10, "Tet4", 3, 4),
    (11, "Voxel", 3, 8),
    (12, "Hex8", 3, 8),
    (13, "Wedge6", 3, 6),
    (14, "Pyramid5", 3, 5),
    (21, "Line3", 1, 3),
    (22, "Tri6", 2, 6),
    (23, "Quad8", 2, 8),
    (24, "Tet10", 3, 10),
    (25, "Hex20", 3, 20),
    (26, "Wedge15", 3, 15),
    (27, "Pyramid13", 3, 13),
    (28, "Quad9", 2, 9),
    (29, "Hex27", 3, 27),
    (34, "Tri7", 2, 7),
    (35, "Line4", 1, 4),
    (36, "Polygon of second order", 2, 0),
    (42, "Polyhedron", 3, 0),
    (68, "Lagrange curve", 1, 0),
    (69, "Lagrange triangle", 2, 0),
    (70, "Lagrange quadrilateral", 2, 0),
    (71, "Lagrange tetrahedron", 3, 0),
    (72, "Lagrange hexahedron", 3, 0),
    (73, "Lagrange wedge", 3, 0),
    (74, "Lagrange pyramid", 3, 0),
    (75, "Bezier curve", 1, 0),
    (76, "Bezier triangle", 2, 0),
    (77, "Bezier quadrilateral", 2, 0),
    (78, "Bezier tetrahedron", 3, 0),
    (79, "Bezier hexahedron", 3, 0),
    (80, "Bezier wedge", 3, 0),
    (81, "Bezier pyramid", 3, 0),
];
