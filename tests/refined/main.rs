//! Meshes that are refined in part: nodes hang in the middle of larger faces.

#[path = "../scene/scene.rs"]
mod scene;

mod forces;
mod joined;
mod welded;

use fmc_contact::{Bodies, CellBlock, CellType, Error, Surface};
use fmc_shapes::{Mesh, cuboid_hex8, cuboid_tet4, rectangle_quad4, second_order};

/// Cells of one type, some of them divided at the middle of their edges.
fn refined<const D: usize>(mesh: &Mesh<D>, is_divided: impl Fn(usize) -> bool) -> Mesh<D> {
    let nodes = match (D, mesh.nodes_per_cell) {
        (2, 3) => 6,
        (2, _) => 9,
        (_, 4) => 10,
        _ => 27,
    };
    let whole = second_order(mesh, nodes);
    let children: Vec<Vec<usize>> = match nodes {
        6 => vec![vec![0, 3, 5], vec![3, 1, 4], vec![5, 4, 2], vec![3, 4, 5]],
        9 => vec![vec![0, 4, 8, 7], vec![4, 1, 5, 8], vec![8, 5, 2, 6], vec![7, 8, 6, 3]],
        10 => [
            [0, 4, 6, 7],
            [4, 1, 5, 8],
            [6, 5, 2, 9],
            [7, 8, 9, 3],
            [6, 8, 4, 5],
            [6, 8, 5, 9],
            [6, 8, 9, 7],
            [6, 8, 7, 4],
        ]
        .map(|child| child.to_vec())
        .to_vec(),
        _ => octants(),
    };
    let mut conn = Vec::new();
    for (number, cell) in whole.cells().enumerate() {
        if is_divided(number) {
            children.iter().for_each(|child| conn.extend(child.iter().map(|&local| cell[local])));
        } else {
            conn.extend_from_slice(&cell[..mesh.nodes_per_cell]);
        }
    }
    let mut used = vec![u32::MAX; whole.coords.len()];
    let mut coords = Vec::new();
    for node in &mut conn {
        if used[*node as usize] == u32::MAX {
            used[*node as usize] = coords.len() as u32;
            coords.push(whole.coords[*node as usize]);
        }
        *node = used[*node as usize];
    }
    Mesh { coords, conn, nodes_per_cell: mesh.nodes_per_cell }
}

/// The eight cells of a hexahedron of 27 nodes, by its lattice.
fn octants() -> Vec<Vec<usize>> {
    let lattice =
        [[0, 8, 1, 11, 24, 9, 3, 10, 2], [16, 22, 17, 20, 26, 21, 19, 23, 18], [4, 12, 5, 15, 25, 13, 7, 14, 6]];
    let mut all = Vec::new();
    for (i, j, k) in (0..8).map(|n| (n & 1, n >> 1 & 1, n >> 2)) {
        let at = |x: usize, y: usize, z: usize| lattice[k + z][3 * (j + y) + i + x];
        let corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)];
        all.push(corners.map(|(x, y, z)| at(x, y, z)).to_vec());
    }
    all
}

fn triangles(min: [f64; 2], max: [f64; 2], cells: [usize; 2]) -> Mesh<2> {
    fmc_shapes::rectangle_tri3(min, max, cells, fmc_shapes::Diagonals::Alternating)
}

/// Rectangles, every third cell refined.
fn rectangles(min: [f64; 2], max: [f64; 2], cells: [usize; 2]) -> [Mesh<2>; 2] {
    [triangles(min, max, cells), rectangle_quad4(min, max, cells)].map(|mesh| refined(&mesh, |cell| cell % 3 == 0))
}

/// Boxes, every third cell refined; of tetrahedra all six of a box.
fn boxes(min: [f64; 3], max: [f64; 3], cells: [usize; 3]) -> [Mesh<3>; 2] {
    let tetrahedra = cuboid_tet4(min, max, cells);
    let of_box = tetrahedra.cell_count() / cells.iter().product::<usize>();
    [
        refined(&tetrahedra, |cell| (cell / of_box).is_multiple_of(3)),
        refined(&cuboid_hex8(min, max, cells), |cell| cell.is_multiple_of(3)),
    ]
}

fn surface<const D: usize>(mesh: &Mesh<D>) -> Result<Surface<D>, Error> {
    let cell_type = match (D, mesh.nodes_per_cell) {
        (2, 3) => CellType::Tri3,
        (2, _) => CellType::Quad4,
        (_, 4) => CellType::Tet4,
        _ => CellType::Hex8,
    };
    Surface::from_cells(&mesh.coords, &[CellBlock { cell_type, conn: &mesh.conn }], Bodies::Connected)
}
