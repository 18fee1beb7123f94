//! A block that slides on a floor until friction has stopped it.

use crate::scene::{depth, part};
use fmc_contact::contact::Friction;
use fmc_contact::{CellType, EnergyLaw, Estimator, Obstacle, Options, Pose, Shape};
use fmc_shapes::rectangle_quad4;
use fmc_solid::dynamics::{Setup, Simulation};
use fmc_solid::fem::{Law, Material, Model};

const MU: f64 = 0.3;
const G: f64 = 9.81;
const DENSITY: f64 = 1000.0;
const K: f64 = 4e7;
const SIZE: [f64; 2] = [0.2, 0.1];

/// 0.2 by 0.1 m, k = E/h, 1 m/s; as deep in the floor as its weight presses it.
fn sliding(contact: Options) -> Setup<2> {
    let sunk = DENSITY * G * SIZE[1] / K;
    let mesh = rectangle_quad4([0.0, -sunk], [SIZE[0], SIZE[1] - sunk], [8, 4]);
    let material = Material { law: Law::LinearElastic, young: 1e6, poisson: 0.3, density: DENSITY };
    let model = Model::new(vec![part("block", CellType::Quad4, mesh, material)]).unwrap();
    let load = model.body_load(0, [0.0, -DENSITY * G]);
    let velocity = vec![[1.0, 0.0]; model.node_count()];
    let contact = Options { friction: Friction::coulomb(MU), ..contact };
    let floor = Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0; 2]) };
    Setup { load, velocity, obstacles: vec![floor], ..Setup::new(model, contact) }
}

#[test]
fn a_block_stops_where_its_energy_is_spent() {
    let fiber = Options { estimator: Estimator::Exact, ..Options::new(EnergyLaw::fiber(K)) };
    for options in [depth(K), fiber] {
        let mut simulation = Simulation::start(sliding(options)).unwrap();
        let start = simulation.sample();
        let (mass, weight) = (simulation.part_mass(0), simulation.part_mass(0) * G);
        let mean = |simulation: &Simulation<2>| {
            let moments = simulation.mass().iter().zip(&simulation.state().displacement).map(|(m, u)| m * u[0]);
            moments.sum::<f64>() / mass
        };
        let (mut dissipated, mut lost, mut farthest) = (0.0, 0.0f64, 0.0f64);
        let stop = 1.0 / (MU * G);
        while simulation.time() < 1.2 * stop {
            let sample = simulation.advance().unwrap();
            assert!(sample.dissipated >= dissipated, "friction gave energy at step {}", sample.step);
            dissipated = sample.dissipated;
            lost = lost.max((sample.total + dissipated - start.total).abs() / start.kinetic);
            farthest = farthest.max(mean(&simulation));
        }
        let (way, end) = (mean(&simulation), simulation.sample());
        let expected = 0.5 / (MU * G);
        println!(
            "{} steps: way {:.5}, farthest {:.5}, unaccounted {lost:.1e}, dissipated {:.5}, velocity {:?}, N/W {:?}",
            end.step,
            way / expected,
            farthest / expected,
            dissipated / start.kinetic,
            end.velocities[0],
            end.bodies[0][1] / weight
        );
        assert!((way / expected - 1.0).abs() < 0.01, "{way} by {expected}");
        assert!(lost < 0.01, "{lost} of the energy is not accounted for");
        assert!((dissipated / start.kinetic - 1.0).abs() < 0.01);
        // At rest but for the ringing of the block and its stick.
        assert!(end.velocities[0][0].abs() < 0.01);
    }
}
