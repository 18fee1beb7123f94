//! Small bodies in motion.

use fmc_contact::{CellType, EnergyLaw, Estimator, Options};
use fmc_shapes::{Mesh, rectangle_quad4};
use fmc_solid::dynamics::{Sample, Setup, Simulation, Step};
use fmc_solid::fem::{Law, Material, Model, Part};

/// E = 1000, ρ = 1.
pub(crate) fn material(law: Law, poisson: f64) -> Material {
    Material { law, young: 1000.0, poisson, density: 1.0 }
}

pub(crate) fn part<const D: usize>(name: &str, cell_type: CellType, mesh: Mesh<D>, material: Material) -> Part<D> {
    Part { name: name.into(), cell_type, mesh, material }
}

/// w = k Vᵐ, exact.
pub(crate) fn exact(k: f64, m: f64) -> Options {
    Options { estimator: Estimator::Exact, ..Options::new(EnergyLaw::Volume { stiffness: k, exponent: m }) }
}

/// w = k/2 ∫ (g_A + g_B) dx, exact.
pub(crate) fn depth(k: f64) -> Options {
    Options { estimator: Estimator::Exact, ..Options::new(EnergyLaw::depth(k)) }
}

/// A square on its tip, its velocity (0.3, −3), above a block that is free to move; neo-Hookean. They are 0.01 apart and
/// the tip stands beside a node of the block.
pub(crate) fn tip_on_block(contact: Options, step: Step) -> Setup<2> {
    let rubber = material(Law::NeoHookean, 0.3);
    let block = rectangle_quad4([-1.0, -0.6], [1.0, 0.0], [10, 4]);
    let tip = rectangle_quad4([0.0; 2], [0.6, 0.6], [4, 4]);
    let tip = tip.rotated(std::f64::consts::FRAC_PI_4 + 0.03).translated([0.07, 0.01]);
    let parts = vec![part("block", CellType::Quad4, block, rubber), part("tip", CellType::Quad4, tip, rubber)];
    let model = Model::new(parts).unwrap();
    let mut velocity = vec![[0.0; 2]; model.node_count()];
    model.nodes_of(1).for_each(|node| velocity[node] = [0.3, -3.0]);
    Setup { velocity, step, ..Setup::new(model, contact) }
}

/// Makes `count` steps.
pub(crate) fn run<const D: usize>(simulation: &mut Simulation<D>, count: usize) -> Vec<Sample<D>> {
    (0..count).map(|_| simulation.advance().unwrap()).collect()
}
