//! Laws by estimators: the table that a test of what must always hold goes through, law by law.
//!
//! A new law or estimator is one entry here, and every such test takes it up.

use super::{Scene, exact, fibers, isotropic, lines};
use fmc_contact::{
    EnergyLaw, EnergyProfile, Estimator, FiberOptions, FiberPattern, LineWeights, Options, PenetrationLaw, Resolution,
};

/// Laws for bodies of this size, whose energies are of the order of 1 at the size of 1: local laws beside the global one.
pub(crate) fn laws(size: f64) -> [EnergyLaw; 3] {
    let [quadratic, linear] = local_laws(size);
    [EnergyLaw::volume(1.0), quadratic, linear]
}

/// Those whose energy is a sum over lines, each by its own length.
pub(crate) fn local_laws(size: f64) -> [EnergyLaw; 2] {
    [
        EnergyLaw::fiber(3.0),
        EnergyLaw::Fiber(PenetrationLaw {
            stiffness: 2.0,
            profile: EnergyProfile::Linear { smoothing_length: 0.05 * size },
        }),
    ]
}

/// Whether the estimator takes the law: isotropic fibers have no direction along which a depth could be measured.
fn takes(options: &Options, law: &EnergyLaw) -> bool {
    let is_isotropic =
        matches!(options.estimator, Estimator::Fibers(FiberOptions { pattern: FiberPattern::Isotropic { .. }, .. }));
    !(law.is_fiber() && is_isotropic)
}

/// Every one of these with every law that it takes.
pub(crate) fn by_laws(estimators: impl IntoIterator<Item = Options>, laws: &[EnergyLaw]) -> Vec<Options> {
    let of_laws = |options: Options| laws.iter().map(move |&law| Options { law, ..options });
    estimators.into_iter().flat_map(of_laws).filter(|options| takes(options, &options.law)).collect()
}

/// Every estimator: the exact one, the default lines, lines that are given, and isotropic segments.
pub(crate) fn estimators(size: f64) -> Vec<Options> {
    vec![exact(), fibers(FiberOptions::default()), lines(0.04 * size, 3), isotropic(0.3 * size, 2_000, 4)]
}

/// All of it, for bodies of this size.
pub(crate) fn table(size: f64) -> Vec<Options> {
    by_laws(estimators(size), &laws(size))
}

/// Lines that stay where they are, one weight a line and no correction: the estimate whose derivatives are exact, for any
/// law.
pub(crate) fn uncorrected(law: EnergyLaw, spacing: f64, seed: u64) -> Options {
    let lines = FiberOptions {
        // A local law has one family a patch, and nothing to weigh.
        weights: if law.is_fiber() { LineWeights::default() } else { LineWeights::Consistent },
        resolution: Resolution::Spacing(spacing),
        seed,
        momentum_correction: false,
        ..FiberOptions::default()
    };
    Options { law, ..fibers(lines) }
}

/// The exact estimate under a law.
pub(crate) fn exactly(law: EnergyLaw) -> Options {
    Options { law, ..exact() }
}

/// Whether an estimate is a sum over pieces whose number follows from the bodies alone: exact integration of what is no
/// polynomial takes it at points, by triangles into which pieces fall as their corners are numbered.
pub(crate) fn is_quadrature(options: &Options) -> bool {
    let is_polynomial =
        !matches!(options.law, EnergyLaw::Fiber(PenetrationLaw { profile: EnergyProfile::Linear { .. }, .. }));
    options.estimator == Estimator::Exact && !is_polynomial
}

/// Whether the pair of a scene has one patch under this law, so that no border between two runs through its contact.
pub(crate) fn is_one_patch<const D: usize>(scene: &Scene<D>, options: Options) -> bool {
    !options.law.is_fiber() || scene.contact(options).keep_patches(&scene.coords).unwrap() == 1
}

/// Estimates with exact derivatives, by local laws: exact integration is one of polynomials only, and takes others at
/// points, whose sum has another slope than its force says.
pub(crate) fn differentiable(laws: &[EnergyLaw], spacing: f64, seed: u64) -> Vec<Options> {
    let exact = laws.iter().map(|&law| exactly(law)).filter(|options| !is_quadrature(options));
    exact.chain(laws.iter().map(|&law| uncorrected(law, spacing, seed))).collect()
}
