//! Blocks whose meshes do not match, in contact and tied: the stress is uniform.

use crate::scene::{largest_off, solved};
use fmc_deck::SolveOptions;

/// Under a pressure p of 10 in plane strain σ_yy = −p, σ_zz = −ν p, and nothing else. At the ends of the face the side walls are as near as
/// the face, and the pressure falls within a depth δ = p/k of 5e-4: the stress is off by a part of this size. Multipliers take some away.
#[test]
fn a_pressure_goes_through_two_blocks() {
    let expected = [0.0, -10.0, -3.0, 0.0, 0.0, 0.0];
    for (penetration, bound) in [(0.0, 5e-3), (1e-12, 5e-4)] {
        let outcome = solved::<2>("patch.inp", SolveOptions { penetration, ..SolveOptions::default() });
        let off = largest_off(&outcome.stresses, expected);
        println!("{penetration:e} {off:.2e}");
        assert!(off < bound, "{penetration:e}: {off:.2e}");
        let step = &outcome.steps[0];
        assert!((step.reaction[1] - 10.0).abs() < 1e-8 && (step.load[1] + 10.0).abs() < 1e-12);
        assert!((step.pairs[0].force[1] - 10.0).abs() < 1e-8 && step.pairs[0].names == ["LOWER", "UPPER"]);
        // Two blocks of height 1: the top goes down by 2 p (1 − ν²)/E, and by the penetration.
        let down = outcome.displacement.iter().map(|u| u[1]).fold(0.0, f64::min);
        assert!((down + 2.0 * 10.0 * 0.91 / 1000.0).abs() < 1e-4, "{down}");
    }
}

/// By a linear overclosure of slope k the blocks penetrate by p/k: the top goes down by as much more, but for what the ends lack.
#[test]
fn a_linear_overclosure_keeps_its_penetration() {
    let text = std::fs::read_to_string(crate::scene::path("patch.inp")).unwrap();
    let behaviour = "NAME=PRESS\n*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR\n2e4";
    let file = std::env::temp_dir().join(format!("fmc-deck-linear-{}.inp", std::process::id()));
    std::fs::write(&file, text.replacen("NAME=PRESS", behaviour, 1)).unwrap();
    let outcome = solved::<2>(file.to_str().unwrap(), SolveOptions::default());
    let down = outcome.displacement.iter().map(|u| u[1]).fold(0.0, f64::min);
    assert!((down + 0.0182 + 10.0 / 2e4).abs() < 1e-5, "{down}");
    std::fs::remove_file(file).unwrap();
}

/// Tied blocks of hexahedra that are pulled by 10; a multiple of the residual.
#[test]
fn a_pull_goes_through_tied_blocks() {
    let outcome = solved::<3>("tied.inp", SolveOptions::default());
    let off = largest_off(&outcome.stresses, [0.0, 0.0, 10.0, 0.0, 0.0, 0.0]);
    assert!(off < 1e-9, "{off:.2e}");
    assert!(outcome.steps[0].pairs[0].is_tied);
}

/// Three instances of two parts, by the names of the instances, along an amplitude that ends at 1.
#[test]
fn a_pull_goes_through_tied_instances() {
    let outcome = solved::<3>("parts.inp", SolveOptions::default());
    let off = largest_off(&outcome.stresses, [0.0, 0.0, 10.0, 0.0, 0.0, 0.0]);
    assert!(off < 1e-9, "{off:.2e}");
    let names: Vec<_> = outcome.steps[0].bodies.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, ["Low-1", "Mid-1", "Top-1"]);
}

#[test]
fn threads_change_no_bit() {
    let of = |threads| solved::<3>("tied.inp", SolveOptions { threads, ..SolveOptions::default() }).displacement;
    assert_eq!(of(1), of(3));
}
