//! A half-disc pressed on a rigid plane: `cargo run --release -p fmc-solid --example disc_at_rest`.
//!
//! Hertz' line contact. Radius R = 8, E = 200, ν = 0.3, a load of F = 10 per length:
//! half width a = √(4 F R (1 − ν²)/(π E)) = 0.6808, greatest pressure p0 = 2 F/(π a) = 9.351.
//! Checked: the contact carries F, and p0 is met within 1 %.

use fmc_contact::{CellType, EnergyLaw, EnergyProfile, Estimator, Obstacle, Options, PenetrationLaw, Pose, Shape};
use fmc_shapes::graded_half_disc_tri3;
use fmc_solid::fem::{Constraints, Law, Material, Model, Part};
use fmc_solid::statics::{Equilibrium, Path, Problem, nodal_pressures};
use std::error::Error;
use std::f64::consts::PI;
use std::ops::ControlFlow;

const RADIUS: f64 = 8.0;
const FORCE: f64 = 10.0;
const STEEL: Material = Material { law: Law::LinearElastic, young: 200.0, poisson: 0.3, density: 1.0 };

fn main() -> Result<(), Box<dyn Error>> {
    let half_width = (4.0 * FORCE * RADIUS * (1.0 - STEEL.poisson * STEEL.poisson) / (PI * STEEL.young)).sqrt();
    let peak = 2.0 * FORCE / (PI * half_width);

    // 1. The body: a mesh, finest where it will touch, and its material.
    let mesh = graded_half_disc_tri3(RADIUS, half_width / 8.0, 1.5 * half_width, 0.15);
    let disc = Part { name: "disc".into(), cell_type: CellType::Tri3, mesh, material: STEEL };
    let model = Model::new(vec![disc])?;

    // 2. What holds and drives it: symmetry on its axis, a pressure on its flat side.
    let mut supports = Constraints::default();
    supports.prescribe(model.nodes_where(0, |x| x[0].abs() < 1e-9), 0, 0.0);
    let flat = model.faces_where(0, |x| x[1] > RADIUS - 1e-9);
    let load = model.surface_load(&flat, |_, _| [0.0, -FORCE / (2.0 * RADIUS)]);

    // 3. How it touches: pressure = k × penetration, measured exactly; the plane y ≤ 0.
    let law = EnergyLaw::Fiber(PenetrationLaw { stiffness: 2e5, profile: EnergyProfile::Quadratic });
    let contact = Options { estimator: Estimator::Exact, ..Options::new(law) };
    let plane = Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0; 2]) };
    let problem = Problem { supports, load, obstacles: vec![plane], ..Problem::new(model, contact) };

    // 4. Equilibrium, and the iterations as they come.
    let mut equilibrium = Equilibrium::new(problem)?;
    equilibrium.follow(Path::default(), &mut |iteration| {
        println!("{iteration}");
        ControlFlow::Continue(())
    })?;

    // 5. The check.
    let forces = &equilibrium.balance().contact;
    let pressures = nodal_pressures(equilibrium.model(), 0, &forces.forces);
    let found = pressures.iter().map(|node| node.pressure).fold(0.0, f64::max);
    println!("force {:.6}, load {FORCE}", forces.bodies[0].force[1]);
    println!("greatest pressure {found:.4}, Hertz {peak:.4}");
    let is_met = (forces.bodies[0].force[1] - FORCE).abs() < 1e-8 * FORCE && (found / peak - 1.0).abs() < 0.01;
    if is_met { Ok(()) } else { Err("the closed form is missed".into()) }
}
