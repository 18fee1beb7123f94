//! Writes the meshes in `examples/`: `cargo run -p fmc-mesh-io --example make_meshes`.
//!
//! `star.msh`, `block.msh`: the paper's star, its lowest tip 0.01 deep in a block; 2D, Quad4, metres.
//! `two_blocks.msh`: two blocks of Tet4 cells of different size in one file, 0.02 deep in one another, each a physical
//! group. `ball.vtu`, `plate.msh`: a ball of Tet4 cells 0.02 deep in a plate of Hex8 cells.

use fmc_shapes::{Mesh, ball_tet4, cuboid_hex8, cuboid_tet4, rectangle_quad4, star_quad4};
use std::fmt::{Display, Write};
use std::path::Path;

fn main() -> std::io::Result<()> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../examples");
    let star = star_quad4(4, 0.1, 0.03, 12, 2).translated([0.0, 0.09]);
    let block = rectangle_quad4([-0.1, -0.2], [0.1, 0.0], [50, 19]);
    let lower = cuboid_tet4([0.0, 0.0, 0.0], [1.0, 1.0, 0.5], [6, 6, 3]);
    let upper = cuboid_tet4([0.2, 0.3, 0.48], [0.7, 0.8, 0.98], [4, 4, 4]);
    let ball = ball_tet4(0.5, 3, 1).translated([0.0, 0.0, 0.48]);
    let plate = cuboid_hex8([-0.6, -0.6, -0.2], [0.6, 0.6, 0.0], [18, 18, 3]);
    std::fs::create_dir_all(&folder)?;
    std::fs::write(folder.join("star.msh"), msh(&[("star", &star)]))?;
    std::fs::write(folder.join("block.msh"), msh(&[("block", &block)]))?;
    std::fs::write(folder.join("two_blocks.msh"), msh(&[("lower", &lower), ("upper", &upper)]))?;
    std::fs::write(folder.join("ball.vtu"), vtu(&ball))?;
    std::fs::write(folder.join("plate.msh"), msh(&[("plate", &plate)]))
}

/// Gmsh 4.1, text: every body an entity and a physical group of its own.
fn msh<const D: usize>(bodies: &[(&str, &Mesh<D>)]) -> String {
    let mut names = format!("{}\n", bodies.len());
    let mut entities = if D == 2 { format!("0 0 {} 0\n", bodies.len()) } else { format!("0 0 0 {}\n", bodies.len()) };
    let (mut nodes, mut elements) = (String::new(), String::new());
    let (mut node_count, mut element_count) = (0, 0);
    for (position, (name, mesh)) in bodies.iter().enumerate() {
        let tag = position + 1;
        let bound = |pick: fn(f64, f64) -> f64| {
            let corner = mesh.coords.iter().map(in_space).reduce(|p, q| std::array::from_fn(|k| pick(p[k], q[k])));
            words(&corner.expect("a mesh has nodes"))
        };
        writeln!(names, "{D} {tag} \"{name}\"").unwrap();
        writeln!(entities, "{tag} {} {} 1 {tag} 0", bound(f64::min), bound(f64::max)).unwrap();
        writeln!(nodes, "{D} {tag} 0 {}", mesh.coords.len()).unwrap();
        for node in 1..=mesh.coords.len() {
            writeln!(nodes, "{}", node_count + node).unwrap();
        }
        for x in &mesh.coords {
            writeln!(nodes, "{}", words(&in_space(x))).unwrap();
        }
        let kind = match (D, mesh.nodes_per_cell) {
            (2, 4) => 3,
            (3, 4) => 4,
            (3, 8) => 5,
            other => unreachable!("no example has such cells: {other:?}"),
        };
        writeln!(elements, "{D} {tag} {kind} {}", mesh.cell_count()).unwrap();
        for cell in mesh.cells() {
            element_count += 1;
            let cell: Vec<usize> = cell.iter().map(|&node| node_count + node as usize + 1).collect();
            writeln!(elements, "{element_count} {}", words(&cell)).unwrap();
        }
        node_count += mesh.coords.len();
    }
    let count = bodies.len();
    format!(
        "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$PhysicalNames\n{names}$EndPhysicalNames\n\
         $Entities\n{entities}$EndEntities\n\
         $Nodes\n{count} {node_count} 1 {node_count}\n{nodes}$EndNodes\n\
         $Elements\n{count} {element_count} 1 {element_count}\n{elements}$EndElements\n"
    )
}

/// VTK unstructured grid of Tet4 cells, text.
fn vtu(mesh: &Mesh<3>) -> String {
    let array = |kind: &str, name: &str, components: usize, rows: Vec<String>| {
        format!(
            "<DataArray type=\"{kind}\" Name=\"{name}\" NumberOfComponents=\"{components}\" format=\"ascii\">\n{}\n\
             </DataArray>\n",
            rows.join("\n")
        )
    };
    let points = array("Float64", "Points", 3, mesh.coords.iter().map(|x| words(x)).collect());
    let conn = array("Int64", "connectivity", 1, mesh.cells().map(words).collect());
    let offsets: Vec<usize> = (1..=mesh.cell_count()).map(|cell| 4 * cell).collect();
    let offsets = array("Int64", "offsets", 1, offsets.chunks(20).map(words).collect());
    let types = array("UInt8", "types", 1, vec![10; mesh.cell_count()].chunks(20).map(words).collect());
    format!(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" byte_order=\"LittleEndian\">\n\
         <UnstructuredGrid>\n<Piece NumberOfPoints=\"{}\" NumberOfCells=\"{}\">\n\
         <Points>\n{points}</Points>\n<Cells>\n{conn}{offsets}{types}</Cells>\n\
         </Piece>\n</UnstructuredGrid>\n</VTKFile>\n",
        mesh.coords.len(),
        mesh.cell_count(),
    )
}

fn in_space<const D: usize>(x: &[f64; D]) -> [f64; 3] {
    std::array::from_fn(|axis| x.get(axis).copied().unwrap_or(0.0))
}

fn words(numbers: &[impl Display]) -> String {
    numbers.iter().map(|number| number.to_string()).collect::<Vec<_>>().join(" ")
}
