//! Hexahedra, wedges, pyramids and tetrahedra in one file.

use fmc_contact::CellType;
use fmc_mesh_io::{Kind, Mesh, VtkCell, VtuWriter};
use fmc_shapes::cuboid_mixed;
use std::fmt::Write;

const TYPES: [(CellType, u8); 4] =
    [(CellType::Hex8, 5), (CellType::Wedge6, 6), (CellType::Pyramid5, 7), (CellType::Tet4, 4)];

fn is_read_back(name: &str, text: impl FnOnce(&std::path::Path)) {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"));
    let path = folder.join(name);
    text(&path);
    let mesh = Mesh::read(&path).expect("a mesh");
    let meshes = cuboid_mixed([0.0; 3], [1.0; 3], [2, 1, 3]);
    assert_eq!((mesh.kind(), mesh.blocks.len(), &mesh.points), (Kind::Solid, 4, &meshes[0].coords));
    for ((block, (cell_type, _)), expected) in mesh.blocks.iter().zip(TYPES).zip(&meshes) {
        assert_eq!((block.cell_type, &block.conn), (cell_type, &expected.conn));
    }
    mesh.cells().enumerate().for_each(|(number, cell)| assert_eq!(mesh.cell(number), Some(cell)));
    assert_eq!(mesh.cell(mesh.cell_count()), None);
}

#[test]
fn of_gmsh() {
    let meshes = cuboid_mixed([0.0; 3], [1.0; 3], [2, 1, 3]);
    let (nodes, cells) = (meshes[0].coords.len(), meshes.iter().map(|mesh| mesh.cell_count()).sum::<usize>());
    let mut text = format!("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 {nodes} 1 {nodes}\n3 1 0 {nodes}\n");
    (1..=nodes).for_each(|tag| writeln!(text, "{tag}").unwrap());
    meshes[0].coords.iter().for_each(|[x, y, z]| writeln!(text, "{x} {y} {z}").unwrap());
    writeln!(text, "$EndNodes\n$Elements\n4 {cells} 1 {cells}").unwrap();
    let mut tag = 0;
    for (mesh, (_, number)) in meshes.iter().zip(TYPES) {
        writeln!(text, "3 1 {number} {}", mesh.cell_count()).unwrap();
        for cell in mesh.cells() {
            tag += 1;
            let nodes: Vec<String> = cell.iter().map(|node| (node + 1).to_string()).collect();
            writeln!(text, "{tag} {}", nodes.join(" ")).unwrap();
        }
    }
    text.push_str("$EndElements\n");
    is_read_back("mixed.msh", |path| std::fs::write(path, text).unwrap());
}

#[test]
fn of_vtk() {
    let meshes = cuboid_mixed([0.0; 3], [1.0; 3], [2, 1, 3]);
    let mut writer = VtuWriter::default();
    meshes[0].coords.iter().for_each(|x| {
        writer.point(*x);
    });
    for (mesh, (cell_type, _)) in meshes.iter().zip(TYPES) {
        mesh.cells().for_each(|cell| writer.cell(VtkCell::Mesh(cell_type), cell.iter().map(|&n| u64::from(n))));
    }
    is_read_back("mixed.vtu", |path| writer.write(path).unwrap());
}
