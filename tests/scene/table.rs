//! Laws by estimators: the table that a test of what must always hold goes through, law by law.
//!
//! A new law or estimator is one entry here, and every such test takes it up.

use super::{Scene, exact, fibers, isotropic, lines};
use fmc_contact::{
    EnergyLaw, EnergyProfile, Estimator, FiberOptions, FiberPattern, LineWeights, Options, PenetrationLaw, Resolution,
};

/// Laws for bodies of this size, whose energies are of the order of 1 at the size of 1: the default first, then the global one
/// and local laws.
pub(crate) fn laws(size: f64) -> [EnergyLaw; 4] {
    let [quadratic, linear] = local_laws(size);
    [EnergyLaw::depth(3.0), EnergyLaw::volume(1.0), quadratic, linear]
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

/// Whether forces follow from depths below surfaces, which no estimator measures.
pub(crate) fn is_depth(law: &EnergyLaw) -> bool {
    matches!(law, EnergyLaw::Depth { .. })
}

/// Whether the bodies of a scene have what the law needs: depth is that of cells.
pub(crate) fn suits<const D: usize>(scene: &Scene<D>, options: &Options) -> bool {
    !is_depth(&options.law) || scene.facets.is_empty()
}

/// Whether pressure is the stiffness times a length, so that it has the unit of both.
pub(crate) fn has_pressure_by_length(law: &EnergyLaw) -> bool {
    is_depth(law) || matches!(law, EnergyLaw::Fiber(PenetrationLaw { profile: EnergyProfile::Quadratic, .. }))
}

/// Whether two bodies that change places change no bit. Local laws add up in the order of the sides; so does the law `depth`,
/// whose moments of two pieces are those of the first cut by the second.
pub(crate) fn knows_no_order(law: &EnergyLaw) -> bool {
    matches!(law, EnergyLaw::Volume { .. })
}

/// How much energy and force is taken for none where facets coincide, of bodies of size 1. Clipped facets and lines decide with
/// all digits on which side they lie. The law `depth` cuts pieces of cells by planes with rounded coefficients, and slivers as
/// thin as rounding are left.
pub(crate) fn none_at_a_seam(law: &EnergyLaw) -> f64 {
    if is_depth(law) { 1e-15 } else { 0.0 }
}

/// Whether the estimator takes the law: isotropic fibers have no direction along which a depth could be measured.
fn takes(options: &Options, law: &EnergyLaw) -> bool {
    let is_isotropic =
        matches!(options.estimator, Estimator::Fibers(FiberOptions { pattern: FiberPattern::Isotropic { .. }, .. }));
    !(law.is_fiber() && is_isotropic)
}

/// Every one of these with every law that it takes; first the law `depth`, once, since estimators have no part in it.
pub(crate) fn by_laws(estimators: impl IntoIterator<Item = Options>, laws: &[EnergyLaw]) -> Vec<Options> {
    let (of_depth, measured): (Vec<_>, Vec<_>) = laws.iter().copied().partition(is_depth);
    let of_laws = |options: Options| measured.iter().map(move |&law| Options { law, ..options });
    let measured = estimators.into_iter().flat_map(of_laws).filter(|options| takes(options, &options.law));
    of_depth.into_iter().map(exactly).chain(measured).collect()
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
