//! What cannot be simulated says so.

use crate::scene::{exact, material, part, tip_on_block};
use fmc_contact::CellType;
use fmc_shapes::{rectangle_quad4, second_order};
use fmc_solid::dynamics::{DynamicsError, Setup, Simulation, Step};
use fmc_solid::fem::{Law, Model};

fn refusal(setup: Setup<2>) -> DynamicsError {
    Simulation::start(setup).err().expect("not refused")
}

#[test]
fn bad_values_are_refused() {
    let setup = || tip_on_block(exact(1e6, 2.0), Step::Auto);
    let found = setup().model.node_count();
    let short = Setup { velocity: vec![[0.0; 2]; 3], ..setup() };
    assert_eq!(refusal(short), DynamicsError::Length { array: "velocity", expected: found, found: 3 });
    let nan = Setup { load: vec![[f64::NAN; 2]; found], ..setup() };
    assert!(matches!(refusal(nan), DynamicsError::Value { name: "load", .. }));
    for step in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let bad = Setup { step: Step::Fixed(step), ..setup() };
        assert!(matches!(refusal(bad), DynamicsError::Value { name: "step", .. }));
    }
    assert!(matches!(refusal(Setup { damping: -1.0, ..setup() }), DynamicsError::Value { name: "damping", .. }));
    let mut held = setup();
    held.supports.fix([found]);
    assert_eq!(refusal(held), DynamicsError::Support { node: found });
    let curved = part(
        "square",
        CellType::Quad9,
        second_order(&rectangle_quad4([0.0; 2], [1.0; 2], [2, 2]), 9),
        material(Law::NeoHookean, 0.3),
    );
    let curved = Setup::new(Model::new(vec![curved]).unwrap(), exact(1.0, 1.0));
    assert_eq!(refusal(curved), DynamicsError::SecondOrder { part: "square".into() });
}

#[test]
fn inverted_cells_stop_the_run_and_leave_it_as_it_was() {
    let mesh = rectangle_quad4([0.0; 2], [1.0, 1.0], [2, 2]);
    let model = Model::new(vec![part("square", CellType::Quad4, mesh, material(Law::NeoHookean, 0.3))]).unwrap();
    // The halves run into each other far above the speed of sound.
    let velocity = model.coords().iter().map(|x| [1e4 * (0.5 - x[0]), 0.0]).collect();
    let mut simulation = Simulation::start(Setup { velocity, ..Setup::new(model, exact(1.0, 1.0)) }).unwrap();
    let error = loop {
        let before = simulation.state().clone();
        if let Err(error) = simulation.advance() {
            assert_eq!(simulation.state(), &before);
            break error;
        }
    };
    assert!(matches!(error, DynamicsError::InvertedCell { .. }), "{error}");
}
