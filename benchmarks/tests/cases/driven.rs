//! Bodies that their supports drive into others: every check of their files holds.

use super::{Folder, document};
use fmc_benchmarks::run::{Ending, RunOptions, Summary, run_at_rest};
use std::ops::ControlFlow;

pub(super) fn run(case: &str, variant: Option<&str>) -> Summary {
    let folder = Folder::new(&format!("{case}-{}", variant.unwrap_or("itself")));
    let mut document = document(case, &["output.frames=0"]);
    variant.into_iter().for_each(|variant| document.choose(variant).unwrap());
    let options = RunOptions { out: folder.0.clone(), threads: 1, resume: false };
    let ending = run_at_rest(&document, &document.case().unwrap(), &options, &mut |_| ControlFlow::Continue(()));
    let Ok(Ending::Finished(summary)) = ending else { panic!("{case} {variant:?}: {:?}", ending.err()) };
    assert!(summary.is_ok(), "{case} {variant:?}: {:#?}", summary.checks);
    *summary
}

/// One cell deep, by soft contact; hard, the fiber law gives the same.
#[test]
fn a_corner_is_pressed_in_by_one_cell() {
    let soft = run("corner", None);
    assert_eq!(soft.checks.len(), 2);
    // The block's cells are 0.15 wide.
    assert!((soft.figure("penetration_max").unwrap() / 0.15 - 1.0).abs() < 0.1);
    let [depth, fiber] =
        ["hard", "hard-fiber"].map(|variant| run("corner", Some(variant)).figure("force_peak").unwrap());
    assert!((fiber / depth - 1.0).abs() < 0.02, "{depth} and {fiber}");
}

/// Over the ledge and back, with both laws. The hook ends where it began, so that the work over the loop is what was lost.
#[test]
fn a_hook_snaps_in_and_out_without_losing_energy() {
    let [depth, fiber] = [None, Some("fiber")].map(|variant| run("snap", variant));
    assert_eq!((depth.checks.len(), fiber.checks.len()), (4, 3));
    for name in ["force_peak", "force_least", "work_peak"] {
        let [depth, fiber] = [&depth, &fiber].map(|summary| summary.figure(name).unwrap());
        assert!((fiber / depth - 1.0).abs() < 0.02, "{name}: {depth} and {fiber}");
    }
    // Trapezoids on the same places there and back cancel; what is left is forces balanced to 1e-8.
    assert!(depth.figure("loop_error").unwrap() < 1e-5);
}

/// Edge over edge, where the slope jumps.
#[test]
fn a_hook_passes_sharp_edges() {
    assert_eq!(run("snap", Some("sharp")).checks.len(), 2);
}
