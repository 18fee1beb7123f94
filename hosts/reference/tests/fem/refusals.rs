//! What a model does not accept, and says why.

use crate::part;
use fmc_contact::CellType;
use fmc_shapes::rectangle_quad4;
use fmc_solid::fem::{Error, Law, Model, Part};

fn square() -> Part<2> {
    part(CellType::Quad4, rectangle_quad4([0.0; 2], [1.0; 2], [2, 2]), Law::NeoHookean)
}

fn refusal(change: impl Fn(&mut Part<2>)) -> Error {
    let mut square = square();
    change(&mut square);
    Model::new(vec![square]).unwrap_err()
}

#[test]
fn faults_are_named() {
    assert_eq!(Model::<2>::new(Vec::new()).unwrap_err(), Error::Empty);
    assert_eq!(refusal(|part| part.mesh.conn.clear()), Error::Empty);
    assert!(matches!(refusal(|part| part.cell_type = CellType::Tet4), Error::CellType { dimension: 2, .. }));
    let pyramid = Error::NoElement { part: "Quad4".into(), cell_type: CellType::Pyramid5 };
    assert_eq!(refusal(|part| part.cell_type = CellType::Pyramid5), pyramid);
    assert!(matches!(refusal(|part| part.cell_type = CellType::Tri3), Error::CellType { nodes_per_cell: 4, .. }));
    assert!(matches!(
        refusal(|part| part.mesh.conn[5] = 9),
        Error::NodeOutOfRange { cell: 1, node: 9, node_count: 9, .. }
    ));
    assert!(matches!(refusal(|part| part.mesh.coords.push([2.0; 2])), Error::UnusedNode { node: 9, .. }));
    assert!(matches!(refusal(|part| part.mesh.coords[3][1] = f64::NAN), Error::NonFiniteCoordinate { node: 3, .. }));
    assert!(matches!(refusal(|part| part.mesh.coords[4] = [1.5, 1.5]), Error::InvertedCell { .. }));
    assert!(matches!(refusal(|part| part.material.poisson = 0.5), Error::Material { value: 0.5, .. }));
    assert!(matches!(refusal(|part| part.material.young = 0.0), Error::Material { name: "Young's modulus", .. }));
    assert!(matches!(refusal(|part| part.material.density = f64::NAN), Error::Material { name: "density", .. }));
    let message = refusal(|part| part.material.density = -1.0).to_string();
    assert_eq!(message, "Quad4: density = -1 is not positive");
    let threads = Model::new(vec![square()]).unwrap().with_threads(0).unwrap_err();
    assert_eq!(threads, Error::Threads { threads: 0 });
}

#[test]
fn inverted_elements_have_infinite_energy() {
    let model = Model::new(vec![square()]).unwrap();
    let mut displacement = vec![[0.0; 2]; 9];
    displacement[4] = [0.9, 0.9];
    assert_eq!(model.internal(&displacement, &mut [[0.0; 2]; 9]), f64::INFINITY);
}
