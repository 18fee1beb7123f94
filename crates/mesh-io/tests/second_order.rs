//! Cells of second order: Gmsh's order of nodes, Abaqus', VTK's, and ours.

use fmc_contact::{Bodies, CellBlock, CellType, Surface};
use fmc_mesh_io::{Kind, Mesh, VtkCell, VtuWriter};
use std::fmt::Write;
use std::path::PathBuf;

/// Corners of a cell by its number in Gmsh, and what lies between which of them after the corners, in the order of Gmsh's
/// reference manual ("Node ordering"); its number in VTK, and the same there (`vtkQuadraticTriangle.h` and others).
struct Layout {
    cell_type: CellType,
    gmsh: i64,
    between: &'static str,
    ours: &'static str,
}

const LAYOUTS: [Layout; 8] = [
    Layout { cell_type: CellType::Tri6, gmsh: 9, between: "01 12 20", ours: "01 12 20" },
    Layout { cell_type: CellType::Quad8, gmsh: 16, between: "01 12 23 30", ours: "01 12 23 30" },
    Layout { cell_type: CellType::Quad9, gmsh: 10, between: "01 12 23 30 0123", ours: "01 12 23 30 0123" },
    Layout { cell_type: CellType::Tet10, gmsh: 11, between: "01 12 20 30 23 13", ours: "01 12 20 03 13 23" },
    Layout {
        cell_type: CellType::Hex20,
        gmsh: 17,
        between: "01 03 04 12 15 23 26 37 45 47 56 67",
        ours: "01 12 23 30 45 56 67 74 04 15 26 37",
    },
    Layout {
        cell_type: CellType::Hex27,
        gmsh: 12,
        between: "01 03 04 12 15 23 26 37 45 47 56 67 0321 0154 0473 1265 2376 4567 01234567",
        ours: "01 12 23 30 45 56 67 74 04 15 26 37 0473 1265 0154 3762 0321 4567 01234567",
    },
    Layout {
        cell_type: CellType::Wedge15,
        gmsh: 18,
        between: "01 02 03 12 14 25 34 35 45",
        ours: "01 12 20 34 45 53 03 14 25",
    },
    Layout {
        cell_type: CellType::Pyramid13,
        gmsh: 19,
        between: "01 03 04 12 14 23 24 34",
        ours: "01 12 23 30 04 14 24 34",
    },
];

fn corners(cell_type: CellType) -> Vec<[f64; 3]> {
    let square = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.]];
    let above = square.map(|[x, y, _]| [x, y, 1.0]);
    match cell_type.straight() {
        CellType::Tri3 => vec![square[0], square[1], square[3]],
        CellType::Quad4 => square.to_vec(),
        CellType::Tet4 => vec![square[0], square[1], square[3], above[0]],
        CellType::Wedge6 => vec![square[0], square[1], square[3], above[0], above[1], above[3]],
        CellType::Pyramid5 => [&square[..], &[[0.5, 0.5, 1.0]]].concat(),
        _ => [square, above].concat(),
    }
}

/// Corners, then the means of those named.
fn nodes(cell_type: CellType, between: &str) -> Vec<[f64; 3]> {
    let corners = corners(cell_type);
    let mean = |word: &str| {
        let around: Vec<usize> = word.bytes().map(|digit| usize::from(digit - b'0')).collect();
        std::array::from_fn(|axis| around.iter().map(|&k| corners[k][axis]).sum::<f64>() / around.len() as f64)
    };
    corners.iter().copied().chain(between.split(' ').map(mean)).collect()
}

fn path(name: String) -> PathBuf {
    PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name)
}

/// Abaqus' names, with what lies between which corners where its order is another than ours (Abaqus Analysis User's Guide, "Three-
/// dimensional solid element library": node 21 of C3D27 is the centre, the nodes after it lie on faces 1 to 6, 1-2-3-4, 5-8-7-6,
/// 1-5-6-2, 2-6-7-3, 3-7-8-4, 4-8-5-1).
fn abaqus(layout: &Layout) -> Option<(&'static str, &'static str)> {
    Some(match layout.cell_type {
        CellType::Tri6 => ("CPE6", layout.ours),
        CellType::Quad8 => ("cps8r", layout.ours),
        CellType::Tet10 => ("C3D10M", layout.ours),
        CellType::Hex20 => ("C3D20R", layout.ours),
        CellType::Hex27 => ("C3D27", "01 12 23 30 45 56 67 74 04 15 26 37 01234567 0123 4765 0451 1562 2673 3740"),
        CellType::Wedge15 => ("C3D15", layout.ours),
        _ => return None,
    })
}

/// One cell as read: its nodes are where ours are, and the body has the volume of the cell.
fn is_ours(layout: &Layout, mesh: &Mesh) {
    let Layout { cell_type, ours, .. } = layout;
    let flat = cell_type.dimension() == 2;
    assert_eq!((mesh.kind(), mesh.cell_count()), (if flat { Kind::Flat } else { Kind::Solid }, 1));
    let [block] = &mesh.blocks[..] else { panic!("{cell_type:?}: {} blocks", mesh.blocks.len()) };
    assert_eq!(block.cell_type, *cell_type);
    let found: Vec<[f64; 3]> = block.conn.iter().map(|&node| mesh.points[node as usize]).collect();
    assert_eq!(found, nodes(*cell_type, ours), "{cell_type:?}");
    // Nodes elsewhere than in their middles would make cells inside out.
    let block = CellBlock { cell_type: *cell_type, conn: &block.conn };
    if flat {
        let coords: Vec<[f64; 2]> = mesh.points.iter().map(|x| [x[0], x[1]]).collect();
        assert_eq!(Surface::from_cells(&coords, &[block], Bodies::Connected).expect("a body").body_count(), 1);
    } else {
        let surface = Surface::from_cells(&mesh.points, &[block], Bodies::Connected).expect("a body");
        assert_eq!(surface.body_count(), 1);
    }
}

#[test]
fn nodes_of_gmsh_are_put_in_order() {
    for layout in &LAYOUTS {
        let Layout { cell_type, gmsh, between, .. } = layout;
        let (points, dimension) = (nodes(*cell_type, between), cell_type.dimension());
        let count = points.len();
        assert_eq!(count, cell_type.node_count());
        let mut text =
            format!("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 {count} 1 {count}\n{dimension} 1 0 {count}\n");
        (1..=count).for_each(|tag| writeln!(text, "{tag}").unwrap());
        points.iter().for_each(|[x, y, z]| writeln!(text, "{x} {y} {z}").unwrap());
        let row: Vec<String> = (1..=count).map(|tag| tag.to_string()).collect();
        writeln!(text, "$EndNodes\n$Elements\n1 1 1 1\n{dimension} 1 {gmsh} 1\n1 {}\n$EndElements", row.join(" "))
            .unwrap();
        let path = path(format!("{cell_type:?}.msh"));
        std::fs::write(&path, text).unwrap();
        is_ours(layout, &Mesh::read(&path).expect("a mesh"));
    }
}

#[test]
fn nodes_of_abaqus_are_put_in_order() {
    for layout in &LAYOUTS {
        let Some((name, between)) = abaqus(layout) else { continue };
        let points = nodes(layout.cell_type, between);
        let mut text = "*Node\n".to_owned();
        for (label, [x, y, z]) in (1..).zip(&points) {
            writeln!(text, "{label}, {x}, {y}, {z}").unwrap();
        }
        // Sixteen entries a line, as Abaqus has it.
        let entries: Vec<String> = std::iter::once(7).chain(1..=points.len()).map(|label| label.to_string()).collect();
        let rows: Vec<String> = entries.chunks(16).map(|row| row.join(", ")).collect();
        writeln!(text, "*Element, type={name}\n{}", rows.join(",\n")).unwrap();
        let path = path(format!("{:?}.inp", layout.cell_type));
        std::fs::write(&path, text).unwrap();
        is_ours(layout, &Mesh::read(&path).expect("a mesh"));
    }
}

#[test]
fn nodes_of_vtk_are_ours() {
    for layout in &LAYOUTS {
        let mut writer = VtuWriter::default();
        let points: Vec<u64> = nodes(layout.cell_type, layout.ours).iter().map(|x| writer.point(*x)).collect();
        writer.cell(VtkCell::Mesh(layout.cell_type), points);
        let path = path(format!("{:?}.vtu", layout.cell_type));
        writer.write(&path).unwrap();
        is_ours(layout, &Mesh::read(&path).expect("a mesh"));
    }
}
