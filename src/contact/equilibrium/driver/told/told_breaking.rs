//! What is told where cohesive interfaces break and a search does not end.

use crate::contact::cohesive::Breaking;
use crate::contact::equilibrium::driver::asking::trouble::Trouble;
use crate::contact::equilibrium::driver::progress::search::Search;

/// A trouble with the interfaces that were breaking: what each of them carries, and what helps.
pub(crate) fn with_what_breaks<const D: usize>(search: &Search<D>, trouble: Trouble) -> Trouble {
    let all: Vec<String> = search.broken.iter().map(|one| told(search, one)).collect();
    if all.is_empty() {
        return trouble;
    }
    let help = match search.may_go_on() {
        true => "take smaller load steps, or prescribe displacements instead of loads".to_owned(),
        false => format!(
            "prescribe displacements instead of loads, take smaller load steps, or allow more than {} linear solves (max_iterations; max_solves in C and Rust)",
            search.options.max_solves
        ),
    };
    let viscous = match search.broken.iter().all(|one| one.is_viscous) {
        true => "with a smaller time step, or a larger viscosity",
        false => "or give the interface a viscosity (with a time step)",
    };
    trouble.and(&format!("{}; {help}, {viscous}", all.join("; ")))
}

fn told<const D: usize>(search: &Search<D>, one: &Breaking) -> String {
    let [a, b] = one.bodies.map(|body| search.assembly.id(body));
    let [part, broken] = [one.damaged, one.broken].map(|part| 100.0 * part);
    let [normal, shear] = one.strengths;
    format!(
        "the cohesive interface of bodies {a} and {b} breaks: damage grows over {part:.1} % of its area, and {broken:.1} % is broken; when the step \
         began it could carry {normal:.4e} along its normal or {shear:.4e} across it, and no larger load"
    )
}
