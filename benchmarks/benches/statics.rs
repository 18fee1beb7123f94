//! An equilibrium with contact beside one sparse factorisation of the bodies' stiffness, in one run on one thread.
//!
//! `cargo bench -p fmc-benchmarks --bench statics` prints a table; `-- hertz3d` or `cone` prints a part. What was measured is left in
//! out/bench/statics.json for the pages.

mod kept;

use fmc_benchmarks::case::{Case, Document};
use fmc_benchmarks::run::solve;
use fmc_contact::sparse::{Factorisation, Lower};
use fmc_solid::statics::Equilibrium;
use kept::keep;
use serde_json::json;
use std::ops::ControlFlow;
use std::time::Instant;

/// Cases with changes that make them large; by how much, as a name.
const PROBLEMS: [(&str, &str, &[&str]); 4] = [
    ("hertz3d", "34 816 Tet4", &[]),
    ("hertz3d", "128 448 Tet4", &["bodies.ball.mesh.edges=24", "bodies.ball.mesh.finest=6.4e-4"]),
    ("cone", "84 280 Tet4", &["bodies.block.mesh.cells=14", "bodies.block.mesh.shells=24"]),
    (
        "cone",
        "179 820 Tet4, pressed by 0.05",
        &["bodies.block.mesh.cells=18", "bodies.block.mesh.shells=31", "supports.2.values=[0.0, 0.0, 0.05]"],
    ),
];

fn changed(name: &str, changes: &[&str]) -> (Document, Case) {
    let mut document = Document::open(name).expect("a case");
    changes.iter().for_each(|change| document.override_with("--override", change).expect("a key of the case"));
    let case = document.case().expect("a valid case");
    (document, case)
}

/// Seconds of one factorisation of the bodies' stiffness under their supports, nested dissection included.
fn factorisation(equilibrium: &Equilibrium<3>) -> f64 {
    let problem = equilibrium.problem();
    let matrix = problem.model.tangent(equilibrium.displacement());
    let is_held = |freedom: usize| problem.supports.contains(freedom / 3, freedom % 3);
    let mut equations = vec![usize::MAX; matrix.size];
    let free: Vec<usize> = (0..matrix.size).filter(|freedom| !is_held(*freedom)).collect();
    free.iter().enumerate().for_each(|(equation, &freedom)| equations[freedom] = equation);
    let entries = matrix.iter().map(|(row, column, value)| (equations[row], equations[column], value));
    let lower = Lower::new(free.len(), entries.filter(|(row, column, _)| row.max(column) != &usize::MAX));
    let coords = equilibrium.coords();
    let mut factors = Factorisation::new(free.iter().map(|freedom| coords[freedom / 3]).collect());
    let clock = Instant::now();
    assert!(factors.factorise(&lower, &[]), "bodies under their supports are stable");
    clock.elapsed().as_secs_f64()
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|word| !word.starts_with('-')).collect();
    for (name, size, changes) in
        PROBLEMS.iter().filter(|problem| words.is_empty() || words.iter().any(|w| w == problem.0))
    {
        let (document, case) = changed(name, changes);
        let clock = Instant::now();
        let solved =
            solve::<3>(&document.folder, &case, 1, &mut |_| ControlFlow::Continue(())).expect("an equilibrium");
        let seconds = clock.elapsed().as_secs_f64();
        let equilibrium = &solved.equilibrium;
        let one = factorisation(equilibrium);
        let (outer, inner) = (equilibrium.iterations, equilibrium.contact_iterations);
        println!(
            "{name}, {size}: {} equations, {} kept, {outer} ({inner}) iterations, {} factorisations, {seconds:.1} s, {:.0} % in contact; \
             one factorisation {one:.2} s: {:.1} times",
            equilibrium.equation_count(),
            equilibrium.kept_count(),
            equilibrium.factorisations(),
            100.0 * equilibrium.contact_seconds / seconds,
            seconds / one
        );
        let figures = json!({
            "equations": equilibrium.equation_count(), "iterations": outer, "contact_iterations": inner,
            "factorisations": equilibrium.factorisations(), "seconds": seconds, "factorisation": one, "times": seconds / one,
        });
        keep("statics", [(format!("{name}, {size}"), figures)]);
    }
}
