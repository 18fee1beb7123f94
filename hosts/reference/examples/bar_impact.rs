//! An elastic bar runs onto a rigid wall: `cargo run --release -p fmc-solid --example bar_impact`.
//!
//! Waves in a bar of length L = 10 with E = 900, ρ = 1, ν = 0: c = √(E/ρ) = 30. At a velocity v = 10 the wall is pressed by
//! ρ c v = 300 from the first touch until the wave has run to the free end and back, 2 L/c; the bar leaves with −v.
//! Checked: the impulse 2 m v within 0.1 %, the pressure within 1 %, the energy within 0.1 %.

use fmc_contact::{CellType, EnergyLaw, EnergyProfile, Estimator, Obstacle, Options, PenetrationLaw, Pose, Shape};
use fmc_shapes::rectangle_quad4;
use fmc_solid::dynamics::{Setup, Simulation, Step};
use fmc_solid::fem::{Constraints, Law, Material, Model, Part};
use std::error::Error;

const LENGTH: f64 = 10.0;
const WIDTH: f64 = 5.0;
const SPEED: f64 = 10.0;
const CELLS: usize = 100;
const MATERIAL: Material = Material { law: Law::LinearElastic, young: 900.0, poisson: 0.0, density: 1.0 };

fn main() -> Result<(), Box<dyn Error>> {
    let wave = MATERIAL.wave_speed();
    let cell = LENGTH / CELLS as f64;

    // 1. The bar, a little above the wall, moving down; its sides slide, so that it is one-dimensional.
    let mesh = rectangle_quad4([0.0, 0.1], [WIDTH, 0.1 + LENGTH], [1, CELLS]);
    let bar = Part { name: "bar".into(), cell_type: CellType::Quad4, mesh, material: MATERIAL };
    let model = Model::new(vec![bar])?;
    let mut supports = Constraints::default();
    supports.prescribe(0..model.node_count(), 0, 0.0);
    let velocity = vec![[0.0, -SPEED]; model.node_count()];

    // 2. The contact: pressure = k × penetration. Stiffer than a spring of a few cells, it would only ring.
    let law =
        EnergyLaw::Fiber(PenetrationLaw { stiffness: 0.4 * MATERIAL.young / cell, profile: EnergyProfile::Quadratic });
    let contact = Options { estimator: Estimator::Exact, ..Options::new(law) };
    let wall = Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0; 2]) };

    // 3. Half of the time in which a wave crosses a cell.
    let step = 0.5 * cell / wave;
    let setup =
        Setup { supports, velocity, obstacles: vec![wall], step: Step::Fixed(step), ..Setup::new(model, contact) };
    let mut simulation = Simulation::start(setup)?;

    // 4. Through the impact and a little further.
    let start = simulation.sample().total;
    let (mut impulse, mut touching, mut drift) = (0.0, 0.0, 0.0f64);
    while simulation.time() < 1.2 * 2.0 * LENGTH / wave {
        let sample = simulation.advance()?;
        let force = sample.bodies[0][1];
        impulse += force * step;
        touching += if force > 0.0 { step } else { 0.0 };
        drift = drift.max((sample.total / start - 1.0).abs());
    }

    // 5. The check.
    let (mass, area) = (MATERIAL.density * LENGTH * WIDTH, WIDTH);
    let pressure = impulse / touching / area;
    println!("impulse {impulse:.3}, 2 m v = {:.3}", 2.0 * mass * SPEED);
    println!("mean pressure {pressure:.3}, ρ c v = {:.3}", MATERIAL.density * wave * SPEED);
    println!("largest change of the energy {:.2e}", drift);
    let is_met = (impulse / (2.0 * mass * SPEED) - 1.0).abs() < 1e-3
        && (pressure / (MATERIAL.density * wave * SPEED) - 1.0).abs() < 0.01
        && drift < 1e-3;
    if is_met { Ok(()) } else { Err("the closed form is missed".into()) }
}
