//! Masses and loads.

use crate::{models, part, straight_2d, straight_3d};
use fmc_contact::CellType;
use fmc_shapes::{cuboid_hex8, cuboid_tet4, rectangle_quad4};
use fmc_solid::fem::{Law, Model};

fn masses_add_up<const D: usize>(models: Vec<Model<D>>) {
    for model in models {
        let mass = model.lumped_mass();
        let total = 2.5 * model.parts()[0].mesh.measure();
        assert!((mass.iter().sum::<f64>() - total).abs() < 1e-13 * total);
        assert!(mass.iter().all(|&mass| mass > 0.0));
        let weight = model.body_load(0, std::array::from_fn(|i| i as f64 - 3.0));
        for (mass, load) in mass.iter().zip(&weight) {
            (0..D).for_each(|i| assert!((load[i] - mass / 2.5 * (i as f64 - 3.0)).abs() < 1e-15));
        }
    }
}

#[test]
fn masses_and_weights_add_up() {
    masses_add_up(models(straight_2d()));
    masses_add_up(models(straight_3d()));
}

/// A regular mesh has a quarter, or an eighth, of a cell's mass at every corner of it.
#[test]
fn cells_share_their_mass_evenly() {
    let model =
        Model::new(vec![part(CellType::Hex8, cuboid_hex8([0.0; 3], [2.0; 3], [2; 3]), Law::NeoHookean)]).unwrap();
    let mass = model.lumped_mass();
    assert!((mass[0] - 2.5 / 8.0).abs() < 1e-15 && (mass[13] - 2.5).abs() < 1e-14);
}

/// A pressure that grows with depth on one side of a box: resultant and moment as by hand, in triangles and in
/// rectangles. p = 1 + 2z on the unit square x = 1: F = 2, moment about z = 0 is ∫ z p = 1/2 + 2/3.
#[test]
fn linear_pressure_has_its_resultant_and_moment() {
    let box_of = |cell_type, mesh| Model::new(vec![part(cell_type, mesh, Law::LinearElastic)]).unwrap();
    for model in [
        box_of(CellType::Tet4, cuboid_tet4([0.0; 3], [1.0; 3], [2, 3, 4])),
        box_of(CellType::Hex8, cuboid_hex8([0.0; 3], [1.0; 3], [2, 3, 4])),
    ] {
        let side = model.faces_where(0, |x| x[0] == 1.0);
        assert_eq!(side.len(), if model.parts()[0].cell_type == CellType::Tet4 { 24 } else { 12 });
        let load = model.surface_load(&side, |x, n| n.map(|n| -(1.0 + 2.0 * x[2]) * n));
        let sum =
            |f: fn(&[f64; 3], &[f64; 3]) -> f64| load.iter().zip(model.coords()).map(|(l, x)| f(l, x)).sum::<f64>();
        assert!((sum(|l, _| l[0]) + 2.0).abs() < 1e-14);
        assert!((sum(|l, x| l[0] * x[2]) + 0.5 + 2.0 / 3.0).abs() < 1e-14);
        assert!(sum(|l, _| l[1].abs() + l[2].abs()) == 0.0);
    }
    // The same in the plane: p = 1 + 2y on the side x = 0, whose outward normal is −x.
    let model = box_of_quads();
    let load = model.surface_load(&model.faces_where(0, |x| x[0] == 0.0), |x, n| n.map(|n| -(1.0 + 2.0 * x[1]) * n));
    assert!((load.iter().map(|l| l[0]).sum::<f64>() - 2.0).abs() < 1e-14);
    let moment: f64 = load.iter().zip(model.coords()).map(|(l, x)| l[0] * x[1]).sum();
    assert!((moment - 0.5 - 2.0 / 3.0).abs() < 1e-14);
}

fn box_of_quads() -> Model<2> {
    Model::new(vec![part(CellType::Quad4, rectangle_quad4([0.0; 2], [1.0; 2], [3, 5]), Law::NeoHookean)]).unwrap()
}

#[test]
fn parts_follow_one_another() {
    let square = rectangle_quad4([0.0; 2], [1.0; 2], [2, 2]);
    let parts = vec![
        part(CellType::Tri3, square.clone().triangulated(), Law::LinearElastic),
        part(CellType::Quad4, square.translated([3.0, 0.0]), Law::NeoHookean),
    ];
    let model = Model::new(parts).unwrap();
    assert_eq!((model.node_count(), model.cell_count()), (18, 12));
    assert_eq!((model.nodes_of(0), model.nodes_of(1)), (0..9, 9..18));
    assert_eq!(model.nodes_where(1, |x| x[0] == 4.0 && x[1] == 0.5), [14]);
    assert!(model.faces_where(1, |x| x[1] == 0.0).iter().flat_map(|face| &face.nodes).all(|&node| node >= 9));
    let surface = model.surface().unwrap();
    assert_eq!(surface.body_ids(), [0, 1]);
    assert_eq!(surface.facet_count(), 16);
}
