//! Large strains.

use crate::scene::{largest_off, solved};
use fmc_deck::SolveOptions;

/// A cube of W = C10 (J^(−2/3) I₁ − 3) + (J − 1)²/D1 stretched by 2 along z, free at its sides. With the stretch l across,
/// σ_xx = G J^(−5/3) (l² − I₁/3) + K (J − 1) vanishes, and σ_zz = G J^(−5/3) (4 − I₁/3) + K (J − 1).
#[test]
fn rubber_stretches_as_its_energy_has_it() {
    let (shear, bulk) = (2.0 * 0.5, 2.0 / 0.1);
    let stress = |l: f64, own: f64| {
        let (volume, i1) = (2.0 * l * l, 2.0 * l * l + 4.0);
        shear * volume.powf(-5.0 / 3.0) * (own - i1 / 3.0) + bulk * (volume - 1.0)
    };
    let (mut low, mut high) = (0.5, 1.0);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if stress(middle, middle * middle) < 0.0 { low = middle } else { high = middle }
    }
    let outcome = solved::<3>("rubber.inp", SolveOptions::default());
    let along = stress(low, 4.0);
    let off = largest_off(&outcome.stresses, [0.0, 0.0, along, 0.0, 0.0, 0.0]);
    assert!(off < 1e-8, "{off:.2e} of {along}");
    let reaction = outcome.steps[0].sets[0].1[2];
    assert!((reaction - along * low * low).abs() < 1e-8, "{reaction}");
}
