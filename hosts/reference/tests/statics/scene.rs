//! Problems with an answer.

use fmc_contact::{CellType, EnergyLaw, Estimator, FiberOptions, Obstacle, Options, Pose, Resolution, Shape};
use fmc_shapes::{Mesh, graded_half_disc_tri3};
use fmc_solid::fem::{Constraints, Law, Material, Model, Part};
use fmc_solid::statics::{Equilibrium, Iteration, Problem};
use std::ops::ControlFlow;

pub(crate) fn material(young: f64) -> Material {
    Material { law: Law::LinearElastic, young, poisson: 0.3, density: 1.0 }
}

pub(crate) fn exact(law: EnergyLaw) -> Options {
    Options { estimator: Estimator::Exact, ..Options::new(law) }
}

pub(crate) fn lines(law: EnergyLaw, spacing: f64) -> Options {
    let fibers = FiberOptions { resolution: Resolution::Spacing(spacing), ..Default::default() };
    Options { estimator: Estimator::Fibers(fibers), ..Options::new(law) }
}

pub(crate) fn part<const D: usize>(name: &str, cell_type: CellType, mesh: Mesh<D>) -> Part<D> {
    Part { name: name.into(), cell_type, mesh, material: material(200.0) }
}

/// Half-disc of radius 8 on a rigid plane, pressed by 0.625 on its flat side: F = 10, a = 0.6808, p0 = 9.351.
pub(crate) const HALF_WIDTH: f64 = 0.680_83;
pub(crate) const PEAK: f64 = 9.3506;

pub(crate) fn hertz(parts: f64, contact: Options) -> Problem<2> {
    hertz_of(Law::LinearElastic, parts, contact)
}

pub(crate) fn hertz_of(law: Law, parts: f64, contact: Options) -> Problem<2> {
    let mesh = graded_half_disc_tri3(8.0, HALF_WIDTH / parts, 1.5 * HALF_WIDTH, 0.15);
    let mut disc = part("disc", CellType::Tri3, mesh);
    disc.material.law = law;
    let model = Model::new(vec![disc]).unwrap();
    let mut supports = Constraints::default();
    supports.prescribe(model.nodes_where(0, |x| x[0].abs() < 1e-9), 0, 0.0);
    let load = model.surface_load(&model.faces_where(0, |x| x[1] > 8.0 - 1e-9), |_, _| [0.0, -0.625]);
    let plane = Obstacle { shape: Shape::HalfSpace, pose: Pose::at([0.0; 2]) };
    Problem { supports, load, obstacles: vec![plane], ..Problem::new(model, contact) }
}

/// Writes down all iterations.
pub(crate) fn recorder(log: &mut Vec<Iteration>) -> impl FnMut(&Iteration) -> ControlFlow<()> + '_ {
    |iteration| {
        println!("{iteration}");
        log.push(*iteration);
        ControlFlow::Continue(())
    }
}

pub(crate) fn solved<const D: usize>(problem: Problem<D>) -> (Equilibrium<D>, Vec<Iteration>) {
    let mut equilibrium = Equilibrium::new(problem).unwrap();
    let mut log = Vec::new();
    equilibrium.follow(Default::default(), &mut recorder(&mut log)).unwrap();
    (equilibrium, log)
}
