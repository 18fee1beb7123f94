//! Bodies in hexahedra, wedges, pyramids and tetrahedra.

use crate::command::{folder, json};
use fmc_contact::CellType;
use fmc_mesh_io::{VtkCell, VtuWriter};
use fmc_shapes::cuboid_mixed;

/// Two blocks in one file, 0.02 deep in one another over 0.5 × 0.5: V = 0.005, F = K · 0.25.
#[test]
fn blocks_of_all_cells() {
    let mut writer = VtuWriter::default();
    let types = [CellType::Hex8, CellType::Wedge6, CellType::Pyramid5, CellType::Tet4];
    for (low, high) in [([0.0; 3], [1.0; 3]), ([0.2, 0.3, 0.98], [0.7, 0.8, 1.98])] {
        let meshes = cuboid_mixed(low, high, [3, 2, 4]);
        let nodes: Vec<u64> = meshes[0].coords.iter().map(|x| writer.point(*x)).collect();
        for (mesh, cell_type) in meshes.iter().zip(types) {
            mesh.cells()
                .for_each(|cell| writer.cell(VtkCell::Mesh(cell_type), cell.iter().map(|&n| nodes[n as usize])));
        }
    }
    let path = folder("blocks_of_all_cells").join("mixed.vtu");
    writer.write(&path).unwrap();
    let found = json("blocks_of_all_cells", &format!("{} --stiffness 1e6 --law volume", path.display()));
    assert_eq!(found["bodies"].as_array().unwrap().len(), 2);
    assert!((found["volume"].as_f64().unwrap() / 0.005 - 1.0).abs() < 1e-12, "{found}");
    let up = found["bodies"][1]["force"][2].as_f64().unwrap();
    assert!((up / 2.5e5 - 1.0).abs() < 1e-12, "{up}");
}
