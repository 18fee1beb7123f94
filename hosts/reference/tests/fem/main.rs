//! The finite elements against closed forms, finite differences and what must always hold.

mod consistency;
mod frequency;
mod loads;
mod modes;
mod patch;
mod refusals;
mod rings;
mod second_order;
mod stress;

use fmc_contact::CellType;
use fmc_shapes::{
    Diagonals, Mesh, Splitmix, cuboid_hex8, cuboid_tet4, cuboid_wedge6, rectangle_quad4, rectangle_tri3, second_order,
};
use fmc_solid::fem::{Law, Material, Model, Part};

const LAWS: [Law; 2] = [Law::LinearElastic, Law::NeoHookean];

fn material(law: Law) -> Material {
    Material { law, young: 100.0, poisson: 0.3, density: 2.5 }
}

fn part<const D: usize>(cell_type: CellType, mesh: Mesh<D>, law: Law) -> Part<D> {
    Part { name: format!("{cell_type:?}"), cell_type, mesh, material: material(law) }
}

/// Every element type, distorted also at the boundary, where the faces of hexahedra are then not flat; edges of second order are
/// curved, but for those of tetrahedra and wedges.
fn distorted_2d() -> Vec<(CellType, Mesh<2>)> {
    let mut meshes = straight_2d();
    let curved = |cell_type: CellType, straight: &Mesh<2>| (cell_type, curved(straight, cell_type.node_count()));
    let [triangles, quads] = [meshes[0].1.clone(), meshes[1].1.clone()];
    meshes.push(curved(CellType::Tri6, &triangles));
    meshes.push(curved(CellType::Quad8, &quads));
    meshes.push(curved(CellType::Quad9, &quads));
    meshes
}

fn distorted_3d() -> Vec<(CellType, Mesh<3>)> {
    let mut meshes = straight_3d();
    let [tetrahedra, hexahedra, wedges] = [meshes[0].1.clone(), meshes[1].1.clone(), meshes[2].1.clone()];
    meshes.push((CellType::Tet10, second_order(&tetrahedra, 10)));
    meshes.push((CellType::Wedge15, second_order(&wedges, 15)));
    meshes.push((CellType::Hex20, curved(&hexahedra, 20)));
    meshes.push((CellType::Hex27, curved(&hexahedra, 27)));
    meshes
}

/// Those of first order.
fn straight_2d() -> Vec<(CellType, Mesh<2>)> {
    let jittered = |mesh: Mesh<2>| mesh.jittered(0.3, 5, |_| true);
    let (min, max, cells) = ([-1.0, 0.5], [2.0, 2.0], [6, 4]);
    vec![
        (CellType::Tri3, jittered(rectangle_tri3(min, max, cells, Diagonals::Alternating))),
        (CellType::Quad4, jittered(rectangle_quad4(min, max, cells))),
    ]
}

fn straight_3d() -> Vec<(CellType, Mesh<3>)> {
    let jittered = |mesh: Mesh<3>| mesh.jittered(0.3, 6, |_| true);
    let (min, max, cells) = ([-1.0, 0.5, 0.0], [2.0, 2.0, 1.0], [4, 3, 3]);
    vec![
        (CellType::Tet4, jittered(cuboid_tet4(min, max, cells))),
        (CellType::Hex8, jittered(cuboid_hex8(min, max, cells))),
        (CellType::Wedge6, jittered(cuboid_wedge6(min, max, cells))),
    ]
}

/// Cells of second order whose nodes, all of them, lie at random off where the straight cells have them, by up to 2 % of a cell.
fn curved<const D: usize>(straight: &Mesh<D>, nodes_per_cell: usize) -> Mesh<D> {
    let mut mesh = second_order(straight, nodes_per_cell);
    let off = random_field::<D>(mesh.coords.len(), 0.007, 8);
    mesh.coords.iter_mut().zip(off).for_each(|(x, off)| (0..D).for_each(|i| x[i] += off[i]));
    mesh
}

/// Models of one part, for every element type of the dimension and both laws.
fn models<const D: usize>(meshes: Vec<(CellType, Mesh<D>)>) -> Vec<Model<D>> {
    meshes
        .into_iter()
        .flat_map(|(cell_type, mesh)| LAWS.map(|law| Model::new(vec![part(cell_type, mesh.clone(), law)]).unwrap()))
        .collect()
}

fn random_field<const D: usize>(count: usize, size: f64, seed: u64) -> Vec<[f64; D]> {
    let mut random = Splitmix::new(seed);
    (0..count).map(|_| std::array::from_fn(|_| random.between(-size, size))).collect()
}

/// Displacement H x.
fn homogeneous<const D: usize>(model: &Model<D>, h: [[f64; D]; D]) -> Vec<[f64; D]> {
    model.coords().iter().map(|x| h.map(|row| row.iter().zip(x).map(|(h, x)| h * x).sum())).collect()
}

fn largest<const D: usize>(field: &[[f64; D]]) -> f64 {
    field.iter().flatten().fold(0.0, |most, x| x.abs().max(most))
}
